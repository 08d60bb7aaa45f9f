#pragma once

#include <filesystem>
#include <string_view>

namespace stickslip::fuzz {

/// A file in memory that has a path, for what reads files.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// The path of the file, which now holds this text alone.
  [[nodiscard]] std::filesystem::path with(std::string_view text);

 private:
  int descriptor_;
};

}  // namespace stickslip::fuzz
