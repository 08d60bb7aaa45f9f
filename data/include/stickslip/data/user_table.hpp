// SPDX-License-Identifier: MIT
#pragma once

/// A user's results as a CSV file, to be compared with a data set.
///
/// Columns are found by their names, in any order and in any case; a unit may follow the name and is
/// converted to that of the data set: `frequency [kHz]`, `frequency (kHz)`, `frequency / kHz`,
/// `frequency_kHz`, `frequency/kHz`, or in a line below the names. csv_text.hpp says which formats are understood. The columns
/// of `stickslip respond` are known. Columns that the data set does not have are left alone.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/reference.hpp"

namespace stickslip::data {

/// --column REFERENCE=THEIRS[:unit]: which of their columns it is, and in which unit.
struct ColumnMapping {
  std::string reference;
  std::string theirs;
  std::string unit;  ///< empty: as the header says, or that of the data set

  /// Throws InputError if there is no '=' or a side is empty.
  static ColumnMapping parse(std::string_view text);
};

struct UserTable {
  std::filesystem::path file;
  std::vector<Column> columns;     ///< those that the data set has, in its units
  std::vector<std::size_t> lines;  ///< where each row stands

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  /// Null if the file lacks it.
  [[nodiscard]] const Column* column(std::string_view name) const { return find_column(columns, name); }
  /// "theirs.csv:12"
  [[nodiscard]] std::string place(std::size_t row) const;
};

/// Reads a file of at most 50 MB. It must have the columns of the primary key (but not one in which the data
/// set has one value only, nor the `index` of events), the abscissa, the `change` and the `time` of events,
/// and at least one of the values that are compared. Throws InputError, naming file, line, column and value
/// and what is allowed, for a column that is missing, stands twice or has an unknown unit, for a cell that is
/// no finite number, for a line with fewer or more cells, for no rows, for a key that stands twice in
/// a table, and for an abscissa or times of events that decrease. A file without a line of names is refused unless
/// `names` gives them, in the order of its columns. Messages quote the names of the columns of the file unless is_quoted is
/// false, for a file that a manifest of someone else names. (Cells are quoted where the file has the columns of the data set.)
[[nodiscard]] UserTable read_user_table(const std::filesystem::path& file, const ReferenceTable& reference,
                                        const std::vector<ColumnMapping>& mappings = {},
                                        const std::vector<std::string>& names = {}, bool is_quoted = true);

/// Throws InputError if a mapping names a column that none of the data sets has.
void require_known_columns(const std::vector<ColumnMapping>& mappings,
                           const std::vector<const ReferenceTable*>& references);

/// The primary key without the abscissa and without `index`: what tells one curve, or one sequence of events,
/// from another.
[[nodiscard]] std::vector<std::string> group_columns(const Resource& resource);

}  // namespace stickslip::data
