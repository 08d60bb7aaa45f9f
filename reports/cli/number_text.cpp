// SPDX-License-Identifier: MIT
#include "number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stickslip/data/problem.hpp"
#include "studies/common/common_digits.hpp"

namespace stickslip::cli {

int digits_that_hold(double relative_error) {
  const double resolved = std::max(relative_error, std::numeric_limits<double>::epsilon());
  return std::max(1, static_cast<int>(std::floor(-std::log10(resolved))));
}

std::string significant(double value, int digits) {
  std::string text = fmt::format("{:#.{}g}", value, digits);
  if (const auto bare = text.find(".e"); bare != std::string::npos)
    text.erase(bare, 1);  // 3.e+01 becomes 3e+01
  // fmt ends 25 to two digits with ".0", which would be a third one.
  const auto shown = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
  if (text.ends_with(".0") && shown > digits) text.erase(text.size() - 2);
  return text;
}

std::string common_digits(const analytic::Bounds& bounds) {
  if (bounds.lower == bounds.upper) return data::shortest_text(bounds.lower);
  if (const int digits = studies::common_digits(bounds); digits > 0) return significant(bounds.lower, digits);
  return fmt::format("{} ... {}", significant(bounds.lower, 2), significant(bounds.upper, 2));
}

}  // namespace stickslip::cli
