#include "csv_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <system_error>

#include "input_text.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::data {

std::string cell_place(const std::filesystem::path& file, std::size_t line, std::size_t column,
                       std::string_view name) {
  return file.string() + ":" + std::to_string(line) + ", column " + std::to_string(column) + " (" +
         printable(name) + ")";
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
