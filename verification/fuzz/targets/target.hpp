#pragma once

/// What libFuzzer feeds and the test suite replays: functions of any bytes. Bytes that are no usable input
/// must be refused in one sentence; anything else that is thrown, and a Violation most of all, is a finding.

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A property that does not hold.
class Violation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A case file and, behind each byte 0x1e, an override of --set: a case that reads again as it was read.
void read_case_file(Bytes bytes);

/// The number of a data set (one byte), a table of results and, behind each byte 0x1e, a mapping of --column.
void read_results(Bytes bytes);

/// What `map` and `design` take as a range: ascending finite numbers, as many as were asked for.
void parse_ranges(Bytes bytes);

/// A small case, a byte for each number, followed through some hundred steps by one of the stick-slip
/// methods: finite numbers, or a sentence that says what is wrong.
void respond(Bytes bytes);

struct Target {
  std::string_view name;  ///< of the program and of the folder of the corpus
  void (*function)(Bytes);
};

inline constexpr std::array targets{Target{"case", read_case_file}, Target{"results", read_results},
                                    Target{"ranges", parse_ranges}, Target{"respond", respond}};

/// The bytes between the bytes 0x1e.
[[nodiscard]] std::vector<std::string> split(Bytes bytes);

/// Throws Violation unless a refusal is one line of text.
void require_sentence(const std::exception& refusal);

}  // namespace stickslip::fuzz
