// SPDX-License-Identifier: MIT
#pragma once

/// The motion y(x,t) of the whole beam by several methods (Fig. 3).

#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

/// Snapshots at evenly spaced times of a window of `length` (s) that begins at `start` (s), both ends included, each rounded
/// to a time step, and evenly spaced positions from clamp to tip, both included. Throws data::FieldError, naming what is
/// wrong, if there are fewer than two snapshots or positions, if the window begins before 0 or if it has more snapshots
/// than time steps.
[[nodiscard]] Sampling snapshots_of(const data::Case& problem, double start, double length, int snapshots,
                                    int positions);

/// The largest |y| of a motion, m.
[[nodiscard]] double peak(const History& motion);

/// The largest difference (m) of two motions with the same rows and positions, over the rows up to the time `until` (s).
[[nodiscard]] double largest_difference(const History& a, const History& b, double until);

/// Predicted bound of the difference (m) between finite elements and closed form in the stick state, over the
/// snapshots up to the time `until` (s). With g_n of Eq. (26), and g_n,h by frequency_on_mesh() and
/// stepped_from_rest(), it is
///
///     max over x, t of A0 Σ_n |U_n(x) Ω² C_n| |g_n,h(t) - g_n(t)|  +  (Ω h)²/4 max|y|.
///
/// The sum contains the errors of phase, amplitude and resonance of each of 60 modes. The last term is the error of
/// the steady response of the time integration.
[[nodiscard]] double predicted_stick_difference(const data::Case& problem, const Sampling& snapshots,
                                                double until);

/// One panel of Fig. 3: finite elements compared with a reference without a mesh.
struct BeamMotionStudy {
  double frequency_hz{};
  double amplitude{};            ///< m
  std::vector<double> position;  ///< x of the displacements, m
  History finite_element;
  History reference;                 ///< closed form if the tip always sticks, otherwise free modes
  double half_width{};               ///< of the reference, m: twice its change when the step is doubled
  std::optional<double> first_slip;  ///< first slip within numerics.duration() by the closed form, s
  double peak{};                     ///< max |y| of the reference, m
  double stick_difference{};         ///< largest difference up to the first slip, m
  double predicted_stick_difference{};
  double difference{};  ///< largest difference over all snapshots, m
  /// Both over the peak.
  [[nodiscard]] double relative_difference() const { return difference / peak; }
  [[nodiscard]] double relative_half_width() const { return half_width / peak; }
};
STICKSLIP_MEMBERS(BeamMotionStudy, (frequency_hz, "Hz"), (amplitude, "m"), (position, "m"), (finite_element),
                  (reference), (half_width, "m"), (first_slip, "s"), (peak, "m"), (stick_difference, "m"),
                  (predicted_stick_difference, "m"), (difference, "m"), (relative_difference(), "1"),
                  (relative_half_width(), "1"))

/// Compares one period of the excitation: the first period if the tip sticks throughout numerics.duration(),
/// otherwise the period that begins a quarter of a period before the first slip (but not before t = 0). For
/// undamped problems only.
[[nodiscard]] BeamMotionStudy beam_motion_study(const data::Case& problem, int snapshots, int positions);

}  // namespace stickslip::studies
