// SPDX-License-Identifier: MIT
#include "stickslip/data/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <regex>
#include <utility>

#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace {

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

// Powers of ten divide, so that 25 ms become the double nearest to 0.025.
constexpr std::array units{NamedUnit{"Hz", {"Hz"}},
                           NamedUnit{"mHz", {"Hz", 1, 1e3}},
                           NamedUnit{"kHz", {"Hz", 1e3}},
                           NamedUnit{"MHz", {"Hz", 1e6}},
                           NamedUnit{"1/s", {"Hz"}},  // in the heading of a column
                           NamedUnit{"1/s", {"1/s"}},
                           NamedUnit{"rad/s", {"Hz", 1, 2.0 * std::numbers::pi}},
                           NamedUnit{"s", {"s"}},
                           NamedUnit{"ms", {"s", 1, 1e3}},
                           NamedUnit{"us", {"s", 1, 1e6}},
                           NamedUnit{"ns", {"s", 1, 1e9}},
                           NamedUnit{"m", {"m"}},
                           NamedUnit{"cm", {"m", 1, 1e2}},
                           NamedUnit{"mm", {"m", 1, 1e3}},
                           NamedUnit{"um", {"m", 1, 1e6}},
                           NamedUnit{"nm", {"m", 1, 1e9}},
                           NamedUnit{"m^2", {"m^2"}},
                           NamedUnit{"cm^2", {"m^2", 1, 1e4}},
                           NamedUnit{"mm^2", {"m^2", 1, 1e6}},
                           NamedUnit{"m^4", {"m^4"}},
                           NamedUnit{"cm^4", {"m^4", 1, 1e8}},
                           NamedUnit{"mm^4", {"m^4", 1, 1e12}},
                           NamedUnit{"kg/m^3", {"kg/m^3"}},
                           NamedUnit{"g/cm^3", {"kg/m^3", 1e3}},
                           NamedUnit{"N s/m", {"N s/m"}},
                           NamedUnit{"N s/mm", {"N s/m", 1e3}},
                           NamedUnit{"N", {"N"}},
                           NamedUnit{"mN", {"N", 1, 1e3}},
                           NamedUnit{"kN", {"N", 1e3}},
                           NamedUnit{"MN", {"N", 1e6}},
                           NamedUnit{"N/m", {"N/m"}},
                           NamedUnit{"kN/m", {"N/m", 1e3}},
                           NamedUnit{"MN/m", {"N/m", 1e6}},
                           NamedUnit{"N/mm", {"N/m", 1e3}},
                           NamedUnit{"m/s", {"m/s"}},
                           NamedUnit{"cm/s", {"m/s", 1, 1e2}},
                           NamedUnit{"mm/s", {"m/s", 1, 1e3}},
                           NamedUnit{"s/m", {"s/m"}},
                           NamedUnit{"m/s^2", {"m/s^2"}},
                           NamedUnit{"g", {"m/s^2", 980665, 1e5}},
                           NamedUnit{"mm/s^2", {"m/s^2", 1, 1e3}},
                           NamedUnit{"kg", {"kg"}},
                           NamedUnit{"g", {"kg", 1, 1e3}},  // a column in g is an acceleration
                           NamedUnit{"t", {"kg", 1e3}},
                           NamedUnit{"Pa", {"Pa"}},
                           NamedUnit{"kPa", {"Pa", 1e3}},
                           NamedUnit{"MPa", {"Pa", 1e6}},
                           NamedUnit{"GPa", {"Pa", 1e9}},
                           NamedUnit{"N/m^2", {"Pa"}},
                           NamedUnit{"N/mm^2", {"Pa", 1e6}},
                           NamedUnit{"kN/mm^2", {"Pa", 1e9}},
                           NamedUnit{"rad", {"rad"}},
                           NamedUnit{"deg", {"rad", std::numbers::pi, 180.0}},
                           NamedUnit{"Hz/s", {"Hz/s"}},
                           NamedUnit{"Hz/min", {"Hz/s", 1, 60.0}},
                           NamedUnit{"oct/s", {"oct/s"}},
                           NamedUnit{"oct/min", {"oct/s", 1, 60.0}},
                           NamedUnit{"J", {"J"}},
                           NamedUnit{"mJ", {"J", 1, 1e3}},
                           NamedUnit{"1", {""}},
                           NamedUnit{"-", {""}},
                           NamedUnit{"%", {"", 1, 1e2}}};

// As the table spells it: "m_per_s" is m/s, m3 is m^3, and both Greek letters for micro are u.
std::string spelled(std::string_view name) {
  std::string text(name);
  for (const auto& [from, to] : {std::pair<std::string_view, std::string_view>{"_per_", "/"},
                                 {"\u00b5", "u"},
                                 {"\u03bc", "u"},
                                 {"\u00b2", "^2"},
                                 {"\u00b3", "^3"},
                                 {"\u2074", "^4"},
                                 {"\u00b0", "deg"}})
    if (const auto at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
  if (text.size() > 1 && text.back() >= '2' && text.back() <= '4' &&
      (text.end()[-2] == 'm' || text.end()[-2] == 's'))
    text.insert(text.size() - 1, "^");
  return text;
}

}  // namespace

std::optional<Unit> unit_named(std::string_view name) {
  const auto found = std::ranges::find(units, spelled(name), &NamedUnit::name);
  if (found == units.end()) return std::nullopt;
  return found->unit;
}

std::optional<double> quantity_in(std::string_view text, std::string_view si, bool may_lack_unit) {
  text = trimmed(text);
  if (text.size() > limit::number_length.most) return std::nullopt;
  double value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  const std::string name = spelled(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
  if (name.empty()) return may_lack_unit ? std::optional(value) : std::nullopt;
  const auto* const found = std::ranges::find_if(
      units, [&](const NamedUnit& one) { return one.name == name && one.unit.si == si; });
  if (found == units.end()) return std::nullopt;
  return found->unit.to_si(value);
}

std::string quantity_allowed(std::string_view text, std::string_view si) {
  if (trimmed(text).size() > limit::number_length.most)
    return "of at most " + std::to_string(limit::number_length.most) + " characters";
  if (const auto number = with_decimal_point(trimmed(text)); !number.empty())
    return "written with a decimal point: " + number;
  if (si.empty()) return "a number";
  return "a number (" + std::string(si) + ") or a text of a number and a unit: " + units_convertible_to(si);
}

std::string with_decimal_point(std::string_view text) {
  static const std::regex form(R"(([+-]?\d+),(\d+(?:[eE][+-]?\d+)?)(?![\d,]))");
  text = text.substr(0, limit::number_length.most);  // std::regex recurs for each digit
  std::match_results<std::string_view::const_iterator> match;
  const bool is_one =
      std::regex_search(text.begin(), text.end(), match, form, std::regex_constants::match_continuous);
  return is_one ? match.str(1) + "." + match.str(2) : "";
}

std::string units_convertible_to(std::string_view si) {
  std::string list;
  for (const auto& [name, unit] : units)
    if (unit.si == si) list.append(list.empty() ? "" : ", ").append(name);
  return list.empty() ? std::string(si) : list;
}

}  // namespace stickslip::data
