#pragma once

#include <fmt/format.h>

#include <cmath>

#include "stickslip/data/paper.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// The frequencies of the four |f_max| in Sect. 5, Hz.
inline constexpr double printed_frequencies[] = {15.0, 25.0, 35.0, 70.0};

/// Their excitations, all of 0.5 mm.
inline data::HarmonicExcitation printed_excitation(double hz) {
  return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.5e-3});
}

/// The |f_max| printed for one of them, N.
inline data::PrintedNumber printed_force(double hz) {
  return data::printed_number(fmt::format("force_max.{}", std::lround(hz)));
}

/// `beam` with one property replaced.
inline data::Beam with(const data::Beam& beam, double data::BeamProperties::*field, double value) {
  data::BeamProperties properties = beam.properties();
  properties.*field = value;
  return data::Beam(properties);
}

}  // namespace stickslip::studies
