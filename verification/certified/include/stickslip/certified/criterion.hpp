// SPDX-License-Identifier: MIT
#pragma once

/// The criterion of Eqs. (29) and (30): the tip sticks over 0 <= t <= duration if and only if max |f| <= mu_s
/// P.

#include <string_view>

#include "stickslip/certified/force_maximum.hpp"

namespace stickslip::certified {

/// The result of the criterion.
enum class Verdict {
  stick,       ///< max |f| is at most mu_s P for all values in the balls
  stick_slip,  ///< max |f| is above mu_s P for all values in the balls
  undecided    ///< the balls overlap
};

/// The result as text: "stick", "stick-slip" or "undecided".
[[nodiscard]] std::string_view to_string(Verdict verdict) noexcept;

/// The quantities of the criterion.
struct Criterion {
  ForceMaximum force_max;
  Real friction_limit;      ///< mu_s P, N
  Real critical_amplitude;  ///< A_c = mu_s P/(max |f|/A0), m
  Verdict verdict{};
};

/// Evaluates the criterion with `modes` modes. Throws what max_abs_friction_force() throws, and
/// std::invalid_argument, naming the field, unless beam.axial_force > 0, friction.static_coefficient >= 0 and
/// excitation.amplitude > 0.
[[nodiscard]] Criterion evaluate_criterion(const Beam& beam, const Rational& static_coefficient,
                                           const Excitation& excitation, const Rational& duration,
                                           int modes = 10);

}  // namespace stickslip::certified
