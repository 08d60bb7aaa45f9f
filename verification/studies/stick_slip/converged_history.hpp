#pragma once

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// A span in which the tip sticks, with half-widths.
struct ConvergedStick {
  double begin{}, end{};                        ///< s
  double position{};                            ///< y(L), m
  double begin_half_width{}, end_half_width{};  ///< s
  double position_half_width{};                 ///< m
};

/// One run of the study.
struct HistoryLevel {
  std::string method;   ///< "boundary integral" or "free modes"
  double time_step{};   ///< h, s
  int modes{};          ///< free modes kept; 0 for the boundary integral
  int changes{};        ///< steps at which the contact changes between stick and slip
  double difference{};  ///< largest difference of y(L) to the finest boundary integral, as a fraction of its
                        ///< range
};

/// A history of the beam as far as it has converged: the boundary integral on the finest of several steps,
/// and how far it is from that on twice the step and from the free modes on their finest step, which share
/// neither kernel nor propagation with it.
///
/// Half-width: twice the larger of these two differences so far (errors grow with time), at least 1e-12 of
/// the range. Twice, because the error falls at least as h^(1/2) (measured), by which the difference to twice
/// the step is at least 0.41 of the error. An estimate, not a bound.
struct ConvergedHistory {
  double frequency_hz{}, amplitude{};                      ///< Hz, m
  std::vector<double> time;                                ///< s
  std::vector<double> tip, midspan;                        ///< y(L), y(L/2), m
  std::vector<double> tip_half_width, midspan_half_width;  ///< m
  double tip_range{}, midspan_range{};                     ///< largest less smallest value, m
  ConvergedStick first_stick;                              ///< from the start to the first slip
  std::vector<ConvergedStick> sticks;  ///< after it, at least shortest_stick long, in all three runs
  std::vector<HistoryLevel> levels;    ///< finest first, boundary integral before free modes

  /// The largest half-width of y(L) as a fraction of its range.
  [[nodiscard]] double largest_half_width() const;
};

/// What is run.
struct ConvergedEffort {
  double duration{0.5};  ///< s
  int samples{1000};     ///< equal parts of the duration at whose ends the history is kept
  int steps_per_sample{
      4096};      ///< of the finest boundary integral; a power of two, halved from level to level
  int levels{4};  ///< of each method; the free modes start with half as many steps
  double shortest_stick{1e-3};  ///< s
  bool with_midspan{true};      ///< else midspan is left empty, in half the time
};

/// Throws what analytic::BeamBoundaryIntegral throws. numerics of the case are not used. Undamped cases only:
/// std::invalid_argument, naming the damping, for others.
[[nodiscard]] ConvergedHistory converged_history(const data::Case& problem,
                                                 const ConvergedEffort& effort = {});

/// How many free modes a FreeModeRun of step h keeps here: those with omega_k h up to 20, as omega_k grows
/// with k^2, at least 20 and at most 1000. Throws what slip_modes() throws.
[[nodiscard]] int free_modes_for(const data::Beam& beam, double time_step);

}  // namespace stickslip::studies
