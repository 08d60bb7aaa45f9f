// SPDX-License-Identifier: MIT
#include "map_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/key.hpp"

namespace stickslip::cli {

namespace {

using Cell = studies::CriterionMap::Cell;

struct Row {
  Cell cell;
  std::string text;
};

// The key whose axis has the column; empty for none.
std::string_view key_of(const std::string& column) {
  for (const data::Key& key : data::case_keys())
    if (!column.empty() && key.axis.column == column) return key.path;
  return {};
}

// The map without its cells, if these are the columns of one: x, y, then nothing, the ratio, or value and change of each quantity, state.
std::optional<studies::CriterionMap> map_with(const std::vector<std::string>& columns) {
  if (columns.size() < 3 || columns.back() != "state") return std::nullopt;
  studies::CriterionMap map;
  map.x.parameter = key_of(columns[0]);
  map.y.parameter = key_of(columns[1]);
  map.states_only = columns.size() == 3;
  map.tolerance = 0.5;  // see MapFile
  if (map.x.parameter.empty() || map.y.parameter.empty()) return std::nullopt;
  if (columns.size() == 4 && columns[2] == "force_ratio") return map;
  for (std::size_t column = 2; column + 1 < columns.size(); column += 2) {
    const auto quantity = std::ranges::find(studies::motion_quantities, columns[column],
                                            [](const auto& of) { return std::string(of.column); });
    if (quantity == studies::motion_quantities.end() || column + 2 == columns.size()) return std::nullopt;
    map.quantities.push_back(&*quantity);
  }
  return map;
}

std::optional<Row> row_of(const std::vector<std::string>& cells, const studies::CriterionMap& map) {
  const auto x = data::finite_number(cells[0]), y = data::finite_number(cells[1]);
  const auto state = std::ranges::find(all_states, cells.back(), studies::name_of);
  if (!x || !y || state == all_states.end()) return std::nullopt;
  Row row{.cell = {.x = *x, .y = *y, .force_ratio = {}, .state = *state, .response = {}},
          .text = fmt::format("{}\n", fmt::join(cells, ","))};
  for (std::size_t i = 0; i < map.quantities.size(); ++i)
    row.cell.response.push_back({.value = 0.0, .change = cells[2 + 2 * i].empty() ? 1.0 : 0.0});
  return row;
}

// Whether each value is where equal steps between the ends have it.
bool is_even(std::vector<double> values, bool logarithmic) {
  if (logarithmic)
    for (double& value : values) value = std::log(value);
  const double first = values.front(), span = values.back() - first;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double place = first + span * static_cast<double>(i) / static_cast<double>(values.size() - 1);
    if (!(std::abs(values[i] - place) <= 1e-6 * span)) return false;
  }
  return true;
}

// The name that the title of the table has, "# ... for the case NAME; ...".
std::string case_named_in(std::string_view text, const std::string& otherwise) {
  constexpr std::string_view before = "for the case ";
  const std::string_view title = text.substr(0, text.find('\n'));
  const auto begin = title.find(before), end = title.rfind("; stickslip ");
  return begin == title.npos || end == title.npos
             ? otherwise
             : std::string(title.substr(begin + before.size(), end - begin - before.size()));
}

}  // namespace

MapFile read_map(const std::string& file) try {
  const auto fail = [&](const std::string& why) { throw data::InputError(file + ": " + why); };
  const std::string text = data::read_bounded(file, data::limit::map_bytes.most);
  data::CsvReader csv(file, text);
  auto map = map_with(csv.names());
  if (!map) fail("is no map: its columns are " + data::printable(data::joined(csv.names())));

  std::vector<Row> rows;
  while (const auto cells = csv.next_row()) {
    auto row = row_of(*cells, *map);
    if (!row) fail(fmt::format("line {} is no point of a map", csv.line()));
    rows.push_back(std::move(*row));
  }
  if (rows.empty()) fail("has no point");
  std::ranges::sort(rows, {}, [](const Row& row) { return std::pair(row.cell.y, row.cell.x); });
  for (const Row& row : rows) {
    if (row.cell.y == rows.front().cell.y) map->x.values.push_back(row.cell.x);
    if (map->y.values.empty() || map->y.values.back() != row.cell.y) map->y.values.push_back(row.cell.y);
  }
  for (studies::MapAxis* axis : {&map->x, &map->y}) {
    axis->logarithmic = !is_even(axis->values, false);
    if (axis->values.size() < 2 || (axis->logarithmic && !is_even(axis->values, true)))
      fail(fmt::format(
          "{} must have two or more values in equal steps or ratios; is a part missing or double?",
          axis->parameter));
  }
  MapFile read{.map = std::move(*map),
               .case_name = case_named_in(text, file),
               .table = fmt::format("{}\n", fmt::join(csv.names(), ","))};
  const auto &x = read.map.x.values, &y = read.map.y.values;
  for (std::size_t n = 0; n < std::max(rows.size(), x.size() * y.size()); ++n) {
    const double at_x = x[n % x.size()], at_y = y[std::min(n / x.size(), y.size() - 1)];
    if (n >= rows.size() || rows[n].cell.x != at_x || rows[n].cell.y != at_y)
      fail(fmt::format("the point {}, {} must be there once; is a part missing or double?",
                       data::shortest_text(at_x), data::shortest_text(at_y)));
    read.map.cells.push_back(std::move(rows[n].cell));
    read.table += rows[n].text;
    if ((n + 1) % x.size() == 0) read.table += '\n';
  }
  return read;
} catch (const data::InputError& error) {
  throw data::InputError(std::string("--from: ") + error.what());
}

}  // namespace stickslip::cli
