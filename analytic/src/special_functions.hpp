// SPDX-License-Identifier: MIT
#pragma once

/// Functions of one or two numbers in forms without cancellation, overflow and division by zero.

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace stickslip::analytic {

/// sin(y)/y.
[[nodiscard]] inline double sinc(double y) { return y == 0.0 ? 1.0 : std::sin(y) / y; }

// Stumpff functions, entire functions of z that join trigonometric (z > 0), polynomial (z = 0) and
// hyperbolic (z < 0) formulas into one:
//
//     c0 = cos y,  c1 = sin(y)/y,  c2 = (1 - cos y)/y²,  c3 = (y - sin y)/y³,      y = √(z),
//
// and d/ds [s^k c_k(z s²)] = s^(k-1) c_(k-1)(z s²).

/// exp(-decay) c_k(z) for k = 0 ... 3. With decay ≥ √(-z) nothing overflows, however large -z is.
/// Relative accuracy: a few eps away from the zeros of c0 and c1.
[[nodiscard]] double scaled_stumpff(int k, double z, double decay);

/// c_k(z), k = 0 ... 3.
[[nodiscard]] inline double stumpff(int k, double z) { return scaled_stumpff(k, z, 0.0); }

/// (exp(a τ) - exp(b τ))/(a - b), without the cancellation where a and b are close; Re a ≤ 0, Re b ≤ 0. For callers
/// that have the exponentials.
[[nodiscard]] inline std::complex<double> exponential_difference(std::complex<double> a,
                                                                 std::complex<double> b, double tau,
                                                                 std::complex<double> exp_a,
                                                                 std::complex<double> exp_b) {
  const std::complex<double> gap = (a - b) * tau;
  if (std::norm(gap) > 0.25) return (exp_a - exp_b) / (a - b);
  std::complex<double> term = 1.0, sum = 1.0;
  for (int k = 2; std::abs(term) > 0.1 * std::numeric_limits<double>::epsilon() && k < 30; ++k)
    sum += term *= gap / static_cast<double>(k);
  return tau * exp_b * sum;
}
[[nodiscard]] inline std::complex<double> exponential_difference(std::complex<double> a,
                                                                 std::complex<double> b, double tau) {
  return exponential_difference(a, b, tau, std::exp(a * tau), std::exp(b * tau));
}

/// The largest |a + b s + c s²/2| over |s| ≤ r.
inline double largest_parabola(double a, double b, double c, double r) {
  const double at_ends = std::abs(a + 0.5 * c * r * r) + std::abs(b) * r;
  if (std::abs(b) >= std::abs(c) * r) return at_ends;
  return std::max(at_ends, std::abs(a - 0.5 * b * b / c));
}

/// g_n(t) of Eq. (26), given sin(Ω t): as it stands where the frequencies are well apart, since the phase
/// ω_n t of a high mode, known to ω_n t eps, then enters with its small amplitude only; else in the
/// form without 0/0.
[[nodiscard]] inline double modal_coordinate(double excitation, double natural, double t,
                                             double sine_of_excitation) {
  const double sum = excitation + natural, difference = excitation - natural;
  const double sine = std::sin(natural * t);
  if (std::abs(difference) > 0.25 * sum)
    return (natural * sine_of_excitation - excitation * sine) / (sum * difference * natural);
  return (natural * t * std::cos(0.5 * sum * t) * sinc(0.5 * difference * t) - sine) / (sum * natural);
}

}  // namespace stickslip::analytic
