// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "stickslip/data/problem.hpp"

namespace stickslip::benchmarks {

/// A usual implementation of the stick state with Eigen, for comparison. The rows of the tip deflection are
/// removed, its prescribed motion is on the right-hand side, the matrix is factorised once, and one loop
/// performs the steps of generalised-alpha.
enum class Factorisation { dense_lu, sparse_ldlt };

/// The result of the loop and its load per step.
struct EigenLoop {
  double largest_force{};   ///< max |f|, N
  double flops_per_step{};  ///< per step, counted from the matrices
  double bytes_per_step{};  ///< per step, each number read and written once; matrices with their indices
};

/// Runs the loop over numerics.duration().
[[nodiscard]] EigenLoop eigen_stick_loop(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                         const data::NumericalSettings& numerics,
                                         Factorisation factorisation);

}  // namespace stickslip::benchmarks
