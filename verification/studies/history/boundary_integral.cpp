// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/steady_sliding.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/contact_growth.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

// The steps of a run, and what they leave at the times of the rows.
struct ContactRun {
  std::vector<analytic::ContactStep> steps;
  double time_step{};
  std::vector<double> position;              // of the contact on the wall, m
  std::vector<std::vector<double>> motions;  // at other places, m
};

// The holding force of a model, constant over each step, is that of its middle.
std::vector<analytic::ContactStep> steps_of_model(const data::Case& problem, const analytic::TimeGrid& grid) {
  const analytic::ContactModel model = analytic::contact_model(problem, problem.numerics.modes());
  const analytic::ContactLaw law{problem.normal_force(), problem.contact.friction, problem.contact.compliance,
                                 grid.time_step};
  const auto middle = [&](std::size_t n) { return (static_cast<double>(n) + 0.5) * grid.time_step; };
  std::vector<double> holding_force(grid.steps);
  if (model.drive) {
    holding_force = analytic::holding_force(model, grid);
  } else {
    const double duration = static_cast<double>(grid.steps) * grid.time_step;
    const analytic::DampedForce force(analytic::damped_reaction(model, analytic::SteadyPart::exact),
                                      model.load_angular_frequency, duration);
    for (std::size_t n = 0; n < grid.steps; ++n)
      holding_force[n] = -problem.excitation().amplitude() * force.value(middle(n)) - problem.constant_force;
  }
  return contact_steps(analytic::mobility_weights(analytic::contact_mobility(model), grid.time_step,
                                                  grid.steps, analytic::usual_stages),
                       law, holding_force);
}

ContactRun contact_run_of(const data::Case& problem, std::size_t steps_per_row,
                          const std::vector<double>& places) {
  const double row_step = problem.numerics.time_step();
  const auto rows = static_cast<std::size_t>(solver::step_count(problem.numerics.duration(), row_step));
  const analytic::TimeGrid grid{row_step / static_cast<double>(steps_per_row), rows * steps_per_row};
  ContactRun run{.steps = {}, .time_step = grid.time_step, .position = {}, .motions = {}};
  if (problem.model() != nullptr) {
    run.steps = steps_of_model(problem, grid);
  } else {
    const analytic::BeamBoundaryIntegral beam(problem, grid);
    for (const double x : places) run.motions.push_back(beam.displacement(x, steps_per_row));
    run.steps = beam.steps();
  }
  run.position = analytic::contact_positions(run.steps, grid.time_step, steps_per_row);
  return run;
}

std::vector<double> places_of(const data::Case& problem, const Sampling& sampling) {
  std::vector<double> places = sampling.positions;
  if (sampling.with_midspan && problem.model() == nullptr) places.push_back(0.5 * problem.beam().length());
  return places;
}

History history_of(const data::Case& problem, const Sampling& sampling, const ContactRun& run,
                   std::size_t steps_per_row, const RowSink& sink) {
  solver::PrescribedMotion base;
  if (!problem.is_force()) base = solver::base_motion(problem.motion);
  // Positions on the wall become positions in the frame at rest.
  const solver::PrescribedMotion moving_wall = solver::wall_motion(problem, base);
  const auto wall = [&](double t) {
    return moving_wall.displacement(t) - moving_wall.displacement(0.0) + base.displacement(t);
  };
  History history;
  // A step obeys the law, and a row is the mean of two.
  for (const analytic::ContactStep& step : run.steps)
    hold_to_law(problem, history,
                {.time = static_cast<double>(&step - run.steps.data()) * run.time_step,
                 .sliding_velocity = step.sliding_velocity,
                 .friction_force = -step.friction_force,
                 .state = step.slides ? data::ContactState::slip : data::ContactState::stick});
  for_each_row(problem, sampling, [&](long step, double time) {
    const auto n = static_cast<std::size_t>(step);
    HistoryRow row = contact_between(run.steps, n * steps_per_row);
    row.time = time;
    row.base_displacement = base.displacement(time);
    row.tip_displacement = run.position[n] + wall(time);
    if (run.motions.size() > sampling.positions.size()) row.midspan_displacement = run.motions.back()[n];
    for (std::size_t k = 0; k < sampling.positions.size(); ++k) row.displacement.push_back(run.motions[k][n]);
    add_row(problem, history, sink, std::move(row));
  });
  // A smooth law has no stick.
  if (!problem.contact.compliance.is_smooth()) {
    auto events = events_between(run.steps, run.time_step);
    for (auto& event : events) event.position += wall(event.time);
    set_events(history, std::move(events));
  }
  return history;
}

}  // namespace

double boundary_integral_step(const data::Case& problem) {
  constexpr double steps_per_period = 20000.0;
  double highest = data::highest_frequency_hz(problem);
  for (const auto& mode : analytic::held_modes(problem, 1))
    highest = std::max(highest, mode.angular_frequency / two_pi);
  const double rated = problem.numerics.time_step(),
               kappa = weakening(problem.contact.friction, problem.normal_force());
  double step = rated;
  while (step * highest * steps_per_period > 1.0) step *= 0.5;
  // Each step has one solution, and of twice the step, which History::step_effect takes. Of a law that jumps none has.
  const analytic::Mobility mobility =
      problem.model() != nullptr
          ? analytic::contact_mobility(analytic::contact_model(problem, problem.numerics.modes()))
          : analytic::TipMobility(problem.beam(), problem.damping);
  const auto has_one_solution = [&](double h) {
    return kappa * analytic::mobility_weights(mobility, h, 1, analytic::usual_stages).front() < 1.0;
  };
  while (std::isfinite(kappa) && step > std::ldexp(rated, -40) &&
         !has_one_solution(std::min(2.0 * step, rated)))
    step *= 0.5;
  return step;
}

HistoryRow contact_between(const std::vector<analytic::ContactStep>& steps, std::size_t step) {
  const auto& before = steps[step == 0 ? 0 : step - 1];
  const auto& after = steps[step == steps.size() ? steps.size() - 1 : step];
  const double force = step == 0 && steps.size() > 1
                           ? 1.5 * steps[0].friction_force - 0.5 * steps[1].friction_force
                           : 0.5 * (before.friction_force + after.friction_force);
  return {.sliding_velocity =
              before.sliding_velocity == 0.0 ? 0.0 : 0.5 * (before.sliding_velocity + after.sliding_velocity),
          .friction_force = -force,
          .state = before.slides ? data::ContactState::slip : data::ContactState::stick};
}

std::vector<data::ContactEvent> events_between(const std::vector<analytic::ContactStep>& steps,
                                               double time_step) {
  using data::ContactChange;
  std::vector<data::ContactEvent> events;
  double position = 0.0, direction = 0.0;  // 0: stick
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const double velocity = steps[n].sliding_velocity;
    const double next = steps[n].slides ? std::copysign(1.0, velocity) : 0.0;
    if (next != direction)
      events.push_back({.change = direction == 0.0 ? ContactChange::onset
                                  : next == 0.0    ? ContactChange::capture
                                                   : ContactChange::reversal,
                        .time = static_cast<double>(n) * time_step,
                        .position = position});
    direction = next;
    position += time_step * velocity;
  }
  return events;
}

History boundary_integral_history(const data::Case& problem, const Sampling& sampling,
                                  int steps_per_time_step) {
  const auto steps = static_cast<std::size_t>(steps_per_time_step);
  return history_of(problem, sampling, contact_run_of(problem, steps, places_of(problem, sampling)), steps,
                    {});
}

History boundary_integral_history(const data::Case& problem, const Sampling& sampling,
                                  const solver::RunOptions&, const RowSink& sink) {
  const auto steps =
      static_cast<std::size_t>(std::lround(problem.numerics.time_step() / boundary_integral_step(problem)));
  const ContactRun run = contact_run_of(problem, steps, places_of(problem, sampling));
  History history = history_of(problem, sampling, run, steps, sink);
  if (steps > 1)
    history.step_effect = largest_difference(run.position, contact_run_of(problem, steps / 2, {}).position);
  return history;
}

}  // namespace stickslip::studies
