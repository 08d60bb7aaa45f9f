// SPDX-License-Identifier: MIT
/// Orders in time: one table of motions, each with its errors, its order and, where theory has it, the constant of the leading error.

#include "studies/verification/time_order.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/history/history.hpp"
#include "studies/verification/energy_audit.hpp"
#include "support/contact_models.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

/// Errors of one quantity of a motion in steps of decreasing length.
struct ErrorSequence {
  std::vector<OrderLevel> levels;
  std::optional<double> constant;  ///< of the leading error, constant h^2
};

struct Motion {
  std::string name, requirement;
  std::vector<ErrorSequence> (*errors)(double spectral_radius);
};

void PrintTo(const Motion& motion, std::ostream* stream) { *stream << motion.name; }

/// Two damped masses under a harmonic load in their steady vibration: displacement and velocity with the contact free, its reaction
/// with the contact held. The constants follow from the equations that the method solves up to h^4.
std::vector<ErrorSequence> of_a_steady_vibration(double radius) {
  const auto study = studies::time_order_study(radius, {50, 100, 200, 400, 800});
  const auto sequence = [&](const std::vector<double>& errors, const std::vector<double>& predicted,
                            double constant) {
    std::vector<OrderLevel> levels;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double h = study.time_step[i];
      // Samples in steps of omega h = 3 h miss (omega h)^2/8 of the largest error, here and there with half as
      // much again for what is behind; exp(-16) of it has not decayed.
      const double missed = 1.5 * std::pow(3.0 * h, 2) / 8.0 + 2e-7;
      EXPECT_TRUE(
          within(errors[i], predicted[i],
                 discretisation(predicted[i] * missed, 1.0, "between two samples the error is larger")));
      // The next term is (omega h)^2 times a few. Unit amplitudes; a step solves for accelerations, of which a displacement is the double sum.
      levels.push_back({.step = h,
                        .error = errors[i],
                        .next_term = 4.0 * std::pow(3.0 * h, 2) + missed,
                        .floor = round_off(1, 1.0 / std::pow(3.0 * h, 2), 1.0).value});
    }
    return ErrorSequence{levels, constant};
  };
  return {sequence(study.displacement_error, study.predicted_displacement_error, study.displacement_constant),
          sequence(study.velocity_error, study.predicted_velocity_error, study.velocity_constant),
          sequence(study.reaction_error, study.predicted_reaction_error, study.reaction_constant)};
}

/// m v_t = g(v) = -N [mu_m + (mu_s - mu_m) exp(-a v)]/m from v0 stops at t = m/(N a mu_m) ln[(mu_m exp(a v0) + mu_s - mu_m)/mu_s].
///
/// With d = alpha_f - alpha_m, and the force taken at the mean velocity of weights 1 - alpha_f and alpha_f, the method solves
///
///     v_t = g + h^2 [k (g'' g^2 + g'^2 g) - alpha_f (1 - alpha_f)/2 g'' g^2],   k = 1/12 + d^2/2,
///
/// and its acceleration, which lags by d h, begins without that lag: d h g'g too much, which decays within steps and leaves
/// d (1/2 - alpha_f) h^2 g'g of velocity. Both, divided by g, are times. The stop splits a step in h' and the rest, and the lag of
/// the step before is d (h - h') too long: up to d h^2/4 |1 - gamma - gamma alpha_m/(1 - alpha_m)| g'.
std::vector<ErrorSequence> of_a_stop(double radius) {
  const data::FrictionCoefficients law{.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.5};
  const double v0 = 2.0, normal_force = 10.0;
  const double exact = std::log((0.3 * std::exp(1.5 * v0) + 0.3) / 0.6) / (normal_force * 1.5 * 0.3);
  const auto g = [](double v, int derivative = 0) {
    return -10.0 * ((derivative == 0 ? 0.3 : 0.0) + 0.3 * std::pow(-1.5, derivative) * std::exp(-1.5 * v));
  };
  const double af = radius / (radius + 1.0), am = (2.0 * radius - 1.0) / (radius + 1.0), d = af - am,
               gamma = 0.5 + d, k = 1.0 / 12.0 + 0.5 * d * d;
  double integral = 0.0;  // of the term of h^2 over g^2, by the rule of the middle
  for (int i = 0; i < 2000; ++i) {
    const double v = v0 * (i + 0.5) / 2000.0;
    integral += v0 / 2000.0 * ((k - 0.5 * af * (1.0 - af)) * g(v, 2) + k * g(v, 1) * g(v, 1) / g(v));
  }
  const double constant = std::abs(integral - d * (0.5 - af) * g(v0, 1));
  const double split = 0.25 * std::abs(d * (1.0 - gamma - gamma * am / (1.0 - am)) * g(0.0, 1)) / constant;
  ErrorSequence sequence{{}, constant};
  for (const double h : {0.01, 0.005, 0.0025, 0.00125}) {
    solver::StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = law}),
                                       {.time_step = h, .spectral_radius = radius});
    slider.start_slipping(scalar(0.0), scalar(v0));
    while (slider.events().empty() && slider.time() < 2.0 * exact) slider.step();
    EXPECT_FALSE(slider.events().empty()) << "still sliding at " << slider.time() << " s";
    // g changes at the rate g' = 4.5/s, and g'g, which the lag is made of, at g' + g''g/g' = 13.5/s at rest. The stop is found to round-off.
    sequence.levels.push_back({.step = h,
                               .error = std::abs(slider.events().front().time - exact),
                               .next_term = (4.5 + 13.5 * d) * h + split,
                               .floor = round_off(100, 1, exact).value});
  }
  return {sequence};
}

/// Two coupled, damped masses under a load on a moving wall, with an unsymmetric slip state: 23 changes of all kinds in 12 s, against
/// the exact solution. Events in time and position, displacement and velocity at the end, and what the energy balance leaves.
std::vector<ErrorSequence> of_a_pair(double radius) {
  const ForcedPair pair;
  ExactPair exact(pair);
  exact.run(12.0);
  for (const auto kind :
       {data::ContactChange::onset, data::ContactChange::capture, data::ContactChange::reversal})
    EXPECT_GE(std::ranges::count(exact.events(), kind, &data::ContactEvent::change), 2);
  std::vector<ErrorSequence> sequences(5);
  for (const int steps : {1000, 2000, 4000, 8000}) {
    const double h = 12.0 / steps;
    solver::StickSlipIntegrator run(contact_system(pair), {.time_step = h, .spectral_radius = radius});
    run.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
    solver::EnergyRecorder recorder(run);
    run.observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
    while (run.steps() < steps) run.step();
    EXPECT_TRUE(std::ranges::equal(run.events(), exact.events(), {}, &data::ContactEvent::change,
                                   &data::ContactEvent::change));
    const auto apart = studies::largest_difference(run.events(), exact.events(), exact.events().size());
    const double errors[] = {apart.time, apart.position, (run.displacement() - exact.displacement()).norm(),
                             (run.velocity() - exact.velocity()).norm(),
                             std::abs(recorder.balance().residual())};
    // The ends of the exact phases are known to 1e-12 s and less. Where the changes split their steps scatters the energy.
    for (std::size_t i = 0; i < sequences.size(); ++i)
      sequences[i].levels.push_back({h, errors[i], next_term_of_the_pair(h), 1e-11, i == 4 ? 0.2 : 0.0});
  }
  return sequences;
}

class TimeOrder : public ::testing::TestWithParam<Motion> {};

TEST_P(TimeOrder, IsTwoWithTheConstantOfTheory) {
  record_requirement(GetParam().requirement);
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    for (const auto& [levels, constant] : GetParam().errors(radius))
      EXPECT_TRUE(order_is(levels, 2.0, constant)) << "spectral radius " << radius;
}

INSTANTIATE_TEST_SUITE_P(Of, TimeOrder,
                         ::testing::Values(Motion{"SteadyVibration", "F5", of_a_steady_vibration},
                                           Motion{"Stop", "F6", of_a_stop},
                                           Motion{"PairWithItsEnergy", "F8", of_a_pair}),
                         [](const auto& instance) { return instance.param.name; });

STICKSLIP_VERIFIES(NumericalOscillation, "F5");
// With d = alpha_f - alpha_m the frequency falls by the share (omega h)^2 (1/12 + 3 d^2/8), and the decay rate is
// omega (omega h)^3 d^3/2. The next terms are (omega h)^2 times numbers up to 2.
TEST(NumericalOscillation, HasTheLeadingErrors) {
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

STICKSLIP_VERIFIES(EnergyAudit, "F8");
TEST(EnergyAudit, BalancesMeshesAndEvents) {
  const data::Case damped = damped_problem(25.0);
  const std::vector<double> steps{5e-6, 2.5e-6, 1.25e-6};
  const auto audit = studies::energy_audit(damped, 0.12, {6, 10}, 14, steps);
  ASSERT_EQ(audit.meshes.size(), 2u);

  // 1e-12 a step of the state, in each of a few thousand, of the turnover of the balance.
  const analytic::EventDrivenEnergy& exact = audit.event_driven;
  EXPECT_TRUE(within(audit.event_driven_residual(), 0.0,
                     discretisation(1e-12 * 1e4 * exact.base_work, 1.0, "tolerance of the integrator")));
  for (const auto& mesh : audit.meshes) {
    // The next term is omega h = 0.15 of the first for the highest mode of 10 elements, which is damped away
    // within steps of a change: as for EnergyResidual.
    EXPECT_TRUE(within(mesh.observed_order.order, 2.0, discretisation(0.1, 1.0, "next term omega h")))
        << mesh.elements;
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
