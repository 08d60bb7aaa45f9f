// SPDX-License-Identifier: MIT
#include "target.hpp"

#include <algorithm>

namespace stickslip::fuzz {

std::vector<std::string> split(Bytes bytes) {
  constexpr std::uint8_t separator = 0x1e;
  std::vector<std::string> parts(1);
  for (const std::uint8_t byte : bytes) {
    if (byte == separator)
      parts.emplace_back();
    else
      parts.back() += static_cast<char>(byte);
  }
  return parts;
}

void require_sentence(const std::exception& error) {
  const std::string_view text(error.what());
  if (text.empty()) throw Violation("an error message is empty");
  if (std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20U; }))
    throw Violation("an error message is not one line of text: " + std::string(text));
}

}  // namespace stickslip::fuzz
