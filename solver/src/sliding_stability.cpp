// SPDX-License-Identifier: MIT
#include "stickslip/solver/sliding_stability.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

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
  const data::FrictionLaw law = system.friction.in_slip();
  const double speed = std::abs(system.wall.velocity(0.0));
  return system.normal_force * ((law.static_coefficient() - law.kinetic_coefficient()) * law.decay() *
                                    std::exp(-law.decay() * speed) -
                                law.viscous());
}

std::vector<std::complex<double>> sliding_eigenvalues(const ContactSystem& system, double slope) {
  const auto [mass, damping, stiffness] = scaled(system, slope);
  const Eigen::Index n = mass.rows();
  const Eigen::PartialPivLU<Eigen::MatrixXd> factors(stiffness);
  const Eigen::MatrixXd inertia = factors.solve(mass), losses = factors.solve(damping);
  // (omega/s) x = A x of x = (q, q_t/omega), so that both halves of A have one size.
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
  std::ranges::sort(eigenvalues, {}, [](std::complex<double> s) { return std::abs(s); });
  return eigenvalues;
}

double critical_slope(const ContactSystem& system, double angular_frequency, double guess) {
  std::complex<double> at(0.0, angular_frequency);
  const auto growth = [&](double slope) {
    const auto eigenvalues = sliding_eigenvalues(system, slope);
    at = *std::ranges::min_element(eigenvalues, {}, [&](std::complex<double> s) { return std::abs(s - at); });
    return at.real();
  };
  double before = 0.9 * guess, slope = guess, growth_before = growth(before);
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 40; ++i) {
    const double here = growth(slope);
    if (here == growth_before) return slope;
    const double change = here * (slope - before) / (here - growth_before);
    // Rounding leaves changes that no longer fall.
    if (std::abs(change) >= 0.5 * last && std::abs(change) < 1e-7 * std::abs(slope)) return slope;
    before = slope;
    growth_before = here;
    slope -= change;
    last = std::abs(change);
  }
  throw std::runtime_error("the critical slope of sliding did not converge");
}

}  // namespace stickslip::solver
