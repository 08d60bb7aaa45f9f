// SPDX-License-Identifier: MIT
/// Steps by factorised sparse matrices.

#include <Eigen/SparseLU>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "constrained.hpp"
#include "step_kernel.hpp"

namespace stickslip::solver {

namespace {

using SparseLu = Eigen::SparseLU<SparseMatrix, Eigen::NaturalOrdering<int>>;

// A step of one length: its matrices, factorised when first used.
struct StepMatrices {
  double length{};
  std::unique_ptr<SparseCholesky> stick;
  std::unique_ptr<SparseLu> slip;
  Eigen::VectorXd mobility;  // acceleration of every degree of freedom per unit f_d in a slip step
};

// What a failed factorisation leaves behind has no pivots, and solving with it writes anywhere.
template <typename Factorization>
void require_factorised(const Factorization& factorization, double step_length) {
  if (factorization.info() == Eigen::Success) return;
  std::ostringstream text;
  text << "the matrix of a step of " << step_length << " s is singular or not finite";
  throw std::runtime_error(text.str());
}

class SparseKernel final : public StepKernel {
 public:
  SparseKernel(const ContactSystem& system, const FrictionContact& contact, const GeneralizedAlpha& method,
               double time_step);

  void take_step(const StepPhase& phase, const Kinematics& now, double time, double end_time,
                 Kinematics& next) override;
  void restart(const StepPhase& phase, double time, Kinematics& now) override;

 private:
  void take_stick_step(StepMatrices& step, double wall_offset, double time, double end_time,
                       Kinematics& state);
  void take_slip_step(StepMatrices& step, const StepPhase& phase, double time, Kinematics& state);
  StepMatrices& matrices_of(double length);
  const SparseCholesky& stick_matrix(StepMatrices& step) const;
  const SparseLu& slip_matrix(StepMatrices& step) const;
  [[nodiscard]] SparseMatrix step_matrix(double length, const SparseMatrix& stiffness) const;
  void add_static_shape(Kinematics& state, double wall_offset, double t, double factor) const;
  void subtract_static_shape_inertia(double t);
  void subtract_internal_forces(const SparseMatrix& stiffness);

  Eigen::VectorXd static_shape_;                     // σ
  Eigen::VectorXd static_inertia_, static_damping_;  // M σ, C σ
  StepMatrices whole_step_, partial_step_;
  Kinematics alpha_level_;
  Eigen::VectorXd residual_, new_acceleration_;
};

SparseKernel::SparseKernel(const ContactSystem& system, const FrictionContact& contact,
                           const GeneralizedAlpha& method, double time_step)
    : StepKernel(system, contact, method, time_step) {
  const Eigen::Index c = system.contact;
  const SparseCholesky constrained_stiffness(constrained(system.stick_stiffness, c));
  if (!is_positive_definite(constrained_stiffness))
    throw data::InputError("the stiffness with the contact held is not positive definite");
  static_shape_ = -Eigen::VectorXd(system.stick_stiffness.col(c));
  static_shape_[c] = 1.0;
  static_shape_ = constrained_stiffness.solve(static_shape_).eval();
  static_inertia_ = system.mass * static_shape_;
  static_damping_ = system.damping * static_shape_;
  whole_step_.length = time_step;
}

StepMatrices& SparseKernel::matrices_of(double length) {
  if (is_whole_step(length)) return whole_step_;
  if (partial_step_.length != length) {
    partial_step_.length = length;
    partial_step_.stick.reset();
    partial_step_.slip.reset();
  }
  return partial_step_;
}

const SparseCholesky& SparseKernel::stick_matrix(StepMatrices& step) const {
  if (!step.stick) {
    auto stick = std::make_unique<SparseCholesky>(
        constrained(step_matrix(step.length, system_.stick_stiffness), system_.contact));
    require_factorised(*stick, step.length);
    step.stick = std::move(stick);
  }
  return *step.stick;
}

const SparseLu& SparseKernel::slip_matrix(StepMatrices& step) const {
  if (!step.slip) {
    auto slip = std::make_unique<SparseLu>();
    // Nearly symmetric positive definite: pivots on the diagonal, in any system of units.
    slip->setPivotThreshold(0.0);
    slip->compute(step_matrix(step.length, system_.slip_stiffness));
    require_factorised(*slip, step.length);
    step.mobility = slip->solve(Eigen::VectorXd(Eigen::VectorXd::Unit(system_.mass.rows(), system_.contact)));
    step.slip = std::move(slip);
  }
  return *step.slip;
}

// What multiplies a_(n+1).
SparseMatrix SparseKernel::step_matrix(double length, const SparseMatrix& stiffness) const {
  return method_.mass_factor() * system_.mass + method_.damping_factor(length) * system_.damping +
         method_.stiffness_factor(length) * stiffness;
}

void SparseKernel::take_step(const StepPhase& phase, const Kinematics& now, double time, double end_time,
                             Kinematics& next) {
  next = now;
  StepMatrices& step = matrices_of(end_time - time);
  if (is_held(phase)) {
    take_stick_step(step, phase.wall_offset, time, end_time, next);
  } else {
    take_slip_step(step, phase, time, next);
  }
}

void SparseKernel::take_stick_step(StepMatrices& step, double wall_offset, double time, double end_time,
                                   Kinematics& state) {
  const double h = step.length;
  const double load_time = method_.load_time(time, h);
  add_static_shape(state, wall_offset, time, -1.0);
  for (auto* z : {&state.displacement, &state.velocity, &state.acceleration}) (*z)[system_.contact] = 0.0;
  method_.predict(state, h, alpha_level_);

  system_.set_load(load_time, residual_);
  subtract_static_shape_inertia(load_time);
  subtract_internal_forces(system_.stick_stiffness);
  residual_[system_.contact] = 0.0;
  new_acceleration_ = stick_matrix(step).solve(residual_);
  method_.update(state, h, new_acceleration_);
  add_static_shape(state, wall_offset, end_time, 1.0);
}

void SparseKernel::take_slip_step(StepMatrices& step, const StepPhase& phase, double time,
                                  Kinematics& state) {
  const double h = step.length;
  const Eigen::Index c = system_.contact;
  const double load_time = method_.load_time(time, h);
  method_.predict(state, h, alpha_level_);

  system_.set_load(load_time, residual_);
  subtract_internal_forces(system_.slip_stiffness);
  new_acceleration_ = slip_matrix(step).solve(residual_);

  new_acceleration_ += friction_force(phase, time, h, alpha_level_.displacement[c], alpha_level_.velocity[c],
                                      new_acceleration_[c], step.mobility[c]) *
                       step.mobility;
  method_.update(state, h, new_acceleration_);
}

// a = (1 - α_m) A⁻¹ (p s - C v - K q + contact force), A the matrix of a whole step.
void SparseKernel::restart(const StepPhase& phase, double time, Kinematics& now) {
  alpha_level_ = now;
  alpha_level_.acceleration.setZero();
  system_.set_load(time, residual_);
  if (!is_held(phase)) {
    const Eigen::Index c = system_.contact;
    subtract_internal_forces(system_.slip_stiffness);
    const double sliding = now.velocity[c] - system_.wall.velocity(time);
    const double position = now.displacement[c] - system_.wall.displacement(time);
    residual_[c] += contact_.yields() ? contact_.yielding_force(phase.wall_offset, position, sliding)
                                      : contact_.force(phase.direction, sliding);
    now.acceleration = method_.mass_factor() * slip_matrix(whole_step_).solve(residual_);
    return;
  }
  add_static_shape(alpha_level_, phase.wall_offset, time, -1.0);
  alpha_level_.acceleration.setZero();
  subtract_static_shape_inertia(time);
  subtract_internal_forces(system_.stick_stiffness);
  residual_[system_.contact] = 0.0;
  now.acceleration = method_.mass_factor() * stick_matrix(whole_step_).solve(residual_) +
                     system_.wall.acceleration(time) * static_shape_;
}

// Adds the static shape of the contact's exact motion at time t, times a factor.
void SparseKernel::add_static_shape(Kinematics& state, double wall_offset, double t, double factor) const {
  state.displacement += (factor * (wall_offset + system_.wall.displacement(t))) * static_shape_;
  state.velocity += (factor * system_.wall.velocity(t)) * static_shape_;
  state.acceleration += (factor * system_.wall.acceleration(t)) * static_shape_;
}

// residual - M σ w_tt - C σ w_t.
void SparseKernel::subtract_static_shape_inertia(double t) {
  residual_.noalias() -= system_.wall.acceleration(t) * static_inertia_;
  residual_.noalias() -= system_.wall.velocity(t) * static_damping_;
}

// residual - M a - C v - K q at the α level.
void SparseKernel::subtract_internal_forces(const SparseMatrix& stiffness) {
  residual_.noalias() -= system_.mass * alpha_level_.acceleration;
  residual_.noalias() -= system_.damping * alpha_level_.velocity;
  residual_.noalias() -= stiffness * alpha_level_.displacement;
}

}  // namespace

double StepKernel::friction_force(const StepPhase& phase, double time, double length, double displacement,
                                  double velocity, double free_acceleration, double response) {
  const double velocity_factor = method_.damping_factor(length), mobility = velocity_factor * response;
  contact_.require_unique_force(mobility, time, time_step_);
  const double free_velocity =
      velocity + velocity_factor * free_acceleration - system_.wall.velocity(method_.load_time(time, length));
  if (!contact_.yields()) return contact_.alpha_level_force(phase.direction, free_velocity, mobility);
  // Weighted as displacements are and not taken at t_star: a spring to the wall then gets the weighted position of the
  // contact.
  const double wall = (1.0 - method_.alpha_f()) * system_.wall.displacement(time + length) +
                      method_.alpha_f() * system_.wall.displacement(time);
  const double displacement_factor = method_.stiffness_factor(length);
  const double free_position = displacement + displacement_factor * free_acceleration - wall;
  yielding_force_ = contact_.solve_yielding_force(
      phase.wall_offset, {free_velocity, free_position, mobility, displacement_factor * response});
  return yielding_force_;
}

std::unique_ptr<StepKernel> make_sparse_kernel(const ContactSystem& system, const FrictionContact& contact,
                                               const GeneralizedAlpha& method, double time_step) {
  return std::make_unique<SparseKernel>(system, contact, method, time_step);
}

}  // namespace stickslip::solver
