// SPDX-License-Identifier: MIT
#pragma once

/// Tables of comma-separated values: those of the data package, and those of a user.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::data {

constexpr std::size_t largest_table = 50'000'000;  ///< bytes

/// Reads a table row by row. Cells are separated by commas, semicolons or tabs, as in the line of names, and
/// may be quoted; blanks around them, CRLF, a byte order mark, empty lines and lines that begin with # are
/// understood.
class CsvReader {
 public:
  /// Reads the names of the columns from the text of a file. Throws InputError, naming the file, if there are
  /// none or the text is not in UTF-8.
  CsvReader(std::filesystem::path file, std::string_view text);

  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

  /// The cells of the next row, as many as there are names; nothing at the end of the text. Throws
  /// InputError, naming the line, for another number of cells and for a quote that is not closed.
  [[nodiscard]] std::optional<std::vector<std::string>> next_row();

  /// Where the names stand and where the row stands that was read last, counted from 1.
  [[nodiscard]] std::size_t line_of_names() const noexcept { return line_of_names_; }
  [[nodiscard]] std::size_t line() const noexcept { return line_; }

  /// "stick.csv:12"
  [[nodiscard]] std::string place(std::size_t line) const;
  /// "stick.csv:12, column 3 (frequency)" for the column of index 2.
  [[nodiscard]] std::string place(std::size_t line, std::size_t column) const;

 private:
  [[nodiscard]] std::optional<std::string_view> next_line();
  [[nodiscard]] std::vector<std::string> cells_of(std::string_view line) const;

  std::filesystem::path file_;
  std::string_view rest_;
  std::size_t line_{}, line_of_names_{};
  char separator_{','};
  std::vector<std::string> names_;
};

/// The finite number that the whole text is, if it is one; a leading + is allowed.
[[nodiscard]] std::optional<double> finite_number(std::string_view text);

/// A column of a key: its texts are compared or, in a numeric column, its numbers (is_same_key).
struct KeyColumn {
  const std::vector<std::string>* text;
  const std::vector<double>* values;  ///< null for words
};

/// The first two rows that share their key.
struct Twice {
  std::size_t first, second;
};
[[nodiscard]] std::optional<Twice> repeated_key(const std::vector<KeyColumn>& key, std::size_t rows);

}  // namespace stickslip::data
