#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stickslip/report/csv_table.hpp"
#include "study_results.hpp"

namespace stickslip::report {

/// What a gnuplot script gets: tables `<name>.csv` and values that no table holds.
struct FigureData {
  struct Table {
    std::string name;  ///< without .csv; the first one is the figure's own
    CsvTable table;
  };
  std::vector<Table> tables;
  std::vector<std::pair<std::string, std::string>> variables;  ///< gnuplot name and value
};

/// A figure: its name is that of figures/<name>.gp.
struct Figure {
  std::string name;
  FigureData (*data)(StudyResults&);
};

/// All figures, in the order of the report.
[[nodiscard]] const std::vector<Figure>& all_figures();

}  // namespace stickslip::report
