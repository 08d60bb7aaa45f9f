// SPDX-License-Identifier: MIT
#include "stickslip/analytic/event_driven.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "arguments.hpp"
#include "gsl_handles.hpp"
#include "slip_integrator.hpp"

namespace stickslip::analytic {
namespace {

double checked_tolerance(double tolerance) {
  if (std::isfinite(tolerance) && tolerance >= 1e-14 && tolerance <= 1e-3) return tolerance;
  throw wrong_argument("tolerance", tolerance, "1e-14 ... 1e-3");
}

double checked_finite(double value, const char* name) {
  if (std::isfinite(value)) return value;
  throw wrong_argument(name, value, "finite");
}

std::vector<double> filled(const std::vector<double>& values, std::size_t size, const char* name) {
  if (values.empty()) return std::vector<double>(size);
  for (const double value : values) checked_finite(value, name);
  if (values.size() == size) return values;
  throw wrong_argument(std::string("the size of ") + name, static_cast<double>(values.size()),
                       std::to_string(size) + " or 0");
}

// Against the force that holding the contact would take.
double direction_against(double holding_force) { return holding_force > 0.0 ? -1.0 : 1.0; }

Powers operator+(const Powers& a, const Powers& b) {
  return {a.base + b.base, a.follower + b.follower, a.damping + b.damping, a.friction + b.friction};
}

Powers operator*(double factor, const Powers& a) {
  return {factor * a.base, factor * a.follower, factor * a.damping, factor * a.friction};
}

}  // namespace

EventDriven::EventDriven(const ContactModel& model, const EventDrivenSettings& settings)
    : settings_(settings),
      dynamics_(std::make_unique<const ContactDynamics>(model)),
      stick_(*dynamics_),
      limit_(model.friction.static_coefficient() * model.normal_force) {
  checked_tolerance(settings.tolerance);
  require_free_mass(model);
  start_stuck({}, {});
}

EventDriven::~EventDriven() = default;
EventDriven::EventDriven(EventDriven&&) noexcept = default;

void EventDriven::start(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                        double position) {
  const std::size_t m = dynamics_->modes();
  dynamics_->enter(0.0);
  now_ = {filled(amplitudes, m, "amplitudes"), filled(rates, m, "rates"),
          checked_finite(position, "position"), dynamics_->wall_velocity(0.0)};
  time_ = works_until_ = 0.0;
  events_.clear();
  works_ = works_before_phase_ = {};
}

void EventDriven::start_stuck(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                              double position) {
  start(amplitudes, rates, position);
  prepare_slip();
  const double force = holding_force();
  if (std::abs(force) <= limit_) return begin_stick();
  begin_slip(direction_against(force));
  record(data::ContactChange::onset);
}

void EventDriven::start_slipping(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                                 double position, double sliding_velocity) {
  start(amplitudes, rates, position);
  now_.velocity += checked_finite(sliding_velocity, "sliding_velocity");
  prepare_slip();
  begin_slip(direction_against(sliding_velocity != 0.0 ? -sliding_velocity : holding_force()));
}

void EventDriven::advance_to(double t) {
  checked_finite(t, "t");
  if (t < time_) throw wrong_argument("t", t, "at or after " + data::shortest_text(time_) + " s");
  for (;;) {
    const double end = dynamics_->piece_end();
    if (time_ >= end) {
      enter_next_piece();
      continue;
    }
    if (state_ == data::ContactState::stick) {
      const double until = std::min(t, end);
      const auto onset = stick_.first_excess(certain_until_, until, limit_);
      if (!onset) {
        certain_until_ = until;
        move_to(until);
        if (until == t) return;
        continue;
      }
      move_to(*onset);
      begin_slip(direction_against(holding_force()));
      record(data::ContactChange::onset);
    } else {
      if (!ends_ && slip_->end_time() < std::min(t, end)) {
        ends_ = slip_->step(end);
        continue;
      }
      if (!ends_ && slip_->end_time() >= end && end < t) {
        move_to(end);
        continue;
      }
      if (slip_->end_time() > t || !ends_) return move_to(std::min(t, slip_->end_time()));
      move_to(slip_->end_time());
      end_slip();
      if (time_ == t) return;
    }
  }
}

// The force may jump with the acceleration of a shock.
void EventDriven::enter_next_piece() {
  dynamics_->enter(time_);
  if (state_ == data::ContactState::slip) return slip_->go_on();
  stick_.go_on(time_);
  const double force = holding_force();
  if (std::abs(force) <= limit_) return;
  begin_slip(direction_against(force));
  record(data::ContactChange::onset);
}

double EventDriven::base_displacement() const { return dynamics_->base_displacement(time_); }

double EventDriven::sliding_velocity() const {
  return state_ == data::ContactState::stick ? 0.0 : now_.velocity - dynamics_->wall_velocity(time_);
}

double EventDriven::friction_force() const {
  return state_ == data::ContactState::stick ? holding_force() : slip_->friction_force(sliding_velocity());
}

double EventDriven::holding_force() const { return dynamics_->holding_force(view(now_), time_); }

ContactDynamics::Reactions EventDriven::reactions() const {
  auto result = dynamics_->reactions(view(now_), time_, friction_force());
  if (state_ == data::ContactState::stick)  // without rounding
    result.contact_acceleration = dynamics_->wall_acceleration(time_) + dynamics_->base_acceleration(time_);
  return result;
}

EventDrivenEnergy EventDriven::energy_balance() const {
  if (!settings_.keep_energy_balance)
    throw std::logic_error("the energy balance was not kept: set keep_energy_balance");
  return {.kinetic = dynamics_->kinetic_energy(view(now_)),
          .potential = dynamics_->potential_energy(view(now_)),
          .base_work = works_.base,
          .follower_work = works_.follower,
          .damping_loss = works_.damping,
          .friction_loss = works_.friction};
}

// With the reference velocity of EventDrivenSettings::tolerance.
void EventDriven::prepare_slip() {
  const ContactModel& model = dynamics_->model();
  const double omega = model.load_angular_frequency;
  const auto [drive_peak, wall_velocity] =
      model.drive ? model.drive->largest() : Drive::Largest{.acceleration = 1.0};
  const auto load = [&, peak = drive_peak](std::size_t n) {
    return peak * std::hypot(model.load[n], model.load_cosine.empty() ? 0.0 : model.load_cosine[n]);
  };
  double modal_load = 0.0;
  for (std::size_t n = 0; n < model.modes(); ++n) modal_load += std::pow(load(n), 2);
  double speed = std::max({std::abs(model.wall_amplitude) * omega, std::abs(model.wall_speed), wall_velocity,
                           std::sqrt(modal_load / model.contact_mass) / omega,
                           load(model.modes()) / (model.contact_mass * omega),
                           std::abs(model.contact_force) / (model.contact_mass * omega),
                           std::abs(now_.velocity - dynamics_->wall_velocity(0.0))});
  if (!(speed > 0.0)) {
    const double energy =
        dynamics_->kinetic_energy(view(now_)) + std::abs(dynamics_->potential_energy(view(now_)));
    speed = std::sqrt(2.0 * energy / model.contact_mass);
  }
  if (!(speed > 0.0)) speed = 1.0;  // nothing ever moves
  slip_ =
      std::make_unique<SlipIntegrator>(*dynamics_, settings_.tolerance, speed, settings_.keep_energy_balance);
}

void EventDriven::begin_stick() {
  state_ = data::ContactState::stick;
  now_.velocity = dynamics_->wall_velocity(time_);
  stick_.begin(time_, now_);
  certain_until_ = works_until_ = time_;
  works_before_phase_ = works_;
}

void EventDriven::begin_slip(double direction) {
  state_ = data::ContactState::slip;
  slip_->begin(time_, now_, direction);
  ends_ = false;
  works_before_phase_ = works_;
}

// At v_s = 0: sticks if it can, else slips against the force that holding it would take.
void EventDriven::end_slip() {
  const double force = slip_->holding_force(), previous = slip_->direction();
  if (std::abs(force) <= limit_) {
    begin_stick();
    return record(data::ContactChange::capture);
  }
  const double direction = direction_against(force);
  slip_->begin_next(direction);
  ends_ = false;
  works_before_phase_ = works_;
  record(direction == previous ? data::ContactChange::graze : data::ContactChange::reversal);
}

void EventDriven::move_to(double t) {
  if (state_ == data::ContactState::stick) {
    now_ = stick_.state(t);
    if (settings_.keep_energy_balance) add_works_of_stick_until(t);
  } else {
    const auto [state, works] = slip_->at(t);
    now_ = state;
    works_ = works_before_phase_ + works;
  }
  time_ = t;
  if (!std::isfinite(now_.displacement) || !std::isfinite(now_.velocity))
    throw std::runtime_error("the state is no longer finite at t = " + data::shortest_text(t) + " s.");
}

// The powers of a stick phase hold frequencies up to twice the highest. On panels of 3 rad of the highest the Gauss
// points leave nothing.
void EventDriven::add_works_of_stick_until(double t) {
  const auto panels = static_cast<std::size_t>(std::ceil((t - works_until_) * dynamics_->fastest() / 3.0));
  for_each_gauss_point(works_until_, t, panels, [&](double at, double weight) {
    const ContactKinematics state = stick_.state(at);
    const double force = dynamics_->holding_force(view(state), at);
    works_ = works_ + weight * dynamics_->powers(view(state), at, force);
  });
  works_until_ = t;
}

void EventDriven::record(data::ContactChange change) {
  events_.push_back({change, time_, now_.displacement - dynamics_->wall_displacement(time_)});
  constexpr std::size_t crowd = 10000;
  if (events_.size() <= crowd) return;
  const double span = time_ - events_[events_.size() - crowd - 1].time;
  if (span < 1e-9 / dynamics_->model().load_angular_frequency)
    throw std::runtime_error("10000 changes of contact within " + data::shortest_text(span) +
                             " s, at t = " + data::shortest_text(time_) + " s.");
}

}  // namespace stickslip::analytic
