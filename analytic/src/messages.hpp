#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
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

/// Throws std::invalid_argument, naming the field, unless the value is positive and finite.
inline void require_positive(std::string_view field, double value) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw std::invalid_argument(refusal(field, value, "positive and finite"));
}

}  // namespace stickslip::analytic
