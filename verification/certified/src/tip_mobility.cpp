// SPDX-License-Identifier: MIT
#include "stickslip/certified/tip_mobility.hpp"

#include <acb.h>

#include <stdexcept>

namespace stickslip::certified {
namespace {

/// A rectangle in the complex plane, with the operations that the formula needs.
class Complex {
 public:
  Complex(const Real& real, const Real& imaginary = 0) : Complex() {
    acb_set_arb_arb(value_, real.data(), imaginary.data());
  }
  Complex(int real) : Complex(Real(real)) {}
  Complex(const Complex& other) : Complex() { acb_set(value_, other.value_); }
  Complex& operator=(const Complex&) = delete;
  ~Complex() { acb_clear(value_); }

  [[nodiscard]] Mobility parts() const {
    Mobility result;
    acb_get_real(result.real.data(), value_);
    acb_get_imag(result.imaginary.data(), value_);
    return result;
  }

  friend Complex operator+(const Complex& x, const Complex& y) { return combined(acb_add, x, y); }
  friend Complex operator-(const Complex& x, const Complex& y) { return combined(acb_sub, x, y); }
  friend Complex operator*(const Complex& x, const Complex& y) { return combined(acb_mul, x, y); }
  friend Complex operator/(const Complex& x, const Complex& y) { return combined(acb_div, x, y); }
  friend Complex sqrt(const Complex& x) { return applied(acb_sqrt, x); }
  friend Complex sinh(const Complex& x) { return applied(acb_sinh, x); }
  friend Complex cosh(const Complex& x) { return applied(acb_cosh, x); }

 private:
  Complex() { acb_init(value_); }
  template <class Function>
  static Complex applied(Function function, const Complex& x) {
    Complex result;
    function(result.value_, x.value_, precision());
    return result;
  }
  template <class Function>
  static Complex combined(Function function, const Complex& x, const Complex& y) {
    Complex result;
    function(result.value_, x.value_, y.value_, precision());
    return result;
  }

  acb_t value_;
};

}  // namespace

Mobility tip_mobility(const Beam& beam, const Real& sigma, const Real& omega, const Rational& kelvin_voigt) {
  if (kelvin_voigt.sign() < 0)
    throw std::invalid_argument(error_message("damping.kelvin_voigt", kelvin_voigt, "0 or more"));
  const Complex s(sigma, omega), length = beam.length(), force = beam.axial_force();
  const Complex rigidity = beam.bending_stiffness() * (1 + Complex(kelvin_voigt) * s);
  const Complex root = sqrt(force * force - 4 * rigidity * beam.mass_per_length() * s * s);
  const Complex l1_squared = (root - force) / (2 * rigidity);
  const Complex l2_squared = (0 - root - force) / (2 * rigidity);
  // The result is an even function of l_1 and of l_2.
  const Complex l1 = sqrt(l1_squared), l2 = sqrt(l2_squared);
  const Complex c1 = cosh(l1 * length), c2 = cosh(l2 * length);
  const Complex s1 = sinh(l1 * length), s2 = sinh(l2 * length);
  const Complex numerator = s * (l1_squared - l2_squared) * (c1 * s2 / l2 - c2 * s1 / l1);
  const Complex denominator = l1_squared * l1_squared + l2_squared * l2_squared -
                              2 * l1_squared * l2_squared * c1 * c2 +
                              l1 * l2 * (l1_squared + l2_squared) * s1 * s2;
  return (numerator / (rigidity * denominator)).parts();
}

}  // namespace stickslip::certified
