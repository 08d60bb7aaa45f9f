// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "friction_contact.hpp"
#include "stickslip/solver/generalized_alpha.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

/// What a step must know of the contact.
struct StepPhase {
  data::ContactState state{data::ContactState::stick};
  double direction{};    ///< in slip: d = +1 or -1
  double wall_offset{};  ///< in stick: q[c] - w, m; of a contact that yields, the slider's, always
};

/// The equations of one step of the generalised-alpha method in a phase of the contact.
class StepKernel {
 public:
  virtual ~StepKernel() = default;

  /// Puts into `next` the state at end_time, if the phase lasts so long, from the state `now` at `time`. `next` has the
  /// size of `now`.
  virtual void take_step(const StepPhase& phase, const Kinematics& now, double time, double end_time,
                         Kinematics& next) = 0;

  /// f_d at the α level of the last step of a contact that yields, N.
  [[nodiscard]] virtual double yielding_force() const = 0;

  /// Sets the acceleration of the method at the beginning of a phase (StickSlipIntegrator, "Restart").
  virtual void restart(const StepPhase& phase, double time, Kinematics& now) = 0;
};

/// The kernels refer to `system` and `contact`, which must outlive them; time_step is that of a whole step,
/// s. Throw std::invalid_argument, naming the part of the system that they cannot use.
[[nodiscard]] std::unique_ptr<StepKernel> make_sparse_kernel(const ContactSystem& system,
                                                             const FrictionContact& contact,
                                                             const GeneralizedAlpha& method,
                                                             double time_step);
[[nodiscard]] std::unique_ptr<StepKernel> make_modal_kernel(const ContactSystem& system,
                                                            const FrictionContact& contact,
                                                            const GeneralizedAlpha& method, double time_step);

/// w at the α level of a step, weighted as displacements are and not taken at t_star: a spring to the wall then
/// gets the weighted position of the contact.
[[nodiscard]] inline double alpha_level_wall(const ContactSystem& system, const GeneralizedAlpha& method,
                                             double time, double length) {
  return (1.0 - method.alpha_f()) * system.wall.displacement(time + length) +
         method.alpha_f() * system.wall.displacement(time);
}

/// The end of a step is n h and not a sum, so that the length of a whole step is h only up to round-off.
[[nodiscard]] inline bool is_whole_step(double length, double time_step) {
  return std::abs(length - time_step) <= 1e-9 * time_step;
}

}  // namespace stickslip::solver
