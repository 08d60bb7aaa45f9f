// SPDX-License-Identifier: MIT
#include "stickslip/certified/complex.hpp"

#include <stdexcept>

namespace stickslip::certified {
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
  const Complex mobility = numerator / (rigidity * denominator);
  return {mobility.real(), mobility.imaginary()};
}

}  // namespace stickslip::certified
