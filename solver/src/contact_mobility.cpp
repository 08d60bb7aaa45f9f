// SPDX-License-Identifier: MIT
#include "stickslip/solver/contact_mobility.hpp"

#include <Eigen/SparseLU>
#include <stdexcept>

#include "stickslip/solver/decompositions.hpp"
#include "stickslip/solver/generalized_alpha.hpp"

namespace stickslip::solver {

ContactMobility::ContactMobility(const ContactSystem& system)
    : mass_(system.mass),
      damping_(system.damping.pruned()),
      stiffness_(system.slip_stiffness),
      contact_(system.contact) {
  const Eigen::MatrixXd mass = mass_;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(mass);
  if (cholesky.info() != Eigen::Success) throw data::InputError("the mass matrix is not positive definite");
  Eigen::MatrixXd difference = system.slip_stiffness - system.stick_stiffness;
  const Eigen::VectorXd follower = difference.row(contact_);
  difference.row(contact_).setZero();
  if (!difference.isZero(0.0))
    throw std::invalid_argument(
        "slip_stiffness: must equal stick_stiffness in all rows but that of the contact");

  const Eigen::VectorXd impulse = cholesky.solve(Eigen::VectorXd::Unit(mass.rows(), contact_));
  contact_mass_ = 1.0 / impulse[contact_];
  contact_damping_ = impulse.dot(damping_ * impulse) * contact_mass_ * contact_mass_;

  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      Eigen::MatrixXd(system.stick_stiffness), mass);
  if (modes.info() != Eigen::Success)
    throw std::runtime_error("eigenvalues of the free contact did not converge");
  eigenvalues_ = modes.eigenvalues();
  angular_frequencies_ = eigenvalues_.cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd at_contact = modes.eigenvectors().row(contact_);
  participation_ = at_contact.cwiseAbs2();
  follower_ = (modes.eigenvectors().transpose() * follower).cwiseProduct(at_contact);
}

ContactMobility::Complex ContactMobility::operator()(Complex s) const {
  return s * receptance(s * s, s, 1.0);
}

ContactMobility::Complex ContactMobility::discrete(Complex zeta, double h, double spectral_radius) const {
  if (!(h > 0.0)) throw data::FieldError("time_step", h, "above 0 (s)");
  const GeneralizedAlpha method(spectral_radius);
  const double beta = method.beta(), gamma = method.gamma();
  const Complex acceleration = 1.0 - method.alpha_m() + method.alpha_m() * zeta;
  const Complex share = 1.0 - method.alpha_f() + method.alpha_f() * zeta;
  const Complex velocity = h * (gamma + (1.0 - gamma) * zeta) / (1.0 - zeta);
  const Complex displacement = (h * zeta * velocity + h * h * (beta + (0.5 - beta) * zeta)) / (1.0 - zeta);
  return share * velocity * receptance(acceleration, share * velocity, share * displacement);
}

// r(m, c, k).
ContactMobility::Complex ContactMobility::receptance(Complex m, Complex c, Complex k) const {
  if (damping_.nonZeros() > 0) {
    using ComplexMatrix = Eigen::SparseMatrix<Complex>;
    const Eigen::SparseLU<ComplexMatrix, Eigen::NaturalOrdering<int>> factorised(ComplexMatrix(
        m * mass_.cast<Complex>() + c * damping_.cast<Complex>() + k * stiffness_.cast<Complex>()));
    return factorised.solve(Eigen::VectorXcd(Eigen::VectorXcd::Unit(mass_.rows(), contact_)))[contact_];
  }
  Complex a = 0.0, b = 0.0;
  for (Eigen::Index j = 0; j < eigenvalues_.size(); ++j) {
    const Complex stiffness = m + k * eigenvalues_[j];
    const Complex flexibility = std::conj(stiffness) / std::norm(stiffness);
    a += participation_[j] * flexibility;
    b += follower_[j] * flexibility;
  }
  return a / (1.0 + k * b);
}

}  // namespace stickslip::solver
