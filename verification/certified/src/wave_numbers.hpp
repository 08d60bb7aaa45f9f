// SPDX-License-Identifier: MIT
#pragma once

namespace stickslip::certified {

/// The dimensionless wave numbers b = β L and bb = betabar L.
template <class T>
struct WaveNumbers {
  T hyperbolic, trigonometric;
};

/// Both wave numbers at κ = ω L² √(ρ A/EI): b² = -z/2 + s, bb² = z/2 + s, s = √(z²/4 +
/// κ²).
template <class T>
WaveNumbers<T> wave_numbers(const T& kappa, const T& load_factor) {
  const T half = load_factor / 2;
  const T s = sqrt(half * half + kappa * kappa);
  return {sqrt(s - half), sqrt(s + half)};
}

}  // namespace stickslip::certified
