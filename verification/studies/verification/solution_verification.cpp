// SPDX-License-Identifier: MIT
#include "studies/verification/solution_verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/contact_histories.hpp"
#include "studies/verification/paper_checks.hpp"

namespace stickslip::studies {

namespace {

constexpr double ratio = 1.5;
constexpr int levels = 3;
constexpr double formal_order = 4.0;
constexpr double figure9_duration = 1.0;  // s
constexpr double first_stick_duration = 0.1;

using Settings = data::NumericalSettings;

Settings level_settings(const Settings& published, int level) {
  data::NumericalChoices choices = published.choices();
  const double factor = std::pow(ratio, level);
  choices.elements = static_cast<int>(std::lround(choices.elements * factor));
  choices.time_step /= factor * factor;
  return Settings(choices);
}

// The uncertainty for a result whose levels are not asymptotic.
struct Prediction {
  double uncertainty;
  const char* obtained;
};

// A result to be computed: its value at given settings, its closed form, and its predicted error at the
// published settings.
struct Plan {
  std::string id, quantity, unit;
  bool stepped;
  std::function<double(const Settings&)> value;
  double reference;
  std::function<Prediction()> prediction;  // empty where the levels are asymptotic or there is no theory
};

double finite_element_hz(const data::Beam& beam, int mode, int elements) {
  return solver::stick_modes(solver::BeamModel(beam, elements), mode).back().angular_frequency / two_pi;
}

void add_frequencies(const data::Case& paper, std::vector<Plan>& plans) {
  const data::Beam half = half_stiff(paper.beam());
  const auto add = [&](const data::Beam& beam, int mode, const char* id_end, const char* name_end) {
    plans.push_back({fmt::format("frequency.stick.{}{}", mode, id_end),
                     fmt::format("stick frequency {}{}", mode, name_end), "Hz", false,
                     [=](const Settings& at) { return finite_element_hz(beam, mode, at.elements()); },
                     stick_hz(beam, mode), nullptr});
  };
  for (int mode = 1; mode <= 3; ++mode) add(paper.beam(), mode, "", "");
  for (int mode = 1; mode <= 3; ++mode) add(half, mode, ".half_stiffness", ", half stiffness");
}

// The length at which the frequency number `mode` of a mesh is `hz`, between bounds that enclose it; to 1e-12
// m.
double finite_element_resonance_length(const data::Beam& section, int mode, double hz, int elements,
                                       double low, double high) {
  const auto is_above = [&](double length) {
    return finite_element_hz(with(section, &data::BeamProperties::length, length), mode, elements) > hz;
  };
  return bisected(low, high, is_above, 1e-12);
}

void add_resonance_lengths(std::vector<Plan>& plans) {
  const data::Case figure = data::load_case("paper-figure14");
  const double hz = figure.excitation().frequency_hz();
  for (int mode = 1; mode <= 2; ++mode) {
    const double exact = resonance_length(figure.beam(), mode, hz).value();
    plans.push_back({fmt::format("figure14.length.{}", mode), fmt::format("L{} of the paper's Fig. 14", mode),
                     "m", false,
                     [=](const Settings& at) {
                       return finite_element_resonance_length(figure.beam(), mode, hz, at.elements(),
                                                              0.95 * exact, 1.05 * exact);
                     },
                     exact, nullptr});
  }
}

void add_force_maxima(const data::Case& paper, std::vector<Plan>& plans) {
  for (const double hz : printed_frequencies) {
    const data::HarmonicExcitation excitation = printed_excitation(hz);
    const double reference =
        analytic::StickResponse(paper.beam(), excitation, reference_modes, analytic::SteadyPart::exact)
            .max_abs_friction_force(paper.numerics.duration())
            .midpoint();
    plans.push_back(
        {printed_force(hz).id, fmt::format("|f_max| at {:g} Hz, 0.5 mm", hz), "N", true,
         [=](const Settings& at) { return solver::max_abs_friction_force(with(paper, excitation, at)); },
         reference,
         [=] {
           const PredictedForce predicted(with(paper, excitation));
           return Prediction{std::abs(predicted.max_abs() - reference) + predicted.uncertainty(),
                             "predicted error of mesh and step, and the uncertainty of the prediction"};
         }});
  }
}

void add_first_slips(const data::Case& paper, std::vector<Plan>& plans) {
  struct Panel {
    const char* figure;
    double hz, amplitude;
  };
  for (const Panel& panel : {Panel{"4b", 25.0, 0.5e-3}, Panel{"4d", 70.0, 0.5e-3}, Panel{"5b", 25.0, 1e-3},
                             Panel{"5c", 35.0, 1e-3}, Panel{"5d", 70.0, 1e-3}}) {
    const data::Case problem =
        with(paper, data::HarmonicExcitation({.frequency_hz = panel.hz, .amplitude = panel.amplitude}));
    const double reference = closed_form_first_slip(problem).value();
    plans.push_back(
        {fmt::format("figure{}.first_slip", panel.figure),
         fmt::format("first slip, the paper's Fig. {}", panel.figure), "s", true,
         [=](const Settings& at) { return solver::first_slip(with(problem, at)).value(); }, reference,
         [=] {
           const analytic::StickResponse exact(paper.beam(), problem.excitation(), reference_modes,
                                               analytic::SteadyPart::exact);
           constexpr double offset = 1e-6;
           const double slope =
               (exact.friction_force(reference + offset) - exact.friction_force(reference - offset)) /
               (2.0 * offset);
           return Prediction{
               drift_bound(paper.beam(), exact.modes(), exact.transient_force(), paper.numerics, reference) /
                   std::abs(slope),
               "predicted force error over the slope of the force"};
         }});
  }
}

// max |history| over 0 ... duration: the largest sample with the step `step`, refined near it with a step a
// hundred times smaller.
double largest_magnitude(double duration, double step, const std::function<double(double)>& history) {
  double largest = 0.0, at = 0.0;
  for (long n = solver::step_count(duration, step); n >= 0; --n) {
    const double t = static_cast<double>(n) * step;
    const double value = std::abs(history(t));
    if (value > largest) largest = value, at = t;
  }
  for (int k = -100; k <= 100; ++k) {
    const double t = std::clamp(at + 0.01 * k * step, 0.0, duration);
    largest = std::max(largest, std::abs(history(t)));
  }
  return largest;
}

void add_figure9(const data::Case& paper, std::vector<Plan>& plans) {
  const data::HarmonicExcitation excitation = printed_excitation(15.0);
  const double midspan = 0.5 * paper.beam().length();
  const analytic::StickResponse exact(paper.beam(), excitation, reference_modes, analytic::SteadyPart::exact);
  const auto peak = [=](const Settings& at, double (solver::BeamSimulation::*quantity)() const) {
    solver::BeamSimulation run(with(paper, excitation, at),
                               {.is_bonded = true, .coordinates = solver::Coordinates::nodal});
    double largest = std::abs((run.*quantity)());
    for (long n = solver::step_count(figure9_duration, at.time_step()); n > 0; --n) {
      run.integrator().step();
      largest = std::max(largest, std::abs((run.*quantity)()));
    }
    return largest;
  };
  const auto drift = [=](const std::vector<analytic::Sinusoid>& free) {
    return Prediction{drift_bound(paper.beam(), exact.modes(), free, paper.numerics, figure9_duration),
                      "predicted drift of the free vibrations"};
  };
  plans.push_back(
      {"figure9.displacement_peak", "peak of |y(L/2)|, the paper's Fig. 9", "m", true,
       [=](const Settings& at) { return peak(at, &solver::BeamSimulation::midspan_displacement); },
       largest_magnitude(figure9_duration, 2e-5, exact.absolute_displacement(midspan)),
       [=] { return drift(exact.transient_displacement(midspan)); }});
  plans.push_back({"figure9.force_peak", "peak of |f|, the paper's Fig. 9", "N", true,
                   [=](const Settings& at) { return peak(at, &solver::BeamSimulation::friction_force); },
                   exact.max_abs_friction_force(figure9_duration).midpoint(),
                   [=] { return drift(exact.transient_force()); }});
}

// y(L) in the first stick phase after the first slip that lasts for at least shortest_stick.
double first_stick_position(const data::Case& problem, const Settings& at) {
  const History history = finite_element_history(
      refined(problem, at.elements(), at.time_step(), first_stick_duration, at.spectral_radius()), {},
      {.coordinates = solver::Coordinates::nodal});
  return first_capture(without_micro_sticks(history.events, ConvergedEffort{}.shortest_stick))
      .value()
      .position;
}

// What the first slip leaves, against the boundary integral. There is no theory of its error.
void add_first_sticks(const data::Case& paper, std::vector<Plan>& plans) {
  for (const auto& [panel, hz] : {std::pair{"5b", 25.0}, {"5c", 35.0}, {"5d", 70.0}}) {
    const data::Case problem = with(paper, data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1e-3}));
    const ConvergedHistory reference = converged_history(problem, {.duration = first_stick_duration,
                                                                   .samples = 200,
                                                                   .steps_per_sample = 512,
                                                                   .levels = 2,
                                                                   .with_midspan = false});
    plans.push_back({fmt::format("figure{}.first_stick", panel),
                     fmt::format("y(L) after the first slip, the paper's Fig. {}", panel), "m", true,
                     [=](const Settings& at) { return first_stick_position(problem, at); },
                     reference.sticks.at(0).position, nullptr});
  }
}

std::optional<double> printed_value(const std::string& id) {
  for (const data::PrintedNumber& number : data::printed_numbers())
    if (number.id == id) return number.value;
  return std::nullopt;
}

VerifiedResult verified(const Plan& plan, std::vector<VerificationLevel> computed) {
  VerifiedResult result{.id = plan.id,
                        .quantity = plan.quantity,
                        .unit = plan.unit,
                        .printed = printed_value(plan.id),
                        .levels = std::move(computed),
                        .convergence = {},
                        .reference = plan.reference,
                        .obtained = {}};
  std::vector<double> values;
  for (const VerificationLevel& level : result.levels) values.push_back(level.value);
  result.convergence = grid_convergence(values, ratio, formal_order);
  result.true_error = values.front() - plan.reference;
  result.covered = std::abs(result.true_error) <= result.convergence.index;
  if (result.convergence.asymptotic || !plan.prediction) {
    result.uncertainty = result.convergence.index;
    result.obtained = result.convergence.asymptotic ? "grid convergence index"
                                                    : "grid convergence index outside its range, an estimate";
  } else {
    const Prediction prediction = plan.prediction();
    result.uncertainty = prediction.uncertainty;
    result.obtained = prediction.obtained;
  }
  return result;
}

// μ_s P over |f_max| per unit amplitude at the minimum of Fig. 6, from the levels of |f_max|.
VerifiedResult critical_amplitude(const data::Case& paper, double reference_force,
                                  std::vector<VerificationLevel> levels_of_force) {
  const double scale = friction_limit(paper) * printed_excitation(25.0).amplitude();
  const Plan plan{"figure6.minimum.amplitude",
                  "critical amplitude at 25 Hz",
                  "m",
                  true,
                  {},
                  scale / reference_force,
                  nullptr};
  for (VerificationLevel& level : levels_of_force) level.value = scale / level.value;
  return verified(plan, std::move(levels_of_force));
}

}  // namespace

GridConvergence grid_convergence(const std::vector<double>& values, double refinement, double order) {
  if (values.size() != 3)
    throw std::invalid_argument(fmt::format("grid_convergence: needs 3 values, got {}", values.size()));
  if (!(refinement > 1.0))
    throw std::invalid_argument(
        fmt::format("grid_convergence: ratio is {}, but must be above 1", refinement));
  if (!(order > 0.0))
    throw std::invalid_argument(
        fmt::format("grid_convergence: formal_order is {}, but must be above 0", order));
  const double coarse = values[0] - values[1], fine = values[1] - values[2];
  GridConvergence result;
  if (coarse * fine > 0.0) result.observed_order = std::log(coarse / fine) / std::log(refinement);
  result.asymptotic = result.observed_order && std::abs(*result.observed_order - order) <= 0.1 * order;
  result.safety_factor = result.asymptotic ? 1.25 : 3.0;
  const double power = std::pow(refinement, result.asymptotic ? *result.observed_order : order);
  result.extrapolated = values[2] - fine / (power - 1.0);
  const double difference =
      result.asymptotic ? std::abs(coarse) : std::max(std::abs(coarse), std::abs(coarse + fine));
  result.index = result.safety_factor * difference * power / (power - 1.0);
  return result;
}

SolutionVerification solution_verification(const data::Case& paper) {
  std::vector<Plan> plans;
  add_frequencies(paper, plans);
  add_force_maxima(paper, plans);
  add_resonance_lengths(plans);
  add_first_slips(paper, plans);
  add_figure9(paper, plans);
  add_first_sticks(paper, plans);

  std::vector<std::vector<VerificationLevel>> computed(plans.size(), std::vector<VerificationLevel>(levels));
  in_parallel(plans.size() * levels, [&](std::size_t index) {
    const std::size_t i = index / levels, level = index % levels;
    const Settings at = level_settings(paper.numerics, static_cast<int>(level));
    computed[i][level] = {at.elements(), plans[i].stepped ? at.time_step() : 0.0, plans[i].value(at)};
  });
  SolutionVerification study{.ratio = ratio, .formal_order = formal_order, .results = {}};
  for (std::size_t i = 0; i < plans.size(); ++i) {
    study.results.push_back(verified(plans[i], computed[i]));
    if (plans[i].id == printed_force(25.0).id)
      study.results.push_back(critical_amplitude(paper, plans[i].reference, computed[i]));
  }
  return study;
}

}  // namespace stickslip::studies
