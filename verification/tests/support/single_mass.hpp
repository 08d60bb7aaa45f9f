// SPDX-License-Identifier: MIT
#pragma once

/// One mass with a frictional contact, the system on which the contact logic is checked against exact
/// solutions.

#include <memory>

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

/// Friction slows it down by 1.5 m/s^2.
inline constexpr SingleMass sliding_mass{.mass = 2.0, .normal_force = 30.0, .friction = coulomb};

/// omega = 2 rad/s; a half cycle takes 0.2 m off the amplitude, and within 0.1 m of the origin friction holds the mass.
inline constexpr SingleMass oscillating_mass{.stiffness = 4.0, .normal_force = 4.0, .friction = coulomb};

[[nodiscard]] solver::SparseMatrix scalar_matrix(double value);

[[nodiscard]] solver::PrescribedMotion at_rest();

/// w_tt = amplitude sin(2 pi hz t).
[[nodiscard]] solver::PrescribedMotion shaken(double amplitude, double hz);

[[nodiscard]] solver::ContactSystem contact_system(const SingleMass& mass,
                                                   solver::PrescribedMotion wall = at_rest());

[[nodiscard]] Eigen::VectorXd scalar(double value);

/// A run on a wall at rest that starts in slip, at this position (m) and velocity (m/s), after the first step that ends
/// at or after end_time, s.
[[nodiscard]] std::unique_ptr<solver::StickSlipIntegrator> run_from_slip(
    const SingleMass& mass, const solver::IntegratorSettings& settings, double position, double velocity,
    double end_time);

}  // namespace stickslip::testing
