// SPDX-License-Identifier: MIT
#include "stickslip/analytic/stick_propagator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include "root_finding.hpp"
#include "separated_system.hpp"
#include "special_functions.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// A of y_t = unit A y, y = (ω_n T_n, T_n_t).
Matrix held_matrix(const ContactModel& model, double unit) {
  const std::size_t m = model.modes();
  Matrix matrix(2 * m, 2 * m);
  for (std::size_t n = 0; n < m; ++n) {
    matrix(n, m + n) = model.angular_frequency[n] / unit;
    matrix(m + n, n) = -model.angular_frequency[n] / unit;
    for (std::size_t k = 0; k < m; ++k) matrix(m + n, m + k) = -model.damping(n, k) / unit;
  }
  return matrix;
}

// Next to critical damping the vibration of one mode loses digits.
bool is_lightly_damped(const ContactModel& model) {
  constexpr double most = 1.9;  // times ω_n; critical is 2
  for (std::size_t n = 0; n < model.modes() && !model.damping.empty(); ++n)
    if (model.damping(n, n) > most * model.angular_frequency[n]) return false;
  return true;
}

// What z_k adds to f_d, with ContactDynamics::held_force_row().
Complex force_weight(const ContactModel& model, const std::vector<double>& row,
                     const std::vector<Complex>& shape, std::size_t k) {
  const std::size_t m = model.modes(), count = shape.size() / (2 * m);
  Complex weight;
  for (std::size_t n = 0; n < m; ++n)
    weight +=
        row[n] / model.angular_frequency[n] * shape[n * count + k] + row[m + n] * shape[(m + n) * count + k];
  return weight;
}

}  // namespace

StickPropagator::StickPropagator(const ContactDynamics& dynamics)
    : dynamics_(dynamics), omega_(dynamics.model().load_angular_frequency) {
  const ContactModel& model = dynamics.model();
  model.is_uncoupled() && is_lightly_damped(model) ? set_uncoupled() : set_damped();
  dynamics.model().drive ? set_drive() : set_forcing();
  next_length_ = 0.01 / omega_;
}

// Each mode for itself: (ω T, T_t) = Re[(1, λ/ω) z] with λ = -c/2 + i ν.
void StickPropagator::set_uncoupled() {
  const std::size_t m = dynamics_.modes();
  const Matrix& damping = dynamics_.model().damping;
  shape_.assign(2 * m * m, 0.0);
  inverse_.assign(2 * m * m, 0.0);
  for (std::size_t n = 0; n < m; ++n) {
    const double omega = dynamics_.model().angular_frequency[n];
    const double decay = damping.empty() ? 0.0 : 0.5 * damping(n, n);
    const double turn = std::sqrt((omega - decay) * (omega + decay));  // ν
    eigenvalue_.emplace_back(-decay, turn);
    shape_[n * m + n] = 1.0;
    shape_[(m + n) * m + n] = eigenvalue_.back() / omega;
    inverse_[n * 2 * m + n] = Complex(1.0, -decay / turn);
    inverse_[n * 2 * m + m + n] = Complex(0.0, -omega / turn);
  }
}

void StickPropagator::set_damped() {
  const double unit = std::ranges::max(dynamics_.model().angular_frequency);
  SeparatedSystem modes =
      separated_system(held_matrix(dynamics_.model(), unit), "eigenvalues of the damped, held structure");
  if (!(modes.error <= 1e-9))  // nine digits
    throw std::runtime_error("a mode of the held structure is too nearly critically damped to be separated.");
  eigenvalue_ = std::move(modes.eigenvalue);
  shape_ = std::move(modes.shape);
  inverse_ = std::move(modes.inverse);
  for (Complex& value : eigenvalue_) value *= unit;
}

void StickPropagator::set_forcing() {
  const std::size_t m = dynamics_.modes(), count = eigenvalue_.size();
  const std::vector<double> row = dynamics_.held_force_row();
  force_harmonic_ = dynamics_.held_force();
  least_bend_ = omega_ * omega_ * std::hypot(force_harmonic_.sine, force_harmonic_.cosine);
  for (std::size_t k = 0; k < count; ++k) {
    const Complex weight = force_weight(dynamics_.model(), row, shape_, k);
    Complex sine, cosine, constant;
    for (std::size_t n = 0; n < m; ++n) {
      const Harmonic load = dynamics_.held_load(n);
      sine += inverse_[k * 2 * m + m + n] * load.sine;
      cosine += inverse_[k * 2 * m + m + n] * load.cosine;
      constant += inverse_[k * 2 * m + m + n] * load.constant;
    }
    const double rate = std::abs(eigenvalue_[k]), size = std::abs(weight), push = std::abs(constant);
    const double load_size = std::abs(sine) + std::abs(cosine);
    bend_.push_back(size * rate * rate);
    least_bend_ += size * ((rate + omega_) * load_size + rate * push);
    bend_growth_ += bend_.back() * (load_size + push);
    sine_.push_back(sine);
    cosine_.push_back(cosine);
    constant_.push_back(constant);
    force_weight_.push_back(weight);
  }
}

void StickPropagator::set_drive() {
  const ContactModel& model = dynamics_.model();
  const std::size_t m = dynamics_.modes(), count = eigenvalue_.size();
  const auto damping = [&](std::size_t row, std::size_t column) {
    return model.damping.empty() ? 0.0 : model.damping(row, column);
  };
  const auto drag = [&](std::size_t row) { return model.load_cosine.empty() ? 0.0 : model.load_cosine[row]; };
  const std::vector<double> row = dynamics_.held_force_row();
  force_row_ = {-model.load[m], -drag(m), model.free_mass(), damping(m, m)};
  for (std::size_t n = 0; n < m; ++n) {
    force_row_.base_acceleration += model.mass_coupling[n] * model.load[n];
    force_row_.base_velocity += model.mass_coupling[n] * drag(n);
    force_row_.wall_velocity -= model.mass_coupling[n] * damping(n, m);
  }
  for (std::size_t k = 0; k < count; ++k) {
    DriveRow<Complex> drive;
    for (std::size_t n = 0; n < m; ++n) {
      const Complex share = inverse_[k * 2 * m + m + n];
      drive.base_acceleration += share * model.load[n];
      drive.base_velocity += share * drag(n);
      drive.wall_acceleration -= share * model.mass_coupling[n];
      drive.wall_velocity -= share * damping(n, m);
    }
    drive_rows_.push_back(drive);
    force_weight_.push_back(force_weight(model, row, shape_, k));
  }
  series_.resize(count);
  terms_.resize(count);
  free_.resize(count);
}

// The coefficients of z_k under these of F_k, and its free_, on a piece of this length.
void StickPropagator::set_series(std::size_t k, std::span<const Complex> load, double length) {
  const Complex lambda = eigenvalue_[k];
  const double turn = std::sqrt(std::norm(lambda)) * length;
  const std::size_t size = load.size();
  auto& series = series_[k];
  if (turn < 1.0) {
    terms_[k] = 2;
    for (double term = turn; term > kEpsilon && terms_[k] + size < most_terms; ++terms_[k])
      term *= turn / static_cast<double>(terms_[k]);
    terms_[k] += size;
    series[0] = initial_[k];
    for (std::size_t j = 0; j + 1 < terms_[k]; ++j)
      series[j + 1] = (lambda * series[j] + (j < size ? load[j] : 0.0)) / static_cast<double>(j + 1);
    free_[k] = 0.0;
    return;
  }
  terms_[k] = size;
  const Complex inverse = std::conj(lambda) / std::norm(lambda);
  series[size - 1] = -load[size - 1] * inverse;
  for (std::size_t j = size - 1; j-- > 0;)
    series[j] = (static_cast<double>(j + 1) * series[j + 1] - load[j]) * inverse;
  free_[k] = initial_[k] - series[0];
}

// From the values of the z_k at begin_, initial_, on the piece of the drive.
void StickPropagator::enter_piece() {
  const ContactModel& model = dynamics_.model();
  const DrivePiece& piece = dynamics_.piece();
  const double length = piece.end - begin_, by = piece.begin - begin_;
  const Polynomial base = by == 0.0 ? piece.base : shifted(piece.base, by),
                   wall = by == 0.0 ? piece.wall : shifted(piece.wall, by);
  std::size_t size = base.size();  // without leading zeros
  while (size > 1 && base[size - 1] == 0.0 && wall[size - 1] == 0.0) --size;
  const Polynomial base_velocity = derivative(base), wall_velocity = derivative(wall),
                   base_acceleration = derivative(base_velocity),
                   wall_acceleration = derivative(wall_velocity);
  const auto sum = [&](const auto& row, std::size_t j) {
    return row.base_acceleration * base_acceleration[j] + row.base_velocity * base_velocity[j] +
           row.wall_acceleration * wall_acceleration[j] + row.wall_velocity * wall_velocity[j];
  };
  force_series_ = {};
  for (std::size_t j = 0; j < size; ++j)
    force_series_[j] = sum(force_row_, j) + dynamics_.held_stiffness() * wall[j] - model.base_load * base[j];
  force_series_[0] += dynamics_.held_stiffness() * position_ - model.contact_force;
  for (std::size_t k = 0; k < eigenvalue_.size(); ++k) {
    std::array<Complex, std::tuple_size_v<Polynomial>> load{};
    for (std::size_t j = 0; j < size; ++j) load[j] = sum(drive_rows_[k], j);
    set_series(k, std::span(load).first(size), length);
    for (std::size_t j = 0; j < terms_[k]; ++j) force_series_[j] += (force_weight_[k] * series_[k][j]).real();
  }
  decays_.assign(free_.size(), 1.0);
  decays_at_ = 0.0;
}

void StickPropagator::go_on(double t) {
  std::vector<Complex> now;
  for (std::size_t k = 0; k < eigenvalue_.size(); ++k) now.push_back(coordinate(k, t));
  initial_ = std::move(now);
  begin_ = t;
  enter_piece();
}

double StickPropagator::slowest_decay() const {
  double slowest = eigenvalue_.empty() ? 0.0 : -eigenvalue_.front().real();
  for (const Complex& each : eigenvalue_) slowest = std::min(slowest, -each.real());
  return slowest;
}

void StickPropagator::begin(double t, const ContactKinematics& state) {
  const std::size_t m = dynamics_.modes();
  begin_ = t;
  position_ = state.displacement - dynamics_.wall_displacement(t);
  initial_.assign(eigenvalue_.size(), 0.0);
  for (std::size_t k = 0; k < initial_.size(); ++k)
    for (std::size_t n = 0; n < m; ++n)
      initial_[k] +=
          inverse_[k * 2 * m + n] * (dynamics_.model().angular_frequency[n] * state.amplitudes[n]) +
          inverse_[k * 2 * m + m + n] * state.rates[n];
  if (dynamics_.model().drive) enter_piece();
}

std::vector<ModalShare> StickPropagator::force_shares() const {
  std::vector<ModalShare> shares;
  for (std::size_t k = 0; k < eigenvalue_.size(); ++k)
    shares.push_back({eigenvalue_[k], force_weight_[k] * sine_[k], force_weight_[k] * cosine_[k]});
  return shares;
}

std::vector<double> StickPropagator::force_terms(double t) const {
  std::vector<std::size_t> order(eigenvalue_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return std::abs(eigenvalue_[k]); });
  std::vector<double> terms;
  for (const std::size_t k : order) terms.push_back((force_weight_[k] * coordinate(k, t)).real());
  return terms;
}

const std::vector<StickPropagator::Complex>& StickPropagator::decays(double tau) const {
  if (tau != decays_at_)
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (free_[k] != 0.0) decays_[k] = std::exp(eigenvalue_[k] * tau);
  decays_at_ = tau;
  return decays_;
}

StickPropagator::Complex StickPropagator::coordinate(std::size_t k, double t) const {
  const Complex i(0.0, 1.0), lambda = eigenvalue_[k];
  const double tau = t - begin_;
  if (dynamics_.model().drive) {
    Complex result = 0.0;
    for (std::size_t j = terms_[k]; j-- > 0;) result = result * tau + series_[k][j];
    return free_[k] == 0.0 ? result : result + decays(tau)[k] * free_[k];
  }
  const Complex decay = std::exp(lambda * tau), turned = std::exp(i * omega_ * tau);
  Complex free = decay * initial_[k];
  if (constant_[k] != 0.0) free += constant_[k] * exponential_difference(0.0, lambda, tau, 1.0, decay);
  if (sine_[k] == 0.0 && cosine_[k] == 0.0) return free;
  const Complex turn = std::polar(1.0, omega_ * begin_);
  return free +
         0.5 * (cosine_[k] - i * sine_[k]) * turn *
             exponential_difference(i * omega_, lambda, tau, turned, decay) +
         0.5 * (cosine_[k] + i * sine_[k]) * std::conj(turn) *
             exponential_difference(-i * omega_, lambda, tau, std::conj(turned), decay);
}

StickPropagator::Complex StickPropagator::forcing(std::size_t k, double t) const {
  return sine_[k] * std::sin(omega_ * t) + cosine_[k] * std::cos(omega_ * t) + constant_[k];
}

ContactKinematics StickPropagator::state(double t) const {
  const std::size_t m = dynamics_.modes(), count = eigenvalue_.size();
  ContactKinematics state{std::vector<double>(m), std::vector<double>(m),
                          position_ + dynamics_.wall_displacement(t), dynamics_.wall_velocity(t)};
  for (std::size_t k = 0; k < count; ++k) {
    const Complex z = coordinate(k, t);
    for (std::size_t n = 0; n < m; ++n) {
      state.amplitudes[n] += (shape_[n * count + k] * z).real() / dynamics_.model().angular_frequency[n];
      state.rates[n] += (shape_[(m + n) * count + k] * z).real();
    }
  }
  return state;
}

double StickPropagator::force(double t) const {
  if (dynamics_.model().drive) {
    const double tau = t - begin_;
    double force = 0.0;
    for (std::size_t j = most_terms; j-- > 0;) force = force * tau + force_series_[j];
    const auto& decay = decays(tau);
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (free_[k] != 0.0) force += (force_weight_[k] * free_[k] * decay[k]).real();
    return force;
  }
  double force = dynamics_.held_stiffness() * position_ - dynamics_.model().contact_force +
                 force_harmonic_.sine * std::sin(omega_ * t) + force_harmonic_.cosine * std::cos(omega_ * t) +
                 force_harmonic_.constant + force_harmonic_.rate * t;
  for (std::size_t k = 0; k < eigenvalue_.size(); ++k) force += (force_weight_[k] * coordinate(k, t)).real();
  return force;
}

double StickPropagator::force_rate(double t) const {
  if (dynamics_.model().drive) {
    const double tau = t - begin_;
    double rate = 0.0;
    for (std::size_t j = most_terms; j-- > 1;) rate = rate * tau + static_cast<double>(j) * force_series_[j];
    const auto& decay = decays(tau);
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (free_[k] != 0.0) rate += (force_weight_[k] * eigenvalue_[k] * free_[k] * decay[k]).real();
    return rate;
  }
  double rate =
      omega_ * (force_harmonic_.sine * std::cos(omega_ * t) - force_harmonic_.cosine * std::sin(omega_ * t)) +
      force_harmonic_.rate;
  for (std::size_t k = 0; k < eigenvalue_.size(); ++k)
    rate += (force_weight_[k] * (eigenvalue_[k] * coordinate(k, t) + forcing(k, t))).real();
  return rate;
}

// z_tt = λ² z + λ F + F_t, and |z| grows by less than |F| times the length.
double StickPropagator::curvature_bound(double t, double length) const {
  if (dynamics_.model().drive) {
    const double tau = t - begin_, end = tau + length;
    double bound = 0.0;
    for (std::size_t j = most_terms; j-- > 2;)
      bound = bound * end + static_cast<double>(j * (j - 1)) * std::abs(force_series_[j]);
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (free_[k] != 0.0)
        bound += std::abs(force_weight_[k] * free_[k]) * std::norm(eigenvalue_[k]) *
                 std::exp(eigenvalue_[k].real() * tau);
    return bound;
  }
  double bound = least_bend_ + length * bend_growth_;
  for (std::size_t k = 0; k < eigenvalue_.size(); ++k) bound += bend_[k] * std::abs(coordinate(k, t));
  return bound;
}

std::optional<double> StickPropagator::first_excess(double from, double to, double limit) {
  double t = from, here = std::abs(force(t));
  while (t < to) {
    const double length = std::min(next_length_, to - t);
    const double end = t + length, signed_force = force(end), there = std::abs(signed_force);
    const double bound = curvature_bound(t, length);
    const double floor = 4.0 * kEpsilon * std::max(end, 1.0 / omega_);
    const bool at_floor = length <= floor;
    if (std::max(here, there) + 0.125 * bound * length * length <= limit || (at_floor && there <= limit)) {
      t = end;
      here = there;
      if (length == next_length_) next_length_ *= 2.0;
      continue;
    }
    if (there > limit) {
      const double sign = signed_force > 0.0 ? 1.0 : -1.0;
      if (at_floor || here >= limit) return here >= limit ? t : end;
      if (sign * force_rate(t) > bound * length) {
        const auto excess = [&](double time) { return sign * force(time) - limit; };
        return brent_root(as_gsl_function(excess), {t, end}, 2.0 * kEpsilon);
      }
    }
    next_length_ = 0.5 * length;
  }
  return std::nullopt;
}

}  // namespace stickslip::analytic
