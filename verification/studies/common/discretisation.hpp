// SPDX-License-Identifier: MIT
#pragma once

/// Predictions of the discretisation error from theory and from the modes of the continuous beam alone. This
/// code does not call solver/, so that an error in the solver cannot enter the predictions.

#include <algorithm>
#include <complex>
#include <vector>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// Leading relative error of an eigenvalue ω² on Hermite elements of length l (m), which is the bending
/// energy of the interpolation error:
///
///     (ω_h² - ω²)/ω² = l⁴/720 EI ∫ U''''² dx / (ω² ρ A ∫ U² dx) + O(l⁶).
///
/// At P = 0 it is (β l)⁴/720. The leading error is positive.
[[nodiscard]] double hermite_eigenvalue_error(const data::Beam& beam, const analytic::StickMode& mode,
                                              double element_length);

/// The parameters of generalised-alpha as Chung & Hulbert (1993) print them, not as the solver computes them.
struct AlphaParameters {
  explicit AlphaParameters(double spectral_radius)
      : alpha_m((2.0 * spectral_radius - 1.0) / (spectral_radius + 1.0)),
        alpha_f(spectral_radius / (spectral_radius + 1.0)) {}
  double alpha_m, alpha_f;
  double gamma = 0.5 - alpha_m + alpha_f;
  double beta = 0.25 * (1.0 - alpha_m + alpha_f) * (1.0 - alpha_m + alpha_f);
};

/// The exponent s (1/s) of the vibration exp(s t) that generalised-alpha makes of exp(i ω t) in steps of time_step (s): Im s
/// is its angular frequency, -Re s its rate of decay. From the principal eigenvalues of the amplification matrix. Accuracy:
/// rounding of ω, and eps ω² h of the decay rate.
[[nodiscard]] std::complex<double> generalized_alpha_exponent(double spectral_radius,
                                                              double angular_frequency, double time_step);

/// Moduli of the eigenvalues of the amplification matrix, in descending order. The first is the spectral
/// radius.
[[nodiscard]] std::vector<double> amplification_moduli(double spectral_radius, double omega_times_step);

/// The response of generalised-alpha to g_tt + w² g = -sin(Ω t) from rest, exact but for rounding. With
/// x = (g, h g_t, h² g_tt) one step is x_(n+1) = A x_n + b sin(Ω (t_n + (1 - α_f) h)). Hence
///
///     x_n = Im[X exp(i Ω t_n)] + Re[sum c_j v_j λ_j^n],   A v_j = λ_j v_j,
///     X = (exp(i Ω h) - A)⁻¹ b exp(i Ω (1 - α_f) h),   Re[sum c_j v_j] = -Im X.
///
/// b includes the minus sign of the load. The method starts with x_0 = 0, because the load and the
/// acceleration are zero at t = 0.
///
/// The effect on the free vibration, whose exact amplitude is B = Ω/(w (w² - Ω²)), is as follows.
/// Up to terms of order h⁴ the method solves
///
///     g_t = v + h² k_1 v_tt,   v_t = -w² g + F + h² (k_2 v_ttt - k_3 F_tt),   F = -sin(Ω t),
///     d = α_f - α_m,   k_1 = 1/12 + d²/4,   k_2 = 1/12 + d²/2,   k_3 = α_f (1 - α_f)/2
///
/// with the initial value v(0) = (d²/2) h² v_tt(0), because the acceleration of step n belongs to the time
/// t_n - d h. Hence, for Ω << w,
///
///     w_h = w (1 - (w h)² (k_1 + k_2)/2),   B_h = B [1 - (w h)² (3/8) d² + O((Ω h)²)].
///
/// A continuous oscillator of frequency w_h would have the amplitude B (w/w_h)³ from rest. This exceeds B by
/// the relative amount (3/2)(k_1 + k_2)(w h)², at least (w h)²/4. The frequency w_h alone therefore does
/// not predict the amplitude.
struct SteppedResponse {
  struct Term {
    std::complex<double> amplitude, factor;
  };
  std::complex<double> steady;  ///< X of g
  std::vector<Term> free;       ///< c_j v_j of g and λ_j, Im λ_j ≥ 0; conjugate pairs combined

  /// g after n steps with the angle `step_angle` = Ω h each.
  [[nodiscard]] double at(long n, double step_angle) const;
};
/// The stepped response of an oscillator with `natural_frequency` w and load frequency `omega` (both rad/s).
[[nodiscard]] SteppedResponse stepped_from_rest(double spectral_radius, double natural_frequency,
                                                double omega, double time_step);

/// Angular frequency of a mode on the mesh, rad/s: ω_n √(1 + hermite_eigenvalue_error).
[[nodiscard]] double frequency_on_mesh(const data::Beam& beam, const analytic::StickMode& mode, int elements);

/// The same exponent for the free vibration of a mode after discretisation in space and time.
[[nodiscard]] std::complex<double> discrete_exponent(const data::Beam& beam, const analytic::StickMode& mode,
                                                     const data::NumericalSettings& numerics);

/// Predicted bound of the largest difference between two sums of free vibrations over 0 ... duration. It is
/// summed term by term: if the phase of a mode has drifted by d and its amplitude a has decayed by the factor
/// 1 - e, the difference is at most |a| min(2, d + e).
[[nodiscard]] double drift_bound(const data::Beam& beam, const std::vector<analytic::StickMode>& modes,
                                 const std::vector<analytic::Sinusoid>& transient,
                                 const data::NumericalSettings& numerics, double duration);

/// Free vibrations in the closed form that the studies measure errors of finite-element runs against.
inline constexpr int reference_modes = 100;

/// The static friction force that theory predicts for the finite-element run: Eq. (28) with ω_n replaced
/// by frequency_on_mesh() and g_n by stepped_from_rest(). Its |f_max| is the prediction of the finite-element
/// value, including beating and resonance.
class PredictedForce {
 public:
  /// Predicts the free vibrations of the first `modes` modes: on the meshes of the studies, the frequencies of twenty are
  /// predicted well enough. The phase of higher modes counts as unknown. Without the damping of the case.
  explicit PredictedForce(const data::Case& problem, int modes = 20);

  /// Largest |f| over the time steps of the numerics from 0 to numerics.duration(), N.
  [[nodiscard]] double max_abs() const;

  /// Estimated uncertainty of max_abs(), N. With the element length l, the leading eigenvalue error e_n and
  /// the duration T it is the sum of
  ///
  ///     |a_n| min(2, ω_n T e_n (β_n l)²/80 + e_n)    for n ≤ modes
  ///     2 |a_n|                                              for n > modes, and the omitted tail
  ///     (Ω h)²/8 |steady remainder|
  ///
  /// First row: the next term of e_n is about e_n (β_n l)²/40 and changes the phase; e_n changes the
  /// amplitude. Second row: the phase is unknown. Third row: the remainder is the contribution of the modes n
  /// > modes at Ω; its relative error for stiff modes is (Ω h)² k_3 with k_3 ≤ 1/8. Time steps add
  /// no error for n ≤ modes, because stepped_from_rest() is exact.
  [[nodiscard]] double uncertainty() const;

 private:
  struct Term {
    double weight;
    SteppedResponse response;
  };
  double omega_{};
  double rest_amplitude_{};  // of the part at Ω that is not in terms_
  double time_step_{};
  long steps_{};
  double phase_uncertainty_{};  // the first two of the three rows of uncertainty()
  std::vector<Term> terms_;
};

/// ∫_0^L g(x) dx by the composite Simpson rule with 100 intervals per half wave of the mode. The relative
/// error is below 1e-7 for the mode shape, its derivatives and their squares.
template <typename Function, typename Mode>
double simpson_integral(Function&& g, double length, const Mode& mode) {
  const int intervals = 100 * mode.number();
  const double step = length / intervals;
  double sum = 0.0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = (i == 0 || i == intervals) ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * g(std::min(i * step, length));
  }
  return sum * step / 3.0;
}

}  // namespace stickslip::studies
