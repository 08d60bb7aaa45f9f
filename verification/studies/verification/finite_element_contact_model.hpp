// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

/// Converts a ContactSystem to the ContactModel of the event-driven method: the same semi-discrete system,
/// without a time step. c is the contact degree of freedom, and f are the other n ones:
///
///     σ_f = -K_ff⁻¹ K_fc,     M_ff φ_k ω_k² = K_ff φ_k,     φ_k . M_ff φ_k = 1,
///     q_f = σ_f u_c + Φ T,     q_c = u_c,     T = Φ^T M_ff (q_f - σ_f q_c),
///
/// K is the stick stiffness. With B = [Φ σ_f; 0 1] the matrices of the model are B^T (.) B. The
/// follower row is the row c of (K_slip - K_stick) B. Relative rounding error: at most about eps
/// ω_n²/ω_1².
class FiniteElementContactModel {
 public:
  /// Load and wall are proportional to sin(Ω t), Ω = angular_frequency > 0 (rad/s), which gives their amplitudes at Ω t = π/2.
  /// Needs n³ operations on dense matrices. Throws std::invalid_argument unless M_ff and K_ff are positive
  /// definite and K_slip differs from K_stick only in the row c, and what require_consistent() throws.
  FiniteElementContactModel(const solver::ContactSystem& system, double angular_frequency);

  [[nodiscard]] const analytic::ContactModel& model() const noexcept { return model_; }

  /// T of the displacements q, or T_t of the velocities.
  [[nodiscard]] std::vector<double> amplitudes(const Eigen::VectorXd& q) const;
  /// q of (T, u_c), or the velocities of the rates.
  [[nodiscard]] Eigen::VectorXd full(const std::vector<double>& amplitudes, double contact) const;

 private:
  Eigen::Index contact_;
  std::vector<Eigen::Index> others_;  // f
  Eigen::MatrixXd basis_;             // B
  Eigen::MatrixXd projection_;        // Φ^T M_ff
  analytic::ContactModel model_;
};

/// The contact model of a case on a mesh for an event-driven run.
[[nodiscard]] analytic::ContactModel finite_element_contact_model(const data::Case& problem, int elements);

}  // namespace stickslip::studies
