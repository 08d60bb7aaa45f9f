// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "sinc.hpp"

namespace stickslip::analytic {

/// g_n(t) of Eq. (26), given sin(Omega t): as it stands where the frequencies are well apart, since the phase
/// omega_n t of a high mode, known to omega_n t eps, then enters with its small amplitude only; else in the
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
