// SPDX-License-Identifier: MIT
#pragma once

/// Periodic motions of a ContactModel by shooting, and their Floquet multipliers.
///
/// State x = (T, u_c, T_t, u_c_t). Its flow over a time is smooth between two changes of contact, with the derivative Φ,
/// Φ_t = A Φ: in stick the held structure, exactly; in slip A holds the slope of the friction law. At a change of
/// contact the time of the change depends on the state, so that Φ jumps by the saltation matrix
///
///     Φ+ = [1 + (f+ - f-) ∇gᵀ/g_t] Φ-
///
/// with the rates x_t = f- and f+ before and after, the function g(x, t) that is zero at the change, and its rate g_t along
/// f- (M. A. Aizerman, F. R. Gantmakher, Q. J. Mech. Appl. Math. 11, 1958; R. I. Leine, H. Nijmeijer, Dynamics and
/// Bifurcations of Non-Smooth Mechanical Systems, 2004). At a capture and at a reversal g = v_s, at an onset
/// g = |f_d| - μ_s N, and f+ = f- unless the law jumps. A capture takes the velocity of the contact out of the state: a motion that
/// sticks has a multiplier 0. A graze has no saltation matrix; it is passed as if it were none.
///
/// A forced motion of the period T = n 2 π/Ω solves x(T) = x(0). A self-excited one, on a wall that moves and without
/// a load, has an unknown period, and one multiplier 1 for a shift in time. Both by Newton's method with Φ.

#include <complex>
#include <optional>
#include <vector>

#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/analytic/event_driven.hpp"

namespace stickslip::analytic {

/// A state at t = 0, or at a time that is like it.
struct ContactStart {
  ContactKinematics kinematics;
  data::ContactState phase{};
};

/// Starts a run of the model there.
void start(EventDriven& run, const ContactModel& model, const ContactStart& from);

/// The flow over a time, from t = 0.
struct PoincareImage {
  ContactStart end;
  Matrix derivative;                       ///< Φ, n x n with n = 2 (m + 1)
  std::vector<double> rate;                ///< x_t at the end; n
  std::vector<data::ContactEvent> events;  ///< in (0, duration)
};

/// In stick the velocity of the contact is no coordinate: its row and column of Φ are zero. Accuracy: 1e-12 a step, as
/// EventDriven. Throws what EventDriven throws.
[[nodiscard]] PoincareImage poincare_map(const ContactModel& model, const ContactStart& start,
                                         double duration);

/// Eigenvalues by falling modulus. Throws std::runtime_error if they do not converge.
[[nodiscard]] std::vector<std::complex<double>> eigenvalues(const Matrix& matrix);

/// A motion with x(period) = x(0).
struct PeriodicMotion {
  ContactStart start;
  double period{};                                ///< s
  std::vector<data::ContactEvent> events;         ///< of one period
  std::vector<std::complex<double>> multipliers;  ///< n, by falling modulus; from a Φ of 1e-10 a step
  double residual{};                              ///< of x(period) = x(0), relative to the motion
  int iterations{};                               ///< of Newton's method
};

/// What stands between a model and a periodic motion.
enum class NoMotion {
  sticks,  ///< the contact does not change: it sticks for all time
  steady,  ///< the contact slides steadily
  unsettled  ///< none repeats itself after the settling time within 12 cycles; or Newton's method fails, from four starts
};

/// The motion, or the reason why there is none.
struct PeriodicSearch {
  std::optional<PeriodicMotion> motion;
  NoMotion reason{};
};

/// The forced motion of `periods` periods of the load near the one that follows from rest after `settle` periods of the
/// load or, where Newton's method finds none from there, after half, a quarter or an eighth of them: a motion that is unstable is
/// passed and left again. Throws data::FieldError unless periods ≥ 1, and what EventDriven throws.
[[nodiscard]] PeriodicSearch forced_motion(const ContactModel& model, int periods, int settle);

/// The self-excited motion near the one that follows from rest on the wall after the time `settle` (s), sampled each
/// `sample` s. The model has no load and a wall of constant speed (std::invalid_argument).
[[nodiscard]] PeriodicSearch self_excited_motion(const ContactModel& model, double settle, double sample);

}  // namespace stickslip::analytic
