// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stickslip::report {

/// The contents of a file, byte for byte; empty if it cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// Writes the text to a file, to the disk. Throws std::runtime_error naming the file and the reason.
void write_text(const std::filesystem::path& file, std::string_view text);

/// The same by way of `<file>.unfinished`, so that the file appears whole or stays as it is. Throws what
/// write_text() and std::filesystem::rename() throw.
void replace_text(const std::filesystem::path& file, std::string_view text);

}  // namespace stickslip::report
