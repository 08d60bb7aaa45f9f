// SPDX-License-Identifier: MIT
#include "studies/analyses/measured_case.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/slip_probability.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/natural_frequencies.hpp"

namespace stickslip::studies {

namespace {

struct OwnMeasurement {
  std::string quantity;
  double at{}, value{}, half_width{};
};

bool is_frequency(const OwnMeasurement& one) {
  return one.quantity == "stick_frequency" || one.quantity == "slip_frequency";
}

EstimatedFrequency frequency_of(const data::Case& problem, const OwnMeasurement& one) {
  const auto tip = one.quantity == "slip_frequency" ? analytic::TipSupport::free : analytic::TipSupport::held;
  return closed_form_frequencies(problem.beam(), tip, static_cast<int>(one.at)).back();
}

double sampled(const data::Case& problem, const OwnMeasurement& one) {
  if (is_frequency(one)) return frequency_of(problem, one).hz;
  return analytic::evaluate_criterion(problem, 1e-6).critical_amplitude.midpoint();
}

// S and u_num.
std::pair<double, double> predicted(const data::Case& problem, const OwnMeasurement& one) {
  if (is_frequency(one)) {
    const auto [hz, relative_error] = frequency_of(problem, one);
    return {hz, hz * relative_error};
  }
  require_resting_wall(problem);
  require_friction(problem);
  const CriterionAnswer answer = criterion_answer(problem);
  const analytic::Bounds &all = answer.all_modes.critical_amplitude,
                         &some = answer.truncated.critical_amplitude;
  return {all.midpoint(), 0.5 * (std::max(all.upper, some.upper) - std::min(all.lower, some.lower))};
}

// The standard deviation over the samples that are beams, and how many are none.
std::pair<double, std::size_t> spread_of(const data::Case& problem, const data::Uncertainty& uncertainty,
                                         const OwnMeasurement& one, std::size_t samples,
                                         const std::function<void(double)>& progress) {
  const JointDistribution joint(uncertainty);
  std::vector<double> values(samples, std::nan(""));
  const auto work = [&](std::size_t index) {
    try {
      const auto point = joint.at(independent_point(1, index, joint.size()));
      values[index] = sampled(studies::case_at(problem, uncertainty.keys, point), one);
    } catch (const data::InputError&) {
      return;  // no beam
    }
  };
  in_parallel(samples, work, progress);
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.size() < 2) throw data::InputError("of the samples of [uncertainty] two or more must be beams");
  return {gsl_stats_sd(values.data(), 1, values.size()), samples - values.size()};
}

std::vector<OwnMeasurement> read_measurements(const std::filesystem::path& file) {
  const std::string text = data::read_table_text(file);
  data::CsvReader reader(file, text);
  if (reader.names() != data::CsvReader::Cells{"quantity", "at", "value", "half_width"})
    throw data::InputError(reader.place(reader.line_of_names()) +
                           ": the columns must be quantity, at, value and half_width");
  std::vector<OwnMeasurement> all;
  while (const auto cells = reader.next_row()) {
    OwnMeasurement one;
    one.quantity = cells->front();
    const auto refuse = [&](std::size_t column, const std::string& allowed) {
      throw data::FieldError(reader.place(reader.line(), column), data::printable((*cells)[column]), allowed);
    };
    if (!is_frequency(one) && one.quantity != "critical_amplitude")
      refuse(0, "stick_frequency, slip_frequency or critical_amplitude");
    const auto number = [&](std::size_t column) {
      const auto value = reader.number((*cells)[column]);
      if (!value) refuse(column, "a finite number");
      return *value;
    };
    one.at = number(1), one.value = number(2), one.half_width = number(3);
    if (is_frequency(one) && !(one.at >= 1.0 && one.at <= 1000.0 && one.at == std::floor(one.at)))
      refuse(1, "the number of a mode, 1 to 1000");
    if (!(one.value > 0.0)) refuse(2, "above 0");
    if (one.half_width < 0.0) refuse(3, "0 or more");
    all.push_back(one);
  }
  if (all.empty()) throw data::InputError(file.string() + ": has no rows, but must have at least one");
  return all;
}

}  // namespace

CaseComparison compare_with_case(const std::filesystem::path& case_file,
                                 const std::filesystem::path& measurements, std::size_t samples,
                                 const std::function<void(double)>& progress) {
  const std::vector<OwnMeasurement> all = read_measurements(measurements);
  const data::Uncertainty uncertainty = data::read_uncertainty(case_file);
  for (const auto& key : uncertainty.keys)
    if (key.key == "excitation.frequency_hz" || key.key.starts_with("contact."))
      throw data::FieldError(key.place, key.key,
                             "certain here: the file of the measurement says at which frequency");
  CaseComparison result;
  result.has_uncertainty = !uncertainty.keys.empty();
  for (const OwnMeasurement& one : all) {
    std::vector<data::Override> overrides;
    if (!is_frequency(one))
      overrides.push_back({"excitation.frequency_hz", data::shortest_text(one.at), "the column at"});
    const data::Case problem = data::read_case(case_file, overrides);
    data::require_rigid(problem.contact.compliance, "a frequency or critical amplitude; respond takes it");
    const auto [value, numerical] = predicted(problem, one);
    const auto before = static_cast<double>(result.comparisons.size()),
               rows = static_cast<double>(all.size());
    std::pair<double, std::size_t> spread;
    if (result.has_uncertainty)
      spread = spread_of(problem, uncertainty, one, samples, [&](double share) {
        if (progress) progress((before + share) / rows);
      });
    result.dropped += spread.second;
    result.comparisons.push_back({"own", data::shortest_text(one.at), one.quantity, problem.name,
                                  is_frequency(one) ? "Hz" : "m", one.value, 0.5 * one.half_width, value,
                                  spread.first, numerical});
  }
  return result;
}

}  // namespace stickslip::studies
