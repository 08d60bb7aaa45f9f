// SPDX-License-Identifier: MIT
#include "validation_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "case_options.hpp"
#include "program.hpp"
#include "range_text.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/analyses/measured_case.hpp"

namespace stickslip::cli {

Table table_with(std::string_view names) {
  Table table;
  for (const auto name : split(names, ' ')) table.columns.push_back({std::string(name), std::string(name)});
  return table;
}

void add_comparisons(Answer& answer, const std::vector<validation::Comparison>& comparisons) {
  Table table = table_with("experiment record quantity model unit D u_D S u_input u_num E u_val");
  table.columns.front().header.clear();
  table.columns.insert(table.columns.end(),
                       {{"", "lower"}, {"", "upper"}, {"", "resolved"}, {"error of the model", ""}});
  std::ptrdiff_t resolved = 0, outside = 0;
  for (const auto& one : comparisons) {
    const double lower = one.error() - 2.0 * one.uncertainty(), upper = one.error() + 2.0 * one.uncertainty();
    const bool is_resolved = one.is_resolved();
    resolved += is_resolved ? 1 : 0;
    outside += one.contains_zero() ? 0 : 1;
    table.rows.push_back(
        {word(one.experiment), word(one.record), word(one.quantity), word(one.form), word(one.unit),
         rounded(one.measured, 5), rounded(one.measured_uncertainty, 2), rounded(one.predicted, 5),
         rounded(one.input_uncertainty, 2), rounded(one.numerical_uncertainty, 2), rounded(one.error(), 3),
         rounded(one.uncertainty(), 2), rounded(lower, 3), rounded(upper, 3), Value{is_resolved, ""},
         word(is_resolved ? fmt::format("{:.3g} ... {:.3g}", lower, upper) : "nothing resolved")});
  }
  answer.add_table("comparisons", table);
  answer.add_line(
      fmt::format("\nE = S - D. The error of the model lies in E +- 2 u_val; where |E| < u_val nothing was "
                  "resolved. Resolved: {} of {}; zero outside: {}.",
                  resolved, comparisons.size(), outside));
}

CLI::Option* add_own_options(CLI::App& command, OwnComparison& options) {
  auto* problem =
      command.add_option("--case", options.problem,
                         "Compare with this case: NAME is a CSV file with the columns quantity "
                         "(stick_frequency, slip_frequency, "
                         "critical_amplitude), at (mode, or Hz), value (Hz, m) and half_width (of 95 %)");
  add_integer_option(command, "--samples", options.samples, 2, 1'000'000,
                     "Of the uncertain keys of that case")
      ->needs(problem);
  add_file_option(command, "--json", options.json, "JSON file with all numbers, '-' for standard output");
  command.add_flag("--quiet", options.quiet, "Print nothing");
  return problem;
}

Answer compared_with_case(const std::string& file, const OwnComparison& options, Outputs& outputs) {
  if (file.empty()) throw CLI::RequiredError("NAME");
  const auto problem = data::find_case(options.problem);
  outputs.open({{"the table", options.quiet || options.json == "-" ? "" : "-"}, {"--json", options.json}});
  const studies::CaseComparison result =
      studies::compare_with_case(problem, file, options.samples, std::ref(outputs.progress()));
  Answer answer;
  answer.add_members({{"file", file},
                      {"case", options.problem},
                      {"samples", options.samples},
                      {"dropped_samples", result.dropped}});
  add_comparisons(answer, result.comparisons);
  if (result.dropped > 0)
    answer.add_line(fmt::format("{} samples are inadmissible and count in no u_input.", result.dropped));
  if (!result.has_uncertainty) answer.add_line("The case has no table [uncertainty]: u_input is 0.");
  require_finite(answer.json);
  outputs.write("the table", [&] { return answer.text; });
  outputs.write_json(answer.json);
  Answer verdict;
  verdict.status =
      std::ranges::all_of(result.comparisons, &validation::Comparison::contains_zero) ? done : failed;
  return verdict;
}

}  // namespace stickslip::cli
