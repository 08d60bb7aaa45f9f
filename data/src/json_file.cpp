#include "json_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "input_text.hpp"
#include "stickslip/data/case_file.hpp"

namespace stickslip::data {

namespace {

using nlohmann::json;

// Tells how far the parser has read.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}

  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* count_;
};

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t column = offset - (before.rfind('\n') + 1);  // npos + 1 is 0
  return std::to_string(line) + ":" + std::to_string(column + 1);
}

// Pointer tokens as RFC 6901 writes them.
std::string escaped(std::string_view key) {
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

// Builds the value and remembers where each part of it begins.
class Builder final : public nlohmann::json_sax<json> {
 public:
  Builder(std::string file, std::string_view text, const std::size_t& read,
          std::map<std::string, std::size_t>& offsets)
      : file_(std::move(file)), text_(text), read_(read), offsets_(offsets) {}

  [[nodiscard]] json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(value); }
  bool binary(binary_t&) override { return false; }  // JSON has none

  bool start_object(std::size_t) override { return open(json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    key_ = name;
    key_offset_ = read_ - std::min(read_, name.size() + 2);
    if (levels_.back().value->contains(name))
      throw InputError(file_ + ":" + line_and_column(text_, key_offset_) + ": the key " + printable(name) +
                       " stands twice");
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const json::exception&) override {
    const std::size_t offset = std::min(position == 0 ? 0 : position - 1, text_.size());
    throw InputError(file_ + ":" + line_and_column(text_, offset) + ": is not valid JSON here: '" +
                     printable(token) + "' is unexpected");
  }

 private:
  struct Level {
    json* value;
    std::string pointer;
  };

  json* put(json value) {
    if (levels_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    json& parent = *levels_.back().value;
    const bool in_array = parent.is_array();
    pointer_ = levels_.back().pointer + "/" + (in_array ? std::to_string(parent.size()) : escaped(key_));
    offsets_[pointer_] = in_array ? read_ - 1 : key_offset_;
    if (!in_array) return &(parent[key_] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }

  bool add(json value) {
    put(std::move(value));
    return true;
  }

  bool open(json empty) {
    constexpr std::size_t deepest = 100;  // every place keeps the names of all levels above it
    if (levels_.size() == deepest)
      throw InputError(file_ + ":" + line_and_column(text_, read_ - 1) + ": is nested deeper than the " +
                       std::to_string(deepest) + " levels that are allowed");
    pointer_.clear();
    json* const value = put(std::move(empty));
    levels_.push_back({value, pointer_});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string file_;
  std::string_view text_;
  const std::size_t& read_;
  std::map<std::string, std::size_t>& offsets_;
  json root_;
  std::vector<Level> levels_;
  std::string key_, pointer_;
  std::size_t key_offset_{};
};

std::string described(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array";
  return printable(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace

JsonFile::JsonFile(std::filesystem::path file) : file_(std::move(file)) {
  constexpr std::size_t largest = 10'000'000;
  text_ = read_bounded(file_, largest);
  std::size_t read = 0;
  Builder builder(file_.string(), text_, read, offsets_);
  json::sax_parse(CountingIterator(text_.data(), &read), CountingIterator(text_.data() + text_.size(), &read),
                  &builder);
  root_ = builder.take();
}

JsonNode JsonFile::root() const { return {*this, root_, ""}; }

std::string JsonFile::place_of(const std::string& pointer) const {
  const auto found = offsets_.find(pointer);
  return file_.string() + ":" + line_and_column(text_, found == offsets_.end() ? 0 : found->second);
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
  require_object();
  const auto member = value_->find(key);
  if (member == value_->end()) return std::nullopt;
  return JsonNode(*file_, *member, pointer_ + "/" + escaped(key));
}

JsonNode JsonNode::at(const std::string& key) const {
  auto member = find(key);
  if (!member) complain("lacks " + key);
  return *std::move(member);
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  require_object();
  std::vector<std::pair<std::string, JsonNode>> nodes;
  for (const auto& [key, value] : value_->items())
    nodes.emplace_back(key, JsonNode(*file_, value, pointer_ + "/" + escaped(key)));
  return nodes;
}

std::vector<JsonNode> JsonNode::elements() const {
  if (!value_->is_array()) refuse("an array");
  std::vector<JsonNode> nodes;
  for (std::size_t i = 0; i < value_->size(); ++i)
    nodes.emplace_back(*file_, (*value_)[i], pointer_ + "/" + std::to_string(i));
  return nodes;
}

void JsonNode::require_spelling(const std::vector<std::string>& known) const {
  for (const auto& [key, node] : members())
    if (std::ranges::find(known, key) == known.end())
      if (const std::string nearest = suggestion(key, known); !nearest.empty())
        node.complain("is unknown" + nearest);
}

std::string JsonNode::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty())
    refuse("a string that is not empty");
  return value_->get<std::string>();
}

std::vector<std::string> JsonNode::texts() const {
  std::vector<std::string> list;
  for (const JsonNode& element : elements()) list.push_back(element.text());
  return list;
}

double JsonNode::number() const {
  if (!value_->is_number()) refuse("a number");
  return value_->get<double>();
}

long JsonNode::integer() const {
  if (!value_->is_number_integer()) refuse("an integer");
  return value_->get<long>();
}

bool JsonNode::flag() const {
  if (!value_->is_boolean()) refuse("true or false");
  return value_->get<bool>();
}

std::size_t JsonNode::one_of(const std::vector<std::string>& words) const {
  const auto found =
      value_->is_string() ? std::ranges::find(words, value_->get_ref<const std::string&>()) : words.end();
  if (found == words.end()) refuse("one of " + joined(words));
  return static_cast<std::size_t>(found - words.begin());
}

void JsonNode::require_object() const {
  if (!value_->is_object()) refuse("an object");
}

void JsonNode::refuse(std::string_view allowed) const {
  complain("is " + described(*value_) + ", but must be " + std::string(allowed));
}

void JsonNode::complain(std::string_view what) const {
  const std::string name = pointer_.empty() ? "the package" : pointer_.substr(1);
  throw InputError(file_->place_of(pointer_) + ": " + name + " " + std::string(what));
}

}  // namespace stickslip::data
