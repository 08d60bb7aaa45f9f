#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace stickslip::studies {

/// Least-squares slope of log(error) over log(step): the observed order. Throws std::invalid_argument unless
/// there are at least two levels, all positive.
inline double observed_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  if (steps.size() != errors.size() || steps.size() < 2) {
    throw std::invalid_argument("observed_order: needs the same number of steps and errors, at least two");
  }
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!(steps[i] > 0.0 && errors[i] > 0.0))
      throw std::invalid_argument("observed_order: values must be positive");
    const double x = std::log(steps[i]), y = std::log(errors[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const auto n = static_cast<double>(steps.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace stickslip::studies
