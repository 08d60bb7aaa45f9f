// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "stickslip/certified/real.hpp"

namespace stickslip::certified {

// Automatic differentiation by dual numbers a + a' e with e² = 0. A function evaluated at x + e returns its
// value and its derivative. Duals of duals also return second derivatives.

template <class T>
struct Dual {
  T value;
  T slope;

  Dual(const T& value_in, const T& slope_in = T(0)) : value(value_in), slope(slope_in) {}
  Dual(int value_in) : value(value_in), slope(0) {}

  friend Dual operator-(const Dual& x) { return {-x.value, -x.slope}; }
  friend Dual operator+(const Dual& x, const Dual& y) { return {x.value + y.value, x.slope + y.slope}; }
  friend Dual operator-(const Dual& x, const Dual& y) { return {x.value - y.value, x.slope - y.slope}; }
  friend Dual operator*(const Dual& x, const Dual& y) {
    return {x.value * y.value, x.slope * y.value + x.value * y.slope};
  }
  friend Dual operator/(const Dual& x, const Dual& y) {
    const T quotient = x.value / y.value;
    return {quotient, (x.slope - quotient * y.slope) / y.value};
  }
  friend Dual sqrt(const Dual& x) {
    const T root = sqrt(x.value);
    return {root, x.slope / (2 * root)};
  }
  friend Dual sin(const Dual& x) { return {sin(x.value), x.slope * cos(x.value)}; }
  friend Dual cos(const Dual& x) { return {cos(x.value), -x.slope * sin(x.value)}; }
  friend Dual sinh(const Dual& x) { return {sinh(x.value), x.slope * cosh(x.value)}; }
  friend Dual cosh(const Dual& x) { return {cosh(x.value), x.slope * sinh(x.value)}; }
};

/// A function and its derivative over a ball. For all x in the ball of the argument, the value of the result
/// contains F(x), and its slope contains F'(x).
using DifferentiableFunction = std::function<Dual<Real>(const Real& x)>;

/// Encloses all roots of F in [lower, upper], in ascending order, each in a ball that contains no other root.
/// The result is proven: the interval is divided until on each part either F does not contain 0, or F' does
/// not contain 0 and the signs of F at the ends show whether there is one root or none. Interval Newton steps
/// then reduce the balls as far as the precision allows.
///
/// Throws std::invalid_argument if the ends are not exact (radius 0) and ascending. Throws
/// std::runtime_error, naming the interval, if F has no certain sign at an end, or if a part is undecided
/// after `depth` divisions, where `depth` is a quarter of the precision in bits; it then contains a multiple
/// root or two very close roots.
[[nodiscard]] std::vector<Real> isolate_roots(const DifferentiableFunction& function, const Real& lower,
                                              const Real& upper);

/// Encloses the only root in [lower, upper]. Throws what isolate_roots() throws, and std::runtime_error if
/// the number of roots is not one.
[[nodiscard]] Real isolate_root(const DifferentiableFunction& function, const Real& lower, const Real& upper);

}  // namespace stickslip::certified
