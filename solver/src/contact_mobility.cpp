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
  at_contact_ = modes.eigenvectors().row(contact_);
  follower_ = modes.eigenvectors().transpose() * follower;
  if (!is_damped()) return;
  modal_damping_ = modes.eigenvectors().transpose() * (damping_ * modes.eigenvectors());
  damping_diagonal_ = modal_damping_.diagonal();
  modal_damping_.diagonal().setZero();
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

// r(m, c, k), from the amplitudes x of the modes under a unit force on the contact. Damping couples them little, so that Jacobi's iteration
// finds them: it divides by the diagonal only. Where it does not converge, the matrix is factorised.
ContactMobility::Complex ContactMobility::receptance(Complex m, Complex c, Complex k) const {
  const auto by_modes = [&](const auto& amplitude) {
    Complex a = 0.0, b = 0.0;
    for (Eigen::Index j = 0; j < eigenvalues_.size(); ++j) {
      const Complex x = amplitude(j);
      a += at_contact_[j] * x;
      b += follower_[j] * x;
    }
    return a / (1.0 + k * b);
  };
  const auto uncoupled = [&](Eigen::Index j) {
    const Complex stiffness = m + k * eigenvalues_[j];
    return at_contact_[j] * std::conj(stiffness) / std::norm(stiffness);
  };
  if (!is_damped()) return by_modes(uncoupled);
  constexpr int most_rounds = 40;
  constexpr double rounding = 1e-14;
  const Eigen::VectorXcd diagonal =
      m + k * eigenvalues_.array().cast<Complex>() + c * damping_diagonal_.array().cast<Complex>();
  Eigen::VectorXcd x = at_contact_.cast<Complex>().cwiseQuotient(diagonal), coupled(x.size());
  for (int round = 0; round < most_rounds; ++round) {
    coupled.real() = modal_damping_ * x.real();
    coupled.imag() = modal_damping_ * x.imag();
    const Eigen::VectorXcd next = (at_contact_.cast<Complex>() - c * coupled).cwiseQuotient(diagonal);
    const double change = (next - x).squaredNorm();
    x = next;
    if (change <= rounding * rounding * x.squaredNorm())
      return by_modes([&](Eigen::Index j) { return x[j]; });
  }
  using ComplexMatrix = Eigen::SparseMatrix<Complex>;
  const Eigen::SparseLU<ComplexMatrix, Eigen::NaturalOrdering<int>> factorised(ComplexMatrix(
      m * mass_.cast<Complex>() + c * damping_.cast<Complex>() + k * stiffness_.cast<Complex>()));
  return factorised.solve(Eigen::VectorXcd(Eigen::VectorXcd::Unit(mass_.rows(), contact_)))[contact_];
}

}  // namespace stickslip::solver
