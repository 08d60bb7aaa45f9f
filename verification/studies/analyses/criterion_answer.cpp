// SPDX-License-Identifier: MIT
#include "studies/analyses/criterion_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/history/natural_frequencies.hpp"

namespace stickslip::studies {

namespace {

std::optional<StickFrequency> nearest_stick_frequency(const data::Case& problem) {
  const auto shares = analytic::held_modes(problem, analytic::modes_of_all(problem).first);
  if (shares.empty()) return std::nullopt;
  const double omega = angular_frequency(problem.excitation());
  const auto nearest = std::ranges::min_element(
      shares, {}, [&](const auto& share) { return std::abs(share.angular_frequency - omega); });
  return StickFrequency{.mode = static_cast<int>(nearest - shares.begin()) + 1,
                        .hz = nearest->angular_frequency / (2.0 * std::numbers::pi),
                        .distance = (nearest->angular_frequency - omega) / omega};
}

// 1/s, of the slowest free vibration of the held contact; infinite if there is none.
double slowest_decay(const data::Case& problem) {
  if (problem.model() != nullptr) return analytic::StickReaction(problem).slowest_decay();
  const double first = two_pi * closed_form_frequencies(problem, analytic::TipSupport::held, 1).front().hz;
  return first * problem.damping.ratio_at(first);
}

std::optional<SteadyState> steady_state(const data::Case& problem,
                                        const std::optional<StickFrequency>& nearest) {
  if (!problem.is_damped() && nearest &&
      std::abs(nearest->distance) <=
          closed_form_frequencies(problem, analytic::TipSupport::held, nearest->mode).back().relative_error)
    return std::nullopt;
  constexpr double steady_after = 3.0;  // time constants, which leave 5 % of a free vibration
  const double decay = slowest_decay(problem);
  const analytic::Bounds per_unit = analytic::steady_reaction(problem);
  const double limit = friction_limit(problem);
  const analytic::Bounds force = problem.excitation().amplitude() * per_unit;
  return SteadyState{.force = force,
                     .critical_amplitude = limit / per_unit,
                     .verdict = analytic::verdict_of(force, limit),
                     .reached = problem.numerics.duration() * decay >= steady_after};
}

// At these times, the tip held by as much friction as it takes.
Bending held_bending(const data::Case& problem, std::vector<double> times) {
  constexpr int fewest_modes = 10;
  const double length = problem.beam().length();
  const data::Case held = data::with_value(
      with(problem, data::FrictionLaw({.static_coefficient = 1e30, .kinetic_coefficient = 0.0})),
      "numerics.modes", std::max(fewest_modes, problem.numerics.modes()));
  Bending bending;
  std::ignore =
      event_driven_history(held, {.times = std::move(times), .positions = Bending::positions(length)}, {},
                           [&](const HistoryRow& row) { bending.include(row, length); });
  return bending;
}

// Damped, over a period once the slowest free vibration has fallen to exp(-30). A ratio holds with the tip free, whose first
// frequency is more than a fifth of the held one.
double steady_draw_back(const data::Case& problem) {
  if (!problem.is_damped()) {
    Bending bending;
    bending.include(steady_crest(problem, Bending::positions(problem.beam().length())),
                    problem.beam().length());
    return bending.draw_back;
  }
  const double first = two_pi * stick_hz(problem.beam(), 1), at_first = problem.damping.ratio_at(first);
  const double ratio = std::min(at_first, 0.5 / at_first);  // a vibration beyond critical damping creeps back
  std::vector<double> times;
  for (int i = 0; i < 64; ++i)
    times.push_back(150.0 / (ratio * first) + i / (64.0 * problem.excitation().frequency_hz()));
  return held_bending(problem, times).draw_back;
}

std::optional<ModesUsed> modes_used(const data::Case& problem) {
  if (problem.model() == nullptr || problem.model()->is_mass()) return std::nullopt;
  const analytic::HeldStructure structure = analytic::held_structure(problem, problem.numerics.modes());
  const double wall = structure.wall_share,
               coupling = wall * structure.contact_mass - structure.participation.back();
  double residual = coupling;
  for (std::size_t n = 0; n < structure.modes(); ++n)
    residual += structure.mass_coupling[n] * (structure.participation[n] - wall * structure.mass_coupling[n]);
  return ModesUsed{structure.modes(), structure.moved_mass,
                   coupling == 0.0 ? 0.0 : std::abs(residual / coupling)};
}

CriticalAmplitudeSearch search(const data::Case& problem, double hz, double increment, double cap) {
  const int steps = static_cast<int>(std::lround(cap / increment));
  const auto at = [&](double amplitude) {
    return with(problem, data::HarmonicExcitation({.frequency_hz = hz, .amplitude = amplitude}));
  };
  CriticalAmplitudeSearch result;
  result.frequency_hz = hz;
  result.increment = increment;
  result.cap = cap;
  result.linear = increment * friction_limit(problem) / solver::max_abs_friction_force(at(increment));
  const double multiple = std::floor(result.linear / increment) + 1.0;
  if (multiple <= steps) result.stepped_linear = multiple * increment;
  while (!result.searched && result.runs < steps) {
    ++result.runs;
    const double amplitude = result.runs * increment;
    if (solver::first_slip(at(amplitude))) result.searched = amplitude;
  }
  return result;
}

}  // namespace

analytic::Bounds margin_of(const analytic::Criterion& criterion) {
  return criterion.friction_limit / criterion.force_max;
}

std::optional<Change> best_change(
    const data::Case& problem,
    const std::function<std::optional<double>(std::string_view key, double value)>& margin_with) {
  Change best;
  for (const data::Key& key : data::case_keys()) {
    if (!key.effects.is_adjustable) continue;
    for (const double factor : {0.9, 1.1}) {
      const double value = factor * data::value_of(problem, key.path);
      if (std::isnan(value)) continue;
      if (const auto margin = margin_with(key.path, value); margin && *margin > best.margin)
        best = {key.path, factor, *margin};
    }
  }
  return best.key.empty() ? std::nullopt : std::optional(best);
}

std::optional<Change> best_change(const data::Case& problem) {
  return best_change(problem, [&](std::string_view key, double value) -> std::optional<double> {
    try {
      return margin_of(analytic::evaluate_criterion(restated(problem, {{key, value}}))).lower;
    } catch (const data::InputError&) {  // no beam, or one without a stick state
      return std::nullopt;
    }
  });
}

bool too_few_modes(const analytic::Criterion& truncated, const analytic::Criterion& all_modes) {
  constexpr double allowed = 0.05;
  return all_modes.force_max.upper > (1.0 + allowed) * truncated.force_max.lower ||
         truncated.force_max.upper > (1.0 + allowed) * all_modes.force_max.lower;
}

std::optional<SteadyState> steady_state(const data::Case& problem) {
  return steady_state(problem, nearest_stick_frequency(problem));
}

std::optional<Bending> held_bending(const data::Case& problem) {
  constexpr int instants = 4096;
  if (problem.model() != nullptr || problem.has(data::Feature::shear) ||
      problem.has(data::Feature::general_motion))
    return std::nullopt;
  std::vector<double> times;
  for (int i = 0; i < instants; ++i)
    times.push_back(problem.numerics.duration() *
                    std::pow((i + std::fmod(i * std::numbers::phi, 1.0)) / instants, 3));
  return held_bending(problem, std::move(times));
}

CriterionAnswer criterion_answer(const data::Case& problem) {
  CriterionAnswer answer{.truncated = analytic::evaluate_criterion(problem),
                         .all_modes = analytic::criterion_with_all_modes(problem),
                         .steady = {},
                         .nearest = nearest_stick_frequency(problem),
                         .bending = held_bending(problem),
                         .steady_draw_back = {},
                         .modes_used = modes_used(problem),
                         .best_change = {}};
  answer.steady = steady_state(problem, answer.nearest);
  if (answer.bending && answer.steady) answer.steady_draw_back = steady_draw_back(problem);
  if (problem.excitation().amplitude() > 0.0 && !too_few_modes(answer.truncated, answer.all_modes))
    answer.best_change = best_change(problem);
  return answer;
}

std::vector<CriticalAmplitudePoint> critical_amplitude_curve(const data::Case& problem,
                                                             const std::vector<double>& frequencies_hz,
                                                             double relative_width) {
  std::vector<CriticalAmplitudePoint> points(frequencies_hz.size());
  in_parallel(points.size(), [&](std::size_t i) {
    const double hz = frequencies_hz[i];
    const data::Case at_hz = data::with_value(problem, "excitation.frequency_hz", hz);
    points[i] = {hz, analytic::evaluate_criterion(at_hz, relative_width).critical_amplitude.midpoint()};
  });
  return points;
}

CriticalAmplitudeCurve critical_amplitude_curve(const data::Case& problem) {
  constexpr int steps = 240;
  constexpr double reach = 4.0, beyond = 1.25, width = 1e-3;
  const double here = problem.excitation().frequency_hz(), first = here / reach;
  CriticalAmplitudeCurve curve;
  for (const auto& share : analytic::held_modes(problem, problem.numerics.modes()))
    curve.natural_hz.push_back(share.angular_frequency / (2.0 * std::numbers::pi));
  const double last =
      std::max(reach * here, curve.natural_hz.empty() ? 0.0 : beyond * curve.natural_hz.front());
  std::vector<double> frequencies;
  for (int i = 0; i <= steps; ++i)
    frequencies.push_back(first * std::pow(last / first, static_cast<double>(i) / steps));
  for (const double hz : curve.natural_hz)
    if (hz > first && hz < last) frequencies.push_back(hz);
  std::ranges::sort(frequencies);
  curve.points = critical_amplitude_curve(problem, frequencies, width);
  return curve;
}

std::vector<CriticalAmplitudeSearch> critical_amplitude_searches(const data::Case& problem,
                                                                 const std::vector<double>& frequencies_hz,
                                                                 double increment, double cap) {
  std::vector<CriticalAmplitudeSearch> searches(frequencies_hz.size());
  in_parallel(searches.size(),
              [&](std::size_t i) { searches[i] = search(problem, frequencies_hz[i], increment, cap); });
  return searches;
}

std::vector<double> figure6_frequencies() {
  std::vector<double> frequencies;
  for (int i = 1; i <= 20; ++i) frequencies.push_back(5.0 * i);
  return frequencies;
}

}  // namespace stickslip::studies
