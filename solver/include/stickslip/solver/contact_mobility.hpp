// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <complex>

#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// The driving-point mobility of a ContactSystem in slip: the velocity of the contact per unit force on it,
/// m/(N s),
///
///     Y(s) = s r(s^2, s, 1),     r(m, c, k) = e_c . (m M + c C + k K_slip)^-1 e_c.
///
/// K_slip = K_stick + e_c l^T with a symmetric K_stick. Without damping, with the mass-normalised modes
/// K_stick phi_j = lambda_j M phi_j of the free contact, and by the formula of Sherman and Morrison,
///
///     r = a/(1 + k b),
///     a = sum_j phi_j[c]^2/(m + k lambda_j),
///     b = sum_j (l . phi_j) phi_j[c]/(m + k lambda_j).
///
/// With damping r takes the factorisation of a sparse matrix each time.
///
/// For |s| -> infinity, Z = 1/Y = m_c s + c_c + O(1/s), with G = (M^-1)_cc:  m_c = 1/G is the mass that an
/// impulse at the contact meets, c_c = (M^-1 C M^-1)_cc/G^2.
///
/// Generalised-alpha (generalized_alpha.hpp) turns the friction forces of steps into the sliding velocities
/// at the alpha level, at which StickSlipIntegrator evaluates them. With generating functions in zeta,
/// X(zeta) = sum_n x_n zeta^n, its three equations become
///
///     [A M + F (V C + Q K)] a = F_d e_c,     v_alpha = F V a[c],
///     A = 1 - alpha_m + alpha_m zeta,        F = 1 - alpha_f + alpha_f zeta,
///     V = h [gamma + (1 - gamma) zeta]/(1 - zeta),
///     Q = (h zeta V + h^2 [beta + (1/2 - beta) zeta])/(1 - zeta),
///
/// so that the discrete mobility is W(zeta) = F V r(A, F V, F Q). It holds for whole steps: a change of the
/// contact within a step splits it.
class ContactMobility {
 public:
  using Complex = std::complex<double>;

  /// Undamped: dense, n^3 operations. Throws std::invalid_argument unless M is positive definite and K_slip
  /// differs from K_stick in the row of the contact alone.
  explicit ContactMobility(const ContactSystem& system);

  /// Y(s), m/(N s); s in 1/s. The lambda_j are known to eps times the largest of them.
  [[nodiscard]] Complex operator()(Complex s) const;

  /// W(zeta), m/(N s), 0 < |zeta| < 1; time_step h > 0 in s, 0 <= spectral_radius <= 1
  /// (std::invalid_argument).
  [[nodiscard]] Complex discrete(Complex zeta, double time_step, double spectral_radius) const;

  /// sqrt(lambda_j), rad/s, ascending, with 0 for lambda_j < 0: near the poles of Y, which the follower force
  /// l and damping move.
  [[nodiscard]] const Eigen::VectorXd& angular_frequencies() const noexcept { return angular_frequencies_; }
  [[nodiscard]] double contact_mass() const noexcept { return contact_mass_; }        ///< m_c, kg
  [[nodiscard]] double contact_damping() const noexcept { return contact_damping_; }  ///< c_c, N s/m

 private:
  [[nodiscard]] Complex receptance(Complex mass_factor, Complex damping_factor,
                                   Complex stiffness_factor) const;

  SparseMatrix mass_, damping_, stiffness_;
  Eigen::Index contact_;
  Eigen::VectorXd eigenvalues_, angular_frequencies_;  // lambda_j and its root
  Eigen::VectorXd participation_, follower_;           // phi_j[c]^2, (l . phi_j) phi_j[c]
  double contact_mass_{}, contact_damping_{};
};

}  // namespace stickslip::solver
