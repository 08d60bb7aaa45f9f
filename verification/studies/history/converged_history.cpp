// SPDX-License-Identifier: MIT
#include "studies/history/converged_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <future>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "studies/common/convergence.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/runs.hpp"

namespace stickslip::studies {

namespace {

struct Run {
  std::vector<double> tip, midspan;
  std::vector<ConvergedStick> sticks;  // of any length, including the first one
  HistoryLevel level;
};

// The stick phases between the changes of contact. The last one may end with the run.
std::vector<ConvergedStick> sticks_of(const std::vector<data::ContactEvent>& events, double duration) {
  std::vector<ConvergedStick> sticks{{.begin = 0.0, .end = duration, .position = 0.0}};
  for (const data::ContactEvent& event : events) {
    if (event.change == data::ContactChange::onset) sticks.back().end = event.time;
    if (event.change == data::ContactChange::capture)
      sticks.push_back({.begin = event.time, .end = duration, .position = event.position});
  }
  return sticks;
}

// With rows at the samples.
data::Case sampled(const data::Case& problem, const ConvergedEffort& effort) {
  return refined(problem, problem.numerics.elements(), effort.duration / effort.samples, effort.duration);
}

Run run_of(const History& history, HistoryLevel level, const ConvergedEffort& effort) {
  Run run{.tip = tip_displacements(history),
          .midspan = {},
          .sticks = sticks_of(history.events, effort.duration),
          .level = std::move(level)};
  if (effort.with_midspan)
    for (const HistoryRow& row : history.rows) run.midspan.push_back(row.midspan_displacement);
  run.level.changes = static_cast<int>(onsets_and_captures(history.events).size());
  return run;
}

Run run_boundary_integral(const data::Case& problem, const ConvergedEffort& effort, int steps_per_sample) {
  const data::Case at = sampled(problem, effort);
  return run_of(boundary_integral_history(at, {.with_midspan = effort.with_midspan}, steps_per_sample),
                {.method = "boundary integral", .time_step = at.numerics.time_step() / steps_per_sample},
                effort);
}

Run run_free_modes(const data::Case& problem, const ConvergedEffort& effort, int steps_per_sample) {
  const data::Case at = sampled(problem, effort);
  const double step = at.numerics.time_step() / steps_per_sample;
  return run_of(free_mode_history(at, {.with_midspan = effort.with_midspan}, steps_per_sample),
                {.method = "free modes", .time_step = step, .modes = free_modes_for(problem.beam, step)},
                effort);
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
