// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

/// Where the energy of a run came from and went, J, since the record began. Works are done on the
/// system; losses are positive where energy leaves it.
struct EnergyBalance {
  double kinetic{};         ///< 1/2 vᵀ M v
  double elastic{};         ///< 1/2 qᵀ K_stick q: for the beam elastic and geometric, see BeamModel
  double base_work{};       ///< of the load and of the moving wall, both the base's motion seen in its frame
  double follower_work{};   ///< of the unsymmetric part of K_slip
  double damping_loss{};    ///< of C
  double friction_loss{};   ///< of f_d on the sliding velocity
  double capture_loss{};    ///< of the impulses at captures, m_c v_s²/2 each
  double initial_energy{};  ///< kinetic + elastic at the beginning of the record

  [[nodiscard]] double energy() const noexcept { return kinetic + elastic; }
  [[nodiscard]] double change() const noexcept { return energy() - initial_energy; }
  /// What no entry explains: the change of the energy less all works, plus all losses.
  [[nodiscard]] double residual() const noexcept {
    return change() - base_work - follower_work + damping_loss + friction_loss + capture_loss;
  }
};

/// The energy balance of a run of the StickSlipIntegrator, as an audit of it.
///
/// With E = 1/2 vᵀ M v + 1/2 qᵀ K_stick q and f_d the friction force, in stick the one that holds, the
/// balance of the ContactSystem times v gives, exactly and in either state,
///
///     dE/dt = s p.v - v_c r.q - v.C v + f_d v_c,    r = row c of K_slip - K_stick,   v_c = v_s + w_t:
///
/// the works of the load, of the follower term and of the damping, the friction loss f_d v_s ≤ 0, which is
/// zero in stick, and the work f_d w_t of the moving wall. The impulse of a capture, -m_c v_s, does the work
/// -m_c v_s w_t of the wall and takes away m_c v_s²/2. A contact that is not rigid has no impulse, and its friction
/// loss contains the energy that its spring holds.
///
/// The powers are integrated by the trapezoidal rule between the accepted states, with f_d on both sides of a
/// change. The record knows only q, v, the state and the friction law, and nothing of the α level of the
/// method. The power v.C v is that of the mean of both velocities: a mode that h does not resolve changes its
/// sign from state to state; this cancels in all works that are linear in v and must not count as a loss here.
/// The residual, of method and rule together, is of order h² for whatever h resolves, and much larger if a
/// step adds energy that no force explains. Use:
///
///     EnergyRecorder recorder(integrator);   // after start_...
///     integrator.observe([&recorder](const StickSlipIntegrator& now) { recorder.record(now); });
class EnergyRecorder {
 public:
  /// Begins at the present state, of a run that has been started. Throws std::invalid_argument if
  /// K_stick is not symmetric or K_slip differs from it outside the row of the contact: the balance above
  /// would not hold.
  explicit EnergyRecorder(const StickSlipIntegrator& start);

  /// Records an accepted state: the piece of a phase since the last one or, at the same time, a change.
  void record(const StickSlipIntegrator& now);

  [[nodiscard]] const EnergyBalance& balance() const noexcept { return balance_; }

 private:
  // Powers at one state, W; losses positive.
  struct Powers {
    double base{}, follower{}, friction{};
  };

  [[nodiscard]] double sliding_velocity(const StickSlipIntegrator& now) const;
  [[nodiscard]] Powers powers(const StickSlipIntegrator& now) const;
  void set_state(const StickSlipIntegrator& now);

  Eigen::VectorXd follower_row_;  // r
  EnergyBalance balance_;
  // Of the last state recorded.
  double time_{};
  data::ContactState state_{};
  Eigen::VectorXd velocity_;
  double sliding_velocity_{};  // as the velocities have it, also in stick
  Powers powers_;
};

}  // namespace stickslip::solver
