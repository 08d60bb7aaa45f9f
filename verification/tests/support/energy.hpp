// SPDX-License-Identifier: MIT
#pragma once

#include "stickslip/solver/beam_model.hpp"

namespace stickslip::testing {

/// 1/2 q^T K q of bending, J.
inline double elastic_energy(const solver::BeamModel& model, const Eigen::VectorXd& q) {
  return 0.5 * q.dot(model.elastic_stiffness() * q);
}

/// -P/2 q^T K_G q of the axial force, J.
inline double geometric_energy(const solver::BeamModel& model, const Eigen::VectorXd& q) {
  return -0.5 * model.beam().axial_force() * q.dot(model.geometric_stiffness() * q);
}

}  // namespace stickslip::testing
