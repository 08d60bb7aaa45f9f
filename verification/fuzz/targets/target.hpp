// SPDX-License-Identifier: MIT
#pragma once

/// Functions of arbitrary bytes that libFuzzer calls and the test suite repeats. Invalid input must cause an
/// error message of one sentence. Any other exception, in particular a Violation, is a defect.

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/input_error.hpp"

namespace stickslip::fuzz {

/// The input of a target.
using Bytes = std::span<const std::uint8_t>;

/// A required property does not hold.
class Violation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Reads a case file and, after each byte 0x1e, an override of --set. A case must be read again with the same
/// values.
void read_case_file(Bytes bytes);

/// Reads the number of a data set (one byte), a table of results and, after each byte 0x1e, a mapping of
/// --column.
void read_results(Bytes bytes);

/// Reads a range of `map` and `design`. It must give ascending finite numbers, as many as asked for.
void parse_ranges(Bytes bytes);

/// Runs a small case, with one byte for each number, for at most 200 steps by one of the stick-slip methods.
/// It must give finite numbers or an error message.
void respond(Bytes bytes);

/// A function with its name.
struct Target {
  std::string_view name;  ///< name of the program and of its corpus
  void (*function)(Bytes);
};

/// All targets.
inline constexpr std::array targets{Target{"case", read_case_file}, Target{"results", read_results},
                                    Target{"ranges", parse_ranges}, Target{"respond", respond}};

/// The parts of the input between the bytes 0x1e.
[[nodiscard]] std::vector<std::string> split(Bytes bytes);

/// Throws Violation unless the message of the error is one line of text.
void require_sentence(const std::exception& error);

/// Runs what may refuse its input, in one line of text.
template <class Run>
void allow_input_errors(const Run& run) {
  try {
    run();
  } catch (const data::InputError& error) {
    require_sentence(error);
  }
}

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
