// SPDX-License-Identifier: MIT
#pragma once

/// JSON files whose values know their name, so that an error message says which value is wrong.

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/data/reference.hpp"

namespace stickslip::data {

/// Parses a JSON file of at most 10 MB and 100 levels. Throws InputError, naming the file, for a syntax error
/// (with line and column), for a key that stands twice in an object, and for what is nested more deeply.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& file);

/// A value in a JSON file, which must outlive it. Its members throw InputError, naming the file and the value
/// by the keys that lead to it: "datapackage.json: resources/stick-history/bytes is 0, but must be an integer
/// above 0". An element of an array goes by its member `name` or, without one, by its index.
class JsonNode {
 public:
  /// The value of the whole file.
  JsonNode(std::filesystem::path file, const nlohmann::json& value)
      : file_(std::move(file)), value_(&value) {}

  [[nodiscard]] const nlohmann::json& value() const noexcept { return *value_; }

  /// A member of an object; nothing where it is missing.
  [[nodiscard]] std::optional<JsonNode> find(const std::string& key) const;
  /// A member of an object, which must be there.
  [[nodiscard]] JsonNode at(const std::string& key) const;
  /// The members of an object, by their keys.
  [[nodiscard]] std::vector<std::pair<std::string, JsonNode>> members() const;
  /// The elements of an array.
  [[nodiscard]] std::vector<JsonNode> elements() const;

  /// Throws for a key of an object that is nearly a known one; any other is the writer's own.
  void require_spelling(const std::vector<std::string>& known) const;

  /// A string that is not empty, on one line that a terminal may show.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::vector<std::string> texts() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] long integer() const;
  [[nodiscard]] bool flag() const;

  /// One of several words, as its index.
  [[nodiscard]] std::size_t one_of(const std::vector<std::string>& words) const;

  /// Throws "<file>: <name> is <value>, but must be <allowed>".
  [[noreturn]] void fail_unless(std::string_view allowed) const;
  /// Throws "<file>: <name> <what>".
  [[noreturn]] void fail(std::string_view what) const;

 private:
  [[nodiscard]] JsonNode below(std::string_view step, const nlohmann::json& value) const;
  void require_object() const;

  std::filesystem::path file_;
  std::string name_;  // empty for the whole file
  const nlohmann::json* value_;
};

/// A data set as its object in datapackage.json describes it: the members that must be there, each of its type. What
/// they mean is not checked.
[[nodiscard]] Resource read_description(const JsonNode& node);

}  // namespace stickslip::data
