#pragma once

/// What theory says of the discretisation error, from the modes of the continuous beam alone. None of this
/// calls solver/: a prediction that shared its code would share its mistakes.

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

/// The response from rest of g_tt + 2 d g_t + (w^2 + d^2) g = -sin(Omega t): its part at Omega, and the free
/// vibration exp(-d t) (free_sine sin(w t) + free_cosine cos(w t)), with w and d of a NumericalOscillation.
struct ForcedOscillation {
  double steady_sine{}, steady_cosine{};
  double free_sine{}, free_cosine{};
};
[[nodiscard]] ForcedOscillation forced_from_rest(double omega, const NumericalOscillation& oscillation);

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
/// replaced by discrete_oscillation(). Its |f_max| predicts the finite-element one, beating and resonance
/// included.
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
  ///     of it; it
  ///                                                            moves the phase, and e_n the amplitude
  ///     2 |a_n| for n > modes, and the omitted tail            phase unknown
  ///     max_abs (Omega h)^2 / 4                                steady response of the time-stepping method
  [[nodiscard]] double uncertainty() const;

 private:
  struct Term {
    double weight;
    ForcedOscillation forced;
    NumericalOscillation oscillation;
  };
  double omega_{};
  double static_amplitude_{};
  double time_step_{};
  long steps_{};
  double phase_uncertainty_{};  // the first two of the three sums
  std::vector<Term> terms_;
};

}  // namespace stickslip::studies
