// SPDX-License-Identifier: MIT
#include "matrix_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace {

constexpr int most_rows = std::numeric_limits<int>::max() - 1;

// The words of one line after the other, without empty lines and those that begin with the sign of a comment.
class Lines {
 public:
  Lines(std::string file, std::string_view text, char comment)
      : file_(std::move(file)), rest_(text), comment_(comment) {
    if (text.find('\0') != std::string_view::npos)
      throw InputError(file_ + ": holds bytes of 0, but must be a text");
  }

  bool next() {
    while (!rest_.empty()) {
      const auto end = std::min(rest_.find('\n'), rest_.size());
      split(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_;
      if (!words_.empty() && words_.front().front() != comment_) return true;
    }
    return false;
  }

  [[nodiscard]] const std::vector<std::string_view>& words() const noexcept { return words_; }
  [[nodiscard]] const std::string& file() const noexcept { return file_; }

  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(file_ + ":" + std::to_string(line_) + ": " + sentence);
  }

  void require_words(std::size_t count, std::string_view which) const {
    if (words_.size() != count)
      fail("holds " + std::to_string(words_.size()) + " words, but must hold " + std::to_string(count) +
           ": " + std::string(which));
  }

  [[nodiscard]] int integer(std::string_view what, std::string_view word, int most) const {
    int value{};
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc{} || read.ptr != word.data() + word.size() || value < 1 || value > most)
      fail(std::string(what) + " is " + printable(word) + ", but must be an integer from 1 to " +
           std::to_string(most));
    return value;
  }

  [[nodiscard]] double number(std::string_view word) const {
    const auto value = finite_number(word);
    if (!value) fail("value is " + printable(word) + ", but must be a finite number");
    return *value;
  }

 private:
  void split(std::string_view line) {
    constexpr std::string_view blanks = " \t\r,";
    words_.clear();
    for (auto begin = line.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = line.find_first_not_of(blanks)) {
      line.remove_prefix(begin);
      words_.push_back(line.substr(0, line.find_first_of(blanks)));
      line.remove_prefix(words_.back().size());
    }
  }

  std::string file_;
  std::string_view rest_;
  char comment_;
  std::vector<std::string_view> words_;
  int line_{};
};

std::pair<int, int> position_of(const MatrixEntry& entry) { return {entry.row, entry.column}; }

// By row and column, those of one place added, without zeros.
void merge(std::vector<MatrixEntry>& entries) {
  std::ranges::sort(entries, {}, position_of);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries.size();) {
    MatrixEntry sum = entries[i];
    while (++i < entries.size() && position_of(entries[i]) == position_of(sum)) sum.value += entries[i].value;
    if (sum.value != 0.0) entries[kept++] = sum;
  }
  entries.resize(kept);
}

// Throws InputError unless merged entries are symmetric.
void require_symmetric(const std::string& file, const std::vector<MatrixEntry>& entries) {
  double largest = 0.0;
  for (const MatrixEntry& entry : entries) largest = std::max(largest, std::abs(entry.value));
  const auto text = [](int row, int column, double value) {
    return "entry " + std::to_string(row + 1) + " " + std::to_string(column + 1) + " is " +
           shortest_text(value);
  };
  for (const auto& [row, column, value] : entries) {
    const auto other = std::ranges::lower_bound(entries, std::pair(column, row), {}, position_of);
    const bool is_there = other != entries.end() && position_of(*other) == std::pair(column, row);
    const double mirrored = is_there ? other->value : 0.0;
    if (std::abs(value - mirrored) > 1e-9 * largest)
      throw InputError(file + ": " + text(row, column, value) + " and " + text(column, row, mirrored) +
                       ", but the matrix must be symmetric to 1e-9 of its largest entry");
  }
}

// The matrix of one triangle, or of both.
SymmetricMatrix symmetric(const std::string& file, int rows, std::vector<MatrixEntry> entries,
                          bool is_triangle) {
  const bool is_above = std::ranges::any_of(entries, [](const auto&of) { return of.row < of.column; }),
             is_below = std::ranges::any_of(entries, [](const auto&of) { return of.row > of.column; });
  if (is_triangle && is_above && is_below)
    throw InputError(file +
                     ": has entries above and below the diagonal, but of a symmetric matrix must have those "
                     "of one triangle");
  if (!is_triangle && is_above != is_below)
    throw InputError(
        file + ": has entries " + (is_above ? "above" : "below") +
        " the diagonal alone, but must hold both triangles or be called symmetric in its first line");
  merge(entries);
  if (!is_triangle) {  // the mean with the transpose
    require_symmetric(file, entries);
    for (MatrixEntry& entry : entries) entry.value *= 0.5;
  }
  const std::size_t count = entries.size();
  for (std::size_t i = 0; i < count; ++i)
    if (const MatrixEntry of = entries[i]; !is_triangle || of.row != of.column)
      entries.push_back({of.column, of.row, of.value});
  merge(entries);
  return {rows, std::move(entries)};
}

MatrixEntry entry_on(const Lines& lines, int rows) {
  lines.require_words(3, "row, column, value");
  const auto& words = lines.words();
  return {lines.integer("row", words[0], rows) - 1, lines.integer("column", words[1], rows) - 1,
          lines.number(words[2])};
}

// The words of the first line in small letters, of which the third to fifth are looked at.
struct Banner {
  bool is_array{}, is_symmetric{};

  explicit Banner(const std::string& file, std::string_view line) {
    Lines lines(file, line, '\0');
    if (lines.next()) lines.require_words(5, "%%MatrixMarket matrix coordinate real symmetric");
    const auto is = [&](std::size_t i, const std::vector<std::string>& names) {
      std::string word(lines.words()[i]);
      std::ranges::transform(word, word.begin(),
                             [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
      const auto found = std::ranges::find(names, word);
      if (found == names.end())
        lines.fail("begins with " + printable(word) + " as word " + std::to_string(i + 1) +
                   ", but must have one of " + joined(names));
      return found - names.begin();
    };
    (void)is(1, {"matrix"});
    is_array = is(2, {"coordinate", "array"}) == 1;
    (void)is(3, {"real", "integer", "double"});
    is_symmetric = is(4, {"general", "symmetric"}) == 1;
  }
};

SymmetricMatrix matrix_market_in(const std::string& file, std::string_view text) {
  const Banner banner(file, text.substr(0, text.find('\n')));
  Lines lines(file, text, '%');
  if (!lines.next()) lines.fail("ends, but must go on with the numbers of rows and columns");
  lines.require_words(banner.is_array ? 2 : 3, banner.is_array ? "rows, columns" : "rows, columns, entries");
  const int rows = lines.integer("the number of rows", lines.words()[0], most_rows);
  if (lines.integer("the number of columns", lines.words()[1], most_rows) != rows)
    lines.fail("the matrix has " + std::to_string(rows) + " rows and " + std::string(lines.words()[1]) +
               " columns, but must be square");
  const auto n = static_cast<std::size_t>(rows);
  const std::size_t count =
      !banner.is_array
          ? static_cast<std::size_t>(lines.integer("the number of entries", lines.words()[2], most_rows))
      : banner.is_symmetric ? n * (n + 1) / 2
                            : n * n;
  std::vector<MatrixEntry> entries;
  int row = 0, column = 0;
  while (entries.size() <= count && lines.next()) {
    if (!banner.is_array) {
      entries.push_back(entry_on(lines, rows));
      continue;
    }
    for (const std::string_view word : lines.words()) {
      entries.push_back({row, column, lines.number(word)});
      if (++row < rows) continue;
      ++column;
      row = banner.is_symmetric ? column : 0;
    }
  }
  if (entries.size() != count || n > text.size())
    throw InputError(file + ": has " + (entries.size() > count ? "more" : std::to_string(entries.size())) +
                     " entries, but must have " + std::to_string(count) + " as it says");
  return symmetric(file, rows, std::move(entries), banner.is_symmetric);
}

}  // namespace

SymmetricMatrix matrix_in(const std::string& file, std::string_view text, std::optional<int> rows) {
  constexpr std::string_view banner = "%%MatrixMarket";
  if (text.starts_with(banner)) return matrix_market_in(file, text);
  Lines lines(file, text, '\0');
  std::vector<MatrixEntry> entries;
  while (lines.next()) {
    if (!rows)
      lines.fail("begins with " + printable(lines.words().front()) + ", but must begin with " +
                 std::string(banner) + " where model.dofs is missing");
    entries.push_back(entry_on(lines, *rows));
  }
  return symmetric(file, rows.value_or(0), std::move(entries), true);
}

std::vector<NodeDirection> degrees_of_freedom_in(const std::string& file, std::string_view text) {
  std::vector<NodeDirection> all;
  Lines lines(file, text, '\0');
  while (lines.next()) {
    const std::string_view word = lines.words().front();
    const auto dot = word.find('.');
    if (lines.words().size() != 1 || dot == std::string_view::npos)
      lines.fail("is " + printable(word) + ", but must be a node and its direction, as 37.3");
    all.push_back({lines.integer("node", word.substr(0, dot), most_rows),
                   lines.integer("direction", word.substr(dot + 1), 6)});
  }
  return all;
}

std::vector<int> node_set_in(const std::string& file, std::string_view text) {
  std::vector<int> nodes;
  Lines lines(file, text, '\0');
  bool is_set = true, is_found = false;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words.front().starts_with("**")) continue;
    if (words.front().starts_with('*')) {
      is_set = words.front() == "*NSET";
      if (is_set && is_found) lines.fail("begins a second set of nodes, but there must be one");
      if (is_set && words.back() == "GENERATE") lines.fail("is GENERATE, but the nodes must be listed");
      is_found = is_found || is_set;
    } else if (is_set) {
      for (const std::string_view word : words) nodes.push_back(lines.integer("node", word, most_rows));
    }
  }
  if (nodes.empty()) throw InputError(file + ": holds no node, but must list some under *NSET");
  return nodes;
}

}  // namespace stickslip::data
