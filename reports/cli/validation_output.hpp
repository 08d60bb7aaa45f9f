// SPDX-License-Identifier: MIT
#pragma once

/// Comparisons with measurements, in the form of ASME V&V 20.

#include <string>
#include <string_view>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "validation/study.hpp"

namespace stickslip::cli {

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
