// SPDX-License-Identifier: MIT
#include "contact_driver.hpp"

#include <cmath>
#include <stdexcept>

#include "event_location.hpp"
#include "sign.hpp"

namespace stickslip::solver {

namespace {

// A slip step that ended while the contact moved forward: it is captured if it is slow and can be held.
void accept_slip_step(ContactMotion& motion, double end_time, double forward_velocity) {
  motion.accept_trial_step(end_time);
  const bool slow = forward_velocity <= motion.settings().velocity_threshold;
  if (slow && motion.excess_force() <= 0.0) motion.settle_at_rest();
}

class LocatedChanges final : public ContactDriver {
 public:
  void advance(ContactMotion& motion, double end_time) const override {
    motion.is_stuck() ? advance_stick(motion, end_time) : advance_slip(motion, end_time);
  }

 private:
  static void advance_stick(ContactMotion& motion, double end_time) {
    const double excess = motion.trial_excess_force(end_time);
    if (excess <= 0.0) return motion.accept_trial_step(end_time);
    if (const double excess_now = motion.excess_force(); excess_now < 0.0) {
      const double onset = onset_time(motion, excess_now, end_time, excess);
      motion.compute_trial_step(onset);
      motion.accept_trial_step(onset);
    }
    motion.leave_stick();
  }

  static void advance_slip(ContactMotion& motion, double end_time) {
    const double forward_velocity = motion.trial_forward_velocity(end_time);
    if (forward_velocity > 0.0) return accept_slip_step(motion, end_time, forward_velocity);
    const double rest = rest_time(motion, end_time, forward_velocity);
    motion.compute_trial_step(rest);
    motion.accept_trial_step(rest);
    motion.settle_at_rest();
  }
};

class ChangesAtTheEndOfSteps final : public ContactDriver {
 public:
  void advance(ContactMotion& motion, double end_time) const override {
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
};

// Sect. 3: the state for the step that begins, from |v_s| <= epsilon and |f_s| <= mu_s N alone.
class SchemeOfThePaper final : public ContactDriver {
 public:
  void advance(ContactMotion& motion, double end_time) const override {
    decide(motion);
    motion.compute_trial_step(end_time);
    motion.accept_trial_step(end_time);
  }

 private:
  static void decide(ContactMotion& motion) {
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
};

// Whole steps: in a contact that yields there is nothing to locate.
class YieldingContact final : public ContactDriver {
 public:
  void advance(ContactMotion& motion, double end_time) const override {
    motion.compute_trial_step(end_time);
    motion.accept_trial_step(end_time);
  }
};

}  // namespace

std::unique_ptr<const ContactDriver> make_driver(const ContactMotion& motion) {
  const ContactScheme scheme = motion.settings().scheme;
  if (motion.yields()) {
    if (scheme != ContactScheme::located)
      data::require_rigid(motion.system().tangential, "another contact scheme than located");
    return std::make_unique<YieldingContact>();
  }
  switch (scheme) {
    case ContactScheme::located:
      return std::make_unique<LocatedChanges>();
    case ContactScheme::end_of_step:
      return std::make_unique<ChangesAtTheEndOfSteps>();
    case ContactScheme::paper:
      return std::make_unique<SchemeOfThePaper>();
  }
  throw std::logic_error("no such contact scheme");
}

}  // namespace stickslip::solver
