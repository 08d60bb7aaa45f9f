#include "stickslip/report/csv_table.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "stickslip/data/problem.hpp"

namespace stickslip::report {

CsvTable::CsvTable(std::string_view title, const std::vector<CsvColumn>& columns)
    : columns_(columns.size()), text_(fmt::format("# {}\n# units: ", title)) {
  std::vector<std::string> names;
  for (const CsvColumn& column : columns) {
    if (!names.empty()) text_ += ',';
    text_ += column.unit;
    names.push_back(column.name);
  }
  text_ += '\n';
  add_row(names);
}

void CsvTable::add_row(const std::vector<std::string>& cells) {
  if (cells.size() != columns_)
    throw std::invalid_argument(
        fmt::format("a row has {} cells, but the table {} columns", cells.size(), columns_));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].find_first_of(",\"\r\n") != std::string::npos)
      throw std::invalid_argument(
          fmt::format("the cell '{}' holds a comma, a quote or a line break, but must hold none", cells[i]));
    if (i > 0) text_ += ',';
    text_ += cells[i];
  }
  text_ += '\n';
}

void CsvTable::add_numbers(const std::vector<double>& values) {
  std::vector<std::string> cells;
  for (const double value : values) cells.push_back(csv_number(value));
  add_row(cells);
}

std::string csv_number(std::optional<double> value) { return value ? data::shortest_text(*value) : ""; }

}  // namespace stickslip::report
