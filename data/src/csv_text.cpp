// SPDX-License-Identifier: MIT
#include "stickslip/data/csv_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <system_error>
#include <utility>

#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::data {

namespace {

// The first of tab, semicolon and comma that stands outside quotes.
char separator_of(std::string_view names) {
  for (const char separator : {'\t', ';', ','}) {
    bool quoted = false;
    for (const char c : names) {
      if (c == '"') quoted = !quoted;
      if (c == separator && !quoted) return separator;
    }
  }
  return ',';
}

// The cell that begins here, without blanks and quotes, and where it ends: at a separator or at the end of
// the line. Nothing if a quote is not closed or is followed by anything but a separator.
struct Cell {
  std::string text;
  std::size_t end{};
};

std::optional<Cell> cell_at(std::string_view line, std::size_t at, char separator) {
  const auto end_after = [&](std::size_t place) {
    return std::min(line.find(separator, place), line.size());
  };
  while (at < line.size() && line[at] == ' ') ++at;
  if (at == line.size() || line[at] != '"') {
    const std::size_t end = end_after(at);
    return Cell{std::string(trimmed(line.substr(at, end - at))), end};
  }
  std::string text;
  for (++at; at < line.size() && (line[at] != '"' || line.substr(at, 2) == "\"\""); ++at) {
    text += line[at];
    if (line[at] == '"') ++at;  // two quotes stand for one
  }
  const std::size_t end = end_after(at);
  if (at >= line.size() || !trimmed(line.substr(at + 1, end - at - 1)).empty()) return std::nullopt;
  return Cell{text, end};
}

}  // namespace

CsvReader::CsvReader(std::filesystem::path file, std::string_view text)
    : file_(std::move(file)), rest_(text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
  if (rest_.starts_with("\xFF\xFE") || rest_.starts_with("\xFE\xFF") ||
      rest_.find('\0') != std::string_view::npos)
    throw InputError(file_.string() + ": is no text in UTF-8");
  const auto line = next_line();
  if (!line) throw InputError(place(line_) + ": there is no line with the names of the columns");
  line_of_names_ = line_;
  separator_ = separator_of(*line);
  names_ = cells_of(*line);
}

std::optional<std::vector<std::string>> CsvReader::next_row() {
  const auto line = next_line();
  if (!line) return std::nullopt;
  auto cells = cells_of(*line);
  if (cells.size() != names_.size())
    throw InputError(place(line_) + ": the line has " + std::to_string(cells.size()) +
                     " cells, but must have " + std::to_string(names_.size()) + " as the line of names has");
  return cells;
}

std::string CsvReader::place(std::size_t line) const { return file_.string() + ":" + std::to_string(line); }

std::string CsvReader::place(std::size_t line, std::size_t column) const {
  return place(line) + ", column " + std::to_string(column + 1) + " (" + printable(names_[column]) + ")";
}

// The next line that holds something.
std::optional<std::string_view> CsvReader::next_line() {
  while (!rest_.empty()) {
    const auto end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::string_view content = trimmed(line);
    if (!content.empty() && !content.starts_with('#')) return line;
  }
  return std::nullopt;
}

std::vector<std::string> CsvReader::cells_of(std::string_view line) const {
  std::vector<std::string> cells;
  for (std::size_t at = 0;; ++at) {
    const auto cell = cell_at(line, at, separator_);
    if (!cell)
      throw InputError(place(line_) + ": a quote is not closed, or something follows it: " + printable(line));
    cells.push_back(cell->text);
    at = cell->end;
    if (at == line.size()) return cells;
  }
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value{};
  const auto* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<Twice> repeated_key(const std::vector<KeyColumn>& key, std::size_t rows) {
  std::vector<std::size_t> order(rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto is_before = [&](std::size_t a, std::size_t b) {
    for (const auto& [text, values] : key) {
      if (values != nullptr && (*values)[a] != (*values)[b]) return (*values)[a] < (*values)[b];
      if (values == nullptr && (*text)[a] != (*text)[b]) return (*text)[a] < (*text)[b];
    }
    return false;
  };
  const auto is_same = [&](std::size_t a, std::size_t b) {
    return std::ranges::all_of(key, [&](const KeyColumn& column) {
      return column.values == nullptr ? (*column.text)[a] == (*column.text)[b]
                                      : is_same_key((*column.values)[a], (*column.values)[b]);
    });
  };
  std::ranges::stable_sort(order, is_before);
  const auto twice = std::ranges::adjacent_find(order, is_same);
  if (twice == order.end()) return std::nullopt;
  return Twice{std::min(*twice, *(twice + 1)), std::max(*twice, *(twice + 1))};
}

}  // namespace stickslip::data
