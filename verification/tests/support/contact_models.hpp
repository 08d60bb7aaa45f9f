// SPDX-License-Identifier: MIT
#pragma once

/// Small systems with one frictional contact, on which the contact logic is checked against exact solutions: one mass, and
/// two masses (exact_pair.hpp). As the ContactSystem of the time stepper and as the ContactModel of the event-driven engine,
/// reduced by hand, so that it shares nothing with the finite-element reduction of studies/.

#include <memory>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"
#include "support/exact_pair.hpp"

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
  double wall_acceleration{};  ///< w_tt = wall_acceleration sin(omega t)
  double omega{1.0};
};

/// Friction slows it down by 1.5 m/s^2.
inline constexpr SingleMass sliding_mass{.mass = 2.0, .normal_force = 30.0, .friction = coulomb};

/// omega = 2 rad/s; a half cycle takes 0.2 m off the amplitude, and within 0.1 m of the origin friction holds the mass.
inline constexpr SingleMass oscillating_mass{.stiffness = 4.0, .normal_force = 4.0, .friction = coulomb};

/// Mass 1 kg, mu N = 1 N, on a plane shaken by w_tt = amplitude sin(2 pi t): case SDND104 of a public validation manual.
[[nodiscard]] SingleMass shaken_plane(double amplitude);

[[nodiscard]] solver::SparseMatrix scalar_matrix(double value);
[[nodiscard]] Eigen::VectorXd scalar(double value);

[[nodiscard]] solver::PrescribedMotion at_rest();

/// w_tt = amplitude sin(2 pi hz t).
[[nodiscard]] solver::PrescribedMotion shaken(double amplitude, double hz);

[[nodiscard]] solver::ContactSystem contact_system(const SingleMass& mass);

/// A single mass has no held modes. Its damping must be zero.
[[nodiscard]] analytic::ContactModel contact_model(const SingleMass& mass);

/// A run on a wall at rest that starts in slip, at this position (m) and velocity (m/s), after the first step that ends
/// at or after end_time, s.
[[nodiscard]] std::unique_ptr<solver::StickSlipIntegrator> run_from_slip(
    const SingleMass& mass, const solver::IntegratorSettings& settings, double position, double velocity,
    double end_time);

/// q_1 = sigma q_2 + U T with sigma = -K_12/K_11 and U = 1/sqrt(M_11).
[[nodiscard]] double static_shape(const ForcedPair& pair);
[[nodiscard]] double mode_shape(const ForcedPair& pair);

[[nodiscard]] analytic::ContactModel contact_model(const ForcedPair& pair);

/// The `count` lowest angular frequencies, rad/s, of a model whose contact is free and whose damping and friction are left out:
/// for the beam, approximations of the clamped-free modes under follower load. From 1/omega^2 as eigenvalues of K^-1 M, so that
/// round-off is relative to the lowest. Throws std::runtime_error if one of them is complex.
[[nodiscard]] std::vector<double> free_contact_frequencies(const analytic::ContactModel& model, int count);

}  // namespace stickslip::testing
