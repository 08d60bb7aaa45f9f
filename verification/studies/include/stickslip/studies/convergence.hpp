#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
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
inline double observed_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  if (steps.size() != errors.size() || steps.size() < 2) {
    throw std::invalid_argument("observed_order: needs the same number of steps and errors, at least two");
  }
  std::vector<double> x, y;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!(steps[i] > 0.0 && errors[i] > 0.0))
      throw std::invalid_argument("observed_order: values must be positive");
    x.push_back(std::log(steps[i]));
    y.push_back(std::log(errors[i]));
  }
  return linear_slope(x, y);
}

}  // namespace stickslip::studies
