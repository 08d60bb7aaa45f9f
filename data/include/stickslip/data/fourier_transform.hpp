// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace stickslip::data {

/// Real Fourier transforms of one length by FFTW: X_k = Σ_j x_j exp(-2 π i j k/n), k = 0 ... n/2, and back without the factor 1/n. The
/// same bits every time.
class FourierTransform {
 public:
  explicit FourierTransform(std::size_t size);  ///< throws std::bad_alloc
  ~FourierTransform();
  FourierTransform(const FourierTransform&) = delete;
  FourierTransform& operator=(const FourierTransform&) = delete;

  [[nodiscard]] std::span<double> values();                  ///< x
  [[nodiscard]] std::span<std::complex<double>> spectrum();  ///< X

  void forward();   ///< X from x
  void backward();  ///< n x from X, which is overwritten

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

/// The least number ≥ `size` with no prime factor above 5, for which a transform is fast.
[[nodiscard]] std::size_t fast_size(std::size_t size);

}  // namespace stickslip::data
