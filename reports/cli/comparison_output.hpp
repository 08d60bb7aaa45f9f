// SPDX-License-Identifier: MIT
#pragma once

/// A comparison as text, JSON and JUnit's XML.

#include <string>

#include "case_options.hpp"
#include "comparison/comparison.hpp"

namespace stickslip::cli {

/// The table of quantities, what was skipped, what is missing, and the diagnosis.
[[nodiscard]] std::string text_of(const comparison::Comparison& comparison);

/// Everything, the points included; null stands for what is infinite.
[[nodiscard]] Json json_of(const comparison::Comparison& comparison, const std::string& file);

/// One test case for each quantity: a failure if it differs, skipped if it is undecided.
[[nodiscard]] std::string junit_of(const comparison::Comparison& comparison, const std::string& file);

}  // namespace stickslip::cli
