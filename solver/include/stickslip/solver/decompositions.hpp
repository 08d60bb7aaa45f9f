// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>

/// @file
/// Decompositions of Eigen that the solver instantiates once, in decompositions.cpp. Sources that include this header do not compile
/// them again, which takes 3 to 15 s for each.
namespace Eigen {

extern template class LLT<MatrixXd>;
extern template class PartialPivLU<MatrixXd>;
extern template class PartialPivLU<MatrixXcd>;
extern template class Tridiagonalization<MatrixXd>;
extern template class SelfAdjointEigenSolver<MatrixXd>;
extern template class GeneralizedSelfAdjointEigenSolver<MatrixXd>;
extern template class HessenbergDecomposition<MatrixXd>;
extern template class RealSchur<MatrixXd>;
extern template class EigenSolver<MatrixXd>;

}  // namespace Eigen
