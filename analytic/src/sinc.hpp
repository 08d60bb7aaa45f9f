// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace stickslip::analytic {

/// sin(y)/y.
[[nodiscard]] inline double sinc(double y) { return y == 0.0 ? 1.0 : std::sin(y) / y; }

}  // namespace stickslip::analytic
