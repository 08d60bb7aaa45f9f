// SPDX-License-Identifier: MIT
#include "studies/criterion/scope.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/hertz.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/convergence/discretisation.hpp"
#include "studies/criterion/problem_warnings.hpp"
#include "studies/stick_slip/event_history.hpp"
#include "studies/stick_slip/history_convergence.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;

constexpr int kept_modes = 20;  // with the exact steady part; the omitted modes are bounded

data::Case at(data::Case problem, double hz, double amplitude) {
  problem.excitation = data::HarmonicExcitation({.frequency_hz = hz, .amplitude = amplitude});
  return problem;
}

double friction_limit_of(const data::Case& problem) {
  return problem.friction.static_coefficient() * problem.beam.axial_force();
}

// |f_max| over `duration` as finite elements are predicted to give it.
double predicted_error(const data::Case& problem, double duration, double force_max) {
  data::NumericalChoices choices = problem.numerics.choices();
  choices.duration = duration;
  const PredictedForce predicted(problem.beam, problem.excitation, data::NumericalSettings(choices),
                                 kept_modes);
  return std::abs(predicted.max_abs() - force_max) + predicted.uncertainty();
}

ForceHorizon horizon(const data::Case& problem, const analytic::StickResponse& response, double duration) {
  const analytic::Bounds kept = response.max_abs_friction_force(duration, 1e-7);
  const double omitted = response.omitted_transient_bound();
  ForceHorizon result{
      .duration = duration, .force_max = {kept.lower - omitted, kept.upper + omitted}, .finite_element = {}};
  const double force_max = result.force_max.midpoint();
  result.critical_amplitude = problem.excitation.amplitude() * friction_limit_of(problem) / force_max;
  if (duration > problem.numerics.duration()) return result;
  data::NumericalChoices choices = problem.numerics.choices();
  choices.duration = duration;
  result.finite_element = solver::max_abs_friction_force(
      problem.beam, problem.excitation, data::NumericalSettings(choices), {}, solver::Coordinates::modal);
  result.predicted_error = predicted_error(problem, duration, force_max);
  return result;
}

// The frequency of stick mode 1 in a run by time steps over the exact one, squared.
double stepped_eigenvalue_ratio(const data::Case& problem) {
  const analytic::StickMode mode = analytic::stick_modes(problem.beam, 1).front();
  const double stepped = discrete_oscillation(problem.beam, mode, problem.numerics).angular_frequency;
  return std::pow(stepped / mode.angular_frequency(), 2);
}

double damped_steady_force(const data::Case& problem) {
  return std::abs(analytic::DampedSteadyState(problem.beam, problem.excitation, problem.damping,
                                              analytic::TipSupport::held)
                      .friction_force());
}

// The history of y(L), the times of the onsets, and what is left after the large slips.
LateSlips late_slips_of(std::string method, const std::vector<double>& time, const std::vector<double>& tip,
                        double last_onset) {
  const auto range_from = [&](std::size_t first) {
    const auto [low, high] = std::minmax_element(tip.begin() + static_cast<std::ptrdiff_t>(first), tip.end());
    return *high - *low;
  };
  const double range = range_from(0);
  std::size_t settled = tip.size() - 1;
  while (settled > 0 && std::abs(tip[settled - 1] - tip.back()) <= settled_share * range) --settled;
  return {.method = std::move(method),
          .duration = time.back(),
          .range = range,
          .settled = time[settled],
          .later_range = range_from(settled),
          .last_onset = last_onset};
}

LateSlips late_slips_on_mesh(const data::Case& problem, const data::NumericalSettings& numerics,
                             double duration, int every) {
  const TipHistory history =
      time_stepper_history(problem.beam, problem.friction, problem.excitation, numerics,
                           {.coordinates = solver::Coordinates::modal}, duration, every);
  double last_onset = 0.0;
  for (const HistoryEvent& event : history.events)
    if (event.onset) last_onset = event.time;
  return late_slips_of(
      fmt::format("finite elements, {}, {:.2g} s", numerics.elements(), numerics.time_step()), history.time,
      history.tip_displacement, last_onset);
}

}  // namespace

double finite_element_steady_force(const data::Case& problem, int elements) {
  if (problem.damping.ratio() != 0.0)
    throw data::FieldError("damping.ratio", problem.damping.ratio(),
                           "0 for the steady vibration, which knows Kelvin-Voigt damping only");
  const solver::BeamModel model(problem.beam, elements);
  const double omega = angular_frequency(problem.excitation), amplitude = problem.excitation.amplitude();
  const Complex loss{0.0, omega * problem.damping.kelvin_voigt()};
  const Eigen::MatrixXcd matrix = Eigen::MatrixXd(model.slip_stiffness()).cast<Complex>() +
                                  loss * Eigen::MatrixXd(model.elastic_stiffness()).cast<Complex>() -
                                  omega * omega * Eigen::MatrixXd(model.mass()).cast<Complex>();
  const Eigen::Index tip = model.tip_deflection();
  Eigen::VectorXcd load = (omega * omega * amplitude * model.base_load()).cast<Complex>();
  // u(L) = -A0; the row of the tip is that of its reaction.
  Eigen::MatrixXcd held = matrix;
  Eigen::VectorXcd right = load + amplitude * matrix.col(tip);
  held.row(tip).setZero();
  held.col(tip).setZero();
  held(tip, tip) = 1.0;
  right[tip] = -amplitude;
  const Eigen::VectorXcd u = held.partialPivLu().solve(right);
  return std::abs((matrix.row(tip) * u)(0) - load[tip]);
}

SteadyForce steady_force(const data::Case& paper, const std::vector<double>& durations) {
  const analytic::StickResponse response(paper.beam, paper.excitation, kept_modes,
                                         analytic::SteadyPart::exact);
  const int elements = paper.numerics.elements();
  SteadyForce result{
      .frequency_hz = paper.excitation.frequency_hz(),
      .amplitude = paper.excitation.amplitude(),
      .steady = std::abs(response.steady_force_amplitude()),
      .truncated = std::abs(analytic::StickResponse(paper.beam, paper.excitation, paper.numerics.modes())
                                .steady_force_amplitude()),
      .finite_element = finite_element_steady_force(paper, elements),
      .horizons = {}};
  result.predicted_error =
      16.0 / 15.0 * std::abs(result.finite_element - finite_element_steady_force(paper, 2 * elements));
  result.ceiling = result.steady + response.omitted_transient_bound();
  for (const analytic::Sinusoid& free : response.transient_force())
    result.ceiling += std::abs(free.amplitude);
  const auto warnings = problem_warnings(paper, Inquiry::criterion);
  result.grows = std::ranges::find(warnings, Concern::resonance, &Warning::concern) != warnings.end();
  for (const double duration : durations) result.horizons.push_back(horizon(paper, response, duration));
  return result;
}

SteadyDampedForce damped_force(const data::Case& damped) {
  const double omega = angular_frequency(damped.excitation), eta = damped.damping.kelvin_voigt();
  const analytic::StickMode first = analytic::stick_modes(damped.beam, 1).front();
  SteadyDampedForce result{
      .frequency_hz = damped.excitation.frequency_hz(),
      .amplitude = damped.excitation.amplitude(),
      .kelvin_voigt = eta,
      .ratio = 0.5 * eta * first.angular_frequency(),
      .undamped_force_max =
          analytic::StickResponse(damped.beam, damped.excitation, kept_modes, analytic::SteadyPart::exact)
              .max_abs_friction_force(damped.numerics.duration(), 1e-7)
              .midpoint(),
      .steady = damped_steady_force(damped)};
  solver::BeamSimulation run(damped.beam, damped.friction, damped.excitation, damped.numerics,
                             {.contact = solver::TipContact::bonded, .damping = damped.damping});
  const double step = damped.numerics.time_step();
  // Twice the duration for the free vibrations to decay; then the part at Omega of a second.
  for (long n = 2 * solver::step_count(damped.numerics.duration(), step); n > 0; --n) run.step();
  const long steps = solver::step_count(1.0, step);
  Complex sum{};
  for (long n = 0; n < steps; ++n) {
    run.step();
    sum += run.friction_force() * std::polar(1.0, -omega * run.time());
  }
  result.finite_element = 2.0 * std::abs(sum) / static_cast<double>(steps);
  const double modulus = damped.beam.youngs_modulus() * stepped_eigenvalue_ratio(damped);
  result.predicted_error =
      std::abs(damped_steady_force(with_value(damped, Parameter::youngs_modulus, modulus)) - result.steady);
  return result;
}

SlenderForce slender_force(const data::Case& paper) {
  const analytic::ModalReaction slender = analytic::modal_reaction(paper.beam, paper.numerics.modes());
  const analytic::ModalReaction sheared =
      analytic::modal_reaction(with_shear(paper.beam), paper.numerics.modes());
  const auto force_max = [&](const analytic::ModalReaction& reaction) {
    return paper.excitation.amplitude() *
           analytic::ForceMaximum(reaction, angular_frequency(paper.excitation), paper.numerics.duration())
               .refined_to(1e-7)
               .midpoint();
  };
  SlenderForce result{.frequency_hz = paper.excitation.frequency_hz(),
                      .amplitude = paper.excitation.amplitude(),
                      .model_errors = {},
                      .force_max = force_max(slender),
                      .shifted_force_max = force_max(sheared)};
  for (std::size_t i = 0; i < slender.modes.size(); ++i)
    result.model_errors.push_back(slender.modes[i].angular_frequency / sheared.modes[i].angular_frequency -
                                  1.0);
  return result;
}

SofterBeam softer_beam(const data::Case& paper, int last_hz) {
  const data::Case softer = with_value(paper, Parameter::youngs_modulus, 0.5 * paper.beam.youngs_modulus());
  const auto critical = [](const data::Case& problem, double hz) {
    return analytic::evaluate_criterion(problem.beam, problem.friction, at(problem, hz, 1e-3).excitation,
                                        problem.numerics.duration(), problem.numerics.modes(),
                                        analytic::SteadyPart::modal_sum, 1e-6)
        .critical_amplitude.midpoint();
  };
  SofterBeam result{.all = last_hz, .lowest_ratio = std::numeric_limits<double>::infinity()};
  for (int hz = 1; hz <= last_hz; ++hz) {
    const double ratio = critical(softer, hz) / critical(paper, hz);
    if (ratio > 1.0) ++result.larger;
    if (ratio < result.lowest_ratio) result.lowest_ratio = ratio, result.at_hz = hz;
  }
  return result;
}

std::vector<LateSlips> late_slips(const data::Case& paper, const ConvergedHistory& converged) {
  const data::Case problem = at(paper, converged.frequency_hz, converged.amplitude);
  const double duration = converged.time.back();
  const ConvergedStick& last = converged.sticks.empty() ? converged.first_stick : converged.sticks.back();
  std::vector<LateSlips> result{late_slips_of("converged", converged.time, converged.tip, last.end)};
  constexpr int elements = 40;
  data::NumericalChoices filtering = paper.numerics.choices();
  filtering.elements = elements;
  filtering.spectral_radius = 0.0;
  filtering.velocity_threshold = 0.0;
  filtering.time_step = time_step_of({.angle = filtering_angle}, paper.beam, elements);
  result.push_back(late_slips_on_mesh(problem, data::NumericalSettings(filtering), duration, 1));
  for (const int count : {20, 40})
    result.push_back(late_slips_on_mesh(problem, refined(paper.numerics, count, paper.numerics.time_step()),
                                        paper.numerics.duration(), 10));
  return result;
}

Scope scope(const data::Case& paper, const data::Case& damped, const ConvergedHistory& converged,
            const ScopeRange& range) {
  const auto &frequencies = range.frequencies_hz, &amplitudes = range.amplitudes;
  Scope study;
  study.friction_limit = friction_limit_of(paper);
  study.steady.resize(frequencies.size());
  study.damped.resize(amplitudes.size());
  study.slender.resize(frequencies.size());
  in_parallel(frequencies.size() + amplitudes.size(), [&](std::size_t i) {
    if (i < frequencies.size()) {
      const data::Case problem = at(paper, frequencies[i], amplitudes.front());
      study.steady[i] = steady_force(problem, range.durations);
      study.slender[i] = slender_force(problem);
    } else {
      data::Case problem = at(paper, 25.0, amplitudes[i - frequencies.size()]);
      problem.damping = damped.damping;
      study.damped[i - frequencies.size()] = damped_force(problem);
    }
  });
  study.softer = softer_beam(paper, range.last_hz);
  study.late_slips = late_slips(paper, converged);
  return study;
}

}  // namespace stickslip::studies
