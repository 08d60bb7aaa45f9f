// SPDX-License-Identifier: MIT
#include "studies/common/convergence.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stickslip::studies {

namespace {

struct Logarithms {
  std::vector<double> steps, errors;
};

Logarithms logarithms(const std::vector<double>& steps, const std::vector<double>& errors) {
  if (steps.size() != errors.size() || steps.size() < 2) {
    throw std::invalid_argument("observed_order: needs the same number of steps and errors, at least two");
  }
  Logarithms logs;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!(steps[i] > 0.0 && errors[i] > 0.0))
      throw std::invalid_argument("observed_order: values must be positive");
    logs.steps.push_back(std::log(steps[i]));
    logs.errors.push_back(std::log(errors[i]));
  }
  return logs;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

double observed_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  const Logarithms logs = logarithms(steps, errors);
  return linear_slope(logs.steps, logs.errors);
}

OrderEstimate order_estimate(const std::vector<double>& steps, const std::vector<double>& errors) {
  const auto [x, y] = logarithms(steps, errors);
  const double slope = linear_slope(x, y), mean_x = mean(x), mean_y = mean(y);
  double spread = 0.0, residual = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    spread += (x[i] - mean_x) * (x[i] - mean_x);
    residual += std::pow(y[i] - mean_y - slope * (x[i] - mean_x), 2);
  }
  const int levels = static_cast<int>(x.size());
  if (levels == 2) return {slope, std::numeric_limits<double>::infinity(), levels};
  const double freedom = levels - 2;
  const double quantile = gsl_cdf_tdist_Pinv(0.975, freedom);
  return {slope, quantile * std::sqrt(residual / (freedom * spread)), levels};
}

double largest_or_nan(std::initializer_list<double> values) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double value : values) {
    if (std::isnan(value)) return value;
    largest = std::max(largest, value);
  }
  return largest;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = largest_or_nan({largest, std::abs(a[i] - b[i])});
  return largest;
}

int common_digits(const analytic::Bounds& range) {
  for (int digits = 15; digits > 0; --digits)
    if (fmt::format("{:.{}e}", range.lower, digits - 1) == fmt::format("{:.{}e}", range.upper, digits - 1))
      return digits;
  return 0;
}

}  // namespace stickslip::studies
