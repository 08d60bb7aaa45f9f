// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/stick_propagator.hpp"

namespace stickslip::analytic {

/// T, T_t and u_c_t = w_t at t = 0, where u_c = 0. Under spectra (Drive::is_random()) a damped structure has been held for all time before:
/// the realisation has the period of its duration, and what came before it decays as the slowest mode does and is left out where that is
/// below 1e-10. Else T = T_t = 0.
[[nodiscard]] ContactKinematics held_start(const ContactModel& model);

/// A structure whose contact is held from t = 0 on, under a general motion (ContactModel::drive), exactly but for the modes left out:
/// StickPropagator, piece by piece. It starts as held_start() says, wherever base and wall are.
class HeldMotion {
 public:
  explicit HeldMotion(const ContactModel& model);

  [[nodiscard]] double piece_end() const { return dynamics_.piece_end(); }
  /// Goes on at the end of the piece on the next one.
  void enter_next_piece();
  /// f_d at t ≥ the times of earlier calls, N: the pieces before it are gone.
  [[nodiscard]] double force(double t);
  /// What each held mode, in order, adds to f_d at a time of the piece, N; the rest of f_d follows base and wall at once.
  [[nodiscard]] std::vector<double> shares(double t) const { return stick_.force_terms(t); }
  [[nodiscard]] StickPropagator& propagator() { return stick_; }
  [[nodiscard]] const ContactDynamics& dynamics() const { return dynamics_; }

 private:
  ContactDynamics dynamics_;
  StickPropagator stick_;
};

/// What one band of frequencies adds to the largest |f|.
struct BandShare {
  double from_hz{}, to_hz{};  ///< Hz
  double force{};             ///< N, of the sign that makes f positive
};

/// The force that holds the contact under a general motion.
struct MotionReaction {
  Bounds
      of_modes;  ///< of |f| of the held modes and the inertia of all others from 0 to the duration, N; they differ by 1e-7 of it
  double time{};                       ///< of the largest value found, s
  std::optional<double> first_excess;  ///< of μ_s N, s
  double largest_acceleration{};       ///< |h_tt| at the begins of the pieces, m/s²
  std::vector<double> shares;          ///< HeldMotion::shares() at `time`, of the sign that makes f positive
  /// Octaves between powers of 2 Hz, the highest with the highest frequency of the motion, and what is below and above them; they add up
  /// to |f| at `time`, t. With the window w of Hann over 4 periods of the lowest edge before t and after it, an edge cuts off
  ///
  ///     ∫ w(s) f(t + s) sin(2π edge s)/(π s) ds,   w = cos²(π s/(2 · 4 periods)), f = 0 before the start and after the end,
  ///
  /// by the trapezoidal rule. A sine has all of its force in its band if it is a third of the lowest edge or more away from the others.
  std::vector<BandShare> bands;
  /// What the held modes left out can change, N. Each of them follows the static load but for a_n p_n X_n(h) + a_n² X_n(w), with
  ///
  ///     X_n(h) ≤ |h_tt(0)| + min(∫|h_ttt|, (|h_ttt(0)| + ∫|h_tttt|)/ω_n),
  ///
  /// where the integrals forget at the rate ζ_n ω_n and count jumps between pieces; Σ a_n p_n by Cauchy and Schwarz, with p . p at most
  /// the moved mass. A bound where damping does not couple these modes; under a force, an estimate.
  double omitted{};

  /// Of |f|: of_modes, widened by `omitted`, N.
  [[nodiscard]] Bounds largest() const {
    return {std::max(0.0, of_modes.lower - omitted), of_modes.upper + omitted};
  }
};

/// |f| on each piece is at most the larger value at its ends and f_tt L²/8, with a bound of f_tt; a piece that could hold the largest
/// value or the first excess of μ_s N is halved until it cannot. With so many held modes and the inertia of all others.
/// `report` is told the time from time to time. Throws what contact_model() throws.
[[nodiscard]] MotionReaction motion_reaction(const data::Case& problem, int modes,
                                             const std::function<void(double)>& report = {});

}  // namespace stickslip::analytic
