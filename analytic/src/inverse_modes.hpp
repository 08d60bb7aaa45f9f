// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sparse_cholesky.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::analytic {

/// Modes U_n of K U = ω² M U, U_mᵀ M U_n = δ_mn, from the lowest.
struct InverseModes {
  std::vector<double> angular_frequency;  ///< ω_n, rad/s
  std::vector<double> shapes;             ///< U_n, one after the other
  bool are_all{};                         ///< M has no others
};

/// At least `count` modes where there are so many, as the largest eigenvalues ω⁻² of L⁻¹ P M Pᵀ L⁻ᵀ with the factors of K: rounding is
/// relative to the lowest mode, and rows without mass have ω⁻² = 0. All of them by LAPACK for up to most_dense_rows, else by ARPACK, which
/// looks for the largest alone. Throws data::FieldError, naming model.mass_matrix, for an M that LAPACK finds indefinite.
[[nodiscard]] InverseModes inverse_modes(const SparseMatrix& mass, const SparseCholesky& stiffness,
                                         std::size_t count);

[[nodiscard]] data::FieldError indefinite_mass();

inline constexpr int most_dense_rows = 600;

/// Below this share of the largest ω⁻² one counts as 0.
inline constexpr double least_inverse_square = 1e-12;

}  // namespace stickslip::analytic
