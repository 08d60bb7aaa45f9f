// SPDX-License-Identifier: MIT
#pragma once

/// The beam on a mesh: its energies, its tip held or free of friction.

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

/// The beam with a tip that slides without friction, a linear system: no normal force, and a wall that is faster than any
/// tip (1 km/s), so that the sliding velocity never changes its sign and no step is divided.
inline solver::ContactSystem free_tip_system(const solver::BeamModel& model,
                                             const solver::PrescribedMotion& base,
                                             const data::Damping& damping) {
  constexpr double speed = 1e3;
  solver::ContactSystem system = solver::beam_contact_system(model, data::FrictionLaw({}), base, damping);
  system.normal_force = 0.0;
  system.wall = {.displacement = [](double t) { return speed * t; },
                 .velocity = [](double) { return speed; },
                 .acceleration = [](double) { return 0.0; }};
  return system;
}

}  // namespace stickslip::testing
