// SPDX-License-Identifier: MIT
#pragma once

/// A contact by the modes of its free structure, propagated exactly under a friction force that is constant
/// over each step: the response of boundary_integral.hpp with R = exp, cut off after the modes kept.
/// Undamped,
///
///     q_k_tt + ω_k² q_k = g_k (f_d - f_h),        v_s = Σ_k q_k_t,
///
/// with f_h the holding force. The sliding velocity v of a step is its mean, [Σ_k q_k(t + h) - Σ_k q_k(t)]/h, so that
/// h v f_d is the exact work of friction.

#include <vector>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

struct FreeMode {
  double angular_frequency{};  ///< ω_k ≥ 0, rad/s
  double input{};              ///< g_k: acceleration of the contact in this mode per unit force on it, 1/kg
};

/// The first `count` slip modes of the beam, g_k = 1/(ρ A ∫ ψ*_k ψ_k dx) by quadrature. Throws what
/// slip_modes() throws.
[[nodiscard]] std::vector<FreeMode> free_modes(const data::Beam& beam, int count);

/// A run from q = 0.
class FreeModeRun {
 public:
  /// Throws std::invalid_argument unless time_step > 0 and κ W_0 < 1 (contact_steps()).
  FreeModeRun(const std::vector<FreeMode>& modes, const ContactLaw& law, double time_step);

  /// The next step, under the mean holding force over it, N.
  ContactStep step(double holding_force);

  /// q_k, m: the deviation from the motion with the contact held is Σ_k ψ_k(x) q_k.
  [[nodiscard]] const std::vector<double>& amplitudes() const noexcept { return displacement_; }

 private:
  ContactElement contact_;
  double time_step_;
  double first_weight_{};  // W_0
  // With a = ω_k h: cos a, sin(a)/a and a sin a turn q_k and h q_k_t.
  std::vector<double> cosine_, to_displacement_, to_velocity_;
  std::vector<double> displacement_, velocity_;              // q_k, h q_k_t
  std::vector<double> displacement_input_, velocity_input_;  // what a unit force adds to them in a step
  double increment_{};                                       // of sum q_k over the next step if no force acts
};

}  // namespace stickslip::analytic
