// SPDX-License-Identifier: MIT
#include "studies/common/problem_parameter.hpp"

#include <cmath>

#include "stickslip/analytic/stick_reaction.hpp"

namespace stickslip::studies {

double angular_frequency(const data::HarmonicExcitation& excitation) {
  return 2.0 * std::numbers::pi * excitation.frequency_hz();
}

double friction_limit(const data::Case& problem) {
  return problem.contact.friction.static_coefficient() * problem.normal_force();
}

bool is_a_factor(const data::Case& problem, std::string_view key) {
  return data::key_named(key).effects.is_a_factor ||
         (key == "excitation.scale" && analytic::is_proportional_to_scale(problem));
}

double tip_stiffness(const data::Beam& beam) {
  return 3.0 * beam.youngs_modulus() * beam.second_moment_of_area() / std::pow(beam.length(), 3);
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
  if (problem.contact.wall.speed() == 0.0) return;
  throw data::FieldError("wall.speed", data::shortest_text(problem.contact.wall.speed()),
                         std::string(resting_wall));
}

void require_start_at_rest(const data::Case& problem) {
  for (const data::FeatureKey& key : data::feature_keys())
    if (const double value = key.value(problem);
        (key.feature == data::Feature::initial_state || key.feature == data::Feature::constant_force) &&
        value != key.plain)
      throw data::FieldError(key.path, value,
                             "0 but for respond: the criterion is that of a contact that starts at rest");
}

void require_friction(const data::Case& problem) {
  if (problem.contact.friction.static_coefficient() > 0.0) return;
  throw data::FieldError("friction.static_coefficient", "0", "above 0: without friction nothing sticks");
}

}  // namespace stickslip::studies
