// SPDX-License-Identifier: MIT
#include "case_entry.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

struct Quantity {
  double value{};
  Unit unit;
};

// "1.5 mm" or "1.5mm": a number and a unit that is known.
std::optional<Quantity> quantity_of(std::string_view text) {
  text = trimmed(text);
  Quantity quantity;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), quantity.value);
  if (error != std::errc{}) return std::nullopt;
  const auto unit = unit_named(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
  if (!unit) return std::nullopt;
  quantity.unit = *unit;
  return quantity;
}

std::string allowed_number(std::string_view unit) {
  if (unit.empty()) return "a number";
  return "a number (" + std::string(unit) +
         ") or a text of a number and a unit: " + units_convertible_to(unit);
}

}  // namespace

Entry entry_of(const toml::node& node, std::string place) {
  Entry entry{{}, describe(node), std::move(place)};
  if (const auto* integer = node.as_integer()) entry.value = integer->get();
  if (const auto* floating = node.as_floating_point()) entry.value = floating->get();
  if (const auto* text = node.as_string()) entry.value = text->get();
  return entry;
}

Entry entry_of(const std::string& text, const std::string& place) {
  if (text.find_first_of("\r\n") != std::string::npos)
    throw InputError(place + ": the value has several lines, but must be one TOML value on one line");
  try {
    const toml::table parsed = toml::parse("value = " + text);
    return entry_of(*parsed.get("value"), place);
  } catch (const toml::parse_error&) {
    return {text, printable(text), place};  // a shell takes the quotes of "1.5 mm" away
  }
}

std::string name_of(std::string_view path, const Entry& entry, const std::vector<std::string>& names) {
  const auto* text = std::get_if<std::string>(&entry.value);
  if (text == nullptr || std::ranges::find(names, *text) == names.end())
    throw FieldError(path, entry.description + (text == nullptr ? "" : suggestion(*text, names)),
                     "one of " + joined(names));
  return *text;
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
    const auto quantity = text == nullptr ? std::nullopt : quantity_of(*text);
    if (!quantity || quantity->unit.si != magnitudes.unit)
      throw FieldError(path, entry.description, allowed_number(magnitudes.unit));
    number = quantity->unit.to_si(quantity->value);
  }
  require_magnitude(path, magnitudes, number);
  return number;
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
