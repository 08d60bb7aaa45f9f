#pragma once

/// Counts and extremes over a study's rows, which the text, the summary and the tables all quote.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "study_results.hpp"

namespace stickslip::report {

/// Smallest and largest of something.
struct Range {
  double lowest{};
  double highest{};
};

[[nodiscard]] Range orders_of(const studies::FrequencyStudy& study);
[[nodiscard]] Range orders_of(const std::vector<studies::TimeOrderStudy>& studies);

/// |a/b - 1| in per cent.
[[nodiscard]] double percent_difference(double a, double b);

/// Largest differences over the force maxima, in per cent.
struct ForceDifferences {
  double sampling{};        ///< sampled against true, N modes
  double truncation{};      ///< N modes against converged
  double discretisation{};  ///< finite elements against converged
  double prediction{};      ///< finite elements against predicted
};
[[nodiscard]] ForceDifferences force_differences(const std::vector<studies::ForceMaximumStudy>& maxima);

struct PointCounts {
  std::size_t all{};
  int agreeing{}, in_guard{}, disagreeing_inside{}, disagreeing_outside{};
};
[[nodiscard]] PointCounts point_counts(const studies::ClassificationStudy& study);

/// Half-widths of the guard band over all frequencies, relative.
[[nodiscard]] Range guard_range(const studies::ClassificationStudy& study);

struct HistoryFindings {
  int verdicts_agreeing{};         ///< paper, criterion and finite elements say the same
  double first_slip_difference{};  ///< largest, s
  Range half_widths;               ///< largest of each converged history, as a fraction of its range
};
[[nodiscard]] HistoryFindings history_findings(const std::vector<studies::ContactHistory>& histories);

/// The time stepper's run on the most elements with the shortest step.
[[nodiscard]] const studies::BenchmarkRun& finest_stepped(const studies::DampedBenchmark& benchmark);

/// A computed value beside what it is held against.
struct ComparedValue {
  std::string what;       ///< "frequency.stick.1, closed form"
  std::string reference;  ///< what it is held against: "printed" or "closed form"
  double computed{}, expected{};
  bool known_erratum{};  ///< a printed number that does not hold
  [[nodiscard]] double relative_difference() const { return computed / expected - 1.0; }
};

/// Every printed result against its recomputation, and every finite-element result of the solution
/// verification against the closed form.
[[nodiscard]] std::vector<ComparedValue> compared_values(StudyResults& results);

/// Of the relative differences, errata apart.
struct Agreement {
  std::size_t count{};
  double bias{};     ///< mean
  double spread{};   ///< standard deviation
  double largest{};  ///< in magnitude
};
[[nodiscard]] Agreement agreement_with(const std::vector<ComparedValue>& values,
                                       const std::string& reference);

/// Buckling load of the stick state in units of EI/L^2.
[[nodiscard]] double buckling_coefficient(const data::Beam& beam);

/// Whether the text as printed misses the reference and the corrected text meets it.
[[nodiscard]] bool confirmed(const studies::ErratumEvidence& evidence);

/// The different reasons for what counts as agreement, in the order of their first use; the report refers to
/// them by letters.
[[nodiscard]] std::vector<std::string> printed_reasons(const std::vector<studies::PrintedCheck>& checks);
/// The same for how the uncertainties of the solution verification were obtained.
[[nodiscard]] std::vector<std::string> uncertainty_sources(StudyResults& results);

/// 'a' for the first of `texts`, and so on.
[[nodiscard]] char letter_of(const std::string& text, const std::vector<std::string>& texts);

}  // namespace stickslip::report
