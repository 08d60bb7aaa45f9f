// SPDX-License-Identifier: MIT
#pragma once

/// Steady sliding of a ContactSystem on a wall of constant speed: its displacement and its small disturbances.
/// With the falling slope κ = -N μ'(v) (N s/m) of the friction force they obey
///
///     M q_tt + (C - κ e_c e_c^T) q_t + K_slip q = 0.

#include <complex>
#include <vector>

#include "stickslip/solver/contact_system.hpp"

namespace stickslip::solver {

/// q[c] under the constant force f_d (N) on the contact: [K_slip⁻¹ e_c]_c f_d, m.
[[nodiscard]] double steady_contact_displacement(const ContactSystem& system, double friction_force);

/// κ of steady sliding at the speed of the wall at t = 0, N s/m.
[[nodiscard]] double falling_slope(const ContactSystem& system);

/// All eigenvalues s of the equation above with Im s ≥ 0, 1/s. From 1/s as eigenvalue of the inverse first-order
/// system, so that round-off is relative to the lowest: eps times (ω_n/ω_1)² for mode n. n³ operations on dense
/// matrices of twice the degrees of freedom.
[[nodiscard]] std::vector<std::complex<double>> sliding_eigenvalues(const ContactSystem& system,
                                                                    double slope);

}  // namespace stickslip::solver
