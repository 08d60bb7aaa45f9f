// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>

#include "stickslip/data/problem.hpp"

namespace stickslip::solver {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// A force or moment that is linear in the motion of a structure and of its base:
///
///     acceleration · q_tt + velocity · q_t + displacement · q + base[0] h_tt + base[1] h_t + base[2] h.
struct MotionRow {
  Eigen::VectorXd acceleration, velocity, displacement;
  std::array<double, 3> base{};
};

/// The beam on a uniform mesh, clamped at x = 0 (those two degrees of freedom are gone), both degrees of
/// freedom of the tip kept: q = (w_1, θ_1, ..., w_n, θ_n), relative to the base, in m and rad.
///
/// Slip state, Eq. (9):    M q_tt + K_slip q  = -b h_tt + e_w f_d,
///                         K_slip = K - P K_G + (1 - χ) P e_w e_thetaᵀ
/// Stick state, Eq. (8):   the same rows without that of w_L, whose motion is prescribed,  K_stick = K - P K_G.
///
/// e_w and e_theta pick the tip's deflection and rotation, b = ρ A ∫ N dx. The last term of K_slip is the
/// follower term: the weak form leaves -w(L) (EI u''' + P u') at the tip, and the boundary condition is EI
/// u''' + χ P u' = -f_d, with χ = 0 in the paper. It makes K_slip unsymmetric; at χ = 1, an axial force of
/// fixed direction, it is absent. In both states the friction force on the beam is the w_L row of the slip-state
/// balance, f_d = [M q_tt + K_slip q + b h_tt]_w = -[EI u''' + χ P u'](L).
///
/// With a shear stiffness the rotation is that of the section, M has the rotary inertia ρ I, K the shear, and
/// f_d = [k G A (u' - θ) - P u' + (1 - χ) P θ](L): the part of P that follows the tip follows its section.
/// Static deflections at the nodes are exact without axial force, as in bending alone. A frequency is too high by the
/// relative amount
///
///     (β l)⁴/1440 + ρ A ω² l²/(24 k G A),            β⁴ = ρ A ω²/EI,
///
/// of the element length l: of fourth order down to elements of about four heights of the section, of second order below.
class BeamModel {
 public:
  /// Throws data::FieldError, naming numerics.elements, if elements < 1.
  BeamModel(const data::Beam& beam, int elements);

  [[nodiscard]] int elements() const noexcept { return elements_; }
  [[nodiscard]] Eigen::Index degrees_of_freedom() const noexcept { return 2 * Eigen::Index{elements_}; }
  [[nodiscard]] Eigen::Index tip_deflection() const noexcept { return degrees_of_freedom() - 2; }
  [[nodiscard]] Eigen::Index tip_rotation() const noexcept { return degrees_of_freedom() - 1; }
  [[nodiscard]] const data::Beam& beam() const noexcept { return beam_; }

  [[nodiscard]] const SparseMatrix& mass() const noexcept { return mass_; }                      ///< M
  [[nodiscard]] const SparseMatrix& elastic_stiffness() const noexcept { return elastic_; }      ///< K
  [[nodiscard]] const SparseMatrix& geometric_stiffness() const noexcept { return geometric_; }  ///< K_G
  /// K - P K_G.
  [[nodiscard]] const SparseMatrix& stick_stiffness() const noexcept { return stick_stiffness_; }
  /// (1 - χ) P, N: the part of the axial force that follows the tip.
  [[nodiscard]] double follower_force() const noexcept {
    return (1.0 - beam_.axial_direction()) * beam_.axial_force();
  }
  /// The same with the follower term.
  [[nodiscard]] const SparseMatrix& slip_stiffness() const noexcept { return slip_stiffness_; }
  /// b = ρ A ∫ N dx, kg (and kg m): the load is -b h_tt.
  [[nodiscard]] const Eigen::VectorXd& base_load() const noexcept { return base_load_; }

  /// The equation of the clamp without damping, as its deflection (N) or its rotation (N m) has it: the consistent mass and
  /// K - P K_G of the first element.
  [[nodiscard]] MotionRow clamp_force() const { return clamp_row(0); }
  [[nodiscard]] MotionRow clamp_moment() const { return clamp_row(1); }

  /// Weights w with u_h(x) = w . q, by the shape functions; 0 ≤ x ≤ L in m (std::invalid_argument).
  [[nodiscard]] Eigen::VectorXd interpolation(double x) const;

  /// The static shape for a tip deflection of 1 in the stick state, without load: the finite-element -S(x).
  /// Throws what require_stable_stick_state() throws.
  [[nodiscard]] Eigen::VectorXd unit_tip_deflection() const;

 private:
  [[nodiscard]] MotionRow clamp_row(Eigen::Index row) const;

  data::Beam beam_;
  int elements_;
  double shear_parameter_{};  // 12 EI/(k G A l²)
  SparseMatrix mass_, elastic_, geometric_, stick_stiffness_, slip_stiffness_;
  Eigen::VectorXd base_load_;
  Eigen::Matrix<double, 2, 4> clamp_mass_, clamp_stiffness_;  // the rows of the clamp in the first element
  Eigen::Vector2d clamp_load_;
};

/// Throws data::FieldError, naming beam.axial_force, its value and the buckling load of the mesh, if the
/// stick state of the model is not stable; naming beam.length, if the stiffness is not finite.
void require_stable_stick_state(const BeamModel& model);

}  // namespace stickslip::solver
