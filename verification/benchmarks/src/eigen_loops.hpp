#pragma once

#include <Eigen/Core>

#include "stickslip/data/problem.hpp"

namespace stickslip::benchmarks {

/// The stick state as anybody would program it with Eigen, to compare with: the rows of the tip's deflection
/// left out, its prescribed motion on the right-hand side, one factorisation, one loop of the
/// generalised-alpha method.
enum class Factorisation { dense_lu, sparse_ldlt };

struct EigenLoop {
  double largest_force{};   ///< max |f|, N
  double flops_per_step{};  ///< counted from the matrices
  double bytes_per_step{};  ///< read and written once each, matrices with their indices
};

[[nodiscard]] EigenLoop eigen_stick_loop(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                         const data::NumericalSettings& numerics,
                                         Factorisation factorisation);

}  // namespace stickslip::benchmarks
