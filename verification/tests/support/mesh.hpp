// SPDX-License-Identifier: MIT
#pragma once

/// The beam on a mesh: its energies, its tip held.

#include <Eigen/Dense>

#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::testing {

/// 1/2 q^T K q of bending, J.
inline double elastic_energy(const solver::BeamModel& model, const Eigen::VectorXd& q) {
  return 0.5 * q.dot(model.elastic_stiffness() * q);
}

/// -P/2 q^T K_G q of the axial force, J.
inline double geometric_energy(const solver::BeamModel& model, const Eigen::VectorXd& q) {
  return -0.5 * model.beam().axial_force() * q.dot(model.geometric_stiffness() * q);
}

/// A stiffness with the deflection of the tip held at zero.
inline Eigen::MatrixXd with_held_tip(const solver::BeamModel& model, const solver::SparseMatrix& stiffness) {
  Eigen::MatrixXd held = stiffness;
  const Eigen::Index tip = model.tip_deflection();
  held.row(tip).setZero();
  held.col(tip).setZero();
  held(tip, tip) = 1.0;
  return held;
}

}  // namespace stickslip::testing
