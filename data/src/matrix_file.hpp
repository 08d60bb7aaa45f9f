// SPDX-License-Identifier: MIT
#pragma once

/// Files of finite-element programs, from their text: symmetric matrices, their degrees of freedom, a set of nodes. `file` is what a
/// message names. All throw InputError, naming file and line.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/model.hpp"

namespace stickslip::data {

/// Both triangles, ordered by row and column, each entry once, none 0.
struct SymmetricMatrix {
  int rows{};
  std::vector<MatrixEntry> entries;
};

/// A degree of freedom: 1, 2, 3 are the directions x, y, z.
struct NodeDirection {
  int node{}, direction{};

  auto operator<=>(const NodeDirection&) const = default;
};

/// A Matrix Market file (coordinate or array; real or integer; symmetric, by either triangle, or general, if it is symmetric to 1e-9 of
/// its largest entry); or, if `rows` are known, lines "row column value" of one triangle, as CalculiX 2.20 writes them (.mas, .sti).
/// Entries of one place add.
[[nodiscard]] SymmetricMatrix matrix_in(const std::string& file, std::string_view text,
                                        std::optional<int> rows);

/// Of each row: lines "node.direction" (CalculiX, .dof).
[[nodiscard]] std::vector<NodeDirection> degrees_of_freedom_in(const std::string& file,
                                                               std::string_view text);

/// The numbers under *NSET, or of a file without keywords (cgx, .nam).
[[nodiscard]] std::vector<int> node_set_in(const std::string& file, std::string_view text);

}  // namespace stickslip::data
