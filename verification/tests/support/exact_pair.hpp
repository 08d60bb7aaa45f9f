#pragma once

/// Two masses with a Coulomb contact on the second, solved exactly: a linear system in each phase, by the
/// matrix exponential, with the ends of the phases found by bisection. Knows nothing of the solver's step.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::testing {

/// M q_tt + C q_t + K q = p sin(omega t) + e_2 f_d, on a wall that moves by W sin(omega t); K_slip is
/// unsymmetric, as the beam's is.
struct ForcedPair {
  Eigen::Matrix2d mass{{2.0, 0.3}, {0.3, 1.0}};
  Eigen::Matrix2d damping{{0.7, 0.5}, {0.5, 0.9}};
  Eigen::Matrix2d stick_stiffness{{30.0, -12.0}, {-12.0, 14.0}};
  Eigen::Matrix2d slip_stiffness{{30.0, -12.0}, {-9.0, 14.0}};
  Eigen::Vector2d load{6.0, -3.0};
  double omega{3.0};
  double wall_amplitude{0.1};
  double normal_force{10.0};
  double friction_coefficient{0.2};

  [[nodiscard]] double friction_limit() const { return friction_coefficient * normal_force; }
};

/// What an error of second order has behind its leading term, relative to it, in 12 s of this pair: omega h
/// of the higher frequency, 6/s, and that each of the 23 changes splits a step, 23 h/12 of the whole.
inline double next_term_of_the_pair(double time_step) { return (6.0 + 23.0 / 12.0) * time_step; }

inline solver::ContactSystem contact_system(const ForcedPair& pair) {
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

/// The exact motion of a ForcedPair that starts stuck, at the displacement of rest, with the wall's velocity.
class ExactPair {
 public:
  explicit ExactPair(const ForcedPair& pair) : pair_(pair) {
    state_ << 0.0, 0.0, 0.0, pair.omega * pair.wall_amplitude, 0.0, 1.0, 1.0;
  }

  /// Runs to end_time; looks for the end of a phase on a grid of 1/1000 of it. Visits the start, the points
  /// of the grid and both sides of every change: between two visits at different times lies a piece of one
  /// phase.
  template <typename Visit>
  void run(double end_time, Visit&& visit) {
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

  void run(double end_time) {
    run(end_time, [](const ExactPair&) {});
  }

  [[nodiscard]] const std::vector<solver::ContactEvent>& events() const { return events_; }
  [[nodiscard]] Eigen::Vector2d displacement() const { return state_.head<2>(); }
  [[nodiscard]] Eigen::Vector2d velocity() const { return state_.segment<2>(2); }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] bool stuck() const { return direction_ == 0.0; }
  /// The derivative of the velocity of that order, 1 the acceleration.
  [[nodiscard]] Eigen::Vector2d velocity_derivative(int order) const {
    State x = state_;
    for (int i = 0; i < order; ++i) x = rate_matrix() * x;
    return x.segment<2>(2);
  }

 private:
  // (q_1, q_2, v_1, v_2, sin omega t, cos omega t, 1): every phase is x_t = A x.
  using State = Eigen::Matrix<double, 7, 1>;
  using Matrix = Eigen::Matrix<double, 7, 7>;
  using Kind = solver::ContactEvent::Kind;

  // -C v - K q + p sin(omega t) as a matrix on the state.
  [[nodiscard]] Eigen::Matrix<double, 2, 7> forces(const Eigen::Matrix2d& stiffness) const {
    Eigen::Matrix<double, 2, 7> rows = Eigen::Matrix<double, 2, 7>::Zero();
    rows.leftCols<2>() = -stiffness;
    rows.middleCols<2>(2) = -pair_.damping;
    rows.col(4) = pair_.load;
    return rows;
  }

  // Accelerations while the second mass moves with the wall.
  [[nodiscard]] Eigen::Matrix<double, 2, 7> held_acceleration() const {
    Eigen::Matrix<double, 2, 7> rows = Eigen::Matrix<double, 2, 7>::Zero();
    rows(1, 4) = -pair_.wall_amplitude * pair_.omega * pair_.omega;
    rows.row(0) = (forces(pair_.stick_stiffness).row(0) - pair_.mass(0, 1) * rows.row(1)) / pair_.mass(0, 0);
    return rows;
  }

  [[nodiscard]] Eigen::Matrix<double, 2, 7> sliding_acceleration() const {
    Eigen::Matrix<double, 2, 7> rows = forces(pair_.slip_stiffness);
    rows(1, 6) -= direction_ * pair_.friction_limit();
    return pair_.mass.inverse() * rows;
  }

  // A of the phase.
  [[nodiscard]] Matrix rate_matrix() const {
    Matrix a = Matrix::Zero();
    a(0, 2) = a(1, 3) = 1.0;
    a.middleRows<2>(2) = stuck() ? held_acceleration() : sliding_acceleration();
    a(4, 5) = pair_.omega;
    a(5, 4) = -pair_.omega;
    return a;
  }

  [[nodiscard]] State after(double length) const { return (rate_matrix() * length).exp() * state_; }

  // The friction force that holding the second mass takes.
  [[nodiscard]] double holding_force(const State& x) const {
    return (pair_.mass * held_acceleration() * x - forces(pair_.slip_stiffness) * x)[1];
  }

  [[nodiscard]] double sliding_velocity(const State& x) const {
    return x[3] - pair_.wall_amplitude * pair_.omega * x[5];
  }

  // Negative while the phase lasts.
  [[nodiscard]] double excess(double length) const {
    const State x = after(length);
    return stuck() ? std::abs(holding_force(x)) - pair_.friction_limit() : -direction_ * sliding_velocity(x);
  }

  [[nodiscard]] double phase_end(double high) const {
    double low = 0.0;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (excess(middle) < 0.0 ? low : high) = middle;
    }
    return low;
  }

  void change_phase() {
    const double force = holding_force(state_);
    const bool holds = std::abs(force) <= pair_.friction_limit();
    const Kind kind = stuck() ? Kind::onset : holds ? Kind::capture : Kind::reversal;
    direction_ = kind == Kind::capture ? 0.0 : force > 0.0 ? -1.0 : 1.0;
    events_.push_back({.kind = kind,
                       .time = time_,
                       .displacement = state_[1] - pair_.wall_amplitude * state_[4],
                       .residual_velocity = sliding_velocity(state_)});
  }

  ForcedPair pair_;
  State state_;
  double time_{};
  double direction_{};
  std::vector<solver::ContactEvent> events_;
};

}  // namespace stickslip::testing
