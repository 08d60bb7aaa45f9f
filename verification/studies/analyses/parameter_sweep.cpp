// SPDX-License-Identifier: MIT
#include "studies/analyses/parameter_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "stickslip/analytic/modal_contact_run.hpp"
#include "studies/analyses/contact_response.hpp"

namespace stickslip::studies {

namespace {

double wall_velocity(const analytic::ContactModel& model) {
  return model.wall_amplitude * model.load_angular_frequency;
}

// Runs one value from `last`, and leaves its end there for the next one, with the velocity relative to the wall.
SweepPoint point_at(const SweepTask& task, double value, bool up,
                    std::optional<analytic::ContactKinematics>& last) {
  const data::Case problem = with_value(task.problem, task.parameter, value);
  const analytic::ContactModel model = response_model(problem);
  const analytic::ContactModes modes(model);
  const int steps = steps_per_period(problem);
  analytic::ModalContactRun run(modes, model, steps);
  if (last) {
    last->velocity += wall_velocity(model);
    run.start(*last);
  } else {
    run.start_stuck();
  }
  bool slips = false;
  const auto pass_period = [&] {
    slips = false;
    for (int n = 0; n < steps; ++n) {
      run.step();
      slips = slips || run.slips();
    }
  };
  for (int period = 0; period < task.settle; ++period) pass_period();
  SweepPoint point{.up = up, .value = value, .section = {}, .period = 0, .slips = false};
  std::vector<std::vector<std::complex<double>>> samples;
  for (int period = 0; period < task.periods; ++period) {
    pass_period();
    point.slips = point.slips || slips;
    point.section.push_back({.tip_displacement = run.contact_position(),
                             .sliding_velocity = run.sliding_velocity(),
                             .friction_force = -run.friction_force()});
    samples.push_back(run.amplitudes());
  }
  point.period = period_of(samples);
  last = run.state();
  last->velocity = run.sliding_velocity();
  return point;
}

}  // namespace

std::vector<SweepPoint> parameter_sweep(const SweepTask& task, const std::function<void(double)>& progress) {
  for (const double value : task.values) (void)with_value(task.problem, task.parameter, value);
  std::vector<std::pair<double, bool>> way;
  if (task.direction != SweepDirection::down)
    for (const double value : task.values) way.emplace_back(value, true);
  if (task.direction != SweepDirection::up)
    for (auto value = task.values.rbegin(); value != task.values.rend(); ++value)
      way.emplace_back(*value, false);
  std::optional<analytic::ContactKinematics> last;
  std::vector<SweepPoint> points;
  for (const auto& [value, up] : way) {
    points.push_back(point_at(task, value, up, last));
    if (progress) progress(static_cast<double>(points.size()) / static_cast<double>(way.size()));
  }
  return points;
}

Hysteresis hysteresis_of(const std::vector<SweepPoint>& points) {
  const auto extent = [](const SweepPoint& point) {
    return std::ranges::minmax(point.section, {}, &HistoryRow::friction_force);
  };
  constexpr double apart = 0.01;  // of the larger force
  Hysteresis count;
  for (std::size_t i = 0; i < points.size() / 2; ++i) {
    const auto up = extent(points[i]), down = extent(points[points.size() - 1 - i]);
    const double scale = std::max({std::abs(up.min.friction_force), std::abs(up.max.friction_force),
                                   std::abs(down.min.friction_force), std::abs(down.max.friction_force)});
    if (std::abs(up.min.friction_force - down.min.friction_force) > apart * scale ||
        std::abs(up.max.friction_force - down.max.friction_force) > apart * scale)
      ++(points[i].slips || points[points.size() - 1 - i].slips ? count.moving : count.resting);
  }
  return count;
}

}  // namespace stickslip::studies
