// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <complex>
#include <limits>

namespace stickslip::analytic {

/// (exp(a tau) - exp(b tau))/(a - b), without the cancellation where a and b are close; Re a <= 0, Re b <= 0.
[[nodiscard]] inline std::complex<double> exponential_difference(std::complex<double> a,
                                                                 std::complex<double> b, double tau) {
  const std::complex<double> gap = (a - b) * tau;
  if (std::abs(gap) > 0.5) return (std::exp(a * tau) - std::exp(b * tau)) / (a - b);
  std::complex<double> term = 1.0, sum = 1.0;
  for (int k = 2; std::abs(term) > 0.1 * std::numeric_limits<double>::epsilon() && k < 30; ++k)
    sum += term *= gap / static_cast<double>(k);
  return tau * std::exp(b * tau) * sum;
}

}  // namespace stickslip::analytic
