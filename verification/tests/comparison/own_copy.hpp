// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "comparison/comparison.hpp"

namespace stickslip::testing {

/// A data set as its own result, or some of its columns, in which a test changes rows and cells.
class OwnCopy {
 public:
  OwnCopy(const data::ReferencePackage& package, const std::string& set,
          const std::vector<std::string>& columns = {})
      : package_(&package), reference_(data::read_table(package, set)) {
    table.file = "mine.csv";
    table.lines.resize(reference_.rows());
    std::iota(table.lines.begin(), table.lines.end(), 2);
    for (const data::Column& column : reference_.columns)
      if (columns.empty() || std::ranges::count(columns, column.field.name) > 0)
        table.columns.push_back(column);
  }

  data::UserTable table;

  [[nodiscard]] const data::ReferenceTable& reference() const { return reference_; }
  [[nodiscard]] std::vector<double>& operator[](const std::string& name) { return column(name).values; }
  [[nodiscard]] std::vector<std::string>& words(const std::string& name) { return column(name).text; }

  OwnCopy& keep(const std::function<bool(std::size_t)>& is_kept) {
    for (std::size_t row = table.rows(); row-- > 0;) {
      if (is_kept(row)) continue;
      for_each_column([row](auto& cells) { cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(row)); });
    }
    return *this;
  }
  OwnCopy& repeat(std::size_t row) {
    for_each_column([row](auto& cells) {
      const auto cell = cells[row];
      cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(row), cell);
    });
    return *this;
  }

  [[nodiscard]] studies::Comparison compared(studies::ComparisonSettings settings = {}) const {
    settings.diagnose = false;
    return studies::compare(*package_, reference_.resource.name, table, settings);
  }
  [[nodiscard]] studies::Comparison::Quantity compared(
      const std::string& quantity, const studies::ComparisonSettings& settings = {}) const {
    const auto comparison = compared(settings);
    return *std::ranges::find(comparison.quantities, quantity, &studies::Comparison::Quantity::name);
  }

 private:
  data::Column& column(const std::string& name) {
    return *std::ranges::find(table.columns, name, [](const auto& one) { return one.field.name; });
  }
  template <class Change>
  void for_each_column(const Change& change) {
    for (data::Column& one : table.columns) {
      change(one.text);
      change(one.values);
    }
    change(table.lines);
  }

  const data::ReferencePackage* package_;
  data::ReferenceTable reference_;
};

inline studies::ComparisonSettings with_tolerance(const std::string& quantity, double tolerance,
                                                  std::optional<double> until = std::nullopt) {
  return {.tolerances = {{quantity, tolerance}}, .until = until, .events = {}};
}

inline std::size_t skipped_for(const studies::Comparison::Quantity& quantity, const std::string& reason) {
  const auto found = std::ranges::find_if(
      quantity.skipped, [&](const auto& skipped) { return skipped.reason.starts_with(reason); });
  return found == quantity.skipped.end() ? 0 : found->points;
}

}  // namespace stickslip::testing
