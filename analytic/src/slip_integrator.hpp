// SPDX-License-Identifier: MIT
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "gsl_handles.hpp"
#include "stickslip/analytic/contact_dynamics.hpp"

namespace stickslip::analytic {

/// A slip phase by GSL's rk8pd, step by step, ended at the first zero of the sliding velocity.
///
/// The unknowns are q = (T, u_c), q_t and, if asked for, the four works of EventDrivenEnergy.
class SlipIntegrator {
 public:
  /// `dynamics` must outlive this. `reference_velocity` in m/s.
  SlipIntegrator(const ContactDynamics& dynamics, double tolerance, double reference_velocity,
                 bool keep_energy_balance);

  /// Begins a phase at time t that moves in `direction` = +1 or -1.
  void begin(double t, const ContactKinematics& state, double direction);
  /// Begins the next phase at the end of the last one, where v_s = 0.
  void begin_next(double direction);

  /// Goes on at the end of the last step on the piece of the drive that `dynamics` has entered since.
  void go_on();

  /// Takes one step, shortened to end at `until` at the latest, or at the first zero of v_s in it; true if there is one.
  /// Throws std::runtime_error, saying when, if no finite step can be taken.
  [[nodiscard]] bool step(double until);

  [[nodiscard]] double end_time() const noexcept { return end_.time; }
  [[nodiscard]] double direction() const noexcept { return direction_; }

  /// The state, and the works since the beginning of the phase (zeros if not asked for).
  struct Sample {
    ContactKinematics state;
    Powers works;
  };
  /// At a time within the last step, or at the beginning of the phase.
  [[nodiscard]] Sample at(double t);

  /// f_d that would give the contact the wall's acceleration at the end of the last step.
  [[nodiscard]] double holding_force() const;

  /// f_d at a sliding velocity, on the branch of this phase.
  [[nodiscard]] double friction_force(double sliding_velocity) const;

 private:
  struct Node {
    double time{};
    std::vector<double> y;
    std::vector<double> rate;          // y_t
    std::array<double, 3> velocity{};  // direction times v_s, v_s_t, v_s_tt
  };
  enum class Passage;

  static int right_side(double t, const double y[], double rate[], void* self);
  void evaluate(double t, const double* y, double* rate) const;
  void begin_at_end(double direction);
  /// q_tt under a load and the contact force f.
  void accelerate(const double* y, const LoadFactors& load, double f, std::span<double> result) const;
  [[nodiscard]] Powers works_of(const std::vector<double>& y) const;
  void measure(Node& node) const;
  /// One Runge-Kutta step; leaves the error estimate in error_. False if not finite.
  [[nodiscard]] bool take(const Node& from, double length, Node& to);
  [[nodiscard]] double interpolation_error(const Node& next) const;
  [[nodiscard]] Passage passage(const Node& next, double& low, double& high) const;
  [[nodiscard]] std::optional<double> polished_zero(double low, double high);

  const ContactDynamics& dynamics_;
  std::size_t size_, dimension_, equations_;  // of q; of q and q_t; with the works
  double longest_step_, shortest_step_;
  double velocity_floor_;  // m/s: below it a sign of v_s is round-off
  data::FrictionLaw law_;
  double direction_{};
  gsl_odeiv2_system system_;
  OwnedHandle<gsl_odeiv2_step> stepper_;
  OwnedHandle<gsl_odeiv2_control> control_;
  std::vector<double> error_;
  mutable std::vector<double> jerk_;
  double mobility_;  // acceleration of the contact per unit f_d, 1/kg

  std::optional<Node> before_;  // the node before begin_, of the same phase
  Node begin_, end_, trial_;
  double length_{};
};

}  // namespace stickslip::analytic
