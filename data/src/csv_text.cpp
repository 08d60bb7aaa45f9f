// SPDX-License-Identifier: MIT
#include "stickslip/data/csv_text.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <new>
#include <system_error>
#include <tuple>
#include <utility>

#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

constexpr char blank = ' ';

// The first of tab, semicolon and comma that stands outside quotes, else a blank if the line has one.
char separator_of(std::string_view line) {
  for (const char separator : {'\t', ';', ',', blank}) {
    bool quoted = false;
    for (const char c : trimmed(line)) {
      if (c == '"') quoted = !quoted;
      if (c == separator && !quoted) return separator;
    }
  }
  return ',';
}

// Where the cell ends that holds this place. Tabs count as blanks.
std::size_t end_of_cell(std::string_view line, std::size_t place, char separator) {
  return std::min(separator == blank ? line.find_first_of(" \t", place) : line.find(separator, place),
                  line.size());
}

// The cell that begins here, without blanks and quotes, and where it ends: at a separator or at the end of
// the line. Nothing if a quote is not closed or is followed by anything but a separator.
struct Cell {
  std::string text;
  std::size_t end{};
};

std::optional<Cell> cell_at(std::string_view line, std::size_t at, char separator) {
  while (at < line.size() && (line[at] == ' ' || (separator != '\t' && line[at] == '\t'))) ++at;
  if (at == line.size() || line[at] != '"') {
    const std::size_t end = end_of_cell(line, at, separator);
    return Cell{std::string(trimmed(line.substr(at, end - at))), end};
  }
  std::string text;
  for (++at; at < line.size() && (line[at] != '"' || line.substr(at, 2) == "\"\""); ++at) {
    text += line[at];
    if (line[at] == '"') ++at;  // two quotes stand for one
  }
  const std::size_t end = end_of_cell(line, std::min(at + 1, line.size()), separator);
  if (at >= line.size() || !trimmed(line.substr(at + 1, end - at - 1)).empty()) return std::nullopt;
  return Cell{text, end};
}

bool is_comment(std::string_view line) {
  return trimmed(line).starts_with('#') || trimmed(line).starts_with('%');
}

// What stands behind the signs of a comment.
std::string_view comment_text(std::string_view line) {
  const auto begin = line.find_first_not_of(" \t#%");
  return begin == std::string_view::npos ? std::string_view{} : line.substr(begin);
}

// Blanks separate names, but not a name from its unit in brackets: "frequency [kHz]" is one.
std::vector<std::string> with_units_joined(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const std::string& word : words) {
    const bool is_open = !names.empty() && names.back().find_first_of("[(") != std::string::npos &&
                         names.back().find_first_of("])") == std::string::npos;
    if (!names.empty() && (is_open || word.starts_with('[') || word.starts_with('(')))
      names.back() += " " + word;
    else
      names.push_back(word);
  }
  return names;
}

// A unit without its brackets.
std::string_view bare_unit(std::string_view cell) {
  const bool is_bracketed =
      (cell.starts_with('[') && cell.ends_with(']')) || (cell.starts_with('(') && cell.ends_with(')'));
  return is_bracketed ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

// Why the text cannot be a table; empty if it can.
std::string other_format(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> beginnings{
      {{"\x89HDF", "is a file in HDF5 format (as MATLAB's -v7.3)"},
       {"PK\x03\x04", "is a zip archive (as .xlsx, .ods, .npz)"},
       {"MATLAB 5.0", "is a MATLAB file"},
       {"\x93NUMPY", "is a NumPy file"},
       {"PAR1", "is a Parquet file"},
       {"{", "is a JSON file"},
       {"[{", "is a JSON file"},
       {"<", "is an XML or HTML file"},
       {"---", "is a YAML file"},
       {"*", "is an input or output file of a finite-element program"}}};
  for (const auto& [beginning, format] : beginnings)
    if (trimmed(text.substr(0, 64)).starts_with(beginning))
      return std::string(format) + ", but must be a table in text, as CSV";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return "is text in UTF-16, but must be in UTF-8";
  return text.find('\0') != std::string_view::npos ? "is no text in UTF-8" : "";
}

// Whether a byte beyond ASCII is part of no character in UTF-8, so that `printable` replaces it.
bool has_foreign_letter(std::string_view text) {
  const auto letters = [](std::string_view of) {
    return std::ranges::count_if(of, [](char c) { return static_cast<unsigned char>(c) > 0x7FU; });
  };
  return letters(printable(text, text.size())) < letters(text);
}

// What is compressed here, of all members of the file.
std::string decompressed(const std::string& file, std::string text) {
  constexpr int gzip_window = 16 + MAX_WBITS;
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, inflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  std::string plain;
  int state = Z_OK;
  while (state == Z_OK && plain.size() <= limit::table_bytes.most) {
    constexpr std::size_t chunk = 1 << 16;
    const std::size_t before = plain.size();
    plain.resize(before + chunk);
    stream.next_out = reinterpret_cast<Bytef*>(plain.data() + before);
    stream.avail_out = chunk;
    state = inflate(&stream, Z_NO_FLUSH);
    plain.resize(before + chunk - stream.avail_out);
    for (; state == Z_STREAM_END && stream.avail_in > 0 && *stream.next_in == 0; --stream.avail_in)
      ++stream.next_in;  // zeros that fill up a block
    if (state == Z_STREAM_END && stream.avail_in > 0) state = inflateReset(&stream);
  }
  if (plain.size() > limit::table_bytes.most)
    throw InputError(file + ": holds more than the " + std::to_string(limit::table_bytes.most) +
                     " bytes that are allowed");
  if (state != Z_STREAM_END) throw InputError(file + ": is no complete file in gzip's format");
  return plain;
}

}  // namespace

std::string read_table_text(const std::filesystem::path& file) {
  std::string text = read_bounded(file == "-" ? "/dev/stdin" : file, limit::table_bytes.most);
  return text.starts_with("\x1F\x8B") ? decompressed(file.string(), std::move(text)) : text;
}

CsvReader::CsvReader(std::filesystem::path file, std::string_view text, Cells names, std::size_t lines_before)
    : file_(file == "-" ? "standard input" : std::move(file)),
      rest_(text),
      line_(lines_before),
      names_(std::move(names)) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
  if (const auto sentence = other_format(rest_); !sentence.empty())
    throw InputError(file_.string() + ": " + sentence);
  // Excel's first line; the names show the separator as well.
  if (rest_.starts_with("sep=") || rest_.starts_with("\"sep=")) static_cast<void>(take_line());
  std::vector<Line> comments;
  const auto first = next_line(&comments);
  if (!first && lines_before > 0) return;
  if (!first) throw InputError(place(line_) + ": there is no line with the names of the columns");
  if (!names_.empty()) {
    are_given_ = true;
    separator_ = separator_of(first->text);
    line_of_names_ = first->number;
    held_ = first;
    return;
  }
  find_names(*first, comments);
  for (const std::string& name : names_)
    if (has_foreign_letter(name))
      throw InputError(place(line_of_names_) +
                       ": the name of a column is no text in UTF-8 (Latin-1?), but must be");
  if (separator_ != blank || !held_) return;
  if (const auto row = cells_of(*held_, separator_); row.size() == names_.size() + 1)
    names_.insert(names_.begin(), "");
}

// The names are in the first line or, if half of its cells are numbers, in a comment before it.
void CsvReader::find_names(const Line& first, const std::vector<Line>& comments) {
  separator_ = separator_of(first.text);
  const Cells cells = cells_of(first, separator_);
  line_of_names_ = first.number;
  const auto names_in = [this](const Line& line, char separator) {
    const Cells names = cells_of(line, separator);
    return separator == blank ? with_units_joined(names) : names;
  };
  if (2 * numbers_in(cells) >= std::ssize(cells)) {
    std::vector<std::pair<std::size_t, Cells>> candidates;
    for (const Line& comment : comments) {
      const Line line{comment_text(comment.text), comment.number};
      if (line.text.empty()) continue;
      Cells names = names_in(line, separator_of(line.text));
      if (names.size() == cells.size()) candidates.emplace_back(line.number, std::move(names));
    }
    if (!candidates.empty()) {
      held_ = first;
      // The last one, or the last but one if the last one holds its units.
      const bool are_two = candidates.size() > 1;
      std::tie(line_of_names_, names_) = candidates[candidates.size() - (are_two ? 2 : 1)];
      if (are_two && !take_units(candidates.back().second))
        std::tie(line_of_names_, names_) = candidates.back();
      return;
    }
  }
  names_ = names_in(first, separator_);
  held_ = next_line();
  if (!held_) return;
  const Cells second = cells_of(*held_, separator_);
  if (take_units(second)) held_ = next_line();
}

// Joins a line of units to the names. A row of the table is none: it holds a number other than 1.
bool CsvReader::take_units(const Cells& units) {
  bool has_unit = false;
  for (const std::string& cell : units) {
    const std::string_view unit = bare_unit(cell);
    if (unit != "1" && number(unit)) return false;
    has_unit = has_unit || (unit != "1" && unit_named(unit).has_value());
  }
  if (!has_unit || units.size() != names_.size()) return false;
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (const std::string_view unit = bare_unit(units[i]); !unit.empty() && unit != "-" && unit != "1")
      names_[i].append(" [").append(unit).append("]");
  return true;
}

std::optional<std::vector<std::string>> CsvReader::next_row() {
  const auto line = held_ ? std::exchange(held_, std::nullopt) : next_line();
  line_of_row_ = line ? line->number : line_;
  if (!line) return std::nullopt;
  auto cells = cells_of(*line, separator_);
  if (cells.size() != names_.size())
    throw InputError(place(line_of_row_) + ": the line has " + std::to_string(cells.size()) +
                     " cells, but must have " + std::to_string(names_.size()) +
                     (are_given_ ? ", one for each name" : " as the line of names has"));
  return cells;
}

std::string CsvReader::place(std::size_t line) const { return file_.string() + ":" + std::to_string(line); }

std::string CsvReader::place(std::size_t line, std::size_t column) const {
  return place(line) + ", column " + std::to_string(column + 1) + " (" + printable(names_[column]) + ")";
}

// A line ends with a line feed, with a carriage return, or with both.
std::string_view CsvReader::take_line() {
  const auto end = rest_.find_first_of("\r\n");
  const std::string_view line = rest_.substr(0, end);
  const bool is_pair = end != std::string_view::npos && rest_.substr(end, 2) == "\r\n";
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + (is_pair ? 2 : 1));
  ++line_;
  return line;
}

// The next line that holds something. The comments before it can be collected.
std::optional<CsvReader::Line> CsvReader::next_line(std::vector<Line>* comments) {
  while (!rest_.empty()) {
    const std::string_view line = take_line();
    if (trimmed(line).empty()) continue;
    if (!is_comment(line)) return Line{line, line_};
    if (comments != nullptr) comments->push_back({line, line_});
  }
  return std::nullopt;
}

CsvReader::Cells CsvReader::cells_of(const Line& line, char separator) const {
  const std::string_view text = separator == blank ? trimmed(line.text) : line.text;
  Cells cells;
  for (std::size_t at = 0;; ++at) {
    const auto cell = cell_at(text, at, separator);
    if (!cell) throw InputError(place(line.number) + ": a quote is not closed, or something follows it");
    cells.push_back(cell->text);
    if (cells.size() > limit::table_columns.most)
      throw InputError(place(line.number) + ": the line has more than the " +
                       std::to_string(limit::table_columns.most) + " columns that are allowed");
    at = cell->end;
    if (at == text.size()) return cells;
  }
}

std::optional<double> CsvReader::number(std::string_view cell) const {
  std::string text(cell);
  for (char& c : text) {
    if (c == 'd' || c == 'D') c = 'e';
    if (c == ',' && separator_ != ',' && text.find('.') == std::string::npos) c = '.';
  }
  return finite_number(text);
}

std::ptrdiff_t CsvReader::numbers_in(const Cells& cells) const {
  return std::ranges::count_if(cells, [this](const std::string& cell) { return number(cell).has_value(); });
}

Header header_of(std::string_view text) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const auto begin = text.rfind(open);
    if (begin != std::string_view::npos && text.ends_with(close))
      return {std::string(trimmed(text.substr(0, begin))),
              std::string(trimmed(text.substr(begin + 1, text.size() - begin - 2)))};
  }
  if (const auto slash = text.find(" / "); slash != std::string_view::npos)
    return {std::string(trimmed(text.substr(0, slash))), std::string(trimmed(text.substr(slash + 3)))};
  return {std::string(text), std::nullopt};
}

// As names are compared: in lower case, with an underscore for a blank or a hyphen.
std::string folded(std::string_view name) {
  std::string text(trimmed(name));
  for (char& c : text)
    c = c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

namespace {

// The unit in a header such as name_unit, if the name is this one.
std::optional<std::string> unit_behind(const std::string& name, const std::string& header) {
  if (header.size() <= name.size() + 1 || (header[name.size()] != '_' && header[name.size()] != '/'))
    return std::nullopt;
  if (folded(header.substr(0, name.size())) != folded(name)) return std::nullopt;
  const std::string unit = header.substr(name.size() + 1);
  return unit_named(unit) ? std::optional(unit) : std::nullopt;
}

}  // namespace

std::optional<Header> header_named(std::string_view text, std::string_view name) {
  if (folded(text) == folded(name)) return Header{std::string(text), std::nullopt};
  if (Header header = header_of(text); folded(header.name) == folded(name)) return header;
  if (const auto unit = unit_behind(std::string(name), std::string(text)))
    return Header{std::string(name), *unit};
  return std::nullopt;
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value{};
  const auto* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace stickslip::data
