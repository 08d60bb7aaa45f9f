// SPDX-License-Identifier: MIT
#include "answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "studies/common/convergence.hpp"

namespace stickslip::cli {

namespace {

constexpr std::size_t value_width = 20;  // of values side by side
constexpr int all_digits = 17;
int most_digits = 6;

std::string without_blanks_at_the_end(const std::string& line) {
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

// With blanks to the width of its column, one at least.
std::string padded(std::string_view text, std::size_t width) {
  return fmt::format("{:<{}}", text, std::max(width, text.size() + 1));
}

}  // namespace

void set_most_digits(int digits) { most_digits = digits; }

int digits_that_hold(double relative_error) {
  const double resolved = std::max(relative_error, std::numeric_limits<double>::epsilon());
  return std::max(1, static_cast<int>(std::floor(-std::log10(resolved))));
}

std::string significant(double value, int digits) {
  digits = std::min(digits, most_digits);
  std::string text = fmt::format("{:#.{}g}", value, digits);
  if (const auto bare = text.find(".e"); bare != std::string::npos)
    text.erase(bare, 1);  // 3.e+01 becomes 3e+01
  // fmt ends 25 to two digits with ".0", which would be a third one.
  const auto shown = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
  if (text.ends_with(".0") && shown > digits) text.erase(text.size() - 2);
  return text;
}

std::string common_digits(const analytic::Bounds& bounds) {
  if (bounds.lower == bounds.upper) return exact(bounds.lower).text;
  constexpr int enough = 3;
  if (const int digits = studies::common_digits(bounds); digits >= enough)
    return significant(bounds.lower, digits);
  if (std::isinf(bounds.upper)) return significant(bounds.lower, 2) + " or more";
  return fmt::format("{} ... {}", significant(bounds.lower, enough + 1),
                     significant(bounds.upper, enough + 1));
}

Value exact(double value) {
  return {value,
          most_digits < all_digits ? fmt::format("{:.{}g}", value, most_digits) : data::shortest_text(value)};
}

Value rounded(double value, int digits) {
  return {value, fmt::format("{:.{}g}", value, std::min(digits, most_digits))};
}

Value between(const analytic::Bounds& bounds) {
  return {{{"lower", bounds.lower}, {"upper", finite_json(bounds.upper)}}, common_digits(bounds)};
}

Value middle(const analytic::Bounds& bounds) {
  const bool is_known = bounds.lower == bounds.upper || studies::common_digits(bounds) > 0;
  return {is_known ? finite_json(bounds.midpoint()) : Json(), common_digits(bounds)};
}

Value estimated(const studies::Estimate& estimate, std::string text) {
  return {{{"value", finite_json(estimate.value)},
           {"lower", finite_json(estimate.lower)},
           {"upper", finite_json(estimate.upper)}},
          std::move(text)};
}

Value estimated(const studies::Estimate& estimate, int decimals) {
  const auto& [value, lower, upper] = estimate;
  return estimated(estimate,
                   fmt::format("{0:.{3}f} ({1:.{3}f} ... {2:.{3}f})", value, lower, upper, decimals));
}

Value word(std::string_view text) { return {text, std::string(text)}; }

Value count(std::size_t number) { return {number, std::to_string(number)}; }

std::string Table::text(bool with_headers) const {
  std::vector<std::vector<std::string>> lines(rows.size() + 1);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].header.empty()) continue;
    lines[0].push_back(columns[i].header);
    for (std::size_t n = 0; n < rows.size(); ++n) lines[n + 1].push_back(rows[n].at(i).text);
  }
  if (!with_headers) lines.erase(lines.begin());
  std::vector<std::size_t> widths;
  for (const Column& column : columns)
    if (!column.header.empty()) widths.push_back(column.width);
  for (std::size_t i = 0; i < widths.size(); ++i)
    if (widths[i] == 0)
      for (const auto& line : lines) widths[i] = std::max(widths[i], line[i].size() + 2);
  std::string text;
  for (const auto& line : lines) {
    std::string cells;
    for (std::size_t i = 0; i < line.size(); ++i) cells += padded(line[i], widths[i]);
    text += without_blanks_at_the_end(cells) + "\n";
  }
  return text;
}

Json Table::json() const {
  Json array = Json::array();
  for (const auto& row : rows) {
    Json object = Json::object();
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!columns[i].key.empty()) object[columns[i].key] = row.at(i).json;
    array.push_back(object);
  }
  return array;
}

std::string Table::csv() const {
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i)
    text += (i > 0 ? "," : "") + data::csv_cell(columns[i].key);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i > 0 ? "," : "\n") + (row[i].json.is_string() ? data::csv_cell(row[i].json.get<std::string>())
                                      : row[i].json.is_null() ? ""
                                                              : row[i].json.dump());
  return text + "\n";
}

void Answer::add_line(std::string_view line) { text.append(line) += '\n'; }

void Answer::add_members(const Json& members) { json.update(members); }

void Answer::add_row(const LabelledValue& row) {
  if (!row.label.empty()) add_row(row.label, {row.value.text});
  if (!row.key.empty()) json[row.key] = row.value.json;
}

void Answer::add_row(std::string_view label, const std::vector<std::string>& values) {
  std::string line = padded(label, label_width);
  for (const std::string& value : values) line += padded(value, value_width);
  add_line(without_blanks_at_the_end(line));
}

void Answer::add_table(const std::string& key, const Table& table) {
  text += table.text();
  json[key] = table.json();
}

Json optional_json(const std::optional<double>& value) { return value ? finite_json(*value) : Json(); }

Json finite_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }

void require_finite(const Json& answer, const std::string& name) {
  if (answer.is_structured()) {
    for (const auto& [key, value] : answer.items()) require_finite(value, answer.is_object() ? key : name);
  } else if (answer.is_number_float() && !std::isfinite(answer.get<double>())) {
    data::throw_overflow(fmt::format("{} comes out as {}, but must be finite", name,
                                     data::shortest_text(answer.get<double>())));
  }
}

std::string json_text(const Json& object) {
  return data::plain_text(object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace stickslip::cli
