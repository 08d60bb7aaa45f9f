// SPDX-License-Identifier: MIT
#pragma once

#include "answer.hpp"
#include "studies/analyses/squeal.hpp"

namespace stickslip::cli {

/// Adds a periodic motion, or the reason why there is none; its members stand in an object with the key, if there is one.
void add_cycle(Answer& answer, const studies::Cycle& cycle, const std::string& key = "");

}  // namespace stickslip::cli
