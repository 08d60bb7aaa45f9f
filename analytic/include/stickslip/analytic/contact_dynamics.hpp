// SPDX-License-Identifier: MIT
#pragma once

/// The rows of a ContactModel: accelerations, forces, energies.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"

namespace stickslip::analytic {

/// T, T_t, u_c, u_c_t.
struct ContactKinematics {
  std::vector<double> amplitudes;
  std::vector<double> rates;
  double displacement{};
  double velocity{};
};

/// The same without owning the modal part.
struct KinematicsView {
  std::span<const double> amplitudes;
  std::span<const double> rates;
  double displacement{};
  double velocity{};
};

[[nodiscard]] inline KinematicsView view(const ContactKinematics& state) {
  return {state.amplitudes, state.rates, state.displacement, state.velocity};
}

/// The state x = (T, u_c, T_t, u_c_t) of a model with that many modes.
[[nodiscard]] inline KinematicsView view(const double* x, std::size_t modes) {
  return {{x, modes}, {x + modes + 1, modes}, x[modes], x[2 * modes + 1]};
}

[[nodiscard]] ContactKinematics copy(const KinematicsView& state);

/// (T, u_c, T_t, u_c_t).
[[nodiscard]] std::vector<double> flat(const ContactKinematics& state);

/// The function sine sin(Ω t) + cosine cos(Ω t) + constant + rate t. The last two come from the speed of the wall.
struct Harmonic {
  double sine{};
  double cosine{};
  double constant{};
  double rate{};
};

/// Factors of ContactModel::load, load_cosine and base_load: sin(Ω t), cos(Ω t) and 0, or h_tt, h_t and h, or their rates.
struct LoadFactors {
  double sine{}, cosine{}, base{};
};

/// Rates at which the works of EventDrivenEnergy grow, W.
struct Powers {
  double base{}, follower{}, damping{}, friction{};
};

class ContactDynamics {
 public:
  explicit ContactDynamics(const ContactModel& model);

  [[nodiscard]] const ContactModel& model() const noexcept { return model_; }
  [[nodiscard]] std::size_t modes() const noexcept { return model_.modes(); }
  /// The highest of ω_n and Ω, rad/s.
  [[nodiscard]] double fastest() const;

  /// Of a general motion: moves to the piece of the drive that begins at t or holds it. All functions of time are those of this
  /// piece, until the next one is entered. Of one sine nothing happens, and it has one piece.
  void enter(double t) const;
  [[nodiscard]] double piece_end() const;  ///< s
  [[nodiscard]] const DrivePiece& piece() const { return cursor_->piece(); }

  [[nodiscard]] double base_displacement(double t) const;  ///< h; 0 under a force, as
  [[nodiscard]] double base_velocity(double t) const;      ///< its rate
  [[nodiscard]] double base_acceleration(double t) const;
  [[nodiscard]] LoadFactors load(double t) const;
  [[nodiscard]] LoadFactors load_rate(double t) const;
  [[nodiscard]] double wall_displacement(double t) const;  ///< w
  [[nodiscard]] double wall_velocity(double t) const;
  [[nodiscard]] double wall_acceleration(double t) const;
  [[nodiscard]] double wall_jerk(double t) const;

  /// Accelerations under a load and the contact force f, which is f_d + F_c; writes T_tt and returns u_c_tt. Linear in all its
  /// arguments, so that their rates give the rate of the result. Not without a free mass.
  double accelerate(const KinematicsView& state, const LoadFactors& load, double f,
                    std::span<double> modal) const;

  /// f_d that gives the contact the acceleration of the wall.
  [[nodiscard]] double holding_force(const KinematicsView& state, double t) const;

  /// y_tt of the contact (m/s²) and what the base must apply, as in HeldStructure::base_balances, under f_d. All terms are of the modes of
  /// the model; the inertia of the others is in the masses, so that what they add is of the order h_tttt/ω², and u_c_tttt/ω² in slip.
  struct Reactions {
    double contact_acceleration{};
    std::vector<double> base{};
  };
  [[nodiscard]] Reactions reactions(const KinematicsView& state, double t, double friction_force) const;

  [[nodiscard]] Powers powers(const KinematicsView& state, double t, double friction_force) const;
  [[nodiscard]] double kinetic_energy(const KinematicsView& state) const;
  [[nodiscard]] double potential_energy(const KinematicsView& state) const;

  /// The force T_n sees while the contact is held, as it stands in T_n_tt + (C T_t)_n + ω_n² T_n = held_load.
  [[nodiscard]] Harmonic held_load(std::size_t mode) const;

  /// holding_force = sum ρ_n T_n + sum ρ_(m+n) T_n_t + held_stiffness() (u_c - w) - F_c + held_force().
  [[nodiscard]] std::vector<double> held_force_row() const;
  [[nodiscard]] double held_stiffness() const { return model_.contact_stiffness + model_.contact_follower; }
  [[nodiscard]] Harmonic held_force() const;

 private:
  [[nodiscard]] double damping(std::size_t row, std::size_t column) const {
    return model_.damping.empty() ? 0.0 : model_.damping(row, column);
  }
  [[nodiscard]] double load_cosine(std::size_t row) const {
    return model_.load_cosine.empty() ? 0.0 : model_.load_cosine[row];
  }

  /// What moves the contact if the modes follow: writes T_tt for a contact without acceleration, and returns (m_c - a . a) u_c_tt.
  double push(const KinematicsView& state, const LoadFactors& load, double f, std::span<double> modal) const;

  [[nodiscard]] double along_wall(int rate, double t) const;
  void take_piece() const;

  ContactModel model_;
  mutable std::optional<DriveCursor> cursor_;
  mutable std::array<Polynomial, 4> base_{}, wall_{};  // of the piece, with their derivatives
  double free_mass_;  // m_c - a . a: what f_d accelerates when the modes may follow
  static constexpr std::size_t kTogether = 4;
  std::vector<double> damping_columns_;  // C by column, each filled up with zeros to a multiple of kTogether
  std::size_t column_length_{};
};

}  // namespace stickslip::analytic
