// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// The coordinates of Craig & Bampton (AIAA J. 6, 1313-1319, 1968) for the beam with its tip as the
/// interface,
///
///     q = Phi eta + sigma w_L,     K_stick phi_n = omega_n^2 M phi_n with w_L = 0,   phi_n^T M phi_n = 1,
///
/// all modes phi_n of the mesh with its tip held, and the static shape sigma of a unit deflection of the tip.
/// The tip's deflection is a coordinate, the last, so that the contact is one in these coordinates too. As
/// K_stick sigma = 0 but at the tip, K_stick is diagonal and M is an arrow:
///
///     M = [I  g; g^T  sigma^T M sigma],   g = Phi^T M sigma,
///     K_stick = diag(omega^2, sigma^T K_stick sigma),
///
/// and K_slip adds the follower term, the row (1 - chi) P e_theta^T [Phi sigma] of the tip.
struct HeldTipBasis {
  Eigen::MatrixXd modes;                ///< Phi, by columns
  Eigen::VectorXd static_shape;         ///< sigma
  Eigen::VectorXd squared_frequencies;  ///< omega_n^2, rad^2/s^2, ascending
};

/// The omega_n^2 are Rayleigh quotients in extended precision: as accurate as double precision can hold for
/// the matrices given, where those of an eigensolver lose the condition number of K_stick. Cost: the cube of
/// the elements. Throws data::FieldError, naming beam.axial_force, if P is at or over the buckling load.
[[nodiscard]] HeldTipBasis held_tip_basis(const BeamModel& model);

/// The coordinates (eta, w_L) of a vector of nodal degrees of freedom: eta = Phi^T M (q - sigma w_L).
[[nodiscard]] Eigen::VectorXd modal_coordinates(const BeamModel& model, const HeldTipBasis& basis,
                                                const Eigen::VectorXd& nodal);

/// The contact system of the beam without damping, in the coordinates of the basis: what StepAlgebra::modal
/// takes.
[[nodiscard]] ContactSystem modal_contact_system(const BeamModel& model, const HeldTipBasis& basis,
                                                 const data::FrictionLaw& friction,
                                                 const PrescribedMotion& base, const data::Wall& wall = {});

}  // namespace stickslip::solver
