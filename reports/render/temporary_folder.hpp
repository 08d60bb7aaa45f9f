// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace stickslip::report {

/// A new folder that is removed in the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const char* const chosen = std::getenv("TMPDIR");
    std::string name = std::string(chosen == nullptr ? "/tmp" : chosen) + "/stickslip-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(),
                              "the temporary folder " + name + " cannot be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;  // nothing is left to be done about a folder that cannot be removed
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace stickslip::report
