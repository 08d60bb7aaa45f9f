// SPDX-License-Identifier: MIT
#include "support/contact_models.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>
#include <utility>

namespace stickslip::testing {

solver::SparseMatrix scalar_matrix(double value) {
  solver::SparseMatrix matrix(1, 1);
  matrix.insert(0, 0) = value;
  return matrix;
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
                      ? solver::PrescribedMotion()
                      : shaken(mass.wall_acceleration, mass.omega / (2.0 * std::numbers::pi)),
          .normal_force = mass.normal_force,
          .friction = data::FrictionLaw(mass.friction)};
}

solver::ContactSystem contact_system(const SingleMass& mass, solver::PrescribedMotion wall) {
  solver::ContactSystem system = contact_system(mass);
  system.wall = std::move(wall);
  return system;
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
  analytic::ContactModel model;
  model.contact_mass = mass.mass;
  model.contact_stiffness = mass.stiffness;
  model.load = {0.0};
  model.load_angular_frequency = mass.omega;
  model.wall_amplitude = -mass.wall_acceleration / (mass.omega * mass.omega);
  model.normal_force = mass.normal_force;
  model.friction = data::FrictionLaw(mass.friction);
  return model;
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
  analytic::ContactModel model;
  model.angular_frequency = {std::sqrt(k(0, 0) / m(0, 0))};
  model.mass_coupling = {mode * (m(0, 0) * sigma + m(0, 1))};
  model.contact_mass = sigma * (m(0, 0) * sigma + 2.0 * m(0, 1)) + m(1, 1);
  model.contact_stiffness = k(1, 1) - k(0, 1) * k(0, 1) / k(0, 0);
  model.follower = {follower * mode};
  model.contact_follower = follower * sigma;
  model.damping = damping;
  model.load = {mode * pair.load[0], sigma * pair.load[0] + pair.load[1]};
  model.load_angular_frequency = pair.omega;
  model.wall_amplitude = pair.wall_amplitude;
  model.normal_force = pair.normal_force;
  model.friction = data::FrictionLaw({.static_coefficient = pair.friction_coefficient,
                                      .kinetic_coefficient = pair.friction_coefficient,
                                      .decay = 0.0});
  return model;
}

solver::ContactSystem contact_system(const ForcedPair& pair) {
  const auto sparse = [](const Eigen::Matrix2d& m) {
    return solver::SparseMatrix(Eigen::MatrixXd(m).sparseView());
  };
  const double omega = pair.omega, amplitude = pair.wall_amplitude;
  return {.mass = sparse(pair.mass),
          .damping = sparse(pair.damping),
          .stick_stiffness = sparse(pair.stick_stiffness),
          .slip_stiffness = sparse(pair.slip_stiffness),
          .load_shape = pair.load,
          .load_history = [=](double t) { return std::sin(omega * t); },
          .contact = 1,
          .wall = {[=](double t) { return amplitude * std::sin(omega * t); },
                   [=](double t) { return amplitude * omega * std::cos(omega * t); },
                   [=](double t) { return -amplitude * omega * omega * std::sin(omega * t); }},
          .normal_force = pair.normal_force,
          .friction = data::FrictionLaw({.static_coefficient = pair.friction_coefficient,
                                         .kinetic_coefficient = pair.friction_coefficient,
                                         .decay = 0.0})};
}

ExactPair::ExactPair(const ForcedPair& pair, double position) : pair_(pair) {
  state_ << 0.0, position, 0.0, pair.omega * pair.wall_amplitude, 0.0, 1.0, 1.0;
}

void ExactPair::run(double end_time) {
  const double span = end_time / 1000.0;
  while (end_time - time_ > 1e-12 * end_time) {
    const double length = std::min(span, end_time - time_);
    const double end = excess(length) < 0.0 ? length : phase_end(length);
    state_ = after(end);
    time_ += end;
    if (end < length) change_phase();
  }
}

ExactPair::Rows ExactPair::forces(const Eigen::Matrix2d& stiffness) const {
  Rows rows = Rows::Zero();
  rows.leftCols<2>() = -stiffness;
  rows.middleCols<2>(2) = -pair_.damping;
  rows.col(4) = pair_.load;
  return rows;
}

ExactPair::Rows ExactPair::held_acceleration() const {
  Rows rows = Rows::Zero();
  rows(1, 4) = -pair_.wall_amplitude * pair_.omega * pair_.omega;
  rows.row(0) = (forces(pair_.stick_stiffness).row(0) - pair_.mass(0, 1) * rows.row(1)) / pair_.mass(0, 0);
  return rows;
}

ExactPair::Rows ExactPair::sliding_acceleration() const {
  Rows rows = forces(pair_.slip_stiffness);
  rows(1, 6) -= direction_ * pair_.friction_limit();
  return pair_.mass.inverse() * rows;
}

ExactPair::Matrix ExactPair::rate_matrix() const {
  Matrix a = Matrix::Zero();
  a(0, 2) = a(1, 3) = 1.0;
  a.middleRows<2>(2) = stuck() ? held_acceleration() : sliding_acceleration();
  a(4, 5) = pair_.omega;
  a(5, 4) = -pair_.omega;
  return a;
}

ExactPair::State ExactPair::after(double length) const { return (rate_matrix() * length).exp() * state_; }

double ExactPair::holding_force(const State& x) const {
  return (pair_.mass * held_acceleration() * x - forces(pair_.slip_stiffness) * x)[1];
}

double ExactPair::sliding_velocity(const State& x) const {
  return x[3] - pair_.wall_amplitude * pair_.omega * x[5];
}

double ExactPair::excess(double length) const {
  const State x = after(length);
  return stuck() ? std::abs(holding_force(x)) - pair_.friction_limit() : -direction_ * sliding_velocity(x);
}

double ExactPair::phase_end(double high) const {
  double low = 0.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return low;
}

void ExactPair::change_phase() {
  const double force = holding_force(state_);
  const bool holds = std::abs(force) <= pair_.friction_limit();
  const Kind kind = stuck() ? Kind::onset : holds ? Kind::capture : Kind::reversal;
  direction_ = kind == Kind::capture ? 0.0 : force > 0.0 ? -1.0 : 1.0;
  events_.push_back({.change = kind,
                     .time = time_,
                     .position = state_[1] - pair_.wall_amplitude * state_[4],
                     .residual_velocity = sliding_velocity(state_)});
}

}  // namespace stickslip::testing
