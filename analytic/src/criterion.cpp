// SPDX-License-Identifier: MIT
#include "stickslip/analytic/criterion.hpp"

#include <algorithm>
#include <limits>

#include "arguments.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_reaction.hpp"

namespace stickslip::analytic {
namespace {

/// The amplitude at which a force that is `per_unit` at amplitude 1 reaches `limit`.
double amplitude_at(double limit, double per_unit) {
  return per_unit > 0.0 ? limit / per_unit : std::numeric_limits<double>::infinity();
}

double friction_limit(const data::Case& problem) {
  return problem.contact.friction.static_coefficient() * problem.normal_force();
}

Criterion criterion_of(const data::Case& problem, const Bounds& per_unit) {
  const double limit = friction_limit(problem);
  const Bounds force = load(problem) * per_unit;
  return {.force_max = force,
          .friction_limit = limit,
          .critical_amplitude = {amplitude_at(limit, per_unit.upper), amplitude_at(limit, per_unit.lower)},
          .verdict = verdict_of(force, limit)};
}

}  // namespace

std::string_view to_string(Verdict verdict) noexcept {
  if (verdict == Verdict::undecided) return "undecided";
  return verdict == Verdict::stick ? "stick" : "stick-slip";
}

Verdict verdict_of(const Bounds& force, double limit) noexcept {
  if (force.lower > limit) return Verdict::stick_slip;
  return force.upper <= limit ? Verdict::stick : Verdict::undecided;
}

void require_contact(const data::Beam& beam) {
  if (beam.axial_force() > 0.0 && beam.axial_force() < stick_buckling_load(beam)) return;
  throw data::FieldError("beam.axial_force", beam.axial_force(),
                         "positive, to press the tip against the wall, and below the buckling load "
                         "of the stick state, " +
                             data::shortest_text(stick_buckling_load(beam)) + " N");
}

void require_contact(const data::Case& problem) {
  if (problem.model() == nullptr) require_contact(problem.beam());
}

Criterion evaluate_criterion(const data::Case& problem, double relative_width) {
  require_contact(problem);
  return criterion_of(problem, StickReaction(problem).largest(relative_width));
}

Criterion criterion_with_all_modes(const data::Case& problem, double relative_width) {
  require_contact(problem);
  const auto [first, most] = modes_of_all(problem);
  for (int modes = first;; modes = std::min(2 * modes, most)) {
    const Bounds per_unit = StickReaction(problem, modes).largest(relative_width);
    const Criterion criterion = criterion_of(problem, per_unit);
    if ((criterion.verdict != Verdict::undecided && per_unit.lower > 0.0) || modes == most) return criterion;
  }
}

Verdict verdict_with_all_modes(const data::Case& problem, const StickReactions& reactions,
                               double relative_width) {
  require_contact(problem);
  if (load(problem) == 0.0) return Verdict::stick;
  const double of_unit = friction_limit(problem) / load(problem);
  const auto [first, most] = modes_of_all(problem, true);
  for (int modes = first;; modes = std::min(2 * modes, most)) {
    const Verdict verdict =
        verdict_of(reactions.of(problem, modes).largest_against(of_unit, relative_width), of_unit);
    if (verdict != Verdict::undecided || modes == most) return verdict;
  }
}

}  // namespace stickslip::analytic
