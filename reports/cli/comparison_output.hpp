// SPDX-License-Identifier: MIT
#pragma once

/// Comparisons as text, JSON and JUnit's XML: with reference data, and with measurements in the form of ASME V&V 20.

#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "comparison/comparison.hpp"
#include "validation/study.hpp"

namespace stickslip::cli {

/// A file and what came of it: a comparison, or the sentence with which it was refused.
struct Judged {
  std::string name, file;
  std::optional<comparison::Comparison> comparison{};
  std::string refusal{};
};

/// The verdict in one clause, such as "agrees in 12 of 120 rows".
[[nodiscard]] std::string conclusion_of(const comparison::Comparison& comparison);

/// The table of quantities, what was skipped, what is missing, and the diagnosis; or a line for each file.
[[nodiscard]] std::string text_of(const comparison::Comparison& comparison);
[[nodiscard]] std::string text_of(const std::vector<Judged>& all);

/// Everything, the points included; null stands for what is infinite.
[[nodiscard]] Json json_of(const comparison::Comparison& comparison, const std::string& file);
[[nodiscard]] Json json_of(const std::vector<Judged>& all);

/// A test suite for each file, with a test case for the coverage, each quantity and each part: a failure if it differs, an error if
/// it is undecided. A refused file is an error.
[[nodiscard]] std::string junit_of(const std::vector<Judged>& all);

/// A table whose columns have these names, in the text and in JSON.
[[nodiscard]] Table table_with(std::string_view names);

/// A row for each comparison: D, u_D, S, u_input, u_num, E = S - D, u_val, and where the error of the model lies; and the sentence
/// that says what that means.
void add_comparisons(Answer& answer, const std::vector<validation::Comparison>& comparisons);

/// --case CASE --samples N --json FILE --quiet, of an own measurement; the option --case.
struct OwnComparison {
  std::string problem;
  std::size_t samples = 1000;
  std::string json;
  bool quiet{};
};
CLI::Option* add_own_options(CLI::App& command, OwnComparison& options);

/// The measurement of a CSV file against the case. The status is `failed` if zero is outside of E ± 2 u_val somewhere.
[[nodiscard]] Answer compared_with_case(const std::string& file, const OwnComparison& options,
                                        Outputs& outputs);

}  // namespace stickslip::cli
