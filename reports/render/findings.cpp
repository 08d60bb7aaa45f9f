// SPDX-License-Identifier: MIT
#include "render/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/json_text.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/paper.hpp"
#include "studies/common/described_types.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/stick_slip/contact_growth.hpp"

namespace stickslip::report {

namespace {

using nlohmann::json;

double relative_difference(double a, double b) { return std::abs(a / b - 1.0); }

void raise(double& largest, double value) { largest = studies::largest_or_nan({largest, value}); }

// Each frequency of Fig. 7 on the mesh of the paper.
json frequencies(StudyResults& results) {
  json rows = json::array();
  for (const auto& curve : results.mode_shapes().curves) {
    const auto& study = curve.slip ? results.slip_frequencies() : results.stick_frequencies();
    const auto mode = std::ranges::find(study.modes, curve.mode, &studies::FrequencyConvergence::mode);
    rows.push_back({{"state", state_of(curve)},
                    {"mode", curve.mode},
                    {"closed_form_hz", mode->closed_form_hz},
                    {"finite_element_hz", curve.finite_element_hz},
                    {"relative_error", curve.finite_element_hz / mode->closed_form_hz - 1.0},
                    {"observed_order", mode->observed_order},
                    {"leading_constant_ratio", mode->leading_constant_ratio}});
  }
  return rows;
}

std::vector<double> flutter_errors(const studies::FlutterStudy& study) {
  std::vector<double> errors;
  for (const double load : study.finite_element) errors.push_back(load / study.closed_form - 1.0);
  return errors;
}

// Of each level, as shares of the peaks.
json stick_errors(const studies::StickHistoryStudy& study) {
  json rows = json::array();
  for (const auto& level : study.levels)
    rows.push_back({{"displacement", level.displacement_error / study.displacement_peak},
                    {"force", level.force_error / study.force_peak}});
  return rows;
}

json flat_section(const data::Case& flat) {
  const double height = std::sqrt(12.0 * flat.beam.second_moment_of_area() / flat.beam.area());
  std::vector<double> lengths;
  for (const int mode : {1, 2})
    lengths.push_back(studies::resonance_length(flat.beam, mode, flat.excitation.frequency_hz()).value());
  return {{"buckling_coefficient", buckling_coefficient(flat.beam)},
          {"height", height},
          {"width", flat.beam.area() / height},
          {"resonance_lengths", lengths}};
}

// The time stepper's run on the most elements with the shortest step.
const studies::BenchmarkRun& finest_stepped(const studies::DampedBenchmark& benchmark) {
  const studies::BenchmarkRun* finest = nullptr;
  for (const auto& run : benchmark.runs)
    if (run.time_step > 0.0 && (!finest || run.size > finest->size ||
                                (run.size == finest->size && run.time_step < finest->time_step)))
      finest = &run;
  return *finest;
}

// A row for each run: the change of the energy, what explains it, and what does not.
json energy_row(const auto& energy, double change, double residual) {
  return {{"change", change},
          {"base_work", energy.base_work},
          {"follower_work", energy.follower_work},
          {"damping_loss", energy.damping_loss},
          {"friction_loss", energy.friction_loss},
          {"residual", residual}};
}

json agreement(StudyResults& results) {
  const auto values = checked_results(results.printed_checks(), results.solution_verification());
  json found;
  for (const auto& [name, reference] : {std::pair{"printed", "printed"}, {"exact", "mesh-free"}}) {
    const Differences differences = differences_from(values, reference);
    found[name] = {{"count", differences.count}, {"bias", differences.bias}, {"spread", differences.spread}};
  }
  return found;
}

}  // namespace

std::string verdict_of(bool slips) { return slips ? "stick-slip" : "stick"; }

std::string state_of(const studies::ModeShapeStudy::Curve& curve) { return curve.slip ? "slip" : "stick"; }

std::vector<CheckedResult> checked_results(const std::vector<studies::PrintedCheck>& printed,
                                           const studies::SolutionVerification& verification) {
  std::vector<CheckedResult> values;
  for (const auto& check : printed)
    values.push_back({.what = check.printed.id + " by " + check.method,
                      .reference = "printed",
                      .computed = check.computed,
                      .expected = check.printed.value,
                      .known_erratum = !check.agrees()});
  for (const auto& result : verification.results)
    values.push_back({.what = result.quantity,
                      .reference = "mesh-free",
                      .computed = result.levels.front().value,
                      .expected = result.reference});
  return values;
}

Differences differences_from(const std::vector<CheckedResult>& values, const std::string& reference) {
  Differences differences;
  double sum = 0.0, squares = 0.0;
  for (const CheckedResult& value : values) {
    if (value.reference != reference || value.known_erratum) continue;
    const double difference = value.relative_difference();
    ++differences.count;
    sum += difference;
    squares += difference * difference;
  }
  const auto count = static_cast<double>(differences.count);
  differences.bias = sum / count;
  differences.spread = std::sqrt((squares - count * differences.bias * differences.bias) / (count - 1.0));
  return differences;
}

double buckling_coefficient(const data::Beam& beam) {
  const double rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  return analytic::stick_buckling_load(beam) * beam.length() * beam.length() / rigidity;
}

json force_differences(const std::vector<studies::ForceMaximumStudy>& maxima) {
  double sampling = 0.0, truncation = 0.0, discretisation = 0.0, prediction = 0.0, printed = 0.0;
  for (const auto& row : maxima) {
    const double truncated = row.truncated.midpoint(), converged = row.converged.midpoint();
    raise(sampling, relative_difference(row.sampled, truncated));
    raise(truncation, relative_difference(truncated, converged));
    raise(discretisation, relative_difference(row.finite_element, converged));
    raise(prediction, relative_difference(row.finite_element, row.predicted_finite_element));
    raise(printed,
          relative_difference(row.sampled,
                              data::printed_number(fmt::format("force_max.{}", row.frequency_hz)).value));
  }
  return {{"sampling", sampling},
          {"truncation", truncation},
          {"discretisation", discretisation},
          {"prediction", prediction},
          {"printed", printed}};
}

json guard_points(const studies::ClassificationStudy& study) {
  json rows = json::array();
  for (const auto& point : study.points) {
    if (!point.in_guard_band) continue;
    const auto frequency =
        std::ranges::find(study.frequencies, point.frequency_hz, &studies::ClassifiedFrequency::frequency_hz);
    rows.push_back({{"frequency_hz", point.frequency_hz},
                    {"amplitude", point.amplitude},
                    {"distance", point.amplitude / frequency->critical_amplitude - 1.0},
                    {"relative_guard", frequency->relative_guard()},
                    {"closed_form", verdict_of(point.closed_form_slips)},
                    {"finite_element", verdict_of(point.finite_element_slips)}});
  }
  return rows;
}

json half_stiffness_ratio(const std::vector<studies::CriticalAmplitudePoint>& full,
                          const std::vector<studies::CriticalAmplitudePoint>& half) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < full.size(); ++i)
    ratios.push_back(half[i].critical_amplitude / full[i].critical_amplitude);
  std::ranges::sort(ratios);
  return {{"median", ratios[ratios.size() / 2]},
          {"low_tenth", ratios[ratios.size() / 10]},
          {"high_tenth", ratios[ratios.size() - 1 - ratios.size() / 10]}};
}

json histories(const std::vector<studies::ContactHistory>& histories) {
  int agreeing = 0;
  double difference = 0.0, half_width = 0.0;
  const auto verdicts = data::printed_verdicts();
  for (std::size_t i = 0; i < histories.size(); ++i) {
    const auto& history = histories[i];
    const bool printed = verdicts[i].verdict == "stick-slip";
    const auto& slip = history.finite_element_slip;
    if (printed == slip.has_value() && printed == history.criterion_slips) ++agreeing;
    if (history.converged) raise(half_width, history.converged->largest_half_width());
    if (slip && history.closed_form_slip) raise(difference, std::abs(*slip - *history.closed_form_slip));
  }
  return {{"verdicts_agreeing", agreeing}, {"first_slip_difference", difference}, {"half_width", half_width}};
}

json benchmark_extremes(const std::vector<studies::DampedBenchmark>& benchmarks, double first_hz) {
  studies::EventDifference first_ten, all;
  std::size_t events = 0, merged = 0;
  for (const auto& benchmark : benchmarks) {
    const auto& run = finest_stepped(benchmark);
    raise(first_ten.time, run.first_ten.time);
    raise(first_ten.position, run.first_ten.position);
    raise(all.time, run.all.time);
    raise(all.position, run.all.position);
    events += benchmark.events.size();
    merged += (benchmark.history.events.size() - benchmark.events.size()) / 2;
  }
  return {{"elements", finest_stepped(benchmarks.front()).size},
          {"time_step", finest_stepped(benchmarks.front()).time_step},
          {"first_ten", first_ten},
          {"all", all},
          {"events", events},
          {"merged_sticks", merged},
          {"damping_ratio", std::numbers::pi * benchmarks.front().kelvin_voigt * first_hz}};
}

json energy_balances(const std::vector<studies::EnergyAudit>& audits) {
  json rows = json::array();
  double event_driven = 0.0;
  for (const auto& audit : audits) {
    const auto& exact = audit.event_driven;
    raise(event_driven, std::abs(audit.event_driven_residual() / exact.base_work));
    rows.push_back(energy_row(exact, exact.kinetic + exact.potential - audit.event_driven_initial,
                              audit.event_driven_residual()));
    rows.back()["modes"] = audit.modes;
    rows.back()["kelvin_voigt"] = audit.kelvin_voigt;
    for (const auto& mesh : audit.meshes) {
      const auto& stepped = mesh.stepped.back();
      rows.push_back(energy_row(stepped, stepped.energy() - stepped.initial_energy, stepped.residual()));
      rows.back()["elements"] = mesh.elements;
      rows.back()["time_step"] = audit.time_step.back();
      rows.back()["kelvin_voigt"] = audit.kelvin_voigt;
    }
  }
  double unresolved = 0.0;
  for (const auto& balance : audits.back().meshes.back().stepped)
    raise(unresolved, std::abs(balance.residual() / balance.base_work));
  return {{"rows", rows}, {"event_driven", event_driven}, {"unresolved", unresolved}};
}

json motion(const std::vector<studies::BeamMotionStudy>& motions) {
  const auto& worst = *std::ranges::max_element(motions, {}, &studies::BeamMotionStudy::stick_difference);
  double difference = 0.0, half_width = 0.0;
  for (const auto& panel : motions) {
    raise(difference, panel.difference / panel.peak);
    raise(half_width, panel.half_width / panel.peak);
  }
  return {{"stick_difference", worst.stick_difference},
          {"predicted_stick_difference", worst.predicted_stick_difference},
          {"difference", difference},
          {"half_width", half_width}};
}

json findings(StudyResults& results) {
  const data::Case& paper = results.paper();
  const auto& classification = results.classification();
  const auto& search = results.force_sensitivity().search;
  return {
      {"friction_limit", studies::friction_limit(paper)},
      {"threshold_deceleration", paper.numerics.velocity_threshold() / paper.numerics.time_step()},
      {"event_tolerance", analytic::EventDrivenSettings{}.tolerance},
      {"shown_duration", StudyResults::shown_duration},
      {"search", {{"increment", StudyResults::search_increment}, {"cap", StudyResults::search_cap}}},
      {"filtering_angle", studies::filtering_angle},
      {"perturbation", studies::perturbation},
      {"shortest_plateau", studies::shortest_plateau},
      {"beam_growth_bound", studies::beam_growth_bound(paper.beam, paper.friction)},
      {"frequencies", frequencies(results)},
      {"flutter_errors", flutter_errors(results.flutter())},
      {"stick_errors", stick_errors(results.stick_history())},
      {"force_differences", force_differences(results.force_maxima())},
      {"disagreeing_inside", static_cast<int>(classification.points.size()) - classification.agreeing -
                                 classification.disagreeing_outside},
      {"guard_points", guard_points(classification)},
      {"half_stiffness_ratio", half_stiffness_ratio(results.criterion(), results.half_stiffness_criterion())},
      {"flat_section", flat_section(results.flat_section())},
      {"histories", histories(results.contact_histories())},
      {"benchmark", benchmark_extremes(results.damped_benchmarks(),
                                       results.stick_frequencies().modes.front().closed_form_hz)},
      {"energy", energy_balances(results.energy_audits())},
      {"motion", motion(results.beam_motions())},
      {"search_trials", search.most_modes * static_cast<int>(search.sampling_steps.size())},
      {"agreement", agreement(results)}};
}

}  // namespace stickslip::report
