#pragma once

/// What theory says of the discretisation error, from the modes of the continuous beam alone. None of this
/// calls solver/: a prediction that shared its code would share its mistakes.

#include <complex>
#include <vector>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// Leading relative error of an eigenvalue omega^2 on Hermite elements of length l,
///
///     (omega_h^2 - omega^2)/omega^2 = l^4/720 EI int U''''^2 dx / (omega^2 rho A int U^2 dx) + O(l^6),
///
/// the bending energy of the interpolation error: (beta l)^4/720 at P = 0. Always from above.
[[nodiscard]] double hermite_eigenvalue_error(const data::Beam& beam, const analytic::StickMode& mode,
                                              double element_length);

/// What generalised-alpha makes of a free vibration exp(i omega t): exp((-decay_rate + i angular_frequency)
/// t), exactly, from the principal eigenvalues of its amplification matrix.
struct NumericalOscillation {
  double angular_frequency{};  ///< rad/s
  double decay_rate{};         ///< 1/s
};
[[nodiscard]] NumericalOscillation generalized_alpha_oscillation(double spectral_radius,
                                                                 double angular_frequency, double time_step);

/// Moduli of the eigenvalues of the amplification matrix, largest first: the first is the spectral radius.
[[nodiscard]] std::vector<double> amplification_moduli(double spectral_radius, double omega_times_step);

/// The response from rest of g_tt + w^2 g = -sin(Omega t) in steps of generalised-alpha, exactly: with x =
/// (g, h g_t, h^2 g_tt) a step is x_(n+1) = A x_n + b sin(Omega (t_n + (1 - alpha_f) h)), so that
///
///     x_n = Im[X exp(i Omega t_n)] + Re[sum c_j v_j lambda_j^n],   A v_j = lambda_j v_j,
///     X = (exp(i Omega h) - A)^-1 b exp(i Omega (1 - alpha_f) h),   Re[sum c_j v_j] = -Im X,
///
/// b with the sign of the load, since the method starts with x_0 = 0: the load is zero at t = 0, and with it
/// the acceleration.
///
/// What that does to the free vibration, whose exact amplitude is B = Omega/(w (w^2 - Omega^2)). Up to h^4
/// the method solves g_t = v + h^2 k_1 v_tt, v_t = -w^2 g + F + h^2 (k_2 v_ttt - k_3 F_tt), with F =
/// -sin(Omega t),
///
///     d = alpha_f - alpha_m,   k_1 = 1/12 + d^2/4,   k_2 = 1/12 + d^2/2,   k_3 = alpha_f (1 - alpha_f)/2,
///
/// from v(0) = (d^2/2) h^2 v_tt(0), because its acceleration belongs to d h before its time. Hence
///
///     w_h = w (1 - (w h)^2 (k_1 + k_2)/2),   B_h = B [1 - (w h)^2 (3/8) d^2 + O((Omega h)^2)],   Omega << w.
///
/// A continuous oscillator of frequency w_h from rest would have B (w/w_h)^3 instead, (3/2)(k_1 + k_2)(w h)^2
/// or a quarter of (w h)^2 too much: the method's frequency does not fix its amplitude.
struct SteppedResponse {
  struct Term {
    std::complex<double> amplitude, factor;
  };
  std::complex<double> steady;  ///< X of g
  std::vector<Term> free;       ///< c_j v_j of g, and lambda_j: those with Im lambda_j >= 0, pairs joined

  /// g after n steps of `step_angle` = Omega h each.
  [[nodiscard]] double at(long n, double step_angle) const;
};
[[nodiscard]] SteppedResponse stepped_from_rest(double spectral_radius, double natural_frequency,
                                                double omega, double time_step);

/// Angular frequency of a mode on the mesh, rad/s: omega_n sqrt(1 + hermite_eigenvalue_error).
[[nodiscard]] double frequency_on_mesh(const data::Beam& beam, const analytic::StickMode& mode, int elements);

/// The free vibration of a mode after both discretisations.
[[nodiscard]] NumericalOscillation discrete_oscillation(const data::Beam& beam,
                                                        const analytic::StickMode& mode,
                                                        const data::NumericalSettings& numerics);

/// Predicted bound of the sup-norm difference of two sums of free vibrations over 0 ... duration, term by
/// term: a mode whose phase has drifted by d and whose amplitude has decayed by the factor 1 - e differs by
/// at most |a| min(2, d + e).
[[nodiscard]] double drift_bound(const data::Beam& beam, const std::vector<analytic::StickMode>& modes,
                                 const std::vector<analytic::Sinusoid>& transient,
                                 const data::NumericalSettings& numerics, double duration);

/// The static friction force that theory expects of the finite-element run: Eq. (28) with every omega_n
/// replaced by frequency_on_mesh() and every g_n by its stepped_from_rest(). Its |f_max| predicts the
/// finite-element one, beating and resonance included.
class PredictedForce {
 public:
  /// `modes` free vibrations are predicted; those beyond count as unknown in phase.
  PredictedForce(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                 const data::NumericalSettings& numerics, int modes);

  /// max |f| over the grid of `numerics`, 0 ... numerics.duration(), N.
  [[nodiscard]] double max_abs() const;

  /// What the prediction of max_abs() itself may be off by, N. With l the element length, e_n the leading
  /// eigenvalue error and T the duration, the sum of
  ///
  ///     |a_n| min(2, omega_n T e_n (beta_n l)^2 / 80 + e_n)    the next term of e_n is about (beta l)^2/40
  ///                                                            of it; it moves the phase, and e_n the
  ///                                                            amplitude
  ///     2 |a_n| for n > modes, and the omitted tail            phase unknown
  ///     (Omega h)^2/8 times the steady rest                    what modes n > modes add at Omega; stiff ones
  ///                                                            are off by (Omega h)^2 k_3, k_3 <= 1/8
  ///
  /// The steps themselves cost nothing for n <= modes: stepped_from_rest() is exact.
  [[nodiscard]] double uncertainty() const;

 private:
  struct Term {
    double weight;
    SteppedResponse response;
  };
  double omega_{};
  double rest_amplitude_{};  // of the part at Omega that no term holds
  double time_step_{};
  long steps_{};
  double phase_uncertainty_{};  // the first two of the three sums
  std::vector<Term> terms_;
};

}  // namespace stickslip::studies
