// SPDX-License-Identifier: MIT
#include "render/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace stickslip::report {

nlohmann::json& entry_of(nlohmann::json& object, std::string_view member) {
  return object[member.substr(0, member.find('('))];
}

namespace {

// JSON has no such numbers; the library would write null.
void spell_out_infinities(nlohmann::json& value) {
  if (value.is_structured())
    for (auto& part : value) spell_out_infinities(part);
  else if (value.is_number_float() && !std::isfinite(value.get<double>()))
    value = fmt::format("{}", value.get<double>());
}

using nlohmann::json;

// "runs.error as error in %": the name is without the unit and empty for that of the member.
struct Column {
  std::string_view path, name, unit;
};

// What stands in front of the separator; leaves in `text` what is behind it.
std::string_view take(std::string_view& text, std::string_view separator) {
  const std::string_view front = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(text.size(), front.size() + separator.size()));
  return front;
}

std::vector<Column> columns_of(std::string_view text) {
  std::vector<Column> columns;
  while (!text.empty()) {
    std::string_view unit = take(text, ", ");
    std::string_view name = take(unit, " in ");
    const std::string_view path = take(name, " as ");
    columns.push_back({path, name, unit});
  }
  return columns;
}

// A value and what is left of the path to the member.
struct Cell {
  const json* value;
  std::string_view path;
  double scale;

  [[nodiscard]] bool is_list() const { return value->is_array(); }
  [[nodiscard]] bool is_list_of_results() const { return is_list() && !path.empty(); }
};

bool is_number(std::string_view step) { return !step.empty() && std::isdigit(step.front()) != 0; }

// Through objects, and to the elements that the path numbers.
void follow_path(Cell& cell) {
  while (!cell.path.empty() && (cell.value->is_object() || (cell.is_list() && is_number(cell.path)))) {
    const std::string step(take(cell.path, "."));
    cell.value = cell.is_list() ? &cell.value->at(std::stoul(step)) : &cell.value->at(step);
  }
}

std::string text_of(const Cell& cell) {
  const json& value = *cell.value;
  if (value.is_null()) return "";
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (!value.is_string()) return csv_number(cell.scale * value.get<double>());
  auto text = value.get<std::string>();
  std::ranges::replace(text, ',', ';');
  return text;
}

void add_rows(std::vector<Cell> cells, CsvTable& table) {
  std::ranges::for_each(cells, follow_path);
  const bool has_results = std::ranges::any_of(cells, &Cell::is_list_of_results);
  const auto walked = [&](const Cell& cell) {
    return has_results ? cell.is_list_of_results() : cell.is_list();
  };
  const auto first = std::ranges::find_if(cells, walked);
  if (first == cells.end()) {
    std::vector<std::string> texts;
    std::ranges::transform(cells, std::back_inserter(texts), text_of);
    table.add_row(texts);
    return;
  }
  const std::size_t size = first->value->size();
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<Cell> elements = cells;
    for (Cell& cell : elements)
      if (walked(cell)) {
        if (cell.value->size() != size)
          throw std::invalid_argument(
              fmt::format("lists of {} and {} elements cannot be walked together", size, cell.value->size()));
        cell.value = &cell.value->at(i);
      }
    add_rows(std::move(elements), table);
  }
}

// "time_step_s", "speed_m_per_s", "frequency_Hz".
std::string with_unit(std::string name, std::string unit) {
  if (unit == "Hz" && name.ends_with("_hz")) name.resize(name.size() - 3);
  if (unit == "1" || unit == "-" || unit == "SI") return name;
  if (unit == "%") unit = "percent";
  if (unit.starts_with("1/")) unit.erase(0, 1);
  if (const auto slash = unit.find('/'); slash != std::string::npos)
    unit.replace(slash, 1, slash == 0 ? "per_" : "_per_");
  return name + "_" + unit;
}

std::string head_of(const json& units, const Column& column) {
  if (column.path == "#") return fmt::format("{} [1]", column.name);
  const json* unit = &units;
  std::string name;
  for (std::string_view path = column.path; !path.empty();)
    if (const std::string step(take(path, ".")); !is_number(step)) unit = &unit->at(name = step);
  const std::string text = column.unit.empty() ? unit->get<std::string>() : std::string(column.unit);
  return fmt::format("{} [{}]", with_unit(column.name.empty() ? name : std::string(column.name), text), text);
}

}  // namespace

std::string json_text(nlohmann::json value) {
  spell_out_infinities(value);
  return value.dump() + "\n";
}

CsvTable study_table(const std::string& title, const json& results, const json& units, std::string_view text,
                     TableShape shape) {
  const std::vector<Column> columns = columns_of(text);
  std::string heads;
  for (const Column& column : columns) heads += (heads.empty() ? "" : ", ") + head_of(units, column);
  CsvTable table(title, heads);
  const auto add = [&](const json& result, const json& number) {
    std::vector<Cell> cells;
    for (const Column& column : columns) {
      const double scale = column.unit == "%" ? 100.0 : 1.0;
      cells.push_back(column.path == "#" ? Cell{&number, "", scale} : Cell{&result, column.path, scale});
    }
    add_rows(std::move(cells), table);
    if (shape == TableShape::grid) table.end_grid_line();
  };
  const bool is_one = !results.is_array() || is_number(columns.front().path);
  if (is_one) add(results, 1);
  for (std::size_t i = 0; !is_one && i < results.size(); ++i) add(results[i], i + 1);
  return table;
}

}  // namespace stickslip::report
