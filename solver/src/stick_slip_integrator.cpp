#include "stickslip/solver/stick_slip_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "bracketed_root.hpp"
#include "constrained.hpp"
#include "step_operator.hpp"

namespace stickslip::solver {

namespace {

constexpr int max_events_per_step = 1000;
// An event is located to this part of the step: far below the error of the method.
constexpr double location_tolerance_per_step = 1e-11;

double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

template <typename Cholesky>
bool is_positive_definite(const Cholesky& factorization) {
  return factorization.info() == Eigen::Success && factorization.vectorD().allFinite() &&
         factorization.vectorD().minCoeff() > 0.0;
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

StickSlipIntegrator::StickSlipIntegrator(ContactSystem system, const IntegratorSettings& settings)
    : system_(std::move(system)), settings_(settings), method_(settings.spectral_radius) {
  require(std::isfinite(settings.time_step) && settings.time_step > 0.0,
          "time_step = " + std::to_string(settings.time_step) + " s: must be positive");
  require(
      std::isfinite(settings.velocity_threshold) && settings.velocity_threshold >= 0.0,
      "velocity_threshold = " + std::to_string(settings.velocity_threshold) + " m/s: must not be negative");
  require(settings.scheme != ContactScheme::paper || settings.velocity_threshold > 0.0,
          "velocity_threshold = 0 m/s: must be positive with the scheme of the paper, or no slip ever ends");
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
    if (settings_.scheme == ContactScheme::paper) {
      advance_by_the_paper(end_time);
    } else if (state_ == ContactState::stick) {
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
  if (settings_.scheme == ContactScheme::end_of_step) {
    accept_trial(end_time);
  } else if (excess_now < 0.0) {
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
  if (settings_.scheme == ContactScheme::end_of_step) {
    accept_trial(end_time);
    return settle_at_rest();
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

void StickSlipIntegrator::advance_by_the_paper(double end_time) {
  decide_by_the_paper();
  trial(end_time);
  accept_trial(end_time);
}

// Not finer than the spacing of floating-point numbers around the time itself.
double StickSlipIntegrator::location_tolerance() const {
  return std::max(location_tolerance_per_step * settings_.time_step,
                  2.0 * std::numeric_limits<double>::epsilon() * time_);
}

void StickSlipIntegrator::accept_trial(double new_time) {
  std::swap(now_, trial_);
  time_ = new_time;
  notify();
}

void StickSlipIntegrator::notify() const {
  if (observer_) observer_(*this);
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
  notify();
}

// The contact is at rest on the wall, up to what the location left: stick if it can be held, else slip.
void StickSlipIntegrator::settle_at_rest() {
  const double force = holding_force(now_, time_);
  if (std::abs(force) <= static_limit_) {
    record(ContactEvent::Kind::capture);
    stick_here();
    return notify();
  }
  const double new_direction = -sign(force);
  record(new_direction == direction_ ? ContactEvent::Kind::graze : ContactEvent::Kind::reversal);
  direction_ = new_direction;
  restart_acceleration();
  notify();
}

// The velocity of the contact becomes that of the wall, by an impulse at the contact alone.
void StickSlipIntegrator::stick_here() {
  const Eigen::Index c = system_.contact;
  now_.velocity += (system_.wall.velocity(time_) - now_.velocity[c]) * impulse_response_;
  wall_offset_ = now_.displacement[c] - system_.wall.displacement(time_);
  state_ = ContactState::stick;
  restart_acceleration();
}

// Sect. 3: the state for the step that begins, from |v_s| <= epsilon and |f_s| <= mu_s N alone.
void StickSlipIntegrator::decide_by_the_paper() {
  const double sliding = sliding_velocity(now_, time_);
  const bool sticks = std::abs(sliding) <= settings_.velocity_threshold && excess_force(now_, time_) <= 0.0;
  if (sticks && state_ == ContactState::slip) {
    record(ContactEvent::Kind::capture);
    now_.velocity[system_.contact] = system_.wall.velocity(time_);
    wall_offset_ = now_.displacement[system_.contact] - system_.wall.displacement(time_);
    state_ = ContactState::stick;
    notify();
  }
  if (sticks) return;
  const bool from_rest = state_ == ContactState::stick || sliding == 0.0;
  const double new_direction = from_rest ? -sign(holding_force(now_, time_)) : sign(sliding);
  if (state_ == ContactState::slip && new_direction == direction_) return;
  record(state_ == ContactState::stick ? ContactEvent::Kind::onset : ContactEvent::Kind::reversal);
  state_ = ContactState::slip;
  direction_ = new_direction;
  notify();
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
