// SPDX-License-Identifier: MIT
#pragma once

/// What reading a file of any format needs: its bytes, parts of it fit for a message, and the nearest known
/// name to a misspelt one.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::data {

/// The bytes of a file, which may have `most` of them. Throws InputError, naming the file, if it cannot be
/// read, is empty or larger.
[[nodiscard]] std::string read_bounded(const std::filesystem::path& file, std::size_t most);

/// Without blanks at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text on one line for use in a message: control characters and what is no UTF-8 replaced, anything
/// beyond `longest` bytes cut off.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest = 60);

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
