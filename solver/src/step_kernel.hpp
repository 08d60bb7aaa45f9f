// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "friction_contact.hpp"
#include "stickslip/solver/generalized_alpha.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

/// The equations of one step of the generalised-alpha method in a phase of the contact.
class StepKernel {
 public:
  /// `system` and `contact` must outlive this; time_step is that of a whole step, s.
  StepKernel(const ContactSystem& system, const FrictionContact& contact, const GeneralizedAlpha& method,
             double time_step)
      : system_(system), contact_(contact), method_(method), time_step_(time_step) {}
  virtual ~StepKernel() = default;

  /// Puts into `next` the state at end_time, if the phase lasts so long, from the state `now` at `time`. `next` has the
  /// size of `now`.
  virtual void take_step(const StepPhase& phase, const Kinematics& now, double time, double end_time,
                         Kinematics& next) = 0;

  /// f_d at the α level of the last step of a contact that yields, N.
  [[nodiscard]] double yielding_force() const { return yielding_force_; }

  /// Sets the acceleration of the method at the beginning of a phase (StickSlipIntegrator, "Restart").
  virtual void restart(const StepPhase& phase, double time, Kinematics& now) = 0;

 protected:
  /// The contact moves with the wall.
  [[nodiscard]] bool is_held(const StepPhase& phase) const {
    return phase.state == data::ContactState::stick && !contact_.yields();
  }

  /// The end of a step is n h and not a sum, so that the length of a whole step is h only up to round-off.
  [[nodiscard]] bool is_whole_step(double length) const {
    return std::abs(length - time_step_) <= 1e-9 * time_step_;
  }

  /// f_d at the α level of a slip step, N. `displacement` and `velocity` are those of the contact at the α level, m and
  /// m/s, without the share of the new acceleration: `free_acceleration` without f_d, m/s², and `response` to it, 1/kg.
  double friction_force(const StepPhase& phase, double time, double length, double displacement,
                        double velocity, double free_acceleration, double response);

  const ContactSystem& system_;
  const FrictionContact& contact_;
  GeneralizedAlpha method_;
  double time_step_;

 private:
  double yielding_force_{};
};

/// Throw std::invalid_argument, naming the part of the system that they cannot use.
[[nodiscard]] std::unique_ptr<StepKernel> make_sparse_kernel(const ContactSystem& system,
                                                             const FrictionContact& contact,
                                                             const GeneralizedAlpha& method,
                                                             double time_step);
[[nodiscard]] std::unique_ptr<StepKernel> make_modal_kernel(const ContactSystem& system,
                                                            const FrictionContact& contact,
                                                            const GeneralizedAlpha& method, double time_step);

}  // namespace stickslip::solver
