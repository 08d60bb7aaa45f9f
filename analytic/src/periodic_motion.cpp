// SPDX-License-Identifier: MIT
#include "stickslip/analytic/periodic_motion.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "arguments.hpp"
#include "friction_in_slip.hpp"
#include "gsl_handles.hpp"
#include "stickslip/analytic/stick_propagator.hpp"

namespace stickslip::analytic {
namespace {

// The same structure without load and wall: what differences of motions in stick obey.
ContactModel unloaded(ContactModel model) {
  std::ranges::fill(model.load, 0.0);
  model.wall_amplitude = model.wall_speed = model.contact_force = 0.0;
  return model;
}

// Errors of a step: of a state, and of a derivative for multipliers of nine digits or for Newton's method.
constexpr double tolerance_of_state = 1e-13, tolerance_of_multipliers = 1e-10, tolerance_of_newton = 1e-6;

/// The flow, with its derivative or without, phase by phase.
class Variation {
 public:
  Variation(const ContactModel& model, const ContactStart& start, bool with_derivative, double tolerance)
      : dynamics_(model),
        differences_(unloaded(model)),
        stick_(dynamics_),
        stick_of_differences_(differences_),
        law_(model.friction.in_slip()),
        modes_(model.modes()),
        n_(2 * (modes_ + 1)),
        columns_(with_derivative ? n_ : 0),
        tolerance_(tolerance),
        x_(flat(start.kinematics)),
        phi_(n_, columns_) {
    for (std::size_t i = 0; i < columns_; ++i) phi_(i, i) = 1.0;
    set_scale();
  }

  // The velocity of the contact is that of the wall, whatever the state was at the start.
  void begin_stick() {
    sticks_ = true;
    x_.back() = dynamics_.wall_velocity(time_);
    for (std::size_t j = 0; j < columns_; ++j) phi_(n_ - 1, j) = 0.0;
    stick_.begin(time_, copy(view(x_.data(), modes_)));
  }

  void begin_slip(double direction) {
    sticks_ = false;
    direction_ = direction;
  }

  void advance_to(double t) {
    if (t > time_) sticks_ ? advance_stick(t) : advance_slip(t);
    time_ = t;
  }

  [[nodiscard]] std::vector<double> rate() const {
    std::vector<double> rate(n_);
    std::copy_n(x_.begin() + static_cast<std::ptrdiff_t>(modes_) + 1, modes_ + 1, rate.begin());
    const KinematicsView state = view(x_.data(), modes_);
    const double friction =
        sticks_ ? dynamics_.holding_force(state, time_)
                : -direction_ * resistance(state.velocity - dynamics_.wall_velocity(time_)).force;
    rate[n_ - 1] =
        dynamics_.accelerate(state, dynamics_.load(time_), friction + dynamics_.model().contact_force,
                             {rate.data() + modes_ + 1, modes_});
    return rate;
  }

  void change(const data::ContactEvent& event) {
    advance_to(event.time);
    if (event.change == data::ContactChange::graze) return;
    const std::vector<double> before = rate();
    std::vector<double> gradient(n_);
    double passage = 0.0;
    if (event.change == data::ContactChange::onset) {
      gradient = force_gradient();
      passage = stick_.force_rate(time_);
      begin_slip(dynamics_.holding_force(view(x_.data(), modes_), time_) > 0.0 ? -1.0 : 1.0);
    } else {
      gradient.back() = 1.0;
      passage = before.back() - dynamics_.wall_acceleration(time_);
      x_.back() = dynamics_.wall_velocity(time_);
      if (event.change == data::ContactChange::reversal) begin_slip(-direction_);
    }
    const bool captured = event.change == data::ContactChange::capture;
    if (captured) sticks_ = true;
    jump(before, rate(), gradient, passage);
    if (captured) begin_stick();
  }

  [[nodiscard]] ContactStart state() const {
    return {copy(view(x_.data(), modes_)), sticks_ ? data::ContactState::stick : data::ContactState::slip};
  }

  [[nodiscard]] const Matrix& derivative() const { return phi_; }

 private:
  // Velocities of the order of the motion, and the time in which they turn.
  void set_scale() {
    const ContactModel& model = dynamics_.model();
    const double mass = model.contact_mass;
    const double omega =
        std::max(std::sqrt(std::abs(dynamics_.held_stiffness()) / mass), 1e-3 * dynamics_.fastest());
    double speed =
        std::max(std::abs(model.wall_speed), std::abs(model.wall_amplitude) * model.load_angular_frequency);
    speed = std::max({speed, std::abs(x_.back()), omega * std::abs(x_[modes_]),
                      model.normal_force * model.friction.static_coefficient() / (mass * omega), 1e-30});
    scale_.assign(n_, speed);
    for (std::size_t i = 0; i < modes_; ++i) scale_[modes_ + 1 + i] = speed * std::sqrt(mass);
    for (std::size_t i = 0; i <= modes_; ++i) scale_[i] = scale_[modes_ + 1 + i] / omega;
  }

  [[nodiscard]] SlipResistance resistance(double sliding) const {
    return slip_resistance(law_, dynamics_.model().normal_force, direction_ * sliding);
  }

  [[nodiscard]] std::vector<double> force_gradient() const {
    const std::vector<double> row = dynamics_.held_force_row();  // of T and T_t
    std::vector<double> gradient(n_);
    for (std::size_t i = 0; i < modes_; ++i) {
      gradient[i] = row[i];
      gradient[modes_ + 1 + i] = row[modes_ + i];
    }
    gradient[modes_] = dynamics_.held_stiffness();
    return gradient;
  }

  void advance_stick(double t) {
    x_ = flat(stick_.state(t));
    for (std::size_t j = 0; j < columns_; ++j) {
      std::vector<double> column(n_);
      for (std::size_t i = 0; i < n_; ++i) column[i] = phi_(i, j);
      stick_of_differences_.begin(time_, copy(view(column.data(), modes_)));
      column = flat(stick_of_differences_.state(t));
      for (std::size_t i = 0; i < n_; ++i) phi_(i, j) = column[i];
    }
  }

  // y: x and the columns of Φ, all in units of scale_.
  static int right_side(double t, const double y[], double rate[], void* self) {
    static_cast<const Variation*>(self)->evaluate(t, y, rate);
    return GSL_SUCCESS;
  }

  void evaluate(double t, const double* y, double* rate) const {
    std::vector<double> x(n_), modal(modes_);
    double friction_slope = 0.0;
    for (std::size_t column = 0; column <= columns_; ++column) {
      for (std::size_t i = 0; i < n_; ++i) x[i] = scale_[i] * y[column * n_ + i];
      const KinematicsView state = view(x.data(), modes_);
      double acceleration = 0.0;
      if (column == 0) {
        const SlipResistance friction = resistance(state.velocity - dynamics_.wall_velocity(t));
        friction_slope = -friction.slope;  // d f_d/d v_s
        acceleration = dynamics_.accelerate(
            state, dynamics_.load(t), -direction_ * friction.force + dynamics_.model().contact_force, modal);
      } else {
        acceleration = dynamics_.accelerate(state, {}, friction_slope * state.velocity, modal);
      }
      double* out = rate + column * n_;
      for (std::size_t i = 0; i <= modes_; ++i) out[i] = x[modes_ + 1 + i] / scale_[i];
      for (std::size_t i = 0; i < modes_; ++i) out[modes_ + 1 + i] = modal[i] / scale_[modes_ + 1 + i];
      out[n_ - 1] = acceleration / scale_[n_ - 1];
    }
  }

  void advance_slip(double end) {
    const StatusInsteadOfAbort guard;
    const std::size_t size = n_ * (columns_ + 1);
    std::vector<double> y(size);
    for (std::size_t i = 0; i < n_; ++i) {
      y[i] = x_[i] / scale_[i];
      for (std::size_t j = 0; j < columns_; ++j) y[(j + 1) * n_ + i] = phi_(i, j) * scale_[j] / scale_[i];
    }
    gsl_odeiv2_system system{&Variation::right_side, nullptr, size, this};
    const double longest = (tolerance_ == tolerance_of_state ? 1.0 : 3.0) / dynamics_.fastest();
    const auto driver = owned(gsl_odeiv2_driver_alloc_standard_new(
        &system, gsl_odeiv2_step_rk8pd, 0.05 * longest, tolerance_, tolerance_, 1.0, 0.0));
    gsl_odeiv2_driver_set_hmax(driver.get(), longest);
    double t = time_;
    require_success(gsl_odeiv2_driver_apply(driver.get(), &t, end, y.data()), "slip of a periodic motion");
    for (std::size_t i = 0; i < n_; ++i) {
      x_[i] = y[i] * scale_[i];
      for (std::size_t j = 0; j < columns_; ++j) phi_(i, j) = y[(j + 1) * n_ + i] * scale_[i] / scale_[j];
    }
  }

  // Φ <- Φ + (after - before) (gradient . Φ)/passage.
  void jump(const std::vector<double>& before, const std::vector<double>& after,
            const std::vector<double>& gradient, double passage) {
    for (std::size_t j = 0; j < columns_; ++j) {
      double difference = 0.0;
      for (std::size_t i = 0; i < n_; ++i) difference += gradient[i] * phi_(i, j);
      for (std::size_t i = 0; i < n_; ++i) phi_(i, j) += (after[i] - before[i]) * difference / passage;
    }
  }

  ContactDynamics dynamics_, differences_;
  StickPropagator stick_, stick_of_differences_;
  data::FrictionLaw law_;
  std::size_t modes_, n_, columns_;  // columns of Φ that are followed: all or none
  double tolerance_;
  std::vector<double> x_;
  Matrix phi_;
  std::vector<double> scale_;
  double time_{}, direction_{};
  bool sticks_{};
};

// The phases of the flow over a time.
struct Phases {
  data::ContactState first;                ///< slip, if it cannot stick
  double direction;                        ///< of the first, if that is slip
  std::vector<data::ContactEvent> events;  ///< after the start
};

Phases phases_of(const ContactModel& model, const ContactStart& from, double duration) {
  EventDriven run(model);
  start(run, model, from);
  Phases phases{run.state(), run.friction_force() > 0.0 ? -1.0 : 1.0, {}};
  run.advance_to(duration);
  phases.events = run.events();
  if (phases.first == data::ContactState::slip)
    std::erase_if(phases.events, [](const data::ContactEvent& event) { return event.time == 0.0; });
  return phases;
}

PoincareImage image_of(const ContactModel& model, const ContactStart& from, double duration,
                       const Phases& phases, bool with_derivative, double tolerance) {
  Variation variation(model, from, with_derivative, tolerance);
  if (phases.first == data::ContactState::stick)
    variation.begin_stick();
  else
    variation.begin_slip(phases.direction);
  for (const data::ContactEvent& event : phases.events) variation.change(event);
  variation.advance_to(duration);
  return {variation.state(), variation.derivative(), variation.rate(), phases.events};
}

ContactStart state_of(const EventDriven& run) {
  return {{run.amplitudes(), run.rates(), run.contact_displacement(), run.contact_velocity()}, run.state()};
}

// x with A x = b, in place of b; false if A is singular.
bool solve(const Matrix& a, std::vector<double>& b) {
  const StatusInsteadOfAbort guard;
  const auto matrix = gsl_copy_of(a);
  const auto permutation = owned(gsl_permutation_alloc(b.size()));
  int sign = 0;
  gsl_vector_view right = gsl_vector_view_array(b.data(), b.size());
  return gsl_linalg_LU_decomp(matrix.get(), permutation.get(), &sign) == GSL_SUCCESS &&
         gsl_linalg_LU_svx(matrix.get(), permutation.get(), &right.vector) == GSL_SUCCESS &&
         std::ranges::all_of(b, [](double value) { return std::isfinite(value); });
}

bool is_finite(const Matrix& matrix) {
  return std::ranges::all_of(matrix.values(), [](double value) { return std::isfinite(value); });
}

// Velocities in units of that of the contact, coordinates in units of that times the period.
std::vector<double> units_of(const ContactStart& start, const std::vector<double>& rate, double period) {
  const std::vector<double> x = flat(start.kinematics);
  const std::size_t half = x.size() / 2;
  const double speed = std::max(std::abs(x.back()), std::abs(rate.back()) * period) + 1e-300;
  std::vector<double> units(x.size(), speed);
  for (std::size_t i = 0; i < x.size(); ++i) units[i] = speed * (i < half ? period : 1.0);
  return units;
}

// Of the run from rest, from which Newton's method starts.
constexpr EventDrivenSettings settling{.tolerance = 1e-8};

/// Newton's method for x(T) = x(0); with a free period, T is an unknown and the velocity of the contact at the start is
/// kept.
class Shooting {
 public:
  Shooting(const ContactModel& model, ContactStart start, double period, bool free_period)
      : model_(model), start_(std::move(start)), period_(period), free_period_(free_period) {}

  // A start from which three steps lead no nearer is given up: each step may take seconds.
  [[nodiscard]] std::optional<PeriodicMotion> run() {
    constexpr int patience = 3;
    double first = 0.0, last = std::numeric_limits<double>::infinity();
    Matrix derivative;  // kept while each step brings a digit
    bool is_new = false;
    for (int iteration = 0; iteration < 30; ++iteration) {
      const Phases phases = phases_of(model_, start_, period_);
      const PoincareImage image = image_of(model_, start_, period_, phases, false, tolerance_of_state);
      if (image.end.phase != start_.phase) return std::nullopt;
      const double residual = residual_of(image);
      if (iteration == 0) first = residual;
      if (!std::isfinite(residual) || (iteration >= patience && residual >= first)) return std::nullopt;
      // The tolerance of the run, or what its rounding leaves.
      const bool is_found = residual < 1e-12 || (residual < 1e-9 && is_new && residual >= 0.3 * last);
      is_new = is_found || !(residual < 0.1 * last) || derivative.empty();
      if (is_new)
        derivative = image_of(model_, start_, period_, phases, true,
                              is_found ? tolerance_of_multipliers : tolerance_of_newton)
                         .derivative;
      if (!is_finite(derivative)) return std::nullopt;  // a graze
      if (is_found)
        return PeriodicMotion{start_, period_, image.events, eigenvalues(derivative), residual, iteration};
      if (!improve(image, derivative)) return std::nullopt;
      last = residual;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double residual_of(const PoincareImage& image) const {
    const std::vector<double> x = flat(start_.kinematics), end = flat(image.end.kinematics),
                              units = units_of(start_, image.rate, period_);
    double largest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      largest = std::max(largest, std::abs(end[i] - x[i]) / units[i]);
    return largest;
  }

  bool improve(const PoincareImage& image, const Matrix& derivative) {
    std::vector<double> x = flat(start_.kinematics);
    const std::vector<double> end = flat(image.end.kinematics), units = units_of(start_, image.rate, period_);
    const std::size_t n = x.size(), size = n + (free_period_ ? 1 : 0);
    Matrix jacobian(size, size);
    std::vector<double> change(size);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        jacobian(i, j) = (derivative(i, j) - (i == j ? 1.0 : 0.0)) * units[j] / units[i];
      change[i] = (x[i] - end[i]) / units[i];
      if (free_period_) jacobian(i, n) = image.rate[i] * period_ / units[i];
    }
    if (free_period_) jacobian(n, n - 1) = 1.0;
    if (!solve(jacobian, change)) return false;
    for (std::size_t i = 0; i < n; ++i) x[i] += change[i] * units[i];
    if (free_period_) period_ *= 1.0 + change[n];
    start_.kinematics = copy(view(x.data(), model_.modes()));
    return period_ > 0.0;
  }

  const ContactModel& model_;
  ContactStart start_;
  double period_;
  bool free_period_;
};

}  // namespace

void start(EventDriven& run, const ContactModel& model, const ContactStart& from) {
  const ContactKinematics& state = from.kinematics;
  if (from.phase == data::ContactState::stick)
    run.start_stuck(state.amplitudes, state.rates, state.displacement);
  else
    run.start_slipping(state.amplitudes, state.rates, state.displacement,
                       state.velocity - ContactDynamics(model).wall_velocity(0.0));
}

PoincareImage poincare_map(const ContactModel& model, const ContactStart& from, double duration) {
  return image_of(model, from, duration, phases_of(model, from, duration), true, tolerance_of_state);
}

std::vector<std::complex<double>> eigenvalues(const Matrix& matrix) {
  const StatusInsteadOfAbort guard;
  const std::size_t size = matrix.rows();
  const auto work = gsl_copy_of(matrix);
  const auto values = owned(gsl_vector_complex_alloc(size));
  const auto workspace = owned(gsl_eigen_nonsymm_alloc(size));
  gsl_eigen_nonsymm_params(0, 1, workspace.get());
  require_success(gsl_eigen_nonsymm(work.get(), values.get(), workspace.get()), "eigenvalues");
  std::vector<std::complex<double>> result;
  for (std::size_t i = 0; i < size; ++i) {
    const gsl_complex value = gsl_vector_complex_get(values.get(), i);
    result.emplace_back(GSL_REAL(value), GSL_IMAG(value));
  }
  std::ranges::sort(result, std::greater(), [](std::complex<double> value) { return std::abs(value); });
  return result;
}

PeriodicSearch forced_motion(const ContactModel& model, int periods, int settle) {
  if (periods < 1) throw data::FieldError("periods", periods, "1 or more");
  const double period = 2.0 * std::numbers::pi / model.load_angular_frequency;
  EventDriven run(model, settling);
  run.start_stuck({}, {});
  std::vector<ContactStart> starts;
  std::size_t events = 0;
  for (const int earlier : {8, 4, 2, 1}) {
    run.advance_to(settle / earlier * period);  // whole periods
    events = run.events().size();
    starts.push_back(state_of(run));
  }
  run.advance_to((settle + periods) * period);
  if (starts.back().phase == data::ContactState::stick && run.events().size() == events)
    return {{}, NoMotion::sticks};
  PeriodicSearch search{{}, NoMotion::unsettled};
  for (; !starts.empty() && !search.motion; starts.pop_back())
    search.motion = Shooting(model, starts.back(), periods * period, false).run();
  return search;
}

PeriodicSearch self_excited_motion(const ContactModel& model, double settle, double sample) {
  if (model.wall_speed == 0.0) throw wrong_argument("wall_speed", 0.0, "other than 0 (m/s)");
  if (model.wall_amplitude != 0.0 || std::ranges::any_of(model.load, [](double load) { return load != 0.0; }))
    throw wrong_argument("load", model.wall_amplitude, "0: a forced motion has the period of its load");
  EventDriven run(model, settling);
  run.start_stuck({}, {});
  run.advance_to(settle);
  constexpr std::size_t most_cycles = 12;
  constexpr int most_failures = 4;  // of Newton's method: a longer motion takes it longer still
  // Of u_c_t through 0 in the direction of the wall, each with the sample behind it.
  struct Crossing {
    double time{};
    ContactStart after;
  };
  std::vector<Crossing> crossings;
  const double from = run.time();
  double before = run.contact_velocity(), largest = 0.0;
  const double direction = model.wall_speed > 0.0 ? 1.0 : -1.0;
  for (long n = 1; crossings.size() <= most_cycles && static_cast<double>(n) * sample < 0.25 * settle; ++n) {
    run.advance_to(from + static_cast<double>(n) * sample);
    const double velocity = run.contact_velocity();
    largest = std::max(largest, std::abs(velocity));
    if (direction * before < 0.0 && direction * velocity >= 0.0) {
      crossings.push_back({run.time() - sample * velocity / (velocity - before), state_of(run)});
    }
    before = velocity;
  }
  if (crossings.size() < 2 && run.state() == data::ContactState::stick) return {{}, NoMotion::sticks};
  if (largest < 1e-2 * std::abs(model.wall_speed)) return {{}, NoMotion::steady};
  int failures = 0;
  for (std::size_t cycles = 1; cycles < crossings.size() && failures < most_failures; ++cycles) {
    const ContactStart& start = crossings.front().after;
    if (start.phase == data::ContactState::stick) return {{}, NoMotion::unsettled};
    const double period = crossings[cycles].time - crossings.front().time;
    EventDriven once(model);
    analytic::start(once, model, start);
    once.advance_to(period);
    const double miss = std::abs(once.contact_displacement() - start.kinematics.displacement) +
                        sample * std::abs(once.contact_velocity() - start.kinematics.velocity);
    if (miss > 0.05 * std::abs(model.wall_speed) * period) continue;
    if (auto motion = Shooting(model, start, period, true).run()) return {motion, {}};
    ++failures;
  }
  return {{}, NoMotion::unsettled};
}

}  // namespace stickslip::analytic
