// SPDX-License-Identifier: MIT
#include "studies/analyses/method_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/input_error.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

constexpr double most_slowness = 10.0;
constexpr double seconds_per_step = 7e-6;  // of the boundary integral, with the run with twice the step

void require(const Method& method, const data::Case& problem, const MotionRequest& request) {
  for (const data::Feature feature : request.features) method.require(feature, "--method", method.name);
  method.require(problem, request.run);
  require_held_growth(problem, method);
}

// The sentence by which the method refuses, if it does.
std::optional<std::string> refusal_of(const Method& method, const data::Case& problem,
                                      const MotionRequest& request) {
  try {
    require(method, problem, request);
    return std::nullopt;
  } catch (const data::FieldError& error) {
    return error.what();
  }
}

// Why the boundary integral is not taken, if it is not.
std::optional<std::string> objection_to_boundary_integral(const data::Case& problem,
                                                          const MotionRequest& request) {
  if (request.of_many_places) return "takes half of its time again for each place";
  if (const auto refusal = refusal_of(boundary_integral(), problem, request)) return "refuses: " + *refusal;
  const double steps = problem.numerics.duration() / boundary_integral_step(problem);
  if (steps <= most_steps_of_boundary_integral) return std::nullopt;
  return fmt::format("would take about {:.0f} s", seconds_per_step * steps);
}

// Whether the contact is known to hold.
bool sticks(const data::Case& problem, const MotionRequest& request) {
  if (request.run.starts_with_the_base) return false;
  try {
    require_resting_wall(problem);
    require_start_at_rest(problem);
    const double load = analytic::load(problem);
    return !(load > 0.0) || !analytic::StickReaction(problem).exceeds(friction_limit(problem) / load);
  } catch (const data::FieldError&) {
    return false;
  }
}

MethodChoice chosen_for(const data::Case& problem, const MotionRequest& request) {
  const auto by_elements = [](std::string reason) {
    return MethodChoice{&finite_elements(), std::move(reason)};
  };
  if (!request.of_elements.empty()) return by_elements(request.of_elements + " is given, which it alone has");
  if (const auto refusal = refusal_of(event_driven(), problem, request))
    return by_elements("event-driven refuses: " + *refusal);
  const double slowness = slowness_of_events(problem);
  if (slowness <= most_slowness && problem.is_damped())
    return {&event_driven(), "accurate and fast with damping; --method fe is a second opinion"};
  if (sticks(problem, request)) return {&event_driven(), "exact in its modes, because the contact holds"};
  if (slowness > most_slowness)
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

double slowness_of_events(const data::Case& problem) {
  const double damping = problem.damping.kelvin_voigt();
  if (damping == 0.0) return 0.0;
  const auto modes = analytic::held_modes(problem, problem.numerics.modes());
  if (modes.empty()) return 0.0;
  const double omega = modes.back().angular_frequency;
  return 0.1 * damping * omega * omega * problem.numerics.time_step() * static_cast<double>(modes.size());
}

MethodChoice method_for(const data::Case& problem, const MotionRequest& request) {
  const MethodChoice choice =
      request.method ? MethodChoice{&method(*request.method), ""} : chosen_for(problem, request);
  if (request.method || choice.method == &finite_elements()) require(*choice.method, problem, request);
  return choice;
}

}  // namespace stickslip::studies
