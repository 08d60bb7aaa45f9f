#include "toml_file.hpp"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <sstream>
#include <system_error>

#include "stickslip/data/case_file.hpp"

namespace stickslip::data {

namespace {

constexpr std::size_t maximum_bytes = 1'000'000;

// Reads one byte more than is allowed at most, so that an endless file is refused like a large one.
std::string read_bounded(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": is a folder, not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": cannot be opened for reading");
  std::string text(maximum_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InputError(file.string() + ": cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.empty()) throw InputError(file.string() + ": is empty");
  if (text.size() > maximum_bytes)
    throw InputError(file.string() + ": is larger than the " + std::to_string(maximum_bytes) +
                     " bytes that are allowed");
  return text;
}

std::size_t edit_distance(std::string_view left, std::string_view right) {
  std::vector<std::size_t> row(right.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= left.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t replaced = diagonal + (left[i - 1] == right[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string with_article(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a float";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

}  // namespace

toml::table read_toml(const std::filesystem::path& file) {
  const std::string text = read_bounded(file);
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(file.string() + ":" + std::to_string(error.source().begin.line) +
                     ": is not valid TOML: " + std::string(error.description()));
  }
}

std::string place_of(const std::filesystem::path& file, const toml::node& node) {
  return file.string() + ":" + std::to_string(node.source().begin.line);
}

std::string describe(const toml::node& node) {
  if (node.is_table() || node.is_array()) return with_article(node);
  if (const auto* number = node.as_floating_point()) return shortest_text(number->get()) + " (a float)";
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << toml::node_view<const toml::node>(node);
  return printable(text.str()) + " (" + with_article(node) + ")";
}

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 60;
  const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  std::size_t length = std::min(text.size(), longest);
  while (length > 0 && length < text.size() && is_continuation(text[length])) --length;
  std::string line(text.substr(0, length));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; },
      '?');
  return length < text.size() ? line + "..." : line;
}

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t longest =
      100;  // no name is nearly as long, and the distance costs a product of lengths
  if (names.empty() || word.size() > longest) return "";
  const auto distance = [&](const std::string& name) { return edit_distance(word, name); };
  const auto nearest = std::ranges::min_element(names, {}, distance);
  const bool is_near = 3 * distance(*nearest) <= std::max(word.size(), nearest->size());
  return is_near ? " (did you mean " + *nearest + "?)" : "";
}

}  // namespace stickslip::data
