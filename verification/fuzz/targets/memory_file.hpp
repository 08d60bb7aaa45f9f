// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace stickslip::fuzz {

/// A file in memory that has a path, so that functions which read files can use it.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Replaces the content of the file by `text` and returns the path.
  [[nodiscard]] std::filesystem::path with(std::string_view text);

 private:
  int descriptor_;
};

}  // namespace stickslip::fuzz
