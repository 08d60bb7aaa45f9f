// SPDX-License-Identifier: MIT
#include "studies/analyses/criterion_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/natural_frequencies.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

namespace {

using analytic::SteadyPart;

// The free vibrations that are kept where no truncation is asked for, at first and at most. Damping couples them.
constexpr int damped_modes = 40, most_damped_modes = 160, undamped_modes = 200, most_undamped_modes = 800;

data::HarmonicExcitation unit_excitation(double frequency_hz) {
  return data::HarmonicExcitation({.frequency_hz = frequency_hz, .amplitude = 1.0});
}

// What the modes that are not kept can add to the undamped reaction at most, N per m.
double omitted_transient_bound(const data::Case& problem, const data::HarmonicExcitation& unit, int modes) {
  if (problem.beam().shear_stiffness() > 0.0)
    return analytic::timoshenko_omitted_transient(analytic::timoshenko_reaction(problem.beam(), modes),
                                                  angular_frequency(unit));
  return analytic::StickResponse(problem.beam(), unit, modes, SteadyPart::exact).omitted_transient_bound();
}

// |f| per metre with so many modes, and with bounds of those that are left out.
analytic::DampedForce damped_force(const data::Case& problem, int modes) {
  const auto reaction = [&](int count) {
    return analytic::damped_reaction(problem.beam(), problem.damping, count, SteadyPart::exact);
  };
  return {reaction(modes), angular_frequency(problem.excitation()), problem.numerics.duration(),
          reaction(modes / 2)};
}

analytic::Bounds unit_force(const data::Case& problem, int modes, double relative_width) {
  if (is_damped(problem)) return damped_force(problem, modes).refined_to(relative_width);
  const double hz = problem.excitation().frequency_hz();
  const double omitted = omitted_transient_bound(problem, unit_excitation(hz), modes);
  const auto [lower, upper] =
      analytic::largest_unit_force(problem.beam(), problem.damping, hz, problem.numerics.duration(), modes,
                                   SteadyPart::exact, relative_width);
  return {std::max(0.0, lower - omitted), upper + omitted};
}

int most_modes(const data::Case& problem) {
  return is_damped(problem) ? most_damped_modes : most_undamped_modes;
}

// From so many on, doubled until the highest is at 4 Ω; half of them are then above Ω.
int enough_modes(const data::Case& problem, int first) {
  const int most = most_modes(problem);
  const double omega = angular_frequency(problem.excitation());
  for (int modes = first;; modes = std::min(2 * modes, most)) {
    const double highest = analytic::modal_forces(problem.beam(), modes).back().angular_frequency;
    if (highest >= 4.0 * omega) return modes;
    if (modes == most)
      throw data::FieldError(
          "excitation.frequency_hz", problem.excitation().frequency_hz(),
          fmt::format("at most {:.6g} Hz, a quarter of natural frequency {} of the stick state",
                      highest / (4.0 * two_pi), most));
  }
}

int kept_modes(const data::Case& problem) {
  return enough_modes(problem, is_damped(problem) ? damped_modes : undamped_modes);
}

// N per m: with a damping ratio by the modes kept, else exact.
analytic::Bounds steady_force_per_unit(const data::Case& problem) {
  const auto unit = unit_excitation(problem.excitation().frequency_hz());
  const double omega = angular_frequency(unit);
  if (problem.damping.ratio() > 0.0) return damped_force(problem, kept_modes(problem)).steady_bounds();
  const auto exactly = [](double force) { return analytic::Bounds{std::abs(force), std::abs(force)}; };
  if (problem.damping.kelvin_voigt() > 0.0)
    return exactly(std::abs(
        analytic::DampedSteadyState(problem.beam(), unit, problem.damping, analytic::TipSupport::held)
            .friction_force()));
  if (problem.beam().shear_stiffness() > 0.0)
    return exactly(analytic::timoshenko_steady_force(problem.beam(), omega));
  return exactly(analytic::StickResponse(problem.beam(), unit, kept_modes(problem), SteadyPart::exact)
                     .steady_force_amplitude());
}

StickFrequency nearest_stick_frequency(const data::Case& problem) {
  const auto shares = analytic::modal_forces(problem.beam(), kept_modes(problem));
  const double omega = angular_frequency(problem.excitation());
  const auto nearest = std::ranges::min_element(
      shares, {}, [&](const auto& share) { return std::abs(share.angular_frequency - omega); });
  return {.mode = static_cast<int>(nearest - shares.begin()) + 1,
          .hz = nearest->angular_frequency / (2.0 * std::numbers::pi),
          .distance = (nearest->angular_frequency - omega) / omega};
}

std::optional<SteadyState> steady_state(const data::Case& problem, const StickFrequency& nearest) {
  const auto natural = closed_form_frequencies(problem.beam(), analytic::TipSupport::held, nearest.mode);
  if (!is_damped(problem) && std::abs(nearest.distance) <= natural.back().relative_error) return std::nullopt;
  constexpr double steady_after = 3.0;  // time constants, which leave 5 % of a free vibration
  const double first = 2.0 * std::numbers::pi * natural.front().hz;
  const double decay = first * (problem.damping.ratio() + 0.5 * problem.damping.kelvin_voigt() * first);
  const analytic::Bounds per_unit = steady_force_per_unit(problem);
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
  const double first = two_pi * stick_hz(problem.beam(), 1), eta = problem.damping.kelvin_voigt() * first;
  std::vector<double> times;
  if (is_damped(problem)) {
    const double ratio = problem.damping.ratio() + (eta > 0.0 ? std::min(0.5 * eta, 1.0 / eta) : 0.0);
    for (int i = 0; i < 64; ++i)
      times.push_back(150.0 / (ratio * first) + i / (64.0 * problem.excitation().frequency_hz()));
    return held_bending(problem, times).draw_back;
  }
  const analytic::StickResponse response(problem.beam(), problem.excitation(), kept_modes(problem),
                                         SteadyPart::exact);
  HistoryRow crest;
  for (const double x : Bending::positions(problem.beam().length()))
    crest.displacement.push_back(response.steady_displacement_amplitude(x));
  Bending bending;
  bending.include(crest, problem.beam().length());
  return bending.draw_back;
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
  for (const std::string_view key :
       {"beam.length", "section.width", "section.height", "section.diameter", "section.wall_thickness",
        "beam.axial_force", "friction.static_coefficient"})
    for (const double factor : {0.9, 1.1}) {
      const double value = factor * data::value_of(problem, key);
      if (std::isnan(value)) continue;
      if (const auto margin = margin_with(key, value); margin && *margin > best.margin)
        best = {key, factor, *margin};
    }
  return best.key.empty() ? std::nullopt : std::optional(best);
}

bool too_few_modes(const analytic::Criterion& truncated, const analytic::Criterion& all_modes) {
  constexpr double allowed = 0.05;
  return all_modes.force_max.upper > (1.0 + allowed) * truncated.force_max.lower ||
         truncated.force_max.upper > (1.0 + allowed) * all_modes.force_max.lower;
}

// Evaluated at an amplitude of 1 m and scaled, since the reaction is proportional to the amplitude.
analytic::Criterion criterion_with_all_modes(const data::Case& problem, double relative_width,
                                             bool verdict_alone) {
  analytic::require_contact(problem.beam());
  const int most = most_modes(problem);
  const int first = is_damped(problem) ? damped_modes
                    : verdict_alone ? std::clamp(4 * problem.numerics.modes(), damped_modes, undamped_modes)
                                    : undamped_modes;
  const double limit = friction_limit(problem);
  for (int modes = enough_modes(problem, first);; modes = std::min(2 * modes, most)) {
    const analytic::Bounds per_unit = unit_force(problem, modes, relative_width);
    const analytic::Bounds force = problem.excitation().amplitude() * per_unit;
    const auto verdict = analytic::verdict_of(force, limit);
    if (modes == most || (verdict != analytic::Verdict::undecided && (verdict_alone || per_unit.lower > 0.0)))
      return {.force_max = force,
              .friction_limit = limit,
              .critical_amplitude = limit / per_unit,
              .verdict = verdict};
  }
}

std::optional<SteadyState> steady_state(const data::Case& problem) {
  return steady_state(problem, nearest_stick_frequency(problem));
}

std::optional<Bending> held_bending(const data::Case& problem) {
  constexpr int instants = 4096;
  if (problem.beam().shear_stiffness() > 0.0) return std::nullopt;
  std::vector<double> times;
  for (int i = 0; i < instants; ++i)
    times.push_back(problem.numerics.duration() *
                    std::pow((i + std::fmod(i * std::numbers::phi, 1.0)) / instants, 3));
  return held_bending(problem, std::move(times));
}

CriterionAnswer criterion_answer(const data::Case& problem, const Remake& remake) {
  CriterionAnswer answer{.truncated = criterion_of(problem),
                         .all_modes = criterion_with_all_modes(problem, 1e-10),
                         .steady = {},
                         .nearest = nearest_stick_frequency(problem),
                         .bending = held_bending(problem),
                         .steady_draw_back = {},
                         .best_change = {}};
  answer.steady = steady_state(problem, answer.nearest);
  if (answer.bending && answer.steady) answer.steady_draw_back = steady_draw_back(problem);
  if (problem.excitation().amplitude() > 0.0 && !too_few_modes(answer.truncated, answer.all_modes))
    answer
        .best_change = best_change(problem, [&](std::string_view key, double value) -> std::optional<double> {
      try {
        return margin_of(criterion_of(remake ? remake(key, value) : with_value(problem, key, value))).lower;
      } catch (const data::InputError&) {  // no beam, or one without a stick state
        return std::nullopt;
      }
    });
  return answer;
}

std::vector<CriticalAmplitudePoint> critical_amplitude_curve(const data::Case& problem,
                                                             const std::vector<double>& frequencies_hz,
                                                             double relative_width) {
  std::vector<CriticalAmplitudePoint> points(frequencies_hz.size());
  in_parallel(points.size(), [&](std::size_t i) {
    const double hz = frequencies_hz[i];
    const data::Case at_hz = data::with_value(problem, "excitation.frequency_hz", hz);
    points[i] = {hz, criterion_of(at_hz, relative_width).critical_amplitude.midpoint()};
  });
  return points;
}

CriticalAmplitudeCurve critical_amplitude_curve(const data::Case& problem) {
  constexpr int steps = 240;
  constexpr double reach = 4.0, beyond = 1.25, width = 1e-3;
  const double here = problem.excitation().frequency_hz(), first = here / reach;
  CriticalAmplitudeCurve curve;
  for (const auto& share : analytic::modal_forces(problem.beam(), problem.numerics.modes()))
    curve.natural_hz.push_back(share.angular_frequency / (2.0 * std::numbers::pi));
  const double last = std::max(reach * here, beyond * curve.natural_hz.front());
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
