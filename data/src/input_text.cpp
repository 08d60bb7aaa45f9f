// SPDX-License-Identifier: MIT
#include "stickslip/data/input_text.hpp"

#include <openssl/evp.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::data {

namespace {

// Letters to insert, drop or replace, and neighbours to exchange, to turn one word into the other (optimal
// string alignment).
std::size_t edit_distance(std::string_view left, std::string_view right) {
  std::vector<std::size_t> row(right.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  std::vector<std::size_t> above(row.size());
  std::vector<std::size_t> above_that(row.size());
  for (std::size_t i = 1; i <= left.size(); ++i) {
    above_that.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (left[i - 1] == right[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1])
        row[j] = std::min(row[j], above_that[j - 2] + 1);
    }
  }
  return row.back();
}

// Bytes of the character in UTF-8 at the front of the text; 0 if there is none. Surrogates and overlong forms
// are none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
  if (first < 0xC2U || first > 0xF4U || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  const bool is_overlong = (first == 0xE0U && byte(1) < 0xA0U) || (first == 0xF0U && byte(1) < 0x90U);
  const bool is_outside = (first == 0xEDU && byte(1) > 0x9FU) || (first == 0xF4U && byte(1) > 0x8FU);
  return is_overlong || is_outside ? 0 : length;
}

// Those of ASCII, U+0080 ... U+009F, and U+FFFE and U+FFFF, which XML 1.0 forbids as well.
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  return first < 0x20U || first == 0x7FU ||
         (first == 0xC2U && static_cast<unsigned char>(character[1]) < 0xA0U) || character == "\uFFFE" ||
         character == "\uFFFF";
}

// The regular file that has this name; nothing for anything else.
using FileIdentity = std::pair<dev_t, ino_t>;
std::optional<FileIdentity> identity_of(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino};
}

std::optional<std::set<FileIdentity>> inputs;  // while they are protected

std::string hexadecimal(const std::array<unsigned char, 32>& digest) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += digits[byte >> 4U];
    text += digits[byte & 0xFU];
  }
  return text;
}

// Reads no more than one part beyond what is allowed, so that an endless file ends with the same error as a large one.
void read_parts(const std::filesystem::path& file, std::size_t most,
                const std::function<void(std::string_view)>& take) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": is a folder, not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": cannot be opened for reading");
  const bool is_regular = std::filesystem::is_regular_file(file, error);
  std::size_t size = is_regular ? std::filesystem::file_size(file, error) : 0;
  const auto require_size = [&] {
    if (size > most)
      throw InputError(file.string() + ": is larger than the " + std::to_string(most) +
                       " bytes that are allowed");
  };
  require_size();
  std::string part(1 << 16U, '\0');
  for (size = 0; stream; require_size()) {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    size += static_cast<std::size_t>(stream.gcount());
    take(std::string_view(part).substr(0, static_cast<std::size_t>(stream.gcount())));
  }
  if (stream.bad()) throw InputError(file.string() + ": cannot be read");
  if (size == 0) throw InputError(file.string() + ": is empty");
  if (const auto identity = identity_of(file); identity && inputs) inputs->insert(*identity);
}

}  // namespace

std::string read_bounded(const std::filesystem::path& file, std::size_t most) {
  std::string text;
  read_parts(file, most, [&text](std::string_view part) { text += part; });
  return text;
}

std::string read_lines(const std::filesystem::path& file, std::size_t most,
                       const std::function<void(std::string_view)>& take) {
  constexpr std::size_t enough = 1 << 20U;
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> digest(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  const auto require = [](int done) {
    if (done != 1) throw std::runtime_error("libcrypto cannot compute a SHA-256 digest");
  };
  require(EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr));
  std::string text;
  read_parts(file, most, [&](std::string_view part) {
    require(EVP_DigestUpdate(digest.get(), part.data(), part.size()));
    text += part;
    if (text.size() < enough) return;
    const std::size_t feed = text.rfind('\n'), end = feed == std::string::npos ? text.rfind('\r') : feed;
    if (end == std::string::npos) throw InputError(file.string() + ": has a line of more than a megabyte");
    take(std::string_view(text).substr(0, end + 1));
    text.erase(0, end + 1);
  });
  if (!text.empty()) take(text);
  std::array<unsigned char, 32> bytes{};
  require(EVP_DigestFinal_ex(digest.get(), bytes.data(), nullptr));
  return hexadecimal(bytes);
}

void require_no_input(const std::filesystem::path& output) {
  if (const auto identity = identity_of(output); identity && inputs && inputs->contains(*identity))
    throw InputError("output " + output.string() +
                     " is a file that the command reads, but must be another one");
}

void protect_inputs(bool from_here_on) {
  if (from_here_on)
    inputs = std::set<FileIdentity>{};
  else
    inputs.reset();
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text.substr(at));
    const std::string_view character = length > 0 ? text.substr(at, length) : "?";
    if (line.size() + character.size() > longest) return line + "...";
    line += is_control(character) ? "?" : character;
    at += std::max<std::size_t>(length, 1);
  }
  return line;
}

std::string plain_text(std::string_view text) {
  std::string parts;
  for (auto end = text.find_first_of("\n\t"); end != std::string_view::npos;
       end = text.find_first_of("\n\t")) {
    parts += printable(text.substr(0, end), text.size()) + text[end];
    text.remove_prefix(end + 1);
  }
  return parts + printable(text, text.size());
}

std::string csv_cell(std::string_view text) {
  std::string cell(text);
  const bool is_computed =
      cell.size() > 1 && std::string_view("=+-@").find(cell[0]) != std::string_view::npos;
  if (is_computed && !finite_number(cell)) cell.insert(0, "'");
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  for (auto at = cell.find('"'); at != std::string::npos; at = cell.find('"', at + 2))
    cell.insert(at, 1, '"');
  return '"' + cell + '"';
}

// A backquote would run a command, and two quotes in a row end a string of gnuplot 5.4 in single quotes.
std::string gnuplot_string(std::string_view text) {
  std::string escaped;
  for (const char c : printable(text, 200)) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c == '`' ? "\\140" : std::string(1, c);
  }
  if (escaped.ends_with('\\')) escaped += ' ';  // which gnuplot warns of behind a sign of its markup
  return '"' + escaped + '"';
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

bool is_inside(const std::filesystem::path& file) {
  return !file.is_absolute() && file != "-" && std::ranges::find(file, "..") == file.end();
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  if (::EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, ::EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("libcrypto cannot compute a SHA-256 digest");
  return hexadecimal(digest);
}

}  // namespace stickslip::data
