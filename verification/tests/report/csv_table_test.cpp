// SPDX-License-Identifier: MIT
/// Tables of the figures' data.

#include "render/csv_table.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/requirements.hpp"

namespace stickslip {
namespace {

STICKSLIP_VERIFIES(CsvTable, "U3");
TEST(CsvTable, HasTitleUnitsNamesAndRows) {
  report::CsvTable table("Tip", {{"time_s", "s"}, {"tip_m", "m"}});
  table.add_numbers({0.1, -2e-7});
  EXPECT_EQ(table.text(), "# Tip\n# units: s,m\ntime_s,tip_m\n0.1,-2e-07\n");
}

TEST(CsvTable, EndsALineOfAGridWithAnEmptyLine) {
  report::CsvTable table("Map", {{"length_m", "m"}});
  table.add_numbers({1.0});
  table.end_grid_line();
  table.add_numbers({2.0});
  EXPECT_EQ(table.text(), "# Map\n# units: m\nlength_m\n1\n\n2\n");
}

TEST(CsvTable, WritesNumbersThatReadBackExactly) {
  for (const double value : {std::numbers::pi, 1.0 / 3.0, 2.2250738585072014e-308, -1.7976931348623157e308})
    EXPECT_EQ(std::stod(report::csv_number(value)), value);
  EXPECT_EQ(report::csv_number(std::nullopt), "");
}

TEST(CsvTable, IsTheSameWrittenCellByCell) {
  const std::vector<report::CsvColumn> columns{{"time_s", "s"}, {"tip_m", "m"}, {"state", "-"}};
  report::CsvTable rows("Tip", columns), cells("Tip", columns);
  const report::CsvText stick("stick");
  rows.add_row({"0.1", "", "stick"});
  cells.add(0.1).add(std::nullopt).add(stick).end_row();
  rows.add_row({"1e-05", "-2", "stick"});
  cells.add(1e-5).add(-2.0).add(stick).end_row();
  EXPECT_EQ(cells.text(), rows.text());
  EXPECT_THROW(cells.add(1.0).end_row(), std::invalid_argument);
  EXPECT_THROW(report::CsvText("a,b"), std::invalid_argument);
}

TEST(CsvTable, RefusesARowOfTheWrongLengthAndACellThatWouldSplit) {
  report::CsvTable table("Tip", {{"time_s", "s"}, {"tip_m", "m"}});
  EXPECT_THROW(table.add_numbers({1.0}), std::invalid_argument);
  EXPECT_THROW(table.add_row({std::string("a,b"), std::string("c")}), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip
