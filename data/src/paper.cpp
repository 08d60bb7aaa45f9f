// SPDX-License-Identifier: MIT
#include "stickslip/data/paper.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <stdexcept>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/toml_file.hpp"

namespace stickslip::data {

namespace {

std::filesystem::path numbers_file() { return data_directory() / "paper" / "printed-numbers.toml"; }

// A printed decimal: its value, and half a unit of its last digit.
struct Decimal {
  double value{}, half_digit{};
};

double to_number(const Record& record, std::string_view digits) {
  double value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size())
    record.fail("a part of printed is '" + std::string(digits) + "', but must be a number");
  return value;
}

// "25.0", or a fraction "(1/12)", which is exact.
Decimal parse_mantissa(const Record& record, std::string_view text) {
  if (text.starts_with('(') && text.ends_with(')')) {
    const auto slash = text.find('/');
    if (slash == std::string_view::npos)
      record.fail_unless("printed", "a number, or a fraction in brackets, as in (1/12)");
    return {to_number(record, text.substr(1, slash - 1)) /
                to_number(record, text.substr(slash + 1, text.size() - slash - 2)),
            0.0};
  }
  const auto point = text.find('.');
  const auto decimals = point == std::string_view::npos ? 0 : text.size() - point - 1;
  return {to_number(record, text), 0.5 * std::pow(10.0, -static_cast<double>(decimals))};
}

// "25.0", "3.03 x 10^4", "(1/12) x 10^-6" or "10^-4".
Decimal parse_printed(const Record& record, std::string_view text) {
  constexpr std::string_view times = " x ", ten = "10^";
  const auto power = text.find(ten);
  if (power == std::string_view::npos) return parse_mantissa(record, text);
  const double scale = std::pow(10.0, to_number(record, text.substr(power + ten.size())));
  if (power == 0) return {scale, 0.5 * scale};
  if (!text.substr(0, power).ends_with(times)) record.fail_unless("printed", "a number as in 3.03 x 10^4");
  const Decimal mantissa = parse_mantissa(record, text.substr(0, power - times.size()));
  return {mantissa.value * scale, mantissa.half_digit * scale};
}

PrintedNumber read_printed_number(const Record& record) {
  const double scale = record.has("scale") ? record.number("scale") : 1.0;
  PrintedNumber row{.id = record.text("id"),
                    .value = record.number("value"),
                    .unit = record.text("unit"),
                    .printed = record.text("printed"),
                    .printed_unit = record.text(record.has("printed_unit") ? "printed_unit" : "unit"),
                    .is_given = record.flag("given"),
                    .place = record.text("place"),
                    .meaning = record.text("meaning"),
                    .erratum = record.optional_text("erratum")};
  const Decimal decimal = parse_printed(record, row.printed);
  row.half_digit = decimal.half_digit * scale;
  // Three roundings at most separate the two: the power of ten, its product with the mantissa, and the scale.
  if (std::abs(row.value - decimal.value * scale) >
      4.0 * std::numeric_limits<double>::epsilon() * std::abs(row.value))
    record.fail(row.id + " has the value " + shortest_text(row.value) + ", but its printed digits give " +
                shortest_text(decimal.value * scale));
  return row;
}

PrintedVerdict read_verdict(const Record& record) {
  return {.frequency_hz = record.number("frequency_hz"),
          .amplitude = record.number("amplitude"),
          .verdict = record.text("verdict"),
          .figure = record.text("figure")};
}

}  // namespace

std::vector<PrintedNumber> printed_numbers() {
  auto rows = read_all(
      numbers_file(), "number",
      {"id", "value", "unit", "printed", "printed_unit", "scale", "given", "place", "meaning", "erratum"},
      read_printed_number);
  std::set<std::string> ids;
  for (const PrintedNumber& row : rows)
    if (!ids.insert(row.id).second)
      throw InputError(numbers_file().string() + ": the id " + row.id + " stands twice");
  return rows;
}

std::vector<PrintedVerdict> printed_verdicts() {
  return read_all(numbers_file(), "verdict", {"frequency_hz", "amplitude", "verdict", "figure"},
                  read_verdict);
}

PrintedNumber printed_number(const std::string& id) {
  const auto rows = printed_numbers();
  const auto found = std::ranges::find(rows, id, &PrintedNumber::id);
  if (found == rows.end()) throw std::out_of_range("no printed number has the id " + id);
  return *found;
}

}  // namespace stickslip::data
