// SPDX-License-Identifier: MIT
#include "stickslip/data/toml_file.hpp"

#include <locale>
#include <sstream>

#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

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

// What is wrong, on one line: toml++ quotes a line break as it is.
std::string description_of(const toml::parse_error& error, std::string_view line) {
  for (auto equals = line.find('='); equals != std::string_view::npos; equals = line.find('=')) {
    line.remove_prefix(equals + 1);
    if (const auto number = with_decimal_point(trimmed(line)); !number.empty())
      return "a number has a decimal comma, but must be written with a decimal point: " + number;
  }
  std::string text(error.description());
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }, '?');
  return text;
}

}  // namespace

toml::table read_toml(const std::filesystem::path& file) {
  return parse_toml(file, read_bounded(file, limit::case_bytes.most));
}

toml::table parse_toml(const std::filesystem::path& file, const std::string& text) {
  // Tables in tables are destroyed one inside the other, on the stack.
  if (const auto dots = std::ranges::count(text, '.'); static_cast<std::size_t>(dots) > limit::case_dots.most)
    throw InputError(file.string() + ": holds " + std::to_string(dots) + " dots, but must hold at most " +
                     std::to_string(limit::case_dots.most));
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    const auto number = error.source().begin.line;
    std::istringstream lines(text);
    std::string line;
    for (auto i = number; i > 0; --i) std::getline(lines, line);
    throw InputError(file.string() + ":" + std::to_string(number) +
                     ": is not valid TOML: " + description_of(error, line));
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

}  // namespace stickslip::data
