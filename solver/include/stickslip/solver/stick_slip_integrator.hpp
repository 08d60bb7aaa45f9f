// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "stickslip/data/contact_event.hpp"
#include "stickslip/solver/contact_system.hpp"
#include "stickslip/solver/generalized_alpha.hpp"

namespace stickslip::solver {

/// When and how the contact changes. Use `located` for results; the others show what the location of changes gains.
enum class ContactScheme {
  /// Inside the step, where the change happens: of second order in h.
  located,
  /// At the end of the grid step in which the change was noticed, up to h late, with the velocity left there
  /// removed by the same impulse. The times of changes are of first order in h, and so is everything after a
  /// reversal, which leaves friction in the wrong direction for a while; what a late onset or capture costs
  /// is of second order, because the impulse makes up for the force that the late capture held.
  end_of_step,
  /// The scheme exactly as Sects. 2 and 3 of Won, Lee & Chung describe it. The state is decided at the start of
  /// every step: stick if |v_s| ≤ ε and |f_s| ≤ μ_s N, with f_s the force that holding takes; else slip, against the
  /// current sliding velocity (from rest: against f_s). At the capture the one component v[c] is overwritten
  /// by the wall's velocity, without an impulse, which may add energy. A contact that decelerates faster than
  /// ε/h (1 m/s² there) jumps over the threshold: then friction merely changes its direction. Nothing
  /// restarts the method: its acceleration is carried through every change. Needs ε > 0.
  paper
};

/// The coordinates of a run, and what solves the equations of a step. Both give the same numbers up to rounding.
enum class Coordinates {
  nodal,  ///< any, as deflections and rotations of nodes: factorised sparse matrices, cost linear in their number
  modal  ///< those of modal_contact_system(): passes over the modes, and a full matrix where damping couples them
};

struct IntegratorSettings {
  double time_step{};        ///< h, s, > 0
  double spectral_radius{};  ///< 0 ... 1
  /// ε, m/s, ≥ 0: below it a slip that can stick is captured. Above 0 it limits the step from below: a slip
  /// that begins and does not exceed it within the step is captured at its end, by an impact.
  double velocity_threshold{};
  ContactScheme scheme{ContactScheme::located};
  Coordinates coordinates{Coordinates::nodal};
};

/// What a step must know of the contact.
struct StepPhase {
  data::ContactState state{data::ContactState::stick};
  double direction{};    ///< in slip: d = +1 or -1
  double wall_offset{};  ///< in stick: q[c] - w, m; of a contact that yields, the slider's, always
};

class FrictionContact;
class HeldContact;
class StepKernel;

/// Time integration of a ContactSystem by the generalised-alpha method, on the grid t_n = n h, with contact
/// changes located inside the step.
///
/// Stick. The contact moves with the wall, exactly, velocity and acceleration included; in the balance at the
/// α level its motion enters at t_star, so that the other degrees of freedom see a load of second order.
/// The friction force at t_n follows from the semi-discrete balance alone, with influence vectors found once,
///
///     f_d = r_q · q + r_v · v + r_s s(t) + m_c ẅ(t).
///
/// It is of second order in h, because q and v are, and costs one scalar product.
///
/// Slip. f_d = -d μ(|v_s|) N with the direction d = ±1 of the phase, v_s at the α level. This is a scalar
/// equation, since a_(n+1) depends on f_d through one influence vector; Newton's method solves it to round-off.
///
/// Changes. |f_d| > μ_s N at the end of a stick step, or d v_s ≤ 0 at the end of a slip step, is located
/// inside the step by root finding over the end of a shortened step, which is then taken; the rest of the
/// grid step follows from there. At v_s = 0 the contact sticks if it can (|f_d| ≤ μ_s N), else it slips
/// against the force that holding it would take. A slip that ends a step with |v_s| ≤ ε and can stick
/// is captured too, as in Sect. 3 of Won, Lee & Chung. The velocity left at a capture is removed by the impulse
/// at the contact that does it,
///
///     v ← v - M⁻¹ e_c m_c v_s,      m_c = 1/(e_c · M⁻¹ e_c).
///
/// It is M-orthogonal, so that kinetic energy in the frame of the wall falls by m_c v_s²/2 and never rises. At a
/// reversal no velocity is reset. That is ContactScheme::located; the other schemes say what they do instead.
///
/// A contact that yields (data::TangentialContact): a spring or a smooth law. There is no stick phase. Every step has
/// the equations of slip, with f_d at the α level the root of one scalar equation in the weighted velocity and
/// position of the contact; the slider follows at the end of the step. friction_force() is on the line through f_d at the
/// last two α levels, within the bound. f_d is continuous, so that changes need no
/// location, and q and v are of second order. state() is stick while the slider rests; a smooth law always slips and
/// has no events. Only ContactScheme::located.
///
/// Restart. After a change (and at t = 0) the method's acceleration is, with the residual r and the matrix A of a
/// whole step,
///
///     a = (1 - α_m) A⁻¹ r = (M + θ h² K)⁻¹ r,      r = p s - C v - K q + contact force,      θ = (1 - α_f) β/(1 - α_m).
///
/// It is the balance up to (ω h)² for what the step resolves, and nearly zero for what it does not. The balance
/// itself, or the value carried over from the shortened step, holds ω² q of the stiffest modes, which a spectral
/// radius below 1 turns into a velocity ω h times too large: on fine meshes the run diverges.
///
/// Limits. An excess of |f_d| over μ_s N, or a double sign change of v_s, that begins and ends within one
/// step is not seen. More than 1000 events in one step, or a state that is not finite, stop the run with
/// std::runtime_error that says when.
class StickSlipIntegrator {
 public:
  /// Throws std::invalid_argument naming the setting or the part of the system that is unusable; data::InputError
  /// where the values of a user lead to it.
  StickSlipIntegrator(ContactSystem system, const IntegratorSettings& settings);
  ~StickSlipIntegrator();
  StickSlipIntegrator(const StickSlipIntegrator&) = delete;
  StickSlipIntegrator& operator=(const StickSlipIntegrator&) = delete;

  /// Starts at t = 0 with the contact stuck; q[c] and v[c] of the arguments are replaced by the wall's. If
  /// the friction needed exceeds μ_s N at once, the contact slips from the start.
  void start_stuck(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);

  /// Starts at t = 0 in slip, in the direction of the sliding velocity given (or, where that is zero, against
  /// the force that holding the contact would take). Throws std::logic_error if the contact is bonded.
  void start_slipping(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);

  /// From t_n to t_(n+1).
  void step();

  /// Is called with the integrator after every accepted step or part of one, and once more, at the same time,
  /// after a change of the contact: between two calls lies a piece of one phase, or a change.
  using Observer = std::function<void(const StickSlipIntegrator&)>;

  /// From now on calls the observer, or none if it is empty.
  void observe(Observer observer);

  [[nodiscard]] double time() const noexcept { return time_; }
  [[nodiscard]] long steps() const noexcept { return steps_; }
  [[nodiscard]] data::ContactState state() const noexcept { return phase_.state; }
  [[nodiscard]] const Eigen::VectorXd& displacement() const noexcept { return now_.displacement; }
  [[nodiscard]] const Eigen::VectorXd& velocity() const noexcept { return now_.velocity; }
  /// v_s, m/s; zero in stick, unless the contact yields.
  [[nodiscard]] double sliding_velocity() const;
  /// f_d on the system, N, at time().
  [[nodiscard]] double friction_force() const;
  /// The friction force that holding the contact to the wall would take now, N.
  [[nodiscard]] double holding_force() const;
  /// q_tt[c] from the balance, m/s²: ẅ in stick, else ẅ + (f_d - holding_force())/m_c. Of second order, as q and v.
  [[nodiscard]] double contact_acceleration() const;
  /// m_c = 1/(e_c · M⁻¹ e_c), kg; 0 for a contact without mass.
  [[nodiscard]] double contact_mass() const noexcept;
  [[nodiscard]] const std::vector<data::ContactEvent>& events() const noexcept { return events_; }
  [[nodiscard]] const ContactSystem& system() const noexcept { return system_; }

 private:
  // Takes the motion towards end_time, the end of its grid step: there, or to a change of the contact.
  using Scheme = void (StickSlipIntegrator::*)(double end_time);
  [[nodiscard]] Scheme scheme() const;
  void locate_changes(double end_time);
  void change_at_the_end_of_steps(double end_time);
  void step_as_the_paper(double end_time);
  void take_step_to(double end_time);
  void advance_stick(double end_time);
  void advance_slip(double end_time);
  void accept_slip_step(double end_time, double forward_velocity);
  void decide_as_the_paper();
  [[nodiscard]] double onset_time(double excess_now, double end_time, double excess_at_end);
  [[nodiscard]] double rest_time(double end_time, double forward_velocity_at_end);
  [[nodiscard]] double time_tolerance() const;

  // The state at end_time, if the contact stays as it is, with its excess force, and d v_s, negative once the contact has
  // come to rest.
  const Kinematics& compute_trial_step(double end_time);
  double trial_excess_force(double end_time);
  double trial_forward_velocity(double end_time);
  // The last trial step, which ends at new_time, becomes the state. In a contact that yields the slider follows, and a
  // change is recorded: f_d does not jump, so that a change inside a step costs no order and is not located.
  void accept_trial_step(double new_time);

  // Changes of the contact at the present state, recorded as events; those of ContactScheme::paper have neither impulse
  // nor restart. Settling, the contact is at rest on the wall, up to what the location left: stick if it can be held, else
  // slip.
  void leave_stick();
  void stick_or_reverse();
  void overwrite_sliding_velocity();
  void turn_to(double direction);

  void start(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);
  void begin_stick();
  void begin_slip(double direction);
  void begin_yielding();
  void move_slider(double length);  // after a step of this length
  void record(data::ContactChange change);
  void notify() const;

  [[nodiscard]] bool is_stuck() const noexcept { return phase_.state == data::ContactState::stick; }
  [[nodiscard]] bool yields() const noexcept;
  [[nodiscard]] double relative_velocity() const;  // v_s, whatever is left of it in stick
  [[nodiscard]] double excess_force() const;       // above zero the contact cannot be held, N
  [[nodiscard]] double position() const;           // q[c] - w

  ContactSystem system_;  // to which the parts refer
  IntegratorSettings settings_;
  GeneralizedAlpha method_;
  std::unique_ptr<const FrictionContact> contact_;
  std::unique_ptr<const HeldContact> held_contact_;
  std::unique_ptr<StepKernel> kernel_;
  Scheme advance_;

  Kinematics now_, trial_;
  double time_{};
  long steps_{};
  StepPhase phase_;
  int events_in_step_{};
  std::vector<data::ContactEvent> events_;
  // Of a contact that yields: f_d now, and f_d and time of the last α level.
  double yielding_force_{}, alpha_level_force_{}, alpha_level_time_{};
  Observer observer_;
};

}  // namespace stickslip::solver
