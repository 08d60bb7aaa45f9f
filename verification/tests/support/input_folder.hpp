// SPDX-License-Identifier: MIT
#pragma once

/// What the tests of the readers share: a folder for the input files, and the sentence that refuses one of them.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "stickslip/data/input_error.hpp"
#include "support/error_message.hpp"

namespace stickslip::testing {

/// An empty folder that is removed at the end.
class InputFolder {
 public:
  InputFolder() { std::filesystem::create_directory(path_); }
  ~InputFolder() { std::filesystem::remove_all(path_); }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// Writes a file of this name, or replaces it, and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

  /// The sentence with which an action refuses its input, without this folder in the names of files; "accepted" if it
  /// does not. It must be on one line.
  [[nodiscard]] std::string error_message(const std::function<void()>& action) const {
    std::string sentence = error_message_if_any<data::InputError>(action).value_or("accepted");
    const std::string prefix = path_.string() + "/";
    for (auto at = sentence.find(prefix); at != std::string::npos; at = sentence.find(prefix))
      sentence.erase(at, prefix.size());
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    return sentence;
  }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("stickslip-input-" + std::to_string(::getpid()));
};

}  // namespace stickslip::testing
