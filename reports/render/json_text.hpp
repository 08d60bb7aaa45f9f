// SPDX-License-Identifier: MIT
#pragma once

/// The results of studies as JSON: an object of what is described, with a key for each member.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "studies/common/members.hpp"

namespace stickslip::report {

/// "length" of "length()".
[[nodiscard]] constexpr std::string_view key_of(std::string_view member) {
  return member.substr(0, member.find('('));
}

/// An enumeration whose values have names.
template <typename T>
concept Named = std::is_enum_v<T> && requires(T value) {
  to_string(value);
};

/// With all digits of each number, so that it reads back exactly; infinite is "inf" or "-inf", not a number
/// "nan".
[[nodiscard]] std::string json_text(nlohmann::json value);

}  // namespace stickslip::report

namespace nlohmann {

/// Nothing is null.
template <typename T>
struct adl_serializer<std::optional<T>> {
  static void to_json(json& object, const std::optional<T>& value) {
    if (value)
      object = *value;
    else
      object = nullptr;
  }
};

template <stickslip::studies::Described T>
struct adl_serializer<T> {
  static void to_json(json& object, const T& value) {
    visit_members(std::type_identity<T>{}, [&](std::string_view member, std::string_view, auto get) {
      object[stickslip::report::key_of(member)] = get(value);
    });
  }
};

template <stickslip::report::Named T>
struct adl_serializer<T> {
  static void to_json(json& word, T value) { word = to_string(value); }
};

}  // namespace nlohmann
