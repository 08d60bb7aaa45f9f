// SPDX-License-Identifier: MIT
/// Tables of the figures' data, and those of the results of studies.

#include "render/csv_table.hpp"
#include "render/study_table.hpp"
#include "support/testing.hpp"

namespace stickslip {
namespace {

struct Level {
  double step{}, error{};
  std::optional<double> order{};
};
STICKSLIP_MEMBERS(Level, (step, "s"), (error, "1"), (order))

struct Run {
  std::string method{};
  double load_hz{};
  bool slips{};
  std::vector<Level> levels{};
  std::vector<double> time{}, speed{};
  [[nodiscard]] double rate() const { return 2.0 * load_hz; }
};
STICKSLIP_MEMBERS(Run, (method, "-"), (load_hz, "Hz"), (slips, "1"), (levels, "N"), (time, "s"),
                  (speed, "m/s"), (rate(), "1/s"))

const std::vector<Run> runs{
    {"by hand, twice", 25.0, true, {{0.1, 0.5, 2.0}, {0.05, 0.25}}, {0.0, 1.0}, {3.0, 4.0}},
    {"fast", 70.0, false, {{0.2, 1.0, {}}}, {0.0, 2.0}, {5.0, 6.0}}};

std::string rows_of(const std::string& columns, report::TableShape shape = report::TableShape::lines) {
  const std::string text = report::study_table("Runs", runs, columns, shape).text();
  return text.substr(text.find("# units"));
}

STICKSLIP_VERIFIES(StudyTable, "U3");
TEST(StudyTable, NamesColumnsByMemberAndUnit) {
  for (const auto& [columns, rows] : std::vector<std::pair<std::string, std::string>>{
           {"# as number, method, load_hz, slips, rate, rate as growth",
            "1,-,Hz,1,1/s,1/s\nnumber,method,load_Hz,slips,rate_per_s,growth_per_s\n"
            "1,by hand; twice,25,1,50,50\n2,fast,70,0,140,140\n"},
           {"load_hz, levels.step, levels.error in %, levels.order",
            "Hz,s,%,N\nload_Hz,step_s,error_percent,order_N\n25,0.1,50,2\n25,0.05,25,\n70,0.2,100,\n"},
           {"0.time, 0.speed as first, 1.speed as second",
            "s,m/s,m/s\ntime_s,first_m_per_s,second_m_per_s\n0,3,5\n1,4,6\n"},
           {"levels.step, time", "s,s\nstep_s,time_s\n0.1,0\n0.1,1\n0.05,0\n0.05,1\n0.2,0\n0.2,2\n"}})
    EXPECT_EQ(rows_of(columns), "# units: " + rows);
  EXPECT_EQ(rows_of("time, speed, load_hz", report::TableShape::grid),
            "# units: s,m/s,Hz\ntime_s,speed_m_per_s,load_Hz\n0,3,25\n1,4,25\n\n0,5,70\n2,6,70\n\n");
}

TEST(StudyTable, RefusesUnknownMembers) {
  EXPECT_THROW(rows_of("0.levels.step, 1.levels.step"), std::invalid_argument);
  EXPECT_THROW(rows_of("load_hz, levels.stop"), nlohmann::json::out_of_range);
}

STICKSLIP_VERIFIES(CsvTable, "U3");
TEST(CsvTable, WritesNumbersThatReadBackExactly) {
  for (const double value : {std::numbers::pi, 1.0 / 3.0, 2.2250738585072014e-308, -1.7976931348623157e308})
    EXPECT_EQ(std::stod(report::csv_number(value)), value);
  EXPECT_EQ(report::csv_number(std::nullopt), "");
}

TEST(CsvTable, IsTheSameWrittenCellByCell) {
  report::CsvTable rows("Tip", "time_s [s], tip_m [m], state [-]"), cells = rows;
  rows.add_row({"0.1", "", "stick"});
  cells.add(0.1).add(std::nullopt).add("stick").end_row();
  rows.add_row({"1e-05", "-2e-07", "stick"});
  cells.add(1e-5).add(-2e-7).add("stick").end_row();
  EXPECT_EQ(cells.text(), rows.text());
  EXPECT_EQ(rows.text(), "# Tip\n# units: s,m,-\ntime_s,tip_m,state\n0.1,,stick\n1e-05,-2e-07,stick\n");
  EXPECT_THROW(rows.add_numbers({1.0}), std::invalid_argument);
  EXPECT_THROW(cells.add(1.0).end_row(), std::invalid_argument);
}

TEST(CsvTable, HoldsAnyText) {
  report::CsvTable table("Names", "name [-]");
  for (const char* name : {"a,b", "a\"b", "=1+1", "@a,b", "-1e3", "+b", "-"}) table.add_row({name});
  EXPECT_TRUE(table.text().ends_with("name\n\"a,b\"\n\"a\"\"b\"\n'=1+1\n\"'@a,b\"\n-1e3\n'+b\n-\n"));
}

}  // namespace
}  // namespace stickslip
