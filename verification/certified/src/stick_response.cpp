// SPDX-License-Identifier: MIT
#include "stickslip/certified/stick_response.hpp"

#include <stdexcept>

#include "stickslip/certified/complex.hpp"

namespace stickslip::certified {

StickResponse::StickResponse(const Beam& beam, const Excitation& excitation, int modes)
    : quasi_static_(beam),
      frequency_hz_(excitation.frequency_hz),
      amplitude_(excitation.amplitude),
      omega_(2 * pi() * Real(excitation.frequency_hz)),
      modes_(stick_modes(beam, modes)) {
  if (excitation.frequency_hz.sign() <= 0)
    throw std::invalid_argument(
        error_message("excitation.frequency_hz", excitation.frequency_hz, "positive"));
  if (excitation.amplitude.sign() < 0)
    throw std::invalid_argument(error_message("excitation.amplitude", excitation.amplitude, "0 or more"));
  force_ = history(beam.length(), 3);
  force_.base *= beam.bending_stiffness();
  for (Real& weight : force_.weights) weight *= beam.bending_stiffness();
}

StickResponse::History StickResponse::history(const Real& x, std::size_t derivative) const {
  History result{quasi_static_.at(x)[derivative], {}};
  for (const StickMode& mode : modes_)
    result.weights.push_back(mode.shape(x)[derivative] * pow(omega_, 2) * mode.participation);
  return result;
}

/// g_n(t). If the balls of the two frequencies overlap, the difference of the sines is divided by Omega -
/// omega in the form
///
///     sin(Omega t) - sin(omega t) = 2 cos((Omega + omega) t/2) sin((Omega - omega) t/2).
Real StickResponse::modal_coordinate(const StickMode& mode, const Real& t) const {
  const Real& natural = mode.angular_frequency;
  const Real sum = omega_ + natural, difference = omega_ - natural;
  if (difference.contains_zero())
    return (natural * t * cos(sum * t / 2) * sinc(difference * t / 2) - sin(natural * t)) / (sum * natural);
  return (natural * sin(omega_ * t) - omega_ * sin(natural * t)) / (sum * difference * natural);
}

Real StickResponse::evaluate(const History& history, const Real& t) const {
  Real sum = history.base * sin(omega_ * t);
  for (std::size_t n = 0; n < modes_.size(); ++n) sum += history.weights[n] * modal_coordinate(modes_[n], t);
  return amplitude_ * sum;
}

Real StickResponse::relative_displacement(const Real& x, const Real& t) const {
  return evaluate(history(x, 0), t);
}

Real StickResponse::absolute_displacement(const Real& x, const Real& t) const {
  return amplitude_ * sin(omega_ * t) + relative_displacement(x, t);
}

Real StickResponse::friction_force(const Real& t) const { return evaluate(force_, t); }

std::vector<Sinusoid> StickResponse::force_sinusoids() const {
  std::vector<Sinusoid> sinusoids{{force_.base, omega_}};
  for (std::size_t n = 0; n < modes_.size(); ++n) {
    const Real& natural = modes_[n].angular_frequency;
    const Real difference = pow(omega_, 2) - pow(natural, 2);
    if (difference.contains_zero())
      throw std::domain_error(error_message(
          "excitation.frequency_hz", frequency_hz_,
          "so far from natural frequency " + std::to_string(modes_[n].number) + ", " +
              enclosure(modes_[n].frequency_hz, 17).value + " Hz, that the precision can tell them apart"));
    sinusoids.front().amplitude += force_.weights[n] / difference;
    sinusoids.push_back({-force_.weights[n] * omega_ / (difference * natural), natural});
  }
  for (Sinusoid& sinusoid : sinusoids) sinusoid.amplitude *= amplitude_;
  return sinusoids;
}

Complex tip_mobility(const Beam& beam, const Real& sigma, const Real& omega, const Rational& kelvin_voigt) {
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
  return numerator / (rigidity * denominator);
}

}  // namespace stickslip::certified
