// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stickslip::data {

/// An output that cannot be written: names the path and the reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that appears under its name only when it is complete: written beside it under a temporary name
/// (.NAME.stickslip-PID, locked while it is written; what a killed run of the same user has left there the next
/// one removes), flushed to the disk and renamed by commit(); removed if commit() is not reached. A file that is
/// replaced leaves its mode. "-" is standard output. What exists and is no regular file (a pipe, /dev/null) is
/// written to directly; a symbolic link stays and its target is replaced or made.
class AtomicFile {
 public:
  /// Throws OutputError if the path cannot be written, InputError as require_no_input().
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws OutputError, on a full disk for one.
  void write(std::string_view text);

  /// Puts the file in place. Throws as the constructor.
  void commit();

  /// Removes what has not been put in place, for a program that ends here; from any thread.
  void discard() const noexcept;

 private:
  void open_directly();
  void open_temporary();
  [[noreturn]] void fail() const;

  std::string path_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;  // empty when written to directly; set once
  std::FILE* stream_{};
};

/// Whether opening an output waits or writes at once: it exists and is no regular file.
[[nodiscard]] bool is_no_regular_file(const std::filesystem::path& output);

/// Whether two outputs are one file, which need not exist yet: by links, hard links or other spellings.
[[nodiscard]] bool are_one_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// A new folder, which no other process has, that is removed in the end. It is in TMPDIR or else in /tmp.
class TemporaryFolder {
 public:
  /// Throws std::system_error.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

/// Writes an AtomicFile. Throws OutputError.
void write_text(const std::filesystem::path& file, std::string_view text);

/// The contents of a file, byte for byte; empty if it cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

}  // namespace stickslip::data
