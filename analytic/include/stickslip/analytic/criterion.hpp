// SPDX-License-Identifier: MIT
#pragma once

/// The criterion of stick-slip occurrence, Eqs. (29) and (30): the tip stays stuck over 0 ≤ t ≤ duration if
/// and only if max |f(t)| ≤ μ_s P, with f the stick-state reaction of Eq. (28).

#include <string_view>

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

class StickReactions;

enum class Verdict { stick, stick_slip, undecided };

/// "stick", "stick-slip" or "undecided".
[[nodiscard]] std::string_view to_string(Verdict verdict) noexcept;

/// Stick-slip if the force exceeds the limit for certain, force.lower > limit, and stick if it does not for certain, force.upper ≤
/// limit: a force that just reaches it does not make the tip slip. Bounds that hold the limit leave it undecided. Both in N.
[[nodiscard]] Verdict verdict_of(const Bounds& force, double limit) noexcept;

struct Criterion {
  Bounds force_max;         ///< max |f|, N, rigorous for the modes kept
  double friction_limit{};  ///< μ_s P, N
  Bounds
      critical_amplitude;  ///< A0 at which max |f| = μ_s P, m, of a general motion load(); infinite when max |f|
                           ///< is 0 for every amplitude
  Verdict verdict{};       ///< verdict_of(force_max, friction_limit)
};

/// Throws data::FieldError, naming beam.axial_force, unless 0 < P < P_cr: without compression there is no
/// contact, at the buckling load no stick state.
void require_contact(const data::Beam& beam);
/// The same of a case; a Model always has contact.
void require_contact(const data::Case& problem);

/// With the first numerics.modes() modes, as in the paper (StickReaction). The reaction is proportional to A0, so that the critical
/// amplitude follows for any amplitude of the base, zero included. Throws what require_contact() and StickReaction throw.
[[nodiscard]] Criterion evaluate_criterion(const data::Case& problem, double relative_width = 1e-10);

/// Without truncation: the exact steady part and many free vibrations (modes_of_all()), with bounds that hold those that are left out,
/// 1e-5 of the paper's force with damping. There are twice as many as long as the bounds hold μ_s P or 0.
[[nodiscard]] Criterion criterion_with_all_modes(const data::Case& problem, double relative_width = 1e-10);
/// Its verdict with less work, by the reactions of many cases.
[[nodiscard]] Verdict verdict_with_all_modes(const data::Case& problem, const StickReactions& reactions,
                                             double relative_width = 1e-10);

}  // namespace stickslip::analytic
