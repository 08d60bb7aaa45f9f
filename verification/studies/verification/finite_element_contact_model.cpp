// SPDX-License-Identifier: MIT
#include "studies/verification/finite_element_contact_model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cstddef>
#include <stdexcept>

#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

std::vector<double> to_vector(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

Eigen::VectorXd to_eigen(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

analytic::Matrix to_matrix(const Eigen::MatrixXd& values) {
  analytic::Matrix matrix(static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols()));
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index j = 0; j < values.cols(); ++j)
      matrix(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = values(i, j);
  return matrix;
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace

FiniteElementContactModel::FiniteElementContactModel(const solver::ContactSystem& system,
                                                     double angular_frequency)
    : contact_(system.contact) {
  const Eigen::Index size = system.mass.rows(), n = size - 1;
  for (Eigen::Index i = 0; i < size; ++i)
    if (i != contact_) others_.push_back(i);
  const Eigen::MatrixXd mass(system.mass), stiffness(system.stick_stiffness);
  Eigen::MatrixXd difference = Eigen::MatrixXd(system.slip_stiffness) - stiffness;
  const Eigen::RowVectorXd follower_row = difference.row(contact_);
  difference.row(contact_).setZero();
  require(difference.isZero(0.0),
          "slip_stiffness may differ from stick_stiffness in the contact's row alone.");

  basis_ = Eigen::MatrixXd::Zero(size, size);
  basis_(contact_, n) = 1.0;
  Eigen::VectorXd frequencies(n);
  if (n > 0) {
    const Eigen::MatrixXd held_mass = mass(others_, others_), held_stiffness = stiffness(others_, others_);
    const Eigen::LLT<Eigen::MatrixXd> factors(held_stiffness);
    require(factors.info() == Eigen::Success,
            "stick_stiffness must be positive definite with the contact held.");
    // M φ = ω⁻² K φ, so that round-off is relative to the lowest mode.
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(held_mass, held_stiffness);
    require(eigen.info() == Eigen::Success && eigen.eigenvalues().minCoeff() > 0.0,
            "mass must be positive definite with the contact held.");
    const Eigen::VectorXd inverse_squares = eigen.eigenvalues().reverse();
    frequencies = inverse_squares.cwiseSqrt().cwiseInverse();
    // The solver normalises with K: φ . K φ = 1.
    const Eigen::MatrixXd modes = eigen.eigenvectors().rowwise().reverse() * frequencies.asDiagonal();
    projection_ = modes.transpose() * held_mass;
    basis_(others_, Eigen::seqN(0, n)) = modes;
    basis_(others_, n) = -factors.solve(stiffness(others_, contact_));
  }

  const double quarter = 0.25 * two_pi / angular_frequency;  // of a period
  const Eigen::VectorXd inertia = basis_.transpose() * mass * basis_.col(n);
  const Eigen::VectorXd follower = basis_.transpose() * follower_row.transpose();
  model_.angular_frequency = to_vector(frequencies);
  model_.mass_coupling = to_vector(inertia.head(n));
  model_.contact_mass = inertia[n];
  model_.contact_stiffness = stiffness.row(contact_).dot(basis_.col(n));
  model_.follower = to_vector(follower.head(n));
  model_.contact_follower = follower[n];
  if (system.damping.nonZeros() > 0)
    model_.damping = to_matrix(basis_.transpose() * Eigen::MatrixXd(system.damping) * basis_);
  model_.load = to_vector(system.load_history(quarter) * (basis_.transpose() * system.load_shape));
  model_.load_angular_frequency = angular_frequency;
  model_.base_amplitude = -system.wall.displacement(quarter);
  model_.wall_amplitude = system.wall.displacement(quarter);
  model_.normal_force = system.normal_force;
  model_.friction = system.friction;
  analytic::require_consistent(model_);
}

std::vector<double> FiniteElementContactModel::amplitudes(const Eigen::VectorXd& q) const {
  const Eigen::Index n = basis_.cols() - 1;
  if (n == 0) return {};
  return to_vector(projection_ * (q(others_) - q[contact_] * basis_(others_, n)));
}

Eigen::VectorXd FiniteElementContactModel::full(const std::vector<double>& amplitudes, double contact) const {
  const Eigen::Index n = basis_.cols() - 1;
  return basis_.leftCols(n) * to_eigen(amplitudes) + contact * basis_.col(n);
}

analytic::ContactModel finite_element_contact_model(const data::Case& problem, int elements) {
  const solver::BeamModel mesh(problem.beam(), elements);
  return FiniteElementContactModel(solver::beam_contact_system(mesh, problem),
                                   angular_frequency(problem.excitation()))
      .model();
}

}  // namespace stickslip::studies
