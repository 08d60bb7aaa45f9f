// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <vector>

#include "stickslip/analytic/contact_dynamics.hpp"

namespace stickslip::analytic {

/// A real system y_t = A y in its eigenvectors: y = Re(Z z), z = W y, z_k_t = λ_k z_k, with one eigenvalue of each
/// complex pair, Im λ_k ≥ 0.
struct SeparatedSystem {
  std::vector<std::complex<double>> eigenvalue;
  std::vector<std::complex<double>> shape;    ///< Z, row by row
  std::vector<std::complex<double>> inverse;  ///< W, row by row
  /// Largest difference of Re(Z λ W) from A over the largest entry of A: what nearly parallel eigenvectors cost.
  /// Infinite if they are parallel.
  double error{};
};

/// `matrix`: A, without dimension: GSL rounds the eigenvalues otherwise in other units. `what` names it in an error
/// message. Throws std::runtime_error if GSL finds no eigenvalues.
[[nodiscard]] SeparatedSystem separated_system(const Matrix& matrix, const char* what);

/// A of y_t = unit A y, y = (scale X, X_t), X = (T, u_c): a ContactModel without load and wall whose contact force is
/// -stiffness u_c + slope u_c_t. `scale` has a value for each coordinate, 1/s; `unit` in 1/s.
[[nodiscard]] Matrix first_order_matrix(const ContactDynamics& dynamics, const std::vector<double>& scale,
                                        double unit, double stiffness = 0.0, double slope = 0.0);

}  // namespace stickslip::analytic
