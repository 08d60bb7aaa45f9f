// SPDX-License-Identifier: MIT
#include "render/criterion_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace stickslip::report {

namespace {

// What the axis `name` (x or y) shows, and whether its values are in equal ratios.
void add_axis(const std::string& name, const studies::MapAxis& axis, std::vector<FigureData::Value>& values) {
  const data::KeyAxis& shown = data::key_named(axis.parameter).axis;
  values.push_back({name + "_label", 0.0, "-", std::string(shown.label)});
  values.push_back({name + "_scale", shown.scale, "1"});
  values.push_back({name + "_log", axis.logarithmic ? 1.0 : 0.0, "1"});
}

std::vector<FigureData::Value> values_of(const studies::CriterionMap& map) {
  std::vector<FigureData::Value> values;
  add_axis("x", map.x, values);
  add_axis("y", map.y, values);
  values.push_back({"states_only", map.states_only ? 1.0 : 0.0, "1"});
  values.push_back({"quantities", static_cast<double>(map.quantities.size()), "1"});
  if (!map.quantities.empty())
    values.push_back({"quantity_label", 0.0, "-", std::string(map.quantities.front()->label)});
  return values;
}

// The texts of the values along an axis, which many cells share.
std::vector<std::string> texts_of(const studies::MapAxis& axis) {
  std::vector<std::string> texts;
  for (const double value : axis.values) texts.push_back(csv_number(value));
  return texts;
}

constexpr std::size_t longest_usual_row = 72;  // three numbers of 20 characters and a state

// The value, if there is one and it has converged, and the change.
void add(CsvTable& table, const studies::CriterionMap::Cell& cell, std::size_t quantity, double tolerance) {
  std::optional<double> value, change;
  if (quantity < cell.response.size()) {
    change = cell.response[quantity].change;
    if (*change <= tolerance) value = cell.response[quantity].value;
  }
  table.add(value).add(change);
}

using Quantity = comparison::Comparison::Quantity;

// "tip displacement / m", without what gnuplot takes for markup.
std::string label(std::string name, const std::string& unit) {
  std::ranges::replace(name, '_', ' ');
  return unit.empty() ? name : fmt::format("{} / {}", name, unit);
}

// An empty line after each series, so that no line joins two of them.
CsvTable table_of(const comparison::Comparison& comparison, const Quantity& quantity) {
  CsvTable table(fmt::format("{} of {}", quantity.name, comparison.name),
                 fmt::format("abscissa [{0}], theirs [{1}], reference [{1}], half_width [{1}], allowed [{1}]",
                             comparison.abscissa_unit, quantity.unit));
  for (const auto& series : quantity.series) {
    for (std::size_t i = 0; i < series.abscissa.size(); ++i)
      table.add_numbers({series.abscissa[i], series.theirs[i], series.reference[i], series.half_width[i],
                         series.allowed[i]});
    table.end_grid_line();
  }
  return table;
}

// Samples of something smooth are joined by lines.
bool is_smooth(data::ComparisonKind kind) {
  return kind == data::ComparisonKind::curve || kind == data::ComparisonKind::phases;
}

}  // namespace

std::string column_of(std::string_view parameter) {
  const data::Key& key = data::key_named(parameter);
  const std::string_view unit = key.magnitudes.unit;
  return fmt::format("{} [{}]", key.axis.column, unit.empty() ? "1" : unit);
}

CsvTable table_of(const data::Case& problem, const studies::CriterionMap& map) {
  std::string columns = column_of(map.x.parameter) + ", " + column_of(map.y.parameter);
  const bool has_ratio = !map.states_only && map.quantities.empty();
  if (has_ratio) columns += ", force_ratio [1]";
  for (const studies::MotionQuantity* quantity : map.quantities) {
    std::string change(quantity->name);
    std::ranges::replace(change, '-', '_');
    columns += fmt::format(", {} [{}], {}_change [1]", quantity->column, quantity->unit, change);
  }
  CsvTable table(
      fmt::format("{} for the case {}{}",
                  map.quantities.empty() ? "Criterion of stick-slip" : "Stick-slip motion", problem.name,
                  has_ratio ? " (force_ratio is the largest |f| over mu_s P: above 1 the tip slips)" : ""),
      columns + ", state [-]");
  table.reserve(map.cells.size() * longest_usual_row);

  const std::vector<std::string> x = texts_of(map.x), y = texts_of(map.y);
  std::size_t n = map.part.of(x.size() * y.size()).first;
  for (const auto& cell : map.cells) {
    table.add(x[n % x.size()]).add(y[n / x.size()]);
    if (has_ratio) table.add(cell.force_ratio);
    for (std::size_t q = 0; q < map.quantities.size(); ++q) add(table, cell, q, map.tolerance);
    table.add(studies::name_of(cell.state)).end_row();
    if (++n % x.size() == 0) table.end_grid_line();
  }
  return table;
}

std::string draw(const std::string& table, const studies::CriterionMap& map, const Look& look) {
  return drawing_of("map", look,
                    {{"map.csv", table}, {"map-values.csv", values_table(values_of(map)).text()}});
}

std::string draw(const data::Case& problem, const studies::CriticalAmplitudeCurve& curve, const Look& look) {
  const data::Key& stated = data::stated_amplitude(problem.excitation());
  const data::HarmonicMotion& motion = problem.excitation().motion();
  CsvTable table("Critical amplitude of the case " + problem.name,
                 fmt::format("frequency [Hz], critical_amplitude [{}]", stated.magnitudes.unit));
  CsvTable marks("Natural frequencies of the stick state", "frequency [Hz]");
  for (const auto& [hz, amplitude] : curve.points)
    table.add_numbers(
        {hz, data::HarmonicExcitation({hz, amplitude}).stated_as(motion.amplitude_of).amplitude});
  for (const double hz : curve.natural_hz) marks.add_numbers({hz});
  const auto values =
      values_table({{"excitation_frequency", motion.frequency_hz, "Hz"},
                    {"excitation_amplitude", motion.amplitude, std::string(stated.magnitudes.unit)},
                    {"amplitude_label", 0.0, "-", std::string(stated.axis.label)},
                    {"amplitude_scale", stated.axis.scale, "1"}});
  return drawing_of("criterion", look,
                    {{"criterion.csv", table.text()},
                     {"criterion-natural.csv", marks.text()},
                     {"criterion-values.csv", values.text()}});
}

std::string draw(const std::map<std::size_t, double>& margins, const Look& look) {
  CsvTable table("Margins of the rows of a table", "row [1], margin [1]");
  for (const auto& [row, margin] : margins) table.add_numbers({static_cast<double>(row), margin});
  return drawing_of("plan", look, {{"plan.csv", table.text()}});
}

std::string draw(const studies::SlipUncertainty& result, const Look& look) {
  CsvTable table("Margins of the samples", "margin [1]");
  for (const double margin : result.margins) table.add_numbers({margin});
  return drawing_of("uncertainty", look, {{"uncertainty.csv", table.text()}});
}

std::string draw(const comparison::Comparison& comparison, const Look& look) {
  CsvTable labels("Labels of the axes: the abscissa, then one for each quantity", "label [-]");
  labels.add_row(
      {comparison.abscissa.empty() ? "row" : label(comparison.abscissa, comparison.abscissa_unit)});
  std::map<std::string, std::string> tables;
  double quantities = 0.0;
  for (const Quantity& quantity : comparison.quantities) {
    if (quantity.series.empty()) continue;
    quantities += 1.0;
    tables[fmt::format("comparison-{}.csv", quantities)] = table_of(comparison, quantity).text();
    labels.add_row({label(quantity.name, quantity.unit)});
  }
  tables["comparison-labels.csv"] = labels.text();
  tables["comparison-values.csv"] =
      values_table({{"quantities", quantities, "1"}, {"smooth", is_smooth(comparison.kind) ? 1.0 : 0.0, "1"}})
          .text();
  return drawing_of("comparison", look, tables);
}

}  // namespace stickslip::report
