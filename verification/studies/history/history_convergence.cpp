// SPDX-License-Identifier: MIT
#include "studies/history/history_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "studies/history/contact_growth.hpp"
#include "studies/history/runs.hpp"

namespace stickslip::studies {

namespace {

// ω_max l² √(ρ A/EI) of a uniform mesh of elements of length l at P = 0. Computed: 59.792 for 5
// elements, 59.878 for 20 and more.
constexpr double highest_frequency_factor = 59.88;
// The fraction of the range of y(L) at which the observation of a growth ends.
constexpr double observed_until = 0.1;

solver::ContactSystem system_of(const data::Case& problem, const solver::BeamModel& mesh, double change,
                                double radiating_share) {
  const data::HarmonicExcitation excitation(
      {problem.excitation.frequency_hz(), problem.excitation.amplitude() * (1.0 + change)});
  const auto system =
      solver::beam_contact_system(mesh, problem.friction, solver::harmonic_motion(excitation));
  if (radiating_share == 0.0) return system;
  const data::Beam& beam = problem.beam;
  return with_radiating_contact(
      system, radiating_share * beam.density() * beam.area() * beam.length() / mesh.elements(),
      weakening(problem.friction, beam.axial_force()));
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
  const solver::BeamModel mesh(problem.beam, elements);
  const auto history = [&](double change) {
    if (radiating_share > 0.0)
      return radiating_history(mesh, system_of(problem, mesh, change, radiating_share),
                               {.time_step = step, .spectral_radius = spectral_radius}, duration, every);
    data::Case changed = at;
    changed.excitation = data::HarmonicExcitation(
        {problem.excitation.frequency_hz(), problem.excitation.amplitude() * (1.0 + change)});
    return finite_element_history(changed, {.every = every}, {.coordinates = solver::Coordinates::modal});
  };
  const History run = history(0.0);
  const solver::ContactMobility mobility(system_of(problem, mesh, 0.0, radiating_share));
  HistoryRun result{.elements = elements,
                    .time_step = step,
                    .spectral_radius = spectral_radius,
                    .highest_angle = mobility.angular_frequencies().maxCoeff() * step,
                    .growth_bound = growth_bound(stepped_contact(mobility, step, spectral_radius),
                                                 weakening(problem.friction, problem.beam.axial_force())),
                    .changes = static_cast<int>(run.events.size())};
  result.error = largest_difference(tip_displacements(run), reference.tip) / reference.tip_range;
  if (observe_growth)
    result.observed_growth =
        growth_rate(run, history(HistoryRun::perturbation), 1.0 / problem.excitation.frequency_hz(),
                    observed_until * reference.tip_range);
  return result;
}

HistoryRefinement history_refinement(const data::Case& problem, const ConvergedHistory& reference,
                                     const StepRule& rule, const std::vector<int>& elements,
                                     int observed_elements) {
  HistoryRefinement refinement;
  refinement.rule = rule;
  refinement.frequency_hz = problem.excitation.frequency_hz();
  refinement.beam_growth_bound = beam_growth_bound(problem.beam, problem.friction);
  std::vector<double> lengths, errors;
  for (const int count : elements) {
    refinement.runs.push_back(history_run(problem, reference, count, time_step_of(rule, problem.beam, count),
                                          rule.spectral_radius, count <= observed_elements,
                                          rule.radiating_share));
    lengths.push_back(problem.beam.length() / count);
    errors.push_back(refinement.runs.back().error);
  }
  refinement.order = order_estimate(lengths, errors);
  return refinement;
}

}  // namespace stickslip::studies
