// SPDX-License-Identifier: MIT
#pragma once

/// Real Fourier transforms of one length by FFTW.

#include <fftw3.h>

#include <complex>
#include <cstddef>
#include <span>

namespace stickslip::analytic {

/// X_k = Σ_j x_j exp(-2 π i j k/n), k = 0 ... n/2, and back without the factor 1/n.
class FourierTransform {
 public:
  explicit FourierTransform(std::size_t size);
  ~FourierTransform();
  FourierTransform(const FourierTransform&) = delete;
  FourierTransform& operator=(const FourierTransform&) = delete;

  [[nodiscard]] std::span<double> values() { return {values_, size_}; }                            ///< x
  [[nodiscard]] std::span<std::complex<double>> spectrum() { return {spectrum_, size_ / 2 + 1}; }  ///< X

  void forward() { fftw_execute(forward_); }    ///< X from x
  void backward() { fftw_execute(backward_); }  ///< n x from X, which is overwritten

 private:
  std::size_t size_;
  double* values_;
  std::complex<double>* spectrum_;
  fftw_plan forward_, backward_;
};

}  // namespace stickslip::analytic
