// SPDX-License-Identifier: MIT
#include "stickslip/data/general_motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "motion_shape.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::data {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double reach = 0.4;  // Ω times the length of a piece: an error of 5e-13 of the amplitude
constexpr double remainder = 128.0 * 40320.0;  // 2^7 8!

void require(bool holds, const std::string& key, double value, std::string_view allowed) {
  if (!holds || !std::isfinite(value)) throw FieldError(key, value, allowed);
}

// The derivatives of A sin(φ) with respect to the stated quantity: of a force, the acceleration alone.
MotionState of_force(double force) { return {0.0, 0.0, -force}; }

// The polynomial through the values of a function at eight Chebyshev points, by Newton's differences.
std::array<double, 8> interpolated(double begin, double length,
                                   const std::function<double(double)>& function) {
  std::array<double, 8> point{}, difference{}, made{};
  for (std::size_t j = 0; j < 8; ++j) {
    point[j] = 0.5 - 0.5 * std::cos((2.0 * static_cast<double>(j) + 1.0) * pi / 16.0);
    difference[j] = function(begin + point[j] * length);
  }
  for (std::size_t order = 1; order < 8; ++order)
    for (std::size_t j = 7; j >= order; --j)
      difference[j] = (difference[j] - difference[j - 1]) / (point[j] - point[j - order]);
  for (std::size_t j = 8; j-- > 0;) {
    for (std::size_t k = 7; k > 0; --k) made[k] = made[k - 1] - point[j] * made[k];
    made[0] = difference[j] - point[j] * made[0];
  }
  double power = 1.0;
  for (double& coefficient : made) {
    coefficient /= power;
    power *= length;
  }
  return made;
}

// A motion in closed form, whose pieces are interpolated.
class ClosedShape : public MotionShape {
 public:
  using MotionShape::MotionShape;

  [[nodiscard]] std::size_t pieces() const override { return pieces_; }
  [[nodiscard]] MotionPiece piece(std::size_t index) const override {
    const double begin = begin_of(index), length = begin_of(index + 1) - begin;
    const MotionState state = at(begin);
    return {begin, length, interpolated(begin, length, [this](double t) { return at(t).acceleration; }),
            state.velocity, state.displacement};
  }

 protected:
  [[nodiscard]] virtual double begin_of(std::size_t index) const = 0;
  std::size_t pieces_{1};
};

class SinesShape : public ClosedShape {
 public:
  SinesShape(std::vector<Sine> sines, double duration, std::string_view table)
      : ClosedShape(sines, duration, table) {
    const std::string key = key_in(table, "sines");
    if (sines.empty()) throw FieldError(key, "empty", "a list of sines");
    for (const Sine& sine : sines) {
      require(sine.frequency_hz > 0.0, key, sine.frequency_hz, "of frequencies above 0 (Hz)");
      require(sine.amplitude >= 0.0, key, sine.amplitude, "of amplitudes of 0 or more");
      require(true, key, sine.phase, "of finite phases");
      if ((sine.amplitude_of == AmplitudeOf::force) != (sines[0].amplitude_of == AmplitudeOf::force))
        throw FieldError(key, "of forces and motions", "of one of them");
      highest_hz = std::max(highest_hz, sine.frequency_hz);
    }
    pieces_ = static_cast<std::size_t>(std::ceil(duration * 2.0 * pi * highest_hz / reach));
    for (const Sine& sine : sines) {
      const double omega = 2.0 * pi * sine.frequency_hz;
      piece_error += sine.amplitude * std::pow(omega, 2 - derivatives(sine.amplitude_of)) *
                     std::pow(0.5 * omega * begin_of(1), 8.0) / remainder;
    }
  }

  [[nodiscard]] MotionState at(double t) const override {
    MotionState sum;
    for (const auto& [hz, amplitude, kind, phase] : std::get<std::vector<Sine>>(statement)) {
      const double omega = 2.0 * pi * hz, sine = amplitude * std::sin(omega * t + phase);
      if (kind == AmplitudeOf::force) {
        sum.acceleration -= sine;
        continue;
      }
      const double unit = std::pow(omega, -derivatives(kind));
      sum.displacement += unit * sine;
      sum.velocity += unit * omega * amplitude * std::cos(omega * t + phase);
      sum.acceleration -= unit * omega * omega * sine;
    }
    return sum;
  }

 private:
  [[nodiscard]] double begin_of(std::size_t index) const override {
    return lasts * static_cast<double>(index) / static_cast<double>(pieces_);
  }
};

// Its pieces have equal phases. With ν = φ' and ε = |ν'|/ν², each derivative in time of ν^m ε^j sin φ adds a factor of at most
// ν (1 + (|m| + 2 j) ε), so that |h^(10)| ≤ A ν^(10-k) Π_i (1 + (|i - k| + 2 i) ε), i = 0 ... 9.
class SweepShape : public ClosedShape {
 public:
  SweepShape(const Sweep& sweep, double duration, std::string_view table)
      : ClosedShape(sweep, duration, table), sweep_(sweep), k_(derivatives(sweep.amplitude_of)) {
    const std::string key = key_in(table, "sweep");
    const double slowest = std::min(sweep.from_hz, sweep.to_hz);
    require(sweep.from_hz > 0.0, key, sweep.from_hz, "from a frequency above 0 (Hz)");
    require(sweep.to_hz > 0.0, key, sweep.to_hz, "to a frequency above 0 (Hz)");
    require(sweep.amplitude >= 0.0, key, sweep.amplitude, "of an amplitude of 0 or more");
    const double natural = sweep.is_logarithmic ? sweep.rate * std::numbers::ln2 / slowest
                                                : sweep.rate / (slowest * slowest);  // in a period
    require(sweep.rate > 0.0 && natural <= 10.0, key, sweep.rate,
            "of a rate above 0 that changes no frequency by more than ten times itself in a period");
    rate_ = 2.0 * pi * std::copysign(sweep.rate, sweep.to_hz - sweep.from_hz);
    growth_ = std::copysign(sweep.rate, sweep.to_hz - sweep.from_hz) * std::numbers::ln2;
    const double whole =
        sweep.is_logarithmic ? std::log2(sweep.to_hz / sweep.from_hz) : sweep.to_hz - sweep.from_hz;
    stop_phase_ = pi * std::floor(sweeping(std::abs(whole) / sweep.rate)[0] / pi);
    stop_ = time_of(stop_phase_);
    end_phase_ = phase(duration)[0];
    const double epsilon = natural / (2.0 * pi);
    double product = 1.0;
    for (int i = 0; i < 10; ++i) product *= 1.0 + (std::abs(i - k_) + 2 * i) * epsilon;
    step_ = reach * std::pow(product, -0.125);
    sweeping_pieces_ = static_cast<std::size_t>(std::ceil(std::min(end_phase_, stop_phase_) / step_));
    pieces_ = sweeping_pieces_ +
              static_cast<std::size_t>(std::ceil(std::max(0.0, end_phase_ - stop_phase_) / step_));
    const double highest = std::max(2.0 * pi * sweep.from_hz, phase(std::min(duration, stop_))[1]);
    highest_hz = highest / (2.0 * pi);
    piece_error = sweep.amplitude * std::pow(highest, 2 - k_) * product *
                  std::pow(0.5 * step_ * (1.0 + epsilon * step_), 8.0) / remainder;
  }

  [[nodiscard]] MotionState at(double t) const override {
    const auto [angle, nu, change, change_of_change] = phase(t);
    const double sine = std::sin(angle), cosine = std::cos(angle);
    if (sweep_.amplitude_of == AmplitudeOf::force) return of_force(sweep_.amplitude * sine);
    const double a = sweep_.amplitude * std::pow(nu, -k_), relative = change / nu;
    const double a_t = -k_ * a * relative,
                 a_tt = a * (k_ * (k_ + 1) * relative * relative - k_ * change_of_change / nu);
    return {a * sine, a_t * sine + a * nu * cosine,
            (a_tt - a * nu * nu) * sine + (2.0 * a_t * nu + a * change) * cosine};
  }

 private:
  using Phase = std::array<double, 4>;  // φ and its derivatives

  [[nodiscard]] Phase sweeping(double t) const {
    const double from = 2.0 * pi * sweep_.from_hz;
    if (!sweep_.is_logarithmic) return {(from + 0.5 * rate_ * t) * t, from + rate_ * t, rate_, 0.0};
    const double nu = from * std::exp(growth_ * t);
    return {from * std::expm1(growth_ * t) / growth_, nu, growth_ * nu, growth_ * growth_ * nu};
  }
  [[nodiscard]] Phase phase(double t) const {
    if (t < stop_) return sweeping(t);
    const double nu = sweeping(stop_)[1];
    return {stop_phase_ + nu * (t - stop_), nu, 0.0, 0.0};
  }
  [[nodiscard]] double time_of(double angle) const {
    const double from = 2.0 * pi * sweep_.from_hz;
    if (sweep_.is_logarithmic) return std::log1p(angle * growth_ / from) / growth_;
    return 2.0 * angle / (from + std::sqrt(from * from + 2.0 * rate_ * angle));
  }
  [[nodiscard]] double begin_of(std::size_t index) const override {
    if (index == pieces_) return lasts;
    if (index < sweeping_pieces_) return time_of(step_ * static_cast<double>(index));
    return stop_ + step_ * static_cast<double>(index - sweeping_pieces_) / sweeping(stop_)[1];
  }

  Sweep sweep_;
  int k_;
  double rate_{}, growth_{};  // of ν, rad/s², and of its logarithm, 1/s
  double stop_phase_{}, stop_{}, end_phase_{}, step_{};
  std::size_t sweeping_pieces_{};
};

// Pieces one after the other, from rest.
class ShockMotion : public MotionShape {
 public:
  ShockMotion(const Shock& shock, double duration, std::string_view table)
      : MotionShape(shock, duration, table), shock_(shock) {
    const std::string key = key_in(table, "shock");
    require(shock.duration > 0.0, key, shock.duration, "of a duration above 0 (s)");
    require(shock.amplitude >= 0.0, key, shock.amplitude, "of an amplitude of 0 or more");
    const bool is_velocity = shock.amplitude_of == AmplitudeOf::velocity;
    const bool jumps = shock.shape == ShockShape::sawtooth || shock.shape == ShockShape::rectangle;
    if (shock.amplitude_of == AmplitudeOf::displacement || (is_velocity && jumps))
      throw FieldError(key,
                       !is_velocity                          ? "of displacement"
                       : shock.shape == ShockShape::sawtooth ? "a sawtooth of velocity"
                                                             : "a rectangle of velocity",
                       "of an acceleration, or a half-sine or trapezoid of velocity: it has a jump that "
                       "needs an infinite acceleration");
    highest_hz = (shock.shape == ShockShape::half_sine ? 5.0 : 12.0) / (2.0 * shock.duration);
    const double length = shock.duration, a = shock.amplitude;
    if (shock.shape == ShockShape::half_sine) {
      constexpr int parts = 8;
      for (int i = 0; i < parts; ++i) {
        const double begin = i * length / parts, end = (i + 1) * length / parts;
        add(begin, end,
            interpolated(begin, end - begin, [this](double t) { return shocked(t).acceleration; }));
      }
      const double omega = pi / length;
      piece_error = (is_velocity ? a * omega : a) * std::pow(0.5 * omega * length / parts, 8.0) / remainder;
    } else if (shock.shape == ShockShape::sawtooth) {
      add_line(0.0, length, 0.0, a);
    } else if (shock.shape == ShockShape::rectangle) {
      add_line(0.0, length, a, a);
    } else {
      add_line(0.0, 0.1 * length, 0.0, a);
      add_line(0.1 * length, 0.9 * length, a, a);
      add_line(0.9 * length, length, a, 0.0);
    }
    add(length, std::max(duration, 2.0 * length), {});
    while (pieces_.size() > 1 && pieces_.back().begin >= duration) pieces_.pop_back();
    pieces_.back().length = duration - pieces_.back().begin;
  }

  [[nodiscard]] MotionState at(double t) const override {
    if (shock_.shape == ShockShape::half_sine && t < shock_.duration) return shocked(t);
    const auto next = std::ranges::upper_bound(pieces_, t, {}, &MotionPiece::begin);
    return state_in(*std::prev(next), t);
  }
  [[nodiscard]] std::size_t pieces() const override { return pieces_.size(); }
  [[nodiscard]] MotionPiece piece(std::size_t index) const override { return pieces_.at(index); }

 private:
  // Of a half-sine, during it.
  [[nodiscard]] MotionState shocked(double t) const {
    const double a = shock_.amplitude, omega = pi / shock_.duration, half = std::sin(0.5 * omega * t),
                 sine = std::sin(omega * t);
    if (shock_.amplitude_of == AmplitudeOf::force) return of_force(a * sine);
    if (shock_.amplitude_of == AmplitudeOf::velocity)
      return {2.0 * a / omega * half * half, a * sine, a * omega * std::cos(omega * t)};
    return {a / omega * (t - sine / omega), 2.0 * a / omega * half * half, a * sine};
  }

  void add_line(double begin, double end, double from, double to) {
    const double slope = (to - from) / (end - begin);
    if (shock_.amplitude_of == AmplitudeOf::velocity)
      add(begin, end, {slope});
    else if (shock_.amplitude_of == AmplitudeOf::force)
      add(begin, end, {-from, -slope});
    else
      add(begin, end, {from, slope});
  }

  void add(double begin, double end, const std::array<double, 8>& acceleration) {
    MotionPiece made{begin, end - begin, acceleration};
    if (!pieces_.empty() && shock_.amplitude_of != AmplitudeOf::force) {
      MotionState state = state_in(pieces_.back(), begin);
      if (shock_.shape == ShockShape::half_sine) state = shocked(begin);
      made.velocity = state.velocity;
      made.displacement = state.displacement;
    }
    pieces_.push_back(made);
  }

  Shock shock_;
  std::vector<MotionPiece> pieces_;
};

std::unique_ptr<MotionShape> shape_of(GeneralMotion::Statement statement, double duration,
                                      std::string_view table) {
  if (auto* record = std::get_if<MotionRecord>(&statement)) return recorded_motion(std::move(*record), table);
  require(duration > 0.0, "excitation.duration", duration, "above 0 (s)");
  if (auto* spectrum = std::get_if<PowerSpectrum>(&statement))
    return random_motion(std::move(*spectrum), duration, table);
  if (const auto* sines = std::get_if<std::vector<Sine>>(&statement))
    return std::make_unique<SinesShape>(*sines, duration, table);
  if (const auto* sweep = std::get_if<Sweep>(&statement))
    return std::make_unique<SweepShape>(*sweep, duration, table);
  return std::make_unique<ShockMotion>(std::get<Shock>(statement), duration, table);
}

AmplitudeOf quantity_of(const GeneralMotion::Statement& statement) {
  if (const auto* sines = std::get_if<std::vector<Sine>>(&statement)) return sines->front().amplitude_of;
  if (const auto* sweep = std::get_if<Sweep>(&statement)) return sweep->amplitude_of;
  if (const auto* shock = std::get_if<Shock>(&statement)) return shock->amplitude_of;
  if (const auto* spectrum = std::get_if<PowerSpectrum>(&statement)) return spectrum->quantity;
  return std::get<MotionRecord>(statement).quantity;
}

}  // namespace

// Horner's scheme for the polynomial and its integrals.
MotionState state_in(const MotionPiece& piece, double t) {
  const double tau = t - piece.begin;
  double once = 0.0, twice = 0.0, acceleration = 0.0;
  for (int k = 7; k >= 0; --k) {
    const double coefficient = piece.acceleration[static_cast<std::size_t>(k)];
    acceleration = acceleration * tau + coefficient;
    once = once * tau + coefficient / (k + 1);
    twice = twice * tau + coefficient / ((k + 1) * (k + 2));
  }
  return {piece.displacement + (piece.velocity + twice * tau) * tau, piece.velocity + once * tau,
          acceleration};
}

GeneralMotion::GeneralMotion(Statement statement, double duration, std::string_view table)
    : shape_(shape_of(std::move(statement), duration, table)) {}

double GeneralMotion::displacement(double t) const {
  return is_force() ? 0.0 : scale_ * shape_->at(t).displacement;
}
double GeneralMotion::velocity(double t) const { return is_force() ? 0.0 : scale_ * shape_->at(t).velocity; }
double GeneralMotion::acceleration(double t) const { return scale_ * shape_->at(t).acceleration; }

std::size_t GeneralMotion::pieces() const noexcept { return shape_->pieces(); }

MotionPiece GeneralMotion::piece(std::size_t index) const {
  MotionPiece made = shape_->piece(index);
  for (double& coefficient : made.acceleration) coefficient *= scale_;
  made.velocity = is_force() ? 0.0 : scale_ * made.velocity;
  made.displacement = is_force() ? 0.0 : scale_ * made.displacement;
  return made;
}

double GeneralMotion::piece_error() const noexcept { return scale_ * shape_->piece_error; }
double GeneralMotion::interpolation_error() const noexcept { return scale_ * shape_->interpolation_error; }
double GeneralMotion::duration() const noexcept { return shape_->lasts; }
double GeneralMotion::highest_frequency_hz() const noexcept { return shape_->highest_hz; }

GeneralMotion GeneralMotion::lasting(double duration) const {
  if (duration == shape_->lasts) return *this;
  if (const auto* record = std::get_if<MotionRecord>(&statement())) {
    if (duration > shape_->lasts)
      throw FieldError("excitation.duration", duration,
                       "at most that of " + record->file + ", " + shortest_text(shape_->lasts) + " s");
    return *this;
  }
  return GeneralMotion(statement(), duration, shape_->table_name).scaled(scale_);
}

GeneralMotion GeneralMotion::scaled(double scale) const {
  require(scale >= 0.0, key_in(shape_->table_name, "scale"), scale, "a finite number of 0 or more");
  GeneralMotion made = *this;
  made.scale_ = scale;
  return made;
}

bool GeneralMotion::is_force() const noexcept { return quantity_of(statement()) == AmplitudeOf::force; }

const GeneralMotion::Statement& GeneralMotion::statement() const noexcept { return shape_->statement; }

std::string GeneralMotion::key() const {
  constexpr std::array names{"sines", "sweep", "shock", "file", "spectrum"};
  return key_in(shape_->table_name, names.at(statement().index()));
}

}  // namespace stickslip::data
