// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "stickslip/analytic/force_maximum.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// Slope of the least-squares line of y over x. Precondition: at least two points with different x.
inline double linear_slope(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  }
  const auto n = static_cast<double>(x.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// The observed order: the least-squares slope of log(error) over log(step). Throws std::invalid_argument
/// unless there are at least two levels and all values are positive.
[[nodiscard]] double observed_order(const std::vector<double>& steps, const std::vector<double>& errors);

/// An observed order with the 95 % confidence interval order -+ half_width of the regression slope (Student's
/// t with levels - 2 degrees of freedom). half_width is infinite for two levels.
///
/// The interval contains the true slope in 95 of 100 cases if the logarithms of the errors scatter
/// independently and normally about a straight line. The errors of a convergent sequence do not scatter in
/// this way: they deviate smoothly from the line by the next term of an asymptotic series. half_width
/// therefore measures the deviation from a straight line, in units of the slope. A small value means that one
/// power of the step describes all levels. It does not mean that this power is the theoretical one.
struct OrderEstimate {
  double order{};
  double half_width{};
  int levels{};
};
STICKSLIP_MEMBERS(OrderEstimate, (order, "1"), (half_width, "1"), (levels, "1"))

/// The observed order with its confidence interval. Throws what observed_order() throws.
[[nodiscard]] OrderEstimate order_estimate(const std::vector<double>& steps,
                                           const std::vector<double>& errors);

/// The largest of the values, or NaN if one of them is. std::max(largest, NaN) is `largest`, so that what is below a bound
/// could have an error that is NaN.
[[nodiscard]] double largest_or_nan(std::initializer_list<double> values);

/// The largest absolute difference of two series of the same length, or NaN if one of the differences is.
[[nodiscard]] double largest_difference(const std::vector<double>& a, const std::vector<double>& b);

/// The largest number of significant digits, from 15 down to 1, at which both bounds round to the same value;
/// 0 if they differ at one digit.
[[nodiscard]] int common_digits(const analytic::Bounds& range);

}  // namespace stickslip::studies
