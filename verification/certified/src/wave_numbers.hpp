// SPDX-License-Identifier: MIT
#pragma once

namespace stickslip::certified {

/// The dimensionless wave numbers b = beta L and bb = betabar L.
template <class T>
struct WaveNumbers {
  T hyperbolic, trigonometric;
};

/// Both wave numbers at kappa = omega L^2 sqrt(rho A/EI): b^2 = -z/2 + s, bb^2 = z/2 + s, s = sqrt(z^2/4 +
/// kappa^2).
template <class T>
WaveNumbers<T> wave_numbers(const T& kappa, const T& load_factor) {
  const T half = load_factor / 2;
  const T s = sqrt(half * half + kappa * kappa);
  return {sqrt(s - half), sqrt(s + half)};
}

}  // namespace stickslip::certified
