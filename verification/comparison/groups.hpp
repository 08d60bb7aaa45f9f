// SPDX-License-Identifier: MIT
#pragma once

/// The rows of a reference table and of a user's table that belong together.

#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/data/reference.hpp"
#include "stickslip/data/user_table.hpp"

namespace stickslip::comparison {

using Rows = std::vector<std::size_t>;

/// The rows of one curve or one sequence, in the reference and in the user's table.
struct Group {
  std::string label;
  Rows reference, theirs;
};

/// Whether row i of a table and row j of another have the same words or numbers in the columns of these names. A
/// column that one of the tables lacks does not count.
[[nodiscard]] bool are_alike(const std::vector<data::Column>& a, std::size_t i,
                             const std::vector<data::Column>& b, std::size_t j,
                             const std::vector<std::string>& names);

/// The user's table with numeric keys in single precision replaced: by the key of the reference within 1e-6, relative,
/// if that is the only one there. The column `abscissa` is left as it is.
[[nodiscard]] data::UserTable with_keys_of(const data::ReferenceTable& reference, data::UserTable theirs,
                                           const std::string& abscissa);

/// The words or numbers of a row in these columns, such as "beam = paper, mode = 3".
[[nodiscard]] std::string label_of(const data::ReferenceTable& reference,
                                   const std::vector<std::string>& columns, std::size_t row);

/// Throws data::InputError: the data set lacks the user's row.
[[noreturn]] void throw_unknown_row(const data::ReferenceTable& reference, const data::UserTable& theirs,
                                    const std::vector<std::string>& columns, std::size_t their_row);

/// The groups of the reference with the user's rows. Throws data::InputError for a row of no group.
[[nodiscard]] std::vector<Group> groups_of(const data::ReferenceTable& reference,
                                           const data::UserTable& theirs,
                                           const std::vector<std::string>& columns);

}  // namespace stickslip::comparison
