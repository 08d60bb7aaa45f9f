#pragma once

#include <limits>
#include <sstream>
#include <string>
#include <string_view>

namespace stickslip::analytic {

/// A number with all digits that hold.
[[nodiscard]] inline std::string digits(double value) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

/// "<field> is <value>; it must be <allowed>."
[[nodiscard]] inline std::string refusal(std::string_view field, double value, std::string_view allowed) {
  return std::string(field) + " is " + digits(value) + "; it must be " + std::string(allowed) + ".";
}

}  // namespace stickslip::analytic
