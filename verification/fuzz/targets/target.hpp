// SPDX-License-Identifier: MIT
#pragma once

/// Functions of arbitrary bytes that libFuzzer calls and the test suite repeats. Invalid input must cause an
/// error message of one sentence. Any other exception is a defect.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace stickslip::fuzz {

using Bytes = std::span<const std::uint8_t>;

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

struct Target {
  std::string_view name;  ///< name of the program and of its corpus
  void (*function)(Bytes);
};

inline constexpr std::array targets{Target{"case", read_case_file}, Target{"results", read_results},
                                    Target{"ranges", parse_ranges}, Target{"respond", respond}};

}  // namespace stickslip::fuzz
