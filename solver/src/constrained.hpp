#pragma once

#include "stickslip/solver/beam_model.hpp"

namespace stickslip::solver {

/// The symmetric matrix with one row and column replaced by those of the identity.
[[nodiscard]] inline SparseMatrix constrained(const SparseMatrix& matrix, Eigen::Index fixed) {
  SparseMatrix result = matrix;
  result.prune(
      [fixed](Eigen::Index row, Eigen::Index column, double) { return row != fixed && column != fixed; });
  result.coeffRef(fixed, fixed) = 1.0;
  result.makeCompressed();
  return result;
}

}  // namespace stickslip::solver
