// SPDX-License-Identifier: MIT
#include "studies/common/problem_parameter.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string>

#include "stickslip/data/case_file.hpp"

namespace stickslip::studies {

namespace {

/// What the parameters are fields of.
struct Properties {
  data::BeamProperties beam;
  data::HarmonicMotion motion;
  data::FrictionCoefficients friction;
  data::DampingProperties damping;
};

struct Field {
  std::string_view name;
  double& (*in)(Properties&);
};

// In the order of Parameter.
constexpr Field fields[] = {
    {"excitation.frequency_hz", [](Properties& of) -> double& { return of.motion.frequency_hz; }},
    {"excitation.amplitude", [](Properties& of) -> double& { return of.motion.amplitude; }},
    {"beam.length", [](Properties& of) -> double& { return of.beam.length; }},
    {"beam.axial_force", [](Properties& of) -> double& { return of.beam.axial_force; }},
    {"beam.youngs_modulus", [](Properties& of) -> double& { return of.beam.youngs_modulus; }},
    {"friction.static_coefficient", [](Properties& of) -> double& { return of.friction.static_coefficient; }},
    {"beam.axial_direction", [](Properties& of) -> double& { return of.beam.axial_direction; }},
    {"friction.kinetic_coefficient",
     [](Properties& of) -> double& { return of.friction.kinetic_coefficient; }},
    {"friction.decay", [](Properties& of) -> double& { return of.friction.decay; }},
    {"damping.ratio", [](Properties& of) -> double& { return of.damping.ratio; }},
    {"damping.kelvin_voigt", [](Properties& of) -> double& { return of.damping.kelvin_voigt; }}};

static_assert(std::size(fields) == static_cast<std::size_t>(Parameter::kelvin_voigt) + 1);

const Field& field(Parameter parameter) { return fields[static_cast<std::size_t>(parameter)]; }

}  // namespace

std::string_view field_of(Parameter parameter) { return field(parameter).name; }

double value_of(const data::Case& problem, Parameter parameter) {
  return data::numbers_of(problem).at(std::string(field_of(parameter)));
}

data::Case with_value(const data::Case& problem, Parameter parameter, double value) {
  Properties properties{
      .beam = problem.beam.properties(),
      .motion = {.frequency_hz = problem.excitation.frequency_hz(),
                 .amplitude = problem.excitation.amplitude()},
      .friction = problem.friction.coefficients(),
      .damping = {.kelvin_voigt = problem.damping.kelvin_voigt(), .ratio = problem.damping.ratio()}};
  if (parameter == Parameter::youngs_modulus)  // G is proportional to E
    properties.beam.shear_stiffness *= value / properties.beam.youngs_modulus;
  field(parameter).in(properties) = value;
  if (parameter == Parameter::static_coefficient)
    properties.friction.kinetic_coefficient =
        std::min(properties.friction.kinetic_coefficient, std::max(value, 0.0));
  data::Case changed = problem;
  changed.beam = data::Beam(properties.beam);
  changed.excitation = data::HarmonicExcitation(properties.motion);
  changed.friction = data::FrictionLaw(properties.friction);
  changed.damping = data::Damping(properties.damping);
  return changed;
}

double angular_frequency(const data::HarmonicExcitation& excitation) {
  return 2.0 * std::numbers::pi * excitation.frequency_hz();
}

double friction_limit(const data::FrictionLaw& friction, const data::Beam& beam) {
  return friction.static_coefficient() * beam.axial_force();
}

double friction_limit(const data::Case& problem) { return friction_limit(problem.friction, problem.beam); }

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
  throw data::FieldError("wall.speed", data::shortest_text(problem.wall.speed()), std::string(resting_wall));
}

void require_friction(const data::Case& problem) {
  if (problem.friction.static_coefficient() > 0.0) return;
  throw data::FieldError(field_of(Parameter::static_coefficient), "0",
                         "above 0: without friction nothing sticks");
}

}  // namespace stickslip::studies
