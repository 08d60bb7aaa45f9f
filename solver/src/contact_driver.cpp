// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bracketed_root.hpp"
#include "contact_motion.hpp"

namespace stickslip::solver {

namespace {

// Far below the error of the method, but not finer than the spacing of floating-point numbers around the time
// itself.
double tolerance(const ContactMotion& motion) {
  constexpr double per_step = 1e-11;
  return std::max(per_step * motion.settings().time_step,
                  2.0 * std::numeric_limits<double>::epsilon() * motion.time());
}

// When a stuck contact lets go in the step from motion.time() to end_time, s: the excess force, below zero
// now, is above it at the end.
double onset_time(ContactMotion& motion, double excess_now, double end_time, double excess_at_end) {
  const auto excess_at = [&motion](double t) { return motion.trial_excess_force(t); };
  return bracketed_root(excess_at, motion.time(), excess_now, end_time, excess_at_end, tolerance(motion));
}

// When a sliding contact comes to rest in the step from motion.time() to end_time, s: its velocity in the
// direction of the phase is no longer positive at the end.
double rest_time(ContactMotion& motion, double end_time, double forward_velocity_at_end) {
  const auto backward_velocity = [&motion](double t) { return -motion.trial_forward_velocity(t); };
  // A phase that has just begun starts from zero: halve the step until the contact moves forward within it.
  double low = motion.time(), at_low = -motion.phase().direction * motion.sliding_velocity();
  double high = end_time, at_high = -forward_velocity_at_end;
  for (int halving = 0; at_low >= 0.0 && halving < 12; ++halving) {
    const double middle = low + 0.5 * (high - low);
    const double at_middle = backward_velocity(middle);
    (at_middle < 0.0 ? low : high) = middle;
    (at_middle < 0.0 ? at_low : at_high) = at_middle;
  }
  if (at_low >= 0.0) return end_time;
  return bracketed_root(backward_velocity, low, at_low, high, at_high, tolerance(motion));
}

void take_step_to(ContactMotion& motion, double end_time) {
  motion.compute_trial_step(end_time);
  motion.accept_trial_step(end_time);
}

// A slip step that ended while the contact moved forward: it is captured if it is slow and can be held.
void accept_slip_step(ContactMotion& motion, double end_time, double forward_velocity) {
  motion.accept_trial_step(end_time);
  const bool slow = forward_velocity <= motion.settings().velocity_threshold;
  if (slow && motion.excess_force() <= 0.0) motion.settle_at_rest();
}

void advance_stick(ContactMotion& motion, double end_time) {
  const double excess = motion.trial_excess_force(end_time);
  if (excess <= 0.0) return motion.accept_trial_step(end_time);
  if (const double excess_now = motion.excess_force(); excess_now < 0.0)
    take_step_to(motion, onset_time(motion, excess_now, end_time, excess));
  motion.leave_stick();
}

void advance_slip(ContactMotion& motion, double end_time) {
  const double forward_velocity = motion.trial_forward_velocity(end_time);
  if (forward_velocity > 0.0) return accept_slip_step(motion, end_time, forward_velocity);
  take_step_to(motion, rest_time(motion, end_time, forward_velocity));
  motion.settle_at_rest();
}

void locate_changes(ContactMotion& motion, double end_time) {
  motion.is_stuck() ? advance_stick(motion, end_time) : advance_slip(motion, end_time);
}

void change_at_the_end_of_steps(ContactMotion& motion, double end_time) {
  if (motion.is_stuck()) {
    const double excess = motion.trial_excess_force(end_time);
    motion.accept_trial_step(end_time);
    if (!(excess <= 0.0)) motion.leave_stick();
    return;
  }
  const double forward_velocity = motion.trial_forward_velocity(end_time);
  if (forward_velocity > 0.0) return accept_slip_step(motion, end_time, forward_velocity);
  motion.accept_trial_step(end_time);
  motion.settle_at_rest();
}

// Sect. 3: the state for the step that begins, from |v_s| ≤ ε and |f_s| ≤ μ_s N alone.
void decide_as_the_paper(ContactMotion& motion) {
  const double sliding = motion.sliding_velocity();
  const bool sticks =
      std::abs(sliding) <= motion.settings().velocity_threshold && motion.excess_force() <= 0.0;
  if (sticks) {
    if (!motion.is_stuck()) motion.overwrite_sliding_velocity();
    return;
  }
  const bool from_rest = motion.is_stuck() || sliding == 0.0;
  const double direction = from_rest ? -sign(motion.holding_force()) : sign(sliding);
  if (motion.is_stuck() || direction != motion.phase().direction) motion.turn_to(direction);
}

void step_as_the_paper(ContactMotion& motion, double end_time) {
  decide_as_the_paper(motion);
  take_step_to(motion, end_time);
}

}  // namespace

ContactDriver driver_of(const ContactMotion& motion) {
  const ContactScheme scheme = motion.settings().scheme;
  if (motion.yields()) {
    if (scheme != ContactScheme::located)
      data::require_rigid(motion.system().tangential, "another contact scheme than located");
    return take_step_to;  // in a contact that yields there is nothing to locate
  }
  switch (scheme) {
    case ContactScheme::located:
      return locate_changes;
    case ContactScheme::end_of_step:
      return change_at_the_end_of_steps;
    case ContactScheme::paper:
      return step_as_the_paper;
  }
  throw std::logic_error("no such contact scheme");
}

}  // namespace stickslip::solver
