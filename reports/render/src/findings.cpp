#include "findings.hpp"

#include <algorithm>
#include <limits>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/paper.hpp"

namespace stickslip::report {

namespace {

class RangeBuilder {
 public:
  void add(double value) {
    range_.lowest = std::min(range_.lowest, value);
    range_.highest = std::max(range_.highest, value);
  }
  [[nodiscard]] Range range() const { return range_; }

 private:
  Range range_{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

}  // namespace

Range orders_of(const studies::FrequencyStudy& study) {
  RangeBuilder orders;
  for (const auto& mode : study.modes) orders.add(mode.observed_order.order);
  return orders.range();
}

Range orders_of(const std::vector<studies::TimeOrderStudy>& studies) {
  RangeBuilder orders;
  for (const auto& study : studies)
    for (const auto& order : {study.displacement_order, study.velocity_order, study.reaction_order})
      orders.add(order.order);
  return orders.range();
}

double percent_difference(double a, double b) { return 100.0 * std::abs(a / b - 1.0); }

ForceDifferences force_differences(const std::vector<studies::ForceMaximumStudy>& maxima) {
  ForceDifferences largest;
  const auto raise = [](double& value, double a, double b) {
    value = std::max(value, percent_difference(a, b));
  };
  for (const auto& row : maxima) {
    const double converged = row.converged.midpoint();
    raise(largest.sampling, row.sampled, row.truncated.midpoint());
    raise(largest.truncation, row.truncated.midpoint(), converged);
    raise(largest.discretisation, row.finite_element, converged);
    raise(largest.prediction, row.finite_element, row.predicted_finite_element);
  }
  return largest;
}

PointCounts point_counts(const studies::ClassificationStudy& study) {
  const int disagreeing = static_cast<int>(study.points.size()) - study.agreeing;
  return {study.points.size(), study.agreeing, study.in_guard_band, disagreeing - study.disagreeing_outside,
          study.disagreeing_outside};
}

Range guard_range(const studies::ClassificationStudy& study) {
  RangeBuilder guards;
  for (const auto& frequency : study.frequencies) guards.add(frequency.relative_guard());
  return guards.range();
}

HistoryFindings history_findings(const std::vector<studies::ContactHistory>& histories) {
  HistoryFindings findings;
  RangeBuilder half_widths;
  const auto verdicts = data::printed_verdicts();
  for (std::size_t i = 0; i < histories.size(); ++i) {
    const auto& history = histories[i];
    const bool printed = verdicts[i].verdict == "stick-slip";
    const bool computed = history.finite_element_slip.has_value();
    if (printed == computed && printed == history.criterion_slips) ++findings.verdicts_agreeing;
    if (!computed) continue;
    if (history.converged) half_widths.add(history.converged->largest_half_width());
    if (history.closed_form_slip)
      findings.first_slip_difference = std::max(
          findings.first_slip_difference, std::abs(*history.finite_element_slip - *history.closed_form_slip));
  }
  findings.half_widths = half_widths.range();
  return findings;
}

const studies::BenchmarkRun& finest_stepped(const studies::DampedBenchmark& benchmark) {
  const studies::BenchmarkRun* finest = nullptr;
  for (const auto& run : benchmark.runs)
    if (run.time_step > 0.0 && (!finest || run.size > finest->size ||
                                (run.size == finest->size && run.time_step < finest->time_step)))
      finest = &run;
  return *finest;
}

std::vector<ComparedValue> compared_values(StudyResults& results) {
  std::vector<ComparedValue> values;
  for (const auto& check : results.printed_checks())
    values.push_back({.what = check.printed.id + " by " + check.method,
                      .reference = "printed",
                      .computed = check.computed,
                      .expected = check.printed.value,
                      .known_erratum = !check.agrees()});
  for (const auto& result : results.solution_verification().results)
    values.push_back({.what = result.quantity,
                      .reference = "closed form",
                      .computed = result.levels.front().value,
                      .expected = result.reference});
  return values;
}

Agreement agreement_with(const std::vector<ComparedValue>& values, const std::string& reference) {
  Agreement agreement;
  double sum = 0.0, squares = 0.0;
  for (const ComparedValue& value : values) {
    if (value.reference != reference || value.known_erratum) continue;
    const double difference = value.relative_difference();
    ++agreement.count;
    sum += difference;
    squares += difference * difference;
    agreement.largest = std::max(agreement.largest, std::abs(difference));
  }
  const auto count = static_cast<double>(agreement.count);
  agreement.bias = sum / count;
  agreement.spread = std::sqrt((squares - count * agreement.bias * agreement.bias) / (count - 1.0));
  return agreement;
}

double buckling_coefficient(const data::Beam& beam) {
  const double rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  return analytic::stick_buckling_load(beam) * beam.length() * beam.length() / rigidity;
}

bool confirmed(const studies::ErratumEvidence& evidence) {
  return std::abs(evidence.corrected - evidence.reference) <= evidence.tolerance &&
         std::abs(evidence.as_printed - evidence.reference) > evidence.tolerance;
}

namespace {

// Each text once, in the order of its first use.
std::vector<std::string> distinct(const auto& rows, auto member) {
  std::vector<std::string> texts;
  for (const auto& row : rows)
    if (std::ranges::find(texts, row.*member) == texts.end()) texts.push_back(row.*member);
  return texts;
}

}  // namespace

std::vector<std::string> printed_reasons(const std::vector<studies::PrintedCheck>& checks) {
  return distinct(checks, &studies::PrintedCheck::because);
}

std::vector<std::string> uncertainty_sources(StudyResults& results) {
  return distinct(results.solution_verification().results, &studies::VerifiedResult::obtained);
}

char letter_of(const std::string& text, const std::vector<std::string>& texts) {
  return "abcdefghijklmnopqrstuvwxyz"[(std::ranges::find(texts, text) - texts.begin()) % 26];
}

}  // namespace stickslip::report
