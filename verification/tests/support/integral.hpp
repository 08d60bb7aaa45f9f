// SPDX-License-Identifier: MIT
#pragma once

/// Integrals of functions of x, of numbers or of matrices.

#include <cmath>

namespace stickslip::testing {

/// int_lower^upper f dx by Gauss's rule of four points on each of `pieces` equal parts: exact for polynomials of degree 7 or less,
/// else off by (upper - lower) h^8 max|f^(8)|/1.8e9 at most, h the length of a part.
template <class Function>
auto integral(const Function& function, double lower, double upper, int pieces) {
  const double inner = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(6.0 / 5.0)),
               outer = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double inner_weight = (18.0 + std::sqrt(30.0)) / 36.0, half = 0.5 * (upper - lower) / pieces;
  decltype(function(lower)) sum = 0.0 * function(lower);
  for (int i = 0; i < pieces; ++i) {
    const double middle = lower + (2 * i + 1) * half;
    sum += half * inner_weight * (function(middle - half * inner) + function(middle + half * inner));
    sum += half * (1.0 - inner_weight) * (function(middle - half * outer) + function(middle + half * outer));
  }
  return sum;
}

}  // namespace stickslip::testing
