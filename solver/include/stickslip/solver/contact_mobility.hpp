// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <complex>

#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// The driving-point mobility of a ContactSystem in slip: the velocity of the contact per unit force on it,
/// m/(N s),
///
///     Y(s) = s r(s², s, 1),     r(m, c, k) = e_c . (m M + c C + k K_slip)⁻¹ e_c.
///
/// K_slip = K_stick + e_c lᵀ with a symmetric K_stick. Without damping, with the mass-normalised modes
/// K_stick φ_j = λ_j M φ_j of the free contact, and by the formula of Sherman and Morrison,
///
///     r = a/(1 + k b),
///     a = Σ_j φ_j[c]²/(m + k λ_j),
///     b = Σ_j (l . φ_j) φ_j[c]/(m + k λ_j).
///
/// Damping couples these modes, little as a rule: Jacobi's iteration then takes some products with its matrix, else a factorisation.
///
/// For |s| -> infinity, Z = 1/Y = m_c s + c_c + O(1/s), with G = (M⁻¹)_cc:  m_c = 1/G is the mass that an
/// impulse at the contact meets, c_c = (M⁻¹ C M⁻¹)_cc/G².
///
/// Generalised-alpha (generalized_alpha.hpp) turns the friction forces of steps into the sliding velocities
/// at the α level, at which StickSlipIntegrator evaluates them. With generating functions in ζ,
/// X(ζ) = Σ_n x_n ζ^n, its three equations become
///
///     [A M + F (V C + Q K)] a = F_d e_c,     v_alpha = F V a[c],
///     A = 1 - α_m + α_m ζ,        F = 1 - α_f + α_f ζ,
///     V = h [γ + (1 - γ) ζ]/(1 - ζ),
///     Q = (h ζ V + h² [β + (1/2 - β) ζ])/(1 - ζ),
///
/// so that the discrete mobility is W(ζ) = F V r(A, F V, F Q). It holds for whole steps: a change of the
/// contact within a step splits it.
class ContactMobility {
 public:
  using Complex = std::complex<double>;

  /// Undamped: dense, n³ operations. Throws std::invalid_argument unless M is positive definite and K_slip
  /// differs from K_stick in the row of the contact alone.
  explicit ContactMobility(const ContactSystem& system);

  /// Y(s), m/(N s); s in 1/s. The λ_j are known to eps times the largest of them.
  [[nodiscard]] Complex operator()(Complex s) const;

  /// W(ζ), m/(N s), 0 < |ζ| < 1; time_step h > 0 in s, 0 ≤ spectral_radius ≤ 1
  /// (std::invalid_argument).
  [[nodiscard]] Complex discrete(Complex zeta, double time_step, double spectral_radius) const;

  /// √(λ_j), rad/s, ascending, with 0 for λ_j < 0: near the poles of Y, which the follower force
  /// l and damping move.
  [[nodiscard]] const Eigen::VectorXd& angular_frequencies() const noexcept { return angular_frequencies_; }
  [[nodiscard]] double contact_mass() const noexcept { return contact_mass_; }        ///< m_c, kg
  [[nodiscard]] double contact_damping() const noexcept { return contact_damping_; }  ///< c_c, N s/m

 private:
  [[nodiscard]] Complex receptance(Complex mass_factor, Complex damping_factor,
                                   Complex stiffness_factor) const;
  [[nodiscard]] bool is_damped() const noexcept { return damping_.nonZeros() > 0; }

  SparseMatrix mass_, damping_, stiffness_;
  Eigen::Index contact_;
  Eigen::VectorXd eigenvalues_, angular_frequencies_;  // λ_j and its root
  Eigen::VectorXd at_contact_, follower_;              // φ_j[c], l . φ_j
  Eigen::VectorXd damping_diagonal_;                   // of C in these modes, and the rest of it
  Eigen::MatrixXd modal_damping_;
  double contact_mass_{}, contact_damping_{};
};

}  // namespace stickslip::solver
