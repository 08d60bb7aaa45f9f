// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace stickslip::report {

/// The program is not on the search path.
class ToolMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a program (found on the search path, no shell) in a folder, in the locale C.UTF-8, with its output in
/// a log file, and returns its exit status (128 + n if signal n ended it). It belongs to the process group of
/// this program, so that Ctrl-C ends both. Throws ToolMissing, or std::runtime_error if it cannot be started.
[[nodiscard]] int run_tool(const std::string& program, const std::vector<std::string>& arguments,
                           const std::filesystem::path& folder, const std::filesystem::path& log);

/// The first line that a program prints for `--version`; "not found" if it is missing.
[[nodiscard]] std::string tool_version(const std::string& program, const std::filesystem::path& scratch);

}  // namespace stickslip::report
