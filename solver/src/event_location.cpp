// SPDX-License-Identifier: MIT
#include "event_location.hpp"

#include <algorithm>
#include <limits>

#include "bracketed_root.hpp"

namespace stickslip::solver {

namespace {

// Far below the error of the method, but not finer than the spacing of floating-point numbers around the time
// itself.
double tolerance(const ContactMotion& motion) {
  constexpr double per_step = 1e-11;
  return std::max(per_step * motion.settings().time_step,
                  2.0 * std::numeric_limits<double>::epsilon() * motion.time());
}

}  // namespace

double onset_time(ContactMotion& motion, double excess_now, double end_time, double excess_at_end) {
  const auto excess_at = [&motion](double t) { return motion.trial_excess_force(t); };
  return bracketed_root(excess_at, motion.time(), excess_now, end_time, excess_at_end, tolerance(motion));
}

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

}  // namespace stickslip::solver
