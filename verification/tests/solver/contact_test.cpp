// SPDX-License-Identifier: MIT
/// Contact changes on one mass, against exact piecewise solutions.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "stickslip/solver/stick_slip_integrator.hpp"
#include "support/error_message.hpp"
#include "support/exact_pair.hpp"
#include "support/parameter_name.hpp"
#include "support/requirements.hpp"
#include "support/single_mass.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using data::ContactEvent;
using data::ContactState;
using solver::ContactScheme;
using solver::IntegratorSettings;
using solver::StickSlipIntegrator;
using std::numbers::pi;

STICKSLIP_VERIFIES(StickSlipIntegrator, "F6");
TEST(StickSlipIntegrator, CoulombSliderStopsWhereItMust) {
  // v = v0 - mu g' t: stops at t = v0/a after v0^2/(2 a), a = mu N/m. Constant acceleration is integrated
  // exactly.
  for (const double radius : {0.0, 0.5, 0.9, 1.0}) {
    const auto slider =
        run_from_slip(sliding_mass, {.time_step = 0.07, .spectral_radius = radius}, 0.0, 1.3, 1.5);
    const double deceleration = 0.1 * 30.0 / 2.0;
    ASSERT_EQ(slider->events().size(), 1u);
    const ContactEvent& stop = slider->events().front();
    EXPECT_EQ(stop.change, data::ContactChange::capture);
    EXPECT_TRUE(within(stop.time, 1.3 / deceleration,
                       discretisation(1e-11 * 0.07 + 1e-14, 1.0, "location tolerance 1e-11 h")));
    EXPECT_TRUE(within(slider->displacement()[0], 0.5 * 1.3 * 1.3 / deceleration, round_off(100, 1, 1.0)));
    EXPECT_EQ(slider->state(), ContactState::stick);
    EXPECT_EQ(slider->sliding_velocity(), 0.0);
  }
}

TEST(StickSlipIntegrator, FrictionOpposesTheSlidingInBothDirections) {
  for (const double v0 : {-1.0, 1.0}) {
    StickSlipIntegrator slider(contact_system({.normal_force = 10.0, .friction = coulomb}),
                               {.time_step = 0.01, .spectral_radius = 1.0});
    slider.start_slipping(scalar(0.0), scalar(v0));
    EXPECT_DOUBLE_EQ(slider.friction_force(), -v0);
    slider.step();
    EXPECT_LT(std::abs(slider.velocity()[0]), 1.0);
    EXPECT_DOUBLE_EQ(slider.friction_force(), -v0);
  }
}

TEST(StickSlipIntegrator, CoulombOscillatorLosesTwiceTheDeadZoneEachHalfCycle) {
  // m = 1, k = 4: turning points -0.84, 0.64, -0.44, 0.24, -0.04 at multiples of pi/2 with mu N/k = 0.1; the last
  // lies within the dead zone and sticks. Per half cycle the method's period error is (omega h)^2/12 relative. At
  // spectral radius 1 a step changes the energy by the work of the constant friction, exactly: the turning points are
  // those of the exact motion, to the rounding of 1571 steps each.
  const double h = 1e-3;
  const auto oscillator =
      run_from_slip(oscillating_mass, {.time_step = h, .spectral_radius = 1.0}, 1.04, 0.0, 12.0);
  const auto& events = oscillator->events();
  ASSERT_EQ(events.size(), 5u);
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto half_cycles = static_cast<double>(i + 1);
    const double expected_time = half_cycles * pi / 2.0;
    const double expected_position = (i % 2 == 0 ? -1.0 : 1.0) * (1.04 - 0.2 * half_cycles);
    EXPECT_EQ(events[i].change, i + 1 < 5 ? data::ContactChange::reversal : data::ContactChange::capture);
    EXPECT_TRUE(
        within(events[i].time, expected_time,
               discretisation(expected_time * 4.0 * h * h / 12.0, 2.0, "period error (omega h)^2/12")));
    EXPECT_TRUE(within(events[i].position, expected_position, round_off(1571.0 * half_cycles, 1, 1.04)));
  }
}

// Friction holds 1 N of the inertia of 1 kg; the wall moves by w_tt = amplitude sin(2 pi t).
solver::ContactSystem mass_on_shaken_plane(double amplitude) {
  return contact_system({.normal_force = 10.0, .friction = coulomb}, shaken(amplitude, 1.0));
}

TEST(StickSlipIntegrator, MassOnAShakenPlaneLetsGoWhenFrictionIsUsedUp) {
  // A sin(2 pi t) m = mu N: t = asin(mu N/(m A))/(2 pi).
  StickSlipIntegrator mass(mass_on_shaken_plane(15.0), {.time_step = 1e-3, .spectral_radius = 0.9});
  mass.start_stuck(scalar(0.0), scalar(0.0));
  while (mass.events().empty() && mass.time() < 1.0) mass.step();
  ASSERT_FALSE(mass.events().empty());
  EXPECT_EQ(mass.events().front().change, data::ContactChange::onset);
  EXPECT_TRUE(within(mass.events().front().time, std::asin(1.0 / 15.0) / (2.0 * pi),
                     discretisation(1e-11 * 1e-3 + 1e-14, 1.0, "location tolerance 1e-11 h")));
}

TEST(StickSlipIntegrator, ASpringPastTheFrictionLimitLetsGoAtOnce) {
  // Holding takes k q = 2 q; the limit is 1 N, which itself still holds.
  for (const double position : {-0.6, -0.5, 0.4, 0.5, 0.6})
    for (const auto scheme : {ContactScheme::located, ContactScheme::end_of_step, ContactScheme::paper}) {
      StickSlipIntegrator mass(
          contact_system({.stiffness = 2.0, .normal_force = 10.0, .friction = coulomb}),
          {.time_step = 1e-2, .spectral_radius = 0.9, .velocity_threshold = 1e-6, .scheme = scheme});
      mass.start_stuck(scalar(position), scalar(0.0));
      if (std::abs(position) <= 0.5) {
        for (int n = 0; n < 10; ++n) mass.step();
        EXPECT_EQ(mass.state(), ContactState::stick);
        EXPECT_TRUE(mass.events().empty());
        continue;
      }
      EXPECT_EQ(mass.state(), ContactState::slip);
      ASSERT_EQ(mass.events().size(), 1u);
      EXPECT_EQ(mass.events().front().change, data::ContactChange::onset);
      EXPECT_EQ(mass.events().front().time, 0.0);
      EXPECT_DOUBLE_EQ(mass.friction_force(), position > 0.0 ? 1.0 : -1.0);
    }
}

TEST(StickSlipIntegrator, StaysStuckForEverBelowTheFrictionLimit) {
  StickSlipIntegrator mass(mass_on_shaken_plane(0.99), {.time_step = 1e-3, .spectral_radius = 0.9});
  mass.start_stuck(scalar(0.25), scalar(0.0));
  const auto& wall = mass.system().wall;
  for (int n = 0; n < 12000; ++n) {
    mass.step();
    ASSERT_TRUE(within(mass.displacement()[0] - wall.displacement(mass.time()), 0.25, round_off(2, 1, 0.3)));
  }
  EXPECT_TRUE(mass.events().empty());
}

// Code SDND104 of a public validation manual: mean of 10 N |v_s| over 4 <= t <= 12 s on a plane shaken by A
// sin(2 pi t).
double mean_friction_power(double amplitude, double time_step) {
  StickSlipIntegrator mass(mass_on_shaken_plane(amplitude), {.time_step = time_step, .spectral_radius = 1.0});
  mass.start_stuck(scalar(0.0), scalar(0.0));
  double sum = 0.0, before = 0.0;
  const long first = std::lround(4.0 / time_step), last = std::lround(12.0 / time_step);
  for (long n = 1; n <= last; ++n) {
    mass.step();
    const double now = std::abs(mass.sliding_velocity());
    if (n > first) sum += 0.5 * (before + now) * time_step;
    before = now;
  }
  return 10.0 * sum / 8.0;
}

struct ShakenPlane {
  double amplitude, mean_power;
};

class ShakenPlaneBenchmark : public ::testing::TestWithParam<ShakenPlane> {};

STICKSLIP_VERIFIES(ShakenPlaneBenchmark, "F6");
TEST_P(ShakenPlaneBenchmark, MeanFrictionPowerIsThePublishedOne) {
  // Second order in h: |v_s| is smooth between kinks that are located, and the trapezoidal rule loses at most
  // h^2/8 times the jump of the slope at each of the at most 4 kinks a second; method and rule together
  // (2 pi h)^2/12 of 10 A/(2 pi) per second of smooth motion.
  const double h = 1e-4;
  const double slope = 2.0 * GetParam().amplitude;
  const double predicted =
      10.0 * (4.0 * h * h / 8.0 * slope + std::pow(2.0 * pi * h, 2) / 12.0 * slope / (4.0 * pi));
  EXPECT_TRUE(within(mean_friction_power(GetParam().amplitude, h), GetParam().mean_power,
                     discretisation(predicted, 1.0, "kinks h^2/8 and (omega h)^2/12")));
}

INSTANTIATE_TEST_SUITE_P(StickSlip, ShakenPlaneBenchmark,
                         ::testing::Values(ShakenPlane{15.0, 15.2670995893716},
                                           ShakenPlane{1.5, 0.409062451015709},
                                           ShakenPlane{1.01, 2.26164121279787e-4}, ShakenPlane{0.99, 0.0}),
                         [](const auto& instance) { return parameter_name(instance.param.amplitude); });

// The same mean from the path: under Coulomb friction the loss is mu N times the way slid, that is the sum of
// the distances between the positions of consecutive events and the two ends of the average.
double mean_friction_power_by_path(double amplitude, double time_step) {
  StickSlipIntegrator mass(mass_on_shaken_plane(amplitude), {.time_step = time_step, .spectral_radius = 0.9});
  const auto& wall = mass.system().wall;
  mass.start_stuck(scalar(0.0), scalar(0.0));
  const auto run_to = [&](double end) {
    while (mass.steps() < std::lround(end / time_step)) mass.step();
    return mass.displacement()[0] - wall.displacement(mass.time());
  };
  double position = run_to(4.0), path = 0.0;
  const std::size_t first = mass.events().size();
  const double last_position = run_to(12.0);
  for (std::size_t i = first; i < mass.events().size(); ++i) {
    path += std::abs(mass.events()[i].position - position);
    position = mass.events()[i].position;
  }
  return 10.0 * (path + std::abs(last_position - position)) / 8.0;
}

TEST_P(ShakenPlaneBenchmark, MeanFrictionPowerByThePathIsThePublishedOneToSixDigitsAtAnyStep) {
  // The force on the mass is constant in slip and the wall's motion is exact, so that the order 2 has nothing
  // to act on. What is left is the location of the at most 6 events a second, 1e-11 h: an instant that is off
  // by dt leaves a sliding velocity of at most 2 A dt, for less than a second.
  for (const double h : {1e-2, 1e-3, 1e-4}) {
    const double instant = 1e-11 * h + 1e-14;
    const double predicted = 10.0 * 6.0 * instant * 2.0 * GetParam().amplitude;
    const double power = mean_friction_power_by_path(GetParam().amplitude, h);
    EXPECT_TRUE(
        within(power, GetParam().mean_power, discretisation(predicted, 1.0, "events located to 1e-11 h")))
        << h;
    EXPECT_LE(std::abs(power - GetParam().mean_power), 5e-7 * GetParam().mean_power) << h;
  }
}

// The pair without damping, load and follower term, on a wall at rest.
solver::ContactSystem pair_at_rest(double normal_force) {
  ForcedPair pair;
  pair.damping.setZero();
  pair.slip_stiffness = pair.stick_stiffness;
  pair.load.setZero();
  pair.wall_amplitude = 0.0;
  pair.normal_force = normal_force;
  pair.friction_coefficient = 0.1;
  return contact_system(pair);
}

TEST(StickSlipIntegrator, CaptureRemovesExactlyTheEnergyOfTheImpulse) {
  // With a threshold the contact is captured while it still slides; the twin without one shows the state
  // before.
  const auto run_until = [](double threshold, double end) {
    auto integrator = std::make_unique<StickSlipIntegrator>(
        pair_at_rest(20.0),
        IntegratorSettings{.time_step = 1e-2, .spectral_radius = 1.0, .velocity_threshold = threshold});
    integrator->start_slipping(Eigen::Vector2d(0.2, 0.1), Eigen::Vector2d(0.5, 1.0));
    while (integrator->time() < end && integrator->events().empty()) integrator->step();
    return integrator;
  };
  const auto captured = run_until(0.3, 10.0);
  ASSERT_EQ(captured->events().size(), 1u);
  const ContactEvent& event = captured->events().front();
  ASSERT_EQ(event.change, data::ContactChange::capture);
  const auto twin = run_until(0.0, event.time - 1e-9);
  ASSERT_TRUE(twin->events().empty());
  const auto kinetic_energy = [](const StickSlipIntegrator& s) {
    return 0.5 * s.velocity().dot(s.system().mass * s.velocity());
  };
  const double removed = 0.5 * captured->contact_mass() * event.residual_velocity * event.residual_velocity;
  EXPECT_GT(std::abs(event.residual_velocity), 0.01);
  EXPECT_TRUE(within(kinetic_energy(*twin) - kinetic_energy(*captured), removed, round_off(50, 10, 1.0)));
  EXPECT_EQ(captured->velocity()[1], 0.0);
  EXPECT_EQ((captured->displacement() - twin->displacement()).cwiseAbs().maxCoeff(), 0.0);
  // M-orthogonal: what the impulse took away has no inertia force but at the contact.
  const Eigen::VectorXd momentum = twin->system().mass * (twin->velocity() - captured->velocity());
  EXPECT_TRUE(within(momentum[0], 0.0, round_off(20, 1, 1.0)));
}

TEST(StickSlipIntegrator, ContactMassIsTheInverseOfTheContactMobility) {
  const StickSlipIntegrator integrator(pair_at_rest(1.0), {.time_step = 1e-2, .spectral_radius = 1.0});
  // [M^-1]_22 = 2.0/(2.0*1.0 - 0.09)
  EXPECT_TRUE(within(integrator.contact_mass(), (2.0 - 0.09) / 2.0, round_off(10, 1, 1.0)));
}

TEST(StickSlipIntegrator, FrictionForceBalancesTheContactInStickAndIsThatOfTheLawInSlip) {
  // The first row of M q_tt + C v + K q = s(t) p gives the acceleration of the first mass, the second one the force on
  // the contact, which in stick has the acceleration of the wall. The largest term is K q, about 30 N.
  const ForcedPair pair;
  StickSlipIntegrator integrator(contact_system(pair), {.time_step = 1e-2, .spectral_radius = 0.9});
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  const auto& system = integrator.system();
  int stuck = 0;
  while (integrator.steps() < 400) {
    integrator.step();
    if (integrator.state() == ContactState::slip) {
      const double limit = pair.friction_limit();
      ASSERT_TRUE(within(integrator.friction_force(), -std::copysign(limit, integrator.sliding_velocity()),
                         round_off(2, 1, limit)));
      continue;
    }
    ++stuck;
    const double t = integrator.time(), of_wall = system.wall.acceleration(t);
    const Eigen::Vector2d rest = pair.damping * integrator.velocity() +
                                 pair.slip_stiffness * integrator.displacement() -
                                 system.load_history(t) * pair.load;
    const double of_first = -(rest[0] + pair.mass(0, 1) * of_wall) / pair.mass(0, 0);
    ASSERT_TRUE(within(integrator.friction_force(),
                       pair.mass(1, 0) * of_first + pair.mass(1, 1) * of_wall + rest[1],
                       round_off(20, 2, 30.0)));
  }
  EXPECT_GT(stuck, 20);
  EXPECT_LT(stuck, 380);
}

TEST(StickSlipIntegrator, CapturesAtTheFirstStepThatEndsBelowTheThreshold) {
  // v = 1.3 - 1.5 t: 0.25 m/s after ten steps, 0.145 m/s after eleven.
  const auto slider = run_from_slip(
      sliding_mass, {.time_step = 0.07, .spectral_radius = 0.9, .velocity_threshold = 0.2}, 0.0, 1.3, 0.8);
  ASSERT_EQ(slider->events().size(), 1u);
  EXPECT_EQ(slider->events().front().change, data::ContactChange::capture);
  EXPECT_DOUBLE_EQ(slider->events().front().time, 0.77);
  EXPECT_TRUE(within(slider->events().front().residual_velocity, 0.145, round_off(11, 1, 1.3)));
}

TEST(StickSlipIntegrator, CapturesAVelocityThatIsTheThresholdItself) {
  // Nothing acts on the mass, so that its velocity stays 2^-10 m/s to the last bit.
  const double velocity = 0x1p-10;
  for (const double threshold : {velocity, std::nextafter(velocity, 0.0)}) {
    StickSlipIntegrator glider(
        contact_system({.mass = 2.0, .normal_force = 30.0}),
        {.time_step = 0x1p-6, .spectral_radius = 0.9, .velocity_threshold = threshold});
    glider.start_slipping(scalar(0.0), scalar(velocity));
    glider.step();
    EXPECT_EQ(glider.events().size(), threshold < velocity ? 0u : 1u);
  }
}

TEST(StickSlipIntegrator, ASlowContactThatCannotBeHeldSlidesOn) {
  // Turning points at 1.04 - 0.2 i beyond the dead zone of 0.1: a threshold affects the last one alone.
  const auto events = [](double threshold) {
    return run_from_slip(oscillating_mass,
                         {.time_step = 1e-2, .spectral_radius = 1.0, .velocity_threshold = threshold}, 1.04,
                         0.0, 12.0)
        ->events();
  };
  const auto without = events(0.0), with = events(0.05);
  ASSERT_EQ(without.size(), 5u);
  ASSERT_EQ(with.size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(with[i].change, data::ContactChange::reversal);
    EXPECT_EQ(with[i].time, without[i].time);
  }
  EXPECT_EQ(with[4].change, data::ContactChange::capture);
  EXPECT_LT(with[4].time, without[4].time);
}

TEST(StickSlipIntegrator, StartingAgainForgetsTheRunBefore) {
  StickSlipIntegrator oscillator(contact_system(oscillating_mass),
                                 {.time_step = 1e-2, .spectral_radius = 0.9});
  const auto run = [&oscillator] {
    oscillator.start_slipping(scalar(1.04), scalar(0.0));
    while (oscillator.steps() < 500) oscillator.step();
    return oscillator.displacement()[0];
  };
  const double first = run();
  const auto events = oscillator.events().size();
  ASSERT_GT(events, 0u);
  EXPECT_EQ(run(), first);
  EXPECT_EQ(oscillator.events().size(), events);
  EXPECT_DOUBLE_EQ(oscillator.time(), 5.0);
}

TEST(StickSlipIntegrator, StartsAsOftenAsAskedBeforeItSteps) {
  // Each start lets go at once; only what happens within a step is chatter.
  StickSlipIntegrator oscillator(contact_system(oscillating_mass),
                                 {.time_step = 1e-2, .spectral_radius = 0.9});
  for (int i = 0; i < 2000; ++i) ASSERT_NO_THROW(oscillator.start_stuck(scalar(1.04), scalar(0.0)));
  EXPECT_EQ(oscillator.events().size(), 1u);
}

constexpr IntegratorSettings usable_settings{.time_step = 1e-3, .spectral_radius = 1.0};

TEST(StickSlipIntegrator, RefusesUnusableSettings) {
  const auto refuses = [](const IntegratorSettings& settings) {
    EXPECT_THROW(StickSlipIntegrator(contact_system(sliding_mass), settings), std::invalid_argument)
        << "time_step = " << settings.time_step << ", spectral_radius = " << settings.spectral_radius
        << ", velocity_threshold = " << settings.velocity_threshold;
  };
  for (const double step : {0.0, -1.0, std::nan("")}) refuses({.time_step = step, .spectral_radius = 1.0});
  refuses({.time_step = 1e-3, .spectral_radius = 1.1});
  refuses({.time_step = 1e-3, .spectral_radius = 1.0, .velocity_threshold = -1.0});
  refuses({.time_step = 1e-3, .spectral_radius = 1.0, .scheme = ContactScheme::paper});  // no threshold
}

TEST(StickSlipIntegrator, RefusesUnusableSystems) {
  const auto refuses = [](const std::string& what,
                          const std::function<void(solver::ContactSystem&)>& change) {
    solver::ContactSystem system = contact_system(sliding_mass);
    change(system);
    EXPECT_THROW(StickSlipIntegrator(system, usable_settings), std::invalid_argument) << what;
  };
  refuses("negative mass", [](auto& system) { system.mass = scalar_matrix(-1.0); });
  refuses("two loads", [](auto& system) { system.load_shape = Eigen::VectorXd::Zero(2); });
  for (const double force : {-1.0, std::nan("")})
    refuses("normal force", [force](auto& system) { system.normal_force = force; });
  for (const Eigen::Index contact : {-1, 1})
    refuses("contact", [contact](auto& system) { system.contact = contact; });
  for (const double stiffness : {std::nan(""), std::numeric_limits<double>::infinity()})
    refuses("stiffness", [stiffness](auto& system) {
      system = pair_at_rest(1.0);
      system.stick_stiffness.coeffRef(0, 0) = stiffness;
    });
  for (const auto matrix : {&solver::ContactSystem::mass, &solver::ContactSystem::damping,
                            &solver::ContactSystem::stick_stiffness, &solver::ContactSystem::slip_stiffness})
    for (const int rows : {1, 2})
      refuses("size of a matrix", [matrix, rows](auto& system) {
        solver::SparseMatrix other(rows, 3 - rows);
        other.insert(0, 0) = 1.0;
        system.*matrix = other;
      });
}

TEST(StickSlipIntegrator, ObserverSeesTheForceAtTheEndOfTheStep) {
  // The force of a contact on a spring follows from the step.
  solver::ContactSystem system = contact_system(oscillating_mass);
  system.tangential = data::TangentialContact({.tangential_stiffness = 400.0});
  StickSlipIntegrator oscillator(system, {.time_step = 1e-2, .spectral_radius = 1.0});
  oscillator.start_slipping(scalar(1.04), scalar(0.0));
  double force = 0.0;
  oscillator.observe([&force](const StickSlipIntegrator& now) { force = now.friction_force(); });
  while (oscillator.time() < 4.0) {
    oscillator.step();
    ASSERT_EQ(force, oscillator.friction_force()) << oscillator.time() << " s";
  }
  EXPECT_GE(oscillator.events().size(), 5u);
}

TEST(StickSlipIntegrator, RefusesAStartOfAnotherSize) {
  StickSlipIntegrator mass(contact_system(sliding_mass), usable_settings);
  const Eigen::VectorXd one = scalar(0.0), two = Eigen::VectorXd::Zero(2);
  EXPECT_THROW(mass.start_stuck(two, one), std::invalid_argument);
  EXPECT_THROW(mass.start_stuck(one, two), std::invalid_argument);
  EXPECT_THROW(mass.start_slipping(two, one), std::invalid_argument);
  EXPECT_THROW(mass.start_slipping(one, two), std::invalid_argument);
}

TEST(StickSlipIntegrator, FrictionLawHoldsToRoundOffInAStepAsLongAsTheLawAllows) {
  // At spectral radius 0 the balance holds at the end of the step: m (2 a_1 - a_0) = -mu(v_1) N with
  // v_1 = v_0 + h (3 a_1 - a_0)/2. The step is 99 % of the longest one, 4 m/(3 N (mu_s - mu_m) alpha).
  const data::FrictionCoefficients weakening{
      .static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.5};
  const data::FrictionLaw law(weakening);
  const double normal_force = 10.0, h = 0.99 * 4.0 / (3.0 * normal_force * 0.3 * 1.5);
  for (const double v0 : {1.57, 1.6, 1.7, 2.0, 3.0}) {
    StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = weakening}),
                               {.time_step = h, .spectral_radius = 0.0});
    slider.start_slipping(scalar(0.0), scalar(v0));
    const double a0 = -solver::friction_coefficient(law, v0) * normal_force;
    slider.step();
    ASSERT_TRUE(slider.events().empty()) << v0;
    const double v1 = slider.velocity()[0];
    const double a1 = ((v1 - v0) / (0.5 * h) + a0) / 3.0;
    EXPECT_TRUE(within(2.0 * a1 - a0, -solver::friction_coefficient(law, v1) * normal_force,
                       round_off(20, 1, normal_force)))
        << "v_0 = " << v0 << ", v_1 = " << v1;
  }
}

TEST(StickSlipIntegrator, StopsWhenItsStateIsNoLongerFinite) {
  StickSlipIntegrator slider(contact_system({.normal_force = 10.0, .friction = coulomb}),
                             {.time_step = 0.5, .spectral_radius = 1.0});
  slider.start_slipping(scalar(1.79e308), scalar(1e308));
  EXPECT_THROW(slider.step(), std::runtime_error);
}

TEST(StickSlipIntegrator, NeverSolvesWithAMatrixThatCouldNotBeFactorised) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2);
  solver::ContactSystem overflown = pair_at_rest(1.0);
  overflown.slip_stiffness.coeffRef(0, 0) = std::nan("");
  StickSlipIntegrator sliding(overflown, usable_settings);
  for (int attempt = 0; attempt < 2; ++attempt)
    EXPECT_THROW(sliding.start_slipping(zero, zero), std::runtime_error);

  // In a step of 1 s, M/2 + C/4 + K/8 = 0 for the first mass.
  solver::ContactSystem cancelling = pair_at_rest(1.0);
  cancelling.damping.coeffRef(0, 0) = -19.0;
  StickSlipIntegrator stuck(cancelling, {.time_step = 1.0, .spectral_radius = 1.0});
  for (int attempt = 0; attempt < 2; ++attempt)
    EXPECT_THROW(stuck.start_stuck(zero, zero), std::runtime_error);
}

TEST(StickSlipIntegrator, StopsWithAMessageWhenTheFrictionLawFallsTooFastForTheStep) {
  StickSlipIntegrator slider(
      contact_system({.normal_force = 1e3,
                      .friction = {.static_coefficient = 1.0, .kinetic_coefficient = 0.0, .decay = 1e3}}),
      {.time_step = 0.1, .spectral_radius = 1.0});
  slider.start_slipping(scalar(0.0), scalar(1.0));
  const std::string message = error_message_of<std::runtime_error>([&] { slider.step(); });
  EXPECT_NE(message.find("time_step = 0.1 s"), std::string::npos) << message;
}

STICKSLIP_VERIFIES(ContactScheme, "F6");
TEST(ContactScheme, OfThePaperJumpsOverItsThresholdWhenTheContactIsFast) {
  // v = 1.3 - 1.5 t in steps of 0.07 s: v falls by 0.105 m/s a step, from 0.04 to -0.065 m/s. A threshold of
  // 0.05 m/s is met at 0.04 m/s; one of 0.03 m/s is not, and friction flips for ever.
  const auto run = [](double threshold) {
    return run_from_slip(sliding_mass,
                         {.time_step = 0.07,
                          .spectral_radius = 1.0,
                          .velocity_threshold = threshold,
                          .scheme = ContactScheme::paper},
                         0.0, 1.3, 2.07)
        ->events();
  };
  const auto held = run(0.05), missed = run(0.03);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].change, data::ContactChange::capture);
  EXPECT_DOUBLE_EQ(held[0].time, 12 * 0.07);
  EXPECT_TRUE(within(held[0].residual_velocity, 0.04, round_off(12, 1, 1.3)));
  ASSERT_EQ(missed.size(), 17u);  // at the start of every step from the 14th to the 30th
  for (const auto& event : missed) EXPECT_EQ(event.change, data::ContactChange::reversal);
}

TEST(ContactScheme, AtTheEndOfTheStepTakesAChangeThereAndAnImpulseAwayWithIt) {
  const IntegratorSettings settings{
      .time_step = 0.07, .spectral_radius = 0.9, .scheme = ContactScheme::end_of_step};
  const auto slider = run_from_slip(sliding_mass, settings, 0.0, 1.3, 2.07);
  ASSERT_EQ(slider->events().size(), 1u);
  const ContactEvent& stop = slider->events().front();
  EXPECT_EQ(stop.change, data::ContactChange::capture);
  EXPECT_DOUBLE_EQ(stop.time, 13 * 0.07);
  EXPECT_TRUE(within(stop.residual_velocity, -0.065, round_off(13, 1, 1.3)));
  EXPECT_EQ(slider->velocity()[0], 0.0);

  // The plane lets go at asin(1/15)/(2 pi) = 0.010618 s: after the eleventh step of 1 ms.
  StickSlipIntegrator mass(mass_on_shaken_plane(15.0),
                           {.time_step = 1e-3, .spectral_radius = 0.9, .scheme = ContactScheme::end_of_step});
  mass.start_stuck(scalar(0.0), scalar(0.0));
  while (mass.steps() < 20) mass.step();
  ASSERT_FALSE(mass.events().empty());
  EXPECT_EQ(mass.events()[0].change, data::ContactChange::onset);
  EXPECT_DOUBLE_EQ(mass.events()[0].time, 0.011);
}

STICKSLIP_VERIFIES(FrictionLaw, "P2");
TEST(FrictionLaw, FallsFromStaticToKineticWithTheDecay) {
  const data::FrictionLaw law({.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 2.0});
  EXPECT_DOUBLE_EQ(solver::friction_coefficient(law, 0.0), 0.6);
  EXPECT_DOUBLE_EQ(solver::friction_coefficient(law, -0.7), solver::friction_coefficient(law, 0.7));
  EXPECT_TRUE(
      within(solver::friction_coefficient(law, 0.7), 0.3 + 0.3 * std::exp(-1.4), round_off(5, 1, 1.0)));
  EXPECT_DOUBLE_EQ(solver::friction_coefficient(law, 1e6), 0.3);
}

}  // namespace
}  // namespace stickslip::testing
