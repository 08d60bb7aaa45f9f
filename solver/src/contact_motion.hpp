// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "friction_contact.hpp"
#include "held_contact.hpp"
#include "step_kernel.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

/// The motion of a ContactSystem, phase by phase. A ContactDriver decides when a phase ends.
class ContactMotion {
 public:
  ContactMotion(ContactSystem system, const IntegratorSettings& settings);
  // Its parts refer to system_.
  ContactMotion(const ContactMotion&) = delete;
  ContactMotion& operator=(const ContactMotion&) = delete;

  /// See StickSlipIntegrator.
  void start_stuck(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);
  void start_slipping(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);
  /// Begins the next step of the grid and returns its end, s.
  double begin_step();
  /// Throws std::runtime_error, naming the time, if the state is not finite.
  void end_step();

  [[nodiscard]] double time() const noexcept { return time_; }
  [[nodiscard]] long steps() const noexcept { return steps_; }
  [[nodiscard]] const Kinematics& now() const noexcept { return now_; }
  [[nodiscard]] const StepPhase& phase() const noexcept { return phase_; }
  [[nodiscard]] bool yields() const noexcept { return contact_.yields(); }
  [[nodiscard]] bool is_stuck() const noexcept { return phase_.state == data::ContactState::stick; }
  [[nodiscard]] const ContactSystem& system() const noexcept { return system_; }
  [[nodiscard]] const HeldContact& held_contact() const noexcept { return held_contact_; }
  [[nodiscard]] const IntegratorSettings& settings() const noexcept { return settings_; }
  [[nodiscard]] const std::vector<data::ContactEvent>& events() const noexcept { return events_; }

  /// Of the present state: v_s (whatever is left of it in stick), and the force that holding would take.
  [[nodiscard]] double sliding_velocity() const { return held_contact_.sliding_velocity(now_, time_); }
  [[nodiscard]] double holding_force() const { return held_contact_.holding_force(now_, time_); }
  [[nodiscard]] double friction_force() const;
  /// Above zero the contact cannot be held, N.
  [[nodiscard]] double excess_force() const { return contact_.excess(holding_force()); }

  /// The state at end_time, if the contact stays as it is.
  const Kinematics& compute_trial_step(double end_time);
  /// Of the trial step that ends at end_time: the excess force, and d v_s, negative once the contact has come
  /// to rest.
  double trial_excess_force(double end_time);
  double trial_forward_velocity(double end_time);
  /// The last trial step, which ends at new_time, becomes the state. In a contact that yields the slider follows, and a
  /// change is recorded: f_d does not jump, so that a change inside a step costs no order and is not located.
  void accept_trial_step(double new_time);

  void observe(std::function<void()> observer) { observer_ = std::move(observer); }

  /// Changes of the contact at the present state, recorded as events.
  void leave_stick();
  /// The contact is at rest on the wall, up to what the location left: stick if it can be held, else slip.
  void settle_at_rest();
  /// The changes of ContactScheme::paper: no impulse, no restart.
  void overwrite_sliding_velocity();
  void turn_to(double direction);

 private:
  void start(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);
  void begin_yielding();
  void move_slider(double length);  // after a step of this length
  void begin_stick();
  void begin_slip(double direction);
  [[nodiscard]] double position() const;  // q[c] - w
  void record(data::ContactChange change);
  void notify() const;

  ContactSystem system_;
  IntegratorSettings settings_;
  GeneralizedAlpha method_;
  FrictionContact contact_;
  HeldContact held_contact_;
  std::unique_ptr<StepKernel> kernel_;

  Kinematics now_, trial_;
  double time_{};
  long steps_{};
  StepPhase phase_;
  int events_in_step_{};
  std::vector<data::ContactEvent> events_;
  // Of a contact that yields: f_d now, and f_d and time of the last α level.
  double yielding_force_{}, alpha_level_force_{}, alpha_level_time_{};
  std::function<void()> observer_;
};

/// A ContactScheme, which decides when the contact changes: takes the motion towards end_time, the end of its grid step:
/// there, or to a change of the contact.
using ContactDriver = void (*)(ContactMotion& motion, double end_time);

[[nodiscard]] ContactDriver driver_of(const ContactMotion& motion);

}  // namespace stickslip::solver
