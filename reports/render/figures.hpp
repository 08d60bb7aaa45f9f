// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "render/csv_table.hpp"
#include "render/study_results.hpp"

namespace stickslip::report {

/// What a gnuplot script gets, all of it as `<name>.csv`: tables, and a table of single values if there are
/// any.
struct FigureData {
  struct Table {
    std::string name;  ///< without .csv; the first one is the figure's own
    CsvTable table;
  };
  struct Value {
    std::string name;  ///< the gnuplot variable
    std::variant<double, std::string> value;
    std::string unit;  ///< "-" of a text
  };
  std::vector<Table> tables;
  std::vector<Value> values;
};

/// The values of a figure as a table with the columns name, value and unit.
[[nodiscard]] CsvTable values_table(const std::vector<FigureData::Value>& values);

/// A figure: its name is that of figures/<name>.gp.
struct Figure {
  std::string name;
  FigureData (*data)(StudyResults&);
};

/// All figures, in the order of the report.
[[nodiscard]] const std::vector<Figure>& all_figures();

}  // namespace stickslip::report
