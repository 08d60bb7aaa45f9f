// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::report {

/// A table of comma-separated values: two comment lines (title, units), a line of column names, the rows.
/// Numbers are written with the digits that read back as the same double.
class CsvTable {
 public:
  /// Columns as in "time_s [s], steps [1], state [-]": 1 for a pure number, - for a word.
  CsvTable(std::string_view title, std::string_view columns);

  /// Throws std::invalid_argument if there are not as many cells as columns.
  void add_row(const std::vector<std::string>& cells);
  void add_numbers(const std::vector<double>& values);

  /// A row cell by cell, for tables of millions of rows; without a value the cell is empty.
  CsvTable& add(std::string_view cell);
  CsvTable& add(std::optional<double> value);
  void end_row();

  /// Makes room for text of this length in all, so that it need not move as it grows.
  void reserve(std::size_t length) { text_.reserve(length); }

  /// An empty line between two lines of a grid, as gnuplot asks for; other readers skip it.
  void end_grid_line() { text_ += '\n'; }

  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  /// Without comments and names of the columns.
  [[nodiscard]] std::string_view rows() const { return std::string_view(text_).substr(rows_begin_); }

 private:
  void require_columns(std::size_t cells) const;

  std::size_t columns_{}, rows_begin_{};
  std::size_t cells_{};  // in the row that has not ended
  std::string text_;
};

/// The shortest decimal text that reads back as the same double; empty for nothing.
[[nodiscard]] std::string csv_number(std::optional<double> value);

}  // namespace stickslip::report
