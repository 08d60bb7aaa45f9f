// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "stickslip/solver/contact_system.hpp"
#include "stickslip/solver/generalized_alpha.hpp"

namespace stickslip::solver {

/// What holding the contact of a system to its wall takes: a force while it is held, an impulse to begin with.
class HeldContact {
 public:
  /// `system` must outlive this. Throws data::InputError if its mass is not positive definite.
  explicit HeldContact(const ContactSystem& system);

  /// v_s = q_t[c] - w_t, m/s.
  [[nodiscard]] double sliding_velocity(const Kinematics& state, double t) const;

  /// The friction force that gives the contact the acceleration of the wall, N,
  /// f_d = r_q · q + r_v · v + r_s s(t) + m_c ẅ(t), with a term r_s s for each further load.
  [[nodiscard]] double holding_force(const Kinematics& state, double t) const;

  /// v <- v - M⁻¹ e_c m_c v_s: the contact takes the velocity of the wall by an impulse at it alone.
  void remove_sliding_velocity(Kinematics& state, double t) const;

  /// The holding force after remove_sliding_velocity(), N: the impulse changes the damping force by -c_c v_s, c_c = r_v · m_c M⁻¹ e_c.
  [[nodiscard]] double holding_force_at_rest(const Kinematics& state, double t) const {
    return holding_force(state, t) - damping_ * sliding_velocity(state, t);
  }

  /// m_c = 1/(e_c . M⁻¹ e_c), kg; 0 for a contact without mass.
  [[nodiscard]] double mass() const noexcept { return mass_; }

 private:
  const ContactSystem& system_;
  Eigen::VectorXd impulse_response_;                         // m_c M⁻¹ e_c
  Eigen::VectorXd displacement_factors_, velocity_factors_;  // r_q, r_v
  double load_factor_{}, mass_{}, damping_{};                // r_s, m_c, c_c
  std::vector<double> further_factors_;                      // r_s of the further loads
};

}  // namespace stickslip::solver
