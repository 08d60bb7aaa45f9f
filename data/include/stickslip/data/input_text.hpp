// SPDX-License-Identifier: MIT
#pragma once

/// What reading a file of any format needs: its bytes, how much it may hold, parts of it fit for a message or
/// another output, and the nearest known name to a misspelt one.

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::data {

/// What an input may hold at most. The user guide shows the table.
struct Limit {
  std::string_view of;
  std::size_t most;
};
namespace limit {
inline constexpr Limit case_bytes{"bytes of a case", 1'000'000},
    case_dots{"dots in a case, as each one in a key opens a table", 5000},
    matrix_bytes{"bytes of a file of a structure, as of its mass matrix", 1'000'000'000},
    package_bytes{"bytes of `datapackage.json`", 10'000'000},
    package_levels{"levels of nesting in `datapackage.json`", 100},
    table_bytes{"bytes of a table, also once decompressed", 50'000'000},
    table_columns{"columns of a table", 10'000}, map_bytes{"bytes of a map", 500'000'000},
    record_bytes{"bytes of a record of a motion", 500'000'000},
    map_values{"values along an axis of a map", 2000},
    number_length{"characters of a number with its unit", 1000},
    mistakes{"mistakes of a case, after which the rest is not read", 20};
inline constexpr std::array all{case_bytes,     case_dots,   matrix_bytes,  package_bytes,
                                package_levels, table_bytes, table_columns, map_bytes,
                                record_bytes,   map_values,  number_length, mistakes};
}  // namespace limit

/// The bytes of a file, of which there may be `most`. Throws InputError, naming the file, if it cannot be
/// read, is empty or larger.
[[nodiscard]] std::string read_bounded(const std::filesystem::path& file, std::size_t most);

/// Hands the bytes of a file, of which there may be `most`, on in parts that end with a line, and returns their SHA-256 digest.
/// Throws what read_bounded() throws.
[[nodiscard]] std::string read_lines(const std::filesystem::path& file, std::size_t most,
                                     const std::function<void(std::string_view)>& take);

/// From here on, or no longer, no AtomicFile may be a file that read_bounded() has read.
void protect_inputs(bool from_here_on);
/// Throws InputError, naming the output, if it is such a file, by whatever name.
void require_no_input(const std::filesystem::path& output);

/// Without blanks at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text on one line for use in a message: control characters, what is no UTF-8 and what XML forbids replaced, anything
/// beyond `longest` bytes cut off.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest = 60);

// A text that may hold anything, such as the name of a file, in an output: one function for each format. For JSON
// nlohmann's dump() does it.

/// For a terminal, and for XML, in which the library that writes the file escapes < > & and quotes: printable(), with the
/// line breaks and tabs that stand in it.
[[nodiscard]] std::string plain_text(std::string_view text);

/// A cell of a CSV file (RFC 4180): in quotes if it holds a comma, a quote or a line break. A text that a
/// spreadsheet would compute, as it begins with = + - or @ and is no number, has an apostrophe in front.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// A string of gnuplot in double quotes, in which nothing is computed.
[[nodiscard]] std::string gnuplot_string(std::string_view text);

/// "a, b, c"
[[nodiscard]] std::string joined(const std::vector<std::string>& names);

/// " (did you mean beam.length?)", or nothing when no name is near: at most a third of the letters may differ
/// (optimal string alignment: two neighbours in the wrong order count as one letter).
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& names);

/// Whether a file that a case, a manifest or a package names is in its folder or below: a relative path without "..", and no "-".
[[nodiscard]] bool is_inside(const std::filesystem::path& file);

/// The SHA-256 digest (FIPS 180-4) of some bytes, as 64 hexadecimal digits in lower case.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace stickslip::data
