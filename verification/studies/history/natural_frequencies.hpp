// SPDX-License-Identifier: MIT
#pragma once

/// Natural frequencies and modes of a case in the stick state (tip held) or the slip state (tip free), in closed form or on the
/// mesh of the case, with how far to trust them.

#include <vector>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

struct EstimatedFrequency {
  double hz{};
  double relative_error{};  ///< estimate
};

/// Those of the continuous beam, from the lowest. The error is rounding: that of the wave numbers times the condition of the
/// frequency, in the slip state that of the characteristic function over its slope, which vanishes where two frequencies coalesce.
/// Throws what stick_modes(), slip_modes() and timoshenko_frequencies() throw.
[[nodiscard]] std::vector<EstimatedFrequency> closed_form_frequencies(const data::Beam& beam,
                                                                      analytic::TipSupport tip, int count);

/// The same of a case. Of a Model they are those of its matrices, the contact held or free, without damping; at most as many as it has.
[[nodiscard]] std::vector<EstimatedFrequency> closed_form_frequencies(const data::Case& problem,
                                                                      analytic::TipSupport tip, int count);

/// Those of the mesh of numerics.elements. The error is the leading one of the elements,
///
///     [l⁴/(1440 EI) + l²/(24 K)] |∫ q q* dx| / (ω² φ*ᵀ M φ),     q = ρA ω² w - P w'',
///
/// K = k G A, with the deflection w of the mode φ and, in q*, that of the mode φ* of the transposed problem, which is φ itself where
/// K is symmetric. In the slip state, where the terms may cancel, it is not below mesh_frequency_error(). Added is what rounding
/// of the stiffness leaves, 12 eps n^3.5/(β L)⁴ on n elements. Throws what the modal analysis throws.
[[nodiscard]] std::vector<EstimatedFrequency> mesh_frequencies(const data::Case& problem,
                                                               analytic::TipSupport tip, int count);

/// Leading relative discretisation error of a natural frequency ω (rad/s) on elements of length l (m): (β l)⁴/1440 with
/// β⁴ = ρA ω²/EI, and with shear ρA ω² l²/(24 k G A) more. That is the error above at P = 0.
[[nodiscard]] double mesh_frequency_error(const data::Beam& beam, double omega, double element_length);

/// That of the stiffness next to buckling: hermite_eigenvalue_error() of the first stick mode; 0 for a beam with shear.
[[nodiscard]] double hermite_stick_error(const data::Beam& beam, double element_length);

/// The relative amount by which Euler-Bernoulli theory overestimates a natural frequency of the stick or the
/// slip state, for P much smaller than κ G A. Rotary inertia adds ρ I int U'² to the mass ρ A int
/// U², and shear adds (EI)² int U'''²/(κ G A) to the flexibility. With r² = I/A and E/(κ G) = shear_flexibility
///
///     ω_EB/ω - 1 = √(1 + r² [int U'²/int U² + E/(κ G) int U'''²/int U''²]) - 1.
///
/// For half waves of wave number k this is √(1 + (k r)² (1 + E/(κ G))) - 1. Throws what stick_modes()
/// and slip_modes() throw.
[[nodiscard]] double stick_model_error(const data::Beam& beam, int mode);
[[nodiscard]] double slip_model_error(const data::Beam& beam, int mode);

/// The value of each mode at the points (m), divided by that of largest modulus: [point][mode].
[[nodiscard]] std::vector<std::vector<double>> closed_form_shapes(const data::Beam& beam,
                                                                  analytic::TipSupport tip, int count,
                                                                  const std::vector<double>& points);
[[nodiscard]] std::vector<std::vector<double>> mesh_shapes(const data::Case& problem,
                                                           analytic::TipSupport tip, int count,
                                                           const std::vector<double>& points);

}  // namespace stickslip::studies
