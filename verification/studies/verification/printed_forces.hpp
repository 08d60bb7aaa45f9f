// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cmath>

#include "stickslip/data/paper.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// The frequencies (Hz) of the four |f_max| printed in Sect. 5.
inline constexpr double printed_frequencies[] = {15.0, 25.0, 35.0, 70.0};

/// The excitation of a printed |f_max|, with an amplitude of 0.5 mm.
inline data::HarmonicExcitation printed_excitation(double hz) {
  return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.5e-3});
}

/// The printed |f_max| at one of these frequencies, N.
inline data::PrintedNumber printed_force(double hz) {
  return data::printed_number(fmt::format("force_max.{}", std::lround(hz)));
}

/// A copy of `beam` with one property changed.
inline data::Beam with(const data::Beam& beam, double data::BeamProperties::*field, double value) {
  data::BeamProperties properties = beam.properties();
  properties.*field = value;
  return data::Beam(properties);
}

/// The beam of Fig. 13, with half of E.
inline data::Beam half_stiff(const data::Beam& beam) {
  return with(beam, &data::BeamProperties::youngs_modulus, 0.5 * beam.youngs_modulus());
}

}  // namespace stickslip::studies
