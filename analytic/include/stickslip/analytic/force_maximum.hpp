// SPDX-License-Identifier: MIT
#pragma once

/// |f_max| of Eqs. (29) and (30), fast: what StickResponse::max_abs_friction_force returns, at a fraction of
/// the cost of halving intervals by a bound of |f''|.
///
/// Per unit amplitude the reaction is a sum of sinusoids, a_0 sin(Ω t) + sum a_n sin(ω_n t), and of
/// one modulated sinusoid for each mode in resonance, |Ω - ω_n| T < 2. Three bounds find its largest
/// value over 0 ≤ t ≤ T without sampling it finely. On an interval of half-width r about t_c, with f_k the
/// first k terms in falling order of amplitude, C_k ≥ max|f_k''|, D_k ≥ max|f_k'''| and R_k ≥ |f - f_k|,
///
///     |f| ≤ max(|f_k(t_c - r)|, |f_k(t_c + r)|) + C_k r²/2 + R_k                                 (chord)
///     |f| ≤ max |f_k(t_c) + f_k'(t_c) s + f_k''(t_c) s²/2| + D_k r³/6 + R_k,   |s| ≤ r       (parabola)
///     |f| ≤ |f(t)| + f'(t)²/(2 m)       where f has one sign, is concave away from zero, m ≤ |f''| (peak)
///
/// The amplitudes of the free vibrations fall as n⁻⁴, while their shares in f'' do not fall. So a coarse division needs
/// few terms, and the rest counts with its amplitude. A grid with the chord bound drops most of the time; its step and
/// number of terms are the cheapest. The other pieces are halved under the parabola bound, with more terms as they get
/// narrower, until the peak bound closes a piece after two or three steps of Newton's method.

#include <cstddef>
#include <vector>

#include "stickslip/analytic/modal_reaction.hpp"

namespace stickslip::analytic {

/// An interval that is known to hold the true value: lower ≤ value ≤ upper.
struct Bounds {
  double lower{};
  double upper{};

  [[nodiscard]] constexpr double midpoint() const noexcept { return lower + 0.5 * (upper - lower); }
};

/// Bounds of a number of 0 or more times the value, and over it; the value is not below 0.
[[nodiscard]] constexpr Bounds operator*(double number, const Bounds& value) noexcept {
  return {number * value.lower, number * value.upper};
}
[[nodiscard]] constexpr Bounds operator/(double number, const Bounds& value) noexcept {
  return {number / value.upper, number / value.lower};
}

/// One sinusoid a sin(w t) of a force or displacement history.
struct Sinusoid {
  double amplitude{};          ///< a
  double angular_frequency{};  ///< w, rad/s
};

/// A function and its first two derivatives at a point.
struct TaylorCoefficients {
  double value{}, slope{}, curvature{};
};

/// The reaction of one beam to one excitation frequency over 0 ≤ t ≤ duration, per unit amplitude.
class ForceMaximum {
 public:
  /// angular_frequency: Ω, rad/s; duration: T, s. Throws data::FieldError, naming
  /// excitation.frequency_hz or excitation.duration, unless both are positive and finite.
  ForceMaximum(const ModalReaction& reaction, double angular_frequency, double duration);

  /// Bounds of max |f|/A0, N/m, with upper - lower ≤ relative_width * lower + 3 rounding(). They enclose the
  /// maximum over all real t for the frequencies and coefficients given, rounding included. Throws
  /// std::invalid_argument unless 1e-13 ≤ relative_width < 1, or if the grid would need more than 1e9
  /// points.
  [[nodiscard]] Bounds refined_to(double relative_width = 1e-10) const;

  /// The same with less work where more is not asked: an upper bound that does not exceed `enough` (N/m) may be wide, and
  /// a lower bound above `too_much` ends the search, after which the upper one says nothing.
  [[nodiscard]] Bounds refined_to(double relative_width, double enough, double too_much) const;

  /// The sum of the amplitudes, N/m, without a search; infinite within a beat of a resonance.
  [[nodiscard]] double upper_bound() const;

  /// Whether max |f|/A0 exceeds the limit, N/m: refined_to(1e-10).lower > limit, with fewer evaluations.
  [[nodiscard]] bool exceeds(double limit) const;

  /// f(t)/A0, N/m.
  [[nodiscard]] double value(double t) const;

  /// Bound of the rounding error of an evaluation of f/A0 and of what the bounds above make of it, N/m.
  [[nodiscard]] double rounding() const noexcept { return rounding_; }

 private:
  class Search;

  // b e(t) cos(σ t), e(t) = sin(δ t)/δ: a mode in resonance, together with a Sinusoid.
  struct NearResonantTerm {
    double amplitude{};  // b
    double mean{};       // σ = (Ω + ω_n)/2
    double detuning{};   // δ = (Ω - ω_n)/2
  };
  // What bounds the first k sinusoids with all beats, and the rest.
  struct Truncation {
    double curvature{};  // C_k
    double third{};      // D_k
    double rest{};       // R_k
  };

  // sin(w t) and cos(w t)
  struct Phase {
    double sine{}, cosine{1.0};
  };
  [[nodiscard]] static Phase turned(const Phase& phase, const Phase& by) {
    return {phase.sine * by.cosine + phase.cosine * by.sine, phase.cosine * by.cosine - phase.sine * by.sine};
  }
  [[nodiscard]] TaylorCoefficients jet(double t) const;
  [[nodiscard]] TaylorCoefficients jet(double t, const Phase* phases, std::size_t terms) const;
  [[nodiscard]] double beats(double t) const;

  double duration_;
  std::vector<Sinusoid> sinusoids_;  // that at Ω first, then in falling order of amplitude
  std::vector<NearResonantTerm> near_resonant_terms_;
  std::vector<Truncation> truncations_;  // by k = 1 ... sinusoids_.size()
  double rounding_{};
};

}  // namespace stickslip::analytic
