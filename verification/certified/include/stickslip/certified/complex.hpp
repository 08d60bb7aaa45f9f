// SPDX-License-Identifier: MIT
#pragma once

#include <acb.h>

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

}  // namespace stickslip::certified
