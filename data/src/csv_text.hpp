#pragma once

/// Lines and cells of comma-separated values.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::data {

constexpr std::size_t largest_table = 50'000'000;  ///< bytes

/// "stick.csv:12, column 3 (frequency)", counted from 1.
[[nodiscard]] std::string cell_place(const std::filesystem::path& file, std::size_t line, std::size_t column,
                                     std::string_view name);

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
