// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

/// The time functions of a ContactSystem in closed form: load_history = load_amplitude sin(Omega t), wall
/// displacement = wall_amplitude sin(Omega t).
struct HarmonicDrive {
  double load_amplitude{};     ///< in the units of load_history
  double angular_frequency{};  ///< Omega, rad/s, > 0
  double wall_amplitude{};     ///< W, m
};

/// The drive of beam_contact_system() for h(t) = A0 sin(Omega t): load_history = h_tt, w = -h.
[[nodiscard]] HarmonicDrive harmonic_drive(const data::HarmonicExcitation& excitation);

/// Converts a ContactSystem to the ContactModel of the event-driven method: the same semi-discrete system,
/// without a time step. c is the contact degree of freedom, and f are the other n ones:
///
///     sigma_f = -K_ff^-1 K_fc,     M_ff phi_k omega_k^2 = K_ff phi_k,     phi_k . M_ff phi_k = 1,
///     q_f = sigma_f u_c + Phi T,     q_c = u_c,     T = Phi^T M_ff (q_f - sigma_f q_c),
///
/// K is the stick stiffness. With B = [Phi sigma_f; 0 1] the matrices of the model are B^T (.) B. The
/// follower row is the row c of (K_slip - K_stick) B. Relative rounding error: at most about eps
/// omega_n^2/omega_1^2.
class FiniteElementContactModel {
 public:
  /// Needs n^3 operations on dense matrices. Throws std::invalid_argument unless M_ff and K_ff are positive
  /// definite and K_slip differs from K_stick only in the row c, and what require_consistent() throws.
  FiniteElementContactModel(const solver::ContactSystem& system, const HarmonicDrive& drive);

  [[nodiscard]] const analytic::ContactModel& model() const noexcept { return model_; }

  /// T of the displacements q, or T_t of the velocities.
  [[nodiscard]] std::vector<double> amplitudes(const Eigen::VectorXd& q) const;
  /// q of (T, u_c), or the velocities of the rates.
  [[nodiscard]] Eigen::VectorXd full(const std::vector<double>& amplitudes, double contact) const;

 private:
  Eigen::Index contact_;
  std::vector<Eigen::Index> others_;  // f
  Eigen::MatrixXd basis_;             // B
  Eigen::MatrixXd projection_;        // Phi^T M_ff
  analytic::ContactModel model_;
};

/// The contact model of a case on a mesh for an event-driven run.
[[nodiscard]] analytic::ContactModel finite_element_contact_model(const data::Case& problem, int elements);

}  // namespace stickslip::studies
