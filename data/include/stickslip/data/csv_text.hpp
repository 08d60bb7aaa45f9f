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

/// The text of a table: a file, standard input for "-", or what a file in gzip's format holds, at most
/// limit::table_bytes. Throws InputError for what cannot be read, and for a format that is no text.
[[nodiscard]] std::string read_table_text(const std::filesystem::path& file);

/// Reads a table row by row. Cells are separated by commas, semicolons, tabs or else blanks, as in the line of
/// names, and may be quoted; blanks around them, the line ends of all systems, a byte order mark, a first line `sep=;`, empty lines
/// and lines that begin with # or % are understood. If half of the cells of the first line are numbers, the names are those of
/// the last comment before it that has as many cells. A line of units below the names is joined to them, as in
/// "frequency [kHz]". In a table with blanks, the rows may have one cell more in front, as R's have.
class CsvReader {
 public:
  using Cells = std::vector<std::string>;

  /// Reads the names of the columns from the text of a file, unless they are given because it has none, as the rest of a file
  /// behind some lines. Throws InputError, naming the file, if there are none or the text is not in UTF-8.
  CsvReader(std::filesystem::path file, std::string_view text, Cells names = {},
            std::size_t lines_before = 0);

  [[nodiscard]] const Cells& names() const noexcept { return names_; }

  /// The cells of the next row, as many as there are names; nothing at the end of the text. Throws
  /// InputError, naming the line, for another number of cells and for a quote that is not closed.
  [[nodiscard]] std::optional<std::vector<std::string>> next_row();

  /// Where the names stand and where the row stands that was read last, counted from 1.
  [[nodiscard]] std::size_t line_of_names() const noexcept { return line_of_names_; }
  [[nodiscard]] std::size_t line() const noexcept { return line_of_row_; }
  /// The lines that are read, of the whole file.
  [[nodiscard]] std::size_t lines() const noexcept { return line_; }

  /// The number of a cell, as finite_number; also with a Fortran exponent (1.0D-03) and, unless commas separate
  /// the cells, with a decimal comma.
  [[nodiscard]] std::optional<double> number(std::string_view cell) const;

  /// How many of the cells are numbers.
  [[nodiscard]] std::ptrdiff_t numbers_in(const Cells& cells) const;

  /// "stick.csv:12"
  [[nodiscard]] std::string place(std::size_t line) const;
  /// "stick.csv:12, column 3 (frequency)" for the column of index 2.
  [[nodiscard]] std::string place(std::size_t line, std::size_t column) const;

 private:
  struct Line {
    std::string_view text;
    std::size_t number{};
  };
  [[nodiscard]] std::string_view take_line();
  [[nodiscard]] std::optional<Line> next_line(std::vector<Line>* comments = nullptr);
  [[nodiscard]] Cells cells_of(const Line& line, char separator) const;
  void find_names(const Line& first, const std::vector<Line>& comments);
  bool take_units(const Cells& units);

  std::filesystem::path file_;
  std::string_view rest_;
  std::size_t line_{}, line_of_names_{}, line_of_row_{};
  std::optional<Line> held_;  // the first row, which was read to look for the names or the units
  char separator_{','};
  Cells names_;
  bool are_given_{};  // the names
};

/// A column's name and unit; the unit is nothing if there is none.
struct Header {
  std::string name;
  std::optional<std::string> unit;
};

/// Takes "name [unit]", "name (unit)" or "name / unit" apart; any other text is a name.
[[nodiscard]] Header header_of(std::string_view text);

/// As names of columns are compared: in lower case, with an underscore for a blank or a hyphen.
[[nodiscard]] std::string folded(std::string_view name);

/// The header, if its name is this one; `name_unit` and `name/unit` are one with a unit, too.
[[nodiscard]] std::optional<Header> header_named(std::string_view text, std::string_view name);

/// The finite number that the whole text is, if it is one; a leading + is allowed.
[[nodiscard]] std::optional<double> finite_number(std::string_view text);

}  // namespace stickslip::data
