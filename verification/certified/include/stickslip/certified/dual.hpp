// SPDX-License-Identifier: MIT
#pragma once

/// Automatic differentiation by dual numbers a + a' e with e² = 0. A function evaluated at x + e returns its
/// value and its derivative. Duals of duals also return second derivatives.

namespace stickslip::certified {

/// A dual number: a value and its derivative.
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

}  // namespace stickslip::certified
