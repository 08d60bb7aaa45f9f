#pragma once

/// JSON files whose values know their place, so that a refusal names line and column.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::data {

class JsonNode;

/// A JSON file of at most 10 MB and 100 levels.
class JsonFile {
 public:
  /// Throws InputError, naming file, line and column, for a syntax error, for a key that stands twice and
  /// for what is nested too deeply.
  explicit JsonFile(std::filesystem::path file);

  [[nodiscard]] JsonNode root() const;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return file_; }

  /// "datapackage.json:12:7" of the value with this JSON pointer: where its key begins, or the value itself
  /// in an array.
  [[nodiscard]] std::string place_of(const std::string& pointer) const;

 private:
  std::filesystem::path file_;
  std::string text_;
  nlohmann::json root_;
  std::map<std::string, std::size_t> offsets_;  // by JSON pointer
};

/// A value in a JsonFile, which must outlive it. Its members throw InputError with place and name.
class JsonNode {
 public:
  JsonNode(const JsonFile& file, const nlohmann::json& value, std::string pointer)
      : file_(&file), value_(&value), pointer_(std::move(pointer)) {}

  [[nodiscard]] const nlohmann::json& value() const noexcept { return *value_; }

  /// A member of an object; nothing where it is missing.
  [[nodiscard]] std::optional<JsonNode> find(const std::string& key) const;
  /// The same, refused where it is missing.
  [[nodiscard]] JsonNode at(const std::string& key) const;
  /// The members of an object, by their keys.
  [[nodiscard]] std::vector<std::pair<std::string, JsonNode>> members() const;
  /// The elements of an array.
  [[nodiscard]] std::vector<JsonNode> elements() const;

  /// Refuses a key of an object that is nearly a known one; any other is the writer's own.
  void require_spelling(const std::vector<std::string>& known) const;

  /// A string that is not empty.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::vector<std::string> texts() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] long integer() const;
  [[nodiscard]] bool flag() const;

  /// One of several words, as its index.
  [[nodiscard]] std::size_t one_of(const std::vector<std::string>& words) const;

  /// Throws InputError: "<place>: <name> is <value>, but must be <allowed>".
  [[noreturn]] void refuse(std::string_view allowed) const;
  /// Throws InputError: "<place>: <name> <what>".
  [[noreturn]] void complain(std::string_view what) const;

 private:
  void require_object() const;

  const JsonFile* file_;
  const nlohmann::json* value_;
  std::string pointer_;
};

}  // namespace stickslip::data
