// SPDX-License-Identifier: MIT
#include "stickslip/analytic/event_driven.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "arguments.hpp"
#include "gsl_handles.hpp"
#include "slip_integrator.hpp"
#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/analytic/stick_propagator.hpp"

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

Powers operator+(const Powers& a, const Powers& b) {
  return {a.base + b.base, a.follower + b.follower, a.damping + b.damping, a.friction + b.friction};
}

Powers operator*(double factor, const Powers& a) {
  return {factor * a.base, factor * a.follower, factor * a.damping, factor * a.friction};
}

}  // namespace

class EventDriven::Engine {
 public:
  Engine(const ContactModel& model, const EventDrivenSettings& settings)
      : settings_(settings), dynamics_(model), stick_(dynamics_) {
    checked_tolerance(settings.tolerance);
    limit_ = model.friction.static_coefficient() * model.normal_force;
    start({}, {}, 0.0);
    start_stuck();
  }
  // stick_ and slip_ refer to dynamics_.
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void start(const std::vector<double>& amplitudes, const std::vector<double>& rates, double position) {
    const std::size_t m = dynamics_.modes();
    now_ = {filled(amplitudes, m, "amplitudes"), filled(rates, m, "rates"),
            checked_finite(position, "position"), dynamics_.wall_velocity(0.0)};
    time_ = works_until_ = 0.0;
    events_.clear();
    works_ = works_before_phase_ = {};
  }

  void start_stuck() {
    prepare();
    if (std::abs(holding_force()) <= limit_) {
      begin_stick();
    } else {
      begin_slip(holding_force() > 0.0 ? -1.0 : 1.0);
      record(ContactChange::onset);
    }
  }

  void start_slipping(double sliding_velocity) {
    now_.velocity += checked_finite(sliding_velocity, "sliding_velocity");
    prepare();
    const double against = sliding_velocity != 0.0 ? -sliding_velocity : holding_force();
    begin_slip(against > 0.0 ? -1.0 : 1.0);
  }

  void advance_to(double t) {
    checked_finite(t, "t");
    if (t < time_) throw wrong_argument("t", t, "at or after " + data::shortest_text(time_) + " s");
    for (;;) {
      if (state_ == ContactPhase::stick) {
        const auto onset = stick_.first_excess(certain_until_, t, limit_);
        if (!onset) {
          certain_until_ = t;
          return move_to(t);
        }
        move_to(*onset);
        begin_slip(holding_force() > 0.0 ? -1.0 : 1.0);
        record(ContactChange::onset);
      } else {
        if (!ends_ && slip_->end_time() < t) {
          ends_ = slip_->step();
          continue;
        }
        if (slip_->end_time() > t || !ends_) return move_to(std::min(t, slip_->end_time()));
        move_to(slip_->end_time());
        settle();
        if (time_ == t) return;
      }
    }
  }

  [[nodiscard]] double holding_force() const { return dynamics_.holding_force(view(now_), time_); }

  [[nodiscard]] double friction_force() const {
    return state_ == ContactPhase::stick ? holding_force() : slip_->friction_force(sliding_velocity());
  }

  [[nodiscard]] double sliding_velocity() const {
    return state_ == ContactPhase::stick ? 0.0 : now_.velocity - dynamics_.wall_velocity(time_);
  }

  [[nodiscard]] EventDrivenEnergy energy_balance() const {
    if (!settings_.keep_energy_balance)
      throw std::logic_error("the energy balance was not kept: set keep_energy_balance");
    return {.kinetic = dynamics_.kinetic_energy(view(now_)),
            .potential = dynamics_.potential_energy(view(now_)),
            .base_work = works_.base,
            .follower_work = works_.follower,
            .damping_loss = works_.damping,
            .friction_loss = works_.friction};
  }

  [[nodiscard]] double wall_displacement() const { return dynamics_.wall_displacement(time_); }
  [[nodiscard]] double drive_displacement() const {
    return dynamics_.model().wall_amplitude * dynamics_.load(time_);
  }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] ContactPhase state() const { return state_; }
  [[nodiscard]] const ContactKinematics& now() const { return now_; }
  [[nodiscard]] const std::vector<ChangeOfContact>& events() const { return events_; }

 private:
  void prepare() {
    double speed = settings_.reference_velocity;
    if (!(speed > 0.0)) {
      const ContactModel& model = dynamics_.model();
      const double omega = model.load_angular_frequency;
      double modal_load = 0.0;
      for (std::size_t n = 0; n < model.modes(); ++n) modal_load += std::pow(model.load[n], 2);
      speed = std::max({std::abs(model.wall_amplitude) * omega, std::abs(model.wall_speed),
                        std::sqrt(modal_load / model.contact_mass) / omega,
                        std::abs(model.load.back()) / (model.contact_mass * omega),
                        std::abs(model.contact_force) / (model.contact_mass * omega),
                        std::abs(now_.velocity - dynamics_.wall_velocity(0.0))});
    }
    if (!(speed > 0.0)) speed = speed_of_the_energy();
    if (!(speed > 0.0)) speed = 1.0;  // nothing ever moves
    slip_ = std::make_unique<SlipIntegrator>(dynamics_, settings_.tolerance, speed,
                                             settings_.keep_energy_balance);
  }

  // What all the energy of the start would give the contact's mass.
  [[nodiscard]] double speed_of_the_energy() const {
    const double energy =
        dynamics_.kinetic_energy(view(now_)) + std::abs(dynamics_.potential_energy(view(now_)));
    return std::sqrt(2.0 * energy / dynamics_.model().contact_mass);
  }

  void begin_stick() {
    state_ = ContactPhase::stick;
    now_.velocity = dynamics_.wall_velocity(time_);
    stick_.begin(time_, now_);
    certain_until_ = works_until_ = time_;
    works_before_phase_ = works_;
  }

  void begin_slip(double direction) {
    state_ = ContactPhase::slip;
    slip_->begin(time_, now_, direction);
    ends_ = false;
    works_before_phase_ = works_;
  }

  // At v_s = 0: sticks if it can, else slips against the force that holding it would take.
  void settle() {
    const double force = slip_->holding_force(), previous = slip_->direction();
    if (std::abs(force) <= limit_) {
      begin_stick();
      return record(ContactChange::capture);
    }
    const double direction = force > 0.0 ? -1.0 : 1.0;
    slip_->begin_next(direction);
    ends_ = false;
    works_before_phase_ = works_;
    record(direction == previous ? ContactChange::graze : ContactChange::reversal);
  }

  void move_to(double t) {
    if (state_ == ContactPhase::stick) {
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

  // The powers of a stick phase hold frequencies up to twice the highest: panels of 2 rad of it, on which ten
  // Gauss points leave nothing.
  void add_works_of_stick_until(double t) {
    constexpr std::size_t points = 10;
    static const auto table = owned(gsl_integration_glfixed_table_alloc(points));
    const double span = t - works_until_;
    const auto panels = static_cast<long>(std::ceil(span * dynamics_.fastest() / 2.0));
    for (long panel = 0; panel < panels; ++panel) {
      const double from = works_until_ + span * static_cast<double>(panel) / static_cast<double>(panels);
      const double to = works_until_ + span * static_cast<double>(panel + 1) / static_cast<double>(panels);
      for (std::size_t i = 0; i < points; ++i) {
        double at = 0.0, weight = 0.0;
        gsl_integration_glfixed_point(from, to, i, &at, &weight, table.get());
        const ContactKinematics state = stick_.state(at);
        const double force = dynamics_.holding_force(view(state), at);
        works_ = works_ + weight * dynamics_.powers(view(state), at, force);
      }
    }
    works_until_ = t;
  }

  void record(ContactChange change) {
    events_.push_back({change, time_, now_.displacement - dynamics_.wall_displacement(time_)});
    constexpr std::size_t crowd = 10000;
    if (events_.size() <= crowd) return;
    const double span = time_ - events_[events_.size() - crowd - 1].time;
    if (span < 1e-9 / dynamics_.model().load_angular_frequency)
      throw std::runtime_error("10000 changes of contact within " + data::shortest_text(span) +
                               " s, at t = " + data::shortest_text(time_) + " s.");
  }

  EventDrivenSettings settings_;
  ContactDynamics dynamics_;
  StickPropagator stick_;
  std::unique_ptr<SlipIntegrator> slip_;
  double limit_{};  // mu_s N

  double time_{};
  ContactPhase state_{ContactPhase::stick};
  ContactKinematics now_;
  double certain_until_{};  // stick: no onset before
  bool ends_{};             // slip: v_s = 0 at the end of the last step
  std::vector<ChangeOfContact> events_;
  Powers works_, works_before_phase_;
  double works_until_{};
};

EventDriven::EventDriven(const ContactModel& model, const EventDrivenSettings& settings)
    : engine_(std::make_unique<Engine>(model, settings)) {}

EventDriven::~EventDriven() = default;
EventDriven::EventDriven(EventDriven&&) noexcept = default;
EventDriven& EventDriven::operator=(EventDriven&&) noexcept = default;

void EventDriven::start_stuck(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                              double position) {
  engine_->start(amplitudes, rates, position);
  engine_->start_stuck();
}

void EventDriven::start_slipping(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                                 double position, double sliding_velocity) {
  engine_->start(amplitudes, rates, position);
  engine_->start_slipping(sliding_velocity);
}

void EventDriven::advance_to(double t) { engine_->advance_to(t); }
double EventDriven::time() const { return engine_->time(); }
ContactPhase EventDriven::state() const { return engine_->state(); }
const std::vector<double>& EventDriven::amplitudes() const { return engine_->now().amplitudes; }
const std::vector<double>& EventDriven::rates() const { return engine_->now().rates; }
double EventDriven::contact_displacement() const { return engine_->now().displacement; }
double EventDriven::contact_velocity() const { return engine_->now().velocity; }
double EventDriven::wall_displacement() const { return engine_->wall_displacement(); }
double EventDriven::drive_displacement() const { return engine_->drive_displacement(); }
double EventDriven::contact_position() const {
  return engine_->now().displacement - engine_->wall_displacement();
}
double EventDriven::sliding_velocity() const { return engine_->sliding_velocity(); }
double EventDriven::friction_force() const { return engine_->friction_force(); }
double EventDriven::holding_force() const { return engine_->holding_force(); }
const std::vector<ChangeOfContact>& EventDriven::events() const { return engine_->events(); }
EventDrivenEnergy EventDriven::energy_balance() const { return engine_->energy_balance(); }

}  // namespace stickslip::analytic
