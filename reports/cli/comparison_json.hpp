// SPDX-License-Identifier: MIT
#pragma once

/// Comparisons with reference data as JSON.

#include <string>
#include <vector>

#include "answer.hpp"
#include "comparison_output.hpp"

namespace stickslip::cli {

/// Everything, the points included; null stands for what is infinite.
[[nodiscard]] Json json_of(const Judged& judged);
[[nodiscard]] Json json_of(const std::vector<Judged>& all);

}  // namespace stickslip::cli
