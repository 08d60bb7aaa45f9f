// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// The coordinates of Craig & Bampton (AIAA J. 6, 1313-1319, 1968) for the beam with its tip as the
/// interface,
///
///     q = Φ η + σ w_L,     K_stick φ_n = ω_n² M φ_n with w_L = 0,   φ_nᵀ M φ_n = 1,
///
/// all modes φ_n of the mesh with its tip held, and the static shape σ of a unit deflection of the tip.
/// The tip's deflection is a coordinate, the last, so that the contact is one in these coordinates too. As
/// K_stick σ = 0 but at the tip, K_stick is diagonal and M is an arrow:
///
///     M = [I  g; gᵀ  σᵀ M σ],   g = Φᵀ M σ,
///     K_stick = diag(ω², σᵀ K_stick σ),
///
/// and K_slip adds the follower term, the row (1 - χ) P e_thetaᵀ [Φ σ] of the tip.
struct HeldTipBasis {
  Eigen::MatrixXd modes;                ///< Φ, by columns
  Eigen::VectorXd static_shape;         ///< σ
  Eigen::VectorXd squared_frequencies;  ///< ω_n², rad²/s², ascending

  [[nodiscard]] Eigen::MatrixXd matrix() const;  ///< [Φ σ]
};

/// The ω_n² are Rayleigh quotients in extended precision: as accurate as double precision can hold for
/// the matrices given, where those of an eigensolver lose the condition number of K_stick. Cost: the cube of
/// the elements. Throws data::FieldError, naming beam.axial_force, if P is at or over the buckling load.
[[nodiscard]] HeldTipBasis held_tip_basis(const BeamModel& model);

/// The coordinates (η, w_L) of a vector of nodal degrees of freedom: η = Φᵀ M (q - σ w_L).
[[nodiscard]] Eigen::VectorXd modal_coordinates(const BeamModel& model, const HeldTipBasis& basis,
                                                const Eigen::VectorXd& nodal);

/// The beam_contact_system() of the model in the coordinates of the basis: what Coordinates::modal takes. `mass_proportional`: of its damping, the part
/// of M, 1/s.
[[nodiscard]] ContactSystem modal_contact_system(const BeamModel& model, const HeldTipBasis& basis,
                                                 ContactSystem system, double mass_proportional = 0.0);

}  // namespace stickslip::solver
