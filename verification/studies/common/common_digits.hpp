#pragma once

#include "stickslip/analytic/bounds.hpp"

namespace stickslip::studies {

/// The largest number of significant digits, up to 15, to which both ends round alike; 0 if to none.
[[nodiscard]] int common_digits(const analytic::Bounds& range);

}  // namespace stickslip::studies
