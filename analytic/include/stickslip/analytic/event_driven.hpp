// SPDX-License-Identifier: MIT
#pragma once

/// Stick-slip histories from event to event: no time step, no regularisation of friction.
///
/// Stick is propagated exactly: every mode of the damped, held structure is a complex exponential, driven by
/// two more. Slip is integrated by the Runge-Kutta method of order 8 of Prince and Dormand (GSL's rk8pd) with
/// an error per step of `tolerance`, friction on its analytic branch v_s > 0 or v_s < 0 alone, so that
/// nothing discontinuous is integrated over.
///
/// Why no event is missed. Stick: f_d is a sum of exponentials with known amplitudes, so that |f_d_tt| has a
/// bound B on every interval of length h, and |f_d| <= max(|f_d(t)|, |f_d(t + h)|) + B h^2/8 in between. An
/// interval is passed only if that is below mu_s N, and halved otherwise, until f_d is monotonic in it or h
/// is at round-off. Slip: over an accepted step the sliding velocity, its rate and the rate of that are known
/// at both ends; the quintic through them differs from v_s by at most h^6/46080 max|v_s^(6)|. That derivative
/// is measured: the quintic across two consecutive steps against the value between them, times a safety of 4.
/// A step is passed only if the Bernstein coefficients of its quintic exceed that error, and halved
/// otherwise; the halved error is 64 times smaller. Every event is then polished by Brent's method on the
/// exact exponentials, or on the integrator itself restarted from the beginning of the step.

#include <memory>
#include <vector>

#include "stickslip/analytic/contact_model.hpp"

namespace stickslip::analytic {

enum class ContactPhase { stick, slip };

enum class ContactChange {
  onset,     ///< stick to slip: |f_d| reached mu_s N
  capture,   ///< slip to stick
  reversal,  ///< slip to slip in the other direction
  graze      ///< the sliding velocity touched zero and goes on in the same direction
};

struct ChangeOfContact {
  ContactChange change{};
  double time{};      ///< s
  double position{};  ///< of the contact on the wall, u_c - w, m
};

/// Where the energy went since the start, J. kinetic + potential - (their values at the start) =
/// base_work + follower_work - damping_loss - friction_loss.
struct EventDrivenEnergy {
  double kinetic{};    ///< 1/2 x_t . M x_t in the frame of the base
  double potential{};  ///< strain and geometric energy, 1/2 sum omega_n^2 T_n^2 + 1/2 k_c u_c^2
  double base_work{};  ///< of the loads and of the moving wall, int s b . x_t + F_c u_c_t + f_d w_t dt
  double follower_work{};
  double damping_loss{};
  double friction_loss{};
};

struct EventDrivenSettings {
  /// Error allowed per step of the slip phases, relative to each coordinate and to the reference velocity.
  double tolerance{1e-12};
  /// Speed that is small motion's measure, m/s: absolute errors are tolerance times it. 0: max(W Omega, V, that
  /// of the held structure under the load alone, the sliding velocity of the start) or, where none of these
  /// moves, what the energy of the start would give the contact's mass.
  double reference_velocity{};
  bool keep_energy_balance{};  ///< integrate the works of EventDrivenEnergy as well
};

/// One run of a ContactModel. f_d is the friction force on the structure.
class EventDriven {
 public:
  /// Starts as start_stuck({}, {}) does. Throws std::invalid_argument, naming what is unusable.
  explicit EventDriven(const ContactModel& model, const EventDrivenSettings& settings = {});
  ~EventDriven();
  EventDriven(EventDriven&&) noexcept;
  EventDriven& operator=(EventDriven&&) noexcept;

  /// Starts at t = 0 with the contact held at u_c = `position`, where w(0) = 0, moving with the wall. If holding it
  /// takes more than mu_s N it slips from the start. Empty vectors are zeros.
  void start_stuck(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                   double position = 0.0);

  /// Starts at t = 0 in slip, in the direction of v_s = `sliding_velocity`; where that is zero, against the
  /// force that holding the contact would take.
  void start_slipping(const std::vector<double>& amplitudes, const std::vector<double>& rates,
                      double position, double sliding_velocity);

  /// Runs to time t, which must be finite and not before time(). The history does not depend on the times
  /// asked for, but for the rounding of the polished events. Throws std::runtime_error, saying when, if the
  /// state is no longer finite or if 10000 events fall within 1e-9 of the period of the load.
  void advance_to(double t);

  [[nodiscard]] double time() const;
  [[nodiscard]] ContactPhase state() const;
  [[nodiscard]] const std::vector<double>& amplitudes() const;  ///< T_n
  [[nodiscard]] const std::vector<double>& rates() const;       ///< T_n_t
  [[nodiscard]] double contact_displacement() const;            ///< u_c, m
  [[nodiscard]] double contact_velocity() const;                ///< u_c_t, m/s
  [[nodiscard]] double wall_displacement() const;               ///< w, m
  [[nodiscard]] double drive_displacement() const;              ///< W sin(Omega t) = w - V t, m
  [[nodiscard]] double contact_position() const;                ///< u_c - w, m
  [[nodiscard]] double sliding_velocity() const;                ///< v_s, m/s; zero in stick
  [[nodiscard]] double friction_force() const;                  ///< f_d, N
  [[nodiscard]] double holding_force() const;  ///< f_d that holding the contact would take, N
  [[nodiscard]] const std::vector<ChangeOfContact>& events() const;
  /// Throws std::logic_error unless settings.keep_energy_balance.
  [[nodiscard]] EventDrivenEnergy energy_balance() const;

 private:
  class Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace stickslip::analytic
