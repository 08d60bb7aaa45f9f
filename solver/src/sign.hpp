// SPDX-License-Identifier: MIT
#pragma once

namespace stickslip::solver {

/// -1 or +1, the latter at zero.
[[nodiscard]] inline double sign(double value) noexcept { return value < 0.0 ? -1.0 : 1.0; }

}  // namespace stickslip::solver
