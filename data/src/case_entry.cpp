// SPDX-License-Identifier: MIT
#include "case_entry.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

Entry entry_of(const toml::node& node, std::string place) {
  Entry entry{{}, describe(node), std::move(place)};
  if (const auto* flag = node.as_boolean()) entry.value = flag->get();
  if (const auto* integer = node.as_integer()) entry.value = integer->get();
  if (const auto* floating = node.as_floating_point()) entry.value = floating->get();
  if (const auto* text = node.as_string()) entry.value = text->get();
  if (const auto* array = node.as_array()) entry.value = *array;
  if (const auto* table = node.as_table()) entry.value = *table;
  return entry;
}

Entry entry_of(const std::string& text, const std::string& place) {
  if (text.find_first_of("\r\n") != std::string::npos)
    throw InputError(place + ": the value has several lines, but must be one TOML value on one line");
  try {
    const toml::table parsed = toml::parse("value = " + text);
    return entry_of(*parsed.get("value"), place);
  } catch (const toml::parse_error&) {
    std::int64_t integer{};
    const auto* const end = text.data() + text.size();
    if (const auto read = std::from_chars(text.data(), end, integer);
        read.ec == std::errc{} && read.ptr == end)
      return {integer, text, place};                                             // 010
    if (const auto number = finite_number(text)) return {*number, text, place};  // .5
    return {text, printable(text), place};  // a shell takes the quotes of "1.5 mm" away
  }
}

std::string name_of(std::string_view path, const Entry& entry, const std::vector<std::string>& names) {
  const auto* text = std::get_if<std::string>(&entry.value);
  std::string name = text == nullptr ? "" : *text;
  std::ranges::transform(name, name.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (std::ranges::find(names, name) == names.end())
    throw FieldError(path, entry.description + suggestion(name, names), "one of " + joined(names));
  return name;
}

void require_magnitude(std::string_view path, const Magnitudes& magnitudes, double value) {
  const auto& [smallest, largest, unit] = magnitudes;
  const double magnitude = std::abs(value);
  if (value == 0.0 || !std::isfinite(value) || (smallest <= magnitude && magnitude <= largest)) return;
  throw FieldError(path, value,
                   "from " + shortest_text(smallest) + " to " + shortest_text(largest) +
                       (unit.empty() ? "" : " (" + std::string(unit) + ")") + " in magnitude");
}

double number_of(std::string_view path, const Magnitudes& magnitudes, const Entry& entry) {
  double number{};
  if (const auto* floating = std::get_if<double>(&entry.value)) {
    number = *floating;
  } else if (const auto* integer = std::get_if<std::int64_t>(&entry.value)) {
    number = static_cast<double>(*integer);
  } else {
    const auto* text = std::get_if<std::string>(&entry.value);
    const auto quantity = text == nullptr ? std::nullopt : quantity_in(*text, magnitudes.unit, false);
    if (!quantity)
      throw FieldError(path, entry.description,
                       quantity_allowed(text == nullptr ? "" : *text, magnitudes.unit) +
                           (path == amplitude_keys.front() ? ", or one of velocity or acceleration" : ""));
    number = *quantity;
  }
  require_magnitude(path, magnitudes, number);
  return number;
}

std::vector<double> numbers_of(std::string_view path, const Magnitudes& magnitudes, const Entry& entry) {
  const auto* list = std::get_if<toml::array>(&entry.value);
  if (list == nullptr || list->empty())
    throw FieldError(path, list == nullptr ? entry.description : "empty", "a list of numbers");
  std::vector<double> numbers;
  for (const toml::node& node : *list)
    numbers.push_back(number_of(path, magnitudes, entry_of(node, entry.place)));
  return numbers;
}

int flag_of(std::string_view path, const Entry& entry) {
  const auto* flag = std::get_if<bool>(&entry.value);
  if (flag == nullptr) throw FieldError(path, entry.description, "true or false");
  return *flag ? 1 : 0;
}

int integer_of(std::string_view path, const Entry& entry) {
  const auto* integer = std::get_if<std::int64_t>(&entry.value);
  if (integer == nullptr) throw FieldError(path, entry.description, "an integer");
  if (!std::in_range<int>(*integer))
    throw FieldError(
        path, std::to_string(*integer),
        "an integer of at most " + std::to_string(std::numeric_limits<int>::max()) + " in magnitude");
  return static_cast<int>(*integer);
}

}  // namespace stickslip::data
