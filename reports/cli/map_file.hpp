// SPDX-License-Identifier: MIT
#pragma once

/// A map that is a file: the output of `map`, or those of all its parts joined.

#include <array>
#include <string>

#include "studies/analyses/criterion_map.hpp"

namespace stickslip::cli {

inline constexpr std::array<studies::CellState, 3> all_states{analytic::Verdict::stick,
                                                              analytic::Verdict::stick_slip, std::nullopt};

struct MapFile {
  /// Of the cells x, y, state and which quantities have converged: with a change of 0, the others of 1.
  studies::CriterionMap map;
  std::string case_name;
  std::string table;  ///< in the order of the map
};

/// Reads a map, whose rows may have any order. Throws data::InputError, naming --from, the file and what is wrong with it, unless it has the
/// columns of a map and each point of its two axes once, and these have equal steps or equal ratios.
[[nodiscard]] MapFile read_map(const std::string& file);

}  // namespace stickslip::cli
