// SPDX-License-Identifier: MIT
/// Friction problems of others, one or two masses with one contact, by both implementations against the closed forms of the data
/// sets `published-problems`, `stops-per-period` and `non-stop-limits`, which the README of data/reference states; and a friction
/// law that jumps.

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/modal_contact_run.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/history/contact_growth.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr double jump = std::numeric_limits<double>::infinity();

/// One mass m x_tt + k x = F + G sin(Omega t) + f_d; with `end_of_pull` two: the second one hangs on the first one's spring, and F
/// pulls it until then.
struct MassProblem {
  SingleMass mass;
  double force{}, amplitude{};
  double position{};
  std::optional<double> velocity{};  // without it the mass starts stuck
  double time_step{};
  std::optional<double> end_of_pull{};
};

// A block of 1 kg.
MassProblem on_an_incline(double slope, std::optional<double> velocity) {
  const double g = 9.81, cosine = 1.0 / std::hypot(1.0, slope);
  return {.mass = {.normal_force = g * cosine,
                   .friction = {.static_coefficient = 0.5, .kinetic_coefficient = 0.3, .decay = jump}},
          .force = g * slope * cosine,
          .position = 0.25,
          .velocity = velocity,
          .time_step = 0.1};
}

MassProblem forced(double force_ratio, double frequency_ratio, double position = 0.0,
                   std::optional<double> velocity = {}) {
  const double rate = 10.0 * frequency_ratio;
  return {.mass = {.stiffness = 100.0,
                   .normal_force = 5.0,
                   .friction = {.static_coefficient = 1.0, .kinetic_coefficient = 1.0},
                   .omega = rate},
          .amplitude = 5.0 * force_ratio,
          .position = position,
          .velocity = velocity,
          .time_step = 2.0 * std::numbers::pi / std::max(rate, 10.0) / 500.0};
}

const std::map<std::string, MassProblem>& problems() {
  static const std::map<std::string, MassProblem> all{
      {"incline-stays", on_an_incline(0.45, {})},
      {"incline-slides", on_an_incline(0.55, {})},
      {"incline-goes-on", on_an_incline(0.45, 1.0)},
      {"sdnd100",
       {.mass = {.stiffness = 1e4, .normal_force = 10.0, .friction = coulomb},
        .position = 0.85e-3,
        .velocity = 0.0,
        .time_step = 1e-3}},
      {"sdnd106",
       {.mass = {.mass = 5.0,
                 .stiffness = 1e4,
                 .normal_force = 1e4,
                 .friction = {.static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = jump}},
        .force = 3000.0,
        .time_step = 1e-3,
        .end_of_pull = 0.2}},
      {"den-hartog", forced(4.0, 0.8, -0.173009592359444, 4.00402328243824)},
      {"hong-liu-1", forced(3.0, 0.5)},
      {"hong-liu-2", forced(3.0, 0.3)},
      {"hong-liu-4", forced(3.0, 0.2)},
      {"hong-liu-6", forced(1.5, 0.06)}};
  return all;
}

// The changes up to the last of the times, and the positions at the times.
struct MassHistory {
  std::vector<data::ContactEvent> changes;
  std::vector<double> positions;

  void add(const std::vector<data::ContactEvent>& events, double start) {
    for (const data::ContactEvent& event : events) {
      changes.push_back(event);
      changes.back().time += start;
    }
  }
  [[nodiscard]] int captures_between(double from, double to) const {
    return static_cast<int>(std::ranges::count_if(changes, [&](const data::ContactEvent& event) {
      return event.change == data::ContactChange::capture && event.time > from && event.time < to;
    }));
  }
};

using Times = std::vector<double>;

analytic::ContactModel mass_model(const MassProblem& problem) {
  const SingleMass& mass = problem.mass;
  analytic::ContactModel model = contact_model(mass);
  model.load = {problem.amplitude};
  model.contact_force = problem.force;
  if (!problem.end_of_pull) return model;
  // x_2 = x_1 + F/k + T/sqrt(m).
  model.angular_frequency = {std::sqrt(mass.stiffness / mass.mass)};
  model.mass_coupling = {std::sqrt(mass.mass)};
  model.contact_mass = 2.0 * mass.mass;
  model.contact_stiffness = 0.0;
  model.follower = {0.0};
  model.load = {0.0, 0.0};
  return model;
}

MassHistory event_by_event(const MassProblem& problem, const Times& times) {
  MassHistory history;
  const auto run_on = [&history](analytic::EventDriven& run, double start, const Times& until) {
    for (const double t : until) {
      run.advance_to(t - start);
      history.positions.push_back(run.contact_position());
    }
    history.add(run.events(), start);
  };
  analytic::EventDriven run(mass_model(problem));
  if (!problem.end_of_pull) {
    if (problem.velocity)
      run.start_slipping({}, {}, problem.position, *problem.velocity);
    else
      run.start_stuck({}, {}, problem.position);
    run_on(run, 0.0, times);
    return history;
  }
  const double stretch = problem.force / problem.mass.stiffness * std::sqrt(problem.mass.mass);
  run.start_stuck({-stretch}, {0.0});
  run_on(run, 0.0, {*problem.end_of_pull});
  MassProblem free = problem;
  free.force = 0.0;
  analytic::EventDriven on(mass_model(free));
  on.start_slipping({run.amplitudes()[0] + stretch}, run.rates(), run.contact_position(),
                    run.contact_velocity());
  run_on(on, *problem.end_of_pull, {times.back()});
  return history;
}

solver::ContactSystem mass_system(const MassProblem& problem) {
  const SingleMass& mass = problem.mass;
  solver::ContactSystem system = contact_system(mass);
  if (problem.end_of_pull) {
    const Eigen::Matrix2d inertia = mass.mass * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d stiffness = mass.stiffness * Eigen::Matrix2d{{1.0, -1.0}, {-1.0, 1.0}};
    system.mass = inertia.sparseView();
    system.damping = solver::SparseMatrix(2, 2);
    system.stick_stiffness = system.slip_stiffness = stiffness.sparseView();
  }
  system.load_shape = Eigen::VectorXd::Unit(system.mass.rows(), system.mass.rows() - 1);
  system.load_history = [problem](double t) {
    return problem.force + problem.amplitude * std::sin(problem.mass.omega * t);
  };
  return system;
}

// To the last of the times, which must be on the grid where the position is asked for.
MassHistory step_by_step(const MassProblem& problem, const Times& times, double h) {
  MassHistory history;
  const auto step_on = [&](solver::StickSlipIntegrator& run, double start, const Times& until) {
    for (const double t : until) {
      while (run.time() < t - start - 1e-9 * h) run.step();
      history.positions.push_back(run.displacement()[0]);
    }
    history.add(run.events(), start);
  };
  const solver::IntegratorSettings settings{.time_step = h, .spectral_radius = 0.9};
  solver::StickSlipIntegrator run(mass_system(problem), settings);
  const Eigen::VectorXd first = Eigen::VectorXd::Unit(problem.end_of_pull ? 2 : 1, 0);
  if (problem.velocity)
    run.start_slipping(problem.position * first, *problem.velocity * first);
  else
    run.start_stuck(problem.position * first, 0.0 * first);
  step_on(run, 0.0, problem.end_of_pull ? Times{*problem.end_of_pull} : times);
  if (!problem.end_of_pull) return history;
  MassProblem free = problem;
  free.force = 0.0;
  solver::StickSlipIntegrator on(mass_system(free), settings);
  on.start_slipping(run.displacement(), run.velocity());
  step_on(on, *problem.end_of_pull, {times.back()});
  return history;
}

// About so long steps: a whole number in a period. A change is not located.
MassHistory in_fixed_steps(const MassProblem& problem, double end, double h) {
  const analytic::ContactModel model = mass_model(problem);
  const analytic::ContactModes modes(model);
  const int steps = static_cast<int>(std::lround(2.0 * std::numbers::pi / problem.mass.omega / h));
  analytic::ModalContactRun run(modes, model, steps);
  run.start({.amplitudes = {},
             .rates = {},
             .displacement = problem.position,
             .velocity = problem.velocity.value_or(0.0)});
  const auto direction = [&] { return run.slips() ? std::copysign(1.0, run.sliding_velocity()) : 0.0; };
  MassHistory history;
  while (run.time() < end) {
    const double before = direction(), position = run.contact_position();
    run.step();
    const bool starts_to_slip = run.steps() == 1 && problem.velocity;  // which is no change
    if (direction() == before || (starts_to_slip && before == 0.0)) continue;
    if (before == 0.0)
      history.changes.push_back({data::ContactChange::onset, run.time() - run.time_step(), position});
    else
      history.changes.push_back(
          {direction() == 0.0 ? data::ContactChange::capture : data::ContactChange::reversal, run.time(),
           run.contact_position()});
  }
  return history;
}

/// The rows of a problem: changes of the contact, or states at given times.
struct PublishedRows {
  std::vector<std::string> change;
  Times time;
  std::vector<double> position;
  [[nodiscard]] bool are_states() const { return change.front() == "state"; }
};

/// The largest errors over the rows, s and m; as many changes of the same kinds are expected.
std::pair<double, double> errors_of(const MassHistory& history, const PublishedRows& rows) {
  std::pair<double, double> error;
  if (!rows.are_states()) {
    EXPECT_GE(history.changes.size(), rows.time.size());
  }
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    if (rows.are_states()) {
      error.second = largest_or_nan({error.second, std::abs(history.positions[i] - rows.position[i])});
    } else if (i < history.changes.size()) {
      const data::ContactEvent& change = history.changes[i];
      EXPECT_EQ(data::to_string(change.change), rows.change[i]) << i;
      error.first = largest_or_nan({error.first, std::abs(change.time - rows.time[i])});
      error.second = largest_or_nan({error.second, std::abs(change.position - rows.position[i])});
    }
  }
  return error;
}

// The event-driven run keeps 1e-12 of each coordinate in a step. The time stepper is of second order. In fixed steps without
// location, for a mass on a spring, a change falls somewhere in a step, so that its time is late by less than one, and what that
// costs is of second order, but scatters: over two halvings the position gains a factor 16 to within 3.
void expect_rows(const MassProblem& problem, const std::string& name, const PublishedRows& rows) {
  double largest = 0.0;
  for (const double position : rows.position) largest = std::max(largest, std::abs(position));
  // A little more than the last event, so that no late one is missed.
  const Times times = rows.are_states() ? rows.time : Times{rows.time.back() + 4.0 * problem.time_step};
  const double natural = std::sqrt(problem.mass.stiffness / problem.mass.mass);
  const double share = 1e-12 * (1.0 + std::max(natural, problem.mass.omega) * rows.time.back());
  const auto exact = errors_of(event_by_event(problem, times), rows);
  EXPECT_TRUE(within(exact.first, 0.0, discretisation(share * rows.time.back(), 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(exact.second, 0.0, discretisation(share * largest, 1.0, "1e-12 a step")));
  const bool has_spring = !problem.end_of_pull && problem.mass.stiffness > 0.0;
  std::vector<std::pair<double, double>> stepped, fixed;
  for (int level = 0; level < 3; ++level) {
    const double h = std::ldexp(problem.time_step, -level);
    stepped.push_back(errors_of(step_by_step(problem, times, h), rows));
    const auto& [time, position] = stepped.back();
    if (name.starts_with("incline")) {  // constant forces: exact but for the rounding of 10 to 200 steps
      EXPECT_TRUE(within(position, 0.0, round_off(100.0 / h, 1, largest)));
    } else if (level > 0) {
      const auto& [longer_time, longer_position] = stepped[stepped.size() - 2];
      EXPECT_GT(longer_time, 3.5 * time);
      EXPECT_LT(longer_time, 4.5 * time);
      EXPECT_GT(longer_position, 3.5 * position);
    }
    if (!has_spring) continue;
    fixed.push_back(errors_of(in_fixed_steps(problem, times.back(), h), rows));
    EXPECT_LT(fixed.back().first, 1.5 * h);
  }
  if (has_spring) {
    EXPECT_LT(fixed[2].second, fixed[0].second * 3.0 / 16.0);
    EXPECT_LT(fixed[2].second, 1e-4 * largest);
  }
  if (name == "incline-stays") {  // no creep below the friction angle, in 100 s
    EXPECT_EQ(exact.second, 0.0);
    for (const auto& run : stepped) EXPECT_EQ(run.second, 0.0);
  }
}

STICKSLIP_VERIFIES(PublishedProblems, "F6");
TEST(PublishedProblems, AreSolvedByBothImplementations) {
  const data::ReferenceTable table = data::read_table(data::load_reference(), "published-problems");
  std::size_t tried = 0;
  for (std::size_t row = 0; row < table.rows(); ++tried) {
    const std::string name = table.column("problem").text[row];
    PublishedRows rows;
    for (; row < table.rows() && table.column("problem").text[row] == name; ++row) {
      rows.change.push_back(table.column("change").text[row]);
      rows.time.push_back(table.column("time").values[row]);
      rows.position.push_back(table.column("position").values[row]);
    }
    SCOPED_TRACE(name);
    expect_rows(problems().at(name), name, rows);
  }
  EXPECT_EQ(tried, problems().size());
}

// The captures in a period of the force, from rest. By Hong and Liu in the fourth, and beside Den Hartog's limit in the 40th.
TEST(PublishedProblems, AForcedMassStopsAsOftenAsPublished) {
  const auto package = data::load_reference();
  const auto expect_stops = [](const data::ReferenceTable& table, double share, int number,
                               const auto& stops) {
    EXPECT_GT(table.rows(), 0u);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double force = share * table.column("force_ratio").values[row];
      const double frequency = table.column("frequency_ratio").values[row];
      const MassProblem problem = forced(force, frequency);
      const double length = 2.0 * std::numbers::pi / problem.mass.omega, to = number * length;
      EXPECT_EQ(event_by_event(problem, {to}).captures_between(to - length, to), stops(row))
          << frequency << ", " << force;
      EXPECT_EQ(step_by_step(problem, {to}, problem.time_step).captures_between(to - length, to), stops(row))
          << frequency << ", " << force;
    }
  };
  const auto counts = data::read_table(package, "stops-per-period");
  const std::vector<double>& stops = counts.column("stops").values;
  EXPECT_EQ(std::set<double>(stops.begin(), stops.end()), (std::set<double>{0, 1, 2, 4, 6, 8}));
  expect_stops(counts, 1.0, 4, [&](std::size_t row) { return static_cast<int>(stops[row]); });
  const auto limits = data::read_table(package, "non-stop-limits");
  expect_stops(limits, 0.99, 40, [](std::size_t) { return 2; });
  expect_stops(limits, 1.01, 40, [](std::size_t) { return 0; });
}

constexpr data::FrictionCoefficients jumping{
    .static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = jump};

STICKSLIP_VERIFIES(JumpOfFriction, "P2");
TEST(JumpOfFriction, IsTheLimitOfEverFasterDecay) {
  const data::FrictionLaw law = data::FrictionLaw(jumping).in_slip();
  for (const double v : {0.0, 1e-300, 1.0}) EXPECT_EQ(solver::friction_coefficient(law, v), 0.2);
  data::FrictionCoefficients fast = jumping;
  fast.decay = 1e6;
  EXPECT_DOUBLE_EQ(solver::friction_coefficient(data::FrictionLaw(fast), 1.0), 0.2);
  EXPECT_EQ(data::FrictionLaw(fast).in_slip().decay(), 1e6);
  EXPECT_EQ(studies::weakening(data::FrictionLaw(jumping), 10.0), 0.0);  // nothing grows in slip
}

TEST(JumpOfFriction, KeepsTheEnergyBalanceUnderAConstantForce) {
  // 4 N pull a mass that 2 N hold in slip: x = t^2, of which half the work is lost.
  analytic::ContactModel model = contact_model(SingleMass{.normal_force = 10.0, .friction = jumping});
  model.contact_force = 4.0;
  analytic::EventDriven run(model, {.keep_energy_balance = true});
  run.start_stuck({}, {});
  run.advance_to(3.0);
  EXPECT_TRUE(within(run.contact_position(), 9.0, discretisation(9e-12, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(run.energy_balance().base_work, 36.0, discretisation(36e-12, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(run.energy_balance().friction_loss, 18.0, discretisation(36e-12, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(run.energy_balance().kinetic, 18.0, discretisation(36e-12, 1.0, "1e-12 a step")));
}

TEST(JumpOfFriction, IsRefusedWhereAStepCouldBothStickAndSlip) {
  EXPECT_THROW(analytic::require_unique_step({10.0, data::FrictionLaw(jumping)}, 1e-9), data::FieldError);
}

}  // namespace
}  // namespace stickslip::testing
