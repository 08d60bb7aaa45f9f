// SPDX-License-Identifier: MIT
/// The data sets of friction problems that others have published: one or two masses, one contact.

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "sets.hpp"
#include "stickslip/certified/roots.hpp"

namespace stickslip::reference {

using certified::Dual;
using certified::PrecisionScope;
using certified::Rational;
using certified::Real;

namespace {

constexpr long published_bits = 256;

struct MassEvent {
  const char* change;
  Real time, position;
};

/// m x_tt + k x = G sin(Omega t) + f_d with m = 1 kg, k = 100 N/m and Coulomb friction, mu N = 5 N.
struct ForcedMass {
  Real amplitude, rate;  // G, Omega
};
constexpr int stiffness = 100, friction = 5;

// The first root from `from` on, searched window by window until `end`; F(from) has a certain sign.
std::optional<Real> first_root(const certified::DifferentiableFunction& function, const Real& from,
                               const Real& window, const Real& end) {
  for (Real lower = from.upper(); lower < end;) {
    const Real upper = (lower + window).midpoint();
    const auto roots = certified::isolate_roots(function, lower, upper);
    if (!roots.empty()) return roots.front();
    lower = upper;
  }
  return std::nullopt;
}

/// A slip phase from the time `begin` on: x = mean + a cos(10 tau) + b sin(10 tau) + V sin(Omega t).
class Slide {
 public:
  Slide(const ForcedMass& mass, int direction, Real begin, const Real& position, const Real& velocity)
      : rate_(mass.rate),
        forced_(mass.amplitude / (stiffness - mass.rate * mass.rate)),
        direction_(direction),
        begin_(std::move(begin)),
        mean_(-direction * Real(friction) / stiffness),
        a_(position - mean_ - forced_ * sin(rate_ * begin_)),
        b_((velocity - forced_ * rate_ * cos(rate_ * begin_)) / own_) {}

  [[nodiscard]] Real position(const Real& t) const {
    return mean_ + a_ * cos(phase(t)) + b_ * sin(phase(t)) + forced_ * sin(rate_ * t);
  }

  /// The first time after the begin at which the velocity is zero. Right after the begin it has the sign of
  /// the direction, because the first of velocity, acceleration and jerk that is not zero has it.
  [[nodiscard]] std::optional<Real> end(const Real& latest) const {
    const Real window = Real(1) / (4 * max(own_, rate_)).midpoint();
    Real after = (window / 64).midpoint();
    for (int halving = 0;; ++halving) {
      const Real early = hull(begin_, begin_ + after);
      const auto has_the_sign = [&](int order) {
        return (direction_ * rate_of(order, early)).certain_sign() > 0;
      };
      if (has_the_sign(1) || has_the_sign(2) || has_the_sign(3)) break;
      if (halving == 40) throw std::runtime_error("a slip begins in no certain direction");
      after = (after / 2).midpoint();
    }
    return first_root([this](const Real& t) { return Dual<Real>(rate_of(1, t), rate_of(2, t)); },
                      begin_ + after, window, latest);
  }

 private:
  [[nodiscard]] Real phase(const Real& t) const { return own_ * (t - begin_); }
  // The derivative of this order, 1 to 3, of the position.
  [[nodiscard]] Real rate_of(int order, const Real& t) const {
    const Real c = cos(phase(t)), s = sin(phase(t)), forced_c = cos(rate_ * t), forced_s = sin(rate_ * t);
    if (order == 1) return own_ * (b_ * c - a_ * s) + forced_ * rate_ * forced_c;
    if (order == 2) return -own_ * own_ * (a_ * c + b_ * s) - forced_ * rate_ * rate_ * forced_s;
    return own_ * own_ * own_ * (a_ * s - b_ * c) - forced_ * pow(rate_, 3) * forced_c;
  }

  Real own_{10}, rate_, forced_;
  int direction_;
  Real begin_, mean_, a_, b_;
};

// The friction force that holding the mass takes, N, and its rate.
Dual<Real> holding(const ForcedMass& mass, const Real& position, const Real& t) {
  return {stiffness * position - mass.amplitude * sin(mass.rate * t),
          -mass.amplitude * mass.rate * cos(mass.rate * t)};
}

std::optional<Real> end_of_stick(const ForcedMass& mass, const Real& position, const Real& begin,
                                 const Real& latest) {
  std::optional<Real> first;
  for (const int sign : {-1, 1}) {
    const auto excess = [&](const Real& t) { return sign * holding(mass, position, t) - friction; };
    const auto root = first_root(excess, begin, Real(1) / (4 * mass.rate).midpoint(), latest);
    if (root && (!first || *root < *first)) first = root;
  }
  return first;
}

/// All events up to the time `latest`, and perhaps one soon after it; every decision certain. Without a
/// velocity the mass starts stuck.
std::vector<MassEvent> events_of(const ForcedMass& mass, Real position, std::optional<Real> velocity,
                                 const Real& latest) {
  std::vector<MassEvent> events;
  Real now(0);
  bool sticks = !velocity;
  int direction = velocity ? velocity->certain_sign() : 0;
  for (;;) {
    if (sticks) {
      const auto onset = end_of_stick(mass, position, now, latest);
      if (!onset) return events;
      now = *onset;
      direction = -holding(mass, position, now).value.certain_sign();
      sticks = false;
      velocity = Real(0);
      events.push_back({"onset", now, position});
      continue;
    }
    const Slide slide(mass, direction, now, position, *velocity);
    const auto rest = slide.end(latest);
    if (!rest) return events;
    now = *rest;
    position = slide.position(now);
    velocity = Real(0);
    const Real force = holding(mass, position, now).value;
    const int excess = (abs(force) - friction).certain_sign();
    if (excess == 0) throw std::runtime_error("it is not certain whether the mass sticks");
    sticks = excess < 0;
    direction = -force.certain_sign();
    events.push_back({sticks ? "capture" : "reversal", now, position});
  }
}

ForcedMass forced_mass(const char* force_ratio, const char* frequency_ratio) {
  return {Real(Rational(force_ratio)) * friction, Real(Rational(frequency_ratio)) * 10};
}

void add_rows(DataSet& set, const char* problem, const std::vector<MassEvent>& events) {
  int index = 0;
  for (const MassEvent& event : events)
    add_row(set, {problem, ++index, event.change, enclosed(event.time), enclosed(event.position)});
}

// x = 0.25 m + v0 t + (sin a - mu_k cos a) g t^2/2 once it slides.
std::vector<MassEvent> states_on_an_incline(const char* slope, int initial_velocity, bool slides,
                                            std::array<int, 3> times) {
  const Real p{Rational(slope)}, g{Rational("9.81")};
  const Real acceleration = g * (p - Real(Rational("0.3"))) / sqrt(1 + p * p);
  std::vector<MassEvent> states;
  for (const int t : times) {
    const Real slid = slides ? initial_velocity * Real(t) + acceleration * (t * t) / 2 : Real(0);
    states.push_back({"state", Real(t), Real(Rational("0.25")) + slid});
  }
  return states;
}

std::vector<MassEvent> sdnd100_events() {
  std::vector<MassEvent> events;
  for (int i = 1; i <= 4; ++i)
    events.push_back({i < 4 ? "reversal" : "capture", i * certified::pi() / 100,
                      (i % 2 == 0 ? 1 : -1) * (Real(Rational("0.85e-3")) - i * Real(Rational("0.2e-3")))});
  return events;
}

// Positions and velocities of the masses, and the acceleration of mass 1.
struct Pair {
  Real x1, v1, x2, v2, a1;
};

// A time tau later, while mass 1 slides up: x1 + x2 falls freely, x1 - x2 oscillates.
Pair slid(const Pair& from, const Real& tau, int pull) {
  const Real rate = sqrt(Real(4000)), c = cos(rate * tau), s = sin(rate * tau);
  const Real fall = Real(pull - 2000) / 5, rest = -Real(pull + 2000) / 20000;
  const Real a = from.x1 - from.x2 - rest, b = (from.v1 - from.v2) / rate;
  const Real sum = from.x1 + from.x2 + tau * (from.v1 + from.v2 + fall * tau / 2);
  const Real sum_rate = from.v1 + from.v2 + fall * tau;
  const Real difference = rest + a * c + b * s, difference_rate = rate * (b * c - a * s);
  return {(sum + difference) / 2, (sum_rate + difference_rate) / 2, (sum - difference) / 2,
          (sum_rate - difference_rate) / 2, (fall - rate * rate * (difference - rest)) / 2};
}

// Mass 1 lets go when k x2 = mu_s N = F, at a quarter of the period of mass 2; at 0.2 s the pull ends.
std::vector<MassEvent> sdnd106_events() {
  const Real own = sqrt(Real(2000)), onset = certified::pi() / (2 * own), release(Rational("0.2"));
  const auto velocity = [](const Pair& from, const Real& begin, int pull) {
    return [=](const Real& t) {
      const Pair now = slid(from, t - begin, pull);
      return Dual<Real>(now.v1, now.a1);
    };
  };
  const Real stretch(Rational("0.3")), window = Real(Rational("0.005")).midpoint();
  const Pair at_onset{Real(0), Real(0), stretch, stretch * own, Real(0)};
  const auto pulled = velocity(at_onset, onset, 3000);
  const Real soon = (onset + window).upper();
  if (!(pulled(hull(onset, soon)).slope > Real(0)) ||
      !certified::isolate_roots(pulled, soon, release.upper()).empty())
    throw std::runtime_error("mass 1 does not slide until the pull ends");
  const Pair at_release = slid(at_onset, release - onset, 3000);
  const Real stop = *first_root(velocity(at_release, release, 0), release, window, Real(1));
  const Pair at_stop = slid(at_release, stop - release, 0);
  // The largest force of the spring from now on is below mu_s N.
  if (!(pow(at_stop.x2 - at_stop.x1, 2) + pow(at_stop.v2 / own, 2) < pow(stretch, 2)))
    throw std::runtime_error("mass 1 does not stay at rest");
  return {{"onset", onset, Real(0)}, {"capture", stop, at_stop.x1}};
}

// The steady motion without stops, from a zero of the force on. While it moves down from rest at tau = 0,
// x = s - s cos(w tau) - s tan(T/2) sin(w tau) + V cos(Omega tau + phi) with w = 10 rad/s, s = mu N/k,
// T = pi w/Omega, V = G/(k - m Omega^2). Half a period later it is at rest at -x(0), because
// Omega V sin(phi) = -w s tan(T/2). The zero of the force lies at Omega tau + phi = pi/2, or half a period
// later, where all signs are reversed.
std::vector<MassEvent> den_hartog_events() {
  const ForcedMass mass = forced_mass("4", "0.8");
  const Real own(10), forced = mass.amplitude / (stiffness - mass.rate * mass.rate);
  const Real shift = Real(friction) / stiffness, tangent = tan(certified::pi() * own / (2 * mass.rate));
  const Real sine = -shift * own * tangent / (mass.rate * forced);
  const Real phi = certified::isolate_root(
      [&](const Real& angle) { return Dual<Real>(sin(angle) - sine, cos(angle)); }, Real(-1), Real(1));
  const Real turn = own * (certified::pi() / 2 - phi) / mass.rate;
  const Real x = shift - shift * cos(turn) - shift * tangent * sin(turn);
  const Real v = own * shift * (sin(turn) - tangent * cos(turn)) - forced * mass.rate;
  std::vector<MassEvent> events = events_of(mass, -x, -v, 10 * certified::pi() / mass.rate);
  if (events.size() < 10) throw std::runtime_error("a turning point of the steady motion is missing");
  events.erase(events.begin() + 10, events.end());
  return events;
}

// From rest at 0, for some half periods of the force.
std::vector<MassEvent> hong_liu_events(const char* force_ratio, const char* frequency_ratio,
                                       int half_periods) {
  const ForcedMass mass = forced_mass(force_ratio, frequency_ratio);
  return events_of(mass, Real(0), std::nullopt, half_periods * certified::pi() / mass.rate);
}

int stops_in_the_fourth_period(const char* force_ratio, const char* frequency_ratio) {
  const Real period = certified::pi() / 5 / Real(Rational(frequency_ratio));
  const auto events = hong_liu_events(force_ratio, frequency_ratio, 8);
  return static_cast<int>(std::ranges::count_if(events, [&](const MassEvent& event) {
    return std::string_view(event.change) == "capture" && event.time > 3 * period && event.time < 4 * period;
  }));
}

// G/(mu N) = |1 - r^2| sqrt(1/r^4 + tan^2(pi/(2 r))/r^2): the friction is just overcome at the turning point.
// Between two turning points the mass must not stop either:
// w = sin(r t)/r - sin t - tan(T/2) (cos(r t) - cos t) > 0 for 0 < t < T = pi/r,
// which starts as a parabola and ends with a falling slope.
Real non_stop_limit(const char* frequency_ratio) {
  const Real r{Rational(frequency_ratio)}, end = certified::pi() / r, tangent = tan(end / 2);
  const auto slope = [&](const Real& t) { return cos(r * t) - cos(t) + tangent * (r * sin(r * t) - sin(t)); };
  const auto bend = [&](const Real& t) {
    return sin(t) - r * sin(r * t) + tangent * (r * r * cos(r * t) - cos(t));
  };
  constexpr int parts = 2048, ends = 256;
  for (int i = 0; i < parts; ++i) {
    const Real t = hull(end * i / parts, end * (i + 1) / parts);
    const Real w = sin(r * t) / r - sin(t) - tangent * (cos(r * t) - cos(t));
    const bool moves = i < ends ? bend(t) > Real(0) : i < parts - ends ? w > Real(0) : slope(t) < Real(0);
    if (!moves) throw std::runtime_error("the mass may stop between its turning points");
  }
  return abs(1 - r * r) * sqrt(1 / pow(r, 4) + tangent * tangent / (r * r));
}

data::Provenance published_provenance(std::string method, std::vector<std::string> checks) {
  return {.value_class = ValueClass::enclosed,
          .method = std::move(method) +
                    ", in ball arithmetic (Arb); every event is isolated and each decision certain",
          .settings = R"({"bits": 256, "digits": 30})",
          .software = software(),
          .checks = std::move(checks)};
}

DataSet published_problems() {
  DataSet set =
      data_set("published-problems", "single-mass/published-problems.csv",
               "Friction problems of others, event by event",
               "One or two masses with one contact; mu_s holds it while it sticks, mu_k while it slides. A "
               "block on an incline, SDND100 and SDND106 of code_aster, Den Hartog's steady motion without "
               "stops, and motions from rest of Hong and Liu with 1, 2, 4 and 6 stops in a period. README.md "
               "states equations, numbers and sources.");
  data::Resource& resource = set.resource;
  resource.fields = {
      word("problem", "name"), integer("index", "number of the event, from 1"),
      word("change", "of the contact, or state at a given time", {"onset", "reversal", "capture", "state"})};
  add_values(resource, ValueClass::enclosed,
             {{"time", "s", "of the event", Norm::scale, 1e-6},
              {"position", "m", "of the mass", Norm::scale, 1e-6}});
  resource.comparison->kind = data::ComparisonKind::events;
  resource.primary_key = {"problem", "index"};
  resource.problem = R"({
      "problem": {"column": "problem"},
      "incline-stays": {"gravity": 9.81, "slope": 0.45, "static_coefficient": 0.5, "kinetic_coefficient": 0.3,
                        "position": 0.25, "velocity": 0},
      "incline-slides": {"gravity": 9.81, "slope": 0.55, "static_coefficient": 0.5, "kinetic_coefficient": 0.3,
                         "position": 0.25, "velocity": 0},
      "incline-goes-on": {"gravity": 9.81, "slope": 0.45, "static_coefficient": 0.5, "kinetic_coefficient": 0.3,
                          "position": 0.25, "velocity": 1},
      "sdnd100": {"mass": 1, "stiffness": 1e4, "friction_force": 1, "position": 0.85e-3, "velocity": 0},
      "sdnd106": {"mass": 5, "other_mass": 5, "coupling": 1e4, "static_coefficient": 0.3, "kinetic_coefficient": 0.2,
                  "normal_force": 1e4, "pull": {"force": 3000, "until": 0.2}, "position": 0, "velocity": 0},
      "den-hartog": {"mass": 1, "stiffness": 100, "friction_force": 5, "force": {"amplitude": 20, "angular_frequency": 8},
                     "position": -0.173009592359444, "velocity": 4.00402328243824},
      "hong-liu-1": {"mass": 1, "stiffness": 100, "friction_force": 5, "force": {"amplitude": 15, "angular_frequency": 5},
                     "position": 0, "velocity": 0},
      "hong-liu-2": {"mass": 1, "stiffness": 100, "friction_force": 5, "force": {"amplitude": 15, "angular_frequency": 3},
                     "position": 0, "velocity": 0},
      "hong-liu-4": {"mass": 1, "stiffness": 100, "friction_force": 5, "force": {"amplitude": 15, "angular_frequency": 2},
                     "position": 0, "velocity": 0},
      "hong-liu-6": {"mass": 1, "stiffness": 100, "friction_force": 5, "force": {"amplitude": 7.5, "angular_frequency": 0.6},
                     "position": 0, "velocity": 0}})";
  resource.provenance =
      published_provenance("the piecewise closed form",
                           {"the event-driven engine and the time stepper, to round-off and to order two"});
  const PrecisionScope scope(published_bits);
  add_rows(set, "incline-stays", states_on_an_incline("0.45", 0, false, {1, 10, 100}));
  add_rows(set, "incline-slides", states_on_an_incline("0.55", 0, true, {1, 2, 5}));
  add_rows(set, "incline-goes-on", states_on_an_incline("0.45", 1, true, {1, 2, 5}));
  add_rows(set, "sdnd100", sdnd100_events());
  add_rows(set, "sdnd106", sdnd106_events());
  add_rows(set, "den-hartog", den_hartog_events());
  add_rows(set, "hong-liu-1", hong_liu_events("3", "0.5", 4));
  add_rows(set, "hong-liu-2", hong_liu_events("3", "0.3", 4));
  add_rows(set, "hong-liu-4", hong_liu_events("3", "0.2", 4));
  add_rows(set, "hong-liu-6", hong_liu_events("1.5", "0.06", 4));
  return set;
}

DataSet stops_per_period() {
  DataSet set = data_set("stops-per-period", "single-mass/stops.csv",
                         "How often a forced mass with Coulomb friction stops",
                         "Hong and Liu (J. Sound Vib. 229, 2000): m x_tt + k x = G sin(Omega t) + f_d with "
                         "Coulomb friction mu N, from rest at 0; "
                         "the stops of finite length in the fourth period of the force.");
  data::Resource& resource = set.resource;
  resource.fields = {exact_number("frequency_ratio", "", "Omega sqrt(m/k)"),
                     exact_number("force_ratio", "", "G/(mu N)"), exact_number("stops", "", "in the period")};
  resource.primary_key = {"frequency_ratio", "force_ratio"};
  resource.comparison = by_rows({{"stops", Norm::absolute, 0.1}});
  resource.problem =
      R"({"frequency_ratio": {"column": "frequency_ratio"}, "force_ratio": {"column": "force_ratio"},
          "position": 0, "velocity": 0, "period": 4})";
  resource.provenance =
      published_provenance("the piecewise closed form", {"the event-driven engine and the time stepper"});
  const PrecisionScope scope(published_bits);
  for (const char* r :
       {"0.06", "0.08", "0.1", "0.12", "0.15", "0.2", "0.3", "0.5", "0.6", "0.8", "1.25", "2"})
    for (const char* f : {"1.5", "2", "3"}) add_row(set, {r, f, stops_in_the_fourth_period(f, r)});
  return set;
}

DataSet non_stop_limits() {
  DataSet set = data_set("non-stop-limits", "single-mass/non-stop.csv",
                         "The least force under which a mass with friction never stops",
                         "Den Hartog (Trans. ASME 53, 1931): m x_tt + k x = G sin(Omega t) + f_d with "
                         "Coulomb friction mu N. The steady motion with "
                         "two turning points in a period, in each of which it rests for no time, is possible "
                         "if G/(mu N) is above |1 - r^2| "
                         "sqrt(1/r^4 + tan^2(pi/(2 r))/r^2), r = Omega sqrt(m/k).");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("frequency_ratio", "", "r")});
  add_values(resource, ValueClass::enclosed,
             {{"force_ratio", "", "G/(mu N) at the limit", Norm::relative, 1e-3}});
  resource.problem =
      R"({"frequency_ratio": {"column": "frequency_ratio"}, "initial_state": "none: steady motion",
          "sought": "force_ratio"})";
  resource.provenance = published_provenance("the closed form", {"runs on both sides of the limit"});
  const PrecisionScope scope(published_bits);
  for (const char* r : {"0.6", "0.7", "0.8", "0.9", "1.1", "1.25", "1.5", "2", "3"})
    add_row(set, {r, enclosed(non_stop_limit(r))});
  return set;
}

}  // namespace

std::vector<Recipe> published_sets() {
  return {
      {"published-problems", published_problems, true, 380},
      {"stops-per-period", stops_per_period, true, 390},
      {"non-stop-limits", non_stop_limits, true, 400},
  };
}

}  // namespace stickslip::reference
