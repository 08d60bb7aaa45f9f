#pragma once

/// The criterion of Eqs. (29) and (30): the tip sticks over 0 <= t <= duration if and only if max |f| <= mu_s
/// P.

#include <string_view>

#include "stickslip/certified/force_maximum.hpp"

namespace stickslip::certified {

enum class Verdict {
  stick,       ///< max |f| is certainly at most mu_s P
  stick_slip,  ///< max |f| is certainly above mu_s P
  undecided    ///< the balls overlap
};

/// "stick", "stick-slip" or "undecided".
[[nodiscard]] std::string_view to_string(Verdict verdict) noexcept;

struct Criterion {
  ForceMaximum force_max;
  Real friction_limit;      ///< mu_s P, N
  Real critical_amplitude;  ///< A_c = mu_s P/(max |f|/A0), m
  Verdict verdict{};
};

/// Throws as max_abs_friction_force(), and std::invalid_argument, naming the field, unless
/// beam.axial_force > 0, friction.static_coefficient >= 0 and excitation.amplitude > 0.
[[nodiscard]] Criterion evaluate_criterion(const Beam& beam, const Rational& static_coefficient,
                                           const Excitation& excitation, const Rational& duration,
                                           int modes = 10);

}  // namespace stickslip::certified
