// SPDX-License-Identifier: MIT
#include "validation/rig.hpp"

#include <cmath>

#include "stickslip/analytic/slip_modes.hpp"

namespace stickslip::validation {

namespace {

double first_frequency(data::BeamProperties properties, double length, double load, double direction) {
  properties.length = length;
  properties.axial_force = load;
  properties.axial_direction = direction;
  return analytic::slip_modes(data::Beam(properties), 1).front().frequency_hz();
}

}  // namespace

std::vector<FrequencyPair> axial_direction_experiment(const data::Beam& beam) {
  std::vector<FrequencyPair> pairs;
  for (const double length : {0.3, 0.4})
    for (const double load : {0.5, 1.0, 2.0, 3.0, 4.0}) {
      FrequencyPair pair{.length = length, .load = load};
      pair.following = first_frequency(beam.properties(), length, load, 0.0);
      pair.fixed = first_frequency(beam.properties(), length, load, 1.0);
      pair.accuracy = std::abs(pair.following - pair.fixed) / (2.0 * (pair.following + pair.fixed));
      pairs.push_back(pair);
    }
  return pairs;
}

double allowed_load_error(const data::Beam& beam, const FrequencyPair& pair) {
  constexpr double step = 1e-3;
  const double above = first_frequency(beam.properties(), pair.length, pair.load * (1.0 + step), 1.0);
  const double below = first_frequency(beam.properties(), pair.length, pair.load * (1.0 - step), 1.0);
  return pair.accuracy / (std::abs(above - below) / (2.0 * step * pair.fixed));
}

}  // namespace stickslip::validation
