// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "stickslip/solver/beam_element.hpp"

namespace stickslip::testing {

/// int_0^l v v^T dx of an element vector v(x/l) by Gauss's rule of four points, exact where v is of degree 3 at most.
template <class Integrand>
solver::ElementMatrix element_integral(double element_length, const Integrand& integrand) {
  const double a = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double b = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double wa = (18.0 + std::sqrt(30.0)) / 36.0, wb = (18.0 - std::sqrt(30.0)) / 36.0;
  solver::ElementMatrix sum = solver::ElementMatrix::Zero();
  for (const auto& [point, weight] :
       std::array<std::array<double, 2>, 4>{{{-b, wb}, {-a, wa}, {a, wa}, {b, wb}}}) {
    const solver::ElementVector value = integrand(0.5 * (1.0 + point));
    sum += 0.5 * element_length * weight * value * value.transpose();
  }
  return sum;
}

}  // namespace stickslip::testing
