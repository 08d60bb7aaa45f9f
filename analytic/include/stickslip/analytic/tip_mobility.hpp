// SPDX-License-Identifier: MIT
#pragma once

/// The mobility of the tip in closed form: the velocity of the sliding beam per unit friction force on its
/// tip, as a function of the complex frequency s (1/s). The whole linear beam, all modes included, is in it.
///
/// A motion u(x) exp(s t) of the beam that is clamped at x = 0 and loaded by the force F exp(s t) at its tip
/// obeys
///
///     D u'''' + P u'' + ρ A s² u = 0,   D = EI (1 + η s),
///     u(0) = u'(0) = u''(L) = 0,             D u'''(L) + χ P u'(L) = -F,
///
/// the slip state of Eqs. (1), (2) and (5) with the axial force P of either sign, which follows the tip for χ = 0,
/// and Kelvin-Voigt damping η. Four exponents ±l_1, ±l_2 give the textbook form, a quotient of products of hyperbolic functions in
/// which almost everything cancels where the exponents meet or are small. In
///
///     k = s L² √(ρ A/D),   z = P L²/D,
///     a = -z + 2 k,   b = -z - 2 k     (a, b = (l_1 ± l_2)² L²),
///
/// and with the entire functions Φ(q) = sinh(√q)/√q, c(q) = (cosh(√q) - 1)/q = Φ(q/4)²/2, it
/// is
///
///     Y(s) = L/(2 √(D ρ A)) [Φ(a) - Φ(b)] / [1 + (k/2) (c(a) - c(b)) - (χ z/2) (c(a) + c(b))].
///
/// Its limits: Y/s is the static flexibility for s -> 0, L³/(3 EI) at P = 0 and η = 0; and the beam is
/// half-infinite for short times, Y -> √(2) D^(-1/4) (ρ A)^(-3/4) s^(-1/2) for |s| -> infinity in Re s >
/// 0. Undamped, its poles are ±i times the frequencies of the slip modes, its zeros those of the stick modes
/// and 0.
///
/// The follower force may do work; at χ = 1 Y is passive up to the buckling load, π²/4 EI/L². At χ = 0, as
/// computed, Y is passive (Re Y ≥ 0 in Re s > 0) without damping as long
/// as the first slip frequency is below the first stick frequency, P L²/EI up to 16.0, where flutter begins
/// at 20.05; with Kelvin-Voigt damping in a smaller range about P = 0, which holds -5 and 5.

#include <complex>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

class TipMobility {
 public:
  using Complex = std::complex<double>;

  /// Throws data::FieldError, naming the key, for damping other than Kelvin-Voigt's: there is no such closed form with
  /// an axial force.
  explicit TipMobility(const data::Beam& beam, const data::Damping& damping = {});

  /// Y(s), m/(N s); s in 1/s. No exponential grows. Accuracy: round-off, times |l L| for the phase of the
  /// waves, and as the condition number of Y near a pole.
  [[nodiscard]] Complex operator()(Complex s) const;

  /// Velocity u_t(x) per unit force at the tip, m/(N s); 0 ≤ x ≤ L in m, and Y(s) at x = L.
  [[nodiscard]] Complex transfer(double x, Complex s) const;

 private:
  struct Scaled;
  [[nodiscard]] Scaled scaled(Complex s) const;

  data::Beam beam_;
  double kelvin_voigt_;
};

}  // namespace stickslip::analytic
