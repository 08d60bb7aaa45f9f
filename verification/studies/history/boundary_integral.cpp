// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/contact_growth.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

analytic::BeamBoundaryIntegral boundary_integral_of(const data::Case& problem, std::size_t steps_per_row) {
  const double row_step = problem.numerics.time_step();
  const auto rows = static_cast<std::size_t>(solver::step_count(problem.numerics.duration(), row_step));
  return {problem, {row_step / static_cast<double>(steps_per_row), rows * steps_per_row}};
}

History history_of(const data::Case& problem, const Sampling& sampling,
                   const analytic::BeamBoundaryIntegral& run, std::size_t steps_per_row,
                   const RowSink& sink) {
  const std::vector<double> tip = run.tip_displacement(steps_per_row);
  std::vector<double> positions = sampling.positions;
  if (sampling.with_midspan) positions.push_back(0.5 * problem.beam().length());
  std::vector<std::vector<double>> motions;
  for (const double x : positions) motions.push_back(run.displacement(x, steps_per_row));
  const solver::PrescribedMotion base = solver::base_motion(problem.motion);
  History history;
  // A step obeys the law, and a row is the mean of two.
  for (const analytic::ContactStep& step : run.steps())
    hold_to_law(problem, history,
                {.time = static_cast<double>(&step - run.steps().data()) * run.grid().time_step,
                 .sliding_velocity = step.sliding_velocity,
                 .friction_force = -step.friction_force,
                 .state = step.slides ? data::ContactState::slip : data::ContactState::stick});
  for_each_row(problem, sampling, [&](long step, double time) {
    const auto n = static_cast<std::size_t>(step);
    HistoryRow row = contact_between(run.steps(), n * steps_per_row);
    row.time = time;
    row.base_displacement = base.displacement(time);
    row.tip_displacement = tip[n];
    if (sampling.with_midspan) row.midspan_displacement = motions.back()[n];
    for (std::size_t k = 0; k < sampling.positions.size(); ++k) row.displacement.push_back(motions[k][n]);
    add_row(problem, history, sink, std::move(row));
  });
  // A smooth law has no stick.
  if (!problem.contact.compliance.is_smooth())
    set_events(history, events_between(run.steps(), run.grid().time_step));
  return history;
}

}  // namespace

double boundary_integral_step(const data::Case& problem) {
  constexpr double steps_per_period = 20000.0;
  const double highest = std::max(problem.excitation().frequency_hz(),
                                  analytic::stick_modes(problem.beam(), 1).front().frequency_hz());
  const double rated = problem.numerics.time_step(),
               kappa = weakening(problem.contact.friction, problem.beam().axial_force());
  double step = rated;
  while (step * highest * steps_per_period > 1.0) step *= 0.5;
  // Each step has one solution, and of twice the step, which History::step_effect takes. Of a law that jumps none has.
  const analytic::TipMobility mobility(problem.beam(), problem.damping);
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
  return history_of(problem, sampling, boundary_integral_of(problem, steps), steps, {});
}

History boundary_integral_history(const data::Case& problem, const Sampling& sampling,
                                  const solver::RunOptions&, const RowSink& sink) {
  const auto steps =
      static_cast<std::size_t>(std::lround(problem.numerics.time_step() / boundary_integral_step(problem)));
  const analytic::BeamBoundaryIntegral run = boundary_integral_of(problem, steps);
  History history = history_of(problem, sampling, run, steps, sink);
  if (steps > 1)
    history.step_effect = largest_difference(
        run.tip_displacement(steps), boundary_integral_of(problem, steps / 2).tip_displacement(steps / 2));
  return history;
}

}  // namespace stickslip::studies
