// SPDX-License-Identifier: MIT
#include "support/single_mass.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace stickslip::testing {

solver::SparseMatrix scalar_matrix(double value) {
  solver::SparseMatrix matrix(1, 1);
  matrix.insert(0, 0) = value;
  return matrix;
}

solver::PrescribedMotion at_rest() {
  const auto zero = [](double) { return 0.0; };
  return {zero, zero, zero};
}

solver::PrescribedMotion shaken(double amplitude, double hz) {
  const double omega = 2.0 * std::numbers::pi * hz;
  return {[=](double t) { return -amplitude / (omega * omega) * std::sin(omega * t); },
          [=](double t) { return -amplitude / omega * std::cos(omega * t); },
          [=](double t) { return amplitude * std::sin(omega * t); }};
}

solver::ContactSystem contact_system(const SingleMass& mass, solver::PrescribedMotion wall) {
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

Eigen::VectorXd scalar(double value) { return Eigen::VectorXd::Constant(1, value); }

std::unique_ptr<solver::StickSlipIntegrator> run_from_slip(const SingleMass& mass,
                                                           const solver::IntegratorSettings& settings,
                                                           double position, double velocity,
                                                           double end_time) {
  auto run = std::make_unique<solver::StickSlipIntegrator>(contact_system(mass), settings);
  run->start_slipping(scalar(position), scalar(velocity));
  while (run->time() < end_time) run->step();
  return run;
}

}  // namespace stickslip::testing
