// SPDX-License-Identifier: MIT
#include "slip_integrator.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "arguments.hpp"
#include "friction_in_slip.hpp"
#include "root_finding.hpp"

namespace stickslip::analytic {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr std::size_t kWorks = 4;

/// The quintic through value, rate and second rate at both ends of a step, as Bernstein coefficients on 0
/// ... 1.
class Quintic {
 public:
  Quintic(const std::array<double, 3>& left, const std::array<double, 3>& right, double length)
      : coefficients_{left[0],
                      left[0] + 0.2 * length * left[1],
                      left[0] + 0.4 * length * left[1] + 0.05 * length * length * left[2],
                      right[0] - 0.4 * length * right[1] + 0.05 * length * length * right[2],
                      right[0] - 0.2 * length * right[1],
                      right[0]} {}

  [[nodiscard]] double value(double x) const {
    std::array<double, 6> b = coefficients_;
    for (std::size_t level = 5; level > 0; --level)
      for (std::size_t i = 0; i < level; ++i) b[i] += x * (b[i + 1] - b[i]);
    return b[0];
  }

  /// The polynomial lies above this on 0 ... 1.
  [[nodiscard]] double lower_bound() const { return *std::ranges::min_element(coefficients_); }

 private:
  std::array<double, 6> coefficients_;
};

}  // namespace

enum class SlipIntegrator::Passage { clear, crossing, doubtful };

SlipIntegrator::SlipIntegrator(const ContactDynamics& dynamics, double tolerance, double reference_velocity,
                               bool keep_energy_balance)
    : dynamics_(dynamics),
      size_(dynamics.modes() + 1),
      dimension_(2 * size_),
      equations_(dimension_ + (keep_energy_balance ? kWorks : 0)),
      velocity_floor_(64.0 * kEpsilon * reference_velocity),
      law_(dynamics.model().friction.in_slip()),
      system_{&SlipIntegrator::right_side, nullptr, equations_, this},
      error_(equations_),
      jerk_(size_) {
  const double omega = dynamics.model().load_angular_frequency;
  // The eighth power of a step is in its error.
  longest_step_ = std::clamp(std::pow(tolerance / 1e-12, 0.125), 1.0, 3.0) / dynamics.fastest();
  shortest_step_ = 1e-6 * longest_step_;
  const std::vector<double> at_rest(dimension_);
  accelerate(at_rest.data(), {}, 1.0, jerk_);
  mobility_ = jerk_.back();

  const double contact_mass = dynamics.model().contact_mass;
  std::vector<double> scale(equations_, contact_mass * reference_velocity * reference_velocity);
  for (std::size_t i = 0; i < size_; ++i) {
    // A rate of T_n is a velocity times the root of a mass, that of u_c a velocity.
    scale[size_ + i] = reference_velocity * (i < dynamics.modes() ? std::sqrt(contact_mass) : 1.0);
    scale[i] = scale[size_ + i] / omega;
  }
  stepper_.reset(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, equations_));
  control_.reset(gsl_odeiv2_control_scaled_new(tolerance, tolerance, 1.0, 0.0, scale.data(), equations_));
}

void SlipIntegrator::begin(double t, const ContactKinematics& state, double direction) {
  end_.time = t;
  end_.y = flat(state);
  end_.y.resize(equations_);
  begin_at_end(direction);
}

void SlipIntegrator::begin_next(double direction) {
  std::fill(end_.y.begin() + static_cast<std::ptrdiff_t>(dimension_), end_.y.end(), 0.0);
  begin_at_end(direction);
}

void SlipIntegrator::begin_at_end(double direction) {
  direction_ = direction;
  end_.rate.resize(equations_);
  evaluate(end_.time, end_.y.data(), end_.rate.data());
  measure(end_);
  begin_ = end_;
  before_.reset();
  length_ = 0.05 * longest_step_;
}

void SlipIntegrator::go_on() {
  evaluate(end_.time, end_.y.data(), end_.rate.data());
  measure(end_);
}

bool SlipIntegrator::step(double until) {
  const StatusInsteadOfAbort guard;
  if (end_.time > begin_.time) before_ = std::move(begin_);
  begin_ = end_;
  const double wanted = length_;
  for (;;) {
    length_ = std::min({length_, longest_step_, until - begin_.time});
    // A length that the clock can represent.
    length_ = (begin_.time + length_) - begin_.time;
    if (!(length_ > 0.0))
      throw std::runtime_error(
          "the slip phase cannot be continued at t = " + data::shortest_text(begin_.time) + " s.");
    if (!take(begin_, length_, trial_)) {
      length_ *= 0.25;
      continue;
    }
    double suggested = length_;
    const int change = gsl_odeiv2_control_hadjust(control_.get(), stepper_.get(), trial_.y.data(),
                                                  error_.data(), trial_.rate.data(), &suggested);
    if (change == GSL_ODEIV_HADJ_DEC && suggested < length_) {
      length_ = suggested;
      continue;
    }
    double low = 0.0, high = length_;
    const Passage found = passage(trial_, low, high);
    if (found == Passage::clear || (found == Passage::doubtful && length_ <= shortest_step_)) {
      std::swap(end_, trial_);
      length_ = std::max(suggested, begin_.time + length_ == until ? wanted : 0.0);
      return false;
    }
    if (found == Passage::crossing) {
      if (const auto zero = polished_zero(low, high)) {
        if (!take(begin_, *zero, trial_)) throw std::runtime_error("a located event is not finite.");
        std::swap(end_, trial_);
        return true;
      }
      if (length_ <= shortest_step_) {
        std::swap(end_, trial_);
        return true;
      }
    }
    length_ *= 0.5;
  }
}

SlipIntegrator::Sample SlipIntegrator::at(double t) {
  const bool at_end = t == end_.time;
  if (!at_end && !take(begin_, t - begin_.time, trial_))
    throw std::runtime_error("the state at t = " + data::shortest_text(t) + " s is not finite.");
  const std::vector<double>& y = at_end ? end_.y : trial_.y;
  return {copy(view(y.data(), dynamics_.modes())), works_of(y)};
}

Powers SlipIntegrator::works_of(const std::vector<double>& y) const {
  if (equations_ == dimension_) return {};
  const double* works = y.data() + dimension_;
  return {works[0], works[1], works[2], works[3]};
}

double SlipIntegrator::friction_force(double sliding_velocity) const {
  return -direction_ *
         slip_resistance(law_, dynamics_.model().normal_force, direction_ * sliding_velocity).force;
}

int SlipIntegrator::right_side(double t, const double y[], double rate[], void* self) {
  static_cast<const SlipIntegrator*>(self)->evaluate(t, y, rate);
  return GSL_SUCCESS;
}

void SlipIntegrator::accelerate(const double* y, const LoadFactors& load, double f,
                                std::span<double> result) const {
  result.back() = dynamics_.accelerate(view(y, dynamics_.modes()), load, f, result.first(dynamics_.modes()));
}

double SlipIntegrator::holding_force() const {
  accelerate(end_.y.data(), dynamics_.load(end_.time), dynamics_.model().contact_force, jerk_);
  return (dynamics_.wall_acceleration(end_.time) - jerk_.back()) / mobility_;
}

void SlipIntegrator::evaluate(double t, const double* y, double* rate) const {
  const KinematicsView state = view(y, dynamics_.modes());
  const double force = friction_force(state.velocity - dynamics_.wall_velocity(t));
  std::copy_n(y + size_, size_, rate);
  accelerate(y, dynamics_.load(t), force + dynamics_.model().contact_force, {rate + size_, size_});
  if (equations_ == dimension_) return;
  const Powers powers = dynamics_.powers(state, t, force);
  rate[dimension_] = powers.base;
  rate[dimension_ + 1] = powers.follower;
  rate[dimension_ + 2] = powers.damping;
  rate[dimension_ + 3] = powers.friction;
}

// v_s and its first two rates; the rows are linear, so that the rate of the accelerations follows from the
// rates of their arguments.
void SlipIntegrator::measure(Node& node) const {
  const double sliding = node.y[dimension_ - 1] - dynamics_.wall_velocity(node.time);
  const double acceleration = node.rate[dimension_ - 1] - dynamics_.wall_acceleration(node.time);
  const double force_rate =
      -slip_resistance(law_, dynamics_.model().normal_force, direction_ * sliding).slope * acceleration;
  accelerate(node.rate.data(), dynamics_.load_rate(node.time), force_rate, jerk_);
  node.velocity = {direction_ * sliding, direction_ * acceleration,
                   direction_ * (jerk_.back() - dynamics_.wall_jerk(node.time))};
}

bool SlipIntegrator::take(const Node& from, double length, Node& to) {
  to.time = from.time + length;
  to.y = from.y;
  to.rate.resize(equations_);
  const int status = gsl_odeiv2_step_apply(stepper_.get(), from.time, length, to.y.data(), error_.data(),
                                           from.rate.data(), to.rate.data(), &system_);
  const bool finite = std::ranges::all_of(to.y, [](double value) { return std::isfinite(value); });
  if (status != GSL_SUCCESS || !finite) return false;
  measure(to);
  return true;
}

// h⁶/46080 max|v_s^(6)| over the step begin_ ... next. The quintic from before_ to next is off by
// max|v_s^(6)|/720 (h1 h2)³ at begin_.
double SlipIntegrator::interpolation_error(const Node& next) const {
  // A phase begins at v_s = 0: there the bound is zero up to round-off.
  if (!before_) return -velocity_floor_;
  const double first = begin_.time - before_->time, second = next.time - begin_.time;
  const Quintic across(before_->velocity, next.velocity, first + second);
  const double miss = std::abs(across.value(first / (first + second)) - begin_.velocity[0]);
  constexpr double safety = 4.0;
  return std::max(velocity_floor_, safety * miss * 720.0 / 46080.0 * std::pow(second / first, 3));
}

SlipIntegrator::Passage SlipIntegrator::passage(const Node& next, double& low, double& high) const {
  const double length = next.time - begin_.time;
  const Quintic quintic(begin_.velocity, next.velocity, length);
  const double error = interpolation_error(next);
  const bool ends_forward = next.velocity[0] > 0.0;
  if (ends_forward && quintic.lower_bound() > error) return Passage::clear;
  constexpr int samples = 64;
  for (int i = 1; i <= samples; ++i) {
    const double x = static_cast<double>(i) / samples;
    const bool crossed = i == samples ? !ends_forward : quintic.value(x) <= -std::abs(error);
    if (!crossed) continue;
    low = length * (i - 1) / samples;
    high = length * x;
    return Passage::crossing;
  }
  return Passage::doubtful;
}

std::optional<double> SlipIntegrator::polished_zero(double low, double high) {
  const auto forward_velocity = [&](double length) {
    if (length == 0.0) return begin_.velocity[0];
    if (!take(begin_, length, trial_)) throw std::runtime_error("a trial state is not finite.");
    return trial_.velocity[0];
  };
  if (!(forward_velocity(low) > 0.0) || forward_velocity(high) > 0.0) return std::nullopt;
  return brent_root(as_gsl_function(forward_velocity), {low, high}, 4.0 * kEpsilon);
}

}  // namespace stickslip::analytic
