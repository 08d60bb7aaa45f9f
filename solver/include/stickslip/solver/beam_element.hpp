// SPDX-License-Identifier: MIT
#pragma once

/// The two-node beam element of length l with the degrees of freedom (w1, theta1, w2, theta2), theta the rotation of
/// the section, and the shear parameter g = 12 EI/(k G A l^2). Its shape functions are the exact solutions of the
/// element without load on it (Przemieniecki, Theory of Matrix Structural Analysis, 1968; Friedman and Kosmatka,
/// Comput. Struct. 47, 473-481, 1993), so that it does not lock: with s = x/l in [0, 1],
///
///     N     = [ 1 + g - g s - 3 s^2 + 2 s^3,  l ((1 + g/2) s - (2 + g/2) s^2 + s^3),
///               g s + 3 s^2 - 2 s^3,          l (-g/2 s - (1 - g/2) s^2 + s^3) ]/(1 + g),
///     theta = [ -6 (s - s^2)/l,  1 + g - (4 + g) s + 3 s^2,  6 (s - s^2)/l,  -(2 - g) s + 3 s^2 ]/(1 + g).
///
/// At g = 0, theta = N' and these are Hermite's cubics. Matrices are those of the weak form of Eqs. (8) and (9),
/// integrated exactly:
///
///     consistent mass        m  int N^T N dx               (m = rho A)
///     rotary mass            j  int theta^T theta dx       (j = rho I)
///     elastic stiffness      EI int theta'^T theta' dx + k G A int (N' - theta)^T (N' - theta) dx
///     geometric stiffness       int N'^T N' dx             (enters as -P for a compressive P)
///     consistent load           int N dx                   (force and moment of a unit load per length, for any g)

#include <Eigen/Core>

namespace stickslip::solver {

using ElementMatrix = Eigen::Matrix4d;
using ElementVector = Eigen::Vector4d;

/// m int N^T N dx; mass_per_length in kg/m, element_length in m, shear_parameter g.
[[nodiscard]] ElementMatrix consistent_mass(double mass_per_length, double element_length,
                                            double shear_parameter = 0.0);

/// j int theta^T theta dx; rotary_inertia_per_length in kg m.
[[nodiscard]] ElementMatrix rotary_mass(double rotary_inertia_per_length, double element_length,
                                        double shear_parameter);

/// EI int theta'^T theta' dx + k G A int (N' - theta)^T (N' - theta) dx; flexural_rigidity in N m^2.
[[nodiscard]] ElementMatrix bending_stiffness(double flexural_rigidity, double element_length,
                                              double shear_parameter = 0.0);

/// int N'^T N' dx for a unit axial force.
[[nodiscard]] ElementMatrix geometric_stiffness(double element_length, double shear_parameter = 0.0);

/// int N dx = l [1/2, l/12, 1/2, -l/12] for a unit load per length.
[[nodiscard]] ElementVector consistent_load(double element_length);

/// N at s = x/l.
[[nodiscard]] ElementVector shape_functions(double s, double element_length, double shear_parameter = 0.0);

}  // namespace stickslip::solver
