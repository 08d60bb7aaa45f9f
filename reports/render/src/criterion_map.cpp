#include "stickslip/report/criterion_map.hpp"

#include <fmt/format.h>

#include <vector>

#include "drawing.hpp"
#include "map_figure.hpp"

namespace stickslip::report {

namespace {

CsvColumn column_of(studies::Parameter parameter) {
  switch (parameter) {
    case studies::Parameter::frequency:
      return {"frequency_Hz", "Hz"};
    case studies::Parameter::amplitude:
      return {"amplitude_m", "m"};
    case studies::Parameter::length:
      return {"length_m", "m"};
    case studies::Parameter::axial_force:
      return {"axial_force_N", "N"};
    case studies::Parameter::youngs_modulus:
      return {"youngs_modulus_Pa", "Pa"};
    case studies::Parameter::static_coefficient:
      return {"static_coefficient", "1"};
  }
  return {};
}

// What the axis `name` (x or y) shows, counted from 1, and whether its values are in equal ratios.
void add_axis(const std::string& name, const studies::MapAxis& axis, std::vector<FigureData::Value>& values) {
  values.push_back({name + "_parameter", static_cast<double>(axis.parameter) + 1.0, "1"});
  values.push_back({name + "_log", axis.logarithmic ? 1.0 : 0.0, "1"});
}

std::vector<FigureData::Value> values_of(const studies::CriterionMap& map) {
  std::vector<FigureData::Value> values;
  add_axis("x", map.x, values);
  add_axis("y", map.y, values);
  return values;
}

}  // namespace

std::string to_string(studies::CellState state) {
  switch (state) {
    case studies::CellState::stick:
      return "stick";
    case studies::CellState::stick_slip:
      return "stick-slip";
    case studies::CellState::no_stick_state:
      return "no stick state";
  }
  return {};
}

CsvTable table_of(const data::Case& problem, const studies::CriterionMap& map) {
  CsvTable table(
      fmt::format("Criterion of stick-slip for the case {}", problem.name),
      {column_of(map.x.parameter), column_of(map.y.parameter), {"force_ratio", "1"}, {"state", "-"}});
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const auto& cell = map.cells[i];
    table.add_row(
        {csv_number(cell.x), csv_number(cell.y), csv_number(cell.force_ratio), to_string(cell.state)});
    if ((i + 1) % map.x.values.size() == 0) table.end_grid_line();
  }
  return table;
}

FigureData figure_of(const data::Case& problem, const studies::CriterionMap& map) {
  return {.tables = {{"map", table_of(problem, map)}}, .values = values_of(map)};
}

std::string draw(const CsvTable& table, const studies::CriterionMap& map, const std::string& format) {
  return drawing_of("map", format,
                    {{"map.csv", table.text()}, {"map-values.csv", values_table(values_of(map)).text()}});
}

}  // namespace stickslip::report
