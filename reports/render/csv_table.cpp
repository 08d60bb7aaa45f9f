// SPDX-License-Identifier: MIT
#include "render/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::report {

CsvTable::CsvTable(std::string_view title, std::string_view columns) {
  std::string names, units;
  for (std::size_t begin = 0; begin < columns.size(); ++columns_) {
    const std::size_t end = std::min(columns.find(", ", begin), columns.size());
    const auto [name, unit] = data::header_of(columns.substr(begin, end - begin));
    const char* const comma = columns_ > 0 ? "," : "";
    names += comma + name;
    units += comma + unit.value();
    begin = end + 2;
  }
  text_ = fmt::format("# {}\n# units: {}\n{}\n", title, units, names);
  rows_begin_ = text_.size();
}

void CsvTable::add_row(const std::vector<std::string>& cells) {
  require_columns(cells.size());
  for (const std::string& cell : cells) add(cell);
  end_row();
}

void CsvTable::add_numbers(const std::vector<double>& values) {
  require_columns(values.size());
  for (const double value : values) add(value);
  end_row();
}

CsvTable& CsvTable::add(std::string_view cell) {
  if (cells_++ > 0) text_ += ',';
  text_ += data::csv_cell(cell);
  return *this;
}

CsvTable& CsvTable::add(std::optional<double> value) {
  if (cells_++ > 0) text_ += ',';
  text_ += csv_number(value);
  return *this;
}

void CsvTable::end_row() {
  require_columns(cells_);
  cells_ = 0;
  text_ += '\n';
}

void CsvTable::require_columns(std::size_t cells) const {
  if (cells != columns_)
    throw std::invalid_argument(fmt::format("a row has {} cells, but the table {} columns", cells, columns_));
}

std::string csv_number(std::optional<double> value) { return value ? data::shortest_text(*value) : ""; }

}  // namespace stickslip::report
