// SPDX-License-Identifier: MIT
#pragma once

/// A problem in other units, and problems of other beams that are the same in units of their own.

#include <cmath>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "support/random_beams.hpp"

namespace stickslip::testing {

/// Numbers per SI unit.
struct Units {
  double length{1.0}, mass{1.0}, time{1.0};

  [[nodiscard]] double velocity() const { return length / time; }
  [[nodiscard]] double force() const { return mass * length / (time * time); }
};

/// mm, t, s, N: usual with finite-element programs.
inline constexpr Units millimetre_tonne_second{1e3, 1e-3, 1.0};

/// Powers of two, so that every product and quotient scales exactly; for the mass of four, so that square
/// roots of masses and stiffnesses do too.
inline Units random_powers_of_two(RandomNumbers& numbers) {
  return {std::ldexp(1.0, numbers.whole(-20, 20)), std::ldexp(1.0, 2 * numbers.whole(-10, 10)),
          std::ldexp(1.0, numbers.whole(-20, 20))};
}

inline data::Beam in_units(const Units& units, const data::Beam& si) {
  const double area = units.length * units.length;
  return data::Beam({.length = si.length() * units.length,
                     .area = si.area() * area,
                     .second_moment_of_area = si.second_moment_of_area() * (area * area),
                     .density = si.density() * (units.mass / (area * units.length)),
                     .youngs_modulus = si.youngs_modulus() * (units.force() / area),
                     .axial_force = si.axial_force() * units.force()});
}

inline data::FrictionLaw in_units(const Units& units, const data::FrictionLaw& si) {
  data::FrictionCoefficients coefficients = si.coefficients();
  coefficients.decay /= units.velocity();
  coefficients.viscous /= units.velocity();
  return data::FrictionLaw(coefficients);
}

inline data::HarmonicExcitation in_units(const Units& units, const data::HarmonicExcitation& si) {
  return data::HarmonicExcitation(
      {.frequency_hz = si.frequency_hz() / units.time, .amplitude = si.amplitude() * units.length});
}

inline data::Damping in_units(const Units& units, const data::Damping& si) {
  return data::Damping({.kelvin_voigt = si.kelvin_voigt() * units.time, .ratio = si.ratio()});
}

inline data::NumericalSettings in_units(const Units& units, const data::NumericalSettings& si) {
  data::NumericalChoices choices = si.choices();
  choices.time_step *= units.time;
  choices.duration *= units.time;
  choices.velocity_threshold *= units.velocity();
  return data::NumericalSettings(choices);
}

inline StickSlipProblem in_units(const Units& units, const StickSlipProblem& si) {
  return {in_units(units, si.beam), in_units(units, si.friction), in_units(units, si.excitation),
          in_units(units, si.damping)};
}

/// Another beam with the same P L^2/EI, and the units in which everything else of both is the same: of length
/// L, of mass rho A L, of time L^2 sqrt(rho A/EI).
struct SimilarBeam {
  data::Beam beam;
  Units units;
};

/// Another material, section and length.
inline SimilarBeam random_similar_beam(RandomNumbers& numbers, const data::Beam& beam) {
  const data::Beam other = random_beam(numbers, no_force);
  const Units units{
      other.length() / beam.length(),
      other.density() * other.area() * other.length() / (beam.density() * beam.area() * beam.length()),
      frequency_unit(beam) / frequency_unit(other)};
  data::BeamProperties properties = other.properties();
  properties.axial_force = beam.axial_force() * units.force();
  return {data::Beam(properties), units};
}

/// The beam in mm, t, s, and one of another material, section and length.
inline std::vector<SimilarBeam> similar_beams(RandomNumbers& numbers, const data::Beam& beam) {
  return {{in_units(millimetre_tonne_second, beam), millimetre_tonne_second},
          random_similar_beam(numbers, beam)};
}

}  // namespace stickslip::testing
