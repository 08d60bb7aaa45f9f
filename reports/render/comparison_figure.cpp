// SPDX-License-Identifier: MIT
#include "render/comparison_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "render/csv_table.hpp"
#include "render/drawing.hpp"

namespace stickslip::report {

namespace {

using Quantity = comparison::Comparison::Quantity;

// "tip displacement / m", without what gnuplot takes for markup.
std::string label(std::string name, const std::string& unit) {
  std::ranges::replace(name, '_', ' ');
  return unit.empty() ? name : fmt::format("{} / {}", name, unit);
}

// An empty line after each series, so that no line joins two of them.
CsvTable table_of(const comparison::Comparison& comparison, const Quantity& quantity) {
  CsvTable table(fmt::format("{} of {}", quantity.name, comparison.name),
                 {{"abscissa", comparison.abscissa_unit},
                  {"theirs", quantity.unit},
                  {"reference", quantity.unit},
                  {"half_width", quantity.unit},
                  {"allowed", quantity.unit}});
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

std::string draw(const comparison::Comparison& comparison, const Look& look) {
  CsvTable labels("Labels of the axes: the abscissa, then one for each quantity", {{"label", "-"}});
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
