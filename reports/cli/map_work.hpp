// SPDX-License-Identifier: MIT
#pragma once

/// What `map` does: a whole map, a part of one, the map that parts make, or what a map costs.

#include <string>
#include <vector>

#include "answer.hpp"
#include "command.hpp"
#include "map_part.hpp"

namespace stickslip::cli {

/// The files of a map: "-" is standard output, and an empty name no figure.
struct MapFiles {
  std::string output = "-", figure;
};

/// Makes the evaluations that no earlier run has left, and writes the map.
[[nodiscard]] Answer whole_map(const studies::MapTask& task, const MapFiles& files, Outputs& outputs);

/// The same of one part, which is written as the evaluations that it is; one that is complete already is left alone.
[[nodiscard]] Answer part_of_map(const studies::MapTask& task, const MapPart& part, const MapFiles& files,
                                 Outputs& outputs);

/// Writes the map that the files of all parts make.
[[nodiscard]] Answer merged_map(const std::vector<std::string>& parts, const MapFiles& files,
                                Outputs& outputs);

/// Times some evaluations of a part and tells what all of them take. Writes nothing.
[[nodiscard]] Answer cost_of_map(const studies::MapTask& task, const MapPart& part, Outputs& outputs);

}  // namespace stickslip::cli
