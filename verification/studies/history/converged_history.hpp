// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// A stick phase with half-widths of its times and position.
struct ConvergedStick {
  double begin{}, end{};                        ///< s
  double position{};                            ///< y(L), m
  double begin_half_width{}, end_half_width{};  ///< s
  double position_half_width{};                 ///< m
};
STICKSLIP_MEMBERS(ConvergedStick, (begin, "s"), (end, "s"), (position, "m"), (begin_half_width, "s"),
                  (end_half_width, "s"), (position_half_width, "m"))

/// One run of the convergence study.
struct HistoryLevel {
  std::string method;   ///< "boundary integral" or "free modes"
  double time_step{};   ///< h, s
  int modes{};          ///< number of free modes; 0 for the boundary integral
  int changes{};        ///< number of steps at which the contact changes between stick and slip
  double difference{};  ///< largest |difference| of y(L) from the finest boundary integral, over its range
};
STICKSLIP_MEMBERS(HistoryLevel, (method, "-"), (time_step, "s"), (modes, "1"), (changes, "1"),
                  (difference, "1"))

/// A history of the beam with its estimated error. The history is the boundary integral with the finest of
/// several steps. It is compared with the boundary integral with twice this step, and with the free modes
/// with their finest step. The free modes use neither the kernel nor the time stepping of the boundary
/// integral.
///
/// Half-width: twice the larger of the two differences up to the time in question, because errors grow with
/// time, but at least 1e-12 of the range. The factor is two because the error decreases at least as fast as
/// h^(1/2) (measured): the difference from twice the step is then at least 0.41 of the error. The half-width
/// is an estimate, not a bound.
struct ConvergedHistory {
  double frequency_hz{}, amplitude{};                      ///< Hz, m
  std::vector<double> time;                                ///< s
  std::vector<double> tip, midspan;                        ///< y(L), y(L/2), m
  std::vector<double> tip_half_width, midspan_half_width;  ///< m
  double tip_range{}, midspan_range{};                     ///< largest minus smallest value, m
  ConvergedStick first_stick;                              ///< from the start to the first slip
  /// Later ones that are at least shortest_stick long and occur in all three runs.
  std::vector<ConvergedStick> sticks;
  std::vector<HistoryLevel> levels;  ///< finest level first, boundary integral before free modes

  /// The largest half-width of y(L) as a fraction of its range.
  [[nodiscard]] double largest_half_width() const;
};
STICKSLIP_MEMBERS(ConvergedHistory, (frequency_hz, "Hz"), (amplitude, "m"), (time, "s"), (tip, "m"),
                  (midspan, "m"), (tip_half_width, "m"), (midspan_half_width, "m"), (tip_range, "m"),
                  (midspan_range, "m"), (first_stick), (sticks), (levels), (largest_half_width(), "1"))

/// The settings of the convergence study.
struct ConvergedEffort {
  double duration{0.5};  ///< s
  int samples{1000};     ///< number of equal parts of the duration at whose ends the history is recorded
  int steps_per_sample{
      4096};      ///< of the finest boundary integral; a power of two, halved from level to level
  int levels{4};  ///< of each method, at least 2; the finest free-mode run has half as many steps
  double shortest_stick{1e-3};  ///< s
  bool with_midspan{true};      ///< otherwise midspan is empty, and the study takes half the time
};

/// Runs the study for an undamped case; `numerics` of the case is not used. Throws std::invalid_argument for
/// a case with damping, and what analytic::BeamBoundaryIntegral throws.
[[nodiscard]] ConvergedHistory converged_history(const data::Case& problem,
                                                 const ConvergedEffort& effort = {});

}  // namespace stickslip::studies
