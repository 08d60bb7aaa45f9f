// SPDX-License-Identifier: MIT
#include "held_contact.hpp"

#include "constrained.hpp"

namespace stickslip::solver {

HeldContact::HeldContact(const ContactSystem& system) : system_(system) {
  const Eigen::Index c = system.contact;
  const SparseMatrix mass = filled(system.mass);
  const SparseCholesky constrained_mass(constrained(mass, c));
  if (!is_positive_definite(SparseCholesky(mass)) || !is_positive_definite(constrained_mass))
    throw data::InputError("the mass matrix is not positive definite, but for rows of zeros");

  // λ = M_ff⁻¹ M_fc, zero at c: what the contact's acceleration does to the others.
  Eigen::VectorXd lambda = Eigen::VectorXd(system.mass.col(c));
  lambda[c] = 0.0;
  lambda = constrained_mass.solve(lambda).eval();
  const auto contact_row = [c](const SparseMatrix& matrix) {
    return Eigen::VectorXd(matrix.transpose().col(c));
  };
  displacement_factors_ = contact_row(system.slip_stiffness) - system.stick_stiffness.transpose() * lambda;
  velocity_factors_ = contact_row(system.damping) - system.damping.transpose() * lambda;
  const auto factor = [&](const Eigen::VectorXd& load) { return lambda.dot(load) - load[c]; };
  load_factor_ = factor(system.load_shape);
  for (const ContactSystem::Load& load : system.further_loads) further_factors_.push_back(factor(load.shape));
  mass_ = system.mass.coeff(c, c) - lambda.dot(Eigen::VectorXd(system.mass.col(c)));
  impulse_response_ = -lambda;
  impulse_response_[c] = 1.0;
  damping_ = velocity_factors_.dot(impulse_response_);
}

double HeldContact::sliding_velocity(const Kinematics& state, double t) const {
  return state.velocity[system_.contact] - system_.wall.velocity(t);
}

double HeldContact::holding_force(const Kinematics& state, double t) const {
  double force = displacement_factors_.dot(state.displacement) + velocity_factors_.dot(state.velocity) +
                 load_factor_ * system_.load_history(t) + mass_ * system_.wall.acceleration(t);
  for (std::size_t i = 0; i < further_factors_.size(); ++i)
    force += further_factors_[i] * system_.further_loads[i].history(t);
  return force;
}

void HeldContact::remove_sliding_velocity(Kinematics& state, double t) const {
  state.velocity += (system_.wall.velocity(t) - state.velocity[system_.contact]) * impulse_response_;
}

}  // namespace stickslip::solver
