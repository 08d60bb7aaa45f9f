// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace stickslip::analytic {

/// The amplitudes of the sinusoids that equidistant values x_0 ... x_(n-1) are the sum of, those with 0 ... n/2
/// periods in n values: |X_k| 2/n, without the 2 for the mean value and, at even n, for the last one. A
/// sinusoid of another frequency leaks into all. Throws std::invalid_argument without values.
[[nodiscard]] std::vector<double> amplitude_spectrum(const std::vector<double>& values);

}  // namespace stickslip::analytic
