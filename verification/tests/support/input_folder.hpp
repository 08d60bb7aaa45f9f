// SPDX-License-Identifier: MIT
#pragma once

/// Folders of the tests, and the sentence that refuses an input file.

#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {

/// A folder for the files that a test reads.
class InputFolder : public data::TemporaryFolder {
 public:
  InputFolder() {}  // clang takes no constant with a defaulted one

  /// Writes a file of this name, or replaces it, and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path() / name, std::ios::binary) << text;
    return path() / name;
  }

  /// The sentence with which an action refuses its input, without this folder in the names of files; "accepted" if it
  /// does not. It must be on one line.
  [[nodiscard]] std::string error_message(const std::function<void()>& action) const {
    std::string sentence = error_message_if_any<data::InputError>(action).value_or("accepted");
    const std::string prefix = path().string() + "/";
    for (auto at = sentence.find(prefix); at != std::string::npos; at = sentence.find(prefix))
      sentence.erase(at, prefix.size());
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    return sentence;
  }
};

}  // namespace stickslip::testing
