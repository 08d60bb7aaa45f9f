// SPDX-License-Identifier: MIT
#pragma once

/// Stick-slip histories from event to event: no time step, no regularisation of friction.
///
/// Stick is propagated exactly: every mode of the damped, held structure is a complex exponential, driven by
/// two more. Slip is integrated by the Runge-Kutta method of order 8 of Prince and Dormand (GSL's rk8pd) with
/// an error per step of `tolerance`, friction on its analytic branch v_s > 0 or v_s < 0 alone, so that
/// nothing discontinuous is integrated over.
///
/// Why no event is missed in stick: f_d is a sum of exponentials with known amplitudes. So |f_d_tt| has a bound B on
/// every interval of length h, and |f_d| ≤ max(|f_d(t)|, |f_d(t + h)|) + B h²/8 in between. An interval is passed only
/// if that is below μ_s N. Otherwise it is halved, until f_d is monotonic in it or h is at round-off.
///
/// In slip: the sliding velocity and its first two rates are known at both ends of a step. The quintic through them
/// differs from v_s by at most h⁶/46080 max|v_s^(6)|. That derivative is measured, with a safety factor of 4, by the
/// quintic across two consecutive steps and the value between them. A step is passed only if the Bernstein coefficients
/// of its quintic exceed that error. Otherwise it is halved, which divides the error by 64.
///
/// A general motion is taken piece by piece: no interval and no step goes beyond a piece, on which the motion is a polynomial.
///
/// Every event is polished by Brent's method, on the exact exponentials or on the integrator restarted from the beginning
/// of the step.

#include <memory>
#include <vector>

#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/analytic/stick_propagator.hpp"
#include "stickslip/data/contact_event.hpp"

namespace stickslip::analytic {

class SlipIntegrator;

/// Where the energy went since the start, J:
///
///     Δ(kinetic + potential) = base_work + follower_work - damping_loss - friction_loss.
struct EventDrivenEnergy {
  double kinetic{};    ///< 1/2 x_t . M x_t in the frame of the base
  double potential{};  ///< strain and geometric energy, 1/2 sum ω_n² T_n² + 1/2 k_c u_c²
  double base_work{};  ///< of the loads and of the moving wall, ∫ b(t) . x_t + F_c u_c_t + f_d w_t dt
  double follower_work{};
  double damping_loss{};
  double friction_loss{};
};

struct EventDrivenSettings {
  /// Error allowed per step of the slip phases, relative to each coordinate and to a reference velocity: the largest of
  /// W Ω, V, the velocity of the held structure under the load alone and the sliding velocity of the start; where
  /// all are 0, the velocity that the energy of the start would give the mass of the contact.
  double tolerance{1e-12};
  bool keep_energy_balance{};  ///< integrate the works of EventDrivenEnergy as well
};

/// One run of a ContactModel. f_d is the friction force on the structure.
class EventDriven {
 public:
  /// Starts as start_stuck({}, {}) does. Throws std::invalid_argument, naming what is unusable, and what
  /// require_free_mass() throws.
  explicit EventDriven(const ContactModel& model, const EventDrivenSettings& settings = {});
  ~EventDriven();
  EventDriven(EventDriven&&) noexcept;

  /// Starts at t = 0 with the contact held at u_c = `position`, where w(0) = 0, moving with the wall. If holding it
  /// takes more than μ_s N it slips from the start. Empty vectors are zeros.
  void start_stuck(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                   double position = 0.0);

  /// Starts at t = 0 in slip, in the direction of v_s = `sliding_velocity`; where that is zero, against the
  /// force that holding the contact would take.
  void start_slipping(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                      double position, double sliding_velocity);

  /// Runs to time t, which must be finite and not before time(). The history does not depend on the times
  /// asked for, but for the rounding of the polished events. Throws std::runtime_error, saying when, if the
  /// state is no longer finite or if 10000 events fall within 1e-9/Ω.
  void advance_to(double t);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] data::ContactState state() const { return state_; }
  [[nodiscard]] const std::vector<double>& amplitudes() const { return now_.amplitudes; }  ///< T_n
  [[nodiscard]] const std::vector<double>& rates() const { return now_.rates; }            ///< T_n_t
  [[nodiscard]] double contact_displacement() const { return now_.displacement; }          ///< u_c, m
  [[nodiscard]] double contact_velocity() const { return now_.velocity; }                  ///< u_c_t, m/s
  [[nodiscard]] double wall_displacement() const { return dynamics_->wall_displacement(time_); }  ///< w, m
  [[nodiscard]] double base_displacement() const;                                                 ///< h, m
  /// u_c - w, m.
  [[nodiscard]] double contact_position() const { return now_.displacement - wall_displacement(); }
  [[nodiscard]] double sliding_velocity() const;  ///< v_s, m/s; zero in stick
  [[nodiscard]] double friction_force() const;    ///< f_d, N
  [[nodiscard]] double holding_force() const;     ///< f_d that holding the contact would take, N
  /// Of the state now; just after a change of the contact those after it.
  [[nodiscard]] ContactDynamics::Reactions reactions() const;
  [[nodiscard]] const std::vector<data::ContactEvent>& events() const { return events_; }
  /// Throws std::logic_error unless settings.keep_energy_balance.
  [[nodiscard]] EventDrivenEnergy energy_balance() const;

 private:
  void start(const std::vector<double>& amplitudes, const std::vector<double>& rates, double position);
  void prepare_slip();
  void enter_next_piece();
  void begin_stick();
  void begin_slip(double direction);
  void end_slip();
  void move_to(double t);
  void add_works_of_stick_until(double t);
  void record(data::ContactChange change);

  EventDrivenSettings settings_;
  std::unique_ptr<const ContactDynamics> dynamics_;  // stick_ and slip_ refer to it
  StickPropagator stick_;
  std::unique_ptr<SlipIntegrator> slip_;
  double limit_;  // μ_s N

  double time_{};
  data::ContactState state_{data::ContactState::stick};
  ContactKinematics now_;
  double certain_until_{};  // stick: no onset before
  bool ends_{};             // slip: v_s = 0 at the end of the last step
  std::vector<data::ContactEvent> events_;
  Powers works_, works_before_phase_;
  double works_until_{};
};

}  // namespace stickslip::analytic
