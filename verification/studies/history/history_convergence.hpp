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
#include "studies/history/converged_history.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

/// One run in modal coordinates, with located changes and the velocity threshold 0.
struct HistoryRun {
  /// The relative change of the amplitude whose effect is observed.
  static constexpr double perturbation = 1e-9;
  int elements{};
  double time_step{};  ///< h, s
  double spectral_radius{};
  double highest_angle{};                   ///< ω_max h, where ω_max is the highest frequency of the mesh
  double growth_bound{};                    ///< σ* of mesh and step, 1/s
  std::optional<double> observed_growth{};  ///< growth_rate() of a perturbation, 1/s, if asked for
  double error{};  ///< largest |difference| of y(L) from the converged history, over its range
  int changes{};   ///< number of changes of contact
};
STICKSLIP_MEMBERS(HistoryRun, (perturbation, "1"), (elements, "1"), (time_step, "s"), (spectral_radius, "1"),
                  (highest_angle, "1"), (growth_bound, "1/s"), (observed_growth, "1/s"), (error, "1"),
                  (changes, "1"))

/// The rate, 1/s, at which two histories at the same times separate: the slope of the logarithm of the largest
/// |difference| of y(L) in each whole period (s) from the first event of `a` on, before the first period in which it
/// exceeds `limit` (m). Nothing if there are fewer than three such periods.
[[nodiscard]] std::optional<double> growth_rate(const History& a, const History& b, double period,
                                                double limit);

/// One run with its growth bound and its error. The growth is observed in periods of the load, with a tenth of the range
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

/// The time step of a rule, s.
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
