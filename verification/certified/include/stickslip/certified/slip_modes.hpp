#pragma once

/// The slip state: clamped at x = 0, free at x = L under a follower force P. With b = beta L, bb = betabar L
/// of stick_modes.hpp, z = P L^2/EI and kappa = omega L^2 sqrt(rho A/EI) = b bb, the frequency equation is
/// (Beck, ZAMP 3, 1952)
///
///     z^2 + 2 kappa^2 [1 + cosh(b) cos(bb)] + z kappa sinh(b) sin(bb) = 0.

#include <vector>

#include "stickslip/certified/beam.hpp"

namespace stickslip::certified {

struct SlipFrequency {
  int number{};
  Real angular_frequency;  ///< omega, rad/s
  Real frequency_hz;       ///< omega/(2 pi)
};

/// P_flutter L^2/EI: the load at which the two lowest roots meet, by the interval Newton method for the
/// frequency equation and its derivative in kappa, which proves that they vanish together once in a box.
[[nodiscard]] Real flutter_factor();

/// The first `count` frequencies: all roots of the frequency equation up to bb = 2 pi ceil(count/2), where
/// its left side is positive, isolated with proof; there must be two for each 2 pi, as at P = 0. Throws
/// std::invalid_argument unless 1 <= count <= 1000, std::domain_error, naming beam.axial_force, unless P is
/// certainly below the flutter load, and std::runtime_error as isolate_roots().
[[nodiscard]] std::vector<SlipFrequency> slip_frequencies(const Beam& beam, int count);

}  // namespace stickslip::certified
