// SPDX-License-Identifier: MIT
#pragma once

/// The two-node beam element of length l with the degrees of freedom (w1, θ1, w2, θ2), θ the rotation of
/// the section, and the shear parameter g = 12 EI/(k G A l²). Its shape functions are the exact solutions of the
/// element without load on it (Przemieniecki, Theory of Matrix Structural Analysis, 1968; Friedman and Kosmatka,
/// Comput. Struct. 47, 473-481, 1993), so that it does not lock: with s = x/l in [0, 1],
///
///     N     = [ 1 + g - g s - 3 s² + 2 s³,  l ((1 + g/2) s - (2 + g/2) s² + s³),
///               g s + 3 s² - 2 s³,          l (-g/2 s - (1 - g/2) s² + s³) ]/(1 + g),
///     θ = [ -6 (s - s²)/l,  1 + g - (4 + g) s + 3 s²,  6 (s - s²)/l,  -(2 - g) s + 3 s² ]/(1 + g).
///
/// At g = 0, θ = N' and these are Hermite's cubics. Matrices are those of the weak form of Eqs. (8) and (9),
/// integrated exactly:
///
///     consistent mass        m  ∫ Nᵀ N dx               (m = ρ A)
///     rotary mass            j  ∫ θᵀ θ dx       (j = ρ I)
///     elastic stiffness      EI ∫ θ'ᵀ θ' dx + k G A ∫ (N' - θ)ᵀ (N' - θ) dx
///     geometric stiffness       ∫ N'ᵀ N' dx             (enters as -P for a compressive P)
///     consistent load           ∫ N dx                   (force and moment of a unit load per length, for any g)

#include <Eigen/Core>

namespace stickslip::solver {

using ElementMatrix = Eigen::Matrix4d;
using ElementVector = Eigen::Vector4d;

/// m ∫ Nᵀ N dx; mass_per_length in kg/m, element_length in m, shear_parameter g.
[[nodiscard]] ElementMatrix consistent_mass(double mass_per_length, double element_length,
                                            double shear_parameter = 0.0);

/// j ∫ θᵀ θ dx; rotary_inertia_per_length in kg m.
[[nodiscard]] ElementMatrix rotary_mass(double rotary_inertia_per_length, double element_length,
                                        double shear_parameter);

/// EI ∫ θ'ᵀ θ' dx + k G A ∫ (N' - θ)ᵀ (N' - θ) dx; flexural_rigidity in N m².
[[nodiscard]] ElementMatrix bending_stiffness(double flexural_rigidity, double element_length,
                                              double shear_parameter = 0.0);

/// ∫ N'ᵀ N' dx for a unit axial force.
[[nodiscard]] ElementMatrix geometric_stiffness(double element_length, double shear_parameter = 0.0);

/// ∫ N dx = l [1/2, l/12, 1/2, -l/12] for a unit load per length.
[[nodiscard]] ElementVector consistent_load(double element_length);

/// N at s = x/l.
[[nodiscard]] ElementVector shape_functions(double s, double element_length, double shear_parameter = 0.0);

}  // namespace stickslip::solver
