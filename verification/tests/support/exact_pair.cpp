// SPDX-License-Identifier: MIT
#include "support/exact_pair.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace stickslip::testing {

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

void ExactPair::run(double end_time, const std::function<void(const ExactPair&)>& visit) {
  const double span = end_time / 1000.0;
  visit(*this);
  while (end_time - time_ > 1e-12 * end_time) {
    const double length = std::min(span, end_time - time_);
    const double end = excess(length) < 0.0 ? length : phase_end(length);
    state_ = after(end);
    time_ += end;
    visit(*this);
    if (end == length) continue;
    change_phase();
    visit(*this);
  }
}

Eigen::Vector2d ExactPair::velocity_derivative(int order) const {
  State x = state_;
  for (int i = 0; i < order; ++i) x = rate_matrix() * x;
  return x.segment<2>(2);
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
