// SPDX-License-Identifier: MIT
/// The boundary integral equation of a contact: its weights and its steps. contact_battery_test.cpp has its histories.

#include <Eigen/Dense>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::ContactLaw;
using analytic::ContactStep;
using Complex = std::complex<double>;
using std::numbers::pi;

/// What mobility_weights() states, 1e-11 max |W|, ten times.
Tolerance of_weights(double largest) { return reference(1e-10 * largest, "mobility_weights()"); }

std::vector<double> noise(std::size_t count) {
  RandomNumbers numbers(7);
  std::vector<double> values(count);
  for (double& value : values) value = numbers.uniform(-1.0, 1.0);
  return values;
}

class GaussStages : public ::testing::TestWithParam<int> {};

STICKSLIP_VERIFIES(GaussStages, "D4");
TEST_P(GaussStages, FollowAFreeMassExactly) {
  // Under a constant force the velocity is linear in time: mean h/(2m) in the step of a unit force, then h/m.
  const double mass = 3.0, h = 0.01;
  const auto weights =
      analytic::mobility_weights([&](Complex s) { return 1.0 / (mass * s); }, h, 300, GetParam());
  ASSERT_EQ(weights.size(), 300u);
  for (std::size_t j = 0; j < weights.size(); ++j)
    ASSERT_TRUE(within(weights[j], (j == 0 ? 0.5 : 1.0) * h / mass, of_weights(h / mass))) << j;
}

TEST_P(GaussStages, HaveThePhaseErrorOfPade) {
  // With a = omega h the exact weights are 2 (1 - cos a) cos(j a)/(omega^2 h). The approximant (k, k) of
  // exp(x) is off by (k!)^2/((2k)! (2k+1)!) x^(2k+1), which turns each step by as much with x = a. After 100
  // rad that is 100 a^2k of this constant, next to which the error of the amplitudes, a^2k of the same
  // constant, is 1 %, and the next term a^2/20.
  struct Level {
    double angle, phase_constant;
  };
  const Level level =
      std::vector<Level>{{0.1, 1.0 / 12.0},
                         {0.5, 1.0 / 720.0},
                         {1.0, 1.0 / 100800.0},
                         {1.5, 576.0 / (40320.0 * 362880.0)}}[static_cast<std::size_t>(GetParam() - 1)];
  const double a = level.angle, omega = 2.0, h = a / omega;
  const auto count = static_cast<std::size_t>(100.0 / a) + 1;
  const auto weights = analytic::mobility_weights([&](Complex s) { return s / (s * s + omega * omega); }, h,
                                                  count, GetParam());
  const double scale = 2.0 * (1.0 - std::cos(a)) / (omega * omega * h);
  double largest = 0.0;  // over the last turn, where the phase error is that of 100 rad
  for (auto j = static_cast<std::size_t>((100.0 - 2.0 * pi) / a); j < count; ++j)
    largest = largest_or_nan({largest, std::abs(weights[j] / scale - std::cos(a * static_cast<double>(j)))});
  const double predicted = 100.0 * level.phase_constant * std::pow(a, 2 * GetParam());
  EXPECT_TRUE(within(largest, predicted,
                     discretisation((0.02 + 2.0 * pi / 100.0 + a * a / 20.0) * predicted, 1.0,
                                    "amplitude, where in the last turn, next term")));
}

TEST_P(GaussStages, ArePowersOfTheMobility) {
  const analytic::TipMobility mobility(paper_beam());
  const double h = 1e-4;
  const Complex zeta = std::polar(0.9, 0.7);
  const auto weights = analytic::mobility_weights(mobility, h, 400, GetParam());  // 0.9^400 = 5e-19
  Complex sum = 0.0, power = 1.0;
  for (const double weight : weights) {
    sum += weight * power;
    power *= zeta;
  }
  const Complex expected = analytic::discrete_mobility(mobility, h, GetParam(), zeta);
  EXPECT_TRUE(within(sum, expected, of_weights(10.0 * weights.front())));  // sum |zeta|^j = 10
}

INSTANTIATE_TEST_SUITE_P(Stages, GaussStages, ::testing::Values(1, 2, 3, 4));

STICKSLIP_VERIFIES(BoundaryIntegral, "D4");
TEST(BoundaryIntegral, ConvolvesAsItsSumsDo) {
  // Over more than eight blocks of 128 and a length that is no power of two; sums of 1500 terms up to 1.
  const auto weights = noise(1500);
  auto values = noise(1499);
  std::ranges::reverse(values);
  const auto at_once = analytic::convolution(weights, values);
  // A contact without normal force answers the holding forces alone.
  const auto steps = analytic::contact_steps(weights, {}, values);
  const Tolerance tolerance = round_off(11, 1.0, 40.0);  // log2 of the length; sqrt(1500) terms
  for (std::size_t n = 0; n < values.size(); ++n) {
    double sum = 0.0;
    for (std::size_t j = 0; j <= n; ++j) sum += weights[n - j] * values[j];
    ASSERT_TRUE(within(-steps[n].sliding_velocity, sum, tolerance)) << n;
    ASSERT_TRUE(within(at_once[n], sum, tolerance)) << n;
  }
}

TEST(BoundaryIntegral, FindsTheOnlySolutionOfAStep) {
  // kappa W = 0.3 * 500 * 2e-3 = 0.3.
  const ContactLaw law{500.0, paper_friction()};
  const double weight = 2e-3, limit = 300.0;
  for (const double free_velocity :
       {-3.0, -0.7, -0.6000001, -0.6, -0.1, 0.0, 0.3, 0.6, 0.6000001, 0.61, 5.0}) {
    const ContactStep step = analytic::solve_contact(law, free_velocity, weight);
    const double speed = std::abs(step.sliding_velocity);
    EXPECT_TRUE(
        within(step.sliding_velocity, free_velocity + weight * step.friction_force, round_off(4, 1.5, 5.0)));
    EXPECT_EQ(step.slides, std::abs(free_velocity) > weight * limit);
    if (!step.slides) {
      EXPECT_EQ(step.sliding_velocity, 0.0);
    } else {
      EXPECT_GT(step.sliding_velocity * free_velocity, 0.0);
      EXPECT_TRUE(within(-std::copysign(1.0, free_velocity) * step.friction_force,
                         500.0 * (0.3 + 0.3 * std::exp(-speed)), round_off(4, 1.0, 300.0)));
    }
  }
}

TEST(BoundaryIntegral, RefusesSeveralSolutions) {
  const ContactLaw law{500.0, paper_friction()};  // kappa = 150 N s/m
  EXPECT_NO_THROW(analytic::require_unique_step(law, 0.999 / 150.0));
  EXPECT_THROW(analytic::require_unique_step(law, 1.001 / 150.0), std::invalid_argument);
  EXPECT_THROW((void)analytic::contact_steps({0.1, 0.1}, law, {1.0}), std::invalid_argument);
  EXPECT_THROW(analytic::FreeModeRun({{0.0, 1.0}}, law, 1.0), std::invalid_argument);
  const ContactLaw exact{512.0, data::FrictionLaw({0.75, 0.25, 1.0})};  // kappa = 256 N s/m
  EXPECT_THROW(analytic::require_unique_step(exact, 0x1p-8), data::InputError);
  ContactLaw on_a_spring = law;
  on_a_spring.tangential = data::TangentialContact({.tangential_stiffness = 1e6});
  EXPECT_THROW(analytic::require_unique_step(on_a_spring, 1e-4), data::FieldError);
  on_a_spring.time_step = 1e-5;
  EXPECT_NO_THROW(analytic::require_unique_step(on_a_spring, 1e-4));
}

TEST(BoundaryIntegral, RefusesUnusableSteps) {
  const auto mass = [](Complex s) { return 1.0 / s; };
  EXPECT_THROW((void)analytic::mobility_weights(mass, 0.0, 1, 2), data::FieldError);
  EXPECT_THROW((void)analytic::discrete_mobility(mass, 0.0, 2, 0.5), data::FieldError);
  EXPECT_THROW(analytic::FreeModeRun({{0.0, 1.0}}, {}, 0.0), data::FieldError);
  EXPECT_THROW((void)analytic::mobility_weights(mass, 0.1, 0, 2), std::invalid_argument);
  EXPECT_THROW((void)analytic::contact_steps({1.0, 2.0}, {}, {1.0, 1.0, 1.0}), std::invalid_argument);
  EXPECT_EQ(analytic::mobility_weights(mass, 0.1, 1, 2).size(), 1u);
  for (const int stages : {0, analytic::most_stages + 1})
    EXPECT_THROW((void)analytic::mobility_weights(mass, 0.1, 1, stages), std::invalid_argument) << stages;
}

}  // namespace
}  // namespace stickslip::testing
