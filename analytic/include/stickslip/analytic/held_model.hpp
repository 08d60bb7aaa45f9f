// SPDX-License-Identifier: MIT
#pragma once

#include "stickslip/analytic/contact_model.hpp"

namespace stickslip::analytic {

/// A data::Model as a HeldStructure. With the matrices M, C, K over all rows, after a change of variables that puts u_c in the place of
/// one row of the contact:
///
///     y = r h + u,    u = σ u_c + Σ_n U_n T_n,
///
/// where u = 0 on the rows of base and rest, r is 1 on the base, 0 on the fixed rows, 1 at the contact and static in between, (K r) = 0
/// on the free rows, and σ is the same with a base at rest. U_n are the modes of the held contact, mass-normalised. From the whole
/// matrices, whatever the number of modes,
///
///     m_c = σᵀ M σ,   k_c = σᵀ K σ,   a_n = U_nᵀ M σ,   p = (U_n, σ)ᵀ M r,   d = (U_n, σ)ᵀ C r,   e_c = (K r)_c,
///
/// so that the modes left out count by their static part: m_c - a . a holds their masses a_n², as residual mass.
///
/// [damping] acts on u: δ M + η K and, in the held modes alone, the force 2 ζ_n ω_n T_n_t on T_n. The matrix C of the model acts on y.
/// With a force in place of the base motion, p are the weights of its load on (U_n, σ) and d = e_c = κ = 0.
///
/// HeldStructure::omitted holds the sums over all other modes: of a_n² by what is left of m_c, of (L_n/ω_n)² by
///
///     xᵀ K x,   x = K⁻¹ M (r - κ σ) - Σ_n U_n L_n/ω_n²   on the free rows.
///
/// At most `modes` modes, from the lowest; rows without mass have none. Accuracy: rounding of about eps ω_max²/ω_1² in ω_n², with
/// ω_max the highest frequency of the matrices. The modes of the last few matrices asked for are kept. Throws data::FieldError, naming
/// model.stiffness_matrix, unless K is positive definite on the free rows, naming model.mass_matrix for an indefinite one, naming
/// model.damping_matrix for a damper on a row without mass, whose relaxation is no mode, and where the factors of K would take more
/// than 2 GB.
[[nodiscard]] HeldStructure held_model(const data::Case& problem, int modes);

}  // namespace stickslip::analytic
