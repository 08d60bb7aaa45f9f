// SPDX-License-Identifier: MIT
#pragma once

namespace stickslip::analytic {

/// An interval that is known to hold the true value: lower ≤ value ≤ upper.
struct Bounds {
  double lower{};
  double upper{};

  [[nodiscard]] constexpr double midpoint() const noexcept { return lower + 0.5 * (upper - lower); }
};

}  // namespace stickslip::analytic
