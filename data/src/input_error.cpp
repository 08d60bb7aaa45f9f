// SPDX-License-Identifier: MIT
#include "stickslip/data/input_error.hpp"

#include <array>
#include <charconv>

namespace stickslip::data {

FieldError::FieldError(std::string_view field, std::string_view value, std::string_view allowed)
    : InputError(std::string(field) + " is " + std::string(value) + ", but must be " + std::string(allowed)),
      field_(field) {}

std::string shortest_text(double value) {
  std::array<char, 32> buffer{};  // the longest shortest text of a double has 24 characters
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

}  // namespace stickslip::data
