// SPDX-License-Identifier: MIT
#pragma once

/// The flat section of Fig. 14, 0.2 m by 0.02 m, at 25 Hz and 1 mm.

#include "support/beams.hpp"

namespace stickslip::testing {

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
          .beam = flat_beam(2.0, 500.0),
          .friction = paper_friction(),
          .excitation = data::HarmonicExcitation({.frequency_hz = 25.0, .amplitude = 1e-3}),
          .numerics = data::NumericalSettings(paper_choices(10.0))};
}

}  // namespace stickslip::testing
