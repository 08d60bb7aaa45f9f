// SPDX-License-Identifier: MIT
#pragma once

/// The wave numbers of U'''' + (P/EI) U'' = k U, made dimensionless with the length: b = β L and
/// bb = β̄ L, the arguments of the hyperbolic and the trigonometric functions, with
///
///     bb² - b² = z = P L²/EI,          b² bb² = k L⁴ = (ρ A ω²/EI) L⁴.
///
/// The smaller of the two is the unknown of a characteristic equation, the larger follows from it by a sum of
/// positive terms, so that neither loses digits, not even where b tends to 0 at a buckling load.

#include <algorithm>
#include <cmath>

namespace stickslip::analytic {

struct WaveNumbers {
  double hyperbolic{};     ///< b
  double trigonometric{};  ///< bb
};

/// Both from the smaller one, which is b in compression (z > 0) and bb otherwise.
[[nodiscard]] inline WaveNumbers wave_numbers_from_smaller(double smaller, double z) {
  const double larger = std::sqrt(smaller * smaller + std::abs(z));
  return z > 0.0 ? WaveNumbers{smaller, larger} : WaveNumbers{larger, smaller};
}

/// The smaller one at a given bb; 0 in compression where bb² < z, which no frequency reaches.
[[nodiscard]] inline double smaller_wave_number(double bb, double z) {
  return z > 0.0 ? std::sqrt(std::max(0.0, bb * bb - z)) : bb;
}

/// Both at b bb = scaled_frequency = ω L² √(ρ A/EI) > 0.
[[nodiscard]] inline WaveNumbers wave_numbers_at(double scaled_frequency, double z) {
  const double larger = std::sqrt(0.5 * std::abs(z) + std::hypot(0.5 * z, scaled_frequency));
  const double smaller = scaled_frequency / larger;
  return z > 0.0 ? WaveNumbers{smaller, larger} : WaveNumbers{larger, smaller};
}

}  // namespace stickslip::analytic
