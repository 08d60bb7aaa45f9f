/// Observed orders in time.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stickslip/solver/stick_slip_integrator.hpp"
#include "stickslip/studies/convergence.hpp"
#include "stickslip/studies/time_order.hpp"
#include "support/exact_pair.hpp"
#include "support/parameter_name.hpp"
#include "support/single_mass.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

class GeneralizedAlphaOrder : public ::testing::TestWithParam<double> {};

TEST_P(GeneralizedAlphaOrder, IsSecondOrderUnderTimeDependentLoad) {
  // The slope through five levels differs from 2 by about the second term of the error relative to the first,
  // (omega h)^2 with omega h <= 2 pi/50 for the load and up to 0.7 for the faster mode: 0.05.
  const studies::TimeOrderStudy study = studies::time_order_study(GetParam(), {50, 100, 200, 400, 800});
  EXPECT_TRUE(within(study.displacement_order.order, 2.0, next_terms(0.05)));
  EXPECT_TRUE(within(study.velocity_order.order, 2.0, next_terms(0.05)));
  EXPECT_TRUE(within(study.reaction_order.order, 2.0, next_terms(0.05)));
  // An order without a small error says little: half a per mille of unity at 800 steps a period.
  EXPECT_LT(study.displacement_error.back(), 1e-5);
  EXPECT_LT(study.reaction_error.back(), 5e-4);
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, GeneralizedAlphaOrder, ::testing::Values(0.0, 0.5, 0.9, 1.0),
                         NameOfDouble());

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
    EXPECT_TRUE(within(studies::observed_order(steps, errors), 2.0, next_terms(0.1))) << radius;
    EXPECT_LT(errors.back(), 1e-5);
  }
}

constexpr double sliding_time = 0.4;

// Velocity of a unit mass after that time, v_t = -N mu(v - w_t), by the classical Runge-Kutta method: 4000
// steps of (4 pi h)^4 < 1e-11 relative error.
double velocity_by_runge_kutta(const data::FrictionLaw& law, double normal_force,
                               const solver::PrescribedMotion& wall, double v0) {
  const auto rate = [&](double t, double v) {
    return -normal_force * solver::friction_coefficient(law, v - wall.velocity(t));
  };
  const int steps = 4000;
  const double h = sliding_time / steps;
  double v = v0;
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    const double k1 = rate(t, v), k2 = rate(t + 0.5 * h, v + 0.5 * h * k1);
    const double k3 = rate(t + 0.5 * h, v + 0.5 * h * k2), k4 = rate(t + h, v + h * k3);
    v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return v;
}

TEST(SlipOrder, IsTwoUnderWeakeningFrictionOnAMovingWall) {
  // The wall's velocity of amplitude 0.24 m/s moves mu - mu_m by a third; the mass always runs ahead of it.
  // 0.4 s are 0.8 of the wall's period: over whole ones the leading errors nearly cancel.
  const data::FrictionCoefficients law{.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.5};
  const double normal_force = 2.0, v0 = 2.0;
  const solver::PrescribedMotion wall = shaken(3.0, 2.0);
  const double exact = velocity_by_runge_kutta(data::FrictionLaw(law), normal_force, wall, v0);
  for (const double radius : {0.0, 0.5, 0.9, 1.0}) {
    std::vector<double> lengths, errors;
    for (const int steps : {100, 200, 400, 800}) {
      solver::StickSlipIntegrator slider(
          contact_system({.normal_force = normal_force, .friction = law}, wall),
          {.time_step = sliding_time / steps, .spectral_radius = radius});
      slider.start_slipping(scalar(0.0), scalar(v0));
      while (slider.steps() < steps) slider.step();
      ASSERT_TRUE(slider.events().empty());
      lengths.push_back(sliding_time / steps);
      errors.push_back(std::abs(slider.velocity()[0] - exact));
    }
    EXPECT_TRUE(within(studies::observed_order(lengths, errors), 2.0, next_terms(0.1))) << radius;
  }
}

// A mass with a spring let go from the wall: position after a slip between two sticks.
TEST(ContactLocation, PositionAfterReversalsIsOfSecondOrder) {
  for (const double radius : {0.0, 0.5, 0.9, 1.0}) {
    std::vector<double> steps, errors;
    for (const double h : {0.02, 0.01, 0.005, 0.0025, 0.00125}) {
      solver::StickSlipIntegrator oscillator(
          contact_system({.stiffness = 4.0, .normal_force = 4.0, .friction = coulomb}),
          {.time_step = h, .spectral_radius = radius});
      oscillator.start_slipping(scalar(1.04), scalar(0.0));
      while (oscillator.time() < 12.0) oscillator.step();
      ASSERT_GE(oscillator.events().size(), 4u);
      steps.push_back(h);
      errors.push_back(std::abs(oscillator.events()[3].time - 2.0 * std::acos(-1.0)));
    }
    EXPECT_TRUE(within(studies::observed_order(steps, errors), 2.0, next_terms(0.1))) << radius;
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
    const solver::ContactEvent& expected = exact.events()[i];
    EXPECT_EQ(events[i].kind, expected.kind) << "event " << i << " at " << expected.time << " s";
    errors.time = std::max(errors.time, std::abs(events[i].time - expected.time));
    errors.position = std::max(errors.position, std::abs(events[i].displacement - expected.displacement));
  }
  errors.displacement = (integrator.displacement() - exact.displacement()).norm();
  errors.velocity = (integrator.velocity() - exact.velocity()).norm();
  return errors;
}

class ContactHistoryOrder : public ::testing::TestWithParam<double> {};

TEST_P(ContactHistoryOrder, IsTwoThroughOnsetsCapturesAndReversals) {
  // Two coupled, damped masses under a load on a moving wall, with an unsymmetric slip state: 23 events in 12
  // s. The errors are differences to the exact solution, so that an order of 2 leaves no limit but zero; it
  // is off by about the next term, omega h = 0.06 relative on the coarsest level for the higher frequency.
  const ForcedPair pair;
  const double duration = 12.0;
  ExactPair exact(pair);
  exact.run(duration);
  for (const auto kind : {solver::ContactEvent::Kind::onset, solver::ContactEvent::Kind::capture,
                          solver::ContactEvent::Kind::reversal})
    ASSERT_GE(std::count_if(exact.events().begin(), exact.events().end(),
                            [kind](const auto& event) { return event.kind == kind; }),
              2);
  std::vector<double> lengths, times, positions, displacements, velocities;
  for (const int steps : {1000, 2000, 4000, 8000}) {
    const HistoryErrors errors = history_errors(pair, exact, duration, steps, GetParam());
    lengths.push_back(duration / steps);
    times.push_back(errors.time);
    positions.push_back(errors.position);
    displacements.push_back(errors.displacement);
    velocities.push_back(errors.velocity);
  }
  EXPECT_TRUE(within(studies::observed_order(lengths, times), 2.0, next_terms(0.06)));
  EXPECT_TRUE(within(studies::observed_order(lengths, positions), 2.0, next_terms(0.06)));
  EXPECT_TRUE(within(studies::observed_order(lengths, displacements), 2.0, next_terms(0.06)));
  EXPECT_TRUE(within(studies::observed_order(lengths, velocities), 2.0, next_terms(0.06)));
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, ContactHistoryOrder, ::testing::Values(0.0, 0.5, 0.9, 1.0),
                         NameOfDouble());

}  // namespace
}  // namespace stickslip::testing
