// SPDX-License-Identifier: MIT
#include "studies/verification/classification.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

constexpr int converged_modes = 60;

ClassifiedFrequency classified_frequency(const data::Case& problem, double hz) {
  const data::HarmonicExcitation unit({.frequency_hz = hz, .amplitude = 1e-3});
  const data::Case at_hz = with(problem, unit);
  const analytic::Criterion criterion = analytic::evaluate_criterion(at_hz);
  const analytic::StickResponse reference(problem.beam(), unit, converged_modes, analytic::SteadyPart::exact);
  const double truncated = criterion.force_max.midpoint();
  const double converged = reference.max_abs_friction_force(problem.numerics.duration(), 1e-8).midpoint();
  const PredictedForce predicted(at_hz);
  return {.frequency_hz = hz,
          .critical_amplitude = criterion.critical_amplitude.midpoint(),
          .relative_truncation_error = std::abs(truncated - converged) / converged,
          .relative_discretisation_error =
              (std::abs(predicted.max_abs() - converged) + predicted.uncertainty()) / converged};
}

}  // namespace

void ClassificationStudy::count_points() {
  const auto agree = [](const ClassifiedPoint& point) {
    return point.closed_form_slips == point.finite_element_slips;
  };
  const auto count = [&](const auto& counts) {
    return static_cast<int>(std::ranges::count_if(points, counts));
  };
  agreeing = count(agree);
  in_guard_band = count([](const ClassifiedPoint& point) { return point.in_guard_band; });
  disagreeing_outside =
      count([&](const ClassifiedPoint& point) { return !agree(point) && !point.in_guard_band; });
}

ClassificationStudy classification_study(const data::Case& problem, const std::vector<double>& frequencies_hz,
                                         const std::vector<double>& amplitudes) {
  ClassificationStudy study;
  study.frequencies.resize(frequencies_hz.size());
  study.points.resize(frequencies_hz.size() * amplitudes.size());

  const auto classify_column = [&](std::size_t column) {
    const double hz = frequencies_hz[column];
    const ClassifiedFrequency frequency = classified_frequency(problem, hz);
    study.frequencies[column] = frequency;
    for (std::size_t row = 0; row < amplitudes.size(); ++row) {
      const double amplitude = amplitudes[row];
      const data::HarmonicExcitation excitation({.frequency_hz = hz, .amplitude = amplitude});
      const double distance = amplitude / frequency.critical_amplitude - 1.0;
      study.points[column * amplitudes.size() + row] = {
          .frequency_hz = hz,
          .amplitude = amplitude,
          .closed_form_slips = amplitude > frequency.critical_amplitude,
          .finite_element_slips = solver::first_slip(with(problem, excitation)).has_value(),
          .in_guard_band = std::abs(distance) <= frequency.relative_guard(),
          .distance = distance,
          .relative_guard = frequency.relative_guard()};
    }
  };
  in_parallel(frequencies_hz.size(), classify_column);

  study.count_points();
  return study;
}

std::vector<double> figure12_frequencies() {
  std::vector<double> frequencies;
  for (int i = 1; i <= 24; ++i) frequencies.push_back(5.0 * i);
  return frequencies;
}

std::vector<double> figure12_amplitudes() {
  std::vector<double> amplitudes;
  for (int i = 1; i <= 20; ++i) amplitudes.push_back(0.05e-3 * i);
  return amplitudes;
}

}  // namespace stickslip::studies
