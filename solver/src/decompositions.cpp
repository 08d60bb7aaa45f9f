// SPDX-License-Identifier: MIT
#include "stickslip/solver/decompositions.hpp"

namespace Eigen {

template class LLT<MatrixXd>;
template class PartialPivLU<MatrixXd>;
template class PartialPivLU<MatrixXcd>;
template class Tridiagonalization<MatrixXd>;
template class SelfAdjointEigenSolver<MatrixXd>;
template class GeneralizedSelfAdjointEigenSolver<MatrixXd>;
template class HessenbergDecomposition<MatrixXd>;
template class RealSchur<MatrixXd>;
template class EigenSolver<MatrixXd>;

}  // namespace Eigen
