// SPDX-License-Identifier: MIT
/// Steps in the coordinates of a HeldTipBasis: in stick the modes do not know each other, in slip they meet in
/// the contact alone. A step takes a few passes over arrays and no factorisation, whatever its length.

#include <Eigen/SparseCore>
#include <stdexcept>

#include "step_kernel.hpp"

namespace stickslip::solver {

namespace {

// Modes act on each other through the contact alone. Its displacement does not act on them: it moves the static shape,
// which needs no force but at the contact.
void require_modal_form(const ContactSystem& system) {
  const Eigen::Index last = system.mass.rows() - 1;
  const auto acts_on_modes = [last](const SparseMatrix& matrix, Eigen::Index columns) {
    for (Eigen::Index column = 0; column < columns; ++column)
      for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
        if (entry.row() != column && entry.row() != last && entry.value() != 0.0) return true;
    return false;
  };
  if (system.contact != last || system.damping.nonZeros() > 0 || acts_on_modes(system.mass, last) ||
      acts_on_modes(system.stick_stiffness, last + 1) || acts_on_modes(system.slip_stiffness, last + 1))
    throw std::invalid_argument(
        "the system must be undamped, with modes that meet in its last coordinate alone, the contact");
}

// What a step of one length needs, by mode.
struct StepFactors {
  double length{};
  Eigen::ArrayXd inverse_diagonal;  // 1/[1 - α_m + (1 - α_f) β (ω h)²]
  Eigen::ArrayXd contact_row;       // of the matrix of the step, times inverse_diagonal
  double contact_acceleration{};    // of the contact per unit force on it
};

class ModalKernel final : public StepKernel {
 public:
  ModalKernel(const ContactSystem& system, const FrictionContact& contact, const GeneralizedAlpha& method,
              double time_step);

  void take_step(const StepPhase& phase, const Kinematics& now, double time, double end_time,
                 Kinematics& next) override;
  // Seldom, so that it need not be fast.
  void restart(const StepPhase& phase, double time, Kinematics& now) override {
    sparse_->restart(phase, time, now);
  }

 private:
  void take_stick_step(const StepFactors& step, double wall_offset, const Kinematics& now, double time,
                       double end_time, Kinematics& next) const;
  void take_slip_step(const StepFactors& step, const StepPhase& phase, const Kinematics& now, double time,
                      Kinematics& next);
  const StepFactors& factors_of(double length);
  void prepare(StepFactors& step, double length) const;

  std::unique_ptr<StepKernel> sparse_;
  Eigen::Index modes_;
  Eigen::ArrayXd stiffness_;     // ω²
  Eigen::ArrayXd coupling_;      // g
  Eigen::ArrayXd follower_row_;  // P e_theta^T Φ
  Eigen::ArrayXd load_;          // p of the modes
  double contact_mass_entry_{}, contact_stiffness_{}, contact_load_{};
  StepFactors whole_step_, partial_step_;
  Eigen::ArrayXd alpha_displacement_, residual_;
};

ModalKernel::ModalKernel(const ContactSystem& system, const FrictionContact& contact,
                         const GeneralizedAlpha& method, double time_step)
    : StepKernel(system, contact, method, time_step),
      sparse_(make_sparse_kernel(system, contact, method, time_step)),
      modes_(system.mass.rows() - 1) {
  require_modal_form(system);
  if (!system.further_loads.empty()) throw std::invalid_argument("modal coordinates take one load");
  const Eigen::Index c = system.contact;
  stiffness_ = Eigen::VectorXd(system.stick_stiffness.diagonal()).head(modes_).array();
  coupling_ = Eigen::VectorXd(system.mass.col(c)).head(modes_).array();
  follower_row_ =
      Eigen::VectorXd(SparseMatrix(system.slip_stiffness.transpose()).col(c)).head(modes_).array();
  load_ = system.load_shape.head(modes_).array();
  contact_mass_entry_ = system.mass.coeff(c, c);
  contact_stiffness_ = system.slip_stiffness.coeff(c, c);
  contact_load_ = system.load_shape[c];
  prepare(whole_step_, time_step);
}

void ModalKernel::prepare(StepFactors& step, double length) const {
  const double mass = method_.mass_factor(), stiffness = method_.stiffness_factor(length);
  step.length = length;
  step.inverse_diagonal = 1.0 / (mass + stiffness * stiffness_);
  step.contact_row = (mass * coupling_ + stiffness * follower_row_) * step.inverse_diagonal;
  step.contact_acceleration = 1.0 / (mass * contact_mass_entry_ + stiffness * contact_stiffness_ -
                                     mass * (step.contact_row * coupling_).sum());
}

const StepFactors& ModalKernel::factors_of(double length) {
  if (is_whole_step(length)) return whole_step_;
  if (partial_step_.length != length) prepare(partial_step_, length);
  return partial_step_;
}

void ModalKernel::take_step(const StepPhase& phase, const Kinematics& now, double time, double end_time,
                            Kinematics& next) {
  const StepFactors& step = factors_of(end_time - time);
  if (is_held(phase)) {
    take_stick_step(step, phase.wall_offset, now, time, end_time, next);
  } else {
    take_slip_step(step, phase, now, time, next);
  }
}

// The contact moves with the wall; each mode follows under the load and the inertia of that motion.
void ModalKernel::take_stick_step(const StepFactors& step, double wall_offset, const Kinematics& now,
                                  double time, double end_time, Kinematics& next) const {
  const double h = step.length, share = 1.0 - method_.alpha_f(), beta = method_.beta(),
               gamma = method_.gamma();
  const double load_time = method_.load_time(time, h);
  const double load = system_.load_history(load_time), wall = system_.wall.acceleration(load_time);
  const auto q = now.displacement.head(modes_).array(), v = now.velocity.head(modes_).array(),
             a = now.acceleration.head(modes_).array();
  auto new_a = next.acceleration.head(modes_).array();
  new_a = (load * load_ - wall * coupling_ - method_.alpha_m() * a -
           stiffness_ * (q + (share * h) * v + (share * h * h * (0.5 - beta)) * a)) *
          step.inverse_diagonal;
  next.displacement.head(modes_).array() = q + h * v + (h * h * (0.5 - beta)) * a + (h * h * beta) * new_a;
  next.velocity.head(modes_).array() = v + (h * (1.0 - gamma)) * a + (h * gamma) * new_a;
  next.displacement[modes_] = wall_offset + system_.wall.displacement(end_time);
  next.velocity[modes_] = system_.wall.velocity(end_time);
  next.acceleration[modes_] = system_.wall.acceleration(end_time);
}

// The modes with the contact's acceleration eliminated, then that from its own row, friction included.
void ModalKernel::take_slip_step(const StepFactors& step, const StepPhase& phase, const Kinematics& now,
                                 double time, Kinematics& next) {
  const double h = step.length, share = 1.0 - method_.alpha_f(), beta = method_.beta(),
               gamma = method_.gamma();
  const double load = system_.load_history(method_.load_time(time, h));
  const auto q = now.displacement.head(modes_).array(), v = now.velocity.head(modes_).array(),
             a = now.acceleration.head(modes_).array();
  const double qc = now.displacement[modes_], vc = now.velocity[modes_], ac = now.acceleration[modes_];
  const double alpha_ac = method_.alpha_m() * ac;
  const double alpha_qc = qc + (share * h) * vc + (share * h * h * (0.5 - beta)) * ac;

  alpha_displacement_ = q + (share * h) * v + (share * h * h * (0.5 - beta)) * a;
  residual_ = load * load_ - method_.alpha_m() * a - alpha_ac * coupling_ - stiffness_ * alpha_displacement_;
  const double contact_residual = load * contact_load_ - method_.alpha_m() * (coupling_ * a).sum() -
                                  alpha_ac * contact_mass_entry_ - contact_stiffness_ * alpha_qc -
                                  (follower_row_ * alpha_displacement_).sum() -
                                  (step.contact_row * residual_).sum();
  const double free_acceleration = contact_residual * step.contact_acceleration;
  const double friction = friction_force(phase, time, h, alpha_qc, vc + (share * h * (1.0 - gamma)) * ac,
                                         free_acceleration, step.contact_acceleration);
  const double new_ac = free_acceleration + friction * step.contact_acceleration;

  auto new_a = next.acceleration.head(modes_).array();
  new_a = (residual_ - (method_.mass_factor() * new_ac) * coupling_) * step.inverse_diagonal;
  next.acceleration[modes_] = new_ac;
  next.displacement = now.displacement + h * now.velocity + (h * h * (0.5 - beta)) * now.acceleration +
                      (h * h * beta) * next.acceleration;
  next.velocity = now.velocity + (h * (1.0 - gamma)) * now.acceleration + (h * gamma) * next.acceleration;
}

}  // namespace

std::unique_ptr<StepKernel> make_modal_kernel(const ContactSystem& system, const FrictionContact& contact,
                                              const GeneralizedAlpha& method, double time_step) {
  return std::make_unique<ModalKernel>(system, contact, method, time_step);
}

}  // namespace stickslip::solver
