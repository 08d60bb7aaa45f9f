#pragma once

/// What both kinds of TOML files (cases, the paper's numbers) need: reading with a bound, places and values
/// as text, and the nearest known name to a misspelt one.

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::data {

/// Parses a TOML file of at most 1 MB. Throws InputError, naming the file and, for a syntax error, the line.
[[nodiscard]] toml::table read_toml(const std::filesystem::path& file);

/// "paper.toml:3", the line on which the node's value begins.
[[nodiscard]] std::string place_of(const std::filesystem::path& file, const toml::node& node);

/// The value and its type on one line: "abc" (a string), true (a boolean), an array, 0.5 (a float).
[[nodiscard]] std::string describe(const toml::node& node);

/// The text on one line, control characters replaced and anything beyond 60 bytes cut off, for use in a
/// message.
[[nodiscard]] std::string printable(std::string_view text);

/// "a, b, c"
[[nodiscard]] std::string joined(const std::vector<std::string>& names);

/// " (did you mean beam.length?)", or nothing when no name is near: at most a third of the letters may differ
/// (Levenshtein distance).
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& names);

}  // namespace stickslip::data
