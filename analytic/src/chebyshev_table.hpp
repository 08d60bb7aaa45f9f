// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "stickslip/analytic/force_maximum.hpp"

namespace stickslip::analytic {

/// Smooth functions of x and y, interpolated in Chebyshev points of the first kind on a rectangle. A side of no width has one point.
class ChebyshevTable {
 public:
  using Values = std::vector<double>;  // by function

  /// From the values at 8 points along each side, or 16, 32 ... 128, until along both the last two coefficients of each function are at
  /// most `allowed`, of the largest magnitude of each function. Nothing if that takes more than `most_points`, or if `values` has
  /// nothing at one of them, or another number of functions.
  [[nodiscard]] static std::optional<ChebyshevTable> of(
      const std::function<std::optional<Values>(double x, double y)>& values, const Bounds& x,
      const Bounds& y, const std::function<Values(const Values& largest)>& allowed, std::size_t most_points);

  /// Inside the rectangle.
  [[nodiscard]] Values at(double x, double y) const;
  [[nodiscard]] bool holds(double x, double y) const {
    return sides_[0].lower <= x && x <= sides_[0].upper && sides_[1].lower <= y && y <= sides_[1].upper;
  }

 private:
  ChebyshevTable(const Bounds& x, const Bounds& y, std::array<std::size_t, 2> counts)
      : sides_{x, y}, counts_(counts) {}

  [[nodiscard]] bool fill(const std::function<std::optional<Values>(double x, double y)>& values);
  [[nodiscard]] std::array<bool, 2> has_converged(const Values& allowed) const;

  std::array<Bounds, 2> sides_;
  std::array<std::size_t, 2> counts_;  // degrees along x and y
  std::vector<Values> coefficients_;   // [degree in x, degree in y][function], the latter first
  Values largest_;                     // magnitude at the points, by function
};

}  // namespace stickslip::analytic
