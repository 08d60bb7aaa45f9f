// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace stickslip::analytic {

/// A real system y_t = A y in its eigenvectors: y = Re(Z z), z = W y, z_k_t = lambda_k z_k, with one eigenvalue of each
/// complex pair, Im lambda_k >= 0.
struct SeparatedSystem {
  std::vector<std::complex<double>> eigenvalue;
  std::vector<std::complex<double>> shape;    ///< Z, row by row
  std::vector<std::complex<double>> inverse;  ///< W, row by row
  /// Largest difference of Re(Z lambda W) from A over the largest entry of A: what nearly parallel eigenvectors cost. Infinite if they are parallel.
  double error{};
};

/// `matrix`: A, row by row, without dimension: GSL rounds the eigenvalues otherwise in other units. `what` names it in
/// an error message. Throws std::runtime_error if GSL finds no eigenvalues.
[[nodiscard]] SeparatedSystem separated_system(const std::vector<double>& matrix, std::size_t size,
                                               const char* what);

}  // namespace stickslip::analytic
