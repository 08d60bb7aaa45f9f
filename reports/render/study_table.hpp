// SPDX-License-Identifier: MIT
#pragma once

/// The results of studies as JSON, an object of what is described with a key for each member, and as tables of figures: the
/// members chosen, with the units of the list of members.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "render/csv_table.hpp"
#include "studies/common/members.hpp"

namespace stickslip::report {

/// The entry of an object for a member, made if there is none; the member "length()" has the key "length".
[[nodiscard]] nlohmann::json& entry_of(nlohmann::json& object, std::string_view member);

/// A result as JSON. Nothing is null.
template <typename T>
nlohmann::json json_of(const T& value) {
  if constexpr (studies::Described<T>) {
    nlohmann::json object;
    visit_members(std::type_identity<T>{}, [&](std::string_view member, std::string_view, auto get) {
      entry_of(object, member) = json_of(get(value));
    });
    return object;
  } else if constexpr (std::is_enum_v<T>) {
    return to_string(value);
  } else if constexpr (requires { value.has_value(); }) {
    return value ? json_of(*value) : nullptr;
  } else if constexpr (requires { value.begin(); } && !std::is_convertible_v<T, std::string_view>) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& element : value) list.push_back(json_of(element));
    return list;
  } else {
    return value;
  }
}

/// With all digits of each number, so that it reads back exactly; infinite is "inf" or "-inf", not a number
/// "nan".
[[nodiscard]] std::string json_text(nlohmann::json value);

/// The unit of each member, in the shape of the JSON of one result. What is described without a unit has `unit`.
template <typename T>
nlohmann::json units_of(std::string_view unit = "") {
  if constexpr (requires { typename T::value_type; } && !std::is_same_v<T, std::string>) {
    return units_of<typename T::value_type>(unit);
  } else if constexpr (studies::Described<T>) {
    nlohmann::json units;
    visit_members(std::type_identity<T>{}, [&](std::string_view member, std::string_view own, auto get) {
      using Member = std::remove_cvref_t<decltype(get(std::declval<const T&>()))>;
      entry_of(units, member) = units_of<Member>(own.empty() ? unit : own);
    });
    return units;
  } else {
    return unit;
  }
}

enum class TableShape { lines, grid };  ///< of a grid, an empty line follows the rows of each result

/// A table of members: "elements, runs.time_step as step, runs.error in %". Each has its way from a result, "0.time" that
/// from the first of several; "#" is the number of the result, from 1. The name of the column is that of the member, or
/// the one given, with the unit.
///
/// A row for each result or, where the ways lead through lists, for each of their elements: of lists of results from the
/// outer to the inner ones, then of numbers; lists of one level are walked together. Throws std::invalid_argument if those
/// differ in length, nlohmann::json::out_of_range for a member that does not exist.
[[nodiscard]] CsvTable study_table(const std::string& title, const nlohmann::json& results,
                                   const nlohmann::json& units, std::string_view columns, TableShape shape);

template <typename Results>
CsvTable study_table(const std::string& title, const Results& results, std::string_view columns,
                     TableShape shape = TableShape::lines) {
  return study_table(title, json_of(results), units_of<Results>(), columns, shape);
}

}  // namespace stickslip::report
