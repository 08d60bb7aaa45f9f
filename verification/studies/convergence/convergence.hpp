#pragma once

#include <cstddef>
#include <vector>

namespace stickslip::studies {

/// Least-squares slope of y over x. Precondition: two or more points that do not share one x.
inline double linear_slope(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  }
  const auto n = static_cast<double>(x.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Least-squares slope of log(error) over log(step): the observed order. Throws std::invalid_argument unless
/// there are at least two levels, all positive.
[[nodiscard]] double observed_order(const std::vector<double>& steps, const std::vector<double>& errors);

/// An observed order with the 95 % confidence interval order -+ half_width of the regression slope, after
/// Student's t with levels - 2 degrees of freedom; infinite with two levels, through which any line passes.
///
/// The interval holds the true slope in 95 of 100 cases if the logarithms of the errors scatter about a
/// straight line independently and normally. Those of a convergent sequence do not: they leave the line
/// through the next term of an asymptotic series, smoothly. Read half_width as the departure from a straight
/// line, in units of the slope: small says that one power of the step describes all levels, not that the
/// power is the theoretical one.
struct OrderEstimate {
  double order{};
  double half_width{};
  int levels{};
};

/// The observed order with its interval. Throws as observed_order() does.
[[nodiscard]] OrderEstimate order_estimate(const std::vector<double>& steps,
                                           const std::vector<double>& errors);

/// The largest difference of two series of one length.
[[nodiscard]] double largest_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace stickslip::studies
