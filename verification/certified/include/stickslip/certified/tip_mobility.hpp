// SPDX-License-Identifier: MIT
#pragma once

/// The mobility of the tip in the usual formula: the velocity of the sliding tip per unit force on it. With D
/// = EI (1 + eta s), the roots +-l_1 and +-l_2 of D l^4 + P l^2 + rho A s^2 = 0, C_i = cosh(l_i L) and S_i =
/// sinh(l_i L), the solution of D u'''' + P u'' + rho A s^2 u = 0 with u(0) = u'(0) = u''(L) = 0 and D
/// u'''(L) = -F gives
///
///     Y(s) = s u(L)/F = s (l_1^2 - l_2^2) (C_1 S_2/l_2 - C_2 S_1/l_1)
///                       /{D [l_1^4 + l_2^4 - 2 l_1^2 l_2^2 C_1 C_2 + l_1 l_2 (l_1^2 + l_2^2) S_1 S_2]}.

#include "stickslip/certified/beam.hpp"

namespace stickslip::certified {

/// The mobility as a complex number.
struct Mobility {
  Real real, imaginary;  ///< m/(N s)
};

/// Y(sigma + i omega), with sigma and omega in 1/s, eta in s, and P of either sign. The radius increases
/// where the terms cancel: near s = 0, near l_1 = l_2 (4 D rho A s^2 = P^2), and near the poles. It is
/// infinite if the ball contains such a point. Throws std::invalid_argument, naming damping.kelvin_voigt, if
/// that is negative.
[[nodiscard]] Mobility tip_mobility(const Beam& beam, const Real& sigma, const Real& omega,
                                    const Rational& kelvin_voigt = "0");

}  // namespace stickslip::certified
