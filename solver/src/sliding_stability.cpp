// SPDX-License-Identifier: MIT
#include "stickslip/solver/sliding_stability.hpp"

#include <cmath>
#include <stdexcept>

#include "stickslip/solver/decompositions.hpp"

namespace stickslip::solver {

namespace {

// Degrees of freedom scaled by the root of their mass: pivots do not depend on units.
struct Scaled {
  Eigen::MatrixXd mass, damping, stiffness;
};

Scaled scaled(const ContactSystem& system, double slope) {
  const Eigen::VectorXd scale = Eigen::MatrixXd(system.mass).diagonal().cwiseSqrt().cwiseInverse();
  const auto apply = [&scale](const SparseMatrix& matrix) {
    return Eigen::MatrixXd(scale.asDiagonal() * Eigen::MatrixXd(matrix) * scale.asDiagonal());
  };
  Scaled result{apply(system.mass), apply(system.damping), apply(system.slip_stiffness)};
  result.damping(system.contact, system.contact) -= slope * scale[system.contact] * scale[system.contact];
  return result;
}

}  // namespace

double steady_contact_displacement(const ContactSystem& system, double friction_force) {
  const Eigen::MatrixXd stiffness = system.slip_stiffness;
  const Eigen::VectorXd unit = Eigen::VectorXd::Unit(stiffness.rows(), system.contact);
  return friction_force * stiffness.partialPivLu().solve(unit)[system.contact];
}

double falling_slope(const ContactSystem& system) {
  return -system.normal_force *
         friction_coefficient_slope(system.friction.in_slip(), system.wall.velocity(0.0));
}

std::vector<std::complex<double>> sliding_eigenvalues(const ContactSystem& system, double slope) {
  const auto [mass, damping, stiffness] = scaled(system, slope);
  const Eigen::Index n = mass.rows();
  const Eigen::PartialPivLU<Eigen::MatrixXd> factors(stiffness);
  const Eigen::MatrixXd inertia = factors.solve(mass), losses = factors.solve(damping);
  // (ω/s) x = A x of x = (q, q_t/ω), so that both halves of A have one size.
  const double omega = 1.0 / std::sqrt(inertia.norm());
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  inverse.topLeftCorner(n, n) = -losses * omega;
  inverse.topRightCorner(n, n) = -inertia * omega * omega;
  inverse.bottomLeftCorner(n, n).setIdentity();
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(inverse, false);
  if (solver.info() != Eigen::Success) throw std::runtime_error("eigenvalues of sliding did not converge");
  std::vector<std::complex<double>> eigenvalues;
  for (const std::complex<double> mu : solver.eigenvalues())
    if (const std::complex<double> s = omega / mu; s.imag() >= 0.0) eigenvalues.push_back(s);
  return eigenvalues;
}

}  // namespace stickslip::solver
