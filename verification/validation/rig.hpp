// SPDX-License-Identifier: MIT
#pragma once

/// What an experiment with the beam itself must measure, and how accurately.

#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::validation {

/// The first frequency of the strip with its tip free at one load, if the axial force follows the tip and if it keeps its
/// direction.
struct FrequencyPair {
  double length{};     ///< m
  double load{};       ///< N
  double following{};  ///< Hz
  double fixed{};      ///< Hz
  /// The relative standard uncertainty of the frequency (of the measurement, u_input and u_num together) up to which the
  /// intervals +- 2 u of the two do not meet: |difference|/(2 (following + fixed)).
  double accuracy{};
};

/// At lengths of 0.3 and 0.4 m and loads of 0.5, 1, 2, 3 and 4 N, the beam otherwise as given.
[[nodiscard]] std::vector<FrequencyPair> axial_direction_experiment(const data::Beam& beam);

/// The largest relative standard uncertainty of the load, as the only one: accuracy f/|P df/dP| with a fixed direction.
[[nodiscard]] double allowed_load_error(const data::Beam& beam, const FrequencyPair& pair);

}  // namespace stickslip::validation
