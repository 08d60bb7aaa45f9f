// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"
#include "studies/history/history.hpp"
#include "studies/history/history_convergence.hpp"

namespace stickslip::studies {

/// One panel of Figs. 4 and 5: the converged motion, and whether the tip slips according to both
/// implementations.
struct ContactHistory {
  double frequency_hz{};
  double amplitude{};                         ///< m
  std::optional<ConvergedHistory> converged;  ///< empty if the criterion predicts stick
  std::optional<double> finite_element_slip;  ///< time of the first slip, s
  std::optional<double> closed_form_slip;     ///< first time at which |f| > μ_s P in the closed form, s
  bool criterion_slips{};                     ///< Eqs. (29), (30) over numerics.duration()
  std::string figure{};                       ///< of the paper, such as "4a"
  bool printed_slips{};                       ///< according to the paper
  /// Whether paper, criterion and finite elements have the same verdict.
  [[nodiscard]] bool verdicts_agree() const {
    return printed_slips == criterion_slips && printed_slips == finite_element_slip.has_value();
  }
  /// |finite_element_slip - closed_form_slip|, s, if there are both.
  [[nodiscard]] std::optional<double> first_slip_difference() const;
};
STICKSLIP_MEMBERS(ContactHistory, (frequency_hz, "Hz"), (amplitude, "m"), (converged),
                  (finite_element_slip, "s"), (closed_form_slip, "s"), (criterion_slips, "1"), (figure, "-"),
                  (printed_slips, "1"), (verdicts_agree(), "1"), (first_slip_difference(), "s"))

/// The verdicts on an undamped case over numerics.duration(), and its history: published_history() of the data set if one
/// is named, else computed over `shown` seconds and sampled every 2e-4 s.
[[nodiscard]] ContactHistory contact_history(const data::Case& problem, double shown,
                                             const std::string& data_set = "");

/// The panels of Figs. 4 and 5, in the paper's order, with the case of data/cases/paper.toml. Histories that data/reference
/// publishes, those of Fig. 5, are read there.
[[nodiscard]] std::vector<ContactHistory> contact_histories(const data::Case& paper, double shown);

/// Runs with usual settings, all with the time step of `numerics` where there is one: the scheme of the
/// paper; located changes with the spectral radii 0.5, 0.9 and 1; and event-driven runs on
/// numerics.elements() and on half as many elements. The excitation is that of the converged history; the
/// problem is undamped.
[[nodiscard]] std::vector<HistoryRun> usual_practice(data::Case problem, const ConvergedHistory& converged);

/// The first time (s) at which |f| of the closed form with the exact steady part exceeds the limit; empty if
/// there is none within numerics.duration(). The search uses steps of 1/2000 of the shorter of the periods of the
/// excitation and of the first mode, and locates the time to 1/20000 of a step.
[[nodiscard]] std::optional<double> closed_form_first_slip(const data::Case& problem);

// The motion y(x,t) of the whole beam by several methods (Fig. 3).

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

/// One level of Fig. 9: y(L/2, t) and f(t) in the stick state by both implementations. The reference is the
/// closed form with the exact steady part and 200 free vibrations.
struct StickHistoryLevel {
  int elements{};
  double time_step{};                     ///< s
  double displacement_error{};            ///< max |y_h - y| over the common times, m
  double force_error{};                   ///< max |f_h - f| over the common times, N
  double predicted_displacement_error{};  ///< drift_bound of the free vibrations, m
  double predicted_force_error{};         ///< N
  double relative_displacement_error{};   ///< over displacement_peak
  double relative_force_error{};          ///< over force_peak
};
STICKSLIP_MEMBERS(StickHistoryLevel, (elements, "1"), (time_step, "s"), (displacement_error, "m"),
                  (force_error, "N"), (predicted_displacement_error, "m"), (predicted_force_error, "N"),
                  (relative_displacement_error, "1"), (relative_force_error, "1"))

struct StickHistoryStudy {
  double displacement_peak{};  ///< max |y|, m
  double force_peak{};         ///< max |f|, N
  std::vector<StickHistoryLevel> levels;
  /// In the time step; the number of elements is inversely proportional to its square root.
  OrderEstimate displacement_order;
  OrderEstimate force_order;
  double predicted_displacement_order{};  ///< slope of the predicted errors
  double predicted_force_order{};
  std::vector<double> time;                             ///< the common times, s: those of the first level
  std::vector<double> displacement, force;              ///< closed form, m and N
  std::vector<double> first_displacement, first_force;  ///< finite elements, first level, m and N
};
STICKSLIP_MEMBERS(StickHistoryStudy, (displacement_peak, "m"), (force_peak, "N"), (levels),
                  (displacement_order), (force_order), (predicted_displacement_order, "1"),
                  (predicted_force_order, "1"), (time, "s"), (displacement, "m"), (force, "N"),
                  (first_displacement, "m"), (first_force, "N"))

/// Compares the undamped histories on the times of the first level over 0 ... numerics.duration(). Level k has the
/// time step h/4^k and 2^k times the elements of the case, so that the errors of time (h²) and mesh (l⁴)
/// decrease at the same rate.
[[nodiscard]] StickHistoryStudy stick_history_study(const data::Case& problem, int levels);

}  // namespace stickslip::studies
