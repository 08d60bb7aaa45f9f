// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stickslip::report {

/// A folder in which files appear whole or not at all: everything is made in a scratch folder inside it, on
/// the same file system, and moved when it is complete. One process at a time may hold an output folder.
class OutputFolder {
 public:
  /// Makes the folder and an empty scratch folder in it. Throws data::InputError, naming the folder, if that
  /// is impossible or another process holds it.
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }
  [[nodiscard]] const std::filesystem::path& scratch() const noexcept { return scratch_; }

  /// Writes a file under this name, unless it holds this text already. Throws std::runtime_error if it cannot
  /// be written.
  void write(const std::string& name, std::string_view text);

  /// Removes the scratch folder, and the folder where this made it and nothing is in it, for a program that
  /// ends here; from any thread. What cannot be removed the next one clears away.
  void clear_scratch() const noexcept;

  /// Moves a file of the scratch folder into the folder, under its own name. Throws std::runtime_error.
  void publish(const std::filesystem::path& file);

 private:
  std::filesystem::path folder_;
  std::filesystem::path scratch_;
  bool is_new_{};
  int lock_{-1};
};

}  // namespace stickslip::report
