// SPDX-License-Identifier: MIT
#include "support/regularisation.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/solver/contact_system.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/convergence/convergence.hpp"

namespace stickslip::testing {

namespace {

using Steps = std::vector<analytic::ContactStep>;

Steps run(const data::Case& problem, const data::ContactProperties& contact, double step) {
  const auto count = static_cast<std::size_t>(std::lround(problem.numerics.duration() / step));
  return analytic::BeamBoundaryIntegral(problem.beam, problem.friction, problem.excitation, problem.damping,
                                        {step, count}, 3, data::TangentialContact(contact))
      .steps();
}

// The first slip as ContactSummary defines it, between steps: by the line through the excess of the two steps before it,
// of the force over its bound or, with a transition velocity above 0, of |v_s| over that. Steps are known in their middle.
double first_slip(const data::Case& problem, const Steps& steps, double step, double transition_velocity) {
  const auto excess = [&](const analytic::ContactStep& at) {
    if (transition_velocity > 0.0) return std::abs(at.sliding_velocity) - transition_velocity;
    const double forward = std::max(-std::copysign(1.0, at.friction_force) * at.sliding_velocity, 0.0);
    return std::abs(at.friction_force) -
           problem.beam.axial_force() * solver::friction_coefficient(problem.friction.in_slip(), forward);
  };
  const auto found = std::ranges::find_if(steps, [&](const analytic::ContactStep& now) {
    return now.slides && std::abs(now.sliding_velocity) >= transition_velocity;
  });
  if (found == steps.end()) return -1.0;
  const auto n = found - steps.begin();
  if (n < 2) return static_cast<double>(n) * step;
  const double last = excess(*(found - 1)), before = excess(*(found - 2));
  return (static_cast<double>(n) - 0.5 - last / (last - before)) * step;
}

std::vector<double> positions(const Steps& steps, double step) {
  std::vector<double> position{0.0};
  for (const auto& now : steps) position.push_back(position.back() + step * now.sliding_velocity);
  return position;
}

// Of the slider z = x + f_d/k_t from the middle of one step to that of the next.
double travel(const Steps& steps, std::size_t from, double step, double stiffness) {
  double sum = 0.0;
  for (std::size_t n = from + 1; n < steps.size(); ++n)
    sum += std::abs(0.5 * step * (steps[n].sliding_velocity + steps[n - 1].sliding_velocity) +
                    (steps[n].friction_force - steps[n - 1].friction_force) / stiffness);
  return sum;
}

}  // namespace

ContactSummary contact_summary(const data::Case& problem, double step) {
  const Steps steps = run(problem, problem.contact.properties(), step);
  const std::size_t half = steps.size() / 2;
  const double periods = static_cast<double>(steps.size() - half) * step * problem.excitation.frequency_hz();
  ContactSummary summary;
  summary.first_slip = first_slip(problem, steps, step, 1.5 * problem.contact.regularisation_velocity());
  summary.travel = travel(steps, half, step, problem.contact.tangential_stiffness()) / periods;
  for (std::size_t n = half; n < steps.size(); ++n)
    summary.work -= step * steps[n].friction_force * steps[n].sliding_velocity / periods;
  const auto stored = [&](const analytic::ContactStep& at) {
    return 0.5 * at.friction_force * at.friction_force / problem.contact.tangential_stiffness();
  };
  summary.work -= (stored(steps.back()) - stored(steps[half])) / periods;
  for (const auto& now : steps)
    summary.largest_force = std::max(summary.largest_force, std::abs(now.friction_force));
  return summary;
}

std::vector<CodeSetting> code_settings(const data::Case& problem) {
  constexpr double face = 0.1;  // m
  const double limit = studies::friction_limit(problem);
  const auto elastic_slip = [&](double slip) {
    return data::ContactProperties{.tangential_stiffness = limit / slip};
  };
  const auto transition = [](double velocity) {
    data::ContactProperties contact;
    contact.regularisation_velocity = velocity / 1.5;
    return contact;
  };
  return {{"set-valued law", {}},
          {"elastic slip 0.005 of a face", elastic_slip(0.005 * face)},
          {"elastic slip 0.0001 of a face", elastic_slip(0.0001 * face)},
          {"transition at 0.1 mm/s", transition(1e-4)},
          {"transition at 1 mm/s", transition(1e-3)},
          {"transition at 100 mm/s", transition(0.1)}};
}

std::vector<RegularisationRate> regularisation_rates(const data::Case& problem,
                                                     const std::vector<data::ContactProperties>& refined,
                                                     double step) {
  const bool smooth = refined.front().regularisation_velocity > 0.0;
  const double sliding = smooth ? 0.01 : 0.0;
  const Steps rigid = run(problem, {}, step);
  const std::vector<double> rigid_position = positions(rigid, step);
  std::vector<double> parameter, first_slips, distances, travels, forces;
  for (const data::ContactProperties& contact : refined) {
    const Steps steps = run(problem, contact, step);
    double force = 0.0;
    for (std::size_t n = 0; n < steps.size(); ++n)
      force +=
          std::abs(steps[n].friction_force - rigid[n].friction_force) / static_cast<double>(steps.size());
    parameter.push_back(smooth ? contact.regularisation_velocity : 1.0 / contact.tangential_stiffness);
    first_slips.push_back(
        std::abs(first_slip(problem, steps, step, sliding) - first_slip(problem, rigid, step, sliding)));
    distances.push_back(studies::largest_difference(positions(steps, step), rigid_position));
    travels.push_back(std::abs(travel(steps, 0, step, contact.tangential_stiffness) -
                               travel(rigid, 0, step, problem.contact.tangential_stiffness())));
    forces.push_back(force);
  }
  return {{"first slip", studies::observed_order(parameter, first_slips)},
          {"position", studies::observed_order(parameter, distances)},
          {"travel", studies::observed_order(parameter, travels)},
          {"friction force", studies::observed_order(parameter, forces)}};
}

}  // namespace stickslip::testing
