// SPDX-License-Identifier: MIT
/// Contact problems, each with its exact answers, by every engine that runs a contact. An engine needs one adapter: how it runs a
/// problem, and by how much its answers may be off.

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "studies/common/bisection.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::ContactChange;
using data::ContactState;
using std::numbers::pi;

/// The contact at one time.
struct ContactSample {
  data::ContactState state{};
  double position{};          ///< on the wall, m
  double sliding_velocity{};  ///< m/s
  double friction_force{};    ///< on the system, N
  double way{};               ///< slid since the start, m
};

struct ContactHistory {
  std::vector<data::ContactEvent> events;
  std::vector<ContactSample> samples;  ///< at the times that the problem asks for
};

enum class Kind { slider, spring, oscillator, plane_below_limit, shaken_plane, two_masses };

struct ContactProblem {
  std::string name;
  Kind kind{};
  SingleMass mass{};  ///< the system, unless it is `pair`
  ForcedPair pair{};
  data::ContactState start{data::ContactState::stick};
  double position{};                   ///< of the contact at the start, m
  double velocity{};                   ///< of a start in slip, m/s
  std::vector<double> sample_times{};  ///< ascending; a run ends at the last one, s
  ContactHistory exact{};              ///< of a single mass
  /// By event, of a single mass: how fast the sliding velocity (m/s^2) or, at an onset, the holding force (N/s) passes its
  /// limit. An error of either, divided by it, is one of time.
  std::vector<double> rates{};
  std::optional<double> friction_power{};  ///< published mean of N |v_s| between the last two samples, W

  [[nodiscard]] bool is_pair() const { return kind == Kind::two_masses; }
};

/// v = v_0 - a t with a = mu N/m = 1.5 m/s^2: stops at t = v_0/a after v_0^2/(2 a).
ContactProblem coulomb_slider(double side) {
  ContactProblem problem{.name = "Slider" + parameter_name(side), .kind = Kind::slider, .mass = sliding_mass};
  problem.start = ContactState::slip;
  problem.position = 0.25;
  problem.velocity = 1.3 * side;
  problem.sample_times = {0.0, 0.42, 2.1};
  const double stop = 0.25 + side * 1.3 * 1.3 / 3.0;
  problem.exact.events = {{ContactChange::capture, 1.3 / 1.5, stop}};
  problem.exact.samples = {
      {ContactState::slip, 0.25, 1.3 * side, -3.0 * side},
      {ContactState::slip, 0.25 + side * (1.3 - 0.75 * 0.42) * 0.42, side * (1.3 - 1.5 * 0.42), -3.0 * side},
      {ContactState::stick, stop, 0.0, 0.0}};
  problem.rates = {1.5};
  return problem;
}

/// m = 1 kg, k = 2 N/m, mu N = 1 N: holds up to 0.5 m, that included; beyond, slips at once from u_0 as
/// u = s/2 + (u_0 - s/2) cos(sqrt(2) t), s the sign of u_0.
ContactProblem loaded_spring(double position) {
  ContactProblem problem{.name = "Spring" + parameter_name(position), .kind = Kind::spring};
  problem.mass = {.stiffness = 2.0, .normal_force = 10.0, .friction = coulomb};
  problem.position = position;
  problem.sample_times = {0.0, 0.1};
  if (std::abs(position) <= 0.5) {
    problem.exact.samples.assign(2, {ContactState::stick, position, 0.0, 2.0 * position});
    return problem;
  }
  const double side = std::copysign(1.0, position), omega = std::numbers::sqrt2;
  problem.exact.events = {{ContactChange::onset, 0.0, position}};
  for (const double t : problem.sample_times)
    problem.exact.samples.push_back({ContactState::slip,
                                     0.5 * side + (position - 0.5 * side) * std::cos(omega * t),
                                     -omega * (position - 0.5 * side) * std::sin(omega * t), side});
  problem.rates = {0.0};
  return problem;
}

/// m = 1 kg, k = 4 N/m, mu N/k = 0.1 m: each half cycle of pi/2 s takes twice this dead zone off the amplitude. Turning points
/// -0.84, 0.64, -0.44, 0.24 and -0.04 m; the last lies within the dead zone and sticks.
ContactProblem coulomb_oscillator(double side) {
  ContactProblem problem{
      .name = "Oscillator" + parameter_name(side), .kind = Kind::oscillator, .mass = oscillating_mass};
  problem.position = 1.04 * side;
  problem.sample_times = {12.0};
  problem.exact.events = {{ContactChange::onset, 0.0, problem.position}};
  problem.rates = {0.0};
  for (int i = 1; i <= 5; ++i) {
    problem.exact.events.push_back({i < 5 ? ContactChange::reversal : ContactChange::capture, i * pi / 2.0,
                                    side * (i % 2 == 1 ? -1.0 : 1.0) * (1.04 - 0.2 * i)});
    problem.rates.push_back(
        4.0 * (1.14 - 0.2 * i));  // omega^2 times the distance from the middle of the half cycle
  }
  problem.exact.samples = {{ContactState::stick, -0.04 * side, 0.0, -0.16 * side}};
  return problem;
}

ContactProblem plane_that_never_slips() {
  ContactProblem problem{.name = "StuckForEver", .kind = Kind::plane_below_limit, .mass = shaken_plane(0.99)};
  problem.position = 0.25;
  for (int i = 1; i <= 120; ++i) {
    problem.sample_times.push_back(0.1 * i);
    problem.exact.samples.push_back({ContactState::stick, 0.25, 0.0, 0.99 * std::sin(2.0 * pi * 0.1 * i)});
  }
  return problem;
}

/// Adds the slips of a plane shaken by A sin(omega t), A > 1: from the onset at |A sin| = 1, or from a reversal, in the
/// direction d, v_s = -d (t - s) + A/omega (cos omega t - cos omega s) until its next zero.
void add_slips(ContactProblem& problem, double amplitude, double end) {
  const double omega = 2.0 * pi, first = std::asin(1.0 / amplitude) / omega;
  double position = 0.0, time = first;
  bool stuck = true;
  const auto add = [&](ContactChange change, double rate) {
    problem.exact.events.push_back({change, time, position});
    problem.rates.push_back(std::abs(rate));
  };
  while (time < end) {
    if (stuck) add(ContactChange::onset, amplitude * omega * std::cos(omega * time));
    const double start = time, d = std::sin(omega * start) > 0.0 ? -1.0 : 1.0;
    const auto velocity = [&](double t) {
      return -d * (t - start) + amplitude / omega * (std::cos(omega * t) - std::cos(omega * start));
    };
    double low = start + 1e-3, high = low;
    while (d * velocity(high) > 0.0) low = high, high += 1e-3;
    time = studies::bisected(low, high, [&](double t) { return d * velocity(t) > 0.0; });
    if (time >= end) return;
    const double length = time - start;
    position += -0.5 * d * length * length + amplitude / omega *
                                                 ((std::sin(omega * time) - std::sin(omega * start)) / omega -
                                                  length * std::cos(omega * start));
    const double force = amplitude * std::sin(omega * time);
    stuck = std::abs(force) <= 1.0;
    add(stuck ? ContactChange::capture : ContactChange::reversal, d + force);
    if (stuck) time = first + std::ceil((time - first) * 2.0) / 2.0;
  }
}

/// Case SDND104, with the mean of 10 N |v_s| over 4 <= t <= 12 s from a computation with 40 digits.
ContactProblem plane_that_slips(double amplitude, double friction_power) {
  ContactProblem problem{.name = "Plane" + parameter_name(amplitude),
                         .kind = Kind::shaken_plane,
                         .mass = shaken_plane(amplitude)};
  problem.sample_times = {4.0, 12.0};
  add_slips(problem, amplitude, 12.0);
  problem.friction_power = friction_power;
  return problem;
}

ContactProblem pair_of_masses(double position) {
  ContactProblem problem{.name = "TwoMasses" + parameter_name(position), .kind = Kind::two_masses};
  problem.position = position;
  problem.sample_times = {12.0};
  return problem;
}

// That of a pair takes a thousand exponentials, which every start of this program would pay for.
ContactHistory exact_history(const ContactProblem& problem) {
  if (!problem.is_pair()) return problem.exact;
  const double end = problem.sample_times.back();
  ExactPair exact(problem.pair, problem.position);
  exact.run(end);
  const double phase = problem.pair.omega * end, wall = problem.pair.wall_amplitude;
  const double velocity = exact.velocity()[1] - wall * problem.pair.omega * std::cos(phase);
  return {exact.events(),
          {{exact.stuck() ? ContactState::stick : ContactState::slip,
            exact.displacement()[1] - wall * std::sin(phase), velocity}}};
}

std::vector<ContactProblem> all_problems() {
  std::vector<ContactProblem> problems;
  for (const double side : {-1.0, 1.0}) {
    problems.push_back(coulomb_slider(side));
    problems.push_back(coulomb_oscillator(side));
  }
  for (const double position : {-0.6, -0.5, -0.4, 0.4, 0.5, 0.6}) problems.push_back(loaded_spring(position));
  problems.push_back(plane_that_never_slips());
  problems.push_back(plane_that_slips(1.01, 2.26164121279787e-4));
  problems.push_back(plane_that_slips(1.5, 0.409062451015709));
  problems.push_back(plane_that_slips(15.0, 15.2670995893716));
  for (const double position : {-0.4, -0.1, 0.0, 0.1, 0.4}) problems.push_back(pair_of_masses(position));
  return problems;
}

/// How far an engine's answers may be off. What has no tolerance is not compared.
struct ContactErrors {
  std::function<Tolerance(std::size_t)> time{}, position{};  ///< of each event
  std::optional<Tolerance> sample_position{}, sample_velocity{}, friction_force{}, friction_power{};
};

struct ContactEngine {
  std::string name;
  std::string requirement;  ///< that its answers serve
  std::function<ContactHistory(const ContactProblem&)> run;
  /// None if the engine cannot run the problem.
  std::function<std::optional<ContactErrors>(const ContactProblem&)> errors;
};

/// The same tolerance of every event.
std::function<Tolerance(std::size_t)> always(const Tolerance& tolerance) {
  return [tolerance](std::size_t) { return tolerance; };
}

Tolerance error_per_step(double error) { return discretisation(error, 1.0, "error per step times steps"); }

/// The way slid until `time`, by the positions of the changes before and the position then.
double way_until(double time, double position, const ContactProblem& problem,
                 const std::vector<data::ContactEvent>& events) {
  double way = 0.0, last = problem.position;
  for (const data::ContactEvent& event : events) {
    if (event.time > time) break;
    way += std::abs(event.position - last);
    last = event.position;
  }
  return way + std::abs(position - last);
}

/// The second of two runs, since a start must forget the run before. start() starts the engine, advance(t) runs it and returns
/// the contact then.
template <class Engine, class Start, class Advance>
ContactHistory run_twice(Engine& engine, const ContactProblem& problem, const Start& start,
                         const Advance& advance) {
  ContactHistory history;
  for (int run = 0; run < 2; ++run) {
    history.samples.clear();
    start();
    for (const double time : problem.sample_times) {
      history.samples.push_back(advance(time));
      ContactSample& now = history.samples.back();
      now.way = way_until(time, now.position, problem, engine.events());
    }
  }
  history.events = engine.events();
  return history;
}

// The time stepper.

ContactHistory run_stepper(const ContactProblem& problem, const solver::IntegratorSettings& settings) {
  const bool is_pair = problem.is_pair();
  solver::StickSlipIntegrator stepper(is_pair ? contact_system(problem.pair) : contact_system(problem.mass),
                                      settings);
  const Eigen::Index contact = stepper.system().contact;
  const auto at_contact = [&](double value) {
    return Eigen::VectorXd(value * Eigen::VectorXd::Unit(contact + 1, contact));
  };
  const auto start = [&] {
    if (problem.start == ContactState::stick) {
      stepper.start_stuck(at_contact(problem.position), at_contact(0.0));
    } else {
      stepper.start_slipping(at_contact(problem.position), at_contact(problem.velocity));
    }
  };
  return run_twice(stepper, problem, start, [&](double time) -> ContactSample {
    while (stepper.steps() < std::lround(time / settings.time_step)) stepper.step();
    return {stepper.state(),
            stepper.displacement()[contact] - stepper.system().wall.displacement(stepper.time()),
            stepper.sliding_velocity(), stepper.friction_force()};
  });
}

/// The force on a mass that slides is constant and the wall's motion is exact, so that the order 2 has nothing to act on: what is
/// left is the location of the events, 1e-11 h. An instant that is off by dt leaves a sliding velocity of at most 2 A dt, for less
/// than a second. With a spring, the error of the period is (omega h)^2/12; at spectral radius 1 a step changes the energy by the
/// work of the constant friction, so that turning points are exact but for the rounding of 1571 steps each.
std::optional<ContactErrors> stepper_errors(const ContactProblem& problem,
                                            const solver::IntegratorSettings& settings) {
  const double h = settings.time_step, instant = 1e-11 * h + 1e-14;
  const bool locates = settings.scheme == solver::ContactScheme::located;
  const Tolerance located = discretisation(instant, 1.0, "location tolerance 1e-11 h");
  ContactErrors errors{.time = always(located), .position = always(round_off(100, 1, 1.0))};
  const auto& exact = problem.exact;
  switch (problem.kind) {
    case Kind::slider:
      errors.sample_position = errors.sample_velocity = round_off(100, 1, 1.0);
      errors.friction_force = round_off(0.5, 1, 3.0);
      return locates && h == 0.07 ? std::optional(errors) : std::nullopt;
    case Kind::spring:
      // A step adds h^3/2 u_tttt to the velocity at most; u_tttt = omega^4 (0.6 - 0.5).
      errors.sample_velocity = discretisation(0.5 * h * h * 0.4 * 0.1, 1.0, "h^2/2 u_tttt t");
      errors.sample_position = errors.sample_velocity;
      errors.friction_force = round_off(0.5, 1, 1.2);
      return h == 0.01 ? std::optional(errors) : std::nullopt;
    case Kind::oscillator:
      errors.time = [=](std::size_t i) {
        return i == 0 ? located
                      : discretisation(static_cast<double>(i) * pi / 2.0 * 4.0 * h * h / 12.0, 2.0,
                                       "period error (omega h)^2/12");
      };
      errors.position = [](std::size_t i) { return round_off(1571.0 * static_cast<double>(i), 1, 1.04); };
      errors.sample_position = round_off(1571.0 * 5.0, 1, 1.04);
      errors.friction_force = round_off(1571.0 * 5.0, 4.0, 1.04);
      return settings.spectral_radius == 1.0 && locates && h == 1e-3 ? std::optional(errors) : std::nullopt;
    case Kind::plane_below_limit:
      errors.sample_position = round_off(2, 1, 0.3);
      errors.friction_force = round_off(20, 80, 1.0);
      return locates && h < 0.02 ? std::optional(errors) : std::nullopt;
    case Kind::shaken_plane: {
      const double amplitude = problem.mass.wall_acceleration;
      errors.time = [=, &problem](std::size_t i) {
        const bool onset = exact.events[i].change == data::ContactChange::onset;
        const double rounding = round_off(2, 1, exact.events[i].time).value;
        const double velocity = 2.0 * amplitude * instant * static_cast<double>(i) +
                                round_off(exact.events[i].time / h, 1, 0.5).value;
        return discretisation(instant + rounding + (onset ? 0.0 : velocity / problem.rates[i]), 1.0,
                              "events located to 1e-11 h, and round-off");
      };
      errors.position = [=](std::size_t i) {
        return discretisation(
            6.0 * exact.events[i].time * 2.0 * amplitude * instant + round_off(100, 1, 1.0).value, 1.0,
            "events located to 1e-11 h, and round-off");
      };
      errors.friction_power =
          discretisation(10.0 * 6.0 * instant * 2.0 * amplitude, 1.0, "events located to 1e-11 h");
      return locates && h < 0.02 ? std::optional(errors) : std::nullopt;
    }
    case Kind::two_masses:
      return std::nullopt;  // ContactHistoryOrder has its order
  }
  return std::nullopt;
}

ContactEngine stepper(const std::string& name, const solver::IntegratorSettings& settings) {
  return {name, "F6", [settings](const ContactProblem& problem) { return run_stepper(problem, settings); },
          [settings](const ContactProblem& problem) { return stepper_errors(problem, settings); }};
}

// The event-driven engine.

ContactHistory run_event_driven(const ContactProblem& problem) {
  const bool is_pair = problem.is_pair();
  const ForcedPair& pair = problem.pair;
  analytic::EventDriven engine(is_pair ? contact_model(pair) : contact_model(problem.mass));
  const auto start = [&] {
    if (problem.start == ContactState::slip) {
      engine.start_slipping({}, {}, problem.position, problem.velocity);
    } else if (is_pair) {  // the first mass at rest at the origin
      const double share = -static_shape(pair) / mode_shape(pair);
      engine.start_stuck({share * problem.position}, {share * pair.omega * pair.wall_amplitude},
                         problem.position);
    } else {
      engine.start_stuck({}, {}, problem.position);
    }
  };
  return run_twice(engine, problem, start, [&](double time) -> ContactSample {
    engine.advance_to(time);
    return {engine.state(), engine.contact_position(), engine.sliding_velocity(), engine.friction_force()};
  });
}

/// The slip phases add an error of at most 1e-12 in each step, and neither friction nor damping lets it grow; steps are counted
/// generously at 10 per radian of the fastest motion.
std::optional<ContactErrors> event_driven_errors(const ContactProblem& problem) {
  const auto& events = problem.exact.events;
  switch (problem.kind) {
    case Kind::slider: {  // a quadratic is integrated exactly
      const Tolerance rounding = round_off(20, 1, 1.0);
      return ContactErrors{always(rounding), always(rounding),       rounding,
                           rounding,         round_off(0.5, 1, 3.0), {}};
    }
    case Kind::spring: {
      const Tolerance none = round_off(1, 1, 0.0), step = error_per_step(1e-12 * 2.0);
      return ContactErrors{always(none), always(none), step, step, round_off(0.5, 1, 1.2), {}};
    }
    case Kind::oscillator: {  // a turning point of amplitude 0.1 or more dates within the error over it
      const auto grown = [](double factor) {
        return
            [factor](std::size_t i) { return error_per_step(factor * 1e-11 * pi * static_cast<double>(i)); };
      };
      return ContactErrors{
          grown(2.5), grown(1.0), error_per_step(1e-12 * 50.0 * pi), {}, error_per_step(4e-12 * 50.0 * pi),
          {}};
    }
    case Kind::plane_below_limit:
      return ContactErrors{always({}), always({}), round_off(2, 1, 0.3), {}, round_off(20, 80, 1.0), {}};
    case Kind::shaken_plane: {
      const double omega = 2.0 * pi, amplitude = problem.mass.wall_acceleration, scale = amplitude / omega;
      const auto rounding = [=](double t) { return round_off(20, omega * t, scale).value; };
      const auto time = [=, &problem, &events](std::size_t i) {
        const double t = events[i].time;
        if (events[i].change == ContactChange::onset)
          return round_off(10, omega * t, amplitude / problem.rates[i]);
        std::size_t onset = i;
        while (events[onset].change != ContactChange::onset) --onset;
        return error_per_step((1e-12 * 10.0 * omega * (t - events[onset].time) * scale + rounding(t)) /
                              problem.rates[i]);
      };
      const auto position = [=, &events](std::size_t i) {
        const double t = events[i].time;
        return error_per_step(1e-12 * 10.0 * omega * t * scale + static_cast<double>(i + 1) * rounding(t));
      };
      const Tolerance power =
          reference(1e-10 * *problem.friction_power, "ten digits of a 40-digit computation");
      return ContactErrors{time, position, {}, {}, {}, power};
    }
    case Kind::two_masses: {
      // Up to 4.6 rad/s with slips of about 1 m/s; the slowest stops decelerate at 1 m/s^2, so that times are as good as
      // velocities. ExactPair bisects to round-off: 1000 exponentials of 4 s matrices, 1e-13.
      const Tolerance tolerance = error_per_step(1e-12 * 10.0 * 4.6 * 12.0);
      return ContactErrors{always(tolerance), always(tolerance), tolerance, tolerance, {}, {}};
    }
  }
  return std::nullopt;
}

// The boundary integral, by the mobility of the system or by its free modes.

/// The mean over each step of the force that holds a single mass, N.
std::vector<double> holding_forces(const ContactProblem& problem, double h) {
  const auto count = static_cast<std::size_t>(std::lround(problem.sample_times.back() / h));
  const double half = 0.5 * problem.mass.omega * h;
  std::vector<double> forces;
  for (std::size_t n = 0; n < count; ++n)
    forces.push_back(problem.mass.stiffness * problem.position +
                     problem.mass.mass * problem.mass.wall_acceleration *
                         std::sin(half * static_cast<double>(2 * n + 1)) * std::sin(half) / half);
  return forces;
}

/// Changes of the direction of sliding after which the new one, or stick, lasts three steps or more: the velocity that is left at
/// a capture changes its sign from step to step, and where the force that goes with it is clipped there are slips of one step.
ContactHistory history_of(const ContactProblem& problem, const std::vector<analytic::ContactStep>& steps,
                          double h) {
  using enum data::ContactChange;
  ContactHistory history;
  data::ContactEvent latest;
  double position = problem.position, direction = 0.0, settled = 0.0, way = 0.0;
  int lasting = 0;
  auto sample_time = problem.sample_times.begin();
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const double velocity = steps[n].sliding_velocity, time = static_cast<double>(n) * h;
    const double now = velocity == 0.0 ? 0.0 : std::copysign(1.0, velocity);
    if (now != direction) {
      latest = {settled == 0.0 ? onset : now == 0.0 ? capture : reversal, time, position};
      direction = now;
      lasting = 0;
    }
    position += velocity * h;
    way += std::abs(velocity) * h;
    if (++lasting >= 3 && direction != settled) {
      settled = direction;
      history.events.push_back(latest);
    }
    for (; sample_time != problem.sample_times.end() && *sample_time < time + 1.5 * h; ++sample_time)
      history.samples.push_back({steps[n].slides ? ContactState::slip : ContactState::stick, position,
                                 velocity, steps[n].friction_force, way});
  }
  return history;
}

analytic::ContactLaw law_of(const ContactProblem& problem) {
  return {problem.mass.normal_force, data::FrictionLaw(problem.mass.friction)};
}

ContactHistory run_boundary_integral(const ContactProblem& problem, double h) {
  const auto forces = holding_forces(problem, h);
  const auto mobility = [&mass = problem.mass](std::complex<double> s) {
    return s / (mass.mass * s * s + mass.stiffness);
  };
  const auto weights = analytic::mobility_weights(mobility, h, forces.size(), 2);
  return history_of(problem, analytic::contact_steps(weights, law_of(problem), forces), h);
}

ContactHistory run_free_modes(const ContactProblem& problem, double h) {
  const double mass = problem.mass.mass;
  analytic::FreeModeRun run({{std::sqrt(problem.mass.stiffness / mass), 1.0 / mass}}, law_of(problem), h);
  std::vector<analytic::ContactStep> steps;
  for (const double force : holding_forces(problem, h)) steps.push_back(run.step(force));
  return history_of(problem, steps, h);
}

/// The friction force of a step in which the contact changes is off by at most 2 mu N, the velocity behind it by 2 mu N h/m, and
/// neither friction nor damping amplifies a difference of velocities: 20 h W for the power of the plane.
std::optional<ContactErrors> boundary_integral_errors(const ContactProblem& problem, double h) {
  if (problem.start == ContactState::slip) return std::nullopt;
  const auto of_step = [](double error, const char* law) { return discretisation(error, 1.0, law); };
  switch (problem.kind) {
    case Kind::oscillator: {
      const auto time = [=, &problem](std::size_t i) {
        const double late = i == 0 ? 0.0 : 0.8 * h * static_cast<double>(i) / problem.rates[i];
        return of_step(h + late, "a step, and 2 mu N h/m an event");
      };
      return ContactErrors{time, always(of_step(0.8 * h * 5.0 * 12.0, "2 mu N h/m an event for 12 s"))};
    }
    case Kind::plane_below_limit:
      return ContactErrors{.time = always({}),
                           .position = always({}),
                           .sample_position = round_off(2, 1, 0.3),
                           .friction_force = of_step(0.5 * h * 2.0 * pi * 0.99 * 1.01, "half a step")};
    case Kind::shaken_plane:
      return ContactErrors{.friction_power =
                               of_step(20.0 * h * std::min(1.0, *problem.friction_power), "20 h W")};
    default:
      return std::nullopt;
  }
}

std::vector<ContactEngine> contact_engines() {
  using solver::ContactScheme;
  std::vector<ContactEngine> engines;
  const auto add_stepper = [&](const std::string& name, double h, double radius, double threshold = 0.0,
                               ContactScheme scheme = ContactScheme::located) {
    engines.push_back(stepper(name, {h, radius, threshold, scheme}));
  };
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    add_stepper("Stepper" + parameter_name(radius), 0.07, radius);
  add_stepper("LocatedStepper", 0.01, 0.9, 1e-6);
  add_stepper("EndOfStepStepper", 0.01, 0.9, 1e-6, ContactScheme::end_of_step);
  add_stepper("PaperStepper", 0.01, 0.9, 1e-6, ContactScheme::paper);
  add_stepper("CoarseStepper", 1e-2, 1.0);
  add_stepper("Stepper1ms", 1e-3, 1.0);
  add_stepper("DampedStepper1ms", 1e-3, 0.9);
  add_stepper("FineStepper", 1e-4, 0.9);
  engines.push_back({"EventDriven", "D1", run_event_driven, event_driven_errors});
  for (const double h : {1e-3, 1.25e-4}) {
    const auto errors = [h](const ContactProblem& problem) { return boundary_integral_errors(problem, h); };
    engines.push_back({"BoundaryIntegral" + parameter_name(1e3 * h) + "ms", "D4",
                       [h](const ContactProblem& problem) { return run_boundary_integral(problem, h); },
                       errors});
    engines.push_back({"FreeModes" + parameter_name(1e3 * h) + "ms", "D4",
                       [h](const ContactProblem& problem) { return run_free_modes(problem, h); }, errors});
  }
  return engines;
}

// Every engine on every problem that it can run.

struct Run {
  const ContactProblem* problem;
  ContactEngine engine;
};

std::vector<Run> all_runs() {
  static const std::vector<ContactProblem> problems = all_problems();
  std::vector<Run> runs;
  for (const ContactProblem& problem : problems)
    for (const ContactEngine& engine : contact_engines())
      if (engine.errors(problem)) runs.push_back({&problem, engine});
  return runs;
}

void PrintTo(const Run& run, std::ostream* stream) {
  *stream << run.engine.name << " on " << run.problem->name;
}

class ContactBattery : public ::testing::TestWithParam<Run> {};

void expect_events(const ContactHistory& computed, const ContactHistory& exact, const ContactErrors& errors) {
  ASSERT_EQ(computed.events.size(), exact.events.size());
  for (std::size_t i = 0; i < exact.events.size(); ++i) {
    const data::ContactEvent &event = computed.events[i], &expected = exact.events[i];
    EXPECT_EQ(event.change, expected.change) << i;
    EXPECT_TRUE(within(event.time, expected.time, errors.time(i))) << i;
    EXPECT_TRUE(within(event.position, expected.position, errors.position(i))) << i;
  }
}

void expect_sample(const ContactSample& computed, const ContactSample& exact, const ContactErrors& errors) {
  const auto expect = [](double value, double expected, const std::optional<Tolerance>& tolerance) {
    if (tolerance) {
      EXPECT_TRUE(within(value, expected, *tolerance));
    }
  };
  EXPECT_EQ(computed.state, exact.state);
  if (exact.state == ContactState::stick) {
    EXPECT_EQ(computed.sliding_velocity, 0.0);
  }
  expect(computed.position, exact.position, errors.sample_position);
  expect(computed.sliding_velocity, exact.sliding_velocity, errors.sample_velocity);
  expect(computed.friction_force, exact.friction_force, errors.friction_force);
}

TEST_P(ContactBattery, FollowsTheExactHistory) {
  const auto& [problem, engine] = GetParam();
  record_requirement(engine.requirement);
  const ContactErrors errors = engine.errors(*problem).value();
  const ContactHistory computed = engine.run(*problem), exact = exact_history(*problem);
  ASSERT_EQ(computed.samples.size(), problem->sample_times.size());
  if (errors.time) expect_events(computed, exact, errors);
  if (errors.sample_position)
    for (std::size_t i = 0; i < exact.samples.size(); ++i) {
      SCOPED_TRACE(problem->sample_times[i]);
      expect_sample(computed.samples[i], exact.samples[i], errors);
    }
  if (!errors.friction_power) return;
  const double way = computed.samples[1].way - computed.samples[0].way;
  EXPECT_TRUE(within(problem->mass.normal_force * way / (problem->sample_times[1] - problem->sample_times[0]),
                     *problem->friction_power, *errors.friction_power));
}

INSTANTIATE_TEST_SUITE_P(Contact, ContactBattery, ::testing::ValuesIn(all_runs()), [](const auto& instance) {
  return instance.param.problem->name + "_" + instance.param.engine.name;
});

}  // namespace
}  // namespace stickslip::testing
