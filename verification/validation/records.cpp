// SPDX-License-Identifier: MIT
#include "validation/records.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::validation {

namespace {

constexpr std::size_t most_bytes = 50'000'000;

// The types of elements that occur (MAT-File Format, The MathWorks, table 1-1).
enum : std::uint32_t { double_type = 9, matrix_type = 14, compressed_type = 15 };

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw data::InputError(file.string() + ": " + what);
}

// Numbers of a file whose bytes stand in the order of this machine.
template <class Number>
Number number_at(std::string_view bytes, std::size_t place) {
  Number number{};
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

std::string inflated(const std::filesystem::path& file, std::string_view bytes) {
  std::string text(8 * bytes.size() + 1024, '\0');
  while (text.size() <= most_bytes) {
    auto size = static_cast<::uLongf>(text.size());
    const int status = ::uncompress(reinterpret_cast<::Bytef*>(text.data()), &size,
                                    reinterpret_cast<const ::Bytef*>(bytes.data()), bytes.size());
    if (status == Z_OK) return text.substr(0, size);
    if (status != Z_BUF_ERROR || bytes.size() < 8) break;
    text.resize(4 * text.size());
  }
  fail(file, "holds a damaged compressed element");
}

struct Element {
  std::uint32_t type{};
  std::string_view bytes;
};

// Takes the next element off the front: type and size in 8 bytes, or in 4 where the data fit in the other 4.
Element take_element(const std::filesystem::path& file, std::string_view& rest) {
  if (rest.size() < 8) fail(file, "ends within an element");
  const auto word = number_at<std::uint32_t>(rest, 0);
  const bool is_small = (word >> 16U) != 0;
  const std::size_t size = is_small ? word >> 16U : number_at<std::uint32_t>(rest, 4);
  const std::size_t begin = is_small ? 4 : 8;
  const Element element{is_small ? word & 0xFFFFU : word, rest.substr(begin, size)};
  if (element.bytes.size() < size || (is_small && size > 4)) fail(file, "ends within an element");
  const std::size_t padded = is_small || element.type == compressed_type ? size : (size + 7) / 8 * 8;
  rest.remove_prefix(std::min(rest.size(), is_small ? 8 : begin + padded));
  return element;
}

// Flags, dimensions, name and real part of an array.
std::pair<std::string, std::vector<double>> array_of(const std::filesystem::path& file,
                                                     std::string_view bytes) {
  take_element(file, bytes);
  take_element(file, bytes);
  const std::string name(take_element(file, bytes).bytes);
  const Element real = take_element(file, bytes);
  if (real.type != double_type || real.bytes.size() % sizeof(double) != 0)
    fail(file, "array " + data::printable(name) + " is not of doubles");
  std::vector<double> values(real.bytes.size() / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), real.bytes.data(), real.bytes.size());
  return {name, std::move(values)};
}

void require_increasing_times(const std::filesystem::path& file, const std::vector<double>& times) {
  if (times.size() < 2 || std::ranges::adjacent_find(times, std::greater_equal{}) != times.end())
    fail(file, "must have two samples or more at increasing times");
}

}  // namespace

std::map<std::string, std::vector<double>> read_mat(const std::filesystem::path& file) {
  const std::string text = data::read_bounded(file, most_bytes);
  constexpr std::size_t header = 128;
  const std::string_view order = std::endian::native == std::endian::little ? "IM" : "MI";
  if (text.size() < header || !text.starts_with("MATLAB 5.0") ||
      std::string_view(text).substr(126, 2) != order)
    fail(file, "is no MAT file of version 5 in the byte order of this machine");
  std::map<std::string, std::vector<double>> arrays;
  for (std::string_view rest = std::string_view(text).substr(header); !rest.empty();) {
    Element element = take_element(file, rest);
    std::string storage;
    if (element.type == compressed_type) {
      storage = inflated(file, element.bytes);
      std::string_view inner = storage;
      element = take_element(file, inner);
    }
    if (element.type != matrix_type) fail(file, "holds an element that is no array");
    arrays.insert(array_of(file, element.bytes));
  }
  return arrays;
}

Record read_slider_record(const std::filesystem::path& file) {
  auto arrays = read_mat(file);
  Record record{.time = std::move(arrays["t"]), .displacement = {}, .force = std::move(arrays["Fnorm"])};
  if (record.time.size() != record.force.size()) fail(file, "must hold t and Fnorm of one length");
  require_increasing_times(file, record.time);
  return record;
}

Record read_damper_record(const std::filesystem::path& file) {
  constexpr double inch = 0.0254, kip = 4448.2216152605;  // m, N: exact by definition
  Record record;
  try {
    const nlohmann::json whole = nlohmann::json::parse(data::read_table_text(file));
    for (const auto& row : whole.at("data")) {
      record.time.push_back(row.at(0).get<double>());
      record.displacement.push_back(inch * row.at(1).get<double>());
      record.force.push_back(kip * row.at(2).get<double>());
    }
  } catch (const nlohmann::json::exception& error) {
    fail(file, std::string("must hold rows of numbers in `data`: ") + error.what());
  }
  require_increasing_times(file, record.time);
  return record;
}

Record read_spectrum(const std::filesystem::path& file) {
  std::istringstream text(data::read_bounded(file, most_bytes));
  Record record;
  // Behind the last heading, whose line begins with X_Value.
  std::string line;
  while (std::getline(text, line) && !line.starts_with("X_Value")) continue;
  for (double frequency{}, level{}; text >> frequency >> level;) {
    record.time.push_back(frequency);
    record.force.push_back(level);
  }
  require_increasing_times(file, record.time);
  return record;
}

}  // namespace stickslip::validation
