// SPDX-License-Identifier: MIT
#include "range_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "command.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::cli {

namespace {

constexpr int most_values = data::limit::map_values.most;  // along one axis

[[noreturn]] void fail_unless(std::string_view allowed, std::string_view option, std::string_view part,
                              std::string_view value) {
  throw data::FieldError(fmt::format("{}: {}", option, part), fmt::format("'{}'", data::printable(value)),
                         allowed);
}

double number_in(std::string_view option, std::string_view part, std::string_view text,
                 std::string_view unit) {
  const auto value = data::quantity_in(text, unit);
  if (!value) fail_unless(data::quantity_allowed(text, unit), option, part, text);
  return *value;
}

analytic::Bounds range_of(std::string_view option, const data::Key& key, std::string_view from,
                          std::string_view to, bool zero, bool equal) {
  const double lower = number_in(option, "FROM", from, key.magnitudes.unit),
               upper = number_in(option, "TO", to, key.magnitudes.unit);
  if (!std::isfinite(lower) || lower < 0.0 || (lower == 0.0 && !zero))
    fail_unless(zero ? "a finite number of 0 or more" : "a finite number above 0", option, "FROM", from);
  if (!std::isfinite(upper) || upper < lower || (upper == lower && !equal))
    fail_unless(
        fmt::format("a finite number {} FROM, {}", equal ? "not below" : "above", data::printable(from)),
        option, "TO", to);
  for (const double end : {lower, upper}) data::require_magnitude(key.path, end, std::string(option));
  return {lower, upper};
}

const data::Key& axis_named(std::string_view option, std::string_view name) {
  std::vector<std::string> names;
  for (const data::Key& key : data::case_keys()) {
    if (key.axis.name.empty()) continue;
    if (key.axis.name == name || key.path == name) return key;
    names.emplace_back(key.axis.name);
  }
  fail_unless(fmt::format("one of {}{}", data::joined(names), data::suggestion(name, names)), option,
              "PARAMETER", name);
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

analytic::Bounds parse_range(std::string_view option, std::string_view key, std::string_view text,
                             bool equal) {
  const auto parts = split(text, ':');
  if (parts.size() != 2) fail_unless("FROM:TO", option, "the range", text);
  return range_of(option, data::key_named(key), parts[0], parts[1], false, equal);
}

std::vector<double> parse_values(std::string_view option, std::string_view key, std::string_view text,
                                 int count) {
  const auto [from, to] = parse_range(option, key, text);
  return studies::map_axis(key, from, to, count, false).values;
}

std::string axis_text(const studies::MapAxis& axis) {
  return fmt::format("{}={}:{}:{}{}", data::key_named(axis.parameter).axis.name,
                     data::shortest_text(axis.values.front()), data::shortest_text(axis.values.back()),
                     axis.values.size(), axis.logarithmic ? ":log" : "");
}

std::string axis_help() {
  std::string help;
  for (const data::Key& key : data::case_keys()) {
    if (key.axis.name.empty()) continue;
    const std::string_view unit = key.magnitudes.unit;
    help += fmt::format("{}{} ({}{}{})", help.empty() ? "" : ", ", key.axis.name, key.path,
                        unit.empty() ? "" : ", ", unit);
  }
  return help;
}

studies::MapAxis parse_axis(std::string_view option, std::string_view text) {
  const auto equals = text.find('=');
  const auto parts = split(equals == std::string_view::npos ? text : text.substr(equals + 1), ':');
  const bool logarithmic = parts.size() == 4 && parts[3] == "log";
  if (equals == std::string_view::npos || (parts.size() != 3 && !logarithmic))
    fail_unless("PARAMETER=FROM:TO:COUNT or PARAMETER=FROM:TO:COUNT:log", option, "the axis", text);
  const data::Key& named = axis_named(option, text.substr(0, equals));
  const data::Key& key = data::key_stated(named.path, parts[0]);
  const bool zero = key.axis.may_be_zero && !logarithmic;
  const analytic::Bounds range = range_of(option, key, parts[0], parts[1], zero, false);
  const auto count = parse<int>(parts[2]);
  if (!count || *count < 2 || *count > most_values)
    fail_unless(fmt::format("an integer from 2 to {}", most_values), option, "COUNT", parts[2]);
  return studies::map_axis(key.path, range.lower, range.upper, *count, logarithmic);
}

std::map<std::string, double> parse_tolerances(const std::vector<std::string>& texts) {
  std::map<std::string, double> tolerances;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    const auto value = parse<double>(equals == std::string::npos ? text : text.substr(equals + 1));
    if (!value || equals == 0)
      throw data::FieldError("--tolerance", fmt::format("'{}'", data::printable(text)),
                             "a number or QUANTITY=NUMBER, as in frequency=1e-3");
    tolerances[equals == std::string::npos ? "" : text.substr(0, equals)] = *value;
  }
  return tolerances;
}

std::vector<std::pair<std::size_t, std::size_t>> parse_rows(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  for (const std::string_view range : split(text, ',')) {
    const auto colon = std::min(range.find(':'), range.size());
    const auto first = parse<std::size_t>(range.substr(0, colon));
    const auto last = colon < range.size() ? parse<std::size_t>(range.substr(colon + 1)) : first;
    if (!first || !last)
      throw data::FieldError("--rows", fmt::format("'{}'", data::printable(text)),
                             "numbers of rows of the data set, as in 1:12 or 1:3,7");
    ranges.emplace_back(*first, *last);
  }
  return ranges;
}

}  // namespace stickslip::cli
