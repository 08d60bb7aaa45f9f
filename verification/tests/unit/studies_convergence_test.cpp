/// Observed orders and their confidence intervals.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "stickslip/studies/convergence.hpp"
#include "support/order.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using studies::order_estimate;
using studies::OrderEstimate;

const std::vector<double> halved{1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125};

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

TEST(OrderEstimate, CoversTheOrderNinetyFiveTimesInAHundred) {
  // Normal noise of two sizes: the width must follow it. The count of hits is binomial; four of its standard
  // deviations leave a chance of 6e-5 to miss, and the seed is fixed.
  std::mt19937_64 generator(20180219);
  for (const double deviation : {0.3, 0.01}) {
    std::normal_distribution<double> noise(0.0, deviation);
    constexpr int trials = 20000;
    int hits = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> errors;
      for (const double step : halved) errors.push_back(std::pow(step, 2) * std::exp(noise(generator)));
      const OrderEstimate estimate = order_estimate(halved, errors);
      if (std::abs(estimate.order - 2.0) <= estimate.half_width) ++hits;
    }
    EXPECT_NEAR(hits / double(trials), 0.95, 4.0 * std::sqrt(0.95 * 0.05 / trials)) << deviation;
  }
}

TEST(OrderEstimate, NeedsPositiveLevelsInPairs) {
  EXPECT_THROW((void)order_estimate({1.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW((void)order_estimate({1.0, 2.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW((void)order_estimate({1.0, 2.0}, {1.0, 0.0}), std::invalid_argument);
}

TEST(OrderBound, HoldsWhateverTheSignsOfTheNextTerms) {
  // All 64 choices of sign of c_i = 0.4 h_i: one of them reaches the bound but for ln(1 + c) < -ln(1 - c).
  std::vector<double> next_terms;
  for (const double step : halved) next_terms.push_back(0.4 * step);
  double largest = 0.0;
  for (unsigned signs = 0; signs < 64; ++signs) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < halved.size(); ++i)
      errors.push_back(std::pow(halved[i], 3) * (1.0 + ((signs >> i & 1U) ? 1 : -1) * next_terms[i]));
    const OrderEstimate estimate = order_estimate(halved, errors);
    EXPECT_TRUE(order_is(estimate, 3.0, halved, next_terms)) << signs;
    largest = std::max(largest, std::abs(estimate.order - 3.0));
  }
  EXPECT_GT(largest, 0.8 * order_bound(halved, next_terms).slope);
  EXPECT_FALSE(
      order_is(order_estimate(halved, {1.0, 0.3, 0.09, 0.027, 0.0081, 0.00243}), 3.0, halved, next_terms));
}

}  // namespace
}  // namespace stickslip::testing
