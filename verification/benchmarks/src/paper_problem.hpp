// SPDX-License-Identifier: MIT
#pragma once

/// The beam of the paper with its friction, settings and excitations for the benchmarks.

#include "stickslip/data/problem.hpp"

namespace stickslip::benchmarks {

inline const data::Beam paper_beam({.length = 2.0,
                                    .area = 0.01,
                                    .second_moment_of_area = 1e-4 / 12.0,
                                    .density = 1000.0,
                                    .youngs_modulus = 2e9,
                                    .axial_force = 500.0});
inline const data::FrictionLaw paper_friction({.static_coefficient = 0.6,
                                               .kinetic_coefficient = 0.3,
                                               .decay = 1.0});
inline constexpr double ten_seconds = 10.0;

/// The excitation with the frequency `hz` (Hz) and the amplitude `amplitude` (m).
inline data::HarmonicExcitation shaking(double hz, double amplitude) {
  return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = amplitude});
}

/// The settings of the paper with another number of elements, another duration (s) and other modes.
inline data::NumericalSettings settings(int elements, double duration = ten_seconds, int modes = 10) {
  return data::NumericalSettings({.elements = elements,
                                  .time_step = 1e-4,
                                  .spectral_radius = 0.9,
                                  .velocity_threshold = 1e-4,
                                  .modes = modes,
                                  .duration = duration});
}

}  // namespace stickslip::benchmarks
