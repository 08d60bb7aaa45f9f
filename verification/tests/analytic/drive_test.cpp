// SPDX-License-Identifier: MIT
/// General motions in closed form and event by event: against one sine, by superposition, and against formulas.

#include "stickslip/analytic/drive.hpp"

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/held_motion.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/structures.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::EventDriven, analytic::HeldMotion;
using data::AmplitudeOf, data::GeneralMotion, data::Sine;

constexpr double pi = std::numbers::pi;

data::Case damped_case(double kelvin_voigt) {
  data::Case problem = with_value(data::load_case("paper"), "excitation.duration", 0.5);
  problem.damping = data::Damping({.kelvin_voigt = kelvin_voigt});
  return problem;
}

data::Case moved_by(data::Case problem, GeneralMotion::Statement statement) {
  problem.motion = GeneralMotion(std::move(statement), problem.numerics.duration());
  return problem;
}

data::Case moved_by(data::Case problem, const Sine& sine) {
  return moved_by(std::move(problem), std::vector<Sine>{sine});
}

double force_at(const data::Case& problem, double t) {
  return HeldMotion(analytic::contact_model(problem, problem.numerics.modes())).force(t);
}

analytic::MotionReaction reaction_of(const data::Case& problem) {
  return analytic::motion_reaction(problem, problem.numerics.modes());
}

// The pieces of a sum of sines are off by 1e-12 of the motion or so. Without damping stick and slip let a difference grow: by at most
// 1e5 over 150 changes of contact here, empirical.
STICKSLIP_VERIFIES(Drives, "A14");
TEST(Drives, OfOneSineAreThatSine) {
  for (const double damping : {0.0, 2e-3})
    for (const double amplitude : {1e-4, 3e-3}) {
      data::Case problem = damped_case(damping);
      problem.motion =
          data::HarmonicExcitation({.frequency_hz = 23.0, .amplitude = amplitude, .amplitude_of = {}});
      const data::Case sum = moved_by(
          problem, Sine{.frequency_hz = 23.0, .amplitude = amplitude, .amplitude_of = {}, .phase = 0.0});
      EventDriven expected(analytic::contact_model(problem, 20)), found(analytic::contact_model(sum, 20));
      const double growth = damping == 0.0 && amplitude > 1e-3 ? 1e5 : 1.0;
      for (int i = 1; i <= 50; ++i) {
        const double t = 0.3 * i / 50.0;
        expected.advance_to(t);
        found.advance_to(t);
        constexpr double size = 100.0;  // of the largest force of the first run, N
        EXPECT_TRUE(within(found.friction_force(), expected.friction_force(),
                           reference(1e-12 * size * growth, "pieces of a sine, empirical")))
            << t;
      }
      ASSERT_EQ(found.events().size(), expected.events().size());
      EXPECT_EQ(found.events().empty(), amplitude < 1e-3);
    }
}

// As a record with 29 and 500 samples a period, of each quantity: the cubic spline misses (2 pi/29)^4/384 of the quantity, and what it
// is differentiated to more: 1e-4 is asked of a velocity and an acceleration, 1e-7 of all with 500.
TEST(Drives, OfARecordedSineAreThatSine) {
  constexpr double hz = 35.0, amplitude = 5e-4, omega = 2.0 * pi * hz;
  const data::Case problem = damped_case(2e-4);
  const Sine sine{.frequency_hz = hz, .amplitude = amplitude, .amplitude_of = {}, .phase = 0.0};
  const double expected = reaction_of(moved_by(problem, sine)).largest().midpoint();
  for (const int samples : {29, 500})
    for (const auto kind : {AmplitudeOf::displacement, AmplitudeOf::velocity, AmplitudeOf::acceleration}) {
      data::MotionRecord record;
      record.quantity = kind;
      record.step = 1.0 / (hz * samples);
      const int derivative = data::derivatives(kind);
      for (double t = 0.0; t < problem.numerics.duration() + record.step; t += record.step)
        record.samples.push_back(amplitude * std::pow(omega, derivative) *
                                 std::sin(omega * static_cast<double>(record.samples.size()) * record.step +
                                          0.5 * pi * derivative));
      if (derivative > 0) record.initial_displacement = 0.0;
      if (derivative > 1) record.initial_velocity = amplitude * omega;
      data::Case recorded = problem;
      recorded.motion = GeneralMotion(record, 0.0).lasting(problem.numerics.duration());
      const double found = reaction_of(recorded).largest().midpoint();
      const double share = samples == 500 ? 1e-7 : kind == AmplitudeOf::displacement ? 2e-2 : 1e-4;
      EXPECT_TRUE(within(found, expected, reference(share * expected, "the accuracy asked for")))
          << samples << " samples, derivative " << derivative;
    }
}

// The bounds hold the largest of |f| of one sine, which another search over other formulas has found.
TEST(Drives, HoldTheLargestForceOfASine) {
  for (const double hz : {5.0, 35.0, 120.0}) {
    data::Case problem = damped_case(2e-4);
    problem.motion = data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1e-3, .amplitude_of = {}});
    const analytic::Bounds expected = 1e-3 * analytic::StickReaction(problem, 40).largest(),
                           found = reaction_of(moved_by(problem, Sine{.frequency_hz = hz,
                                                                      .amplitude = 1e-3,
                                                                      .amplitude_of = {},
                                                                      .phase = 0.0}))
                                       .largest();
    EXPECT_LE(found.lower, expected.upper) << hz;
    EXPECT_GE(found.upper, expected.lower) << hz;
    EXPECT_LE(found.upper - found.lower, 0.05 * expected.upper) << hz;
  }
}

// On random structures, with jumps of the acceleration at the start.
TEST(Drives, AddUp) {
  on_random_structures(12, {.damping = 1.0}, [](const auto& matrices, RandomNumbers& numbers) {
    const data::Case problem = with_matrices(damped_case(0.0), matrices);
    std::vector<Sine> sines;
    for (int i = 0; i < 3; ++i)
      sines.push_back({.frequency_hz = numbers.log_uniform(1.0, 60.0),
                       .amplitude = numbers.log_uniform(0.1, 10.0),
                       .amplitude_of = AmplitudeOf::acceleration,
                       .phase = numbers.uniform(0.0, 2.0 * pi)});
    const data::Case all = moved_by(problem, sines);
    for (int i = 0; i < 5; ++i) {
      const double t = numbers.uniform(0.0, 0.5);
      double sum = 0.0, size = 0.0;
      for (const Sine& sine : sines) {
        sum += force_at(moved_by(problem, sine), t);
        size += reaction_of(moved_by(problem, sine)).largest().upper;
      }
      EXPECT_TRUE(within(force_at(all, t), sum, reference(1e-10 * size, "rounding, empirical"))) << t;
    }
  });
}

// By superposition: what each of three sines, in bands of their own, does at the time of the largest force, which is further
// than the window from the start and the end. Hann's window leaks less than a thousandth a third of the lowest edge away.
TEST(Drives, HaveTheBandsOfTheirSines) {
  data::Case problem = with_value(damped_case(0.0), "excitation.duration", 20.0);
  problem.damping = data::Damping({.ratio = 0.1});
  const std::vector<Sine> sines{{2.83, 1.0, AmplitudeOf::acceleration, 0.0},
                                {12.1, 2.0, AmplitudeOf::acceleration, 0.0},
                                {46.1, 4.0, AmplitudeOf::acceleration, 0.0}};
  const auto found = reaction_of(moved_by(problem, sines));
  const double size = found.of_modes.midpoint(),
               sign = force_at(moved_by(problem, sines), found.time) < 0.0 ? -1.0 : 1.0;
  ASSERT_LT(std::abs(found.time - 10.0), 6.0);
  double sum = 0.0;
  for (const auto& [from, to, force] : found.bands) {
    double expected = 0.0;
    for (const Sine& sine : sines)
      if (from < sine.frequency_hz && sine.frequency_hz < to)
        expected += sign * force_at(moved_by(problem, sine), found.time);
    EXPECT_TRUE(within(force, expected, reference(1e-3 * size, "the leak"))) << from;
    sum += force;
  }
  EXPECT_EQ(found.bands.size(), 8U);
  EXPECT_TRUE(within(sum, size, reference(1e-7 * size, "the bounds of the largest force")));
}

// With the difference of the forces of few modes and of all at random times: a base at rest or not at the start, a wall at rest or on it.
TEST(Drives, BoundWhatModesLeftOutChange) {
  int compared = 0;
  on_random_structures(
      24, {.fewest_rows = 8, .most_rows = 30}, [&](const auto& matrices, RandomNumbers& numbers) {
        data::Case problem = with_matrices(damped_case(numbers.whole(0, 1) == 0 ? 0.0 : 1e-4), matrices);
        problem.contact.wall = data::Wall({.with_base = numbers.whole(0, 1) == 0});
        const double jump = numbers.whole(0, 1) == 0 ? 0.0 : numbers.uniform(0.0, 2.0 * pi);
        problem = moved_by(problem, std::vector<Sine>{{3.0, 1.0, AmplitudeOf::acceleration, jump},
                                                      {numbers.log_uniform(4.0, 20.0), 1.0,
                                                       AmplitudeOf::acceleration, 0.0}});
        HeldMotion all(analytic::contact_model(problem, 200));
        std::vector<double> times, exact;
        for (int i = 1; i <= 60; ++i) {
          times.push_back(problem.numerics.duration() * std::pow(i / 60.0, 3));
          exact.push_back(all.force(times.back()));
        }
        for (const int modes : {3, 6}) {
          const auto found = analytic::motion_reaction(problem, modes);
          HeldMotion few(analytic::contact_model(problem, modes));
          for (std::size_t i = 0; i < times.size(); ++i)
            EXPECT_LE(std::abs(few.force(times[i]) - exact[i]), found.omitted + 1e-7 * found.of_modes.upper)
                << times[i];
          ++compared;
        }
      });
  EXPECT_EQ(compared, 48);
}

// One held mode, m T_tt + k T, under a half-sine of the base's acceleration on a wall that moves with it: with s = pi/(D w)
//
//     T = -A L/(w² (1 - s²)) (sin(pi t/D) - s sin(w t))   up to D, a free vibration then.
TEST(Drives, OfAShockHaveItsFormula) {
  constexpr double mass = 2.0, stiffness = 8e3, contact = 3e3, shock_length = 0.011, peak = 30.0;
  data::Case problem = damped_case(0.0);
  // Base, a mass, and the contact without mass, which sees the spring to the mass alone.
  problem = with_matrices(problem, {.rows = 3,
                                    .mass = {{1, 1, mass}},
                                    .stiffness = {{0, 0, stiffness},
                                                  {0, 1, -stiffness},
                                                  {1, 0, -stiffness},
                                                  {1, 1, stiffness + contact},
                                                  {1, 2, -contact},
                                                  {2, 1, -contact},
                                                  {2, 2, contact}},
                                    .damping = {},
                                    .base = {0},
                                    .fixed = {},
                                    .contact = {{2}},
                                    .load = {},
                                    .files = {}});
  problem.contact.wall = data::Wall({.with_base = true});
  problem = moved_by(problem, data::Shock{.shape = data::ShockShape::half_sine,
                                          .duration = shock_length,
                                          .amplitude = peak,
                                          .amplitude_of = AmplitudeOf::acceleration});
  const double omega = std::sqrt((stiffness + contact) / mass), ratio = pi / (shock_length * omega);
  const double unit = -peak / (omega * omega * (1.0 - ratio * ratio));
  const auto during = [&](double t) {
    return unit * (std::sin(pi * t / shock_length) - ratio * std::sin(omega * t));
  };
  const auto rate = [&](double t) {
    return unit * pi / shock_length * (std::cos(pi * t / shock_length) - std::cos(omega * t));
  };
  for (const double t : {0.002, 0.0055, 0.0109, 0.012, 0.03, 0.2}) {
    const double after = t - shock_length;
    const double moved = after <= 0.0 ? during(t)
                                      : during(shock_length) * std::cos(omega * after) +
                                            rate(shock_length) / omega * std::sin(omega * after);
    EXPECT_TRUE(within(force_at(problem, t), -contact * moved, round_off(1e5, 1, contact * std::abs(unit))))
        << t;
  }
}

}  // namespace
}  // namespace stickslip::testing
