// SPDX-License-Identifier: MIT
#include "stickslip/data/installation.hpp"

#include <cstdlib>
#include <system_error>

namespace stickslip::data {

namespace fs = std::filesystem;

fs::path installed_folder(const char* variable, std::string_view folder, std::string_view source) {
  if (const char* chosen = std::getenv(variable); chosen != nullptr && *chosen != '\0') return chosen;
  std::error_code
      error;  // without /proc a program does not know its place, and what is not there is not installed
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = (program.parent_path() / STICKSLIP_SHARED_FILES / folder).lexically_normal();
  return fs::is_directory(installed, error) ? installed : fs::path(source);
}

}  // namespace stickslip::data
