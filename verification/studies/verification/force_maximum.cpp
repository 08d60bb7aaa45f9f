// SPDX-License-Identifier: MIT
#include "studies/verification/force_maximum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_system.hpp"
#include "studies/common/discretisation.hpp"

namespace stickslip::studies {

namespace {

double relative_difference(double a, double b) { return std::abs(a / b - 1.0); }

}  // namespace

double ForceMaximumStudy::sampling_difference() const {
  return relative_difference(sampled, truncated.midpoint());
}

double ForceMaximumStudy::truncation_difference() const {
  return relative_difference(truncated.midpoint(), converged.midpoint());
}

double ForceMaximumStudy::discretisation_difference() const {
  return relative_difference(finite_element, converged.midpoint());
}

double ForceMaximumStudy::prediction_difference() const {
  return relative_difference(finite_element, predicted_finite_element);
}

double ForceMaximumStudy::printed_difference() const {
  return relative_difference(sampled, data::printed_number(fmt::format("force_max.{}", frequency_hz)).value);
}

ForceMaximumStudy force_maximum_study(const data::Case& problem) {
  const data::HarmonicExcitation& excitation = problem.excitation();
  const analytic::StickResponse truncated(problem.beam(), excitation, problem.numerics.modes());
  const analytic::StickResponse converged(problem.beam(), excitation, reference_modes,
                                          analytic::SteadyPart::exact);
  const PredictedForce predicted(problem);
  const double duration = problem.numerics.duration();
  return {.frequency_hz = excitation.frequency_hz(),
          .amplitude = excitation.amplitude(),
          .sampled = truncated.sampled_max_abs_friction_force(duration, problem.numerics.time_step()).lower,
          .truncated = truncated.max_abs_friction_force(duration),
          .converged = converged.max_abs_friction_force(duration, 1e-9),
          .finite_element = solver::max_abs_friction_force(problem),
          .predicted_finite_element = predicted.max_abs(),
          .prediction_uncertainty = predicted.uncertainty()};
}

AmplitudeRatio amplitude_ratio(const std::vector<CriticalAmplitudePoint>& curve,
                               const std::vector<CriticalAmplitudePoint>& reference) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < curve.size(); ++i)
    ratios.push_back(curve[i].critical_amplitude / reference[i].critical_amplitude);
  std::ranges::sort(ratios);
  const std::size_t tenth = ratios.size() / 10;
  return {.low_tenth = ratios[tenth],
          .median = ratios[ratios.size() / 2],
          .high_tenth = ratios[ratios.size() - 1 - tenth]};
}

std::vector<FrictionPoint> friction_curve(const data::FrictionLaw& law, double normal_force) {
  std::vector<FrictionPoint> curve;
  const auto add = [&](double velocity, double sign) {
    const double coefficient = solver::friction_coefficient(law, velocity);
    curve.push_back({velocity, coefficient, -sign * coefficient * normal_force});
  };
  constexpr int per_unit = 20, units = 5;  // points per m/s, m/s
  for (int i = -units * per_unit; i <= 0; ++i) add(static_cast<double>(i) / per_unit, -1.0);
  for (int i = 0; i <= units * per_unit; ++i) add(static_cast<double>(i) / per_unit, 1.0);
  return curve;
}

std::vector<ForceLine> force_surface(double friction_limit,
                                     const std::vector<CriticalAmplitudePoint>& criterion,
                                     const std::vector<double>& natural_frequencies) {
  std::vector<ForceLine> surface;
  for (const auto& [hz, critical_amplitude] : criterion) {
    const bool near_resonance = std::ranges::any_of(
        natural_frequencies, [&, hz = hz](double natural) { return std::abs(hz - natural) < 2.0; });
    const double step = near_resonance ? 0.25 : 1.0;
    if (std::abs(hz - step * std::round(hz / step)) > 1e-9) continue;
    ForceLine line{.frequency_hz = hz, .amplitude = {}, .force_max = {}};
    for (int i = 1; i <= 20; ++i) {
      line.amplitude.push_back(0.05e-3 * i);
      line.force_max.push_back(friction_limit * line.amplitude.back() / critical_amplitude);
    }
    surface.push_back(line);
  }
  return surface;
}

}  // namespace stickslip::studies
