// SPDX-License-Identifier: MIT
/// Observed orders in time.

#include "studies/verification/time_order.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/verification/energy_audit.hpp"
#include "support/contact_models.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

// The errors of one quantity of the study against what the method's equations at one frequency predict.
void expect_second_order(const std::vector<double>& steps, const std::vector<double>& errors,
                         const std::vector<double>& predicted, double constant) {
  std::vector<OrderLevel> levels;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    // Samples in steps of omega h = 3 h miss (omega h)^2/8 of the largest error, here and there with half as
    // much again for what is behind; exp(-16) of it has not decayed.
    const double missed = 1.5 * std::pow(3.0 * steps[i], 2) / 8.0 + 2e-7;
    EXPECT_TRUE(
        within(errors[i], predicted[i],
               discretisation(predicted[i] * missed, 1.0, "between two samples the error is larger")));
    const double leading = constant * steps[i] * steps[i];
    // Unit amplitudes; a step solves for accelerations, of which a displacement is the double sum.
    levels.push_back({.step = steps[i],
                      .error = errors[i],
                      .next_term = 1.5 * std::abs(predicted[i] / leading - 1.0) + missed,
                      .floor = round_off(1, 1.0 / std::pow(3.0 * steps[i], 2), 1.0).value});
  }
  EXPECT_TRUE(order_is(levels, 2.0, constant));
}

STICKSLIP_VERIFIES(GeneralizedAlphaOrder, "F5");
TEST(GeneralizedAlphaOrder, IsSecondOrderUnderTimeDependentLoad) {
  for (const double spectral_radius : {0.0, 0.5, 0.9, 1.0}) {
    SCOPED_TRACE(spectral_radius);
    const studies::TimeOrderStudy study =
        studies::time_order_study(spectral_radius, {50, 100, 200, 400, 800});
    expect_second_order(study.time_step, study.displacement_error, study.predicted_displacement_error,
                        study.displacement_constant);
    expect_second_order(study.time_step, study.velocity_error, study.predicted_velocity_error,
                        study.velocity_constant);
    expect_second_order(study.time_step, study.reaction_error, study.predicted_reaction_error,
                        study.reaction_constant);
    // What the report prints is the slope of just these levels.
    EXPECT_EQ(study.displacement_order.order, observed_order(study.time_step, study.displacement_error));
    EXPECT_EQ(study.velocity_order.order, observed_order(study.time_step, study.velocity_error));
    EXPECT_EQ(study.reaction_order.order, observed_order(study.time_step, study.reaction_error));
  }
}

STICKSLIP_VERIFIES(ContactLocation, "F6");
// m v_t = -N [mu_m + (mu_s - mu_m) exp(-alpha v)] from v0 stops at
// t = m/(N alpha mu_m) ln[(mu_m exp(alpha v0) + mu_s - mu_m)/mu_s].
TEST(ContactLocation, StopUnderExponentialFrictionIsOfSecondOrder) {
  const data::FrictionCoefficients law{.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.5};
  const double normal_force = 10.0, v0 = 2.0;
  const double exact = std::log((0.3 * std::exp(1.5 * v0) + 0.3) / 0.6) / (normal_force * 1.5 * 0.3);
  for (const double radius : {0.5, 1.0}) {
    std::vector<double> steps, errors;
    for (const double h : {0.04, 0.02, 0.01, 0.005, 0.0025}) {
      solver::StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = law}),
                                         {.time_step = h, .spectral_radius = radius});
      slider.start_slipping(scalar(0.0), scalar(v0));
      while (slider.events().empty() && slider.time() < 2.0 * exact) slider.step();
      ASSERT_FALSE(slider.events().empty()) << "still sliding at " << slider.time() << " s";
      steps.push_back(h);
      errors.push_back(std::abs(slider.events().front().time - exact));
    }
    // The next term: the friction force changes at the rate N alpha (mu_s - mu_m)/m = 4.5/s, and the stop
    // splits its step anywhere. The event is found to round-off.
    EXPECT_TRUE(order_is(order_levels(
                             steps, errors, [](double h) { return 4.5 * h; }, round_off(100, 1, exact).value),
                         2.0))
        << radius;
    EXPECT_LT(errors.back(), 1e-5);
  }
}

STICKSLIP_VERIFIES(NumericalOscillation, "F5");
// With d = alpha_f - alpha_m the frequency falls by the share (omega h)^2 (1/12 + 3 d^2/8), and the decay rate is
// omega (omega h)^3 d^3/2. The next terms are (omega h)^2 times numbers up to 2.
TEST(NumericalOscillation, OfAShortStepHasTheLeadingErrorsOfTheory) {
  constexpr double omega = 3.0, angle = 1e-3;
  for (const double radius : {0.0, 0.5, 0.9, 1.0}) {
    const double d = (1.0 - radius) / (1.0 + radius);
    const auto exponent = studies::generalized_alpha_exponent(radius, omega, angle / omega);
    const double rounding = round_off(10, 1.0 / (angle * angle), 1.0).value;
    EXPECT_TRUE(within((1.0 - exponent.imag() / omega) / (angle * angle), 1.0 / 12.0 + 3.0 * d * d / 8.0,
                       discretisation(angle * angle + rounding, 3.0, "next term, and rounding")))
        << radius;
    EXPECT_TRUE(within(-exponent.real() / omega / std::pow(angle, 3), std::pow(d, 3) / 2.0,
                       discretisation(angle * angle + rounding, 3.0, "next term, and rounding")))
        << radius;
    for (const double tiny : {1e-160, 1e-12, 1e-8, 1e-6})
      EXPECT_TRUE(within(
          studies::generalized_alpha_exponent(radius, omega, tiny / omega).imag(), omega,
          discretisation(omega * tiny * tiny + round_off(4, 1, omega).value, 1.0, "error, and rounding")))
          << radius << ' ' << tiny;
  }
}

struct HistoryErrors {
  double time{}, position{}, displacement{}, velocity{};
};

// Largest errors over all events, and those of the state at the end; every event must be there, in its order.
HistoryErrors history_errors(const ForcedPair& pair, const ExactPair& exact, double duration, int steps,
                             double spectral_radius) {
  solver::StickSlipIntegrator integrator(contact_system(pair),
                                         {.time_step = duration / steps, .spectral_radius = spectral_radius});
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  while (integrator.steps() < steps) integrator.step();
  const auto& events = integrator.events();
  HistoryErrors errors;
  EXPECT_EQ(events.size(), exact.events().size());
  for (std::size_t i = 0; i < std::min(events.size(), exact.events().size()); ++i) {
    const data::ContactEvent& expected = exact.events()[i];
    EXPECT_EQ(events[i].change, expected.change) << "event " << i << " at " << expected.time << " s";
    errors.time = largest_or_nan({errors.time, std::abs(events[i].time - expected.time)});
    errors.position = largest_or_nan({errors.position, std::abs(events[i].position - expected.position)});
  }
  errors.displacement = (integrator.displacement() - exact.displacement()).norm();
  errors.velocity = (integrator.velocity() - exact.velocity()).norm();
  return errors;
}

STICKSLIP_VERIFIES(ContactHistoryOrder, "F6");
TEST(ContactHistoryOrder, IsTwoThroughOnsetsCapturesAndReversals) {
  for (const double spectral_radius : {0.0, 0.5, 0.9, 1.0}) {
    SCOPED_TRACE(spectral_radius);
    // Two coupled, damped masses under a load on a moving wall, with an unsymmetric slip state: 23 events in 12
    // s. The errors are differences to the exact solution, so that an order of 2 leaves no limit but zero.
    const ForcedPair pair;
    const double duration = 12.0;
    ExactPair exact(pair);
    exact.run(duration);
    for (const auto kind :
         {data::ContactChange::onset, data::ContactChange::capture, data::ContactChange::reversal})
      ASSERT_GE(std::count_if(exact.events().begin(), exact.events().end(),
                              [kind](const auto& event) { return event.change == kind; }),
                2);
    std::vector<double> lengths, times, positions, displacements, velocities;
    for (const int steps : {1000, 2000, 4000, 8000}) {
      const HistoryErrors errors = history_errors(pair, exact, duration, steps, spectral_radius);
      lengths.push_back(duration / steps);
      times.push_back(errors.time);
      positions.push_back(errors.position);
      displacements.push_back(errors.displacement);
      velocities.push_back(errors.velocity);
    }
    // The ends of the exact phases are known to 1e-12 s and less.
    for (const std::vector<double>& errors : {times, positions, displacements, velocities})
      EXPECT_TRUE(order_is(order_levels(lengths, errors, next_term_of_the_pair, 1e-11), 2.0));
  }
}

STICKSLIP_VERIFIES(EnergyAudit, "F8");
TEST(EnergyAudit, KeepsOneEventDrivenRunBesideEveryMesh) {
  const data::Case damped = damped_problem(25.0);
  const std::vector<double> steps{5e-6, 2.5e-6, 1.25e-6};
  const auto audit = studies::energy_audit(damped, 0.12, {6, 10}, 14, steps);
  EXPECT_EQ(audit.time_step, steps);
  EXPECT_EQ(audit.kelvin_voigt, 6.4e-5);
  EXPECT_EQ(audit.modes, 14);
  ASSERT_EQ(audit.meshes.size(), 2u);

  // Each mesh has the balance that it has alone, and the event-driven run does not know of the meshes.
  const auto alone = studies::energy_audit(damped, 0.12, {10}, 14, steps);
  EXPECT_EQ(alone.meshes.front().elements, audit.meshes.back().elements);
  EXPECT_EQ(alone.event_driven.base_work, audit.event_driven.base_work);
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_EQ(alone.meshes.front().stepped[i].residual(), audit.meshes.back().stepped[i].residual());

  // 1e-12 a step of the state, in each of a few thousand, of the turnover of the balance.
  const analytic::EventDrivenEnergy& exact = audit.event_driven;
  EXPECT_TRUE(within(audit.event_driven_residual(), 0.0,
                     discretisation(1e-12 * 1e4 * exact.base_work, 1.0, "tolerance of the integrator")));
  for (const auto& mesh : audit.meshes) {
    // The next term is omega h = 0.15 of the first for the highest mode of 10 elements, which is damped away
    // within steps of a change: as for EnergyResidual.
    EXPECT_TRUE(within(mesh.observed_order.order, 2.0, discretisation(0.1, 1.0, "next term omega h")))
        << mesh.elements;
    EXPECT_EQ(mesh.observed_order.levels, 3);
    ASSERT_EQ(mesh.stepped.size(), steps.size());
    // What a mesh costs: (beta l)^4/720 of the stiffness of the waves that matter, beta l = 10.2/6 of mode 3.
    const double cost = std::pow(10.2 / mesh.elements, 4) / 720.0;
    EXPECT_TRUE(within(mesh.stepped.back().friction_loss, exact.friction_loss,
                       discretisation(cost * exact.friction_loss, 2.0, "mode 3 on the mesh")));
    EXPECT_TRUE(within(mesh.stepped.back().base_work, exact.base_work,
                       discretisation(cost * exact.base_work, 2.0, "mode 3 on the mesh")));
  }
}

}  // namespace
}  // namespace stickslip::testing
