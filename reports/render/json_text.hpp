// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

/// Defines to_json() of a type in whose namespace it stands: one key for each field, and for each member
/// function, which is called: STICKSLIP_JSON(Interval, from, to, length()).
#define STICKSLIP_JSON(Type, ...)                                                \
  inline void to_json(nlohmann::json& object, const Type& value) {               \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(STICKSLIP_JSON_FIELD, __VA_ARGS__)) \
  }
#define STICKSLIP_JSON_FIELD(field) object[stickslip::report::json_key(#field)] = value.field;

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

}  // namespace nlohmann

namespace stickslip::report {

/// "length" of "length()".
[[nodiscard]] constexpr std::string_view json_key(std::string_view expression) {
  return expression.substr(0, expression.find('('));
}

/// With all digits of each number, so that it reads back exactly; infinite is "inf" or "-inf", not a number
/// "nan".
[[nodiscard]] std::string json_text(nlohmann::json value);

}  // namespace stickslip::report
