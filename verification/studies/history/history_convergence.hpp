// SPDX-License-Identifier: MIT
#pragma once

/// Whether undamped histories by generalised-alpha converge to that of the beam, and whether the growth bound
/// (contact_growth.hpp) predicts this.

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"
#include "studies/history/history.hpp"

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

/// A run of an undamped history, compared with a converged one.
struct HistoryRun {
  /// The relative change of the amplitude whose effect is observed.
  static constexpr double perturbation = 1e-9;
  std::string method{};      ///< such as "free modes" or "located in the step"
  int elements{};            ///< 0 without a mesh
  int modes{};               ///< number of free modes; 0 without them
  double time_step{};        ///< h, s; 0 for event-driven runs
  double spectral_radius{};  ///< of generalised-alpha
  int changes{};             ///< of contact; of converged_history() the steps at which there is one
  double error{};            ///< largest |difference| of y(L) from the converged history, over its range
  double highest_angle{};    ///< ω_max h, where ω_max is the highest frequency of the mesh
  double growth_bound{};     ///< σ* of mesh and step, 1/s
  std::optional<double> observed_growth{};  ///< growth_rate() of a perturbation, 1/s, if asked for
  std::vector<double> tip_displacement{};  ///< of usual_practice(): y(L) at the times of the converged one, m
};
STICKSLIP_MEMBERS(HistoryRun, (perturbation, "1"), (method, "-"), (elements, "1"), (modes, "1"),
                  (time_step, "s"), (spectral_radius, "1"), (changes, "1"), (error, "1"),
                  (highest_angle, "1"), (growth_bound, "1/s"), (observed_growth, "1/s"),
                  (tip_displacement, "m"))

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
  std::vector<HistoryRun> levels;  ///< finest step first, boundary integral before free modes

  /// The largest half-width of y(L) as a fraction of its range.
  [[nodiscard]] double largest_half_width() const;
};
STICKSLIP_MEMBERS(ConvergedHistory, (frequency_hz, "Hz"), (amplitude, "m"), (time, "s"), (tip, "m"),
                  (midspan, "m"), (tip_half_width, "m"), (midspan_half_width, "m"), (tip_range, "m"),
                  (midspan_range, "m"), (first_stick), (sticks), (levels), (largest_half_width(), "1"))

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

/// The history that data/reference publishes as `data_set` (undamped-history-25 and its relatives), with its half-widths.
/// `problem` is its case; `effort` says which levels are computed and compared with it, none with 0 levels. Sticks and
/// midspan stay empty. Throws what data::read_table() and converged_history() throw.
[[nodiscard]] ConvergedHistory published_history(const data::Case& problem, const std::string& data_set,
                                                 ConvergedEffort effort);

/// The rate, 1/s, at which two histories at the same times separate: the slope of the logarithm of the largest
/// |difference| of y(L) in each whole period (s) from the first event of `a` on, before the first period in which it
/// exceeds `limit` (m). Nothing if there are fewer than three such periods.
[[nodiscard]] std::optional<double> growth_rate(const History& a, const History& b, double period,
                                                double limit);

/// One run by generalised-alpha with located changes and the velocity threshold 0, with its growth bound and its error. It is in
/// modal coordinates unless it radiates. The growth is observed in periods of the load, with a tenth of the range
/// as limit. `time_step` is reduced so that it divides the spacing of the reference. With radiating_share > 0, this
/// fraction of the element mass ρ A l is attached to the tip by a dashpot of κ (with_radiating_contact()). Throws
/// what solver::BeamSimulation throws.
[[nodiscard]] HistoryRun history_run(const data::Case& problem, const ConvergedHistory& reference,
                                     int elements, double time_step, double spectral_radius,
                                     bool observe_growth, double radiating_share = 0.0);

/// How the time step depends on the mesh.
struct StepRule {
  std::string name{};
  double angle{};      ///< ω_max h; 0 for a fixed step
  double time_step{};  ///< h, s, if the angle is 0
  double spectral_radius{};
  double radiating_share{};  ///< see history_run()
};
STICKSLIP_MEMBERS(StepRule, (name, "-"), (angle, "1"), (time_step, "s"), (spectral_radius, "1"),
                  (radiating_share, "1"))

[[nodiscard]] double time_step_of(const StepRule& rule, const data::Beam& beam, int elements);

/// ω_max h at which generalised-alpha with the spectral radius 0 has no more growth than the beam.
inline constexpr double filtering_angle = 2.445;

/// Runs of one rule on several meshes, and the observed order in l of their errors. The growth is observed on
/// meshes of at most `observed_elements` elements.
struct HistoryRefinement {
  StepRule rule;
  double frequency_hz{};
  std::vector<HistoryRun> runs;
  OrderEstimate order;         ///< observed; there is no theoretical order
  double beam_growth_bound{};  ///< σ* of the continuous beam, 1/s
};
STICKSLIP_MEMBERS(HistoryRefinement, (rule), (frequency_hz, "Hz"), (runs), (order),
                  (beam_growth_bound, "1/s"))
[[nodiscard]] HistoryRefinement history_refinement(const data::Case& problem,
                                                   const ConvergedHistory& reference, const StepRule& rule,
                                                   const std::vector<int>& elements, int observed_elements);

}  // namespace stickslip::studies
