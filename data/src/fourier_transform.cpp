// SPDX-License-Identifier: MIT
#include "stickslip/data/fourier_transform.hpp"

#include <fftw3.h>

#include <mutex>
#include <new>

namespace stickslip::data {

namespace {

// FFTW makes and destroys plans on one thread at a time.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

struct FourierTransform::Plans {
  explicit Plans(std::size_t of)
      : size(of),
        values(fftw_alloc_real(size)),
        spectrum(reinterpret_cast<std::complex<double>*>(fftw_alloc_complex(size / 2 + 1))) {
    if (values == nullptr || spectrum == nullptr) {
      fftw_free(values);
      fftw_free(spectrum);
      throw std::bad_alloc();
    }
    const std::scoped_lock lock(planner());
    auto* complex = reinterpret_cast<fftw_complex*>(spectrum);
    // An estimated plan, unlike a measured one, gives the same bits every time.
    forward = fftw_plan_dft_r2c_1d(static_cast<int>(size), values, complex, FFTW_ESTIMATE);
    backward = fftw_plan_dft_c2r_1d(static_cast<int>(size), complex, values, FFTW_ESTIMATE);
  }
  ~Plans() {
    const std::scoped_lock lock(planner());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
    fftw_free(values);
    fftw_free(spectrum);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  std::size_t size;
  double* values;
  std::complex<double>* spectrum;
  fftw_plan forward{}, backward{};
};

FourierTransform::FourierTransform(std::size_t size) : plans_(std::make_unique<Plans>(size)) {}
FourierTransform::~FourierTransform() = default;

std::span<double> FourierTransform::values() { return {plans_->values, plans_->size}; }
std::span<std::complex<double>> FourierTransform::spectrum() {
  return {plans_->spectrum, plans_->size / 2 + 1};
}
void FourierTransform::forward() { fftw_execute(plans_->forward); }
void FourierTransform::backward() { fftw_execute(plans_->backward); }

std::size_t fast_size(std::size_t size) {
  const auto is_fast = [](std::size_t n) {
    for (const std::size_t prime : {2U, 3U, 5U})
      while (n % prime == 0) n /= prime;
    return n == 1;
  };
  while (!is_fast(size)) ++size;
  return size;
}

}  // namespace stickslip::data
