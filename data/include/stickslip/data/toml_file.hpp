// SPDX-License-Identifier: MIT
#pragma once

/// What both kinds of TOML files (cases, the paper's numbers) need: reading with a bound, places and values
/// as text.

#include <toml++/toml.h>

#include <filesystem>
#include <string>

#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

/// Parses a TOML file of at most 1 MB. Throws InputError, naming the file and, for a syntax error, the line.
[[nodiscard]] toml::table read_toml(const std::filesystem::path& file);

/// The same from the text of the file.
[[nodiscard]] toml::table parse_toml(const std::filesystem::path& file, const std::string& text);

/// "paper.toml:3", the line on which the node's value begins.
[[nodiscard]] std::string place_of(const std::filesystem::path& file, const toml::node& node);

/// The value and its type on one line: "abc" (a string), true (a boolean), an array, 0.5 (a float).
[[nodiscard]] std::string describe(const toml::node& node);

}  // namespace stickslip::data
