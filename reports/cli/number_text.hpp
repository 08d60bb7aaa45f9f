// SPDX-License-Identifier: MIT
#pragma once

/// Numbers with the digits that hold, and no others.

#include <string>

#include "stickslip/analytic/bounds.hpp"

namespace stickslip::cli {

/// The number of significant digits that a relative error leaves, 1 ... 15.
[[nodiscard]] int digits_that_hold(double relative_error);

/// The value with that many significant digits, trailing zeros included: (25, 4) is "25.00".
[[nodiscard]] std::string significant(double value, int digits);

/// The largest number of significant digits on which both bounds agree once rounded; "lower ... upper" if
/// they share none.
[[nodiscard]] std::string common_digits(const analytic::Bounds& bounds);

}  // namespace stickslip::cli
