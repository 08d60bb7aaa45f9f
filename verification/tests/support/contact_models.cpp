// SPDX-License-Identifier: MIT
#include "support/contact_models.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

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

solver::ContactSystem contact_system(const SingleMass& mass) {
  return {.mass = scalar_matrix(mass.mass),
          .damping = scalar_matrix(mass.damping),
          .stick_stiffness = scalar_matrix(mass.stiffness),
          .slip_stiffness = scalar_matrix(mass.stiffness),
          .load_shape = Eigen::VectorXd::Zero(1),
          .load_history = [](double) { return 0.0; },
          .contact = 0,
          .wall = mass.wall_acceleration == 0.0
                      ? at_rest()
                      : shaken(mass.wall_acceleration, mass.omega / (2.0 * std::numbers::pi)),
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

analytic::ContactModel contact_model(const SingleMass& mass) {
  return {.angular_frequency = {},
          .mass_coupling = {},
          .contact_mass = mass.mass,
          .contact_stiffness = mass.stiffness,
          .follower = {},
          .contact_follower = 0.0,
          .damping = {},
          .load = {0.0},
          .load_angular_frequency = mass.omega,
          .wall_amplitude = -mass.wall_acceleration / (mass.omega * mass.omega),
          .normal_force = mass.normal_force,
          .friction = data::FrictionLaw(mass.friction)};
}

SingleMass shaken_plane(double amplitude) {
  return {.normal_force = 10.0,
          .friction = coulomb,
          .wall_acceleration = amplitude,
          .omega = 2.0 * std::numbers::pi};
}

double static_shape(const ForcedPair& pair) {
  return -pair.stick_stiffness(0, 1) / pair.stick_stiffness(0, 0);
}
double mode_shape(const ForcedPair& pair) { return 1.0 / std::sqrt(pair.mass(0, 0)); }

analytic::ContactModel contact_model(const ForcedPair& pair) {
  const double sigma = static_shape(pair), mode = mode_shape(pair);
  const Eigen::Matrix2d& k = pair.stick_stiffness;
  const Eigen::Matrix2d& m = pair.mass;
  const Eigen::Matrix2d& c = pair.damping;
  const double follower = pair.slip_stiffness(1, 0) - k(1, 0);
  analytic::Matrix damping(2, 2);
  damping(0, 0) = mode * c(0, 0) * mode;
  damping(0, 1) = mode * (c(0, 0) * sigma + c(0, 1));
  damping(1, 0) = (sigma * c(0, 0) + c(1, 0)) * mode;
  damping(1, 1) = sigma * (c(0, 0) * sigma + c(0, 1)) + c(1, 0) * sigma + c(1, 1);
  return {.angular_frequency = {std::sqrt(k(0, 0) / m(0, 0))},
          .mass_coupling = {mode * (m(0, 0) * sigma + m(0, 1))},
          .contact_mass = sigma * (m(0, 0) * sigma + 2.0 * m(0, 1)) + m(1, 1),
          .contact_stiffness = k(1, 1) - k(0, 1) * k(0, 1) / k(0, 0),
          .follower = {follower * mode},
          .contact_follower = follower * sigma,
          .damping = damping,
          .load = {mode * pair.load[0], sigma * pair.load[0] + pair.load[1]},
          .load_angular_frequency = pair.omega,
          .wall_amplitude = pair.wall_amplitude,
          .normal_force = pair.normal_force,
          .friction = data::FrictionLaw({.static_coefficient = pair.friction_coefficient,
                                         .kinetic_coefficient = pair.friction_coefficient,
                                         .decay = 0.0})};
}

std::vector<double> free_contact_frequencies(const analytic::ContactModel& model, int count) {
  const auto m = static_cast<Eigen::Index>(model.modes());
  const auto vector_of = [m](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), m);
  };
  Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(m + 1, m + 1),
                  stiffness = Eigen::MatrixXd::Zero(m + 1, m + 1);
  mass.col(m).head(m) = mass.row(m).head(m).transpose() = vector_of(model.mass_coupling);
  mass(m, m) = model.contact_mass;
  stiffness.diagonal().head(m) = vector_of(model.angular_frequency).cwiseAbs2();
  stiffness.row(m).head(m) = vector_of(model.follower);
  stiffness(m, m) = model.contact_stiffness + model.contact_follower;
  const Eigen::VectorXcd inverse_squares =
      Eigen::EigenSolver<Eigen::MatrixXd>(stiffness.partialPivLu().solve(mass), false).eigenvalues();
  if (!inverse_squares.imag().isZero(0.0) || inverse_squares.real().minCoeff() <= 0.0)
    throw std::runtime_error("a frequency of the free contact is complex: it flutters or buckles");
  std::vector<double> frequencies;
  for (const double value : inverse_squares.real()) frequencies.push_back(1.0 / std::sqrt(value));
  std::ranges::sort(frequencies);
  frequencies.resize(static_cast<std::size_t>(count));
  return frequencies;
}

}  // namespace stickslip::testing
