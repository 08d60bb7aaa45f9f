// SPDX-License-Identifier: MIT
#include "json_file.hpp"

#include <algorithm>
#include <set>

#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace {

using nlohmann::json;

std::string described(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array";
  return printable(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace

json read_json(const std::filesystem::path& file) {
  constexpr int deepest = limit::package_levels.most;
  const std::string text = read_bounded(file, limit::package_bytes.most);
  const auto fail = [&](const std::string& what) { throw InputError(file.string() + ": " + what); };
  std::vector<std::set<std::string>> keys;  // of each object that is not closed yet
  const auto check = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth > deepest)
      fail("is nested deeper than the " + std::to_string(deepest) + " levels that are allowed");
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      fail("the key " + printable(parsed.get<std::string>()) + " stands twice in an object");
    return true;
  };
  // "[json.exception.parse_error.101] parse error at line 3, ..."
  const auto what_of = [](const json::exception& error) {
    constexpr std::size_t longest = 200;
    const std::string_view message = error.what();
    return printable(message.substr(message.find(']') + 2), longest);
  };
  try {
    return json::parse(text, check);
  } catch (const json::parse_error& error) {
    fail("is not valid JSON: " + what_of(error));
  } catch (const json::out_of_range& error) {
    fail("holds a number that no double holds: " + what_of(error));
  }
  return {};
}

JsonNode JsonNode::below(std::string_view step, const json& value) const {
  JsonNode node(file_, value);
  node.name_ = (name_.empty() ? "" : name_ + "/") + printable(step);
  return node;
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
  require_object();
  const auto member = value_->find(key);
  if (member == value_->end()) return std::nullopt;
  return below(key, *member);
}

JsonNode JsonNode::at(const std::string& key) const {
  auto member = find(key);
  if (!member) fail("lacks " + key);
  return *std::move(member);
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  require_object();
  std::vector<std::pair<std::string, JsonNode>> nodes;
  for (const auto& [key, value] : value_->items()) nodes.emplace_back(key, below(key, value));
  return nodes;
}

std::vector<JsonNode> JsonNode::elements() const {
  if (!value_->is_array()) fail_unless("an array");
  std::vector<JsonNode> nodes;
  for (const json& value : *value_) {
    const auto* name =
        value.is_object() && value.contains("name") ? value["name"].get_ptr<const std::string*>() : nullptr;
    nodes.push_back(below(name != nullptr ? *name : std::to_string(nodes.size()), value));
  }
  return nodes;
}

void JsonNode::require_spelling(const std::vector<std::string>& known) const {
  for (const auto& [key, node] : members())
    if (std::ranges::find(known, key) == known.end())
      if (const std::string nearest = suggestion(key, known); !nearest.empty())
        node.fail("is unknown" + nearest);
}

std::string JsonNode::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty())
    fail_unless("a string that is not empty");
  const auto& text = value_->get_ref<const std::string&>();
  return printable(text, text.size());
}

std::vector<std::string> JsonNode::texts() const {
  std::vector<std::string> list;
  for (const JsonNode& element : elements()) list.push_back(element.text());
  return list;
}

double JsonNode::number() const {
  if (!value_->is_number()) fail_unless("a number");
  return value_->get<double>();
}

long JsonNode::integer() const {
  if (!value_->is_number_integer()) fail_unless("an integer");
  return value_->get<long>();
}

bool JsonNode::flag() const {
  if (!value_->is_boolean()) fail_unless("true or false");
  return value_->get<bool>();
}

std::size_t JsonNode::one_of(const std::vector<std::string>& words) const {
  const auto found =
      value_->is_string() ? std::ranges::find(words, value_->get_ref<const std::string&>()) : words.end();
  if (found == words.end()) fail_unless("one of " + joined(words));
  return static_cast<std::size_t>(found - words.begin());
}

void JsonNode::require_object() const {
  if (!value_->is_object()) fail_unless("an object");
}

void JsonNode::fail_unless(std::string_view allowed) const {
  fail("is " + described(*value_) + ", but must be " + std::string(allowed));
}

void JsonNode::fail(std::string_view what) const {
  throw InputError(file_.string() + ": " + (name_.empty() ? "the package" : name_) + " " + std::string(what));
}

}  // namespace stickslip::data
