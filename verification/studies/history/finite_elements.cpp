// SPDX-License-Identifier: MIT
#include <optional>
#include <utility>

#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/base_reaction.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

HistoryRow row_of(const solver::BeamSimulation& simulation, const std::vector<Eigen::VectorXd>& positions) {
  HistoryRow row{.time = simulation.integrator().time(),
                 .base_displacement = simulation.base_displacement(),
                 .tip_displacement = simulation.tip_displacement(),
                 .midspan_displacement = simulation.midspan_displacement(),
                 .sliding_velocity = simulation.integrator().sliding_velocity(),
                 .friction_force = simulation.friction_force(),
                 .state = simulation.integrator().state()};
  for (const auto& weights : positions) row.displacement.push_back(simulation.displacement(weights));
  return row;
}

}  // namespace

History finite_element_history(const data::Case& problem, const Sampling& sampling,
                               const solver::RunOptions& options, const RowSink& sink) {
  solver::BeamSimulation simulation(problem, options);
  std::optional<solver::BaseReaction> reaction;
  if (sampling.with_reactions) reaction.emplace(problem, simulation);
  if (reaction && simulation.integrator().contact_mass() == 0.0)
    throw data::FieldError("model.mass_matrix", "0 at the contact", "above 0 there where --columns is given");
  std::vector<Eigen::VectorXd> positions;
  const std::vector<Eigen::VectorXd> none;
  for (const double x : sampling.positions) positions.push_back(simulation.weights_at(x));
  History history;
  long done = 0;
  const auto step_to = [&](long step) {
    for (; done < step; ++done) simulation.integrator().step();
  };
  step_to(for_each_row(problem, sampling, [&](long step, double) {
    step_to(step);
    HistoryRow row = row_of(simulation, step % sampling.positions_every == 0 ? positions : none);
    if (reaction) {
      row.tip_acceleration = simulation.tip_acceleration();
      row.base_reaction = reaction->force();
      row.clamp_moment = reaction->moment();
    }
    hold_to_law(problem, history, row);
    add_row(problem, history, sink, std::move(row));
  }));
  auto events = simulation.integrator().events();
  // Positions on the wall become positions in the frame at rest. Under a force the base rests.
  const solver::PrescribedMotion base = solver::base_motion(problem.motion),
                                 wall = solver::wall_motion(problem, base);
  for (auto& event : events)
    event.position +=
        wall.displacement(event.time) + (problem.is_force() ? 0.0 : base.displacement(event.time));
  set_events(history, std::move(events));
  return history;
}

}  // namespace stickslip::studies
