// SPDX-License-Identifier: MIT
#pragma once

/// One mass with a frictional contact, the system on which the contact logic is checked against exact
/// solutions.

#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::testing {

/// Coulomb friction, mu = 0.1.
inline constexpr data::FrictionCoefficients coulomb{
    .static_coefficient = 0.1, .kinetic_coefficient = 0.1, .decay = 0.0};

struct SingleMass {
  double mass{1.0};
  double stiffness{};  ///< of a spring to the fixed frame, in slip; irrelevant while stuck to a wall at rest
  double damping{};
  double normal_force{};
  data::FrictionCoefficients friction{};
};

[[nodiscard]] solver::SparseMatrix scalar_matrix(double value);

[[nodiscard]] solver::PrescribedMotion at_rest();

/// w_tt = amplitude sin(2 pi hz t).
[[nodiscard]] solver::PrescribedMotion shaken(double amplitude, double hz);

[[nodiscard]] solver::ContactSystem contact_system(const SingleMass& mass,
                                                   solver::PrescribedMotion wall = at_rest());

[[nodiscard]] Eigen::VectorXd scalar(double value);

}  // namespace stickslip::testing
