// SPDX-License-Identifier: MIT
/// Steps in the coordinates of a HeldTipBasis: in stick the modes do not know each other, in slip they meet in
/// the contact alone. A step takes a few passes over arrays and no factorisation, whatever its length. Where damping couples the modes,
/// it takes one product with a full matrix besides, and one factorisation for a step that ends at an event.

#include <Eigen/Cholesky>
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
  if (system.contact != last || acts_on_modes(system.mass, last) ||
      acts_on_modes(system.stick_stiffness, last + 1) || acts_on_modes(system.slip_stiffness, last + 1))
    throw std::invalid_argument(
        "but for its damping the system must have modes that meet in its last coordinate alone, the contact");
}

// What a step of one length needs, by mode. With A the matrix of the step, mass M + damping C + stiffness K by the factors of the method:
struct StepFactors {
  double length{};
  Eigen::ArrayXd inverse_diagonal;      // of A of the modes; not where damping couples them:
  Eigen::MatrixXd inverse;              // A⁻¹ of the modes, of a whole step
  Eigen::LLT<Eigen::MatrixXd> factors;  // or its factors, of another
  Eigen::ArrayXd velocity_factors;      // (mass + stiffness ω²)/damping
  Eigen::ArrayXd contact_row;           // of A
  Eigen::ArrayXd response;              // A⁻¹ of its column for the contact
  double contact_acceleration{};        // of the contact per unit force on it
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
                       double end_time, Kinematics& next);
  void take_slip_step(const StepFactors& step, const StepPhase& phase, const Kinematics& now, double time,
                      Kinematics& next);
  void set_residual(const StepFactors& step, const Kinematics& now);
  void solve(const StepFactors& step, Eigen::ArrayXd& accelerations);
  const StepFactors& factors_of(double length);
  void prepare(StepFactors& step, double length) const;

  std::unique_ptr<StepKernel> sparse_;
  Eigen::Index modes_;
  Eigen::ArrayXd stiffness_;     // ω²
  Eigen::ArrayXd coupling_;      // g
  Eigen::ArrayXd follower_row_;  // P e_theta^T Φ
  Eigen::ArrayXd load_;          // p of the modes
  double contact_mass_entry_{}, contact_stiffness_{}, contact_load_{};
  bool is_damped_{}, is_coupled_{};  // by damping; its parts
  Eigen::MatrixXd damping_;          // of the modes, if coupled
  Eigen::ArrayXd damping_diagonal_, contact_damping_row_;
  double contact_damping_{};
  StepFactors whole_step_, partial_step_;
  Eigen::ArrayXd alpha_displacement_, alpha_velocity_, residual_, accelerations_;
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
  is_damped_ = system.damping.nonZeros() > 0;
  if (is_damped_) {
    damping_ = Eigen::MatrixXd(system.damping).topLeftCorner(modes_, modes_);
    damping_diagonal_ = damping_.diagonal().array();
    is_coupled_ = !damping_.isDiagonal(0.0);
    contact_damping_row_ = Eigen::VectorXd(system.damping.col(c)).head(modes_).array();
    contact_damping_ = system.damping.coeff(c, c);
  }
  prepare(whole_step_, time_step);
  if (is_coupled_) {
    whole_step_.inverse = whole_step_.factors.solve(Eigen::MatrixXd::Identity(modes_, modes_));
  }
}

void ModalKernel::prepare(StepFactors& step, double length) const {
  const double mass = method_.mass_factor(), stiffness = method_.stiffness_factor(length),
               damping = method_.damping_factor(length);
  const Eigen::ArrayXd undamped = mass + stiffness * stiffness_;
  Eigen::ArrayXd column = mass * coupling_;
  step.length = length;
  double corner = mass * contact_mass_entry_ + stiffness * contact_stiffness_;
  if (is_damped_) {
    column += damping * contact_damping_row_;
    corner += damping * contact_damping_;
  }
  step.contact_row = column + stiffness * follower_row_;
  if (is_coupled_) {
    Eigen::MatrixXd matrix = damping * damping_;
    matrix.diagonal().array() += undamped;
    step.factors.compute(matrix);
    step.velocity_factors = undamped / damping;
    step.response = step.factors.solve(column.matrix()).array();
  } else {
    step.inverse_diagonal =
        1.0 / (is_damped_ ? Eigen::ArrayXd(undamped + damping * damping_diagonal_) : undamped);
    step.response = column * step.inverse_diagonal;
  }
  step.contact_acceleration = 1.0 / (corner - (step.contact_row * step.response).sum());
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

// The α level of the modes without the new acceleration, and minus their inertia, stiffness and, but where it couples them, damping there.
void ModalKernel::set_residual(const StepFactors& step, const Kinematics& now) {
  const double h = step.length, share = 1.0 - method_.alpha_f();
  const auto q = now.displacement.head(modes_).array(), v = now.velocity.head(modes_).array(),
             a = now.acceleration.head(modes_).array();
  alpha_displacement_ = q + (share * h) * v + (share * h * h * (0.5 - method_.beta())) * a;
  residual_ = -method_.alpha_m() * a - stiffness_ * alpha_displacement_;
  if (!is_damped_) return;
  alpha_velocity_ = v + (share * h * (1.0 - method_.gamma())) * a;
  if (!is_coupled_) residual_ -= damping_diagonal_ * alpha_velocity_;
}

// A⁻¹ of the residual. With C v still missing in it,
//
//     A⁻¹ (r - C v) = A⁻¹ (r + (A - damping C) v/damping) - v/damping,
//
// so that one product is enough.
void ModalKernel::solve(const StepFactors& step, Eigen::ArrayXd& accelerations) {
  if (!is_coupled_) {
    accelerations = residual_ * step.inverse_diagonal;
    return;
  }
  residual_ += step.velocity_factors * alpha_velocity_;
  accelerations.resize(modes_);
  if (&step == &whole_step_)
    accelerations.matrix().noalias() = step.inverse.selfadjointView<Eigen::Lower>() * residual_.matrix();
  else
    accelerations.matrix() = step.factors.solve(residual_.matrix());
  accelerations -= alpha_velocity_ / method_.damping_factor(step.length);
}

// The contact moves with the wall; each mode follows under the load, and the inertia and the damping of that motion.
void ModalKernel::take_stick_step(const StepFactors& step, double wall_offset, const Kinematics& now,
                                  double time, double end_time, Kinematics& next) {
  const double h = step.length, beta = method_.beta(), gamma = method_.gamma();
  const double load_time = method_.load_time(time, h);
  set_residual(step, now);
  residual_ += system_.load_history(load_time) * load_ - system_.wall.acceleration(load_time) * coupling_;
  if (is_damped_) residual_ -= system_.wall.velocity(load_time) * contact_damping_row_;
  solve(step, accelerations_);
  const auto q = now.displacement.head(modes_).array(), v = now.velocity.head(modes_).array(),
             a = now.acceleration.head(modes_).array();
  next.displacement.head(modes_).array() =
      q + h * v + (h * h * (0.5 - beta)) * a + (h * h * beta) * accelerations_;
  next.velocity.head(modes_).array() = v + (h * (1.0 - gamma)) * a + (h * gamma) * accelerations_;
  next.acceleration.head(modes_).array() = accelerations_;
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
  const auto a = now.acceleration.head(modes_).array();
  const double qc = now.displacement[modes_], vc = now.velocity[modes_], ac = now.acceleration[modes_];
  const double alpha_ac = method_.alpha_m() * ac;
  const double alpha_qc = qc + (share * h) * vc + (share * h * h * (0.5 - beta)) * ac;
  const double alpha_vc = vc + (share * h * (1.0 - gamma)) * ac;

  set_residual(step, now);
  residual_ += load * load_ - alpha_ac * coupling_;
  double contact_residual = load * contact_load_ - method_.alpha_m() * (coupling_ * a).sum() -
                            alpha_ac * contact_mass_entry_ - contact_stiffness_ * alpha_qc -
                            (follower_row_ * alpha_displacement_).sum();
  if (is_damped_) {
    residual_ -= alpha_vc * contact_damping_row_;
    contact_residual -= (contact_damping_row_ * alpha_velocity_).sum() + contact_damping_ * alpha_vc;
  }
  solve(step, accelerations_);
  const double free_acceleration =
      (contact_residual - (step.contact_row * accelerations_).sum()) * step.contact_acceleration;
  const double friction =
      friction_force(phase, time, h, alpha_qc, alpha_vc, free_acceleration, step.contact_acceleration);
  const double new_ac = free_acceleration + friction * step.contact_acceleration;

  next.acceleration.head(modes_).array() = accelerations_ - new_ac * step.response;
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
