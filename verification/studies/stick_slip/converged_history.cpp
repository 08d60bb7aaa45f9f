// SPDX-License-Identifier: MIT
#include "studies/stick_slip/converged_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <future>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/convergence/convergence.hpp"

namespace stickslip::studies {

namespace {

struct Run {
  std::vector<double> tip, midspan;
  std::vector<ConvergedStick> sticks;  // of any length, including the first one
  HistoryLevel level;
};

/// Records the stick phases and the values at the samples from the steps of a run.
class RunRecorder {
 public:
  RunRecorder(Run& run, double time_step, std::size_t every)
      : run_(run), time_step_(time_step), every_(every) {
    run_.tip = {0.0};
  }

  void add(const analytic::ContactStep& step) {
    const double time = static_cast<double>(steps_) * time_step_;
    const bool stuck = step.sliding_velocity == 0.0;
    if (stuck && !stuck_) run_.sticks.push_back({.begin = time, .end = time, .position = position_});
    if (steps_ > 0 && stuck != stuck_) ++run_.level.changes;
    position_ += time_step_ * step.sliding_velocity;
    if (stuck) run_.sticks.back().end = time + time_step_;
    stuck_ = stuck;
    if (++steps_ % every_ == 0) run_.tip.push_back(position_);
  }

 private:
  Run& run_;
  double time_step_, position_{};
  std::size_t every_, steps_{};
  bool stuck_{};
};

analytic::TimeGrid grid_of(const ConvergedEffort& effort, int steps_per_sample) {
  return {effort.duration / effort.samples / steps_per_sample,
          static_cast<std::size_t>(effort.samples) * static_cast<std::size_t>(steps_per_sample)};
}

Run run_boundary_integral(const data::Case& problem, const ConvergedEffort& effort, int steps_per_sample) {
  const analytic::TimeGrid grid = grid_of(effort, steps_per_sample);
  const auto every = static_cast<std::size_t>(steps_per_sample);
  const analytic::BeamBoundaryIntegral beam(problem.beam, problem.friction, problem.excitation, {}, grid);
  Run run;
  run.level = {.method = "boundary integral", .time_step = grid.time_step};
  RunRecorder recorder(run, grid.time_step, every);
  for (const analytic::ContactStep& step : beam.steps()) recorder.add(step);
  if (effort.with_midspan) run.midspan = beam.displacement(0.5 * problem.beam.length(), every);
  return run;
}

Run run_free_modes(const data::Case& problem, const ConvergedEffort& effort, int steps_per_sample) {
  const analytic::TimeGrid grid = grid_of(effort, steps_per_sample);
  const auto every = static_cast<std::size_t>(steps_per_sample);
  const int modes = free_modes_for(problem.beam, grid.time_step);
  const double middle = 0.5 * problem.beam.length();
  std::vector<double> shapes;
  if (effort.with_midspan)
    for (const analytic::SlipMode& mode : analytic::slip_modes(problem.beam, modes))
      shapes.push_back(mode.shape(middle));
  const std::vector<double> held = analytic::holding_force(problem.beam, problem.excitation, {}, grid);
  analytic::FreeModeRun beam(analytic::free_modes(problem.beam, modes),
                             {problem.beam.axial_force(), problem.friction}, grid.time_step);
  Run run;
  run.level = {.method = "free modes", .time_step = grid.time_step, .modes = modes};
  RunRecorder recorder(run, grid.time_step, every);
  run.midspan = analytic::held_displacement(problem.beam, problem.excitation, {}, grid, middle, every);
  for (std::size_t n = 0; n < held.size(); ++n) {
    recorder.add(beam.step(held[n]));
    if ((n + 1) % every != 0) continue;
    for (std::size_t k = 0; k < shapes.size(); ++k)
      run.midspan[(n + 1) / every] += shapes[k] * beam.amplitudes()[k];
  }
  return run;
}

double range_of(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  return high - low;
}

std::vector<double> half_widths(const std::vector<double>& finest, const std::vector<double>& coarser,
                                const std::vector<double>& other) {
  std::vector<double> widths;
  double width = 1e-12 * range_of(finest);
  for (std::size_t i = 0; i < finest.size(); ++i) {
    width =
        largest_or_nan({width, 2.0 * std::abs(finest[i] - coarser[i]), 2.0 * std::abs(finest[i] - other[i])});
    widths.push_back(width);
  }
  return widths;
}

/// The stick phase of another run that overlaps with the given one for most of its length; null if there is
/// none.
const ConvergedStick* counterpart(const ConvergedStick& stick, const Run& run) {
  for (const ConvergedStick& other : run.sticks) {
    const double overlap = std::min(stick.end, other.end) - std::max(stick.begin, other.begin);
    if (overlap > 0.5 * (stick.end - stick.begin)) return &other;
  }
  return nullptr;
}

/// The stick phase with its half-widths: twice the largest difference from its counterparts, plus one step.
std::optional<ConvergedStick> with_half_widths(ConvergedStick stick, double step, const Run& coarser,
                                               const Run& other) {
  for (const Run* run : {&coarser, &other}) {
    const ConvergedStick* same = counterpart(stick, *run);
    if (same == nullptr) return std::nullopt;
    const auto widen = [](double& width, double a, double b) {
      width = largest_or_nan({width, 2.0 * std::abs(a - b)});
    };
    widen(stick.begin_half_width, stick.begin, same->begin);
    widen(stick.end_half_width, stick.end, same->end);
    widen(stick.position_half_width, stick.position, same->position);
  }
  stick.begin_half_width += step;
  stick.end_half_width += step;
  return stick;
}

}  // namespace

int free_modes_for(const data::Beam& beam, double time_step) {
  constexpr int probe = 20, most = 1000;
  const double omega = analytic::slip_modes(beam, probe).back().angular_frequency();
  return std::clamp(static_cast<int>(probe * std::sqrt(20.0 / (omega * time_step))), probe, most);
}

double ConvergedHistory::largest_half_width() const { return tip_half_width.back() / tip_range; }

ConvergedHistory converged_history(const data::Case& problem, const ConvergedEffort& effort) {
  if (is_damped(problem))
    throw std::invalid_argument(
        fmt::format("{} has damping, but the study is that of an undamped beam.", problem.name));
  // Both methods run concurrently, each from the finest to the coarsest step.
  const auto runs_of = [&](int first, const auto& run) {
    std::vector<Run> runs;
    for (int level = 0, steps = first; level < effort.levels && steps >= 1; ++level, steps /= 2)
      runs.push_back(run(problem, effort, steps));
    return runs;
  };
  auto modal =
      std::async(std::launch::async, [&] { return runs_of(effort.steps_per_sample / 2, run_free_modes); });
  std::vector<Run> runs = runs_of(effort.steps_per_sample, run_boundary_integral);
  const std::size_t integrals = runs.size();
  std::ranges::move(modal.get(), std::back_inserter(runs));
  const Run &finest = runs.front(), &coarser = runs[1], &other = runs[integrals];

  ConvergedHistory history;
  history.frequency_hz = problem.excitation.frequency_hz();
  history.amplitude = problem.excitation.amplitude();
  for (int i = 0; i <= effort.samples; ++i) history.time.push_back(effort.duration * i / effort.samples);
  history.tip_range = range_of(finest.tip);
  if (effort.with_midspan) history.midspan_range = range_of(finest.midspan);
  history.tip_half_width = half_widths(finest.tip, coarser.tip, other.tip);
  if (effort.with_midspan)
    history.midspan_half_width = half_widths(finest.midspan, coarser.midspan, other.midspan);
  for (std::size_t i = 0; i < finest.sticks.size(); ++i) {
    const ConvergedStick& stick = finest.sticks[i];
    const bool has_ended = stick.end < effort.duration - 0.5 * finest.level.time_step;
    if (i > 0 && (!has_ended || stick.end - stick.begin < effort.shortest_stick)) continue;
    const auto converged = with_half_widths(stick, finest.level.time_step, coarser, other);
    if (i == 0 && converged) history.first_stick = *converged;
    if (i > 0 && converged) history.sticks.push_back(*converged);
  }
  for (Run& run : runs) {
    run.level.difference = largest_difference(run.tip, finest.tip) / history.tip_range;
    history.levels.push_back(run.level);
  }
  history.tip = finest.tip;
  history.midspan = finest.midspan;
  return history;
}

}  // namespace stickslip::studies
