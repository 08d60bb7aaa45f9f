// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "stickslip/solver/beam_model.hpp"

namespace stickslip::solver {

/// One natural mode of a mesh.
struct FiniteElementMode {
  double angular_frequency{};  ///< rad/s
  /// All degrees of freedom of the model, φᵀ M φ = 1, the deflection of the first node not negative.
  Eigen::VectorXd shape;
};

/// The `count` lowest modes of the stick state, (K_stick - ω² M) φ = 0 with w_L = 0.
///
/// Solved as M φ = μ K φ, μ = 1/ω², so that round-off is relative to the lowest mode and not to
/// the highest. Throws std::invalid_argument if count is not in 1 ... 2 elements - 1, data::FieldError if P
/// is at or over the buckling load of the mesh.
[[nodiscard]] std::vector<FiniteElementMode> stick_modes(const BeamModel& model, int count);

/// The `count` lowest eigenvalues ω² of the slip state, (K_slip - ω² M) φ = 0, rad²/s², by
/// modulus; complex pairs beyond the flutter load, one below 0 beyond the buckling load.
[[nodiscard]] std::vector<std::complex<double>> slip_eigenvalues(const BeamModel& model, int count);

/// The `count` lowest modes of the slip state. Throws data::FieldError, naming beam.axial_force, if one of
/// them has no real frequency (flutter or buckling).
[[nodiscard]] std::vector<FiniteElementMode> slip_modes(const BeamModel& model, int count);

/// The shapes ψ of the transposed problem, (K_slipᵀ - ω² M) ψ = 0, in the order of slip_modes(). No mode has to have a real
/// frequency; of a complex one the real part is given.
[[nodiscard]] std::vector<Eigen::VectorXd> adjoint_slip_shapes(const BeamModel& model, int count);

/// The lowest axial force, N, at which K - P K_G with w_L = 0 becomes singular.
[[nodiscard]] double stick_buckling_load(const BeamModel& model);

}  // namespace stickslip::solver
