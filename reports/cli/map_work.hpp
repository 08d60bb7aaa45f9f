// SPDX-License-Identifier: MIT
#pragma once

/// What `map` does: a map or a part of one, the figure of a map that is a file, or what a map costs.

#include <string>

#include "answer.hpp"
#include "command.hpp"
#include "studies/analyses/criterion_map.hpp"

namespace stickslip::cli {

/// Makes the part of the map and writes it to the open files of --output and --figure. Of part 1 the file has the title and the
/// names of the columns, so that the parts one after another have the bytes of the whole map.
[[nodiscard]] Answer made_map(const studies::MapTask& task, Outputs& outputs);

/// Draws the map that a file holds, the outputs of all parts in any order behind the first, in the file `figure`. Throws
/// data::InputError, naming the file and what is wrong with it, unless it has each point of the two axes once, and these in equal
/// steps or ratios.
[[nodiscard]] Answer drawn_map(const std::string& file, const std::string& figure, Outputs& outputs);

/// Times some evaluations of the part and tells what all of them take. Writes nothing.
[[nodiscard]] Answer cost_of_map(const studies::MapTask& task, Outputs& outputs);

}  // namespace stickslip::cli
