// SPDX-License-Identifier: MIT
/// Observed orders and their confidence intervals.

#include "studies/common/convergence.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using studies::order_estimate;
using studies::OrderEstimate;

const std::vector<double> halved{1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125};

STICKSLIP_VERIFIES(OrderEstimate, "X13");
TEST(OrderEstimate, OfAPowerLawHasNoWidth) {
  for (const double order : {0.5, 1.0, 2.0, 4.0}) {
    std::vector<double> errors;
    for (const double step : halved) errors.push_back(3.0 * std::pow(step, order));
    const OrderEstimate estimate = order_estimate(halved, errors);
    EXPECT_EQ(estimate.levels, 6);
    // Logarithms up to 4 ln 32 = 14, their sums of six terms; t = 2.8 for 4 degrees of freedom.
    EXPECT_TRUE(within(estimate.order, order, round_off(20, 1, 14)));
    EXPECT_TRUE(within(estimate.half_width, 0.0, round_off(20, 3, 14)));
  }
}

TEST(OrderEstimate, OfFourPointsIsTheOneByHand) {
  // In units of ln 2: x = 0, 1, 2, 3 and y = 0, 1, 3, 4. Slope 7/5, residuals' squares 10 - 49/5 = 1/5, so
  // that the slope has a standard error of sqrt(1/5/2/5). Student's t for two degrees of freedom is
  // 0.95 sqrt(2/(1 - 0.95^2)).
  const OrderEstimate estimate = order_estimate({1.0, 2.0, 4.0, 8.0}, {1.0, 2.0, 8.0, 16.0});
  const double quantile = 0.95 * std::sqrt(2.0 / (1.0 - 0.95 * 0.95));
  EXPECT_TRUE(within(estimate.order, 1.4, round_off(20, 1, 1.4)));
  EXPECT_TRUE(within(estimate.half_width, quantile * std::sqrt(0.02),
                     reference(1e-10, "gsl_cdf_tdist_Pinv with two degrees of freedom")));
}

TEST(OrderEstimate, OfTwoLevelsKnowsNoWidth) {
  const OrderEstimate estimate = order_estimate({1.0, 2.0}, {1.0, 4.0});
  EXPECT_TRUE(within(estimate.order, 2.0, round_off(10, 1, 2)));
  EXPECT_EQ(estimate.half_width, std::numeric_limits<double>::infinity());
  EXPECT_EQ(estimate.levels, 2);
}

TEST(OrderEstimate, NeedsPositiveLevelsInPairs) {
  EXPECT_THROW((void)order_estimate({1.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW((void)order_estimate({1.0, 2.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW((void)order_estimate({1.0, 2.0}, {1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW((void)order_estimate({1.0, 0.0}, {1.0, 2.0}), std::invalid_argument);
}

// Levels h^3 (1 + c_i) with |c_i| <= 0.2 h_i; the lowest bits of `signs` say which c_i are positive.
std::vector<OrderLevel> cubic_levels(unsigned signs) {
  std::vector<OrderLevel> levels;
  for (std::size_t i = 0; i < halved.size(); ++i) {
    const double next_term = 0.2 * halved[i];
    const double sign = (signs >> i & 1U) != 0U ? 1.0 : -1.0;
    levels.push_back({.step = halved[i],
                      .error = std::pow(halved[i], 3) * (1.0 + sign * next_term),
                      .next_term = next_term,
                      .floor = 1e-16});
  }
  return levels;
}

// That the failure is the one meant: its message holds `reason`.
::testing::AssertionResult fails_because(const ::testing::AssertionResult& result,
                                         const std::string& reason) {
  const std::string message = result.message();
  if (!result && message.find(reason) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << (result ? "holds: " : "fails otherwise: ") << message;
}

STICKSLIP_VERIFIES(OrderBound, "X13");
TEST(OrderBound, HoldsForAnyNextTerms) {
  // One of all 64 choices of sign reaches the bound but for ln(1 + c) < -ln(1 - c).
  double largest = 0.0;
  for (unsigned signs = 0; signs < 64; ++signs) {
    const std::vector<OrderLevel> levels = cubic_levels(signs);
    EXPECT_TRUE(order_is(levels, 3.0, 1.0)) << signs;
    std::vector<double> errors;
    for (const OrderLevel& level : levels) errors.push_back(level.error);
    largest = largest_or_nan({largest, std::abs(studies::observed_order(halved, errors) - 3.0)});
  }
  EXPECT_GT(largest, 0.8 * order_bound(cubic_levels(0)).slope);
  EXPECT_LT(order_bound(cubic_levels(0)).slope, 0.1);
}

TEST(OrderBound, OfFourLevelsIsTheOneByHand) {
  // Steps 8, 4, 2, 1: x off its mean by (3, 1, 1, 3)/2 ln 2, S = 5 (ln 2)^2. Each logarithm is off by ln 2
  // with a next term of a half, or of a quarter beside a floor of a quarter of the error.
  const double ln2 = std::log(2.0);
  const std::vector<OrderLevel> levels{
      {8.0, 1.0, 0.5, 0.0}, {4.0, 1.0, 0.25, 0.25}, {2.0, 4.0, 0.25, 1.0}, {1.0, 1.0, 0.5, 0.0}};
  const OrderBound bound = order_bound(levels);
  EXPECT_TRUE(within(bound.spread, 5.0 * ln2 * ln2, round_off(10, 1, 3)));
  EXPECT_TRUE(within(bound.slope, 4.0 / 5.0, round_off(10, 1, 1)));
  EXPECT_TRUE(within(bound.residual_squares, 4.0 * ln2 * ln2, round_off(10, 1, 2)));
  ASSERT_EQ(bound.local.size(), 3u);
  for (const double local : bound.local) EXPECT_TRUE(within(local, 2.0, round_off(10, 1, 2)));

  // A scatter of 1/10 alone: 3/10 of 1/sqrt(S) in the slope, 3/10 sqrt(2)/ln 2 between neighbours.
  const OrderBound scattered = order_bound(
      {{8.0, 1.0, 0, 0, 0.1}, {4.0, 1.0, 0, 0, 0.1}, {2.0, 1.0, 0, 0, 0.1}, {1.0, 1.0, 0, 0, 0.1}});
  EXPECT_TRUE(within(scattered.slope, 0.3 / (std::sqrt(5.0) * ln2), round_off(10, 1, 1)));
  EXPECT_TRUE(within(scattered.residual_squares, 4.0 * 0.09, round_off(10, 1, 1)));
  for (const double local : scattered.local)
    EXPECT_TRUE(within(local, 0.3 * std::sqrt(2.0) / ln2, round_off(10, 1, 1)));
}

// Pure powers h^order, with the next terms of cubic_levels().
std::vector<OrderLevel> pure_levels(double order) {
  std::vector<OrderLevel> levels = cubic_levels(0);
  for (OrderLevel& level : levels) level.error = std::pow(level.step, order);
  return levels;
}

STICKSLIP_VERIFIES(OrderCriterion, "X13");
TEST(OrderCriterion, RefusesWhatShowsNoOrder) {
  const auto changed = [](std::vector<OrderLevel> levels, const auto& change) {
    change(levels);
    return levels;
  };
  const auto error_of_third = [&](double error) {
    return changed(cubic_levels(0), [=](auto& levels) { levels[2].error = error; });
  };
  // Within a factor of 1.3 the next terms may do anything to the slope.
  const std::vector<OrderLevel> near{
      {1.3, 2.197, 0.2, 0.0}, {1.2, 1.728, 0.2, 0.0}, {1.1, 1.331, 0.2, 0.0}, {1.0, 1.0, 0.2, 0.0}};
  const std::pair<std::vector<OrderLevel>, const char*> rows[] = {
      // 0.1 too flat and too steep, where the next terms allow 0.07 to the slope.
      {pure_levels(2.9), "predicted 3 to"},
      {pure_levels(3.1), "predicted 3 to"},
      {changed(cubic_levels(0), [](auto& levels) { levels.resize(3); }),
       "3 levels; an order needs at least 4"},
      // The next term may be as large as the leading one, or local orders are off by 0.08, though that through all is not.
      {changed(cubic_levels(0), [](auto& levels) { levels.front().next_term = 0.6; }), "not asymptotic"},
      {changed(pure_levels(3.0), [](auto& levels) { levels[4].error *= 1.06; }),
       "the order between h = 0.125 and 0.0625"},
      {changed(cubic_levels(0), [](auto& levels) { levels.back().floor = levels.back().error / 19.0; }),
       "is less than 20 times its floor"},
      {error_of_third(0.0), "times its floor"},
      {error_of_third(-1.0), "times its floor"},
      {error_of_third(std::nan("")), "times its floor"},
      {near, "tell the order only to"},
      // Off the line to and fro by four times what each level is allowed.
      {changed(cubic_levels(0b101010),
               [](auto& levels) {
                 for (OrderLevel& level : levels) {
                   const double leading = std::pow(level.step, 3);
                   level.error = leading * std::pow(level.error / leading, 4);
                 }
               }),
       ""}};
  for (const auto& [levels, reason] : rows)
    EXPECT_TRUE(fails_because(order_is(levels, 3.0), reason)) << reason;
}

TEST(OrderCriterion, AcceptsWhatItsLimitsAllow) {
  for (const double order : {2.9, 3.1}) EXPECT_TRUE(order_is(pure_levels(order), order));
  std::vector<OrderLevel> levels = cubic_levels(0);
  levels.resize(4);
  EXPECT_TRUE(order_is(levels, 3.0));
  levels.back().floor = levels.back().error / 21.0;
  EXPECT_TRUE(order_is(levels, 3.0));
  EXPECT_TRUE(order_is(cubic_levels(63), 3.0, 1.0));
  for (const double constant : {1.02, 0.98})
    EXPECT_TRUE(fails_because(order_is(cubic_levels(63), 3.0, constant), "leading term at h ="));
}

STICKSLIP_VERIFIES(LargestDifference, "X13");
TEST(LargestDifference, IsNanIfADifferenceIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(studies::largest_or_nan({-3.0, -1.0, -2.0}), -1.0);
  EXPECT_EQ(studies::largest_difference({1.0, 2.0, 5.0}, {1.5, 2.0, 5.25}), 0.5);
  for (const std::size_t place : {0U, 1U, 2U}) {
    std::vector<double> values{1.0, 2.0, 3.0};
    values[place] = nan;
    EXPECT_TRUE(std::isnan(studies::largest_difference(values, {1.0, 2.0, 3.0}))) << place;
    EXPECT_TRUE(std::isnan(studies::largest_or_nan({values[0], values[1], values[2]}))) << place;
  }
}

}  // namespace
}  // namespace stickslip::testing
