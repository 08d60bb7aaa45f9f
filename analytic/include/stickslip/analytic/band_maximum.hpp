// SPDX-License-Identifier: MIT
#pragma once

/// The largest |f_max| of Eqs. (29), (30) over a band of excitation frequencies, between rigorous bounds.
///
/// Per unit A0, with c_n = EI U_n'''(L) C_n and φ_n = Ω² g_n of Eq. (26),
///
///     f(t) = EI S'''(L) sin(Ω t) + Σ_n c_n φ_n(t),       0 ≤ t ≤ T.
///
/// At each t this is smooth in Ω. Between two frequencies a distance h apart |f_max| therefore exceeds the larger of
/// its values there by at most h²/8 max |d² f/dΩ²|. A mode whose frequency is outside a ... b by at least D counts
/// in that maximum with the amplitudes of its two sinusoids,
///
///     φ_n = p sin(Ω t) - q sin(ω_n t),  p = Ω²/(Ω² - ω_n²),  q = p Ω/ω_n,
///
/// whose derivatives are bounded with |Ω² - ω_n²| ≥ D (a + ω_n). A mode in or close to the interval
/// counts with g_n = -(1/ω_n) ∫_0^t sin(ω_n (t - s)) sin(Ω s) ds, that is with
///
///     |φ_n''| ≤ (2 T + 2 b T² + b² T³/3)/ω_n.
///
/// A resonance, about 1/T wide, can therefore not hide between two frequencies.
///
/// A damped beam is followed at the same phase θ = Ω t and not at the same time. There
///
///     f = Re[A exp(i θ)] + Re Σ_k B_k exp(λ_k θ/Ω),
///
/// with A and B_k of DampedForce, sums of P_k/(±i Ω - λ_k), |±i Ω - λ_k| ≥ |Re λ_k|, and with ρ = |λ_k|/|Re λ_k|
///
///     |d/dΩ exp(λ_k θ/Ω)| ≤ ρ/(e Ω),     |d²/dΩ² exp(λ_k θ/Ω)| ≤ (4 ρ²/e² + 2 ρ/e)/Ω²,
///
/// so that the bound of |d² f/dΩ²| does not grow with T. At Ω the time is 0 ≤ t ≤ T Ω_to/Ω.
///
/// A base whose velocity (k = 1) or acceleration (k = 2) has one amplitude over the band has the displacement A0 w(Ω),
/// w = (Ω_from/Ω)^k, with A0 at Ω_from. w is convex and falls. Between two frequencies with the largest forces F_1 and F_2 (per unit
/// displacement) and the weights w_1 ≥ w_2, the product of the two chords exceeds the larger of w_1 F_1 and w_2 F_2 by at most
/// (w_1 - w_2) max(0, F_2 - F_1)/4, which adds to w_1 h²/8 max |d² f/dΩ²|.

#include <cstddef>
#include <map>
#include <optional>
#include <queue>
#include <vector>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// Excitation frequencies from ... to, ends included; they may be equal.
struct FrequencyBand {
  double from_hz{};
  double to_hz{};
  data::AmplitudeOf held{};  ///< whose amplitude is the same at all of them
};

/// What is looked at of a damped beam.
enum class DampedForcePart {
  start_up,  ///< the force from the start on
  steady     ///< the amplitude of its steady part
};

/// The search for that largest force. Each call continues it.
class BandMaximum {
 public:
  /// Throws std::invalid_argument unless 0 < from_hz ≤ to_hz and
  /// duration > 0 (excitation.duration).
  BandMaximum(const ModalReaction& reaction, const FrequencyBand& band, double duration);
  BandMaximum(const DampedReaction& reaction, const FrequencyBand& band, double duration,
              DampedForcePart part);

  /// Bounds of the largest |f_max| per unit amplitude of the displacement at from_hz, N/m, with upper - lower ≤ relative_width * lower, or
  /// wider as soon as they leave no doubt on which side of `limit` it is. Rigorous for the modes kept at
  /// their computed frequencies. Throws std::invalid_argument unless 1e-7 ≤ relative_width < 1.
  [[nodiscard]] Bounds refined_to(double relative_width);
  [[nodiscard]] Bounds refined_against(double limit, double relative_width);

  /// Whether the largest |f_max| per unit amplitude exceeds the limit, N/m. A maximum that is within 1e-4 of the limit
  /// and undecided counts as above. Fast: mostly between() decides alone, or the forces at the ends of the band and at
  /// its natural frequencies.
  [[nodiscard]] bool exceeds(double limit);

  /// Where the lower bound is attained, Hz.
  [[nodiscard]] double frequency_hz() const;
  /// How many frequencies have been evaluated.
  [[nodiscard]] std::size_t evaluations() const noexcept { return values_.size(); }

  /// Bounds per unit amplitude over an interval of Ω and 0 ≤ t ≤ T, from the formulas above alone, with the weight of its beginning.
  struct Suprema {
    double force{};      ///< of w |f|, N/m
    double curvature{};  ///< of w |d² f/dΩ²|, N s²/(m rad²)
  };
  /// What the search knows of an interval without evaluating it; from ≤ to in rad/s.
  [[nodiscard]] Suprema between(double from, double to) const;

 private:
  struct Decided;
  struct Interval {
    double from{}, to{};  // rad/s
    bool ends_known{};
    double upper{};
    [[nodiscard]] bool operator<(const Interval& other) const { return upper < other.upper; }
  };
  void divide(const FrequencyBand& band, const std::vector<double>& natural);
  [[nodiscard]] Decided force_at(double omega) const;
  [[nodiscard]] double weight(double omega) const;
  [[nodiscard]] Suprema undamped_between(double from, double to) const;
  [[nodiscard]] Suprema damped_between(double from, double to) const;
  [[nodiscard]] bool rises_above(Decided& from, Decided& to, double limit) const;
  [[nodiscard]] double upper_value(double omega, double excess, double limit, double relative_width);
  [[nodiscard]] bool stays_below(double from, double to, double limit, int halvings) const;
  void add(double from, double to);
  void sharpen(const Interval& interval, double limit, double relative_width);
  [[nodiscard]] Bounds bounds() const;

  ModalReaction reaction_;
  std::optional<DampedReaction> damped_;
  DampedForcePart part_{};
  double duration_;
  double order_{};             // k of the weight
  std::vector<double> marks_;  // the ends and the natural frequencies between them, rad/s, ascending
  // An upper bound of |f_max|, and the relative width to which it is sharp.
  struct UpperValue {
    double upper{}, width{};
  };
  std::map<double, UpperValue> values_;  // by Ω
  std::priority_queue<Interval> intervals_;
  double lower_ = 0.0;
  double best_omega_ = 0.0;
};

}  // namespace stickslip::analytic
