// SPDX-License-Identifier: MIT
#pragma once

/// Numbers that several studies yield together, or that the figures need as well.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/study_results.hpp"

namespace stickslip::report {

/// A computed value beside what it is held against.
struct CheckedResult {
  std::string what;       ///< "frequency.stick.1 by closed form"
  std::string reference;  ///< what it is held against: "printed" or "mesh-free"
  double computed{}, expected{};
  bool known_erratum{};  ///< a printed number that does not hold or is not determined
  [[nodiscard]] double relative_difference() const { return computed / expected - 1.0; }
};

/// Each recomputed number against the printed one, and each result of the solution verification, at the published settings,
/// against the closed form, or the boundary integral after a first slip.
[[nodiscard]] std::vector<CheckedResult> checked_results(const std::vector<studies::PrintedCheck>& printed,
                                                         const studies::SolutionVerification& verification);

/// Of the relative differences, errata apart.
struct Differences {
  std::size_t count{};
  double bias{};    ///< mean
  double spread{};  ///< standard deviation
};
[[nodiscard]] Differences differences_from(const std::vector<CheckedResult>& values,
                                           const std::string& reference);

/// "stick-slip" or "stick".
[[nodiscard]] std::string verdict_of(bool slips);

/// "slip" or "stick".
[[nodiscard]] std::string state_of(const studies::ModeShapeStudy::Curve& curve);

/// Buckling load of the stick state in units of EI/L^2.
[[nodiscard]] double buckling_coefficient(const data::Beam& beam);

/// The largest relative difference of any two routes to |f_max| over the excitations.
[[nodiscard]] nlohmann::json force_differences(const std::vector<studies::ForceMaximumStudy>& maxima);

/// The points in the guard band, with their distance from the critical amplitude as a fraction of it.
[[nodiscard]] nlohmann::json guard_points(const studies::ClassificationStudy& study);

/// Critical amplitude at half the stiffness over that at the full one, at corresponding frequencies.
[[nodiscard]] nlohmann::json half_stiffness_ratio(const std::vector<studies::CriticalAmplitudePoint>& full,
                                                  const std::vector<studies::CriticalAmplitudePoint>& half);

/// Of the panels of Figs. 4 and 5, in the paper's order: verdicts on which paper, criterion and finite elements agree, and
/// the largest difference of a first slip (s) and half-width of a converged history.
[[nodiscard]] nlohmann::json histories(const std::vector<studies::ContactHistory>& histories);

/// The largest differences of the time stepper's finest runs. The damping ratio is that of the mode with the frequency
/// `first_hz`.
[[nodiscard]] nlohmann::json benchmark_extremes(const std::vector<studies::DampedBenchmark>& benchmarks,
                                                double first_hz);

/// A row for each run, and the largest share of the base work that is unexplained: of the event-driven runs, and on the
/// last mesh of the last audit.
[[nodiscard]] nlohmann::json energy_balances(const std::vector<studies::EnergyAudit>& audits);

/// The largest over the panels of Fig. 3. The prediction is that of the largest difference.
[[nodiscard]] nlohmann::json motion(const std::vector<studies::BeamMotionStudy>& motions);

/// What the templates read as `findings`: settings of the studies, and numbers drawn from their results.
[[nodiscard]] nlohmann::json findings(StudyResults& results);

}  // namespace stickslip::report
