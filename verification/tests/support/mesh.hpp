// SPDX-License-Identifier: MIT
#pragma once

/// The beam on a mesh with its tip held.

#include <Eigen/Dense>

#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::testing {

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
