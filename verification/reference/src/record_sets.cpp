// SPDX-License-Identifier: MIT
/// The data sets of a mass with friction whose base has a recorded acceleration, case recorded-mass. The case gives the numbers; spline,
/// motion and changes are computed here, in ball arithmetic.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sets.hpp"
#include "stickslip/certified/roots.hpp"

namespace stickslip::reference {

using certified::Dual;
using certified::PrecisionScope;
using certified::Rational;
using certified::Real;

namespace {

constexpr long record_bits = 256;

/// Σ_k c_k s^k + C cos(ω s) + S sin(ω s), s = t - begin.
struct Motion {
  Real begin;
  std::array<Real, 6> c;
  Real omega{}, cosine{}, sine{};

  /// Its derivative of this order, up to 4.
  [[nodiscard]] Real at(int order, const Real& t) const {
    const Real s = t - begin, cos_s = cos(omega * s), sin_s = sin(omega * s);
    Real sum;
    for (int k = 5; k >= order; --k) {
      int factor = 1;
      for (int i = 0; i < order; ++i) factor *= k - i;
      sum = sum * s + factor * c.at(static_cast<std::size_t>(k));
    }
    const Real free = order % 2 == 0 ? cosine * cos_s + sine * sin_s : sine * cos_s - cosine * sin_s;
    return sum + (order % 4 < 2 ? 1 : -1) * pow(omega, static_cast<unsigned>(order)) * free;
  }
};

// The solution of a system by elimination; what it loses without exchanges is in the radii.
std::vector<Real> solved(std::vector<std::vector<Real>> rows, std::vector<Real> right) {
  const std::size_t size = rows.size();
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t row = i + 1; row < size; ++row) {
      const Real factor = rows[row][i] / rows[i][i];
      for (std::size_t k = i; k < size; ++k) rows[row][k] -= factor * rows[i][k];
      right[row] -= factor * right[i];
    }
  }
  for (std::size_t i = size; i-- > 0; right[i] /= rows[i][i])
    for (std::size_t k = i + 1; k < size; ++k) right[i] -= rows[i][k] * right[k];
  return right;
}

// The displacement of the base: its acceleration is the cubic spline through the samples whose third derivative does not jump at the
// second and at the last but one. The unknowns are its second derivatives.
std::vector<Motion> base_of(const data::MotionRecord& record) {
  const std::size_t last = record.samples.size() - 1;
  std::vector<Real> right(last + 1), length, slope;
  for (std::size_t i = 0; i < last; ++i) {
    length.push_back(Real(record.times[i + 1]) - Real(record.times[i]));  // exact: multiples of 1/64 s
    slope.push_back((Real(exact(record.samples[i + 1])) - exact(record.samples[i])) / length[i]);
  }
  std::vector<std::vector<Real>> rows(last + 1, std::vector<Real>(last + 1));
  for (std::size_t i = 1; i < last; ++i) {
    rows[i][i - 1] = length[i - 1];
    rows[i][i] = 2 * (length[i - 1] + length[i]);
    rows[i][i + 1] = length[i];
    right[i] = 6 * (slope[i] - slope[i - 1]);
  }
  for (const auto& [row, left] : {std::pair{std::size_t{0}, std::size_t{0}}, {last, last - 2}}) {
    rows[row][left] = length[left + 1];
    rows[row][left + 1] = -(length[left] + length[left + 1]);
    rows[row][left + 2] = length[left];
  }
  const std::vector<Real> bend = solved(rows, right);
  std::vector<Motion> pieces;
  Real displacement, velocity = exact(*record.initial_velocity);
  for (std::size_t i = 0; i < last; ++i) {
    const Real first = slope[i] - length[i] * (2 * bend[i] + bend[i + 1]) / 6;
    const Motion piece{Real(record.times[i]),
                       {displacement, velocity, Real(exact(record.samples[i])) / 2, first / 6, bend[i] / 24,
                        (bend[i + 1] - bend[i]) / (120 * length[i])}};
    displacement = piece.at(0, Real(record.times[i + 1]));
    velocity = piece.at(1, Real(record.times[i + 1]));
    pieces.push_back(piece);
  }
  return pieces;
}

/// m y_tt + k (y - h) = f_d from rest on the wall, phase by phase and piece by piece; every decision certain.
class RecordedMass {
 public:
  struct Phase {
    std::size_t piece{};
    Real begin, position;  // there
    int direction{};       // of the slip; 0 in stick
    const char* change{};  // by which it begins; none at the begin of a piece
    Motion motion;
  };

  explicit RecordedMass(const data::Case& problem)
      : base_(base_of(std::get<data::MotionRecord>(problem.general_motion()->statement()))),
        end_(problem.general_motion()->duration()),
        mass_(exact(problem.model()->properties().mass)),
        stiffness_(exact(problem.model()->properties().stiffness)) {
    const Real normal = exact(problem.model()->normal_force());
    static_ = normal * exact(problem.contact.friction.static_coefficient());
    kinetic_ = normal * exact(problem.contact.friction.kinetic_coefficient());
    begin_phase(0, Real(0), 0, nullptr, Real(0), Real(0));
    while (go_on()) {
    }
  }

  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }

  [[nodiscard]] const Phase& phase_at(const Real& t) const {
    std::size_t i = phases_.size() - 1;
    while (i > 0 && !(phases_[i].begin < t)) --i;
    if (i + 1 < phases_.size() && phases_[i + 1].change != nullptr && !(t < phases_[i + 1].begin))
      throw std::runtime_error("it is not certain whether a sample sticks");
    return phases_[i];
  }

  /// N, of the mass on the wall.
  [[nodiscard]] Real force(const Phase& phase, const Real& t) const {
    return phase.direction == 0 ? -holding(phase, t).value : phase.direction * kinetic_;
  }

 private:
  // The friction that would hold the mass, N, and its rate.
  [[nodiscard]] Dual<Real> holding(const Phase& phase, const Real& t) const {
    const Motion& base = base_[phase.piece];
    return {stiffness_ * (phase.motion.at(0, t) - base.at(0, t)), -stiffness_ * base.at(1, t)};
  }

  // With w = k/m, a particular solution is h - (h_tt - h_tttt/w)/w - direction mu_k N/k.
  void begin_phase(std::size_t piece, const Real& begin, int direction, const char* change, const Real& y,
                   const Real& v) {
    Motion motion{base_[piece].begin, {y}};
    if (direction != 0) {
      const Real w = stiffness_ / mass_;
      const std::array<Real, 6>& c = base_[piece].c;
      motion.c = c;
      motion.omega = sqrt(w);
      for (std::size_t j = 0; j < 4; ++j) {
        motion.c.at(j) -= static_cast<int>((j + 1) * (j + 2)) * c.at(j + 2) / w;
        if (j < 2) motion.c.at(j) += (j == 0 ? 24 : 120) * c.at(j + 4) / (w * w);
      }
      motion.c[0] -= direction * kinetic_ / stiffness_;
      const Real p = y - motion.at(0, begin), q = (v - motion.at(1, begin)) / motion.omega,
                 angle = motion.omega * (begin - motion.begin);
      motion.cosine = p * cos(angle) - q * sin(angle);
      motion.sine = p * sin(angle) + q * cos(angle);
    }
    phases_.push_back({piece, begin, y, direction, change, motion});
  }

  // Until the next change or the end of the piece; false at the end of the record.
  bool go_on() {
    const Phase now = phases_.back();
    const bool is_last = now.piece + 1 == base_.size();
    const Real end = is_last ? Real(end_) : base_[now.piece + 1].begin;
    if (const auto change = change_in(now, end)) {
      const Real force = holding(now, *change).value;
      const int excess = now.direction == 0 ? 1 : (abs(force) - static_).certain_sign();
      if (excess == 0) throw std::runtime_error("it is not certain whether the mass sticks");
      begin_phase(now.piece, *change, excess < 0 ? 0 : -force.certain_sign(),
                  now.direction == 0 ? "onset"
                  : excess < 0       ? "capture"
                                     : "reversal",
                  now.motion.at(0, *change), Real(0));
      return true;
    }
    if (!is_last)
      begin_phase(now.piece + 1, end, now.direction, nullptr, now.motion.at(0, end), now.motion.at(1, end));
    return !is_last;
  }

  [[nodiscard]] std::optional<Real> change_in(const Phase& phase, const Real& end) const {
    std::optional<Real> first;
    Real begin = phase.begin.upper();
    if (phase.direction == 0) {
      for (const int sign : {-1, 1})
        for (const Real& root : certified::isolate_roots(
                 [&](const Real& t) { return sign * holding(phase, t) - static_; }, begin, end))
          if (!first || root < *first) first = root;
      return first;
    }
    if (phase.change != nullptr) {  // from rest: it speeds up at first
      Real soon = (end - begin).midpoint();
      while (!(phase.direction * phase.motion.at(2, hull(phase.begin, begin + soon)) > Real(0))) {
        soon = (soon / 2).midpoint();
        if (soon < Real(1e-9)) throw std::runtime_error("a slip begins in no certain direction");
      }
      begin = (begin + soon).midpoint();
      if (!(begin < end)) return first;
    }
    const auto roots = certified::isolate_roots(
        [&](const Real& t) { return Dual<Real>(phase.motion.at(1, t), phase.motion.at(2, t)); }, begin, end);
    if (!roots.empty()) first = roots.front();
    return first;
  }

  std::vector<Motion> base_;
  double end_;
  Real mass_, stiffness_, static_, kinetic_;
  std::vector<Phase> phases_;
};

const data::Case& recorded_case() {
  static const data::Case problem = data::load_case("recorded-mass");
  return problem;
}

const data::MotionRecord& record() {
  return std::get<data::MotionRecord>(recorded_case().general_motion()->statement());
}

const RecordedMass& recorded_mass() {
  static const RecordedMass mass = [] {
    const PrecisionScope scope(record_bits);
    return RecordedMass(recorded_case());
  }();
  return mass;
}

void state(data::Resource& resource) {
  const data::Case& problem = recorded_case();
  const data::ModelProperties& mass = problem.model()->properties();
  resource.problem = fmt::format(
      R"({{"mass": {}, "stiffness": {}, "normal_force": {}, "static_coefficient": {}, "kinetic_coefficient": {},
           "initial_state": "y = 0, y_t = 0",
           "base": {{"acceleration": "record-motion", "interpolation": "cubic spline, not-a-knot",
                     "initial_displacement": 0, "initial_velocity": {}}}}})",
      mass.mass, mass.stiffness, mass.normal_force, problem.contact.friction.static_coefficient(),
      problem.contact.friction.kinetic_coefficient(), *record().initial_velocity);
  resource.provenance = {
      .value_class = ValueClass::enclosed,
      .method =
          "the spline and the piecewise closed form, in ball arithmetic (Arb); every event is isolated "
          "and each decision certain",
      .settings = R"({"bits": 256, "digits": 30})",
      .software = software(),
      .checks = {"the event-driven engine and the time stepper, to round-off and to order two"}};
}

DataSet record_motion() {
  DataSet set =
      data_set("record-motion", "single-mass/record-motion.csv", "A recorded acceleration of a base",
               "The samples between which the base of record-events and record-history moves.");
  set_key(set.resource, {integer("index", "number of the sample, from 1")});
  set.resource.fields.push_back(exact_number("time", "s", "since the start"));
  set.resource.fields.push_back(exact_number("acceleration", "m/s^2", "h_tt, of the base"));
  state(set.resource);
  set.resource.provenance = {
      .value_class = ValueClass::exact,
      .method = "chosen numbers: two sines, rounded, at times that are not equidistant",
      .settings = "{}",
      .software = "none",
      .checks = {"the case recorded-mass has them"}};
  for (std::size_t i = 0; i < record().samples.size(); ++i)
    add_row(set, {static_cast<int>(i) + 1, record().times[i], record().samples[i]});
  return set;
}

DataSet record_events() {
  DataSet set = data_set(
      "record-events", "single-mass/record-events.csv", "Stick and slip of a mass on a recorded base",
      "m y_tt + k (y - h) = f_d, k to a base that moves by h(t), the wall at rest. h_tt is the cubic spline "
      "through record-motion, not-a-knot, integrated twice. Friction holds up to mu_s N while the mass "
      "sticks and is "
      "mu_k N while it slides. The first event is the first slip.");
  data::Resource& resource = set.resource;
  resource.fields = {integer("index", "number of the event, from 1"),
                     word("change", "of the contact", {"onset", "reversal", "capture"})};
  resource.primary_key = {"index"};
  add_values(resource, ValueClass::enclosed,
             {{"time", "s", "of the event", Norm::scale, 1e-6},
              {"position", "m", "y, in the fixed frame", Norm::scale, 1e-6}});
  resource.comparison->kind = data::ComparisonKind::events;
  resource.comparison->horizon = recorded_case().general_motion()->duration();
  state(resource);
  const PrecisionScope scope(record_bits);
  int index = 0;
  for (const RecordedMass::Phase& phase : recorded_mass().phases())
    if (phase.change != nullptr)
      add_row(set, {++index, phase.change, enclosed(phase.begin), enclosed(phase.position, 1.0)});
  return set;
}

DataSet record_history() {
  DataSet set =
      data_set("record-history", "single-mass/record-history.csv", "A mass with friction on a recorded base",
               "The mass of record-events every 10 ms, phase by phase.");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("time", "s", "since the start")});
  resource.fields.push_back(word("phase", "of the contact", {"stick", "slip"}));
  add_values(resource, ValueClass::enclosed,
             {{"tip_displacement", "m", "y(t), in the fixed frame", Norm::scale, 1e-6},
              {"friction_force", "N", "f(t), of the mass on the wall", Norm::scale, 1e-6}});
  compare_along(resource, "time");
  resource.comparison->kind = data::ComparisonKind::phases;
  resource.comparison->events = "record-events";
  resource.comparison->horizon = recorded_case().general_motion()->duration();
  state(resource);
  const PrecisionScope scope(record_bits);
  for (int i = 1; i <= 142; ++i) {
    const Real t = Real(i) / 100;
    const RecordedMass::Phase& phase = recorded_mass().phase_at(t);
    add_row(set, {i / 100.0, phase.direction == 0 ? "stick" : "slip", enclosed(phase.motion.at(0, t), 1.0),
                  enclosed(recorded_mass().force(phase, t), 1.0)});
  }
  return set;
}

}  // namespace

std::vector<Recipe> record_sets() {
  return {{"record-motion", record_motion, true, 410},
          {"record-events", record_events, true, 420},
          {"record-history", record_history, true, 430}};
}

}  // namespace stickslip::reference
