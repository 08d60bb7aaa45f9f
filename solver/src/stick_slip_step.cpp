/// One step of the StickSlipIntegrator in a phase: matrices, linear algebra and the friction law.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "constrained.hpp"
#include "step_operator.hpp"

namespace stickslip::solver {

namespace {

// What a failed factorisation leaves behind has no pivots, and solving with it writes anywhere.
template <typename Factorization>
void require_factorised(const Factorization& factorization, double step_length) {
  if (factorization.info() == Eigen::Success) return;
  std::ostringstream text;
  text << "the matrix of a step of " << step_length << " s is singular or not finite";
  throw std::runtime_error(text.str());
}

}  // namespace

StickSlipIntegrator::StepOperator& StickSlipIntegrator::step_operator(double length) {
  // The end of a step is n h and not a sum, so that a whole step's length is h only up to round-off.
  if (std::abs(length - full_step_->length) <= 1e-9 * full_step_->length) return *full_step_;
  if (partial_step_->length != length) {
    partial_step_->length = length;
    partial_step_->stick.reset();
    partial_step_->slip.reset();
  }
  return *partial_step_;
}

const StickSlipIntegrator::Cholesky& StickSlipIntegrator::stick_matrix(StepOperator& op) const {
  if (!op.stick) {
    auto stick =
        std::make_unique<Cholesky>(constrained(step_matrix(op, system_.stick_stiffness), system_.contact));
    require_factorised(*stick, op.length);
    op.stick = std::move(stick);
  }
  return *op.stick;
}

const StickSlipIntegrator::Lu& StickSlipIntegrator::slip_matrix(StepOperator& op) const {
  if (!op.slip) {
    auto slip = std::make_unique<Lu>();
    // Nearly symmetric positive definite: pivots on the diagonal, in any system of units.
    slip->setPivotThreshold(0.0);
    slip->compute(step_matrix(op, system_.slip_stiffness));
    require_factorised(*slip, op.length);
    op.mobility = slip->solve(Eigen::VectorXd(Eigen::VectorXd::Unit(system_.mass.rows(), system_.contact)));
    op.slip = std::move(slip);
  }
  return *op.slip;
}

// What multiplies a_(n+1).
SparseMatrix StickSlipIntegrator::step_matrix(const StepOperator& op, const SparseMatrix& stiffness) const {
  return method_.mass_factor() * system_.mass + method_.damping_factor(op.length) * system_.damping +
         method_.stiffness_factor(op.length) * stiffness;
}

const Kinematics& StickSlipIntegrator::trial(double end_time) {
  trial_ = now_;
  StepOperator& op = step_operator(end_time - time_);
  if (state_ == ContactState::stick) {
    take_stick_step(op, end_time, trial_);
  } else {
    take_slip_step(op, trial_);
  }
  return trial_;
}

void StickSlipIntegrator::take_stick_step(StepOperator& op, double end_time, Kinematics& state) {
  const double h = op.length;
  const double load_time = method_.load_time(time_, h);
  add_static_shape(state, time_, -1.0);
  for (auto* z : {&state.displacement, &state.velocity, &state.acceleration}) (*z)[system_.contact] = 0.0;
  method_.predict(state, h, alpha_level_);

  residual_.noalias() = system_.load_history(load_time) * system_.load_shape;
  subtract_static_shape_inertia(load_time);
  subtract_internal_forces(system_.stick_stiffness);
  residual_[system_.contact] = 0.0;
  new_acceleration_ = stick_matrix(op).solve(residual_);
  method_.update(state, h, new_acceleration_);
  add_static_shape(state, end_time, 1.0);
}

// Adds the static shape of the contact's exact motion at time t, times a factor.
void StickSlipIntegrator::add_static_shape(Kinematics& state, double t, double factor) const {
  state.displacement += (factor * (wall_offset_ + system_.wall.displacement(t))) * static_shape_;
  state.velocity += (factor * system_.wall.velocity(t)) * static_shape_;
  state.acceleration += (factor * system_.wall.acceleration(t)) * static_shape_;
}

// residual - M sigma w_tt - C sigma w_t.
void StickSlipIntegrator::subtract_static_shape_inertia(double t) {
  residual_.noalias() -= system_.wall.acceleration(t) * static_inertia_;
  residual_.noalias() -= system_.wall.velocity(t) * static_damping_;
}

// residual - M a - C v - K q at the alpha level.
void StickSlipIntegrator::subtract_internal_forces(const SparseMatrix& stiffness) {
  residual_.noalias() -= system_.mass * alpha_level_.acceleration;
  residual_.noalias() -= system_.damping * alpha_level_.velocity;
  residual_.noalias() -= stiffness * alpha_level_.displacement;
}

void StickSlipIntegrator::take_slip_step(StepOperator& op, Kinematics& state) {
  const double h = op.length;
  const Eigen::Index c = system_.contact;
  const double load_time = method_.load_time(time_, h);
  method_.predict(state, h, alpha_level_);

  residual_.noalias() = system_.load_history(load_time) * system_.load_shape;
  subtract_internal_forces(system_.slip_stiffness);
  new_acceleration_ = slip_matrix(op).solve(residual_);

  const double velocity_factor = method_.damping_factor(h);
  const double free_velocity =
      alpha_level_.velocity[c] + velocity_factor * new_acceleration_[c] - system_.wall.velocity(load_time);
  new_acceleration_ += alpha_level_friction(free_velocity, velocity_factor * op.mobility[c]) * op.mobility;
  method_.update(state, h, new_acceleration_);
}

// f_d = -d mu(v) N, v = free_velocity + mobility f_d the sliding velocity at the alpha level. With w = d v
// this is w + mobility N mu(w) = d free_velocity; mu is held at mu_s for w < 0, where a trial step has
// overshot the end of the phase. The left side is convex and rises as long as mobility N (mu_s - mu_m) alpha
// < 1, so that Newton's method from above converges without leaving the right side of the root.
double StickSlipIntegrator::alpha_level_friction(double free_velocity, double mobility) const {
  const data::FrictionLaw& law = system_.friction;
  const double forward = direction_ * free_velocity;
  const double strength = mobility * system_.normal_force;
  const double weakening = (law.static_coefficient() - law.kinetic_coefficient()) * law.decay();
  if (!(strength * weakening < 1.0)) {
    std::ostringstream text;
    text << "time_step = " << settings_.time_step << " s: at t = " << time_
         << " s the friction law falls faster than a step can follow; the step must be shorter than about "
         << settings_.time_step / (strength * weakening) << " s";
    throw std::runtime_error(text.str());
  }
  double w = forward - strength * law.kinetic_coefficient();
  if (forward <= strength * law.static_coefficient()) return -direction_ * static_limit_;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double residual = w + strength * friction_coefficient(law, w) - forward;
    const double slope = 1.0 - strength * weakening * std::exp(-law.decay() * w);
    const double next = std::max(w - residual / slope, 0.0);
    if (std::abs(next - w) <= 1e-15 * std::max(w, forward)) break;
    w = next;
  }
  return -direction_ * friction_coefficient(law, w) * system_.normal_force;
}

// a = (1 - alpha_m) A^-1 (p s - C v - K q + contact force), A the matrix of a whole step.
void StickSlipIntegrator::restart_acceleration() {
  const bool stuck = state_ == ContactState::stick;
  alpha_level_ = now_;
  alpha_level_.acceleration.setZero();
  residual_.noalias() = system_.load_history(time_) * system_.load_shape;
  if (!stuck) {
    subtract_internal_forces(system_.slip_stiffness);
    residual_[system_.contact] += friction_force();
    now_.acceleration = method_.mass_factor() * slip_matrix(*full_step_).solve(residual_);
    return;
  }
  add_static_shape(alpha_level_, time_, -1.0);
  alpha_level_.acceleration.setZero();
  subtract_static_shape_inertia(time_);
  subtract_internal_forces(system_.stick_stiffness);
  residual_[system_.contact] = 0.0;
  now_.acceleration = method_.mass_factor() * stick_matrix(*full_step_).solve(residual_) +
                      system_.wall.acceleration(time_) * static_shape_;
}

}  // namespace stickslip::solver
