#include "stickslip/studies/finite_element_contact_model.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::studies {

namespace {

std::vector<double> to_vector(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

}  // namespace

HeldModes::HeldModes(const solver::ContactSystem& system) : system_(system) {
  const Eigen::Index n = system.mass.rows(), c = system.contact;
  // The contact's row and column are those of the identity, with an eigenvalue of its own that is left out.
  const auto held = [&](const solver::SparseMatrix& matrix, double diagonal) {
    Eigen::MatrixXd dense(matrix);
    dense.row(c).setZero();
    dense.col(c).setZero();
    dense(c, c) = diagonal;
    return dense;
  };
  const Eigen::MatrixXd mass = held(system.mass, 1.0), stiffness = held(system.stick_stiffness, 1.0);
  // M phi = (1/omega^2) K phi: round-off is relative to the lowest mode.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(mass, stiffness);
  if (solver.info() != Eigen::Success || solver.eigenvalues().minCoeff() <= 0.0)
    throw std::invalid_argument("mass, stick_stiffness: must be positive definite with the contact held");
  basis_ = Eigen::MatrixXd::Zero(n, n);
  angular_frequency_.resize(n - 1);
  Eigen::Index column = 0;
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    const Eigen::VectorXd mode = solver.eigenvectors().col(k);
    if (std::abs(mode[c]) > 0.5) continue;
    angular_frequency_[column] = 1.0 / std::sqrt(solver.eigenvalues()[k]);
    basis_.col(column) = mode / std::sqrt(mode.dot(mass * mode));
    basis_(c, column) = 0.0;
    ++column;
  }
  Eigen::VectorXd right_side = -Eigen::VectorXd(system.stick_stiffness.col(c));
  right_side[c] = 1.0;
  basis_.col(n - 1) = stiffness.ldlt().solve(right_side);
  projection_ = basis_.leftCols(n - 1).transpose() * mass;
  projection_.col(c).setZero();
}

analytic::ContactModel HeldModes::model(const HarmonicDrive& drive) const {
  const Eigen::Index m = angular_frequency_.size(), c = system_.contact;
  const Eigen::MatrixXd mass = basis_.transpose() * system_.mass * basis_;
  const Eigen::VectorXd sigma = basis_.col(m);
  const Eigen::RowVectorXd follower =
      Eigen::RowVectorXd(system_.slip_stiffness.row(c) - system_.stick_stiffness.row(c)) * basis_;

  analytic::ContactModel model;
  model.angular_frequency = to_vector(angular_frequency_);
  model.mass_coupling = to_vector(mass.col(m).head(m));
  model.contact_mass = mass(m, m);
  model.contact_stiffness = (system_.stick_stiffness * sigma)[c];
  model.follower = to_vector(follower.head(m));
  model.contact_follower = follower[m];
  model.load = to_vector(drive.load_amplitude * (basis_.transpose() * system_.load_shape));
  model.load_angular_frequency = drive.load_angular_frequency;
  model.wall_amplitude = drive.wall_amplitude;
  model.normal_force = system_.normal_force;
  model.friction = system_.friction;
  if (system_.damping.nonZeros() > 0) {
    const Eigen::MatrixXd damping = basis_.transpose() * system_.damping * basis_;
    model.damping = analytic::Matrix(static_cast<std::size_t>(m + 1), static_cast<std::size_t>(m + 1));
    for (Eigen::Index i = 0; i <= m; ++i)
      for (Eigen::Index j = 0; j <= m; ++j)
        model.damping(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = damping(i, j);
  }
  return model;
}

Eigen::VectorXd HeldModes::amplitudes(const Eigen::VectorXd& q) const {
  return projection_ * (q - q[system_.contact] * basis_.rightCols(1));
}

Eigen::VectorXd HeldModes::displacement(const Eigen::VectorXd& amplitudes, double contact) const {
  return basis_.leftCols(amplitudes.size()) * amplitudes + contact * basis_.rightCols(1);
}

analytic::ContactModel finite_element_contact_model(const solver::BeamModel& model,
                                                    const data::FrictionLaw& friction,
                                                    const data::HarmonicExcitation& excitation,
                                                    const data::Damping& damping) {
  const solver::PrescribedMotion base = solver::harmonic_motion(excitation);
  const HeldModes modes(solver::beam_contact_system(model, friction, base, damping));
  const double omega = 2.0 * std::numbers::pi * excitation.frequency_hz();
  // The load is h_tt, the wall moves by -h.
  return modes.model({.load_amplitude = -excitation.amplitude() * omega * omega,
                      .load_angular_frequency = omega,
                      .wall_amplitude = -excitation.amplitude()});
}

}  // namespace stickslip::studies
