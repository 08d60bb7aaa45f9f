// SPDX-License-Identifier: MIT
#include "studies/verification/scope.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/force_maximum.hpp"

namespace stickslip::studies {

namespace {

constexpr int kept_modes = 20;  // with the exact steady part; the omitted modes are bounded

data::Case at(const data::Case& problem, double hz, double amplitude) {
  return with(problem, data::HarmonicExcitation({.frequency_hz = hz, .amplitude = amplitude}));
}

ForceHorizon horizon(const analytic::StickResponse& response, double duration) {
  const analytic::Bounds kept = response.max_abs_friction_force(duration, 1e-7);
  const double omitted = response.omitted_transient_bound();
  return {.duration = duration, .force_max = {kept.lower - omitted, kept.upper + omitted}};
}

}  // namespace

SteadyForce steady_force(const data::Case& paper, const std::vector<double>& durations) {
  const analytic::StickResponse response(paper.beam(), paper.excitation(), kept_modes,
                                         analytic::SteadyPart::exact);
  const auto warnings = criterion_warnings(paper);
  SteadyForce result{
      .frequency_hz = paper.excitation().frequency_hz(),
      .amplitude = paper.excitation().amplitude(),
      .steady = std::abs(response.steady_force_amplitude()),
      .grows = std::ranges::find(warnings, Concern::resonance, &Warning::concern) != warnings.end(),
      .horizons = {}};
  for (const double duration : durations) result.horizons.push_back(horizon(response, duration));
  return result;
}

SteadyDampedForce damped_force(const data::Case& damped) {
  const analytic::DampedSteadyState steady(damped.beam(), damped.excitation(), damped.damping,
                                           analytic::TipSupport::held);
  return {.frequency_hz = damped.excitation().frequency_hz(),
          .amplitude = damped.excitation().amplitude(),
          .ratio = damped.damping.ratio_at(two_pi * stick_hz(damped.beam(), 1)),
          .steady = std::abs(steady.friction_force())};
}

SlenderForce slender_force(const data::Case& paper) {
  const analytic::ModalReaction slender = analytic::modal_reaction(paper.beam(), paper.numerics.modes());
  const analytic::ModalReaction sheared =
      analytic::modal_reaction(with_shear(paper.beam()), paper.numerics.modes());
  const auto force_max = [&](const analytic::ModalReaction& reaction) {
    return paper.excitation().amplitude() *
           analytic::ForceMaximum(reaction, angular_frequency(paper.excitation()), paper.numerics.duration())
               .refined_to(1e-7)
               .midpoint();
  };
  SlenderForce result{.frequency_hz = paper.excitation().frequency_hz(),
                      .model_errors = {},
                      .force_max = force_max(slender),
                      .shifted_force_max = force_max(sheared)};
  for (std::size_t i = 0; i < slender.modes.size(); ++i)
    result.model_errors.push_back(slender.modes[i].angular_frequency / sheared.modes[i].angular_frequency -
                                  1.0);
  return result;
}

SofterBeam softer_beam(const data::Case& paper, int last_hz) {
  const data::Case softer = with_value(paper, "beam.youngs_modulus", 0.5 * paper.beam().youngs_modulus());
  const auto critical = [](const data::Case& problem, double hz) {
    return analytic::evaluate_criterion(at(problem, hz, 1e-3), 1e-6).critical_amplitude.midpoint();
  };
  SofterBeam result{.all = last_hz, .lowest_ratio = std::numeric_limits<double>::infinity()};
  for (int hz = 1; hz <= last_hz; ++hz) {
    const double ratio = critical(softer, hz) / critical(paper, hz);
    if (ratio > 1.0) ++result.larger;
    if (ratio >= result.lowest_ratio) continue;
    result.lowest_ratio = ratio;
    result.at_hz = hz;
  }
  return result;
}

LateSlips late_slips(const std::vector<double>& time, const std::vector<double>& tip) {
  const auto range_from = [&](std::size_t first) {
    const auto [low, high] = std::minmax_element(tip.begin() + static_cast<std::ptrdiff_t>(first), tip.end());
    return *high - *low;
  };
  const double range = range_from(0);
  std::size_t settled = tip.size() - 1;
  while (settled > 0 && std::abs(tip[settled - 1] - tip.back()) <= settled_share * range) --settled;
  return {.range = range, .settled = time[settled], .later_range = range_from(settled)};
}

DimensionlessCase dimensionless(const data::Case& problem) {
  const data::Beam& beam = problem.beam();
  const double omega = angular_frequency(problem.excitation()), natural = two_pi * stick_hz(beam, 1);
  const ForceMaximumStudy force = force_maximum_study(
      with(problem, data::HarmonicExcitation({problem.excitation().frequency_hz(), 1e-3}), data::Damping()));
  return {.name = problem.name,
          .load = beam.axial_force() / analytic::stick_buckling_load(beam),
          .slenderness = beam.length() * std::sqrt(beam.area() / beam.second_moment_of_area()),
          .frequency = omega / natural,
          .friction = problem.contact.friction.static_coefficient(),
          .decay = problem.contact.friction.decay() * problem.excitation().amplitude() * omega,
          .damping = problem.damping.ratio_at(natural),
          .force_error = force.discretisation_difference(),
          .unpredicted =
              std::abs(force.finite_element - force.predicted_finite_element) / force.prediction_uncertainty};
}

Scope scope(const data::Case& paper, const data::Case& damped, const ConvergedHistory& converged,
            const ScopeRange& range) {
  Scope study;
  study.friction_limit = friction_limit(paper);
  study.steady.resize(range.frequencies_hz.size());
  study.slender.resize(range.frequencies_hz.size());
  in_parallel(range.frequencies_hz.size(), [&](std::size_t i) {
    const data::Case problem = at(paper, range.frequencies_hz[i], range.amplitudes.front());
    study.steady[i] = steady_force(problem, range.durations);
    study.slender[i] = slender_force(problem);
  });
  for (const double amplitude : range.amplitudes)
    study.damped.push_back(damped_force(with(at(paper, 25.0, amplitude), damped.damping)));
  study.softer = softer_beam(paper, range.last_hz);
  study.late_slips = late_slips(converged.time, converged.tip);
  return study;
}

}  // namespace stickslip::studies
