// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace stickslip::report {

class ToolMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws ToolMissing, before the work whose results the program is to show.
void require_tool(const std::string& program);

/// Runs a program (found on the search path, no shell) in a folder, in the locale C.UTF-8, with its output in
/// a log file, and returns its exit status (128 + n if signal n ended it). One at a time. Throws ToolMissing, or
/// std::runtime_error if it cannot be started.
[[nodiscard]] int run_tool(const std::string& program, const std::vector<std::string>& arguments,
                           const std::filesystem::path& folder, const std::filesystem::path& log);

/// Ends the program that runs, if one does, and lets no other one start: for a program that ends here, from any thread.
void end_tools();

/// The first line that a program prints for `--version`; "not found" if it is missing.
[[nodiscard]] std::string tool_version(const std::string& program, const std::filesystem::path& scratch);

}  // namespace stickslip::report
