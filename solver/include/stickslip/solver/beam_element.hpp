// SPDX-License-Identifier: MIT
#pragma once

/// The two-node Hermite beam element of length l: degrees of freedom (w1, theta1, w2, theta2), theta = dw/dx,
/// and cubic shape functions N(s), s = x/l in [0, 1],
///
///     N = [ 1 - 3 s^2 + 2 s^3,  l (s - 2 s^2 + s^3),  3 s^2 - 2 s^3,  l (s^3 - s^2) ].
///
/// Matrices are those of the weak form of Eqs. (8) and (9), integrated exactly:
///
///     consistent mass        m  int N^T N dx            (m = rho A)
///     bending stiffness      EI int N''^T N'' dx
///     geometric stiffness       int N'^T N' dx          (enters as -P for a compressive P)
///     consistent load           int N dx                (force and moment of a unit load per length)

#include <Eigen/Core>

namespace stickslip::solver {

using ElementMatrix = Eigen::Matrix4d;
using ElementVector = Eigen::Vector4d;

/// m int N^T N dx; mass_per_length in kg/m, element_length in m.
[[nodiscard]] ElementMatrix consistent_mass(double mass_per_length, double element_length);

/// EI int N''^T N'' dx; flexural_rigidity in N m^2.
[[nodiscard]] ElementMatrix bending_stiffness(double flexural_rigidity, double element_length);

/// int N'^T N' dx for a unit axial force.
[[nodiscard]] ElementMatrix geometric_stiffness(double element_length);

/// int N dx = l [1/2, l/12, 1/2, -l/12] for a unit load per length.
[[nodiscard]] ElementVector consistent_load(double element_length);

/// N at s = x/l.
[[nodiscard]] ElementVector shape_functions(double s, double element_length);

}  // namespace stickslip::solver
