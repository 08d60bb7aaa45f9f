// SPDX-License-Identifier: MIT
#pragma once

#include "case_options.hpp"
#include "studies/stick_slip/squeal.hpp"

namespace stickslip::cli {

/// Period, amplitude, multipliers and verdict of a periodic motion, or why there is none.
void print_cycle(const studies::Cycle& cycle);
[[nodiscard]] Json cycle_json(const studies::Cycle& cycle);

}  // namespace stickslip::cli
