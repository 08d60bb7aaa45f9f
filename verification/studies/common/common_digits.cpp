// SPDX-License-Identifier: MIT
#include "studies/common/common_digits.hpp"

#include <fmt/format.h>

namespace stickslip::studies {

int common_digits(const analytic::Bounds& range) {
  for (int digits = 15; digits > 0; --digits)
    if (fmt::format("{:.{}e}", range.lower, digits - 1) == fmt::format("{:.{}e}", range.upper, digits - 1))
      return digits;
  return 0;
}

}  // namespace stickslip::studies
