// SPDX-License-Identifier: MIT
#include "fourier_transform.hpp"

#include <algorithm>
#include <mutex>
#include <new>

#include "arguments.hpp"
#include "stickslip/analytic/amplitude_spectrum.hpp"

namespace stickslip::analytic {

namespace {

/// FFTW makes and destroys plans on one thread at a time.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

FourierTransform::FourierTransform(std::size_t size)
    : size_(size),
      values_(fftw_alloc_real(size)),
      spectrum_(reinterpret_cast<std::complex<double>*>(fftw_alloc_complex(size / 2 + 1))) {
  if (values_ == nullptr || spectrum_ == nullptr) {
    fftw_free(values_);
    fftw_free(spectrum_);
    throw std::bad_alloc();
  }
  const std::scoped_lock lock(planner());
  auto* spectrum = reinterpret_cast<fftw_complex*>(spectrum_);
  // An estimated plan, unlike a measured one, gives the same bits every time.
  forward_ = fftw_plan_dft_r2c_1d(static_cast<int>(size), values_, spectrum, FFTW_ESTIMATE);
  backward_ = fftw_plan_dft_c2r_1d(static_cast<int>(size), spectrum, values_, FFTW_ESTIMATE);
}

FourierTransform::~FourierTransform() {
  const std::scoped_lock lock(planner());
  fftw_destroy_plan(forward_);
  fftw_destroy_plan(backward_);
  fftw_free(values_);
  fftw_free(spectrum_);
}

std::vector<double> amplitude_spectrum(const std::vector<double>& values) {
  if (values.empty()) throw wrong_argument("the size of values", 0.0, "1 or more");
  FourierTransform transform(values.size());
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
