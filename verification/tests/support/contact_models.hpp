// SPDX-License-Identifier: MIT
#pragma once

/// Small systems with one frictional contact, on which the contact logic is checked against exact solutions: one mass, and
/// two masses. As the ContactSystem of the time stepper and as the ContactModel of the event-driven engine,
/// reduced by hand, so that it shares nothing with the finite-element reduction of studies/.

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"
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

/// w_tt = amplitude sin(2 pi hz t).
[[nodiscard]] solver::PrescribedMotion shaken(double amplitude, double hz);

[[nodiscard]] solver::ContactSystem contact_system(const SingleMass& mass);

/// With another motion of the wall.
[[nodiscard]] solver::ContactSystem contact_system(const SingleMass& mass, solver::PrescribedMotion wall);

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

/// The exact motion of a ForcedPair that starts stuck with the wall's velocity, its first mass at rest at the origin. If holding
/// the second mass takes more than the limit, it slips from the start.
class ExactPair {
 public:
  /// The second mass starts at `position`, m.
  explicit ExactPair(const ForcedPair& pair, double position = 0.0);

  /// Runs to end_time; looks for the end of a phase on a grid of 1/1000 of it.
  void run(double end_time);

  [[nodiscard]] const std::vector<data::ContactEvent>& events() const { return events_; }
  [[nodiscard]] Eigen::Vector2d displacement() const { return state_.head<2>(); }
  [[nodiscard]] Eigen::Vector2d velocity() const { return state_.segment<2>(2); }
  [[nodiscard]] bool stuck() const { return direction_ == 0.0; }

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
