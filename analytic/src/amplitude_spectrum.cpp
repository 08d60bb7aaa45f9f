// SPDX-License-Identifier: MIT
#include "stickslip/analytic/amplitude_spectrum.hpp"

#include <algorithm>

#include "arguments.hpp"
#include "stickslip/data/fourier_transform.hpp"

namespace stickslip::analytic {

std::vector<double> amplitude_spectrum(const std::vector<double>& values) {
  if (values.empty()) throw wrong_argument("the size of values", 0.0, "1 or more");
  data::FourierTransform transform(values.size());
  std::ranges::copy(values, transform.values().begin());
  transform.forward();
  std::vector<double> amplitudes;
  for (const std::complex<double> value : transform.spectrum())
    amplitudes.push_back(2.0 * std::abs(value) / static_cast<double>(values.size()));
  amplitudes.front() *= 0.5;
  if (values.size() % 2 == 0) amplitudes.back() *= 0.5;
  return amplitudes;
}

}  // namespace stickslip::analytic
