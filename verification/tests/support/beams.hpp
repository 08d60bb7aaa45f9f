// SPDX-License-Identifier: MIT
#pragma once

/// The beam of the paper and its relatives, as the tests need them.

#include <cmath>

#include "stickslip/data/problem.hpp"

namespace stickslip::testing {

/// The paper's beam (Sect. 3, I corrected to (1/12)e-4 m^4). The numbers are repeated on purpose: a test must not take
/// its expectation from the file it checks.
inline data::BeamProperties paper_beam_properties() {
  return {.length = 2.0,
          .area = 0.01,
          .second_moment_of_area = 1e-4 / 12.0,
          .density = 1000.0,
          .youngs_modulus = 2e9,
          .axial_force = 500.0};
}

inline data::Beam paper_beam() { return data::Beam(paper_beam_properties()); }

inline data::Beam paper_beam_with_axial_force(double axial_force) {
  auto properties = paper_beam_properties();
  properties.axial_force = axial_force;
  return data::Beam(properties);
}

/// P = factor * EI/L^2.
inline data::Beam paper_beam_with_load_factor(double factor) {
  const data::BeamProperties beam = paper_beam_properties();
  return paper_beam_with_axial_force(factor * beam.youngs_modulus * beam.second_moment_of_area /
                                     (beam.length * beam.length));
}

/// EI, N m^2.
inline double rigidity(const data::Beam& beam) {
  return beam.youngs_modulus() * beam.second_moment_of_area();
}

/// A base that moves with 0.5 mm, as in most figures of the paper, or another amplitude, m.
inline data::HarmonicExcitation shaking(double frequency_hz, double amplitude = 0.5e-3) {
  return data::HarmonicExcitation({.frequency_hz = frequency_hz, .amplitude = amplitude});
}

inline data::Damping kelvin_voigt(double eta) { return data::Damping({.kelvin_voigt = eta}); }

inline data::FrictionLaw paper_friction() {
  return data::FrictionLaw({.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.0});
}

/// The next term of an error of second order in the step, relative to the leading one, in the damped stick-slip
/// vibration of the paper's beam (25 Hz, 1 mm, 0.5 % of critical in mode 1): omega h of mode 2, which sets the times of
/// the changes, each of which splits a step, and (omega h)^2 of mode 5, the highest that matters.
inline double next_term_of_the_damped_beam(double time_step) {
  return 509.0 * time_step + std::pow(2780.0 * time_step, 2);
}

/// The settings of data/cases/paper.toml for another duration, to be varied.
inline data::NumericalChoices paper_choices(double duration) {
  return {.elements = 20,
          .time_step = 1e-4,
          .spectral_radius = 0.9,
          .velocity_threshold = 1e-4,
          .modes = 10,
          .duration = duration};
}

/// The paper's problem at another excitation (Hz, m), for another duration (s).
inline data::Case paper_problem(double frequency_hz, double amplitude, double duration = 1.0) {
  return {.name = "paper",
          .structure = paper_beam(),
          .motion = shaking(frequency_hz, amplitude),
          .contact = {.friction = paper_friction()},
          .numerics = data::NumericalSettings(paper_choices(duration))};
}

/// Kelvin-Voigt damping of 0.5 % of critical in mode 1 of the paper's beam. With it the changes of contact
/// converge on the mesh; undamped, only the motion has a limit.
inline data::Damping light_damping() { return kelvin_voigt(6.4e-5); }

/// The paper's problem with light damping, at 1 mm, for 0.5 s.
inline data::Case damped_problem(double frequency_hz) {
  data::Case problem = paper_problem(frequency_hz, 1e-3, 0.5);
  problem.damping = light_damping();
  return problem;
}

inline data::BeamProperties flat_properties(double length, double axial_force) {
  return {.length = length,
          .area = 0.2 * 0.02,
          .second_moment_of_area = 0.2 * 0.02 * 0.02 * 0.02 / 12.0,
          .density = 1000.0,
          .youngs_modulus = 2e9,
          .axial_force = axial_force};
}

inline data::Beam flat_beam(double length, double axial_force) {
  return data::Beam(flat_properties(length, axial_force));
}

inline data::Case flat_case() {
  return {.name = "flat",
          .structure = flat_beam(2.0, 500.0),
          .motion = data::HarmonicExcitation({.frequency_hz = 25.0, .amplitude = 1e-3}),
          .contact = {.friction = paper_friction()},
          .numerics = data::NumericalSettings(paper_choices(10.0))};
}

}  // namespace stickslip::testing
