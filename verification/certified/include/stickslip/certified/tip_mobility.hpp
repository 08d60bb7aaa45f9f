// SPDX-License-Identifier: MIT
#pragma once

/// The mobility of the tip in the usual formula: the velocity of the sliding tip per unit force on it. With D
/// = EI (1 + η s), the roots ±l_1 and ±l_2 of D l⁴ + P l² + ρ A s² = 0, C_i = cosh(l_i L) and S_i =
/// sinh(l_i L), the solution of D u'''' + P u'' + ρ A s² u = 0 with u(0) = u'(0) = u''(L) = 0 and D
/// u'''(L) = -F gives
///
///     Y(s) = s u(L)/F = s (l_1² - l_2²) (C_1 S_2/l_2 - C_2 S_1/l_1)
///                       /{D [l_1⁴ + l_2⁴ - 2 l_1² l_2² C_1 C_2 + l_1 l_2 (l_1² + l_2²) S_1 S_2]}.

#include "stickslip/certified/beam.hpp"

namespace stickslip::certified {

/// The mobility as a complex number.
struct Mobility {
  Real real, imaginary;  ///< m/(N s)
};

/// Y(σ + i ω), with σ and ω in 1/s, η in s, and P of either sign. The radius increases
/// where the terms cancel: near s = 0, near l_1 = l_2 (4 D ρ A s² = P²), and near the poles. It is
/// infinite if the ball contains such a point. Throws std::invalid_argument, naming damping.kelvin_voigt, if
/// that is negative.
[[nodiscard]] Mobility tip_mobility(const Beam& beam, const Real& sigma, const Real& omega,
                                    const Rational& kelvin_voigt = "0");

}  // namespace stickslip::certified
