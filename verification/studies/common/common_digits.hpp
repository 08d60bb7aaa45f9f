// SPDX-License-Identifier: MIT
#pragma once

#include "stickslip/analytic/force_maximum.hpp"

namespace stickslip::studies {

/// The largest number of significant digits, from 15 down to 1, at which both bounds round to the same value;
/// 0 if they differ at one digit.
[[nodiscard]] int common_digits(const analytic::Bounds& range);

}  // namespace stickslip::studies
