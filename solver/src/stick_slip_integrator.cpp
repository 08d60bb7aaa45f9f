// SPDX-License-Identifier: MIT
#include "stickslip/solver/stick_slip_integrator.hpp"

#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "friction_contact.hpp"
#include "held_contact.hpp"
#include "step_kernel.hpp"

namespace stickslip::solver {

namespace {

constexpr int max_events_per_step = 1000;

void require_size(Eigen::Index size, Eigen::Index expected, const char* name) {
  if (size == expected) return;
  throw std::invalid_argument(std::string(name) + " has size " + std::to_string(size) + ", but must have " +
                              std::to_string(expected) + ", the degrees of freedom");
}

ContactSystem consistent(ContactSystem system) {
  const Eigen::Index n = system.mass.rows();
  for (const auto& [matrix, name] : {std::pair{&system.mass, "mass"},
                                     {&system.damping, "damping"},
                                     {&system.stick_stiffness, "stick_stiffness"},
                                     {&system.slip_stiffness, "slip_stiffness"}}) {
    require_size(matrix->rows(), n, name);
    require_size(matrix->cols(), n, name);
  }
  require_size(system.load_shape.size(), n, "load_shape");
  for (const ContactSystem::Load& load : system.further_loads)
    require_size(load.shape.size(), n, "the shape of a further load");
  if (system.contact < 0 || system.contact >= n)
    throw std::invalid_argument("contact is " + std::to_string(system.contact) +
                                ", but must be a degree of freedom, 0 ... " + std::to_string(n - 1));
  if (!(system.normal_force >= 0.0))
    throw data::FieldError("normal_force", system.normal_force, "a number of 0 or more (N)");
  if (system.normal_force == bonding_force) data::require_rigid(system.tangential, "a bonded contact");
  return system;
}

IntegratorSettings usable(const IntegratorSettings& settings) {
  const double h = settings.time_step, threshold = settings.velocity_threshold;
  if (!(std::isfinite(h) && h > 0.0)) throw data::FieldError("time_step", h, "a finite number above 0 (s)");
  if (!(std::isfinite(threshold) && threshold >= 0.0))
    throw data::FieldError("velocity_threshold", threshold, "a finite number of 0 or more (m/s)");
  if (settings.scheme == ContactScheme::paper && threshold == 0.0)
    throw data::FieldError("velocity_threshold", threshold,
                           "above 0 (m/s) with the scheme of the paper, or no slip ever ends");
  return settings;
}

}  // namespace

StickSlipIntegrator::StickSlipIntegrator(ContactSystem system, const IntegratorSettings& settings)
    : system_(consistent(std::move(system))),
      settings_(usable(settings)),
      method_(settings.spectral_radius),
      contact_(std::make_unique<FrictionContact>(system_)),
      held_contact_(std::make_unique<HeldContact>(system_)),
      kernel_((settings.coordinates == Coordinates::modal ? make_modal_kernel : make_sparse_kernel)(
          system_, *contact_, method_, settings.time_step)),
      advance_(scheme()) {}

StickSlipIntegrator::~StickSlipIntegrator() = default;

void StickSlipIntegrator::start(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) {
  const Eigen::Index n = system_.mass.rows();
  require_size(displacement.size(), n, "displacement");
  require_size(velocity.size(), n, "velocity");
  now_ = {displacement, velocity, Eigen::VectorXd::Zero(n)};
  trial_ = now_;
  time_ = 0.0;
  steps_ = 0;
  events_.clear();
  events_in_step_ = 0;
}

void StickSlipIntegrator::start_stuck(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) {
  start(displacement, velocity);
  now_.velocity[system_.contact] = system_.wall.velocity(0.0);
  if (yields()) return begin_yielding();
  begin_stick();
  if (excess_force() > 0.0) leave_stick();
}

void StickSlipIntegrator::start_slipping(const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& velocity) {
  if (contact_->is_bonded()) throw std::logic_error("a bonded contact cannot start in slip");
  start(displacement, velocity);
  if (yields()) return begin_yielding();
  const double sliding = relative_velocity();
  begin_slip(sliding != 0.0 ? sign(sliding) : -sign(holding_force()));
}

void StickSlipIntegrator::step() {
  events_in_step_ = 0;
  const double end_time = static_cast<double>(steps_ + 1) * settings_.time_step;
  while (time_ < end_time) (this->*advance_)(end_time);
  ++steps_;
  if (now_.displacement.allFinite() && now_.velocity.allFinite()) return;
  std::ostringstream text;
  text << "the state is no longer finite at t = " << time_ << " s: the run has diverged";
  throw std::runtime_error(text.str());
}

void StickSlipIntegrator::observe(Observer observer) { observer_ = std::move(observer); }

bool StickSlipIntegrator::yields() const noexcept { return contact_->yields(); }

double StickSlipIntegrator::relative_velocity() const { return held_contact_->sliding_velocity(now_, time_); }

double StickSlipIntegrator::sliding_velocity() const {
  return is_stuck() && !yields() ? 0.0 : relative_velocity();
}

double StickSlipIntegrator::holding_force() const { return held_contact_->holding_force(now_, time_); }

double StickSlipIntegrator::excess_force() const { return contact_->excess(holding_force()); }

double StickSlipIntegrator::contact_mass() const noexcept { return held_contact_->mass(); }

double StickSlipIntegrator::contact_acceleration() const {
  const double wall = system_.wall.acceleration(time_);
  return is_stuck() && !yields() ? wall : wall + (friction_force() - holding_force()) / contact_mass();
}

double StickSlipIntegrator::position() const {
  return now_.displacement[system_.contact] - system_.wall.displacement(time_);
}

double StickSlipIntegrator::friction_force() const {
  if (yields()) return yielding_force_;
  return is_stuck() ? holding_force() : contact_->force(phase_.direction, relative_velocity());
}

const Kinematics& StickSlipIntegrator::compute_trial_step(double end_time) {
  kernel_->take_step(phase_, now_, time_, end_time, trial_);
  return trial_;
}

double StickSlipIntegrator::trial_excess_force(double end_time) {
  return contact_->excess(held_contact_->holding_force(compute_trial_step(end_time), end_time));
}

double StickSlipIntegrator::trial_forward_velocity(double end_time) {
  return phase_.direction * held_contact_->sliding_velocity(compute_trial_step(end_time), end_time);
}

void StickSlipIntegrator::accept_trial_step(double new_time) {
  const double length = new_time - time_;
  std::swap(now_, trial_);
  time_ = new_time;
  if (yields()) return move_slider(length);
  notify();
}

void StickSlipIntegrator::begin_stick() {
  held_contact_->remove_sliding_velocity(now_, time_);
  phase_ = {.state = data::ContactState::stick, .wall_offset = position()};
  kernel_->restart(phase_, time_, now_);
}

// At the start the spring has no force; a smooth law has none at rest.
void StickSlipIntegrator::begin_yielding() {
  const bool is_smooth = system_.tangential.is_smooth();
  yielding_force_ = alpha_level_force_ =
      contact_->yielding_force(position(), position(), relative_velocity());
  alpha_level_time_ = 0.0;
  phase_ = {.state = is_smooth ? data::ContactState::slip : data::ContactState::stick,
            .wall_offset = position()};
  kernel_->restart(phase_, time_, now_);
}

void StickSlipIntegrator::move_slider(double length) {
  const auto [slider, direction] =
      contact_->advance_slider(phase_.wall_offset, position(), relative_velocity());
  phase_.wall_offset = slider;
  // On the line through the last two α levels, within the bound. After a kink q and v oscillate from step to step,
  // and the stiff law would amplify that; the α level is free of it.
  const double force = kernel_->yielding_force(), level = method_.load_time(time_ - length, length);
  yielding_force_ =
      contact_->bounded(force + (force - alpha_level_force_) * (time_ - level) / (level - alpha_level_time_),
                        relative_velocity());
  alpha_level_force_ = force;
  alpha_level_time_ = level;
  notify();
  if (system_.tangential.is_smooth() || direction == (is_stuck() ? 0.0 : phase_.direction)) return;
  record(is_stuck()         ? data::ContactChange::onset
         : direction == 0.0 ? data::ContactChange::capture
                            : data::ContactChange::reversal);
  phase_.state = direction == 0.0 ? data::ContactState::stick : data::ContactState::slip;
  phase_.direction = direction;
  notify();
}

void StickSlipIntegrator::begin_slip(double direction) {
  phase_ = {.state = data::ContactState::slip, .direction = direction};
  kernel_->restart(phase_, time_, now_);
}

void StickSlipIntegrator::leave_stick() {
  record(data::ContactChange::onset);
  const double force = holding_force(), direction = -sign(force);
  // At a located onset the force does not jump, unless the law does, and so the contact still has the acceleration of the
  // wall. What the stiff modes of a damped mesh would add to it may point backwards.
  constexpr double located = 1e-6;
  const bool jumps =
      system_.friction.in_slip().static_coefficient() < system_.friction.static_coefficient() ||
      contact_->excess(force) > located * std::abs(force);
  if (system_.damping.nonZeros() == 0 || jumps || !is_stuck()) {
    begin_slip(direction);
  } else {
    kernel_->restart(phase_, time_, now_);
    phase_ = {.state = data::ContactState::slip, .direction = direction};
  }
  notify();
}

void StickSlipIntegrator::stick_or_reverse() {
  const double force = held_contact_->holding_force_at_rest(now_, time_);
  if (contact_->excess(force) <= 0.0) {
    record(data::ContactChange::capture);
    begin_stick();
    return notify();
  }
  const double direction = -sign(force);
  record(direction == phase_.direction ? data::ContactChange::graze : data::ContactChange::reversal);
  // A phase that never moved forward ends with the step: what slides backward by then stops, as at a capture.
  if (settings_.scheme == ContactScheme::located && direction * relative_velocity() < 0.0)
    held_contact_->remove_sliding_velocity(now_, time_);
  begin_slip(direction);
  notify();
}

void StickSlipIntegrator::overwrite_sliding_velocity() {
  record(data::ContactChange::capture);
  now_.velocity[system_.contact] = system_.wall.velocity(time_);
  phase_ = {.state = data::ContactState::stick, .wall_offset = position()};
  notify();
}

void StickSlipIntegrator::turn_to(double direction) {
  record(is_stuck() ? data::ContactChange::onset : data::ContactChange::reversal);
  phase_ = {.state = data::ContactState::slip, .direction = direction};
  notify();
}

void StickSlipIntegrator::record(data::ContactChange change) {
  events_.push_back({change, time_, position(), relative_velocity()});
  if (++events_in_step_ <= max_events_per_step) return;
  std::ostringstream text;
  text << "more than " << max_events_per_step << " contact events in the step that ends at t = "
       << static_cast<double>(steps_ + 1) * settings_.time_step
       << " s: the contact chatters; a shorter time_step may help";
  throw std::runtime_error(text.str());
}

void StickSlipIntegrator::notify() const {
  if (observer_) observer_(*this);
}

}  // namespace stickslip::solver
