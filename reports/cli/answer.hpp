// SPDX-License-Identifier: MIT
#pragma once

/// What a subcommand answers, for a reader and for a program at once.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/analytic/criterion.hpp"
#include "studies/analyses/sampling.hpp"

namespace stickslip::cli {

using Json = nlohmann::ordered_json;

/// Significant digits that the text of a value has at most, 17 for all that read back as the same double.
void set_most_digits(int digits);

/// The number of significant digits that a relative error leaves, 1 ... 15.
[[nodiscard]] int digits_that_hold(double relative_error);

/// The value with that many significant digits, trailing zeros included: (25, 4) is "25.00".
[[nodiscard]] std::string significant(double value, int digits);

/// The largest number of significant digits on which both bounds agree once rounded; "lower ... upper" if
/// they share none.
[[nodiscard]] std::string common_digits(const analytic::Bounds& bounds);

struct Value {
  Json json;
  std::string text;
};

/// A number, in the text with the digits that set_most_digits() allows, or with fewer.
[[nodiscard]] Value exact(double value);
[[nodiscard]] Value rounded(double value, int digits);

/// {"lower": ..., "upper": ...}, null for an upper one that is infinite, and common_digits().
[[nodiscard]] Value between(const analytic::Bounds& bounds);
/// The number in the middle, null where the bounds share no digit, and common_digits().
[[nodiscard]] Value middle(const analytic::Bounds& bounds);

/// {"value": ..., "lower": ..., "upper": ...}, null for an end that too few samples leave open, and that text or "value (lower ... upper)".
[[nodiscard]] Value estimated(const studies::Estimate& estimate, std::string text);
[[nodiscard]] Value estimated(const studies::Estimate& estimate, int decimals);

/// A word, or a number of things.
[[nodiscard]] Value word(std::string_view text);
[[nodiscard]] Value count(std::size_t number);

/// A value with its label, which gives the unit as in "length / m", and its key, as in "length_m". Without a label the text leaves
/// it out, without a key JSON does.
struct LabelledValue {
  std::string label, key;
  Value value;
};

/// Rows of one kind: lines of columns, and an array of objects in JSON. A column without a header is left out of the text, one
/// without a key out of JSON.
struct Table {
  struct Column {
    std::string header, key;
    std::size_t width{};  ///< in the text; 0: that of the longest cell and two blanks
  };
  std::vector<Column> columns;
  std::vector<std::vector<Value>> rows;  ///< of one value for each column

  /// With the line of headers unless it is left out; no line ends in blanks.
  [[nodiscard]] std::string text(bool with_headers = true) const;
  [[nodiscard]] Json json() const;
  /// With the keys as names of the columns.
  [[nodiscard]] std::string csv() const;
};

/// The answer of a subcommand, built up in the order in which text and JSON show it.
struct Answer {
  explicit Answer(std::size_t width_of_labels = 28) : label_width(width_of_labels) {}

  std::size_t label_width;
  std::string text;
  Json json = Json::object();
  std::optional<std::vector<std::string>> warnings;  ///< on standard error, and last in JSON
  int status{};                                      ///< with which the program ends

  /// A line of the text alone, and members of the JSON object alone.
  void add_line(std::string_view line = "");
  void add_members(const Json& members);

  /// A value in both, and a line of the text alone with some values side by side.
  void add_row(const LabelledValue& row);
  void add_row(std::string_view label, const std::vector<std::string>& values);

  /// A table in both.
  void add_table(const std::string& key, const Table& table);
};

/// The number, or null where there is none or it is not finite.
[[nodiscard]] Json optional_json(const std::optional<double>& value);
[[nodiscard]] Json finite_json(double value);

/// Throws data::InputError, naming the key, if a number of the answer is not finite: see
/// data::throw_overflow().
void require_finite(const Json& answer, const std::string& name = "the answer");

/// The text of a JSON file; bytes that are no UTF-8 become U+FFFD, and what JSON may hold and a terminal not becomes ?.
[[nodiscard]] std::string json_text(const Json& object);

}  // namespace stickslip::cli
