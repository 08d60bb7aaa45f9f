// SPDX-License-Identifier: MIT
#include "stickslip/analytic/held_motion.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <utility>

namespace stickslip::analytic {
namespace {

// Σ|c_k| L^k.
double largest(const Polynomial& polynomial, double length) {
  double result = 0.0;
  for (std::size_t k = polynomial.size(); k-- > 0;) result = result * length + std::abs(polynomial[k]);
  return result;
}

// The bound of X_n for frequencies of `omega` and more, which lose energy at the rate `decay` (1/s) at least.
class Response {
 public:
  Response(double omega, double decay) : omega_(omega), decay_(decay) {}

  void add(const Polynomial& displacement, double length) {
    const Polynomial acceleration = derivative(derivative(displacement)), jerk = derivative(acceleration);
    const double forgets = std::exp(-decay_ * length);
    // What happens in the piece may all happen at its end.
    const double jump = std::abs(acceleration[0] - acceleration_end_), bend = std::abs(jerk[0] - jerk_end_);
    jumps_ = (jumps_ + jump) * forgets;
    of_acceleration_ = of_acceleration_ * forgets + length * largest(jerk, length);
    of_jerk_ = (of_jerk_ + bend) * forgets + length * largest(derivative(jerk), length);
    largest_ = std::max(largest_, jumps_ + jump + std::min(of_acceleration_, (of_jerk_ + bend) / omega_));
    acceleration_end_ = value(acceleration, length);
    jerk_end_ = value(jerk, length);
  }
  [[nodiscard]] double bound() const { return largest_; }

 private:
  double omega_, decay_;
  double jumps_{}, of_acceleration_{}, of_jerk_{}, largest_{};
  double acceleration_end_{}, jerk_end_{};  // from rest
};

// The force around its largest value, and the bands in it.
class Bands {
 public:
  explicit Bands(double highest_hz) : highest_(std::exp2(std::ceil(std::log2(highest_hz)))) {}

  // How far apart instants may be.
  [[nodiscard]] double spacing() const { return 0.125 / highest_; }
  void add(double time, double force) {
    while (!recent_.empty() && recent_.front().first < time - half_width()) recent_.pop_front();
    recent_.emplace_back(time, force);
    if (time <= peak_ + half_width()) around_.emplace_back(time, force);
  }
  // The largest value is at this time, not before the last instant.
  void set_peak(double time) {
    peak_ = time;
    around_.assign(recent_.begin(), recent_.end());
  }
  [[nodiscard]] std::vector<BandShare> shares(double largest, double sign) const {
    std::vector<BandShare> bands;
    double before = 0.0, from = 0.0;
    for (int octave = octaves; octave >= 0; --octave) {
      const double edge = std::ldexp(highest_, -octave), below = sign * cut_off(edge);
      bands.push_back({from, edge, below - before});
      before = below;
      from = edge;
    }
    bands.push_back({from, std::numeric_limits<double>::infinity(), largest - before});
    return bands;
  }

 private:
  static constexpr int octaves = 6;

  [[nodiscard]] double half_width() const { return 4.0 / std::ldexp(highest_, -octaves); }
  // The trapezoidal rule.
  [[nodiscard]] double cut_off(double edge) const {
    const auto integrand = [&](const std::pair<double, double>& instant) {
      const double s = instant.first - peak_, w = std::cos(0.5 * std::numbers::pi * s / half_width());
      const double z = 2.0 * std::numbers::pi * edge * s;
      return w * w * instant.second * 2.0 * edge * (std::abs(z) < 1e-9 ? 1.0 : std::sin(z) / z);
    };
    double sum = 0.0;
    for (std::size_t i = 1; i < around_.size(); ++i)
      sum += 0.5 * (around_[i].first - around_[i - 1].first) *
             (integrand(around_[i]) + integrand(around_[i - 1]));
    return sum;
  }

  double highest_, peak_{};
  std::deque<std::pair<double, double>> recent_;
  std::vector<std::pair<double, double>> around_;
};

class Search {
 public:
  Search(HeldMotion& motion, double limit, double highest_hz)
      : motion_(motion), limit_(limit), bands_(highest_hz) {}

  void take_piece(double begin, double end) {
    const double force = motion_.propagator().force(begin), at_begin = size(begin, force), at_end = size(end);
    if (!result_.first_excess && bound(begin, at_begin, end, at_end) > limit_)
      result_.first_excess =
          at_begin > limit_ ? std::optional(begin) : motion_.propagator().first_excess(begin, end, limit_);
    refine(begin, at_begin, end, at_end);
    take_instants(begin, force, end);
    if (result_.time >= begin) {
      sign_ = motion_.propagator().force(result_.time) < 0.0 ? -1.0 : 1.0;
      result_.shares = motion_.shares(result_.time);
      for (double& share : result_.shares) share *= sign_;
    }
    result_.largest_acceleration =
        std::max(result_.largest_acceleration, std::abs(2.0 * motion_.dynamics().piece().base[2]));
  }

  [[nodiscard]] MotionReaction take() {
    result_.of_modes = {lower_, std::max(lower_, upper_)};
    if (lower_ > 0.0) result_.bands = bands_.shares(lower_, sign_);
    return std::move(result_);
  }

 private:
  static constexpr double gap = 1e-7;

  [[nodiscard]] double size(double t) { return size(t, motion_.propagator().force(t)); }
  [[nodiscard]] double size(double t, double force) {
    const double here = std::abs(force);
    if (here > lower_) {
      lower_ = here;
      result_.time = t;
    }
    return here;
  }
  [[nodiscard]] double bound(double begin, double at_begin, double end, double at_end) const {
    const double length = end - begin;
    return std::max(at_begin, at_end) +
           0.125 * motion_.propagator().curvature_bound(begin, length) * length * length;
  }
  void refine(double begin, double at_begin, double end, double at_end) {
    const double most = bound(begin, at_begin, end, at_end), middle = begin + 0.5 * (end - begin);
    if (most <= lower_ * (1.0 + gap) || !(begin < middle && middle < end)) {
      upper_ = std::max(upper_, most);
      return;
    }
    const double at_middle = size(middle);
    refine(begin, at_begin, middle, at_middle);
    refine(middle, at_middle, end, at_end);
  }

  // Of the bands, in the piece; its end is the begin of the next one.
  void take_instants(double begin, double at_begin, double end) {
    const double count = std::ceil((end - begin) / bands_.spacing());
    bool has_peak = result_.time >= begin;
    for (double i = 0.0; i < count; i += 1.0) {
      const double time = begin + (end - begin) * i / count;
      bands_.add(time, i == 0.0 ? at_begin : motion_.propagator().force(time));
      if (has_peak && time + (end - begin) / count >= result_.time) {
        bands_.set_peak(result_.time);
        has_peak = false;
      }
    }
  }

  HeldMotion& motion_;
  double limit_, lower_{}, upper_{}, sign_{1.0};
  Bands bands_;
  MotionReaction result_;
};

}  // namespace

ContactKinematics held_start(const ContactModel& model) {
  const std::size_t m = model.modes();
  const ContactDynamics dynamics(model);
  ContactKinematics state{std::vector<double>(m), std::vector<double>(m), 0.0, dynamics.wall_velocity(0.0)};
  if (!model.drive || !model.drive->is_random()) return state;
  StickPropagator stick(dynamics);
  const double decay = stick.slowest_decay(), period = model.drive->duration();
  if (!(decay > 0.0)) return state;
  const double memory = std::log(1e10) / decay, periods = std::ceil(memory / period);
  constexpr double most_periods = 1e4;
  if (!(periods < most_periods)) return state;
  double from = periods * period - memory;
  for (double round = 0.0; round < periods; round += 1.0, from = 0.0) {
    dynamics.enter(from);
    state.displacement = 0.0;
    state.velocity = dynamics.wall_velocity(from);
    stick.begin(from, state);
    for (double end = dynamics.piece_end(); end < period; end = dynamics.piece_end()) {
      dynamics.enter(end);
      stick.go_on(end);
    }
    state = stick.state(period);
  }
  dynamics.enter(0.0);
  state.displacement = 0.0;
  state.velocity = dynamics.wall_velocity(0.0);
  return state;
}

HeldMotion::HeldMotion(const ContactModel& model) : dynamics_(model), stick_(dynamics_) {
  stick_.begin(0.0, held_start(model));
}

void HeldMotion::enter_next_piece() {
  const double end = piece_end();
  dynamics_.enter(end);
  stick_.go_on(end);
}

double HeldMotion::force(double t) {
  while (t > piece_end()) enter_next_piece();
  return stick_.force(t);
}

MotionReaction motion_reaction(const data::Case& problem, int modes,
                               const std::function<void(double)>& report) {
  constexpr int quiet_pieces = 4096;
  const ContactModel model = contact_model(problem, modes);
  const auto& [omega, contact, load] = model.omitted;
  const double duration = problem.numerics.duration(),
               decay =
                   std::isfinite(omega) ? problem.damping.ratio_at(omega, model.modes() + 1) * omega : 0.0;
  HeldMotion motion(model);
  Search search(motion, problem.contact.friction.static_coefficient() * problem.normal_force(),
                data::highest_frequency_hz(problem));
  Response base(omega, decay), wall(omega, decay);
  int pieces = 0;
  for (double begin = 0.0;;) {
    const double end = std::min(motion.piece_end(), duration);
    const DrivePiece& piece = motion.dynamics().piece();
    base.add(piece.base, end - piece.begin);
    wall.add(piece.wall, end - piece.begin);
    search.take_piece(begin, end);
    if (report && ++pieces % quiet_pieces == 0) report(end);
    if (end >= duration) break;
    motion.enter_next_piece();
    begin = end;
  }
  MotionReaction result = search.take();
  if (contact > 0.0) {
    double base_mass = model.moved_mass;
    for (std::size_t n = 0; n < model.modes(); ++n) base_mass -= std::pow(model.participation[n], 2);
    const double coupling = model.drive->base_moves() ? std::sqrt(contact * std::max(base_mass, 0.0))
                                                      : omega * std::sqrt(contact * load);
    result.omitted = coupling * base.bound() + contact * wall.bound();
  }
  return result;
}

}  // namespace stickslip::analytic
