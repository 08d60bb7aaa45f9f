#pragma once

/// How far an observed order may be from the theoretical one.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <vector>

#include "stickslip/studies/convergence.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

/// What the terms behind the leading one can do to an order. Let error i be C h_i^p (1 + c_i), |c_i| <=
/// next_terms[i] < 1, so that its logarithm is off the line by d_i <= -ln(1 - next_terms[i]). The slope is a
/// weighted sum of the logarithms and off by
///
///     sum |x_i - mean x| d_i / S,   S = sum (x_i - mean x)^2,   x = ln h,
///
/// at most. The residuals of the regression have at most the square sum of the d_i. Both hold for steps in
/// any order.
struct OrderBound {
  double slope{};             ///< of |order - p|
  double residual_squares{};  ///< of the square sum of the residuals
  double spread{};            ///< S
};

inline OrderBound order_bound(const std::vector<double>& steps, const std::vector<double>& next_terms) {
  std::vector<double> x;
  for (const double step : steps) x.push_back(std::log(step));
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  OrderBound bound;
  for (const double value : x) bound.spread += (value - mean) * (value - mean);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = -std::log1p(-next_terms[i]);
    bound.slope += std::abs(x[i] - mean) * off / bound.spread;
    bound.residual_squares += off * off;
  }
  return bound;
}

/// The order is `predicted` to within what `next_terms` allow, on both sides, and so is its half width.
inline ::testing::AssertionResult order_is(const studies::OrderEstimate& estimate, double predicted,
                                           const std::vector<double>& steps,
                                           const std::vector<double>& next_terms) {
  const OrderBound bound = order_bound(steps, next_terms);
  // Student's t for 95 % is largest with one degree of freedom, 12.7; no need to be sharper for more.
  constexpr double largest_quantile = 12.7062;
  const double half_width =
      estimate.levels > 2
          ? largest_quantile * std::sqrt(bound.residual_squares / (estimate.levels - 2) / bound.spread)
          : INFINITY;
  const bool is_near = static_cast<bool>(within(
      estimate.order, predicted, discretisation(bound.slope, 1.0, "what the next terms do to the slope")));
  std::ostringstream text;
  text << "order " << estimate.order << " -+ " << estimate.half_width << " of " << estimate.levels
       << " levels; predicted " << predicted << " to " << bound.slope << ", half width up to " << half_width;
  const bool holds = is_near && estimate.half_width <= half_width;
  return (holds ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << text.str();
}

}  // namespace stickslip::testing
