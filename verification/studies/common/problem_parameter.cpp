// SPDX-License-Identifier: MIT
#include "studies/common/problem_parameter.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "stickslip/data/case_file.hpp"

namespace stickslip::studies {

std::string_view field_of(Parameter parameter) {
  switch (parameter) {
    case Parameter::frequency:
      return "excitation.frequency_hz";
    case Parameter::amplitude:
      return "excitation.amplitude";
    case Parameter::length:
      return "beam.length";
    case Parameter::axial_force:
      return "beam.axial_force";
    case Parameter::youngs_modulus:
      return "beam.youngs_modulus";
    case Parameter::static_coefficient:
      return "friction.static_coefficient";
    case Parameter::axial_direction:
      return "beam.axial_direction";
    case Parameter::kinetic_coefficient:
      return "friction.kinetic_coefficient";
    case Parameter::decay:
      return "friction.decay";
    case Parameter::damping_ratio:
      return "damping.ratio";
    case Parameter::kelvin_voigt:
      return "damping.kelvin_voigt";
  }
  return {};
}

double value_of(const data::Case& problem, Parameter parameter) {
  return data::numbers_of(problem).at(std::string(field_of(parameter)));
}

data::Case with_value(const data::Case& problem, Parameter parameter, double value) {
  data::BeamProperties beam = problem.beam.properties();
  data::HarmonicMotion motion{.frequency_hz = problem.excitation.frequency_hz(),
                              .amplitude = problem.excitation.amplitude()};
  data::FrictionCoefficients friction = problem.friction.coefficients();
  data::DampingProperties damping{.kelvin_voigt = problem.damping.kelvin_voigt(),
                                  .ratio = problem.damping.ratio()};
  switch (parameter) {
    case Parameter::frequency:
      motion.frequency_hz = value;
      break;
    case Parameter::amplitude:
      motion.amplitude = value;
      break;
    case Parameter::length:
      beam.length = value;
      break;
    case Parameter::axial_force:
      beam.axial_force = value;
      break;
    case Parameter::youngs_modulus:
      beam.shear_stiffness *= value / beam.youngs_modulus;  // G is proportional to E
      beam.youngs_modulus = value;
      break;
    case Parameter::static_coefficient:
      friction.static_coefficient = value;
      friction.kinetic_coefficient = std::min(friction.kinetic_coefficient, std::max(value, 0.0));
      break;
    case Parameter::axial_direction:
      beam.axial_direction = value;
      break;
    case Parameter::kinetic_coefficient:
      friction.kinetic_coefficient = value;
      break;
    case Parameter::decay:
      friction.decay = value;
      break;
    case Parameter::damping_ratio:
      damping.ratio = value;
      break;
    case Parameter::kelvin_voigt:
      damping.kelvin_voigt = value;
      break;
  }
  data::Case changed = problem;
  changed.beam = data::Beam(beam);
  changed.excitation = data::HarmonicExcitation(motion);
  changed.friction = data::FrictionLaw(friction);
  changed.damping = data::Damping(damping);
  return changed;
}

double angular_frequency(const data::HarmonicExcitation& excitation) {
  return 2.0 * std::numbers::pi * excitation.frequency_hz();
}

bool is_damped(const data::Case& problem) {
  return problem.damping.kelvin_voigt() > 0.0 || problem.damping.ratio() > 0.0;
}

data::Beam with_shear(const data::Beam& beam) {
  data::BeamProperties properties = beam.properties();
  if (properties.shear_stiffness == 0.0)
    properties.shear_stiffness = beam.youngs_modulus() * beam.area() / shear_flexibility;
  return data::Beam(properties);
}

data::Beam without_shear(const data::Beam& beam) {
  data::BeamProperties properties = beam.properties();
  properties.shear_stiffness = 0.0;
  return data::Beam(properties);
}

void require_resting_wall(const data::Case& problem) {
  if (problem.wall.speed() == 0.0) return;
  throw data::FieldError(
      "wall.speed", data::shortest_text(problem.wall.speed()),
      "0 here: a wall that moves bends the beam until it slips; respond (by finite elements or "
      "event-driven), animate, squeal and periodic follow it");
}

void require_friction(const data::Case& problem) {
  if (problem.friction.static_coefficient() > 0.0) return;
  throw data::FieldError(field_of(Parameter::static_coefficient), "0",
                         "above 0: without friction nothing sticks");
}

}  // namespace stickslip::studies
