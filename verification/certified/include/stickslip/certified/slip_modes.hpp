// SPDX-License-Identifier: MIT
#pragma once

/// The slip state: clamped at x = 0 and free at x = L under a follower force P. With b = β L and bb =
/// betabar L of stick_modes.hpp, z = P L²/EI and κ = ω L² √(ρ A/EI) = b bb, the frequency
/// equation is (Beck, ZAMP 3, 1952)
///
///     z² + 2 κ² [1 + cosh(b) cos(bb)] + z κ sinh(b) sin(bb) = 0.

#include <vector>

#include "stickslip/certified/beam.hpp"

namespace stickslip::certified {

/// A natural frequency of the slip state.
struct SlipFrequency {
  int number{};
  Real angular_frequency;  ///< ω, rad/s
  Real frequency_hz;       ///< ω/(2 π)
};

/// The flutter factor P_flutter L²/EI, at which the two lowest roots coincide. The interval Newton method,
/// applied to the frequency equation and its derivative in κ, proves that the two vanish together at
/// exactly one point of a box.
[[nodiscard]] Real flutter_factor();

/// The first `count` frequencies, as enclosures. They are the roots of the frequency equation up to bb = 2 π
/// ceil(count/2), where its left side is positive. There must be two roots for each 2 π, as at P = 0. Throws
/// std::invalid_argument unless 1 ≤ count ≤ 1000, std::domain_error, naming beam.axial_force, unless P is
/// certainly below the flutter load, and what isolate_roots() throws.
[[nodiscard]] std::vector<SlipFrequency> slip_frequencies(const Beam& beam, int count);

}  // namespace stickslip::certified
