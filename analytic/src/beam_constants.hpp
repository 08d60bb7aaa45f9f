// SPDX-License-Identifier: MIT
#pragma once

/// What the closed forms need of a beam, derived here and nowhere else on this side.

#include <algorithm>
#include <cmath>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// EI, N m².
[[nodiscard]] inline double bending_stiffness(const data::Beam& beam) {
  return beam.youngs_modulus() * beam.second_moment_of_area();
}

/// ρ A, kg/m.
[[nodiscard]] inline double mass_per_length(const data::Beam& beam) { return beam.density() * beam.area(); }

/// z = P L²/EI, dimensionless, positive in compression.
[[nodiscard]] inline double axial_load_factor(const data::Beam& beam) {
  return beam.axial_force() * beam.length() * beam.length() / bending_stiffness(beam);
}

/// √(EI/(ρ A L⁴)), 1/s: the unit of frequencies of a beam made dimensionless with L, EI and ρA.
[[nodiscard]] inline double frequency_unit(const data::Beam& beam) {
  return std::sqrt(bending_stiffness(beam) / mass_per_length(beam)) / (beam.length() * beam.length());
}

/// The beam with L = EI = ρA = 1 and this z and χ.
[[nodiscard]] inline data::Beam dimensionless_beam(double load_factor, double axial_direction) {
  return data::Beam({.length = 1.0,
                     .area = 1.0,
                     .second_moment_of_area = 1.0,
                     .density = 1.0,
                     .youngs_modulus = 1.0,
                     .axial_force = load_factor,
                     .axial_direction = axial_direction});
}

/// s² = EI/(k G A L²), dimensionless; 0 if the beam is rigid in shear.
[[nodiscard]] inline double shear_flexibility(const data::Beam& beam) {
  if (beam.shear_stiffness() == 0.0) return 0.0;
  return bending_stiffness(beam) / (beam.shear_stiffness() * beam.length() * beam.length());
}

/// Throws data::FieldError, naming beam.shear_stiffness, unless the beam is rigid in shear.
inline void require_rigid_in_shear(const data::Beam& beam) {
  if (beam.shear_stiffness() == 0.0) return;
  throw data::FieldError(
      "beam.shear_stiffness", beam.shear_stiffness(),
      "0 for this closed form; finite elements (--method fe) and the criterion without damping "
      "have shear");
}

/// Throws data::FieldError, naming beam.axial_force, unless P > 0.
inline void require_compression(const data::Beam& beam) {
  if (beam.axial_force() > 0.0) return;
  throw data::FieldError("beam.axial_force", beam.axial_force(),
                         "positive (compression), or there is no contact");
}

/// Throws data::FieldError, naming the key, for damping other than Kelvin-Voigt's.
inline void require_kelvin_voigt(const data::Damping& damping) {
  data::require_kelvin_voigt(damping, "0: the closed form knows Kelvin-Voigt damping alone");
}

/// (1 - χ) P, N: the part of the axial force that follows the tip.
[[nodiscard]] inline double follower_force(const data::Beam& beam) {
  return (1.0 - beam.axial_direction()) * beam.axial_force();
}

/// f = D u'''(L) + χ P u'(L), N, of D u'''(L) and u'(L), double or complex; D = EI if there is no damping.
template <class Number>
[[nodiscard]] Number tip_reaction(const data::Beam& beam, Number shear, Number slope) {
  return shear + beam.axial_direction() * beam.axial_force() * slope;
}

/// The same of a shape without damping, a StickMode for one.
template <class Shape>
[[nodiscard]] double tip_reaction(const data::Beam& beam, const Shape& shape) {
  return tip_reaction(beam, bending_stiffness(beam) * shape.third_derivative(beam.length()),
                      shape.slope(beam.length()));
}

/// The wave numbers of U'''' + (P/EI) U'' = k U, made dimensionless with the length: b = β L and
/// bb = β̄ L, the arguments of the hyperbolic and the trigonometric functions, with
///
///     bb² - b² = z = P L²/EI,          b² bb² = k L⁴ = (ρ A ω²/EI) L⁴.
///
/// The smaller of the two is the unknown of a characteristic equation, the larger follows from it by a sum of
/// positive terms, so that neither loses digits, not even where b tends to 0 at a buckling load.
struct WaveNumbers {
  double hyperbolic{};     ///< b
  double trigonometric{};  ///< bb
};

/// Both from the smaller one, which is b in compression (z > 0) and bb otherwise.
[[nodiscard]] inline WaveNumbers wave_numbers_from_smaller(double smaller, double z) {
  const double larger = std::sqrt(smaller * smaller + std::abs(z));
  return z > 0.0 ? WaveNumbers{smaller, larger} : WaveNumbers{larger, smaller};
}

/// The smaller one at a given bb; 0 in compression where bb² < z, which no frequency reaches.
[[nodiscard]] inline double smaller_wave_number(double bb, double z) {
  return z > 0.0 ? std::sqrt(std::max(0.0, bb * bb - z)) : bb;
}

/// Both at b bb = scaled_frequency = ω L² √(ρ A/EI) > 0.
[[nodiscard]] inline WaveNumbers wave_numbers_at(double scaled_frequency, double z) {
  const double larger = std::sqrt(0.5 * std::abs(z) + std::hypot(0.5 * z, scaled_frequency));
  const double smaller = scaled_frequency / larger;
  return z > 0.0 ? WaveNumbers{smaller, larger} : WaveNumbers{larger, smaller};
}

}  // namespace stickslip::analytic
