// SPDX-License-Identifier: MIT
#pragma once

/// What both kinds of TOML files (cases, the paper's numbers) need: reading with a bound, places and values
/// as text.

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

/// Parses a TOML file of at most 1 MB. Throws InputError, naming the file and, for a syntax error, the line.
[[nodiscard]] toml::table read_toml(const std::filesystem::path& file);

/// The same from the text of the file.
[[nodiscard]] toml::table parse_toml(const std::filesystem::path& file, const std::string& text);

/// "paper.toml:3", the line on which the node's value begins.
[[nodiscard]] std::string place_of(const std::filesystem::path& file, const toml::node& node);

/// The value and its type on one line: "abc" (a string), true (a boolean), an array, 0.5 (a float).
[[nodiscard]] std::string describe(const toml::node& node);

// Arrays of tables in TOML files: each table a record whose keys are all known.

/// One table of an array of tables. Its members throw InputError, naming file, line and key, for what cannot
/// be used.
class Record {
 public:
  Record(std::filesystem::path file, const toml::table& table, std::initializer_list<std::string_view> known)
      : file_(std::move(file)), table_(table) {
    for (const auto& [key, value] : table)
      if (std::ranges::find(known, key.str()) == known.end())
        throw InputError(place_of(file_, value) + ": unknown key " + printable(key.str()) +
                         suggestion(key.str(), {known.begin(), known.end()}));
  }

  [[nodiscard]] std::string text(std::string_view key) const {
    const auto value = table_[key].value_exact<std::string>();
    if (!value || value->empty()) fail_unless(key, "a string that is not empty");
    return *value;
  }

  /// Empty if the key is missing.
  [[nodiscard]] std::string optional_text(std::string_view key) const { return has(key) ? text(key) : ""; }

  [[nodiscard]] double number(std::string_view key) const {
    const auto value = table_[key].value<double>();
    if (!value || !std::isfinite(*value)) fail_unless(key, "a finite number");
    return *value;
  }

  [[nodiscard]] bool flag(std::string_view key) const {
    const auto value = table_[key].value_exact<bool>();
    if (!value) fail_unless(key, "true or false");
    return *value;
  }

  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

  /// Throws "<place>: <key> is <value>, but must be <allowed>".
  [[noreturn]] void fail_unless(std::string_view key, std::string_view allowed) const {
    const toml::node* value = table_.get(key);
    fail(std::string(key) + " is " + (value == nullptr ? "missing" : describe(*value)) + ", but must be " +
         std::string(allowed));
  }

  /// Throws "<place>: <sentence>".
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(place_of(file_, table_) + ": " + sentence);
  }

 private:
  std::filesystem::path file_;
  const toml::table& table_;
};

/// What read makes of each table of the array of tables `name` in a file. Throws InputError, naming the file, if there
/// is no such array.
template <class Read>
auto read_all(const std::filesystem::path& file, std::string_view name,
              std::initializer_list<std::string_view> known, Read read) {
  const toml::table table = read_toml(file);
  const auto* list = table.get_as<toml::array>(name);
  if (list == nullptr || !list->is_array_of_tables())
    throw InputError(file.string() + ": must hold tables [[" + std::string(name) + "]]");
  std::vector<decltype(read(std::declval<const Record&>()))> rows;
  for (const auto& element : *list) rows.push_back(read(Record(file, *element.as_table(), known)));
  return rows;
}

}  // namespace stickslip::data
