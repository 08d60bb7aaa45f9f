// SPDX-License-Identifier: MIT
#include "stickslip/analytic/contact_dynamics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "arguments.hpp"

namespace stickslip::analytic {
namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void require_size(std::size_t size, std::size_t expected, const char* name) {
  if (size == expected) return;
  throw wrong_argument(std::string("the size of ") + name, static_cast<double>(size),
                       std::to_string(expected));
}

void require_finite(std::span<const double> values, const char* name) {
  for (const double value : values) require(std::isfinite(value), name, value, "finite");
}

}  // namespace

ContactKinematics copy(const KinematicsView& state) {
  return {{state.amplitudes.begin(), state.amplitudes.end()},
          {state.rates.begin(), state.rates.end()},
          state.displacement,
          state.velocity};
}

std::vector<double> flat(const ContactKinematics& state) {
  std::vector<double> x(state.amplitudes);
  x.push_back(state.displacement);
  x.insert(x.end(), state.rates.begin(), state.rates.end());
  x.push_back(state.velocity);
  return x;
}

double HeldStructure::free_mass() const noexcept {
  constexpr double rounding = 1e-13;
  const double mass = contact_mass - dot(mass_coupling, mass_coupling);
  return std::abs(mass) <= rounding * contact_mass ? 0.0 : mass;
}

bool HeldStructure::is_uncoupled() const noexcept {
  for (std::size_t n = 0; n < modes() && !damping.empty(); ++n)
    for (std::size_t k = 0; k < modes(); ++k)
      if (n != k && damping(n, k) != 0.0) return false;
  return true;
}

void require_free_mass(const HeldStructure& structure) {
  if (structure.free_mass() > 0.0) return;
  throw data::FieldError("model.mass_matrix", "0 at the contact",
                         "above 0 there for this; methods in time steps (fe, boundary-integral) do without");
}

void require_consistent(const ContactModel& model) {
  const std::size_t m = model.modes();
  for (const double omega : model.angular_frequency)
    require(std::isfinite(omega) && omega > 0.0, "angular_frequency", omega, "above 0 (rad/s)");
  require_size(model.mass_coupling.size(), m, "mass_coupling");
  require_size(model.follower.size(), m, "follower");
  require_size(model.load.size(), m + 1, "load");
  if (!model.load_cosine.empty()) require_size(model.load_cosine.size(), m + 1, "load_cosine");
  if (!model.damping.empty()) {
    require_size(model.damping.rows(), m + 1, "damping's columns");
    require_size(model.damping.columns(), m + 1, "damping's rows");
  }
  for (const auto& [values, name] : {std::pair{std::span(model.follower), "follower"},
                                     {std::span(model.load), "load"},
                                     {std::span(model.load_cosine), "load_cosine"},
                                     {std::span(model.damping.values()), "damping"},
                                     {std::span(&model.contact_stiffness, 1), "contact_stiffness"},
                                     {std::span(&model.contact_follower, 1), "contact_follower"},
                                     {std::span(&model.contact_force, 1), "contact_force"},
                                     {std::span(&model.wall_amplitude, 1), "wall_amplitude"},
                                     {std::span(&model.wall_speed, 1), "wall_speed"}})
    require_finite(values, name);
  const double free_mass = model.free_mass();
  require(std::isfinite(free_mass) && free_mass >= 0.0, "contact_mass - mass_coupling . mass_coupling",
          free_mass, "0 or more (kg)");
  const double omega = model.load_angular_frequency;
  require(std::isfinite(omega) && omega > 0.0, "load_angular_frequency", omega, "above 0 (rad/s)");
  require(std::isfinite(model.normal_force) && model.normal_force >= 0.0, "normal_force", model.normal_force,
          "0 or more (N)");
}

ContactDynamics::ContactDynamics(const ContactModel& model) : model_(model) {
  require_consistent(model_);
  free_mass_ = model_.free_mass();
  if (model_.drive) {
    cursor_.emplace(*model_.drive);
    take_piece();
  }
  if (model_.damping.empty()) return;
  const std::size_t rows = modes() + 1;
  column_length_ = (rows + kTogether - 1) / kTogether * kTogether;
  damping_columns_.resize(rows * column_length_);
  for (std::size_t n = 0; n < rows; ++n)
    for (std::size_t k = 0; k < rows; ++k) damping_columns_[k * column_length_ + n] = model_.damping(n, k);
}

double ContactDynamics::fastest() const {
  double fastest = model_.load_angular_frequency;
  for (const double omega : model_.angular_frequency) fastest = std::max(fastest, omega);
  return fastest;
}

void ContactDynamics::enter(double t) const {
  if (!cursor_ || (t >= piece().begin && t < piece().end)) return;
  cursor_->enter(t);
  take_piece();
}

void ContactDynamics::take_piece() const {
  base_[0] = piece().base;
  wall_[0] = piece().wall;
  for (std::size_t k = 1; k < base_.size(); ++k) {
    base_[k] = derivative(base_[k - 1]);
    wall_[k] = derivative(wall_[k - 1]);
  }
}

double ContactDynamics::piece_end() const {
  return cursor_ && !piece().is_last ? piece().end : std::numeric_limits<double>::infinity();
}

double ContactDynamics::along_wall(int rate, double t) const {
  return value(wall_[static_cast<std::size_t>(rate)], t - piece().begin);
}

double ContactDynamics::base_displacement(double t) const {
  if (!cursor_) return model_.base_amplitude * load(t).sine;
  return model_.drive->base_moves() ? value(base_[0], t - piece().begin) : 0.0;
}

double ContactDynamics::base_velocity(double t) const {
  if (!cursor_) return model_.base_amplitude * load_rate(t).sine;
  return model_.drive->base_moves() ? value(base_[1], t - piece().begin) : 0.0;
}

double ContactDynamics::base_acceleration(double t) const {
  if (!cursor_) return -std::pow(model_.load_angular_frequency, 2) * base_displacement(t);
  return model_.drive->base_moves() ? value(base_[2], t - piece().begin) : 0.0;
}

LoadFactors ContactDynamics::load(double t) const {
  if (cursor_) {
    const double tau = t - piece().begin;
    return {value(base_[2], tau), value(base_[1], tau), value(base_[0], tau)};
  }
  return {std::sin(model_.load_angular_frequency * t), std::cos(model_.load_angular_frequency * t)};
}

LoadFactors ContactDynamics::load_rate(double t) const {
  if (cursor_) {
    const double tau = t - piece().begin;
    return {value(base_[3], tau), value(base_[2], tau), value(base_[1], tau)};
  }
  const double omega = model_.load_angular_frequency;
  return {omega * std::cos(omega * t), -omega * std::sin(omega * t)};
}

double ContactDynamics::wall_displacement(double t) const {
  if (cursor_) return along_wall(0, t);
  return model_.wall_amplitude * load(t).sine + model_.wall_speed * t;
}

double ContactDynamics::wall_velocity(double t) const {
  if (cursor_) return along_wall(1, t);
  if (model_.wall_amplitude == 0.0) return model_.wall_speed;
  return model_.wall_amplitude * load_rate(t).sine + model_.wall_speed;
}

double ContactDynamics::wall_acceleration(double t) const {
  if (cursor_) return along_wall(2, t);
  return -std::pow(model_.load_angular_frequency, 2) * (model_.wall_amplitude * load(t).sine);
}

double ContactDynamics::wall_jerk(double t) const {
  if (cursor_) return along_wall(3, t);
  return -std::pow(model_.load_angular_frequency, 2) * (model_.wall_amplitude * load_rate(t).sine);
}

double ContactDynamics::push(const KinematicsView& state, const LoadFactors& load, double f,
                             std::span<double> modal) const {
  const std::size_t m = modes();
  double contact = model_.load[m] * load.sine + model_.base_load * load.base + f -
                   held_stiffness() * state.displacement - dot(model_.follower, state.amplitudes);
  for (std::size_t n = 0; n < m; ++n) {
    const double omega = model_.angular_frequency[n];
    modal[n] = model_.load[n] * load.sine - omega * omega * state.amplitudes[n];
  }
  if (!model_.load_cosine.empty())
    for (std::size_t n = 0; n <= m; ++n) (n < m ? modal[n] : contact) += model_.load_cosine[n] * load.cosine;
  if (!model_.damping.empty()) {
    // Four rows at a time, whose sums do not wait for each other; each adds up as a dot product does.
    for (std::size_t n = 0; n <= m; n += kTogether) {
      const std::size_t rows = std::min(kTogether, m + 1 - n);
      std::array<double, kTogether> loss{};
      const double* column = &damping_columns_[n];
      for (std::size_t k = 0; k <= m; ++k, column += column_length_) {
        const double velocity = k < m ? state.rates[k] : state.velocity;
        for (std::size_t i = 0; i < kTogether; ++i) loss[i] += column[i] * velocity;
      }
      for (std::size_t i = 0; i < rows; ++i) (n + i < m ? modal[n + i] : contact) -= loss[i];
    }
  }
  return contact - dot(model_.mass_coupling, modal);
}

double ContactDynamics::accelerate(const KinematicsView& state, const LoadFactors& load, double f,
                                   std::span<double> modal) const {
  const double acceleration = push(state, load, f, modal) / free_mass_;
  for (std::size_t n = 0; n < modes(); ++n) modal[n] -= model_.mass_coupling[n] * acceleration;
  return acceleration;
}

double ContactDynamics::holding_force(const KinematicsView& state, double t) const {
  std::vector<double> modal(modes());
  return free_mass_ * wall_acceleration(t) - push(state, load(t), model_.contact_force, modal);
}

ContactDynamics::Reactions ContactDynamics::reactions(const KinematicsView& state, double t,
                                                      double friction_force) const {
  const std::size_t m = modes();
  const LoadFactors factors = load(t);
  const double f = friction_force + model_.contact_force;
  std::vector<double> modal(m);
  const double contact = accelerate(state, factors, f, modal);
  Reactions result{.contact_acceleration = contact + base_acceleration(t)};
  for (const BaseBalance& balance : model_.base_balances) {
    const std::span acceleration(balance.acceleration), drag(balance.drag);
    double sum = dot(acceleration.first(m), modal) + acceleration[m] * contact +
                 balance.stiffness * state.displacement + balance.base[0] * factors.sine +
                 balance.base[1] * factors.cosine + balance.base[2] * factors.base +
                 balance.lever * (dot(model_.follower, state.amplitudes) +
                                  model_.contact_follower * state.displacement - f);
    if (!drag.empty()) sum += dot(drag.first(m), state.rates) + drag[m] * state.velocity;
    result.base.push_back(sum);
  }
  return result;
}

Powers ContactDynamics::powers(const KinematicsView& state, double t, double friction_force) const {
  const std::size_t m = modes();
  Powers powers;
  const LoadFactors factors = load(t);
  powers.base =
      factors.sine * (dot(std::span(model_.load).first(m), state.rates) + model_.load[m] * state.velocity) +
      model_.contact_force * state.velocity + friction_force * wall_velocity(t);
  if (!model_.load_cosine.empty())
    powers.base += factors.cosine * (dot(std::span(model_.load_cosine).first(m), state.rates) +
                                     model_.load_cosine[m] * state.velocity);
  powers.base += factors.base * model_.base_load * state.velocity;
  powers.follower = -state.velocity *
                    (dot(model_.follower, state.amplitudes) + model_.contact_follower * state.displacement);
  powers.friction = -friction_force * (state.velocity - wall_velocity(t));
  if (model_.damping.empty()) return powers;
  for (std::size_t n = 0; n <= m; ++n) {
    const std::span row(&model_.damping(n, 0), m + 1);
    powers.damping += (n < m ? state.rates[n] : state.velocity) *
                      (dot(row.first(m), state.rates) + row[m] * state.velocity);
  }
  return powers;
}

double ContactDynamics::kinetic_energy(const KinematicsView& state) const {
  return 0.5 * (dot(state.rates, state.rates) + model_.contact_mass * state.velocity * state.velocity) +
         state.velocity * dot(model_.mass_coupling, state.rates);
}

double ContactDynamics::potential_energy(const KinematicsView& state) const {
  double twice = model_.contact_stiffness * state.displacement * state.displacement;
  for (std::size_t n = 0; n < modes(); ++n)
    twice += std::pow(model_.angular_frequency[n] * state.amplitudes[n], 2);
  return 0.5 * twice;
}

Harmonic ContactDynamics::held_load(std::size_t mode) const {
  const double omega = model_.load_angular_frequency, wall = model_.wall_amplitude;
  return {.sine = model_.load[mode] + model_.mass_coupling[mode] * omega * omega * wall,
          .cosine = load_cosine(mode) - damping(mode, modes()) * omega * wall,
          .constant = -damping(mode, modes()) * model_.wall_speed};
}

std::vector<double> ContactDynamics::held_force_row() const {
  const std::size_t m = modes();
  std::vector<double> row(2 * m);
  for (std::size_t n = 0; n < m; ++n) {
    const double omega = model_.angular_frequency[n];
    row[n] = model_.follower[n] - model_.mass_coupling[n] * omega * omega;
    row[m + n] = damping(m, n);
    for (std::size_t k = 0; k < m; ++k) row[m + n] -= model_.mass_coupling[k] * damping(k, n);
  }
  return row;
}

Harmonic ContactDynamics::held_force() const {
  const std::size_t m = modes();
  const double omega = model_.load_angular_frequency, wall = model_.wall_amplitude;
  double damping_at_contact = damping(m, m);
  double cosine = -load_cosine(m);
  for (std::size_t k = 0; k < m; ++k) {
    damping_at_contact -= model_.mass_coupling[k] * damping(k, m);
    cosine += model_.mass_coupling[k] * load_cosine(k);
  }
  const double load = dot(model_.mass_coupling, std::span(model_.load).first(m)) - model_.load[m];
  return {.sine = (held_stiffness() - free_mass_ * omega * omega) * wall + load,
          .cosine = damping_at_contact * omega * wall + cosine,
          .constant = damping_at_contact * model_.wall_speed,
          .rate = held_stiffness() * model_.wall_speed};
}

}  // namespace stickslip::analytic
