// SPDX-License-Identifier: MIT
#include "studies/verification/contact_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/finite_element_contact_model.hpp"

namespace stickslip::studies {

namespace {

constexpr double sample = 2e-4;

constexpr int closed_form_modes = 60;  // number of modes

void require(bool holds, const char* field, const std::string& value, const char* allowed) {
  if (!holds) throw data::FieldError(field, value, allowed);
}

double sinc(double angle) { return angle == 0.0 ? 1.0 : std::sin(angle) / angle; }

// g_n of Eq. (26): the solution of g'' + w² g = -sin(Ω t) from rest, in a form without 0/0 at resonance.
double modal_coordinate(double omega, double w, double t) {
  const double sum = omega + w;
  return (w * t * std::cos(0.5 * sum * t) * sinc(0.5 * (omega - w) * t) - std::sin(w * t)) / (sum * w);
}

struct SampledHistory {
  std::vector<double> displacement, force;
};

// A run with a bonded tip, of which every `stride`-th step is kept.
SampledHistory bonded_history(const data::Case& problem, long stride) {
  solver::BeamSimulation simulation(problem, {.is_bonded = true});
  const long steps = solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
  SampledHistory history;
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) simulation.integrator().step();
    if (n % stride != 0) continue;
    history.displacement.push_back(simulation.midspan_displacement());
    history.force.push_back(simulation.friction_force());
  }
  return history;
}

data::NumericalSettings at_level(const data::NumericalSettings& numerics, int level) {
  data::NumericalChoices choices = numerics.choices();
  choices.elements <<= level;
  choices.time_step /= std::pow(4.0, level);
  return data::NumericalSettings(choices);
}

// The data set with the history of a panel, half a second of it; empty if it is not published.
std::string published_set(const data::PrintedVerdict& panel) {
  const bool is_published = panel.verdict == "stick-slip" && panel.amplitude == 1e-3;
  return is_published ? fmt::format("undamped-history-{}", panel.frequency_hz) : "";
}

}  // namespace

std::optional<double> closed_form_first_slip(const data::Case& problem) {
  const analytic::StickResponse response(problem.beam(), problem.excitation(), closed_form_modes,
                                         analytic::SteadyPart::exact);
  const double limit = friction_limit(problem);
  const auto exceeded = [&](double t) { return std::abs(response.friction_force(t)) > limit; };
  const double scan =
      std::min(1.0 / problem.excitation().frequency_hz(), 1.0 / response.modes().front().frequency_hz()) /
      2000.0;
  const long samples = std::lround(problem.numerics.duration() / scan);
  for (long n = 1; n <= samples; ++n) {
    const double end = static_cast<double>(n) * scan;
    if (exceeded(end))
      return bracketed(
                 end - scan, end, [&](double t) { return !exceeded(t); }, 5e-5 * scan)
          .second;
  }
  return std::nullopt;
}

ContactHistory contact_history(const data::Case& problem, double shown, const std::string& data_set) {
  ContactHistory history;
  history.frequency_hz = problem.excitation().frequency_hz();
  history.amplitude = problem.excitation().amplitude();
  history.finite_element_slip = solver::first_slip(problem);
  history.criterion_slips = analytic::evaluate_criterion(problem).verdict == analytic::Verdict::stick_slip;
  if (history.criterion_slips) {
    history.closed_form_slip = closed_form_first_slip(problem);
    const ConvergedEffort two_levels{.duration = shown,
                                     .samples = static_cast<int>(std::lround(shown / sample)),
                                     .steps_per_sample = 512,
                                     .levels = 2,
                                     .with_midspan = false};
    history.converged = data_set.empty() ? converged_history(problem, two_levels)
                                         : published_history(problem, data_set, {.steps_per_sample = 256});
  }
  return history;
}

std::optional<double> ContactHistory::first_slip_difference() const {
  if (!finite_element_slip || !closed_form_slip) return std::nullopt;
  return std::abs(*finite_element_slip - *closed_form_slip);
}

std::vector<ContactHistory> contact_histories(const data::Case& paper, double shown) {
  std::vector<ContactHistory> histories;
  for (const auto& verdict : data::printed_verdicts()) {
    const data::Case problem =
        with(paper, data::HarmonicExcitation({verdict.frequency_hz, verdict.amplitude}));
    histories.push_back(contact_history(problem, shown, published_set(verdict)));
    histories.back().figure = verdict.figure;
    histories.back().printed_slips = verdict.verdict == "stick-slip";
  }
  return histories;
}

std::vector<HistoryRun> usual_practice(data::Case problem, const ConvergedHistory& converged) {
  problem.motion = data::HarmonicExcitation({converged.frequency_hz, converged.amplitude});
  const data::NumericalSettings& numerics = problem.numerics;
  const double duration = converged.time.back(), spacing = converged.time[1];
  const int elements = numerics.elements();
  const double h = numerics.time_step();
  struct Stepped {
    const char* method;
    double radius;
    solver::ContactScheme scheme;
    double threshold;
  };
  const Stepped stepped[] = {{"letter of the paper", numerics.spectral_radius(), solver::ContactScheme::paper,
                              numerics.velocity_threshold()},
                             {"located in the step", 0.5, solver::ContactScheme::located, 0.0},
                             {"located in the step", 0.9, solver::ContactScheme::located, 0.0},
                             {"located in the step", 1.0, solver::ContactScheme::located, 0.0}};
  const int meshes[] = {elements / 2, elements};  // of the event-driven runs
  std::vector<HistoryRun> runs(std::size(stepped) + std::size(meshes));
  in_parallel(runs.size(), [&](std::size_t i) {
    HistoryRun& run = runs[i];
    History history;
    if (i < std::size(stepped)) {
      const auto& [method, radius, scheme, threshold] = stepped[i];
      data::NumericalChoices choices = numerics.choices();
      choices.spectral_radius = radius;
      choices.velocity_threshold = threshold;
      choices.duration = duration;
      history = finite_element_history(with(problem, data::NumericalSettings(choices)),
                                       {.every = std::lround(spacing / h)},
                                       {.scheme = scheme, .coordinates = solver::Coordinates::nodal});
      run = {.method = method, .elements = elements, .time_step = h, .spectral_radius = radius};
    } else {
      run = {.method = "event-driven", .elements = meshes[i - std::size(stepped)]};
      history = event_driven_history(finite_element_contact_model(problem, run.elements),
                                     sample_times(duration, spacing));
    }
    run.changes = static_cast<int>(history.events.size());
    run.tip_displacement = tip_displacements(history);
    run.error = largest_difference(converged.tip, run.tip_displacement) / converged.tip_range;
  });
  return runs;
}

Sampling snapshots_of(const data::Case& problem, double start, double length, int snapshots, int positions) {
  const double time_step = problem.numerics.time_step();
  require(start >= 0.0, "start", data::shortest_text(start), "at least 0 (s)");
  require(snapshots >= 2, "snapshots", std::to_string(snapshots), "at least 2");
  require(positions >= 2, "positions", std::to_string(positions), "at least 2");
  require(snapshots - 1 <= std::floor(length / time_step * (1.0 + 1e-12)), "snapshots",
          std::to_string(snapshots), "at most one per time step of the window");
  Sampling sampling;
  for (int i = 0; i < snapshots; ++i)
    sampling.times.push_back(std::round((start + length * i / (snapshots - 1)) / time_step) * time_step);
  for (int i = 0; i < positions; ++i)
    sampling.positions.push_back(problem.beam().length() * i / (positions - 1));
  return sampling;
}

double peak(const History& motion) {
  double largest = 0.0;
  for (const HistoryRow& row : motion.rows)
    for (const double y : row.displacement) largest = std::max(largest, std::abs(y));
  return largest;
}

double largest_difference(const History& a, const History& b, double until) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.rows.size() && a.rows[i].time <= until; ++i)
    largest = largest_or_nan({largest, largest_difference(a.rows[i].displacement, b.rows[i].displacement)});
  return largest;
}

double predicted_stick_difference(const data::Case& problem, const Sampling& snapshots, double until) {
  const double omega = angular_frequency(problem.excitation());
  const double step = problem.numerics.time_step();
  const analytic::StickResponse response(problem.beam(), problem.excitation(), closed_form_modes,
                                         analytic::SteadyPart::exact);
  std::vector<SteppedResponse> stepped;
  for (const auto& mode : response.modes())
    stepped.push_back(stepped_from_rest(problem.numerics.spectral_radius(),
                                        frequency_on_mesh(problem.beam(), mode, problem.numerics.elements()),
                                        omega, step));
  double largest = 0.0, largest_motion = 0.0;
  for (const double t : snapshots.times) {
    if (t > until) break;
    for (const double x : snapshots.positions) {
      double sum = 0.0;
      for (std::size_t k = 0; k < stepped.size(); ++k) {
        const auto& mode = response.modes()[k];
        sum += std::abs(mode.shape(x) * omega * omega * mode.participation() *
                        (stepped[k].at(std::lround(t / step), omega * step) -
                         modal_coordinate(omega, mode.angular_frequency(), t)));
      }
      largest = std::max(largest, problem.excitation().amplitude() * sum);
      largest_motion = std::max(largest_motion, std::abs(response.absolute_displacement(x, t)));
    }
  }
  return largest + 0.25 * omega * omega * step * step * largest_motion;
}

BeamMotionStudy beam_motion_study(const data::Case& problem, int snapshots, int positions) {
  BeamMotionStudy study;
  study.frequency_hz = problem.excitation().frequency_hz();
  study.amplitude = problem.excitation().amplitude();
  study.first_slip = closed_form_first_slip(problem);
  const double period = 1.0 / study.frequency_hz;
  const double start = study.first_slip ? std::max(0.0, *study.first_slip - 0.25 * period) : 0.0;
  const Sampling grid = snapshots_of(problem, start, period, snapshots, positions);
  study.position = grid.positions;
  study.finite_element = finite_element_history(problem, grid);
  constexpr int fine = 128, coarse = 64;  // steps per time step of the finite elements
  study.reference = study.first_slip
                        ? free_mode_history(problem, grid, fine)
                        : closed_form_history(with_value(problem, "numerics.modes", closed_form_modes), grid,
                                              analytic::SteadyPart::exact);
  constexpr double always = std::numeric_limits<double>::infinity();
  const double end_of_stick = study.first_slip.value_or(always);
  study.peak = peak(study.reference);
  if (study.first_slip)
    study.half_width =
        2.0 * largest_difference(study.reference, free_mode_history(problem, grid, coarse), always);
  study.stick_difference = largest_difference(study.finite_element, study.reference, end_of_stick);
  study.predicted_stick_difference = predicted_stick_difference(problem, grid, end_of_stick);
  study.difference = largest_difference(study.finite_element, study.reference, always);
  return study;
}

StickHistoryStudy stick_history_study(const data::Case& problem, int levels) {
  StickHistoryStudy study;
  const data::Beam& beam = problem.beam();
  const data::NumericalSettings& numerics = problem.numerics;
  const double midspan = 0.5 * beam.length();
  const analytic::StickResponse exact(beam, problem.excitation(), 200, analytic::SteadyPart::exact);
  const auto displacement = exact.absolute_displacement(midspan);
  const long samples = solver::step_count(numerics.duration(), numerics.time_step());
  for (long n = 0; n <= samples; ++n) {
    const double t = static_cast<double>(n) * numerics.time_step();
    study.time.push_back(t);
    study.displacement.push_back(displacement(t));
    study.force.push_back(exact.friction_force(t));
  }
  const std::vector<double> zero(study.time.size());
  study.displacement_peak = largest_difference(study.displacement, zero);
  study.force_peak = largest_difference(study.force, zero);

  const auto free_displacement = exact.transient_displacement(midspan);
  const auto free_force = exact.transient_force();
  for (int k = 0; k < levels; ++k) {
    const data::NumericalSettings level = at_level(numerics, k);
    SampledHistory computed = bonded_history(with(problem, level), 1L << (2 * k));
    const double displacement_error = largest_difference(computed.displacement, study.displacement);
    const double force_error = largest_difference(computed.force, study.force);
    study.levels.push_back({level.elements(), level.time_step(), displacement_error, force_error,
                            drift_bound(beam, exact.modes(), free_displacement, level, numerics.duration()),
                            drift_bound(beam, exact.modes(), free_force, level, numerics.duration()),
                            displacement_error / study.displacement_peak, force_error / study.force_peak});
    if (k == 0) {
      study.first_displacement = std::move(computed.displacement);
      study.first_force = std::move(computed.force);
    }
  }
  if (levels < 2) return study;
  const auto column = [&study](double StickHistoryLevel::*entry) {
    std::vector<double> values;
    for (const StickHistoryLevel& level : study.levels) values.push_back(level.*entry);
    return values;
  };
  const std::vector<double> steps = column(&StickHistoryLevel::time_step);
  study.displacement_order = order_estimate(steps, column(&StickHistoryLevel::displacement_error));
  study.force_order = order_estimate(steps, column(&StickHistoryLevel::force_error));
  study.predicted_displacement_order =
      observed_order(steps, column(&StickHistoryLevel::predicted_displacement_error));
  study.predicted_force_order = observed_order(steps, column(&StickHistoryLevel::predicted_force_error));
  return study;
}

}  // namespace stickslip::studies
