// SPDX-License-Identifier: MIT
#pragma once

/// Stick-slip in fixed steps, fast: for maps of many long runs.
///
/// The equations of a ContactModel with its contact free are one linear system, whose eigenvectors separate it,
/// damped or not. With the complex amplitudes z_k scaled to the velocity of the contact,
///
///     z_k_t = λ_k z_k + g_k (f_d + F_c) + b_k(t),        u_c_t = Re Σ_k z_k.
///
/// A step h = 2 π/(Ω n) propagates each z_k exactly under the load and a friction force that is constant
/// over the step. Then the sliding velocity at its end is v_1 = p + W f_d with one number W = Re sum g_k
/// (exp(λ_k h) - 1)/λ_k, and the law of friction is a scalar one:
///
///     stick:  v_1 = 0,   |f_d| ≤ μ_s N        slip:  f_d = -sgn(v_1) N μ(|v_0 + v_1|/2).
///
/// A contact that slips goes on in its direction if that has a solution. Else its velocity passes zero in the step. Then
/// it turns round if |p - v_0| > W μ_s N, with the force of each direction for its share of the step, and otherwise it
/// sticks. The mean of the two velocities in the law makes slip of second order in h. Changes of contact are not located:
/// a contact that is caught is at rest at the end of the step, which costs a displacement of order h² only.
///
/// Friction takes the work -h f_d (v_0 + v_1)/2 in a step, and stays passive, only while |λ_k| h < π. Modes with
/// |λ_k| h > 2 are propagated by the trapezoidal rule, which is passive at any step.
///
/// The load of a general motion is in each step the parabola through its values at begin, middle and end. For one of the frequency ω that
/// is off by at most (ω h)³/124 of its amplitude, with a mean of 0 to the next order; a jump inside of a step is smeared over it.

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::analytic {

/// Two eigenvectors are too nearly parallel.
class InseparableModes : public data::InputError {
 public:
  using InputError::InputError;
};

/// The eigenvectors of a ContactModel with its contact free. They do not depend on load, wall and friction.
class ContactModes {
 public:
  /// Throws InseparableModes if two eigenvectors are too nearly parallel for nine digits, as next to critical
  /// damping or to flutter, and std::invalid_argument as require_consistent().
  explicit ContactModes(const ContactModel& model);

 private:
  friend class ModalContactRun;
  using Complex = std::complex<double>;

  std::size_t size_{};               // 2 (m + 1)
  std::vector<double> scale_;        // coordinates (T, u_c) times these, and their rates, are Re(Z z)
  std::vector<Complex> eigenvalue_;  // λ_k, rad/s, one of each complex pair
  std::vector<Complex> shape_;       // Z, size_ rows of eigenvalue_.size()
  std::vector<Complex> inverse_;     // z = W y, eigenvalue_.size() rows of size_
};

/// A run of a ContactModel.
class ModalContactRun {
 public:
  /// `modes`: of this model, whatever its load, wall and friction were; `steps_per_period`: n ≥ 4, of a general motion in a period of
  /// its highest frequency. Throws
  /// data::InputError, naming numerics.time_step, unless κ W < 2, so that each step has one solution, and naming
  /// wall.speed unless that is 0.
  ModalContactRun(const ContactModes& modes, const ContactModel& model, int steps_per_period);

  /// Starts at t = 0. The contact sticks if its velocity is that of the wall, to rounding.
  void start(const ContactKinematics& state);
  /// At rest on the wall, as held_start() says.
  void start_stuck();

  void step();

  [[nodiscard]] double time_step() const noexcept { return time_step_; }  ///< h, s
  [[nodiscard]] std::size_t steps() const noexcept { return steps_; }     ///< since the start
  [[nodiscard]] double time() const noexcept { return static_cast<double>(steps_) * time_step_; }
  [[nodiscard]] bool slips() const noexcept { return slips_; }                          ///< in the last step
  [[nodiscard]] double sliding_velocity() const noexcept { return sliding_velocity_; }  ///< v_s, m/s
  /// The contact turned round in the last step, and may have stuck in between for less than a step: a contact with the acceleration
  /// a before it stops takes a force of modulus |μ_s N - (m_c - a . a) |a|| to hold it at first, which is in reach to the accuracy
  /// that |a| is known to by the last two steps. The steps do not follow the modes that make it slip again.
  [[nodiscard]] bool may_hide_stick() const noexcept { return may_hide_stick_; }
  /// f_d of the last step, N.
  [[nodiscard]] double friction_force() const noexcept { return friction_force_; }
  [[nodiscard]] double contact_position() const;  ///< u_c - w, m
  [[nodiscard]] ContactKinematics state() const;
  /// z_k, m/s.
  [[nodiscard]] std::vector<std::complex<double>> amplitudes() const;

 private:
  using Complex = std::complex<double>;
  struct Slip;
  [[nodiscard]] double falling_force(double speed);
  [[nodiscard]] Slip slip(double free_speed, double speed_before, double expected_force);
  void set_friction();
  [[nodiscard]] bool turns_round(double free_velocity, double further);
  void update_contact(double free_velocity);
  void advance(double force);
  double add(std::size_t mode, Complex value);
  void add_load();
  void add_drive();
  void set_drive(const ContactDynamics& dynamics);
  [[nodiscard]] double wall_velocity() const;  // at the present time

  // Four modes beside each other, so that a compiler takes them at once.
  static constexpr std::size_t lanes = 4;
  struct ComplexLanes {
    std::array<double, lanes> real{}, imaginary{};
  };
  struct Block {
    ComplexLanes turn;       // exp(λ h)
    ComplexLanes input;      // what a unit of force adds in a step
    ComplexLanes amplitude;  // z_k without its steady part
  };
  // The part of the load in z_k as sine sin(Ω t) + cosine cos(Ω t): the steady vibration of a mode
  // or, next to resonance, what a step from t adds.
  struct Steady {
    std::size_t mode{};
    Complex sine, cosine;
  };
  // h_tt, h_t or h of a general motion, where the model has a load by it.
  struct Channel {
    double LoadFactors::*factor{};
    std::array<double, 3> values{};                     // at begin, middle and end of the step
    std::array<std::vector<ComplexLanes>, 3> inputs{};  // what a unit of each adds in a step
    std::array<double, 3> weights{};                    // Re Σ_k of that
  };
  void add_load(std::size_t mode, Complex sine, Complex cosine);

  const ContactModes* modes_;
  ContactModel model_;
  std::size_t period_;  // n
  double time_step_{};
  std::vector<Block> blocks_;
  std::vector<Steady> steady_, resonant_;
  std::vector<double> sine_, cosine_;      // of Ω t at the steps of a period
  std::optional<ContactDynamics> motion_;  // of a general motion
  std::vector<Channel> channels_;
  std::vector<double> offset_;  // steady velocity of the contact without friction, less that of the wall
  double weight_{};             // W
  double static_limit_{}, kinetic_force_{}, friction_drop_{}, decay_{}, viscous_{};  // the law, N and N s/m
  double known_speed_{}, known_force_{};  // a value of the falling part
  std::size_t steps_{}, phase_{};         // since the start, and since the begin of a period
  double free_velocity_{};                // p
  double sliding_velocity_{}, friction_force_{}, force_before_{};
  double change_{}, change_before_{};  // of the sliding velocity, in the last step and in the one before
  double
      free_step_{};  // what a unit of force changes of it in h, if the modes do not follow: h/(m_c - a . a)
  bool slips_{}, may_hide_stick_{};
};

}  // namespace stickslip::analytic
