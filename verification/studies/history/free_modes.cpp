// SPDX-License-Identifier: MIT
#include "stickslip/analytic/free_mode_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

constexpr int held_modes = 200;  // of the motion with the tip held, as in analytic::held_displacement()

std::vector<std::vector<double>> shapes_at(const std::vector<double>& positions,
                                           const std::vector<analytic::SlipMode>& modes) {
  std::vector<std::vector<double>> shapes;
  for (const double x : positions) {
    auto& values = shapes.emplace_back();
    for (const analytic::SlipMode& mode : modes) values.push_back(mode.shape(x));
  }
  return shapes;
}

}  // namespace

int free_modes_for(const data::Beam& beam, double time_step) {
  constexpr int probe = 20, most = 1000;
  const double omega = analytic::slip_modes(beam, probe).back().angular_frequency();
  return std::clamp(static_cast<int>(probe * std::sqrt(20.0 / (omega * time_step))), probe, most);
}

History free_mode_history(const data::Case& problem, const Sampling& sampling, int steps_per_time_step) {
  const double h = problem.numerics.time_step() / steps_per_time_step;
  std::vector<std::pair<std::size_t, double>> rows;  // their steps and times
  const long last = for_each_row(problem, sampling, [&](long step, double time) {
    rows.emplace_back(static_cast<std::size_t>(step * steps_per_time_step), time);
  });
  const auto count = static_cast<std::size_t>(last * steps_per_time_step);
  std::vector<double> positions = sampling.positions;
  if (sampling.with_midspan) positions.push_back(0.5 * problem.beam().length());
  const int modes = free_modes_for(problem.beam(), h);
  std::vector<std::vector<double>> shapes;
  if (!positions.empty()) shapes = shapes_at(positions, analytic::slip_modes(problem.beam(), modes));
  const analytic::StickResponse held(problem.beam(), problem.excitation(), held_modes,
                                     analytic::SteadyPart::exact);
  const std::vector<double> holding_force =
      analytic::holding_force(problem.beam(), problem.excitation(), {}, {h, count});
  analytic::FreeModeRun run(analytic::free_modes(problem.beam(), modes),
                            {problem.normal_force(), problem.contact.friction}, h);
  History history;
  std::vector<analytic::ContactStep> steps;
  double tip = 0.0;
  for (const auto& [row_step, time] : rows) {
    while (steps.size() < row_step) {
      steps.push_back(run.step(holding_force[steps.size()]));
      tip += h * steps.back().sliding_velocity;
    }
    HistoryRow row{.time = time, .base_displacement = held.base_displacement(time), .tip_displacement = tip};
    for (std::size_t i = 0; i < positions.size(); ++i) {
      double y = held.absolute_displacement(positions[i], time);
      for (std::size_t k = 0; k < shapes[i].size(); ++k) y += shapes[i][k] * run.amplitudes()[k];
      (i < sampling.positions.size() ? row.displacement.emplace_back() : row.midspan_displacement) = y;
    }
    history.rows.push_back(std::move(row));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const HistoryRow contact = contact_between(steps, rows[i].first);
    history.rows[i].sliding_velocity = contact.sliding_velocity;
    history.rows[i].friction_force = contact.friction_force;
    history.rows[i].state = contact.state;
  }
  set_events(history, events_between(steps, h));
  return history;
}

}  // namespace stickslip::studies
