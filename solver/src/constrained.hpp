// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>

#include "stickslip/solver/beam_model.hpp"

namespace stickslip::solver {

using SparseCholesky = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

[[nodiscard]] inline bool is_positive_definite(const SparseCholesky& factorization) {
  return factorization.info() == Eigen::Success && factorization.vectorD().allFinite() &&
         factorization.vectorD().minCoeff() > 0.0;
}

/// The symmetric matrix with one row and column replaced by those of the identity.
[[nodiscard]] inline SparseMatrix constrained(const SparseMatrix& matrix, Eigen::Index fixed) {
  SparseMatrix result = matrix;
  result.prune(
      [fixed](Eigen::Index row, Eigen::Index column, double) { return row != fixed && column != fixed; });
  result.coeffRef(fixed, fixed) = 1.0;
  result.makeCompressed();
  return result;
}

/// The matrix with ones on the diagonal of rows of zeros: degrees of freedom without mass have no inertia to share.
[[nodiscard]] inline SparseMatrix filled(const SparseMatrix& mass) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(mass.rows());
  for (Eigen::Index column = 0; column < mass.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(mass, column); entry; ++entry)
      sums[entry.row()] += std::abs(entry.value());
  SparseMatrix result = mass;
  for (Eigen::Index row = 0; row < sums.size(); ++row)
    if (sums[row] == 0.0) result.coeffRef(row, row) = 1.0;
  result.makeCompressed();
  return result;
}

}  // namespace stickslip::solver
