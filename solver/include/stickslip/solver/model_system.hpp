// SPDX-License-Identifier: MIT
#pragma once

/// A data::Model as a ContactSystem, with all its degrees of freedom.

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// The structure of a model in the rows that neither the base nor a support holds, in coordinates u that move with the base,
/// y = r h + u:
///
///     M u_tt + C u_t + K u = -(M r) h_tt - (C r) h_t - (K r) h + e_c f_d.
///
/// r is the static shape for a base and a contact that both move by 1. A contact of several rows becomes one degree of
/// freedom, u_c = Σ w_i u_i, in place of the row with the largest weight; the others stay.
struct ModelMatrices {
  SparseMatrix mass, stiffness;
  SparseMatrix own_damping;  ///< as given: it resists the absolute velocity
  Eigen::Index contact{};
  Eigen::VectorXd rigid_shape;  ///< r
  Eigen::VectorXd inertia;      ///< M r, kg, with the share of the base
  Eigen::VectorXd drag;         ///< own C r, N s/m, with the share of the base
  double
      base_stiffness{};  ///< (K r)_c, N/m; 0 if the base alone holds the structure. K r is 0 in all other rows
  Eigen::VectorXd static_shape;  ///< σ: (K σ)_i = 0 but at the contact, where σ is 1
  Eigen::VectorXd load;          ///< of a unit force of the excitation
  MotionRow base;                ///< the sum of the rows of the base, with the own damping, N
};

/// Throws data::FieldError, naming the file of the stiffness or the mass, if the structure with its contact held is not
/// positive definite: it is not held, or the matrices are not those of a structure.
[[nodiscard]] ModelMatrices model_matrices(const data::Model& model);

/// One natural mode.
struct ModelMode {
  double angular_frequency{};  ///< rad/s
  Eigen::VectorXd shape;       ///< φᵀ M φ = 1; 0 at a held contact
};
/// All modes with a finite frequency, ascending, the contact held or free, without damping. From M φ = μ K φ, μ = 1/ω², so
/// that round-off is relative to the lowest; dense. Throws data::FieldError, naming damping.ratio, for more than 1000 rows.
[[nodiscard]] std::vector<ModelMode> model_modes(const ModelMatrices& matrices, bool contact_is_held);

/// C without the own damping: η K + δ M + Σ_n 2 ζ_n ω_n v_n v_nᵀ over the modes of the held contact, v_n = M U_n - e_c (σ · M
/// U_n), so that v_n . u is T_n, and the static shape is not damped. Throws what model_modes() throws.
[[nodiscard]] SparseMatrix relative_damping(const ModelMatrices& matrices, const data::Damping& damping);

/// The system of a case with a model, on a base that moves by h(t) = `base`. Throws what the functions above throw.
[[nodiscard]] ContactSystem model_contact_system(const data::Case& problem, const PrescribedMotion& base);
[[nodiscard]] ContactSystem model_contact_system(const data::Case& problem, const ModelMatrices& matrices,
                                                 const PrescribedMotion& base);

/// The amplitude of f while the contact is held for ever, per metre of the base (or per newton times Ω² of a force), from all
/// rows at the frequency of the case. N/m.
[[nodiscard]] double steady_reaction_of(const data::Case& problem);

}  // namespace stickslip::solver
