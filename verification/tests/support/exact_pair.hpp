// SPDX-License-Identifier: MIT
#pragma once

/// Two masses with a Coulomb contact on the second, solved exactly: a linear system in each phase, by the
/// matrix exponential, with the ends of the phases found by bisection. Knows nothing of the solver's step.

#include <Eigen/Dense>
#include <functional>
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

/// The next term of an error of second order in 12 s of this pair, relative to the leading one: omega h of the
/// higher frequency, 6/s, and 23 h/12 for the 23 changes, each of which splits a step.
inline double next_term_of_the_pair(double time_step) { return (6.0 + 23.0 / 12.0) * time_step; }

[[nodiscard]] solver::ContactSystem contact_system(const ForcedPair& pair);

/// The exact motion of a ForcedPair that starts stuck with the wall's velocity, its first mass at rest at the origin. If holding
/// the second mass takes more than the limit, it slips from the start.
class ExactPair {
 public:
  /// The second mass starts at `position`, m.
  explicit ExactPair(const ForcedPair& pair, double position = 0.0);

  /// Runs to end_time; looks for the end of a phase on a grid of 1/1000 of it. Visits the start, the points
  /// of the grid and both sides of every change: between two visits at different times lies a piece of one
  /// phase.
  void run(
      double end_time, const std::function<void(const ExactPair&)>& visit = [](const ExactPair&) {});

  [[nodiscard]] const std::vector<data::ContactEvent>& events() const { return events_; }
  [[nodiscard]] Eigen::Vector2d displacement() const { return state_.head<2>(); }
  [[nodiscard]] Eigen::Vector2d velocity() const { return state_.segment<2>(2); }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] bool stuck() const { return direction_ == 0.0; }
  /// The derivative of the velocity of that order, 1 the acceleration.
  [[nodiscard]] Eigen::Vector2d velocity_derivative(int order) const;

 private:
  // (q_1, q_2, v_1, v_2, sin omega t, cos omega t, 1): every phase is x_t = A x.
  using State = Eigen::Matrix<double, 7, 1>;
  using Matrix = Eigen::Matrix<double, 7, 7>;
  using Kind = data::ContactChange;

  using Rows = Eigen::Matrix<double, 2, 7>;

  [[nodiscard]] Rows forces(const Eigen::Matrix2d& stiffness) const;  // -C v - K q + p sin(omega t)
  [[nodiscard]] Rows held_acceleration() const;                       // the second mass moves with the wall
  [[nodiscard]] Rows sliding_acceleration() const;
  [[nodiscard]] Matrix rate_matrix() const;  // A of the phase
  [[nodiscard]] State after(double length) const;
  [[nodiscard]] double holding_force(const State& x) const;  // friction that holding the second mass takes
  [[nodiscard]] double sliding_velocity(const State& x) const;
  [[nodiscard]] double excess(double length) const;  // negative while the phase lasts
  [[nodiscard]] double phase_end(double high) const;
  void change_phase();

  ForcedPair pair_;
  State state_;
  double time_{};
  double direction_{};
  std::vector<data::ContactEvent> events_;
};

}  // namespace stickslip::testing
