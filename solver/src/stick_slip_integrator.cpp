#include "stickslip/solver/stick_slip_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "bracketed_root.hpp"

namespace stickslip::solver {

namespace {

constexpr int max_events_per_step = 1000;
// An event is located to this part of the step: far below the error of the method.
constexpr double location_tolerance_per_step = 1e-11;

double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

// The symmetric matrix with one row and column replaced by those of the identity.
SparseMatrix constrained(const SparseMatrix& matrix, Eigen::Index fixed) {
  SparseMatrix result = matrix;
  result.prune(
      [fixed](Eigen::Index row, Eigen::Index column, double) { return row != fixed && column != fixed; });
  result.coeffRef(fixed, fixed) = 1.0;
  result.makeCompressed();
  return result;
}

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

template <typename Cholesky>
bool is_positive_definite(const Cholesky& factorization) {
  return factorization.info() == Eigen::Success && factorization.vectorD().minCoeff() > 0.0;
}

void require_size(Eigen::Index size, Eigen::Index expected, const char* name) {
  require(size == expected, std::string(name) + " has size " + std::to_string(size) +
                                ": must equal the degrees of freedom, " + std::to_string(expected));
}

void require_consistent(const ContactSystem& system) {
  const Eigen::Index n = system.mass.rows();
  for (const auto& [matrix, name] : {std::pair{&system.mass, "mass"},
                                     {&system.damping, "damping"},
                                     {&system.stick_stiffness, "stick_stiffness"},
                                     {&system.slip_stiffness, "slip_stiffness"}}) {
    require_size(matrix->rows(), n, name);
    require_size(matrix->cols(), n, name);
  }
  require_size(system.load_shape.size(), n, "load_shape");
  require(system.contact >= 0 && system.contact < n, "contact = " + std::to_string(system.contact) +
                                                         ": must be a degree of freedom, 0 ... " +
                                                         std::to_string(n - 1));
  require(std::isfinite(system.normal_force) && system.normal_force >= 0.0,
          "normal_force = " + std::to_string(system.normal_force) + " N: must be finite and not negative");
}

}  // namespace

double friction_coefficient(const data::FrictionLaw& law, double sliding_velocity) {
  return law.kinetic_coefficient() + (law.static_coefficient() - law.kinetic_coefficient()) *
                                         std::exp(-law.decay() * std::abs(sliding_velocity));
}

// A step of one length: its matrices, factorised when first used.
struct StickSlipIntegrator::StepOperator {
  double length{};
  std::unique_ptr<Cholesky> stick;
  std::unique_ptr<Lu> slip;
  Eigen::VectorXd mobility;  // acceleration of every degree of freedom per unit f_d in a slip step
};

StickSlipIntegrator::StickSlipIntegrator(ContactSystem system, const IntegratorSettings& settings)
    : system_(std::move(system)), settings_(settings), method_(settings.spectral_radius) {
  require(std::isfinite(settings.time_step) && settings.time_step > 0.0,
          "time_step = " + std::to_string(settings.time_step) + " s: must be positive");
  require(
      std::isfinite(settings.velocity_threshold) && settings.velocity_threshold >= 0.0,
      "velocity_threshold = " + std::to_string(settings.velocity_threshold) + " m/s: must not be negative");
  require_consistent(system_);
  static_limit_ = system_.friction.static_coefficient() * system_.normal_force;

  const Eigen::Index c = system_.contact;
  mass_.compute(system_.mass);
  constrained_mass_.compute(constrained(system_.mass, c));
  require(is_positive_definite(mass_) && is_positive_definite(constrained_mass_),
          "mass: must be positive definite");

  // lambda = M_ff^-1 M_fc, zero at c: what the contact's acceleration does to the others.
  Eigen::VectorXd lambda = Eigen::VectorXd(system_.mass.col(c));
  lambda[c] = 0.0;
  lambda = constrained_mass_.solve(lambda).eval();
  const auto contact_row = [c](const SparseMatrix& matrix) {
    return Eigen::VectorXd(matrix.transpose().col(c));
  };
  holding_q_ = contact_row(system_.slip_stiffness) - system_.stick_stiffness.transpose() * lambda;
  holding_v_ = contact_row(system_.damping) - system_.damping.transpose() * lambda;
  holding_load_ = lambda.dot(system_.load_shape) - system_.load_shape[c];
  contact_mass_ = system_.mass.coeff(c, c) - lambda.dot(Eigen::VectorXd(system_.mass.col(c)));
  impulse_response_ = -lambda;
  impulse_response_[c] = 1.0;

  const Cholesky constrained_stiffness(constrained(system_.stick_stiffness, c));
  require(is_positive_definite(constrained_stiffness),
          "stick_stiffness: must be positive definite with the contact held");
  static_shape_ = -Eigen::VectorXd(system_.stick_stiffness.col(c));
  static_shape_[c] = 1.0;
  static_shape_ = constrained_stiffness.solve(static_shape_).eval();
  static_inertia_ = system_.mass * static_shape_;
  static_damping_ = system_.damping * static_shape_;

  full_step_ = std::make_unique<StepOperator>();
  partial_step_ = std::make_unique<StepOperator>();
  full_step_->length = settings_.time_step;
}

StickSlipIntegrator::~StickSlipIntegrator() = default;

void StickSlipIntegrator::start(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) {
  const Eigen::Index n = system_.mass.rows();
  require_size(displacement.size(), n, "displacement");
  require_size(velocity.size(), n, "velocity");
  now_ = {displacement, velocity, Eigen::VectorXd::Zero(n)};
  alpha_level_ = trial_ = now_;
  time_ = 0.0;
  steps_ = 0;
  events_.clear();
  events_in_step_ = 0;
}

void StickSlipIntegrator::start_stuck(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) {
  start(displacement, velocity);
  now_.velocity[system_.contact] = system_.wall.velocity(0.0);
  stick_here();
  if (excess_force(now_, time_) > 0.0) leave_stick();
}

void StickSlipIntegrator::start_slipping(const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& velocity) {
  start(displacement, velocity);
  const double sliding = sliding_velocity(now_, time_);
  state_ = ContactState::slip;
  direction_ = sliding != 0.0 ? sign(sliding) : -sign(holding_force(now_, time_));
  restart_acceleration();
}

void StickSlipIntegrator::step() {
  const double end_time = static_cast<double>(steps_ + 1) * settings_.time_step;
  events_in_step_ = 0;
  while (time_ < end_time) {
    if (state_ == ContactState::stick) {
      advance_stick(end_time);
    } else {
      advance_slip(end_time);
    }
  }
  ++steps_;
  require_finite();
}

void StickSlipIntegrator::advance_stick(double end_time) {
  const double excess = excess_force(trial(end_time), end_time);
  if (excess <= 0.0) return accept_trial(end_time);

  const double excess_now = excess_force(now_, time_);
  if (excess_now < 0.0) {
    const auto excess_at = [this](double t) { return excess_force(trial(t), t); };
    const double onset = bracketed_root(excess_at, time_, excess_now, end_time, excess, location_tolerance());
    trial(onset);
    accept_trial(onset);
  }
  leave_stick();
}

void StickSlipIntegrator::advance_slip(double end_time) {
  // The sliding velocity against the direction of the phase: negative while the phase lasts.
  const auto backward_velocity = [this](double t) { return -direction_ * sliding_velocity(trial(t), t); };
  double high = end_time, at_high = backward_velocity(end_time);
  if (at_high < 0.0) {
    accept_trial(end_time);
    const bool slow = -at_high <= settings_.velocity_threshold;
    if (slow && std::abs(holding_force(now_, time_)) <= static_limit_) settle_at_rest();
    return;
  }
  // A phase that has just begun starts from zero: halve the step until the contact moves forward within it.
  double low = time_, at_low = -direction_ * sliding_velocity(now_, time_);
  for (int halving = 0; at_low >= 0.0 && halving < 12; ++halving) {
    const double middle = low + 0.5 * (high - low);
    const double at_middle = backward_velocity(middle);
    (at_middle < 0.0 ? low : high) = middle;
    (at_middle < 0.0 ? at_low : at_high) = at_middle;
  }
  const double rest =
      at_low < 0.0 ? bracketed_root(backward_velocity, low, at_low, high, at_high, location_tolerance())
                   : end_time;
  trial(rest);
  accept_trial(rest);
  settle_at_rest();
}

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
  if (!op.stick)
    op.stick =
        std::make_unique<Cholesky>(constrained(step_matrix(op, system_.stick_stiffness), system_.contact));
  return *op.stick;
}

const StickSlipIntegrator::Lu& StickSlipIntegrator::slip_matrix(StepOperator& op) const {
  if (!op.slip) {
    op.slip = std::make_unique<Lu>();
    // Nearly symmetric positive definite: pivots on the diagonal, in any system of units.
    op.slip->setPivotThreshold(0.0);
    op.slip->compute(step_matrix(op, system_.slip_stiffness));
    op.mobility =
        op.slip->solve(Eigen::VectorXd(Eigen::VectorXd::Unit(system_.mass.rows(), system_.contact)));
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

// Not finer than the spacing of floating-point numbers around the time itself.
double StickSlipIntegrator::location_tolerance() const {
  return std::max(location_tolerance_per_step * settings_.time_step,
                  2.0 * std::numeric_limits<double>::epsilon() * time_);
}

void StickSlipIntegrator::accept_trial(double new_time) {
  std::swap(now_, trial_);
  time_ = new_time;
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

double StickSlipIntegrator::sliding_velocity(const Kinematics& state, double t) const {
  return state.velocity[system_.contact] - system_.wall.velocity(t);
}

double StickSlipIntegrator::holding_force(const Kinematics& state, double t) const {
  return holding_q_.dot(state.displacement) + holding_v_.dot(state.velocity) +
         holding_load_ * system_.load_history(t) + contact_mass_ * system_.wall.acceleration(t);
}

double StickSlipIntegrator::excess_force(const Kinematics& state, double t) const {
  return settings_.glued ? -1.0 : std::abs(holding_force(state, t)) - static_limit_;
}

double StickSlipIntegrator::sliding_velocity() const {
  return state_ == ContactState::stick ? 0.0 : sliding_velocity(now_, time_);
}

double StickSlipIntegrator::holding_force() const { return holding_force(now_, time_); }

double StickSlipIntegrator::friction_force() const {
  if (state_ == ContactState::stick) return holding_force(now_, time_);
  return -direction_ * friction_coefficient(system_.friction, sliding_velocity()) * system_.normal_force;
}

Eigen::VectorXd StickSlipIntegrator::consistent_acceleration() const {
  const Eigen::Index c = system_.contact;
  const bool stuck = state_ == ContactState::stick;
  const SparseMatrix& stiffness = stuck ? system_.stick_stiffness : system_.slip_stiffness;
  Eigen::VectorXd force = system_.load_history(time_) * system_.load_shape - system_.damping * now_.velocity -
                          stiffness * now_.displacement;
  if (!stuck) {
    force[c] += friction_force();
    return mass_.solve(force);
  }
  const double wall_acceleration = system_.wall.acceleration(time_);
  force -= wall_acceleration * Eigen::VectorXd(system_.mass.col(c));
  force[c] = wall_acceleration;
  return constrained_mass_.solve(force);
}

void StickSlipIntegrator::leave_stick() {
  state_ = ContactState::slip;
  direction_ = -sign(holding_force(now_, time_));
  record(ContactEvent::Kind::onset);
  restart_acceleration();
}

// The contact is at rest on the wall, up to what the location left: stick if it can be held, else slip.
void StickSlipIntegrator::settle_at_rest() {
  const double force = holding_force(now_, time_);
  if (std::abs(force) <= static_limit_) {
    record(ContactEvent::Kind::capture);
    return stick_here();
  }
  const double new_direction = -sign(force);
  record(new_direction == direction_ ? ContactEvent::Kind::graze : ContactEvent::Kind::reversal);
  direction_ = new_direction;
  restart_acceleration();
}

// The velocity of the contact becomes that of the wall, by an impulse at the contact alone.
void StickSlipIntegrator::stick_here() {
  const Eigen::Index c = system_.contact;
  now_.velocity += (system_.wall.velocity(time_) - now_.velocity[c]) * impulse_response_;
  wall_offset_ = now_.displacement[c] - system_.wall.displacement(time_);
  state_ = ContactState::stick;
  restart_acceleration();
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

void StickSlipIntegrator::record(ContactEvent::Kind kind) {
  const double position = now_.displacement[system_.contact] - system_.wall.displacement(time_);
  events_.push_back({kind, time_, position, sliding_velocity(now_, time_)});
  if (++events_in_step_ <= max_events_per_step) return;
  std::ostringstream text;
  text << "more than " << max_events_per_step << " contact events in the step that ends at t = "
       << static_cast<double>(steps_ + 1) * settings_.time_step
       << " s: the contact chatters; a shorter time_step may help";
  throw std::runtime_error(text.str());
}

void StickSlipIntegrator::require_finite() const {
  if (now_.displacement.allFinite() && now_.velocity.allFinite()) return;
  std::ostringstream text;
  text << "the state is no longer finite at t = " << time_ << " s: the run has diverged";
  throw std::runtime_error(text.str());
}

}  // namespace stickslip::solver
