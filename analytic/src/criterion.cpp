// SPDX-License-Identifier: MIT
#include "stickslip/analytic/criterion.hpp"

#include <limits>

#include "arguments.hpp"
#include "stickslip/analytic/damped_reaction.hpp"

namespace stickslip::analytic {
namespace {

/// The amplitude at which a force that is `per_unit` at amplitude 1 reaches `limit`.
double amplitude_at(double limit, double per_unit) {
  return per_unit > 0.0 ? limit / per_unit : std::numeric_limits<double>::infinity();
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

Criterion evaluate_criterion(const data::Beam& beam, const data::FrictionLaw& friction,
                             const data::HarmonicExcitation& excitation, double duration, int modes,
                             SteadyPart steady_part, double relative_width, const data::Damping& damping) {
  require_contact(beam);
  const Bounds per_unit = largest_unit_force(beam, damping, excitation.frequency_hz(), duration, modes,
                                             steady_part, relative_width);

  Criterion criterion;
  criterion.friction_limit = friction.static_coefficient() * beam.axial_force();
  criterion.force_max = excitation.amplitude() * per_unit;
  criterion.critical_amplitude = {amplitude_at(criterion.friction_limit, per_unit.upper),
                                  amplitude_at(criterion.friction_limit, per_unit.lower)};
  criterion.verdict = verdict_of(criterion.force_max, criterion.friction_limit);
  return criterion;
}

}  // namespace stickslip::analytic
