// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>

/// @file
/// What takes 2 to 15 s to compile of Eigen's decompositions and products, instantiated once, in decompositions.cpp. It serves sources that include
/// this header and give the decomposition a MatrixXd or MatrixXcd: for an expression, Eigen has another function.
namespace Eigen {

extern template struct internal::gebp_kernel<double, double, Index,
                                             internal::blas_data_mapper<double, Index, ColMajor>, 4, 4>;
extern template LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
extern template void PartialPivLU<MatrixXd>::compute();
extern template void PartialPivLU<MatrixXcd>::compute();
extern template SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(
    const EigenBase<MatrixXd>&, int);
extern template GeneralizedSelfAdjointEigenSolver<MatrixXd>&
GeneralizedSelfAdjointEigenSolver<MatrixXd>::compute(const MatrixXd&, const MatrixXd&, int);
extern template EigenSolver<MatrixXd>& EigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
extern template EigenSolver<MatrixXd>::EigenvectorsType EigenSolver<MatrixXd>::eigenvectors() const;

}  // namespace Eigen
