// SPDX-License-Identifier: MIT
/// Friction problems of others, and a friction law that jumps, in both implementations.

#include "support/published_problems.hpp"

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/convergence/discretisation.hpp"
#include "studies/stick_slip/contact_growth.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

const std::vector<PublishedProblem>& problems() {
  static const auto solved = published_problems(data::load_reference());
  return solved;
}

STICKSLIP_VERIFIES(PublishedProblems, "F6");
TEST(PublishedProblems, AreSolvedByTheTimeStepperAtSecondOrder) {
  ASSERT_EQ(problems().size(), 10u);
  for (const auto& problem : problems()) {
    SCOPED_TRACE(problem.name);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [same_changes, time, position] = problem.stepped[i];
      EXPECT_TRUE(same_changes);
      if (problem.name.starts_with("incline")) {
        // Constant forces: exact but for the rounding of 10 to 200 steps.
        EXPECT_TRUE(
            within(position, 0.0, round_off(20.0 * 5.0 / problem.time_step[i], 1, problem.amplitude)));
        continue;
      }
      if (i == 0) continue;
      EXPECT_GT(problem.stepped[i - 1].time, 3.5 * time);
      EXPECT_LT(problem.stepped[i - 1].time, 4.5 * time);
      EXPECT_GT(problem.stepped[i - 1].position, 3.5 * position);
    }
  }
}

// A change falls somewhere in a step, so that its time is late by less than one, and what that costs is of second
// order, but scatters: over two halvings the position gains a factor 16 to within 3.
TEST(PublishedProblems, AreSolvedInFixedStepsWithoutLocatingAChange) {
  int tried = 0;
  for (const auto& problem : problems()) {
    if (!problem.has_spring) continue;
    SCOPED_TRACE(problem.name);
    ++tried;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(problem.fixed_steps[i].same_changes);
      EXPECT_LT(problem.fixed_steps[i].time, 1.5 * problem.time_step[i]);
    }
    EXPECT_LT(problem.fixed_steps[2].position, problem.fixed_steps[0].position * 3.0 / 16.0);
    EXPECT_LT(problem.fixed_steps[2].position, 1e-4 * problem.amplitude);
  }
  EXPECT_EQ(tried, 6);
}

TEST(PublishedProblems, AreSolvedByTheEventDrivenRunToItsTolerance) {
  for (const auto& problem : problems()) {
    SCOPED_TRACE(problem.name);
    const double share = problem.event_driven_prediction;
    EXPECT_TRUE(problem.event_driven.same_changes);
    EXPECT_TRUE(within(problem.event_driven.time, 0.0,
                       discretisation(share * problem.duration, 1.0, "1e-12 a step")));
    EXPECT_TRUE(within(problem.event_driven.position, 0.0,
                       discretisation(share * problem.amplitude, 1.0, "1e-12 a step")));
  }
}

TEST(PublishedProblems, ShowNoCreepBelowTheFrictionAngle) {
  const auto& stays = problems().front();
  ASSERT_EQ(stays.name, "incline-stays");
  EXPECT_EQ(stays.duration, 100.0);
  EXPECT_EQ(stays.event_driven.position, 0.0);
  for (const auto& run : stays.stepped) EXPECT_EQ(run.position, 0.0);
}

TEST(PublishedProblems, ASpringStopsLateByTheErrorOfItsPeriod) {
  // sdnd100: four half swings of omega = 100 rad/s. The next term of the error is smaller by (omega h)^2.
  const auto& spring = problems()[3];
  ASSERT_EQ(spring.name, "sdnd100");
  for (std::size_t i = 0; i < 3; ++i) {
    const double h = spring.time_step[i], pi = std::numbers::pi;
    const double late =
        4.0 * pi / studies::generalized_alpha_oscillation(0.9, 100.0, h).angular_frequency - 4.0 * pi / 100.0;
    EXPECT_TRUE(within(spring.stepped[i].time, late, discretisation(late * 1e4 * h * h, 5.0, "(omega h)^2")));
  }
}

TEST(PublishedProblems, AForcedMassStopsAsOftenAsHongAndLiuSay) {
  const auto counts = stops_per_period(data::load_reference());
  EXPECT_EQ(counts.size(), 36u);
  std::set<int> seen;
  for (const auto& count : counts) {
    EXPECT_EQ(count.event_driven, count.reference) << count.frequency_ratio << ", " << count.force_ratio;
    EXPECT_EQ(count.stepped, count.reference) << count.frequency_ratio << ", " << count.force_ratio;
    seen.insert(count.reference);
  }
  EXPECT_EQ(seen, (std::set{0, 1, 2, 4, 6, 8}));
}

TEST(PublishedProblems, AForcedMassNeverStopsBeyondTheLimitOfDenHartog) {
  const auto package = data::load_reference();
  const std::size_t limits = data::read_table(package, "non-stop-limits").rows();
  EXPECT_GT(limits, 0u);
  for (const auto& [share, stops] : {std::pair{0.99, 2}, {1.01, 0}}) {
    const auto counts = stops_beside_the_limit(package, share);
    EXPECT_EQ(counts.size(), limits);
    for (const auto& count : counts) {
      EXPECT_EQ(count.event_driven, stops) << count.frequency_ratio;
      EXPECT_EQ(count.stepped, stops) << count.frequency_ratio;
    }
  }
}

constexpr data::FrictionCoefficients jumping{
    .static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = std::numeric_limits<double>::infinity()};

STICKSLIP_VERIFIES(JumpOfFriction, "P2");
TEST(JumpOfFriction, IsTheLimitOfEverFasterDecay) {
  const data::FrictionLaw law = data::FrictionLaw(jumping).in_slip();
  for (const double v : {0.0, 1e-300, 1.0}) EXPECT_EQ(solver::friction_coefficient(law, v), 0.2);
  data::FrictionCoefficients fast = jumping;
  fast.decay = 1e6;
  EXPECT_DOUBLE_EQ(solver::friction_coefficient(data::FrictionLaw(fast), 1.0), 0.2);
  EXPECT_EQ(data::FrictionLaw(fast).in_slip().decay(), 1e6);
  EXPECT_EQ(studies::weakening(data::FrictionLaw(jumping), 10.0), 0.0);  // nothing grows in slip
}

TEST(JumpOfFriction, HoldsMoreInStickThanInSlipInBothImplementations) {
  // A spring of 2 N/m that takes 2.5 N, between mu_k N = 2 N and mu_s N = 3 N; released in slip it moves on.
  const SingleMass mass{.stiffness = 2.0, .normal_force = 10.0, .friction = jumping};
  solver::StickSlipIntegrator stepped(contact_system(mass), {.time_step = 1e-2, .spectral_radius = 0.9});
  analytic::EventDriven exact(
      contact_model(SingleMass{.stiffness = 2.0, .normal_force = 10.0, .friction = jumping}));
  stepped.start_stuck(scalar(1.25), scalar(0.0));
  exact.start_stuck({}, {}, 1.25);
  EXPECT_EQ(stepped.friction_force(), 2.5);
  EXPECT_EQ(exact.friction_force(), 2.5);
  stepped.start_slipping(scalar(1.25), scalar(-0.1));
  exact.start_slipping({}, {}, 1.25, -0.1);
  EXPECT_DOUBLE_EQ(stepped.friction_force(), 2.0);
  EXPECT_DOUBLE_EQ(exact.friction_force(), 2.0);
  // From 1.6 m it falls to 2 - 1.6 = 0.4 m, where 0.8 N hold it: one stop.
  stepped.start_stuck(scalar(1.6), scalar(0.0));
  exact.start_stuck({}, {}, 1.6);
  exact.advance_to(10.0);
  while (stepped.time() < 10.0) stepped.step();
  ASSERT_EQ(exact.events().size(), 2u);
  ASSERT_EQ(stepped.events().size(), 2u);
  EXPECT_TRUE(within(exact.contact_position(), 0.4, discretisation(1e-12, 10.0, "1e-12 a step")));
  EXPECT_EQ(exact.events()[1].change, data::ContactChange::capture);
  // The numerical damping is of third order: (omega h)^3 = 3e-6.
  EXPECT_TRUE(within(stepped.displacement()[0], 0.4, discretisation(3e-6, 1.0, "(omega h)^3")));
}

TEST(JumpOfFriction, KeepsTheEnergyBalanceUnderAConstantForce) {
  // 4 N pull a mass that 2 N hold in slip: x = t^2, of which half the work is lost.
  analytic::ContactModel model = contact_model(SingleMass{.normal_force = 10.0, .friction = jumping});
  model.contact_force = 4.0;
  analytic::EventDriven run(model, {.keep_energy_balance = true});
  run.start_stuck({}, {});
  run.advance_to(3.0);
  EXPECT_TRUE(within(run.contact_position(), 9.0, discretisation(9e-12, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(run.energy_balance().base_work, 36.0, discretisation(36e-12, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(run.energy_balance().friction_loss, 18.0, discretisation(36e-12, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(run.energy_balance().kinetic, 18.0, discretisation(36e-12, 1.0, "1e-12 a step")));
  // The same in the time stepper, but for the pull: it stops after 2 m/s^2 have taken 1 m/s.
  solver::StickSlipIntegrator slider(contact_system({.normal_force = 10.0, .friction = jumping}),
                                     {.time_step = 1e-2, .spectral_radius = 0.9});
  slider.start_slipping(scalar(0.0), scalar(1.0));
  solver::EnergyRecorder recorder(slider);
  slider.observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
  while (slider.time() < 1.0) slider.step();
  EXPECT_TRUE(within(recorder.balance().friction_loss, 0.5, round_off(1e4, 1, 0.5)));
}

TEST(JumpOfFriction, IsRefusedWhereAStepCouldBothStickAndSlip) {
  EXPECT_THROW(analytic::require_unique_step({10.0, data::FrictionLaw(jumping)}, 1e-9), data::FieldError);
}

}  // namespace
}  // namespace stickslip::testing
