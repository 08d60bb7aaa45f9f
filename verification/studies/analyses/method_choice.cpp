// SPDX-License-Identifier: MIT
#include "studies/analyses/method_choice.hpp"

#include <fmt/format.h>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/input_error.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

void require(const Method& method, const data::Case& problem, const MotionRequest& request) {
  for (const data::Feature feature : request.features) method.require(feature, "--method", method.name);
  method.require(problem, request.run);
  require_held_growth(problem, method);
}

// The sentence by which the method refuses, if it does.
std::optional<std::string> refusal_of(const Method& method, const data::Case& problem,
                                      const MotionRequest& request) try {
  require(method, problem, request);
  return std::nullopt;
} catch (const data::FieldError& error) {
  return "refuses: " + std::string(error.what());
}

// Why the boundary integral is not taken, if it is not. A step takes it 7 µs, with the run with twice the step.
std::optional<std::string> objection_to_boundary_integral(const data::Case& problem,
                                                          const MotionRequest& request) {
  constexpr double seconds_per_step = 7e-6, most_seconds = 10.0;
  if (request.of_many_places) return "takes half of its time again for each place";
  if (const auto refusal = refusal_of(boundary_integral(), problem, request)) return refusal;
  const double seconds = seconds_per_step * problem.numerics.duration() / boundary_integral_step(problem);
  if (seconds <= most_seconds) return std::nullopt;
  return fmt::format("would take about {:.0f} s", seconds);
}

// How many times longer event-driven takes than finite elements while the contact slips, where Kelvin-Voigt damping η makes slip stiff:
// 0.1 η ω_N² h N with N modes and time steps h. Measured, within a factor of two for `damped` with 20 to 40 modes.
double slowness_of_events(const data::Case& problem) {
  if (problem.damping.kelvin_voigt() == 0.0) return 0.0;
  const auto modes = analytic::held_modes(problem, problem.numerics.modes());
  const double omega = modes.empty() ? 0.0 : modes.back().angular_frequency;
  return 0.1 * problem.damping.kelvin_voigt() * omega * omega * problem.numerics.time_step() *
         static_cast<double>(modes.size());
}

// Whether the contact is known to hold.
bool sticks(const data::Case& problem, const MotionRequest& request) try {
  require_resting_wall(problem);
  require_start_at_rest(problem);
  return !request.run.starts_with_the_base &&
         !analytic::StickReaction(problem).exceeds(friction_limit(problem) / analytic::load(problem));
} catch (const data::FieldError&) {
  return false;
}

MethodChoice chosen_for(const data::Case& problem, const MotionRequest& request) {
  constexpr double most_slowness = 10.0;
  const auto by_elements = [](const std::string& reason) { return MethodChoice{&finite_elements(), reason}; };
  if (!request.of_elements.empty()) return by_elements(request.of_elements + " is given, which it alone has");
  if (const auto refusal = refusal_of(event_driven(), problem, request))
    return by_elements("event-driven " + *refusal);
  const double slowness = slowness_of_events(problem);
  if (problem.is_damped() && slowness <= most_slowness)
    return {&event_driven(), "accurate and fast with damping; --method fe is a second opinion"};
  if (sticks(problem, request)) return {&event_driven(), "exact in its modes, because the contact holds"};
  if (problem.is_damped())
    return by_elements(fmt::format(
        "event-driven would take about {:.0f} times as long with {} modes and this Kelvin-Voigt damping",
        slowness, problem.numerics.modes()));
  if (problem.model() != nullptr)
    return {&event_driven(), "exact in its modes; --method fe has all of the structure"};
  if (const auto objection = objection_to_boundary_integral(problem, request))
    return by_elements(
        "averages converge, single changes of contact without damping do not; boundary-integral " +
        *objection);
  return {&boundary_integral(), "has all modes and converges, though slip without damping is sensitive"};
}

}  // namespace

MethodChoice method_for(const data::Case& problem, const MotionRequest& request) {
  const MethodChoice choice =
      request.method ? MethodChoice{&method(*request.method), ""} : chosen_for(problem, request);
  if (request.method || choice.method == &finite_elements()) require(*choice.method, problem, request);
  return choice;
}

}  // namespace stickslip::studies
