// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bracketed_root.hpp"
#include "friction_contact.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

// Far below the error of the method, but not finer than the spacing of floating-point numbers around the time
// itself.
double StickSlipIntegrator::time_tolerance() const {
  constexpr double per_step = 1e-11;
  return std::max(per_step * settings_.time_step, 2.0 * std::numeric_limits<double>::epsilon() * time_);
}

// When a stuck contact lets go in the step from now to end_time, s: the excess force, below zero
// now, is above it at the end.
double StickSlipIntegrator::onset_time(double excess_now, double end_time, double excess_at_end) {
  const auto excess_at = [this](double t) { return trial_excess_force(t); };
  return bracketed_root(excess_at, time_, excess_now, end_time, excess_at_end, time_tolerance());
}

// When a sliding contact comes to rest in the step from now to end_time, s: its velocity in the
// direction of the phase is no longer positive at the end.
double StickSlipIntegrator::rest_time(double end_time, double forward_velocity_at_end) {
  const auto backward_velocity = [this](double t) { return -trial_forward_velocity(t); };
  // A phase that has just begun starts from zero: halve the step until the contact moves forward within it.
  double low = time_, at_low = -phase_.direction * relative_velocity();
  double high = end_time, at_high = -forward_velocity_at_end;
  for (int halving = 0; at_low >= 0.0 && halving < 12; ++halving) {
    const double middle = low + 0.5 * (high - low);
    const double at_middle = backward_velocity(middle);
    (at_middle < 0.0 ? low : high) = middle;
    (at_middle < 0.0 ? at_low : at_high) = at_middle;
  }
  if (at_low >= 0.0) return end_time;
  return bracketed_root(backward_velocity, low, at_low, high, at_high, time_tolerance());
}

void StickSlipIntegrator::take_step_to(double end_time) {
  compute_trial_step(end_time);
  accept_trial_step(end_time);
}

// A slip step that ended while the contact moved forward: it is captured if it is slow and can be held.
void StickSlipIntegrator::accept_slip_step(double end_time, double forward_velocity) {
  accept_trial_step(end_time);
  const bool slow = forward_velocity <= settings_.velocity_threshold;
  if (slow && excess_force() <= 0.0) stick_or_reverse();
}

void StickSlipIntegrator::advance_stick(double end_time) {
  const double excess = trial_excess_force(end_time);
  if (excess <= 0.0) return accept_trial_step(end_time);
  if (const double excess_now = excess_force(); excess_now < 0.0)
    take_step_to(onset_time(excess_now, end_time, excess));
  leave_stick();
}

void StickSlipIntegrator::advance_slip(double end_time) {
  const double forward_velocity = trial_forward_velocity(end_time);
  if (forward_velocity > 0.0) return accept_slip_step(end_time, forward_velocity);
  take_step_to(rest_time(end_time, forward_velocity));
  stick_or_reverse();
}

void StickSlipIntegrator::locate_changes(double end_time) {
  is_stuck() ? advance_stick(end_time) : advance_slip(end_time);
}

void StickSlipIntegrator::change_at_the_end_of_steps(double end_time) {
  if (is_stuck()) {
    const double excess = trial_excess_force(end_time);
    accept_trial_step(end_time);
    if (!(excess <= 0.0)) leave_stick();
    return;
  }
  const double forward_velocity = trial_forward_velocity(end_time);
  if (forward_velocity > 0.0) return accept_slip_step(end_time, forward_velocity);
  accept_trial_step(end_time);
  stick_or_reverse();
}

// Sect. 3: the state for the step that begins, from |v_s| ≤ ε and |f_s| ≤ μ_s N alone.
void StickSlipIntegrator::decide_as_the_paper() {
  const double sliding = relative_velocity();
  const bool sticks = std::abs(sliding) <= settings_.velocity_threshold && excess_force() <= 0.0;
  if (sticks) {
    if (!is_stuck()) overwrite_sliding_velocity();
    return;
  }
  const bool from_rest = is_stuck() || sliding == 0.0;
  const double direction = from_rest ? -sign(holding_force()) : sign(sliding);
  if (is_stuck() || direction != phase_.direction) turn_to(direction);
}

void StickSlipIntegrator::step_as_the_paper(double end_time) {
  decide_as_the_paper();
  take_step_to(end_time);
}

StickSlipIntegrator::Scheme StickSlipIntegrator::scheme() const {
  if (yields()) {
    if (settings_.scheme != ContactScheme::located)
      data::require_rigid(system_.tangential, "another contact scheme than located");
    return &StickSlipIntegrator::take_step_to;  // in a contact that yields there is nothing to locate
  }
  switch (settings_.scheme) {
    case ContactScheme::located:
      return &StickSlipIntegrator::locate_changes;
    case ContactScheme::end_of_step:
      return &StickSlipIntegrator::change_at_the_end_of_steps;
    case ContactScheme::paper:
      return &StickSlipIntegrator::step_as_the_paper;
  }
  throw std::logic_error("no such contact scheme");
}

}  // namespace stickslip::solver
