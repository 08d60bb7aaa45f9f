// SPDX-License-Identifier: MIT
#include "studies/history/history_convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <future>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "stickslip/data/reference.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/contact_growth.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

struct Run {
  std::vector<double> tip, midspan;
  std::vector<ConvergedStick> sticks;  // of any length, including the first one
  HistoryRun level;
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

Run run_of(const History& history, HistoryRun level, const ConvergedEffort& effort) {
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
                {.method = "free modes", .modes = free_modes_for(problem.beam(), step), .time_step = step},
                effort);
}

struct Runs {
  std::vector<Run> integrals, modal;  // from the finest to the coarsest step
};

// Both methods run concurrently.
Runs runs_of(const data::Case& problem, const ConvergedEffort& effort) {
  if (problem.is_damped())
    throw std::invalid_argument(
        fmt::format("{} has damping, but the study is that of an undamped beam.", problem.name));
  const auto all = [&](int first, const auto& run) {
    std::vector<Run> runs;
    for (int level = 0, steps = first; level < effort.levels && steps >= 1; ++level, steps /= 2)
      runs.push_back(run(problem, effort, steps));
    return runs;
  };
  auto modal =
      std::async(std::launch::async, [&] { return all(effort.steps_per_sample / 2, run_free_modes); });
  std::vector<Run> integrals = all(effort.steps_per_sample, run_boundary_integral);
  return {std::move(integrals), modal.get()};
}

void add_levels(Runs runs, ConvergedHistory& history) {
  for (std::vector<Run>* method : {&runs.integrals, &runs.modal})
    for (Run& run : *method) {
      run.level.error = largest_difference(run.tip, history.tip) / history.tip_range;
      history.levels.push_back(std::move(run.level));
    }
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

// ω_max l² √(ρ A/EI) of a uniform mesh of elements of length l at P = 0. Computed: 59.792 for 5
// elements, 59.878 for 20 and more.
constexpr double highest_frequency_factor = 59.88;
// The fraction of the range of y(L) at which the observation of a growth ends.
constexpr double observed_until = 0.1;

solver::ContactSystem system_of(const data::Case& problem, const solver::BeamModel& mesh, double change,
                                double radiating_share) {
  const data::HarmonicExcitation excitation(
      {problem.excitation().frequency_hz(), problem.excitation().amplitude() * (1.0 + change)});
  const auto system = solver::beam_contact_system(mesh, with(problem, excitation, data::Damping()));
  if (radiating_share == 0.0) return system;
  const data::Beam& beam = problem.beam();
  return with_radiating_contact(
      system, radiating_share * beam.density() * beam.area() * beam.length() / mesh.elements(),
      weakening(problem.contact.friction, beam.axial_force()));
}

// Like finite_element_history(), for a system with a radiating contact. In the frame of the base the wall moves
// by -h.
History radiating_history(const solver::BeamModel& mesh, const solver::ContactSystem& system,
                          const solver::IntegratorSettings& settings, double duration, int every) {
  solver::StickSlipIntegrator integrator(system, settings);
  const Eigen::Index size = system.mass.rows();
  Eigen::VectorXd velocity(size);
  velocity << mesh.unit_tip_deflection(), 1.0;
  integrator.start_stuck(Eigen::VectorXd::Zero(size), system.wall.velocity(0.0) * velocity);
  History history;
  const long steps = solver::step_count(duration, settings.time_step);
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) integrator.step();
    if (n % every != 0) continue;
    history.rows.push_back({.time = integrator.time(),
                            .tip_displacement = integrator.displacement()[system.contact] -
                                                system.wall.displacement(integrator.time())});
  }
  history.events = integrator.events();
  return history;
}

}  // namespace

double ConvergedHistory::largest_half_width() const { return tip_half_width.back() / tip_range; }

ConvergedHistory converged_history(const data::Case& problem, const ConvergedEffort& effort) {
  Runs runs = runs_of(problem, effort);
  const Run &finest = runs.integrals.front(), &coarser = runs.integrals[1], &other = runs.modal.front();

  ConvergedHistory history;
  history.frequency_hz = problem.excitation().frequency_hz();
  history.amplitude = problem.excitation().amplitude();
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
  history.tip = finest.tip;
  history.midspan = finest.midspan;
  add_levels(std::move(runs), history);
  return history;
}

ConvergedHistory published_history(const data::Case& problem, const std::string& data_set,
                                   ConvergedEffort effort) {
  const data::ReferenceTable table = data::read_table(data::load_reference(), data_set);
  ConvergedHistory history;
  history.frequency_hz = problem.excitation().frequency_hz();
  history.amplitude = problem.excitation().amplitude();
  history.time = table.column("time").values;
  history.tip = table.column("tip_displacement").values;
  history.tip_half_width = table.radius_of("tip_displacement");
  history.tip_range = range_of(history.tip);
  effort.duration = history.time.back();
  effort.samples = static_cast<int>(history.time.size()) - 1;
  effort.with_midspan = false;
  if (effort.levels > 0) add_levels(runs_of(problem, effort), history);
  return history;
}

std::optional<double> growth_rate(const History& a, const History& b, double period, double limit) {
  if (a.events.empty()) return std::nullopt;
  const double start = a.events.front().time;
  std::vector<double> times, logarithms;
  std::size_t i = 0;
  while (i < a.rows.size() && a.rows[i].time < start) ++i;
  for (;;) {
    const double end = start + static_cast<double>(times.size() + 1) * period;
    if (end > a.rows.back().time) break;
    double largest = 0.0;
    for (; a.rows[i].time < end; ++i)
      largest = largest_or_nan({largest, std::abs(a.rows[i].tip_displacement - b.rows[i].tip_displacement)});
    if (largest > limit || largest == 0.0) break;
    times.push_back(end);
    logarithms.push_back(std::log(largest));
  }
  if (times.size() < 3) return std::nullopt;
  return linear_slope(times, logarithms);
}

double time_step_of(const StepRule& rule, const data::Beam& beam, int elements) {
  if (rule.angle == 0.0) return rule.time_step;
  const double length = beam.length() / elements;
  return rule.angle / highest_frequency_factor * length * length *
         std::sqrt(beam.density() * beam.area() / (beam.youngs_modulus() * beam.second_moment_of_area()));
}

HistoryRun history_run(const data::Case& problem, const ConvergedHistory& reference, int elements,
                       double time_step, double spectral_radius, bool observe_growth,
                       double radiating_share) {
  const double sample = reference.time[1] - reference.time[0];
  const int every = static_cast<int>(std::ceil(sample / time_step * (1.0 - 1e-9)));
  const double duration = reference.time.back();
  const data::Case at = refined(problem, elements, sample / every, duration, spectral_radius);
  const double step = at.numerics.time_step();
  const solver::BeamModel mesh(problem.beam(), elements);
  const auto history = [&](double change) {
    if (radiating_share > 0.0)
      return radiating_history(mesh, system_of(problem, mesh, change, radiating_share),
                               {.time_step = step, .spectral_radius = spectral_radius}, duration, every);
    const data::Case changed =
        with_value(at, "excitation.amplitude", problem.excitation().amplitude() * (1.0 + change));
    return finite_element_history(changed, {.every = every}, {.coordinates = solver::Coordinates::modal});
  };
  const History run = history(0.0);
  const solver::ContactMobility mobility(system_of(problem, mesh, 0.0, radiating_share));
  HistoryRun result{
      .method = "located in the step",
      .elements = elements,
      .time_step = step,
      .spectral_radius = spectral_radius,
      .changes = static_cast<int>(run.events.size()),
      .highest_angle = mobility.angular_frequencies().maxCoeff() * step,
      .growth_bound = growth_bound(stepped_contact(mobility, step, spectral_radius),
                                   weakening(problem.contact.friction, problem.normal_force()))};
  result.error = largest_difference(tip_displacements(run), reference.tip) / reference.tip_range;
  if (observe_growth)
    result.observed_growth =
        growth_rate(run, history(HistoryRun::perturbation), 1.0 / problem.excitation().frequency_hz(),
                    observed_until * reference.tip_range);
  return result;
}

HistoryRefinement history_refinement(const data::Case& problem, const ConvergedHistory& reference,
                                     const StepRule& rule, const std::vector<int>& elements,
                                     int observed_elements) {
  HistoryRefinement refinement;
  refinement.rule = rule;
  refinement.frequency_hz = problem.excitation().frequency_hz();
  refinement.beam_growth_bound = beam_growth_bound(with(problem, data::Damping()));
  std::vector<double> lengths, errors;
  for (const int count : elements) {
    refinement.runs.push_back(history_run(problem, reference, count,
                                          time_step_of(rule, problem.beam(), count), rule.spectral_radius,
                                          count <= observed_elements, rule.radiating_share));
    lengths.push_back(problem.beam().length() / count);
    errors.push_back(refinement.runs.back().error);
  }
  refinement.order = order_estimate(lengths, errors);
  return refinement;
}

}  // namespace stickslip::studies
