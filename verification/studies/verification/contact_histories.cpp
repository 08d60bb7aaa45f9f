// SPDX-License-Identifier: MIT
#include "studies/verification/contact_histories.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/finite_element_contact_model.hpp"

namespace stickslip::studies {

namespace {

constexpr double sample = 2e-4;

}  // namespace

std::optional<double> closed_form_first_slip(const data::Beam& beam, const data::FrictionLaw& friction,
                                             const data::HarmonicExcitation& excitation, double duration) {
  const analytic::StickResponse response(beam, excitation, 60, analytic::SteadyPart::exact);
  const double limit = friction_limit(friction, beam);
  const auto exceeded = [&](double t) { return std::abs(response.friction_force(t)) > limit; };
  const double scan =
      std::min(1.0 / excitation.frequency_hz(), 1.0 / response.modes().front().frequency_hz()) / 2000.0;
  const long samples = std::lround(duration / scan);
  for (long n = 1; n <= samples; ++n) {
    double high = static_cast<double>(n) * scan;
    if (!exceeded(high)) continue;
    double low = high - scan;
    while (high - low > 5e-5 * scan) {
      const double middle = 0.5 * (low + high);
      (exceeded(middle) ? high : low) = middle;
    }
    return high;
  }
  return std::nullopt;
}

ContactHistory contact_history(const data::Case& problem, double shown) {
  ContactHistory history;
  history.frequency_hz = problem.excitation.frequency_hz();
  history.amplitude = problem.excitation.amplitude();
  history.finite_element_slip =
      solver::first_slip(problem.beam, problem.friction, problem.excitation, problem.numerics);
  const double duration = problem.numerics.duration();
  history.criterion_slips = analytic::evaluate_criterion(problem.beam, problem.friction, problem.excitation,
                                                         duration, problem.numerics.modes())
                                .verdict == analytic::Verdict::stick_slip;
  if (history.criterion_slips) {
    history.closed_form_slip =
        closed_form_first_slip(problem.beam, problem.friction, problem.excitation, duration);
    history.converged = converged_history(problem, {.duration = shown,
                                                    .samples = static_cast<int>(std::lround(shown / sample)),
                                                    .steps_per_sample = 512,
                                                    .with_midspan = false});
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
    data::Case problem = paper;
    problem.excitation = data::HarmonicExcitation({verdict.frequency_hz, verdict.amplitude});
    histories.push_back(contact_history(problem, shown));
    histories.back().figure = verdict.figure;
    histories.back().printed_slips = verdict.verdict == "stick-slip";
  }
  return histories;
}

std::vector<PracticeRun> usual_practice(data::Case problem, const ConvergedHistory& converged) {
  problem.excitation = data::HarmonicExcitation({converged.frequency_hz, converged.amplitude});
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
  const int meshes[] = {elements, 2 * elements};  // of the event-driven runs
  std::vector<PracticeRun> runs(std::size(stepped) + std::size(meshes));
  in_parallel(runs.size(), [&](std::size_t i) {
    PracticeRun& run = runs[i];
    History history;
    if (i < std::size(stepped)) {
      const auto& [method, radius, scheme, threshold] = stepped[i];
      data::NumericalChoices choices = numerics.choices();
      choices.spectral_radius = radius;
      choices.velocity_threshold = threshold;
      choices.duration = duration;
      data::Case at = problem;
      at.numerics = data::NumericalSettings(choices);
      history = finite_element_history(at, {.every = std::lround(spacing / h)},
                                       {.scheme = scheme, .coordinates = solver::Coordinates::nodal});
      run = {.method = method, .elements = elements, .time_step = h, .spectral_radius = radius};
    } else {
      run = {.method = "event-driven", .elements = meshes[i - std::size(stepped)]};
      history = event_driven_history(finite_element_contact_model(problem, run.elements),
                                     sample_times(duration, spacing));
    }
    run.changes = static_cast<int>(history.events.size());
    run.tip_displacement = tip_displacements(history);
    run.largest_error = largest_difference(converged.tip, run.tip_displacement) / converged.tip_range;
  });
  return runs;
}

}  // namespace stickslip::studies
