// SPDX-License-Identifier: MIT
/// A friction law with a Stribeck minimum in both implementations: against closed forms, and one against the
/// other.

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr data::FrictionCoefficients stribeck{
    .static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 2.0, .viscous = 0.1};
constexpr double normal_force = 10.0;

// Errors of second order in a step that is halved each time.
void expect_a_quarter_at_each_halving(const std::vector<double>& errors) {
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_LT(errors[i], errors[i - 1] / 3.0);
    EXPECT_GT(errors[i], errors[i - 1] / 5.0);
  }
}

// -f_d of a sliding mass at speed v: the solver's law, and what the contact of the boundary integral returns.
double resistance_of_the_solver(double v) {
  return normal_force * solver::friction_coefficient(data::FrictionLaw(stribeck), v);
}

double resistance_of_the_boundary_integral(double v, double weight) {
  const analytic::ContactLaw law{normal_force, data::FrictionLaw(stribeck)};
  return -solve_contact(law, v + weight * resistance_of_the_solver(v), weight).friction_force;
}

STICKSLIP_VERIFIES(StribeckLaw, "P2");
TEST(StribeckLaw, HasItsMinimumWhereTheSlopesOfItsTermsCancel) {
  const double at = std::log(0.3 * 2.0 / 0.1) / 2.0;  // ln((mu_s - mu_m) alpha/beta)/alpha
  const double lowest = normal_force * (0.3 + 0.1 / 2.0 + 0.1 * at);
  EXPECT_TRUE(within(resistance_of_the_solver(at), lowest, round_off(10, 1, lowest)));
  // A step d beside it the law is higher by alpha beta d^2/2, since mu'' = alpha beta there; next term alpha d/3.
  for (const double step : {-1e-3, 1e-3}) {
    const double rise = 0.5 * normal_force * 2.0 * 0.1 * step * step;
    EXPECT_TRUE(within(resistance_of_the_solver(at + step) - lowest, rise,
                       discretisation(rise * 2.0 * 1e-3 / 3.0, 2.0, "the third derivative")));
  }
  EXPECT_EQ(resistance_of_the_solver(0.0), 6.0);
  EXPECT_GT(resistance_of_the_solver(5.0), 6.0);  // it may exceed mu_s
}

TEST(StribeckLaw, HoldsInEveryStepOfTheBoundaryIntegral) {
  // kappa W_0 = 6 W_0 < 1.
  for (const double weight : {1e-3, 0.05, 0.16})
    for (const double v : {0.01, 0.3, 0.9, 2.0, 50.0})
      EXPECT_TRUE(within(resistance_of_the_boundary_integral(v, weight), resistance_of_the_solver(v),
                         round_off(20, 1.0 / (1.0 - 6.0 * weight) * (v / weight + 6.0), 1.0)))
          << v << ", " << weight;
}

TEST(StribeckLaw, HoldsInEveryStepOfTheSolver) {
  // At spectral radius 0 the balance holds at the end of the step: m (2 a_1 - a_0) = -mu(v_1) N with
  // v_1 = v_0 + h (3 a_1 - a_0)/2. The stronger viscosity outweighs the mass in a step.
  const double h = 0.05;
  for (const double viscous : {0.1, 4.0})
    for (const double v0 : {1.0, 2.0, 20.0}) {
      data::FrictionCoefficients friction = stribeck;
      friction.viscous = viscous;
      const data::FrictionLaw law(friction);
      const auto resistance = [&](double v) { return normal_force * solver::friction_coefficient(law, v); };
      solver::StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = friction}),
                                         {.time_step = h, .spectral_radius = 0.0});
      slider.start_slipping(scalar(0.0), scalar(v0));
      const double a0 = -resistance(v0);
      slider.step();
      ASSERT_TRUE(slider.events().empty());
      const double v1 = slider.velocity()[0], a1 = ((v1 - v0) / (0.5 * h) + a0) / 3.0;
      EXPECT_TRUE(within(2.0 * a1 - a0, -resistance(v1), round_off(40, 1, v0 / h - a0)))
          << viscous << ", " << v0;
    }
}

TEST(StribeckLaw, StopsASliderAtTheTimeOfTheClosedForm) {
  // m v_t = -N (mu_m + beta v): from v_0 to rest in m/(N beta) ln(1 + beta v_0/mu_m), all energy to friction.
  const data::FrictionCoefficients viscous{
      .static_coefficient = 0.3, .kinetic_coefficient = 0.3, .viscous = 0.2};
  const double v0 = 1.5, stop = std::log(1.0 + 0.2 * v0 / 0.3) / (normal_force * 0.2);
  analytic::EventDriven exact(contact_model(SingleMass{.normal_force = normal_force, .friction = viscous}),
                              {.keep_energy_balance = true});
  exact.start_slipping({}, {}, 0.0, v0);
  exact.advance_to(1.0);
  ASSERT_EQ(exact.events().size(), 1u);
  EXPECT_TRUE(within(exact.events()[0].time, stop, discretisation(1e-11, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(exact.energy_balance().friction_loss, 0.5 * v0 * v0,
                     discretisation(1e-11, 1.0, "1e-12 a step")));

  // Both the time and the unexplained energy of the time stepper are of second order.
  std::vector<double> late, unexplained;
  for (const double h : {0.01, 0.005, 0.0025}) {
    solver::StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = viscous}),
                                       {.time_step = h, .spectral_radius = 0.9});
    slider.start_slipping(scalar(0.0), scalar(v0));
    solver::EnergyRecorder recorder(slider);
    slider.observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
    while (slider.time() < 1.0) slider.step();
    ASSERT_EQ(slider.events().size(), 1u);
    late.push_back(std::abs(slider.events()[0].time - stop));
    unexplained.push_back(std::abs(recorder.balance().residual()));
  }
  expect_a_quarter_at_each_halving(late);
  expect_a_quarter_at_each_halving(unexplained);
}

TEST(StribeckLaw, GivesOneHistoryAtSecondOrder) {
  // A mass on a shaken plane sticks, slips through the minimum of the law, and sticks again.
  const SingleMass mass{.stiffness = 3.0,
                        .normal_force = normal_force,
                        .friction = stribeck,
                        .wall_acceleration = 12.0,
                        .omega = 2.0 * std::numbers::pi};
  analytic::EventDriven exact(contact_model(mass));
  exact.advance_to(2.0);
  ASSERT_GE(exact.events().size(), 4u);
  std::vector<double> errors;
  for (const double h : {2e-3, 1e-3, 5e-4, 2.5e-4}) {
    solver::StickSlipIntegrator stepped(contact_system(mass), {.time_step = h, .spectral_radius = 0.9});
    stepped.start_stuck(scalar(0.0), scalar(0.0));
    while (stepped.time() < 2.0 - 0.5 * h) stepped.step();
    ASSERT_EQ(stepped.events().size(), exact.events().size()) << h;
    double largest = 0.0;
    for (std::size_t i = 0; i < stepped.events().size(); ++i)
      largest = largest_or_nan({largest, std::abs(stepped.events()[i].time - exact.events()[i].time)});
    errors.push_back(largest);
  }
  expect_a_quarter_at_each_halving(errors);
}

}  // namespace
}  // namespace stickslip::testing
