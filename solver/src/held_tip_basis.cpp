// SPDX-License-Identifier: MIT
#include "stickslip/solver/held_tip_basis.hpp"

#include <Eigen/Dense>
#include <vector>

#include "stickslip/solver/modal_analysis.hpp"

namespace stickslip::solver {

namespace {

// x^T A x in extended precision: the stiffness of low modes is a small difference of large terms.
long double quadratic_form(const SparseMatrix& matrix, const Eigen::VectorXd& x) {
  long double sum = 0.0L;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      sum += static_cast<long double>(x[entry.row()]) * entry.value() * x[column];
  return sum;
}

// [Φ σ]ᵀ C [Φ σ].
SparseMatrix in_basis(const SparseMatrix& damping, const HeldTipBasis& basis) {
  if (damping.norm() == 0.0) return {damping.rows(), damping.cols()};
  const Eigen::MatrixXd columns = basis.matrix();
  return Eigen::MatrixXd(columns.transpose() * (damping * columns)).sparseView();
}

}  // namespace

Eigen::MatrixXd HeldTipBasis::matrix() const {
  Eigen::MatrixXd columns(modes.rows(), modes.cols() + 1);
  columns << modes, static_shape;
  return columns;
}

HeldTipBasis held_tip_basis(const BeamModel& model) {
  HeldTipBasis basis;
  basis.static_shape = model.unit_tip_deflection();
  const Eigen::Index count = model.degrees_of_freedom() - 1;
  basis.modes.resize(model.degrees_of_freedom(), count);
  basis.squared_frequencies.resize(count);
  const std::vector<FiniteElementMode> modes = stick_modes(model, static_cast<int>(count));
  for (Eigen::Index n = 0; n < count; ++n) {
    const Eigen::VectorXd& shape = modes[static_cast<std::size_t>(n)].shape;
    basis.modes.col(n) = shape;
    basis.squared_frequencies[n] = static_cast<double>(quadratic_form(model.stick_stiffness(), shape) /
                                                       quadratic_form(model.mass(), shape));
  }
  return basis;
}

Eigen::VectorXd modal_coordinates(const BeamModel& model, const HeldTipBasis& basis,
                                  const Eigen::VectorXd& nodal) {
  const double tip = nodal[model.tip_deflection()];
  Eigen::VectorXd coordinates(nodal.size());
  coordinates << basis.modes.transpose() * (model.mass() * (nodal - tip * basis.static_shape)), tip;
  return coordinates;
}

ContactSystem modal_contact_system(const BeamModel& model, const HeldTipBasis& basis, ContactSystem system,
                                   double mass_proportional) {
  const Eigen::Index modes = basis.modes.cols(), tip = modes;
  const Eigen::VectorXd &sigma = basis.static_shape, inertia = model.mass() * sigma;
  const Eigen::VectorXd coupling = basis.modes.transpose() * inertia;
  const Eigen::VectorXd rotations = basis.modes.row(model.tip_rotation()).transpose();
  const double follower_force = model.follower_force();

  SparseMatrix mass(modes + 1, modes + 1), stick(modes + 1, modes + 1), slip(modes + 1, modes + 1);
  for (Eigen::Index n = 0; n < modes; ++n) {
    mass.insert(n, n) = 1.0;
    mass.insert(tip, n) = mass.insert(n, tip) = coupling[n];
    stick.insert(n, n) = slip.insert(n, n) = basis.squared_frequencies[n];
    slip.insert(tip, n) = follower_force * rotations[n];
  }
  mass.insert(tip, tip) = sigma.dot(inertia);
  stick.insert(tip, tip) = sigma.dot(model.stick_stiffness() * sigma);
  slip.insert(tip, tip) = stick.coeff(tip, tip) + follower_force * sigma[model.tip_rotation()];
  for (SparseMatrix* matrix : {&mass, &stick, &slip}) matrix->makeCompressed();

  Eigen::VectorXd load(modes + 1);
  load << basis.modes.transpose() * system.load_shape, sigma.dot(system.load_shape);
  // Of the share of the mass, the modes stay apart to the last digit.
  const SparseMatrix rest = in_basis(system.damping - mass_proportional * system.mass, basis);
  system.damping = SparseMatrix(rest + mass_proportional * mass).pruned();
  system.mass = mass;
  system.stick_stiffness = stick;
  system.slip_stiffness = slip;
  system.load_shape = load;
  system.contact = tip;
  return system;
}

}  // namespace stickslip::solver
