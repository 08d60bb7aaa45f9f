// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace stickslip::analytic {

/// The largest |a + b s + c s^2/2| over |s| <= r.
inline double largest_parabola(double a, double b, double c, double r) {
  const double at_ends = std::abs(a + 0.5 * c * r * r) + std::abs(b) * r;
  if (std::abs(b) >= std::abs(c) * r) return at_ends;
  return std::max(at_ends, std::abs(a - 0.5 * b * b / c));
}

}  // namespace stickslip::analytic
