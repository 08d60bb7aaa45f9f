// SPDX-License-Identifier: MIT
#include "special_functions.hpp"

namespace stickslip::analytic {
namespace {

/// c3 by its Taylor series sum (-z)^j/(2j + 3)!; for |z| ≤ 4 eleven terms leave less than 4¹¹/25! = 3e-19.
double c3_by_series(double z) {
  double term = 1.0 / 6.0, sum = term;
  for (int j = 1; j <= 10; ++j) {
    term *= -z / ((2 * j + 2) * (2 * j + 3));
    sum += term;
  }
  return sum;
}

/// The hyperbolic forms, with y = √(-z) and exp(-decay) drawn into the exponentials.
double scaled_hyperbolic(int k, double y, double decay) {
  const double growing = 0.5 * std::exp(y - decay), decaying = 0.5 * std::exp(-y - decay);
  switch (k) {
    case 0:
      return growing + decaying;
    case 1:
      return (growing - decaying) / y;
    case 2:
      return (growing + decaying - std::exp(-decay)) / (y * y);
    default:
      return (growing - decaying - y * std::exp(-decay)) / (y * y * y);
  }
}

double trigonometric_or_small(int k, double z) {
  const double y = std::sqrt(std::abs(z));
  const double sine = z < 0.0 ? std::sinh(y) : std::sin(y);
  const double half_sine = z < 0.0 ? std::sinh(0.5 * y) : std::sin(0.5 * y);
  switch (k) {
    case 0:
      return z < 0.0 ? std::cosh(y) : std::cos(y);
    case 1:
      return y > 0.0 ? sine / y : 1.0;
    case 2:
      return y > 0.0 ? 2.0 * (half_sine / y) * (half_sine / y) : 0.5;
    default:
      return std::abs(z) <= 4.0 ? c3_by_series(z) : (y - sine) / (y * y * y);
  }
}

}  // namespace

double scaled_stumpff(int k, double z, double decay) {
  if (z < -4.0) return scaled_hyperbolic(k, std::sqrt(-z), decay);
  return std::exp(-decay) * trigonometric_or_small(k, z);
}

}  // namespace stickslip::analytic
