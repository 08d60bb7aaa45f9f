// SPDX-License-Identifier: MIT
#pragma once

#include <acb.h>

#include "stickslip/certified/beam.hpp"
#include "stickslip/certified/real.hpp"

namespace stickslip::certified {

/// A rectangle in the complex plane, with a ball for each part.
class Complex {
 public:
  Complex(const Real& real, const Real& imaginary = 0) : Complex() {
    acb_set_arb_arb(value_, real.data(), imaginary.data());
  }
  Complex(int real) : Complex(Real(real)) {}
  explicit Complex(acb_srcptr value) : Complex() { acb_set(value_, value); }
  Complex(const Complex& other) : Complex(other.value_) {}
  Complex& operator=(const Complex&) = delete;
  ~Complex() { acb_clear(value_); }

  [[nodiscard]] Real real() const {
    Real result;
    acb_get_real(result.data(), value_);
    return result;
  }
  [[nodiscard]] Real imaginary() const {
    Real result;
    acb_get_imag(result.data(), value_);
    return result;
  }
  [[nodiscard]] acb_srcptr data() const noexcept { return value_; }
  [[nodiscard]] acb_ptr data() noexcept { return value_; }

  friend Complex operator+(const Complex& x, const Complex& y) { return rounded(acb_add, x, y); }
  friend Complex operator-(const Complex& x, const Complex& y) { return rounded(acb_sub, x, y); }
  friend Complex operator*(const Complex& x, const Complex& y) { return rounded(acb_mul, x, y); }
  friend Complex operator/(const Complex& x, const Complex& y) { return rounded(acb_div, x, y); }
  friend Complex sqrt(const Complex& x) { return rounded(acb_sqrt, x); }
  friend Complex sin(const Complex& x) { return rounded(acb_sin, x); }
  friend Complex cos(const Complex& x) { return rounded(acb_cos, x); }
  friend Complex sinh(const Complex& x) { return rounded(acb_sinh, x); }
  friend Complex cosh(const Complex& x) { return rounded(acb_cosh, x); }

 private:
  Complex() { acb_init(value_); }
  /// Applies a function of Arb with rounding to the current precision.
  template <class Function, class... Arguments>
  static Complex rounded(Function function, const Arguments&... arguments) {
    Complex result;
    function(result.value_, arguments.value_..., precision());
    return result;
  }

  acb_t value_;
};

// The mobility of the tip in the usual formula: the velocity of the sliding tip per unit force on it. With D
// = EI (1 + η s), the roots ±l_1 and ±l_2 of D l⁴ + P l² + ρ A s² = 0, C_i = cosh(l_i L) and S_i =
// sinh(l_i L), the solution of D u'''' + P u'' + ρ A s² u = 0 with u(0) = u'(0) = u''(L) = 0 and D
// u'''(L) = -F gives
//
//     Y(s) = s u(L)/F = s (l_1² - l_2²) (C_1 S_2/l_2 - C_2 S_1/l_1)
//                       /{D [l_1⁴ + l_2⁴ - 2 l_1² l_2² C_1 C_2 + l_1 l_2 (l_1² + l_2²) S_1 S_2]}.

/// Y(σ + i ω), m/(N s), with σ and ω in 1/s, η in s, and P of either sign. The radius increases
/// where the terms cancel: near s = 0, near l_1 = l_2 (4 D ρ A s² = P²), and near the poles. It is
/// infinite if the ball contains such a point. Throws std::invalid_argument, naming damping.kelvin_voigt, if
/// that is negative.
[[nodiscard]] Complex tip_mobility(const Beam& beam, const Real& sigma, const Real& omega,
                                   const Rational& kelvin_voigt = "0");

}  // namespace stickslip::certified
