// SPDX-License-Identifier: MIT
#include "support/published_problems.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/modal_contact_run.hpp"
#include "stickslip/data/contact_event.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"
#include "studies/convergence/convergence.hpp"

namespace stickslip::testing {
namespace {

using std::numbers::pi;
using studies::largest_or_nan;

constexpr double jump = std::numeric_limits<double>::infinity();

/// One mass m x_tt + k x = F + G sin(Omega t) + f_d, or two: the second one hangs on the first one's spring,
/// and F pulls it until `end_of_pull`.
struct MassProblem {
  double mass{1.0}, stiffness{};
  double force{}, amplitude{}, rate{1.0};
  double normal_force{};
  data::FrictionCoefficients friction{};
  double position{};
  std::optional<double> velocity{};  // without it the mass starts stuck
  double time_step{};
  bool is_pair{};
  double end_of_pull{};
};

constexpr data::FrictionCoefficients incline_friction{
    .static_coefficient = 0.5, .kinetic_coefficient = 0.3, .decay = jump};

// A block of 1 kg.
MassProblem on_an_incline(double slope, std::optional<double> velocity) {
  const double g = 9.81, cosine = 1.0 / std::hypot(1.0, slope);
  return {.force = g * slope * cosine,
          .normal_force = g * cosine,
          .friction = incline_friction,
          .position = 0.25,
          .velocity = velocity,
          .time_step = 0.1};
}

MassProblem forced(double force_ratio, double frequency_ratio) {
  const double rate = 10.0 * frequency_ratio;
  return {.stiffness = 100.0,
          .amplitude = 5.0 * force_ratio,
          .rate = rate,
          .normal_force = 5.0,
          .friction = {.static_coefficient = 1.0, .kinetic_coefficient = 1.0},
          .time_step = 2.0 * pi / std::max(rate, 10.0) / 500.0};
}

MassProblem problem_named(const std::string& name) {
  if (name == "incline-stays") return on_an_incline(0.45, std::nullopt);
  if (name == "incline-slides") return on_an_incline(0.55, std::nullopt);
  if (name == "incline-goes-on") return on_an_incline(0.45, 1.0);
  if (name == "sdnd100")
    return {.stiffness = 1e4,
            .normal_force = 10.0,
            .friction = {.static_coefficient = 0.1, .kinetic_coefficient = 0.1},
            .position = 0.85e-3,
            .velocity = 0.0,
            .time_step = 1e-3};
  if (name == "sdnd106")
    return {.mass = 5.0,
            .stiffness = 1e4,
            .force = 3000.0,
            .normal_force = 1e4,
            .friction = {.static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = jump},
            .time_step = 1e-3,
            .is_pair = true,
            .end_of_pull = 0.2};
  if (name == "den-hartog") {
    MassProblem steady = forced(4.0, 0.8);
    steady.position = -0.173009592359444;
    steady.velocity = 4.00402328243824;
    return steady;
  }
  if (name == "hong-liu-1") return forced(3.0, 0.5);
  if (name == "hong-liu-2") return forced(3.0, 0.3);
  if (name == "hong-liu-4") return forced(3.0, 0.2);
  if (name == "hong-liu-6") return forced(1.5, 0.06);
  throw std::logic_error("the study has no problem " + name);
}

// The changes up to the last of the times, and the positions at the times.
struct MassHistory {
  std::vector<data::ContactEvent> changes;
  std::vector<double> positions;

  void add(const std::vector<data::ContactEvent>& events, double start) {
    for (data::ContactEvent event : events) {
      event.time += start;
      changes.push_back(event);
    }
  }
  [[nodiscard]] int captures_between(double from, double to) const {
    return static_cast<int>(std::ranges::count_if(changes, [&](const data::ContactEvent& event) {
      return event.change == data::ContactChange::capture && event.time > from && event.time < to;
    }));
  }
};

analytic::ContactModel contact_model(const MassProblem& problem) {
  analytic::ContactModel model{.angular_frequency = {},
                               .mass_coupling = {},
                               .contact_mass = problem.mass,
                               .contact_stiffness = problem.stiffness,
                               .follower = {},
                               .damping = {},
                               .load = {problem.amplitude},
                               .contact_force = problem.force,
                               .load_angular_frequency = problem.rate,
                               .normal_force = problem.normal_force,
                               .friction = data::FrictionLaw(problem.friction)};
  if (!problem.is_pair) return model;
  // x_2 = x_1 + F/k + T/sqrt(m).
  model.angular_frequency = {std::sqrt(problem.stiffness / problem.mass)};
  model.mass_coupling = {std::sqrt(problem.mass)};
  model.contact_mass = 2.0 * problem.mass;
  model.contact_stiffness = 0.0;
  model.follower = {0.0};
  model.load = {0.0, 0.0};
  return model;
}

void run_on(analytic::EventDriven& run, double start, const std::vector<double>& times,
            MassHistory& history) {
  for (const double t : times) {
    run.advance_to(t - start);
    history.positions.push_back(run.contact_position());
  }
  history.add(run.events(), start);
}

MassHistory event_driven(const MassProblem& problem, const std::vector<double>& times) {
  MassHistory history;
  analytic::EventDriven run(contact_model(problem));
  if (!problem.is_pair) {
    if (problem.velocity)
      run.start_slipping({}, {}, problem.position, *problem.velocity);
    else
      run.start_stuck({}, {}, problem.position);
    run_on(run, 0.0, times, history);
    return history;
  }
  const double root = std::sqrt(problem.mass), stretch = problem.force / problem.stiffness;
  run.start_stuck({-stretch * root}, {0.0});
  run_on(run, 0.0, {problem.end_of_pull}, history);
  MassProblem free = problem;
  free.force = 0.0;
  analytic::EventDriven on(contact_model(free));
  on.start_slipping({run.amplitudes()[0] + stretch * root}, run.rates(), run.contact_position(),
                    run.contact_velocity());
  run_on(on, problem.end_of_pull, {times.back()}, history);
  return history;
}

solver::ContactSystem contact_system(const MassProblem& problem) {
  const Eigen::Index n = problem.is_pair ? 2 : 1;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Constant(n, n, problem.stiffness);
  if (problem.is_pair) stiffness(0, 1) = stiffness(1, 0) = -problem.stiffness;
  const solver::SparseMatrix k = stiffness.sparseView();
  const auto zero = [](double) { return 0.0; };
  const Eigen::MatrixXd mass = problem.mass * Eigen::MatrixXd::Identity(n, n);
  return {.mass = mass.sparseView(),
          .damping = solver::SparseMatrix(n, n),
          .stick_stiffness = k,
          .slip_stiffness = k,
          .load_shape = Eigen::VectorXd::Unit(n, n - 1),
          .load_history =
              [problem](double t) { return problem.force + problem.amplitude * std::sin(problem.rate * t); },
          .contact = 0,
          .wall = {zero, zero, zero},
          .normal_force = problem.normal_force,
          .friction = data::FrictionLaw(problem.friction)};
}

// Steps to the last of the times, which must be on the grid where the position is asked for.
void step_on(solver::StickSlipIntegrator& run, double start, const std::vector<double>& times, double h,
             MassHistory& history) {
  for (const double t : times) {
    while (run.time() < t - start - 1e-9 * h) run.step();
    history.positions.push_back(run.displacement()[0]);
  }
  history.add(run.events(), start);
}

MassHistory stepped(const MassProblem& problem, const std::vector<double>& times, double h) {
  const solver::IntegratorSettings settings{.time_step = h, .spectral_radius = 0.9};
  solver::StickSlipIntegrator run(contact_system(problem), settings);
  const Eigen::Index n = problem.is_pair ? 2 : 1;
  const Eigen::VectorXd position = problem.position * Eigen::VectorXd::Unit(n, 0);
  if (problem.velocity)
    run.start_slipping(position, *problem.velocity * Eigen::VectorXd::Unit(n, 0));
  else
    run.start_stuck(position, Eigen::VectorXd::Zero(n));
  MassHistory history;
  if (!problem.is_pair) {
    step_on(run, 0.0, times, h, history);
    return history;
  }
  step_on(run, 0.0, {problem.end_of_pull}, h, history);
  MassProblem free = problem;
  free.force = 0.0;
  solver::StickSlipIntegrator on(contact_system(free), settings);
  on.start_slipping(run.displacement(), run.velocity());
  step_on(on, problem.end_of_pull, {times.back()}, h, history);
  return history;
}

// About so long steps: a whole number in a period.
MassHistory fixed_steps(const MassProblem& problem, double end, double h) {
  const analytic::ContactModel model = contact_model(problem);
  const analytic::ContactModes modes(model);
  analytic::ModalContactRun run(modes, model, static_cast<int>(std::lround(2.0 * pi / problem.rate / h)));
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

/// The rows of a problem.
struct Rows {
  std::vector<std::string> change;
  std::vector<double> time, position;
};

ProblemErrors errors_of(const MassHistory& history, const Rows& rows) {
  ProblemErrors errors{.same_changes = true};
  if (rows.change.front() == "state") {
    for (std::size_t i = 0; i < rows.time.size(); ++i)
      errors.position = largest_or_nan({errors.position, std::abs(history.positions[i] - rows.position[i])});
    return errors;
  }
  errors.same_changes = history.changes.size() >= rows.time.size();
  for (std::size_t i = 0; i < std::min(rows.time.size(), history.changes.size()); ++i) {
    const data::ContactEvent& change = history.changes[i];
    errors.same_changes &= data::to_string(change.change) == rows.change[i];
    errors.time = largest_or_nan({errors.time, std::abs(change.time - rows.time[i])});
    errors.position = largest_or_nan({errors.position, std::abs(change.position - rows.position[i])});
  }
  return errors;
}

PublishedProblem solved(const std::string& name, const Rows& rows) {
  const MassProblem problem = problem_named(name);
  PublishedProblem result;
  result.name = name;
  result.duration = rows.time.back();
  for (const double position : rows.position)
    result.amplitude = std::max(result.amplitude, std::abs(position));
  // A little more than the last event, so that no late one is missed.
  const bool has_states = rows.change.front() == "state";
  const auto times = has_states ? rows.time : std::vector{rows.time.back() + 4.0 * problem.time_step};
  result.event_driven = errors_of(event_driven(problem, times), rows);
  const double fastest = std::max(std::sqrt(problem.stiffness / problem.mass), problem.rate);
  result.event_driven_prediction = 1e-12 * (1.0 + fastest * result.duration);
  for (std::size_t level = 0; level < 3; ++level) {
    result.time_step[level] = problem.time_step / std::pow(2.0, level);
    result.stepped[level] = errors_of(stepped(problem, times, result.time_step[level]), rows);
  }
  result.has_spring = !problem.is_pair && problem.stiffness > 0.0;
  for (std::size_t level = 0; result.has_spring && level < 3; ++level)
    result.fixed_steps[level] = errors_of(fixed_steps(problem, times.back(), result.time_step[level]), rows);
  return result;
}

// The captures in a period, from rest, under the forces of a data set times `share`.
std::vector<StopCount> stop_counts(const data::ReferenceTable& table, double share, int period) {
  std::vector<StopCount> counts;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double force_ratio = share * table.column("force_ratio").values[row];
    const MassProblem problem = forced(force_ratio, table.column("frequency_ratio").values[row]);
    const double length = 2.0 * pi / problem.rate, from = (period - 1) * length, to = period * length;
    counts.push_back({table.column("frequency_ratio").values[row], force_ratio, -1,
                      event_driven(problem, {to}).captures_between(from, to),
                      stepped(problem, {to}, problem.time_step).captures_between(from, to)});
  }
  return counts;
}

}  // namespace

std::vector<PublishedProblem> published_problems(const data::ReferencePackage& package) {
  const data::ReferenceTable table = data::read_table(package, "published-problems");
  std::vector<PublishedProblem> problems;
  for (std::size_t row = 0; row < table.rows();) {
    const std::string name = table.column("problem").text[row];
    Rows rows;
    for (; row < table.rows() && table.column("problem").text[row] == name; ++row) {
      rows.change.push_back(table.column("change").text[row]);
      rows.time.push_back(table.column("time").values[row]);
      rows.position.push_back(table.column("position").values[row]);
    }
    problems.push_back(solved(name, rows));
  }
  return problems;
}

std::vector<StopCount> stops_per_period(const data::ReferencePackage& package) {
  const data::ReferenceTable table = data::read_table(package, "stops-per-period");
  auto counts = stop_counts(table, 1.0, 4);
  for (std::size_t row = 0; row < counts.size(); ++row)
    counts[row].reference = static_cast<int>(table.column("stops").values[row]);
  return counts;
}

std::vector<StopCount> stops_beside_the_limit(const data::ReferencePackage& package, double share) {
  return stop_counts(data::read_table(package, "non-stop-limits"), share, 40);
}

}  // namespace stickslip::testing
