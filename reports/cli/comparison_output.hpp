// SPDX-License-Identifier: MIT
#pragma once

/// Comparisons with reference data as text and JUnit's XML.

#include <optional>
#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "comparison/diagnosis/hypothesis.hpp"

namespace stickslip::cli {

/// A file and what came of it: a comparison and what is said of what differs, or the sentence with which it was refused.
struct Judged {
  std::string name, file;
  std::optional<comparison::Comparison> comparison{};
  std::vector<comparison::Diagnosis> diagnoses{};
  std::string refusal{};
};

/// The verdict in one clause, such as "agrees in 12 of 120 rows".
[[nodiscard]] std::string conclusion_of(const comparison::Comparison& comparison);

/// The table of quantities, what was skipped, what is missing, and the diagnosis; or a line for each file.
[[nodiscard]] std::string text_of(const Judged& judged);
[[nodiscard]] std::string text_of(const std::vector<Judged>& all);

/// A test suite for each file, with a test case for the coverage, each quantity and each part: a failure if it differs, an error if
/// it is undecided. A refused file is an error.
[[nodiscard]] std::string junit_of(const std::vector<Judged>& all);

}  // namespace stickslip::cli
