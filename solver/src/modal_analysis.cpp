// SPDX-License-Identifier: MIT
#include "stickslip/solver/modal_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "stickslip/solver/decompositions.hpp"

namespace stickslip::solver {

namespace {

// The matrix without the row and column of the tip deflection.
Eigen::MatrixXd without_tip_deflection(const SparseMatrix& matrix, Eigen::Index tip) {
  const Eigen::MatrixXd full = matrix;
  const Eigen::Index behind = full.rows() - tip - 1;
  Eigen::MatrixXd reduced(full.rows() - 1, full.cols() - 1);
  reduced << full.topLeftCorner(tip, tip), full.topRightCorner(tip, behind),  //
      full.bottomLeftCorner(behind, tip), full.bottomRightCorner(behind, behind);
  return reduced;
}

Eigen::VectorXd with_tip_deflection_zero(const Eigen::VectorXd& reduced, Eigen::Index tip) {
  Eigen::VectorXd full(reduced.size() + 1);
  full << reduced.head(tip), 0.0, reduced.tail(reduced.size() - tip);
  return full;
}

// φᵀ M φ = 1 and a deflection of the first node that is not negative.
Eigen::VectorXd normalised(Eigen::VectorXd shape, const SparseMatrix& mass) {
  shape /= std::sqrt(shape.dot(mass * shape));
  return shape[0] < 0.0 ? Eigen::VectorXd(-shape) : shape;
}

void require_count(int count, Eigen::Index available) {
  if (count >= 1 && count <= available) return;
  throw data::FieldError("count", count,
                         "1 ... " + std::to_string(available) + ", the degrees of freedom of the mesh");
}

// Eigenpairs μ, φ of K⁻¹ M φ = μ φ, by falling |μ|.
struct SlipEigenpairs {
  Eigen::VectorXcd mu;
  Eigen::MatrixXcd shapes;
};

SlipEigenpairs slip_eigenpairs(const BeamModel& model, const SparseMatrix& stiffness) {
  // With rotations times the element length every degree of freedom is a length: pivots, and the accuracy of
  // the unsymmetric problem, do not depend on the unit.
  Eigen::VectorXd per_length = Eigen::VectorXd::Ones(model.degrees_of_freedom());
  for (Eigen::Index rotation = 1; rotation < per_length.size(); rotation += 2)
    per_length[rotation] = model.elements() / model.beam().length();
  const auto as_lengths = [&per_length](const SparseMatrix& matrix) {
    return Eigen::MatrixXd(per_length.asDiagonal() * Eigen::MatrixXd(matrix) * per_length.asDiagonal());
  };
  const Eigen::MatrixXd flexibility_times_mass =
      Eigen::PartialPivLU<Eigen::MatrixXd>(as_lengths(stiffness)).solve(as_lengths(model.mass()));
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(flexibility_times_mass);
  if (solver.info() != Eigen::Success) throw std::runtime_error("slip-state eigenvalues did not converge");
  std::vector<Eigen::Index> order(static_cast<std::size_t>(model.degrees_of_freedom()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
  const Eigen::VectorXcd mu = solver.eigenvalues();
  std::stable_sort(order.begin(), order.end(),
                   [&mu](Eigen::Index i, Eigen::Index j) { return std::abs(mu[i]) > std::abs(mu[j]); });
  return {mu(order), per_length.asDiagonal() * solver.eigenvectors()(Eigen::all, order)};
}

}  // namespace

std::vector<FiniteElementMode> stick_modes(const BeamModel& model, int count) {
  require_count(count, model.degrees_of_freedom() - 1);
  require_stable_stick_state(model);
  const Eigen::Index tip = model.tip_deflection();
  // Ascending μ = 1/ω²: the lowest modes stand last.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      without_tip_deflection(model.mass(), tip), without_tip_deflection(model.stick_stiffness(), tip));
  if (solver.info() != Eigen::Success) throw std::runtime_error("stick-state eigenvalues did not converge");
  std::vector<FiniteElementMode> modes;
  for (int n = 0; n < count; ++n) {
    const Eigen::Index column = solver.eigenvalues().size() - 1 - n;
    modes.push_back(
        {1.0 / std::sqrt(solver.eigenvalues()[column]),
         normalised(with_tip_deflection_zero(solver.eigenvectors().col(column), tip), model.mass())});
  }
  return modes;
}

std::vector<std::complex<double>> slip_eigenvalues(const BeamModel& model, int count) {
  require_count(count, model.degrees_of_freedom());
  const SlipEigenpairs pairs = slip_eigenpairs(model, model.slip_stiffness());
  std::vector<std::complex<double>> eigenvalues;
  for (Eigen::Index n = 0; n < count; ++n) eigenvalues.push_back(1.0 / pairs.mu[n]);
  return eigenvalues;
}

std::vector<FiniteElementMode> slip_modes(const BeamModel& model, int count) {
  require_count(count, model.degrees_of_freedom());
  const SlipEigenpairs pairs = slip_eigenpairs(model, model.slip_stiffness());
  std::vector<FiniteElementMode> modes;
  for (Eigen::Index n = 0; n < count; ++n) {
    const std::complex<double> mu = pairs.mu[n];
    if (mu.imag() != 0.0 || mu.real() <= 0.0)
      throw data::FieldError("beam.axial_force", model.beam().axial_force(),
                             "below the flutter or buckling load of the slip state: slip mode " +
                                 std::to_string(n + 1) + " has no real frequency");
    modes.push_back({1.0 / std::sqrt(mu.real()), normalised(pairs.shapes.col(n).real(), model.mass())});
  }
  return modes;
}

std::vector<Eigen::VectorXd> adjoint_slip_shapes(const BeamModel& model, int count) {
  require_count(count, model.degrees_of_freedom());
  const SlipEigenpairs pairs = slip_eigenpairs(model, model.slip_stiffness().transpose());
  std::vector<Eigen::VectorXd> shapes;
  for (Eigen::Index n = 0; n < count; ++n) shapes.emplace_back(pairs.shapes.col(n).real());
  return shapes;
}

double stick_buckling_load(const BeamModel& model) {
  const Eigen::Index tip = model.tip_deflection();
  // K_G φ = μ K φ, μ = 1/P: the largest μ is the lowest load.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      without_tip_deflection(model.geometric_stiffness(), tip),
      without_tip_deflection(model.elastic_stiffness(), tip), Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success) throw std::runtime_error("buckling load did not converge");
  return 1.0 / solver.eigenvalues()[solver.eigenvalues().size() - 1];
}

}  // namespace stickslip::solver
