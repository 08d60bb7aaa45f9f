// SPDX-License-Identifier: MIT
#pragma once

/// The stick-state response to h(t) = A0 sin(Ω t) in closed form, Eqs. (26)-(28), with the
/// tip at rest: u(x,0) = 0, u_t(x,0) = S(x) h_t(0), which is what Eq. (26) assumes (erratum E4).
///
///     u(x,t) = A0 { S(x) sin(Ω t) + Σ_n U_n(x) Ω² C_n g_n(t) },    y = h + u               (27)
///     f(t)   = EI u'''(L,t) + χ P u'(L,t)                                                           (28)
///     g_n(t) = (ω_n sin(Ω t) - Ω sin(ω_n t)) / ((Ω² - ω_n²) ω_n)        (26)
///
/// Where Ω and ω_n are close, g_n is evaluated as [ω_n t cos((Ω + ω_n) t/2)
/// sinc((Ω - ω_n) t/2) - sin(ω_n t)]/((Ω + ω_n) ω_n), with sinc(y) = sin(y)/y: the
/// same function without the 0/0 at resonance, where it grows with t.

#include <functional>
#include <vector>

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// How the part that oscillates at Ω is summed.
enum class SteadyPart {
  /// N terms, as the paper does. f is off by about half its first omitted term at Ω, O(N⁻²), with a sign
  /// that alternates with N.
  modal_sum,
  /// Without truncation. The absolute steady shape Y = 1 + u/A0 solves Y'''' + p Y'' = k Y at k = ρ A
  /// Ω²/EI with Y(0) = 1, Y'(0) = 0, Y(L) = Y''(L) = 0:
  ///
  ///     Y = [bb cos(bb) sinh(b η)/sinh(b) - b coth(b) sin(bb η)] / [bb cos(bb) - b coth(b) sin(bb)].
  ///
  /// What it has beyond the N terms is analytic in Ω up to ω_(N+1) and is taken as its mean over a
  /// circle in the complex Ω plane, so that nothing is lost at resonance. Only the free vibrations n > N
  /// are left out: u_t(x,0) misses their share of S(x) h_t(0).
  exact
};

/// The response of one beam to one harmonic excitation, with N modes. Accuracy: round-off times the condition
/// number of the modes, and times ω_n t for the phase of the free vibrations; then what the truncation of
/// the sums leaves (SteadyPart, omitted_transient_bound).
class StickResponse {
 public:
  /// Throws what stick_modes() throws, and data::FieldError, naming numerics.modes, if
  /// SteadyPart::exact is asked for with ω_N < 2 Ω.
  StickResponse(const data::Beam& beam, const data::HarmonicExcitation& excitation, int modes = 10,
                SteadyPart steady_part = SteadyPart::modal_sum);

  [[nodiscard]] double base_displacement(double t) const;                ///< h(t), m
  [[nodiscard]] double relative_displacement(double x, double t) const;  ///< u(x,t), m; 0 ≤ x ≤ L, t ≥ 0
  [[nodiscard]] double absolute_displacement(double x, double t) const;  ///< y = h + u, m
  /// The same as a function of t while this lives, for many times: the shapes of the modes are computed once.
  [[nodiscard]] std::function<double(double)> absolute_displacement(double x) const;
  /// f(t), N, sign of Eq. (28).
  [[nodiscard]] double friction_force(double t) const { return amplitude_ * evaluate(force_, t); }

  /// Amplitude of the part of f at Ω, N: A0 [r(S) + sum r(U_n) Ω² C_n/(Ω² - ω_n²)] with
  /// r(U) = EI U'''(L) + χ P U'(L), or its exact limit. Infinite where Ω equals a natural frequency, unless A0 = 0.
  [[nodiscard]] double steady_force_amplitude() const { return steady_amplitude(force_); }
  /// The free vibrations in f, one per mode: -A0 r(U_n) Ω³ C_n / ((Ω² - ω_n²) ω_n)
  /// at ω_n. Their amplitudes fall as n⁻⁴.
  [[nodiscard]] std::vector<Sinusoid> transient_force() const { return transient(force_); }
  /// As steady_force_amplitude and transient_force, for u(x, .).
  [[nodiscard]] double steady_displacement_amplitude(double x) const {
    return steady_amplitude(displacement(x));
  }
  [[nodiscard]] std::vector<Sinusoid> transient_displacement(double x) const {
    return transient(displacement(x));
  }

  /// f/A0.
  [[nodiscard]] const ModalReaction& reaction() const noexcept { return force_; }

  /// Bounds of max |f(t)| over 0 ≤ t ≤ duration, rigorous for the N modes kept at their computed
  /// frequencies and amplitudes: ForceMaximum of reaction(), times A0. Throws what that throws.
  [[nodiscard]] Bounds max_abs_friction_force(double duration, double relative_width = 1e-10) const;

  /// The same from samples at t = i * sampling_step and t = duration only: lower is the largest sample, upper
  /// adds (sampling_step²/8) max|f''|. Of max|f''| a mode has |a_i| w_i² or, in resonance, where its two amplitudes are large and
  /// opposite, |g_n''| ≤ Ω (Ω t + 1)/(Ω + ω_n). Throws std::invalid_argument unless duration > 0, sampling_step > 0
  /// and duration ≤ 1e9 sampling_step.
  [[nodiscard]] Bounds sampled_max_abs_friction_force(double duration, double sampling_step) const;

  /// Bound of what the omitted free vibrations n > N can add to f at any time, N: the tail of
  /// transient_force()'s amplitudes, extrapolated by their n⁻⁴ law from the last mode kept and doubled,
  /// 2 |a_N| N/3. Infinite unless the law is reached: Ω < ω_N and |P| L²/EI < (β̄_N L)².
  [[nodiscard]] double omitted_transient_bound() const;

  [[nodiscard]] const std::vector<StickMode>& modes() const noexcept { return modes_; }

 private:
  // u(x, t)/A0 as a sum over modes.
  [[nodiscard]] ModalReaction displacement(double x) const;
  template <class ExactAmplitude>
  void complete(ModalReaction& sum, const ExactAmplitude& exact_amplitude) const;
  [[nodiscard]] double evaluate(const ModalReaction& sum, double t) const;
  [[nodiscard]] double steady_amplitude(const ModalReaction& sum) const;
  [[nodiscard]] std::vector<Sinusoid> transient(const ModalReaction& sum) const;
  [[nodiscard]] double curvature_bound(double duration) const;

  data::Beam beam_;
  double amplitude_;  // A0
  double omega_;      // Ω, rad/s
  SteadyPart steady_part_;
  QuasiStaticShape quasi_static_;
  std::vector<StickMode> modes_;
  ModalReaction force_;
};

}  // namespace stickslip::analytic
