// SPDX-License-Identifier: MIT
#pragma once

/// Orders of convergence: what a sequence of errors has to show before its slope is believed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <sstream>
#include <vector>

#include "studies/common/convergence.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

/// One error of a convergent sequence, and what theory says of it besides the leading term:
///
///     error = C h^p (1 + c) (1 + s) + r,
///     |c| <= next_term,   s of standard deviation scatter,   |r| <= floor
struct OrderLevel {
  double step{};       ///< h
  double error{};      ///< above 0
  double next_term{};  ///< of the terms behind the leading one, relative to it
  double floor{};      ///< of round-off, or of the reference's own error, absolute
  double scatter{};    ///< where the error is not smooth in h, independent from level to level; else 0
};

/// A level whose next term may be larger than this is outside the asymptotic range.
inline constexpr double largest_next_term = 0.5;
/// An error must be so many times its floor: below, it says as much about round-off as about the method.
inline constexpr double least_distance_from_floor = 20.0;
/// Of a scatter, as many standard deviations count.
inline constexpr double deviations = 3.0;

/// What next terms, floor and scatter can do to the logarithms of errors and to the slope through them. The
/// logarithm of level i is off the line by d_i <= -ln(1 - next_term - floor/error) and by its scatter s_i.
/// The slope is a weighted sum of the logarithms and off by
///
///     sum |x_i - mean x| d_i / S + 3 sqrt(sum (x_i - mean x)^2 s_i^2)/S,   S = sum (x_i - mean x)^2,
///
/// x = ln h, at most; that through two neighbours alone by [d_i + d_j + 3 sqrt(s_i^2 + s_j^2)]/|x_i - x_j|.
/// The residuals of the regression have at most the square sum of the d_i + 3 s_i. All hold for steps in any
/// order.
struct OrderBound {
  double slope{};             ///< of |order - p|
  double residual_squares{};  ///< of the square sum of the residuals
  double spread{};            ///< S
  std::vector<double> local;  ///< of |local order - p|, one between each level and the next
};

inline OrderBound order_bound(const std::vector<OrderLevel>& levels) {
  std::vector<double> x, off;
  for (const OrderLevel& level : levels) {
    x.push_back(std::log(level.step));
    off.push_back(-std::log1p(-level.next_term - level.floor / level.error));
  }
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  OrderBound bound;
  double scatter = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    bound.spread += std::pow(x[i] - mean, 2);
    bound.slope += std::abs(x[i] - mean) * off[i];
    scatter += std::pow((x[i] - mean) * levels[i].scatter, 2);
    bound.residual_squares += std::pow(off[i] + deviations * levels[i].scatter, 2);
    if (i > 0)
      bound.local.push_back(
          (off[i - 1] + off[i] + deviations * std::hypot(levels[i - 1].scatter, levels[i].scatter)) /
          std::abs(x[i] - x[i - 1]));
  }
  bound.slope = (bound.slope + deviations * std::sqrt(scatter)) / bound.spread;
  return bound;
}

/// Levels from columns, with the next term as a function of the step; floor and scatter are the same for all.
template <typename NextTerm>
std::vector<OrderLevel> order_levels(const std::vector<double>& steps, const std::vector<double>& errors,
                                     NextTerm&& next_term, double floor, double scatter = 0.0) {
  std::vector<OrderLevel> levels;
  for (std::size_t i = 0; i < steps.size(); ++i)
    levels.push_back({steps[i], errors.at(i), next_term(steps[i]), floor, scatter});
  return levels;
}

/// The errors fall with the order `predicted`, and, if given, as `constant` * h^predicted:
///
///   - at least four levels;
///   - each at least 20 times its floor, its next term at most a half: the test fails for a level that is not, and does
///     not leave it out;
///   - each local order, between neighbours, is the predicted one to within what their next terms allow: the
///     levels are in the asymptotic range;
///   - the slope through all levels is the predicted one to within what the next terms allow, on both sides,
///     which must be less than half an order; its half width is no larger than they make it;
///   - each error is constant * h^predicted to within next term, scatter and floor.
inline ::testing::AssertionResult order_is(const std::vector<OrderLevel>& levels, double predicted,
                                           std::optional<double> constant = std::nullopt) {
  std::ostringstream text;
  const auto failure = [&text] { return ::testing::AssertionFailure() << text.str(); };
  if (levels.size() < 4) {
    text << levels.size() << " levels; an order needs at least 4";
    return failure();
  }
  std::vector<double> steps, errors;
  for (const OrderLevel& level : levels) {
    if (!(level.error >= least_distance_from_floor * level.floor && level.error > 0.0))
      text << "the error " << level.error << " at h = " << level.step << " is less than "
           << least_distance_from_floor << " times its floor " << level.floor << "\n";
    if (!(level.next_term <= largest_next_term))
      text << "the next term at h = " << level.step << " may be " << level.next_term
           << " of the leading one: not asymptotic\n";
    steps.push_back(level.step);
    errors.push_back(level.error);
  }
  if (!text.str().empty()) return failure();

  const OrderBound bound = order_bound(levels);
  bool holds = true;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const double local = std::log(errors[i] / errors[i - 1]) / std::log(steps[i] / steps[i - 1]);
    if (std::abs(local - predicted) <= bound.local[i - 1]) continue;
    holds = false;
    text << "the order between h = " << steps[i - 1] << " and " << steps[i] << " is " << local
         << ", predicted " << predicted << " to " << bound.local[i - 1] << ": not asymptotic\n";
  }
  if (!(bound.slope < 0.5)) {
    holds = false;
    text << "the levels tell the order only to " << bound.slope << "\n";
  }
  // Student's t for 95 % is largest with two degrees of freedom, 4.303; no need to be sharper for more.
  constexpr double largest_quantile = 4.302653;
  const studies::OrderEstimate estimate = studies::order_estimate(steps, errors);
  const double half_width =
      largest_quantile * std::sqrt(bound.residual_squares / (estimate.levels - 2) / bound.spread);
  const bool is_near = static_cast<bool>(within(
      estimate.order, predicted, discretisation(bound.slope, 1.0, "what the next terms do to the slope")));
  text << "order " << estimate.order << " -+ " << estimate.half_width << " of " << estimate.levels
       << " levels; predicted " << predicted << " to " << bound.slope << ", half width up to " << half_width;
  holds = holds && is_near && estimate.half_width <= half_width;
  if (constant)
    for (const OrderLevel& level : levels) {
      const double leading = *constant * std::pow(level.step, predicted);
      const Tolerance allowed = discretisation(
          leading * (level.next_term + deviations * level.scatter) + level.floor, 1.0, "the next terms");
      const auto result = within(level.error, leading, allowed);
      if (result) continue;
      holds = false;
      text << "\nleading term at h = " << level.step << ":" << result.message();
    }
  return (holds ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << text.str();
}

/// Kendall's rank correlation of the values with their order: the share of pairs that rise less that of those
/// that fall, from -1 (every value below all before it) to 1. At -0.5 three pairs of four fall.
inline double rank_correlation(const std::vector<double>& values) {
  int balance = 0, pairs = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = i + 1; k < values.size(); ++k, ++pairs)
      balance += (values[k] > values[i] ? 1 : 0) - (values[k] < values[i] ? 1 : 0);
  return static_cast<double>(balance) / pairs;
}

/// The number of neighbours of which the second is smaller.
inline int falling_steps(const std::vector<double>& values) {
  int falling = 0;
  for (std::size_t i = 1; i < values.size(); ++i) falling += values[i] < values[i - 1] ? 1 : 0;
  return falling;
}

}  // namespace stickslip::testing
