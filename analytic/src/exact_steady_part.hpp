// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <complex>
#include <numbers>

#include "stickslip/analytic/modal_reaction.hpp"

namespace stickslip::analytic {

/// Adds to the quasi-static part of a sum over N modes what the exact steady amplitude, a function of the complex
/// frequency, has at Ω beyond this sum.
///
/// The difference is analytic in Ω up to ω_(N+1). It is taken as its mean over a circle of radius
/// max(Ω, ω_1)/4 round Ω, by the trapezoidal rule. With ω_N ≥ 2 Ω the nearest singularity is at
/// least four radii away, so that 32 nodes leave an error of 4⁻³². The nodes, conjugate ones taken together, lie off
/// the real axis and with it off every singularity of the parts: the ω_n, and 0, where the amplitude is regular
/// but its formula is not.
template <class ExactAmplitude>
void complete_steady_part(ModalReaction& sum, double omega, const ExactAmplitude& exact_amplitude) {
  constexpr int nodes = 16;
  const double radius = 0.25 * std::max(omega, sum.modes.front().angular_frequency);
  double mean = 0.0;
  for (int j = 0; j < nodes; ++j) {
    const std::complex<double> frequency = omega + std::polar(radius, std::numbers::pi * (j + 0.5) / nodes);
    const std::complex<double> squared = frequency * frequency;
    std::complex<double> remainder = exact_amplitude(frequency) - sum.quasi_static;
    for (const auto& [natural, coefficient] : sum.modes)
      remainder -= coefficient * squared / (squared - natural * natural);
    mean += remainder.real() / nodes;
  }
  sum.quasi_static += mean;
}

}  // namespace stickslip::analytic
