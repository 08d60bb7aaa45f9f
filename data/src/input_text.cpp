#include "input_text.hpp"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <system_error>

#include "stickslip/data/case_file.hpp"

namespace stickslip::data {

namespace {

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

}  // namespace

// Reads one byte more than is allowed at most, so that an endless file is refused like a large one.
std::string read_bounded(const std::filesystem::path& file, std::size_t most) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": is a folder, not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": cannot be opened for reading");
  constexpr std::size_t chunk = 1 << 20;
  std::string text;
  while (stream && text.size() <= most) {
    const std::size_t before = text.size();
    text.resize(std::min(before + chunk, most + 1));
    stream.read(text.data() + before, static_cast<std::streamsize>(text.size() - before));
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError(file.string() + ": cannot be read");
  if (text.empty()) throw InputError(file.string() + ": is empty");
  if (text.size() > most)
    throw InputError(file.string() + ": is larger than the " + std::to_string(most) +
                     " bytes that are allowed");
  return text;
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
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
