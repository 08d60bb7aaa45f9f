// SPDX-License-Identifier: MIT
#pragma once

/// Random beams and excitations, in SI and in other units, for relations that must hold whatever the beam is. The same on every
/// machine up to the last digit of std::pow: numbers are made from the 64 random bits here, since the standard leaves open what
/// its distributions do with them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "support/beams.hpp"

namespace stickslip::testing {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// low <= x < high, from the 53 highest bits.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// The same in the logarithm; 0 < low.
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }
  /// One of low, low + 1, ... high.
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

/// sqrt(EI/(rho A))/L^2, rad/s: the unit of a beam's frequencies.
inline double frequency_unit(const data::Beam& beam) {
  return std::sqrt(rigidity(beam) / (beam.density() * beam.area())) / (beam.length() * beam.length());
}

/// P/P_cr from the strongest tension (negative) to the strongest compression.
struct ForceRange {
  double lowest{}, highest{};
};
inline constexpr ForceRange any_force{-3.0, 0.95};
inline constexpr ForceRange compression{0.05, 0.95};
inline constexpr ForceRange no_force{0.0, 0.0};

inline constexpr double buckling_factor = 20.190728556426629;  ///< P_cr L^2/EI, clamped-pinned

/// P_cr/(P_cr - P), what the nearness of buckling does to round-off; 1 in tension.
inline double nearness_of_buckling(const data::Beam& beam) {
  const double share =
      beam.axial_force() * beam.length() * beam.length() / (buckling_factor * rigidity(beam));
  return 1.0 / (1.0 - std::max(share, 0.0));
}

/// From rubber to steel, 5 cm to 5 m long, 10 to 300 times as long as thick, rectangular.
inline data::Beam random_beam(RandomNumbers& numbers, const ForceRange& force) {
  data::BeamProperties beam;
  beam.youngs_modulus = numbers.log_uniform(1e6, 210e9);
  beam.density = numbers.log_uniform(1100.0, 7850.0);
  beam.length = numbers.log_uniform(0.05, 5.0);
  const double thickness = beam.length / numbers.log_uniform(10.0, 300.0);
  const double width = thickness * numbers.log_uniform(0.5, 20.0);
  beam.area = width * thickness;
  beam.second_moment_of_area = beam.area * thickness * thickness / 12.0;
  beam.axial_force = numbers.uniform(force.lowest, force.highest) * buckling_factor * beam.youngs_modulus *
                     beam.second_moment_of_area / (beam.length * beam.length);
  return data::Beam(beam);
}

/// All of a beam, in digits that give it back.
inline std::string description(const data::Beam& beam) {
  std::ostringstream text;
  for (const auto& [name, value] : {std::pair{"length", beam.length()},
                                    {"area", beam.area()},
                                    {"second_moment_of_area", beam.second_moment_of_area()},
                                    {"density", beam.density()},
                                    {"youngs_modulus", beam.youngs_modulus()},
                                    {"axial_force", beam.axial_force()}})
    text << name << " = " << data::shortest_text(value) << ", ";
  text << "P L^2/EI = " << beam.axial_force() * beam.length() * beam.length() / rigidity(beam);
  return text.str();
}

/// Calls claim(beam, numbers) for `count` random beams, each with random numbers of its own.
template <typename Claim>
void on_random_beams(int count, const ForceRange& force, Claim&& claim) {
  for (int i = 0; i < count; ++i) {
    RandomNumbers numbers(2018 + static_cast<std::uint64_t>(i));
    const data::Beam beam = random_beam(numbers, force);
    SCOPED_TRACE("random beam " + std::to_string(i) + ": " + description(beam));
    claim(beam, numbers);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

/// A frequency between 0.05 and 5 times the first natural one, drawn anew until it differs from each given by
/// more than `distance` of it: the response is then amplified by less than 1/(2 distance).
inline double random_frequency_hz(RandomNumbers& numbers, const std::vector<double>& natural_rad_per_s,
                                  double distance) {
  for (;;) {
    const double omega = natural_rad_per_s.front() * numbers.log_uniform(0.05, 5.0);
    if (std::ranges::all_of(natural_rad_per_s,
                            [&](double natural) { return std::abs(omega / natural - 1.0) > distance; }))
      return omega / (2.0 * std::numbers::pi);
  }
}

inline double period(const data::HarmonicExcitation& excitation) { return 1.0 / excitation.frequency_hz(); }

/// A beam that slips, with all that its history depends on; the settings are of no meaning. mu_s in 0.1 ... 1, mu_m in 0.2 mu_s ... mu_s, a decay that matters at the speed of the base.
inline data::Case random_problem(RandomNumbers& numbers, const data::Beam& beam, double static_coefficient,
                                 const data::HarmonicMotion& motion, double kelvin_voigt) {
  const double speed = 2.0 * std::numbers::pi * motion.frequency_hz * motion.amplitude;
  return {.name = "random",
          .structure = beam,
          .motion = data::HarmonicExcitation(motion),
          .contact = {.friction = data::FrictionLaw(
                          {.static_coefficient = static_coefficient,
                           .kinetic_coefficient = static_coefficient * numbers.uniform(0.2, 1.0),
                           .decay = numbers.log_uniform(0.1, 3.0) / speed})},
          .numerics = data::NumericalSettings(paper_choices(1.0)),
          .damping = data::Damping({.kelvin_voigt = kelvin_voigt})};
}

/// The same problem at another amplitude.
inline data::Case with_amplitude(const data::Case& problem, double factor) {
  return with(problem,
              shaking(problem.excitation().frequency_hz(), factor * problem.excitation().amplitude()));
}

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

inline data::Case in_units(const Units& units, const data::Case& si) {
  return with(si, in_units(units, si.beam()), in_units(units, si.contact.friction),
              in_units(units, si.excitation()), in_units(units, si.damping));
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
