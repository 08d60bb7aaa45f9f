// SPDX-License-Identifier: MIT
#include "stickslip/analytic/modal_contact_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "arguments.hpp"
#include "separated_system.hpp"
#include "special_functions.hpp"
#include "stickslip/analytic/held_motion.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

constexpr double resolved = 2.0;  // |λ_k| h of modes that are propagated exactly

// Accelerations at rest under a load and the contact force f.
std::vector<double> accelerations(const ContactDynamics& dynamics, const LoadFactors& load, double f) {
  const std::size_t m = dynamics.modes();
  const std::vector<double> rest(2 * (m + 1));
  std::vector<double> result(m + 1);
  result[m] = dynamics.accelerate(view(rest.data(), m), load, f, std::span(result).first(m));
  return result;
}

// ∫_0^1 exp(y (1 - x)) L_j(x) dx with the parabolas L_j that are 1 in x = 0, 1/2 or 1 and 0 in the others; from the moments
// M_k = ∫ exp(y (1 - x)) x^k dx = Σ_j y^j k!/(j + k + 1)! = (k M_(k-1) - 1)/y.
std::array<Complex, 3> parabola_shares(Complex y) {
  std::array<Complex, 3> moment{};
  if (std::abs(y) < 1.0) {
    for (std::size_t k = 0; k < moment.size(); ++k) {
      Complex term = 1.0 / static_cast<double>(k + 1);
      for (int j = 1; std::abs(term) > 1e-17; ++j) {
        moment.at(k) += term;
        term *= y / static_cast<double>(static_cast<int>(k) + 1 + j);
      }
    }
  } else {
    moment[0] = (std::exp(y) - 1.0) / y;
    moment[1] = (moment[0] - 1.0) / y;
    moment[2] = (2.0 * moment[1] - 1.0) / y;
  }
  return {moment[0] - 3.0 * moment[1] + 2.0 * moment[2], 4.0 * (moment[1] - moment[2]),
          2.0 * moment[2] - moment[1]};
}

}  // namespace

ContactModes::ContactModes(const ContactModel& model) {
  require_free_mass(model);
  const ContactDynamics dynamics(model);
  const std::size_t m = model.modes();
  size_ = 2 * (m + 1);
  scale_ = model.angular_frequency;
  const double single = std::sqrt(std::abs(model.contact_stiffness) / model.contact_mass);
  scale_.push_back(m > 0 ? std::ranges::min(scale_) : single > 0.0 ? single : model.load_angular_frequency);
  const double unit = std::ranges::max(scale_);
  SeparatedSystem system = separated_system(first_order_matrix(dynamics, scale_, unit),
                                            "eigenvalues of the structure with its contact free");
  if (!(system.error <= 1e-9))  // nine digits
    throw InseparableModes(
        "a mode of the sliding beam cannot be separated from the others: it is too near to critical damping "
        "or to flutter");
  eigenvalue_ = std::move(system.eigenvalue);
  shape_ = std::move(system.shape);
  inverse_ = std::move(system.inverse);
  const std::size_t count = eigenvalue_.size();
  for (std::size_t k = 0; k < count; ++k) {
    eigenvalue_[k] *= unit;
    const Complex contact = shape_[(size_ - 1) * count + k];
    for (std::size_t i = 0; i < size_; ++i) {
      shape_[i * count + k] /= contact;
      inverse_[k * size_ + i] *= contact;
    }
  }
}

ModalContactRun::ModalContactRun(const ContactModes& modes, const ContactModel& model, int steps_per_period)
    : modes_(&modes), model_(model), period_(static_cast<std::size_t>(steps_per_period)) {
  if (steps_per_period < 4) throw wrong_argument("steps_per_period", steps_per_period, "4 or more");
  require(model.wall_speed == 0.0, "wall.speed", model.wall_speed, "0 (m/s) in fixed steps");
  const double omega = model.load_angular_frequency, angle = 2.0 * std::numbers::pi / steps_per_period;
  const double h = time_step_ = angle / omega;
  const ContactDynamics dynamics(model);
  const std::size_t half = model.modes() + 1;
  const std::vector<double> by_force = accelerations(dynamics, {}, 1.0),
                            by_sine = accelerations(dynamics, {.sine = 1.0}, 0.0),
                            by_cosine = accelerations(dynamics, {.cosine = 1.0}, 0.0);
  free_step_ = h * by_force.back();
  for (std::size_t k = 0; k < modes.eigenvalue_.size(); ++k) {
    Complex force, sine, cosine;  // g_k, and b_k of both loads
    for (std::size_t n = 0; n < half; ++n) {
      const Complex row = modes.inverse_[k * modes.size_ + half + n];
      force += row * by_force[n];
      sine += row * by_sine[n];
      cosine += row * by_cosine[n];
    }
    const Complex lambda = modes.eigenvalue_[k];
    Complex turn = std::exp(lambda * h), share = exponential_difference(lambda, 0.0, h);
    if (std::abs(lambda) * h > resolved) {
      turn = (1.0 + 0.5 * lambda * h) / (1.0 - 0.5 * lambda * h);
      share = h / (1.0 - 0.5 * lambda * h);
    }
    Block& block = k % lanes == 0 ? blocks_.emplace_back() : blocks_.back();
    const auto set = [lane = k % lanes](ComplexLanes& part, Complex value) {
      part.real[lane] = value.real();
      part.imaginary[lane] = value.imag();
    };
    set(block.turn, turn);
    set(block.input, share * force);
    weight_ += (share * force).real();
    if (!model.drive) add_load(k, sine, cosine);
  }
  if (model.drive) set_drive(motion_.emplace(model));
  for (std::size_t n = 0; n <= period_; ++n) {
    sine_.push_back(std::sin(angle * static_cast<double>(n)));
    cosine_.push_back(std::cos(angle * static_cast<double>(n)));
    offset_.push_back(-model.wall_amplitude * omega * cosine_.back());
    for (const Steady& steady : steady_)
      offset_.back() += steady.sine.real() * sine_.back() + steady.cosine.real() * cosine_.back();
  }
  set_friction();
}

void ModalContactRun::set_drive(const ContactDynamics& dynamics) {
  const std::size_t half = model_.modes() + 1;
  for (const auto factor : {&LoadFactors::sine, &LoadFactors::cosine, &LoadFactors::base}) {
    LoadFactors unit;
    unit.*factor = 1.0;
    const std::vector<double> by_load = accelerations(dynamics, unit, 0.0);
    if (std::ranges::all_of(by_load, [](double each) { return each == 0.0; })) continue;
    Channel channel{.factor = factor};
    for (auto& inputs : channel.inputs) inputs.resize(blocks_.size());
    for (std::size_t k = 0; k < modes_->eigenvalue_.size(); ++k) {
      Complex load;
      for (std::size_t n = 0; n < half; ++n)
        load += modes_->inverse_[k * modes_->size_ + half + n] * by_load[n];
      const Complex y = modes_->eigenvalue_[k] * time_step_, trapezoid = 0.5 / (1.0 - 0.5 * y);
      const auto shares =
          std::abs(y) > resolved ? std::array{trapezoid, Complex(), trapezoid} : parabola_shares(y);
      for (std::size_t j = 0; j < shares.size(); ++j) {
        const Complex input = time_step_ * shares.at(j) * load;
        channel.inputs.at(j)[k / lanes].real[k % lanes] = input.real();
        channel.inputs.at(j)[k / lanes].imaginary[k % lanes] = input.imag();
        channel.weights.at(j) += input.real();
      }
    }
    channels_.push_back(std::move(channel));
  }
}

double ModalContactRun::wall_velocity() const {
  if (!motion_) return model_.wall_amplitude * model_.load_angular_frequency * cosine_[phase_];
  motion_->enter(time());
  return motion_->wall_velocity(time());
}

void ModalContactRun::add_load(std::size_t mode, Complex sine, Complex cosine) {
  const double omega = model_.load_angular_frequency;
  const Complex lambda = modes_->eigenvalue_[mode], i{0.0, 1.0};
  const double distance = std::min(std::abs(i * omega - lambda), std::abs(i * omega + lambda));
  constexpr double resonance = 0.01;  // takes two digits of a steady part
  const bool is_resonant = distance < resonance * omega;
  const Complex plus = is_resonant ? exponential_difference(i * omega, lambda, time_step_)
                                   : 1.0 / (i * omega - lambda),
                minus = is_resonant ? exponential_difference(-i * omega, lambda, time_step_)
                                    : 1.0 / (-i * omega - lambda);
  const Complex alike = 0.5 * (plus + minus), turned = (plus - minus) / (2.0 * i);
  (is_resonant ? resonant_ : steady_)
      .push_back({mode, alike * sine - turned * cosine, turned * sine + alike * cosine});
}

void ModalContactRun::set_friction() {
  const double normal = model_.normal_force;
  const data::FrictionLaw law = model_.friction.in_slip();
  static_limit_ = model_.friction.static_coefficient() * normal;
  kinetic_force_ = law.kinetic_coefficient() * normal;
  friction_drop_ = law.static_coefficient() * normal - kinetic_force_;
  decay_ = friction_drop_ > 0.0 ? law.decay() : 0.0;
  viscous_ = law.viscous() * normal;
  if (!(weight_ > 0.0 && 0.5 * decay_ * friction_drop_ * weight_ < 1.0))
    throw data::InputError(
        "numerics.time_step is too long: a step has one solution only if (mu_s - mu_m) alpha N W is below 2, "
        "but it is " +
        data::shortest_text(decay_ * friction_drop_ * weight_));
}

void ModalContactRun::start_stuck() { start(held_start(model_)); }

void ModalContactRun::start(const ContactKinematics& state) {
  std::vector<double> y = flat(state);
  for (std::size_t n = 0; n < modes_->scale_.size(); ++n) y[n] *= modes_->scale_[n];
  for (Block& block : blocks_) block.amplitude = {};
  free_velocity_ = 0.0;
  for (std::size_t k = 0; k < modes_->eigenvalue_.size(); ++k) {
    Complex z;
    for (std::size_t i = 0; i < y.size(); ++i) z += modes_->inverse_[k * modes_->size_ + i] * y[i];
    free_velocity_ += add(k, z);
  }
  for (const Steady& steady : steady_) free_velocity_ += add(steady.mode, -steady.cosine);
  steps_ = phase_ = 0;
  friction_force_ = force_before_ = change_ = change_before_ = 0.0;
  const double wall = wall_velocity();
  sliding_velocity_ = state.velocity - wall;
  if (std::abs(sliding_velocity_) <= 4.0 * std::numeric_limits<double>::epsilon() * std::abs(wall))
    sliding_velocity_ = 0.0;
  slips_ = sliding_velocity_ != 0.0;
  add_load();
}

// To the end of the step, with the force that acts on the contact in it.
void ModalContactRun::advance(double force) {
  std::array<double, lanes> sums{};
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    const ComplexLanes turn = block.turn, input = block.input, z = block.amplitude;
    ComplexLanes next;
    for (std::size_t l = 0; l < lanes; ++l)
      next.real[l] = turn.real[l] * z.real[l] - turn.imaginary[l] * z.imaginary[l] + input.real[l] * force;
    for (std::size_t l = 0; l < lanes; ++l)
      next.imaginary[l] =
          turn.real[l] * z.imaginary[l] + turn.imaginary[l] * z.real[l] + input.imaginary[l] * force;
    for (const Channel& channel : channels_)
      for (std::size_t j = 0; j < channel.values.size(); ++j) {
        const ComplexLanes& by = channel.inputs[j][b];
        const double value = channel.values[j];
        for (std::size_t l = 0; l < lanes; ++l) next.real[l] += by.real[l] * value;
        for (std::size_t l = 0; l < lanes; ++l) next.imaginary[l] += by.imaginary[l] * value;
      }
    for (std::size_t l = 0; l < lanes; ++l)
      sums[l] += turn.real[l] * next.real[l] - turn.imaginary[l] * next.imaginary[l];
    block.amplitude = next;
  }
  free_velocity_ = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  for (const Steady& at : resonant_)
    free_velocity_ += add(at.mode, at.sine * sine_[phase_] + at.cosine * cosine_[phase_]);
  ++steps_;
  if (++phase_ == period_) phase_ = 0;
  add_load();
}

// Adds to an amplitude, and returns what that adds to the free velocity of the next step.
double ModalContactRun::add(std::size_t mode, Complex value) {
  Block& block = blocks_[mode / lanes];
  const std::size_t l = mode % lanes;
  block.amplitude.real[l] += value.real();
  block.amplitude.imaginary[l] += value.imag();
  return block.turn.real[l] * value.real() - block.turn.imaginary[l] * value.imag();
}

// The values of the next step, and what they add to its free velocity.
void ModalContactRun::add_drive() {
  const double begin = time(), middle = begin + 0.5 * time_step_, end = begin + time_step_;
  const std::array<double, 3> times{begin, middle, end};
  for (std::size_t j = 0; j < times.size(); ++j) {
    if (j == 0 || times.at(j) > motion_->piece_end()) motion_->enter(times.at(j));
    const LoadFactors load = motion_->load(times.at(j));
    for (Channel& channel : channels_) {
      channel.values.at(j) = load.*channel.factor;
      free_velocity_ += channel.weights.at(j) * channel.values.at(j);
    }
  }
  free_velocity_ -= motion_->wall_velocity(end);
}

// What does not depend on the amplitudes.
void ModalContactRun::add_load() {
  if (motion_) {
    free_velocity_ += weight_ * model_.contact_force;
    add_drive();
    return;
  }
  free_velocity_ += offset_[phase_ + 1] + weight_ * model_.contact_force;
  for (const Steady& at : resonant_)
    free_velocity_ += at.sine.real() * sine_[phase_] + at.cosine.real() * cosine_[phase_];
}

// Next to a value that is known, by the series of the exponential function, to round-off.
double ModalContactRun::falling_force(double speed) {
  if (friction_drop_ == 0.0) return 0.0;
  const double x = decay_ * (known_speed_ - speed);
  constexpr double short_enough = 1e-2;
  if (known_force_ > 0.0 && std::abs(x) < short_enough)
    return known_force_ *
           (1.0 + x * (1.0 + x * (1.0 / 2.0 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0))))));
  known_speed_ = speed;
  return known_force_ = friction_drop_ * std::exp(-decay_ * speed);
}

struct ModalContactRun::Slip {
  double speed{}, force{};
};

// The V with V + W N μ((V + V_0)/2) = P, by Newton's method on a convex, rising function, from an expected force.
ModalContactRun::Slip ModalContactRun::slip(double free_speed, double speed_before, double expected_force) {
  constexpr int most_iterations = 50;
  double speed = std::max(free_speed - weight_ * expected_force, 0.0), force = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double mean = 0.5 * (speed + speed_before);
    const double exponential = falling_force(mean);
    const double slope = 0.5 * (viscous_ - decay_ * exponential);
    force = kinetic_force_ + exponential + viscous_ * mean;
    const double change = (free_speed - speed - weight_ * force) / (1.0 + weight_ * slope);
    speed += change;
    force += slope * change;
    // What is left is below decay² change²/8 of the falling part, 1.25e-9.
    if (decay_ * std::abs(change) < 1e-4) break;
  }
  return {speed, force};
}

// A sliding velocity that would go on to `further`, which is not in its direction. It passes zero after a share of the step, from
// which on friction acts the other way, if that does not hold the contact.
bool ModalContactRun::turns_round(double free_velocity, double further) {
  if (std::abs(free_velocity - sliding_velocity_) <= weight_ * static_limit_) return false;
  may_hide_stick_ =
      std::abs(change_) - std::abs(change_ - change_before_) <= 2.0 * static_limit_ * free_step_;
  const double direction = std::copysign(1.0, sliding_velocity_), speed = std::abs(sliding_velocity_);
  const double share = speed / (speed - further);
  friction_force_ = -direction * (2.0 * share - 1.0) * (kinetic_force_ + friction_drop_);
  force_before_ = std::abs(friction_force_);
  sliding_velocity_ = free_velocity + weight_ * friction_force_;
  return true;
}

void ModalContactRun::update_contact(double free_velocity) {
  if (slips_ && sliding_velocity_ != 0.0) {
    const double direction = std::copysign(1.0, sliding_velocity_);
    const double force = std::abs(friction_force_);
    const Slip on = slip(direction * free_velocity, std::abs(sliding_velocity_), 2.0 * force - force_before_);
    if (on.speed > 0.0) {
      force_before_ = force;
      sliding_velocity_ = direction * on.speed;
      friction_force_ = -direction * on.force;
      return;
    }
    if (turns_round(free_velocity, on.speed)) return;
  }
  slips_ = std::abs(free_velocity) > weight_ * static_limit_;
  if (!slips_) {
    sliding_velocity_ = 0.0;
    friction_force_ = -free_velocity / weight_;
    return;
  }
  const double direction = std::copysign(1.0, free_velocity);
  const Slip away = slip(std::abs(free_velocity), 0.0, static_limit_);
  sliding_velocity_ = direction * away.speed;
  friction_force_ = -direction * away.force;
  force_before_ = static_limit_;
}

void ModalContactRun::step() {
  const double before = sliding_velocity_;
  may_hide_stick_ = false;
  update_contact(free_velocity_);
  change_before_ = change_;
  change_ = sliding_velocity_ - before;
  advance(friction_force_ + model_.contact_force);
}

std::vector<Complex> ModalContactRun::amplitudes() const {
  std::vector<Complex> values(modes_->eigenvalue_.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = {blocks_[k / lanes].amplitude.real[k % lanes],
                 blocks_[k / lanes].amplitude.imaginary[k % lanes]};
  const std::size_t n = phase_;
  for (const Steady& steady : steady_)
    values[steady.mode] += steady.sine * sine_[n] + steady.cosine * cosine_[n];
  return values;
}

ContactKinematics ModalContactRun::state() const {
  const std::vector<Complex> z = amplitudes();
  std::vector<double> y(modes_->size_);
  for (std::size_t k = 0; k < z.size(); ++k)
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += (modes_->shape_[i * z.size() + k] * z[k]).real();
  for (std::size_t n = 0; n < modes_->scale_.size(); ++n) y[n] /= modes_->scale_[n];
  ContactKinematics state = copy(view(y.data(), model_.modes()));
  state.velocity = sliding_velocity_ + wall_velocity();  // in stick exactly that of the wall
  return state;
}

double ModalContactRun::contact_position() const {
  const std::size_t m = model_.modes();
  const std::vector<Complex> z = amplitudes();
  double position = 0.0;
  for (std::size_t k = 0; k < z.size(); ++k) position += (modes_->shape_[m * z.size() + k] * z[k]).real();
  position /= modes_->scale_[m];
  if (!motion_) return position - model_.wall_amplitude * sine_[phase_];
  motion_->enter(time());
  return position - motion_->wall_displacement(time());
}

}  // namespace stickslip::analytic
