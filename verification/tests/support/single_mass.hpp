#pragma once

/// One mass with a frictional contact, the system on which the contact logic is checked against exact
/// solutions.

#include <cmath>
#include <numbers>
#include <utility>

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

inline solver::SparseMatrix scalar_matrix(double value) {
  solver::SparseMatrix matrix(1, 1);
  matrix.insert(0, 0) = value;
  return matrix;
}

inline solver::PrescribedMotion at_rest() {
  const auto zero = [](double) { return 0.0; };
  return {zero, zero, zero};
}

/// w_tt = amplitude sin(2 pi hz t).
inline solver::PrescribedMotion shaken(double amplitude, double hz) {
  const double omega = 2.0 * std::numbers::pi * hz;
  return {[=](double t) { return -amplitude / (omega * omega) * std::sin(omega * t); },
          [=](double t) { return -amplitude / omega * std::cos(omega * t); },
          [=](double t) { return amplitude * std::sin(omega * t); }};
}

inline solver::ContactSystem contact_system(const SingleMass& mass,
                                            solver::PrescribedMotion wall = at_rest()) {
  return {.mass = scalar_matrix(mass.mass),
          .damping = scalar_matrix(mass.damping),
          .stick_stiffness = scalar_matrix(mass.stiffness),
          .slip_stiffness = scalar_matrix(mass.stiffness),
          .load_shape = Eigen::VectorXd::Zero(1),
          .load_history = [](double) { return 0.0; },
          .contact = 0,
          .wall = std::move(wall),
          .normal_force = mass.normal_force,
          .friction = data::FrictionLaw(mass.friction)};
}

inline Eigen::VectorXd scalar(double value) { return Eigen::VectorXd::Constant(1, value); }

}  // namespace stickslip::testing
