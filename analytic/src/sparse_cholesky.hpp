// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "stickslip/data/model.hpp"

namespace stickslip::analytic {

/// A symmetric sparse matrix, of CHOLMOD.
class SparseMatrix {
 public:
  /// `entries` hold both triangles, and those of one place add. rows ≥ 1.
  SparseMatrix(int rows, std::span<const data::MatrixEntry> entries);
  ~SparseMatrix();
  SparseMatrix(const SparseMatrix&) = delete;
  SparseMatrix& operator=(const SparseMatrix&) = delete;

  [[nodiscard]] int rows() const;
  [[nodiscard]] std::vector<double> operator*(std::span<const double> x) const;

 private:
  friend class SparseCholesky;
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

/// The factors P A Pᵀ = L Lᵀ of a symmetric matrix, with a fill-reducing permutation P. Right sides may have several columns, one after
/// the other.
class SparseCholesky {
 public:
  /// Throws data::FieldError, naming model.stiffness_matrix, if L would take more than 2 GB.
  explicit SparseCholesky(const SparseMatrix& matrix);
  ~SparseCholesky();

  /// Whether A is positive definite, to rounding.
  [[nodiscard]] bool is_positive_definite() const;
  /// The square of the least entry on the diagonal of L over the largest.
  [[nodiscard]] double least_pivot() const;
  [[nodiscard]] std::vector<double> solve(std::span<const double> b) const;        ///< A⁻¹ b
  [[nodiscard]] std::vector<double> to_factor(std::span<const double> b) const;    ///< L⁻¹ P b
  [[nodiscard]] std::vector<double> from_factor(std::span<const double> y) const;  ///< Pᵀ L⁻ᵀ y

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

}  // namespace stickslip::analytic
