// SPDX-License-Identifier: MIT
/// What `respond` writes and draws by default: enough for the eye, whatever the step and the duration.

#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

class HistoryFiles : public SignalledRun {
 protected:
  using Rows = std::vector<std::vector<std::string>>;

  // The rows of the command's history behind the names of the columns.
  [[nodiscard]] Rows rows_of(const std::string& options) const {
    EXPECT_EQ(run("respond " + options + " --output history.csv").status, 0) << options;
    return rows_in("history.csv");
  }

  [[nodiscard]] static Rows rows_in(const std::string& file) {
    Rows rows = csv(contents(file));
    rows.erase(rows.begin());
    return rows;
  }

  [[nodiscard]] static double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

  // The smallest and the largest value of a column.
  [[nodiscard]] static std::pair<double, double> range(const Rows& rows, std::size_t column) {
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(number(row[column]));
    const auto [least, most] = std::ranges::minmax(values);
    return {least, most};
  }

  static inline const std::string short_steps =
      "paper --hz 25 --amplitude 1e-3 --set numerics.time_step=1e-6 ";
};

// 100 rows in 0.04 s are 4e-4 s, 20 in a period of 24.97 Hz 2e-3 s: at 0.5 s the 2000 rows decide, 2.5e-4 s.
STICKSLIP_VERIFIES(HistoryFiles, "U1");
TEST_F(HistoryFiles, HaveTheRowsThatAnEyeNeedsWhateverTheStep) {
  EXPECT_EQ(rows_of(short_steps + "--duration 0.5").size(), 2501u);  // of 200 steps
  EXPECT_EQ(rows_of(short_steps + "--duration 2 --method event-driven").size(), 10'001u);
  EXPECT_EQ(rows_of("paper --hz 250 --duration 2 --method closed-form --set numerics.time_step=1e-6").size(),
            100'001u);  // of 20 steps; 40 would be 4e-5 s
  EXPECT_EQ(rows_of(short_steps + "--duration 0.5 --rate 700").size(), 701u / 2u + 1u);
  EXPECT_EQ(
      rows_of("paper --duration 0.01 --method closed-form --rate 1e9 --set numerics.time_step=1e-4").size(),
      101u);  // each step
  expect_refused("respond --rate 0", "--rate is 0, but must be from 1e-09 to 1e+12 (1/s)");
  expect_refused("respond --rate 10 --every 10", "--every excludes --rate");
}

TEST_F(HistoryFiles, HaveTheRowsOfAWindow) {
  const auto rows = rows_of(short_steps + "--duration 0.1 --from 0.06 --to 0.061 --events events.csv");
  ASSERT_EQ(rows.size(), 1001u);  // each step
  EXPECT_EQ(rows.front()[0], "0.06");
  EXPECT_EQ(rows.back()[0], "0.061");
  EXPECT_LT(number(rows_in("events.csv").front()[0]), 0.06);
  expect_refused("respond --duration 0.1 --from 0.2", "--from is 0.2, but must be below the duration, 0.1 s");
  expect_refused("respond --duration 0.1 --from 0.05 --to 0.05",
                 "--to is 0.05, but must be above --from, 0.05 s, and at most the duration, 0.1 s");
}

TEST_F(HistoryFiles, LoseNoExtremeBetweenTheirRows) {
  const std::string options = "respond " + short_steps + "--duration 0.08 --output history.csv ";
  const auto all = json(options + "--every 1"), few = json(options + "--every 4001");
  EXPECT_EQ(few["rows"], 20);
  for (const char* key : {"largest_friction_force_N", "largest_deflection_m", "first_slip_s"})
    EXPECT_EQ(all[key], few[key]) << key;
  EXPECT_EQ(few["time_steps_in_a_row"], 4001);
  EXPECT_TRUE(few["program"].get<std::string>().starts_with("stickslip "));
  EXPECT_TRUE(few["command"].get<std::string>().ends_with(options + "--every 4001 --json"));
}

// By the smallest and largest values in each of a thousand columns.
TEST_F(HistoryFiles, AreDrawnFromFewRowsThatReachAsFarAsAll) {
  install_gnuplot("cat \"${folder}history.csv\" > $output; echo \"$heading, $chosen_width\" > '" +
                  path("look") + "'\n");
  const auto all =
      rows_of(short_steps + "--duration 0.08 --every 1 --figure drawn.svg --title 'Mine' --size 12x8");
  const auto drawn = rows_in("drawn.svg");
  ASSERT_EQ(all.size(), 80'001u);
  std::size_t changes = 0;
  for (std::size_t i = 1; i < all.size(); ++i) changes += all[i][6] != all[i - 1][6];
  EXPECT_LE(drawn.size(), 2002u + 2 * changes);  // a column with both states has the extremes of both
  for (const std::size_t column : {1u, 2u, 3u, 4u, 5u}) EXPECT_EQ(range(drawn, column), range(all, column));
  EXPECT_TRUE(std::ranges::any_of(drawn, [](const auto& row) { return row[6] == "slip"; }));
  for (std::size_t i = 1; i < drawn.size(); ++i) EXPECT_LT(number(drawn[i - 1][0]), number(drawn[i][0]));
  EXPECT_EQ(contents("look"), "Mine, 12\n");
  EXPECT_EQ(run("criterion paper --figure a.png").status, 1);  // this gnuplot finds no history.csv
  EXPECT_EQ(contents("look"), "paper, \n");
  for (const std::string size : {"12", "3x12", "12x101"})
    expect_refused("criterion paper --figure a.png --size " + size,
                   "--size is " + size + ", but must be WIDTHxHEIGHT");
  expect_refused("criterion paper --size 12x8", "--size requires --figure");
  install_gnuplot("echo drawn > $output; echo 'Warning - difficulty fitting plot titles into key?' >&2\n");
  expect_refused("criterion paper --figure a.png --size 4x4",
                 "--size is 4x4, but must be so large that the legend fits into the figure");
}

// Of a hundred thousand rows.
TEST_F(HistoryFiles, AreSmallFigures) {
  for (const std::string name : {"a.svg", "a.pdf", "a.png"}) {
    (void)rows_of(short_steps + "--duration 0.1 --every 1 --figure " + name);
    const auto size = std::filesystem::file_size(name);
    EXPECT_GT(size, 5'000u) << name;
    EXPECT_LT(size, 300'000u) << name;
  }
}

// 3 w/(2 L) of a cantilever: 27/8 (w/L)^2 is above 5 % from 12.2 % of the length on.
TEST_F(HistoryFiles, OfALargeDeflectionComeWithAWarning) {
  std::ofstream("reed.toml")
      << "[beam]\nlength = 0.06\nmaterial = \"steel\"\naxial_force = 10\n"
         "[section]\nshape = \"rectangle\"\nwidth = 8e-3\nheight = 5e-4\n"
         "[friction]\nstatic_coefficient = 0.5\nkinetic_coefficient = 0.25\ndecay = 3\n"
         "[damping]\nratio = 0.005\n[excitation]\nfrequency_hz = 50\namplitude = 0\n"
         "[wall]\nspeed = 0.2\n";
  const std::string part = "% of the length: the model is that of small slopes";
  for (const std::string command :
       {"respond reed.toml --duration 0.1 --set numerics.elements=10 --output history.csv",
        "squeal reed.toml --settle 5"}) {
    EXPECT_TRUE(holds(run(command).errors, part)) << command;
    EXPECT_FALSE(holds(run(command + " --set beam.axial_force=1.5").errors, part)) << command;
  }
}

TEST_F(HistoryFiles, OfSeveralQuantitiesShareOneFigure) {
  install_gnuplot("echo drawn > $output\n");
  EXPECT_TRUE(holds(run("map damped --set numerics.time_step=1e-3 --duration 0.5 --x frequency=24:26:2 --y "
                        "amplitude=1e-3:2e-3:2 --quantity work,period --output map.csv --figure map.svg")
                        .output,
                    "Drawn in map.svg: work, the first quantity\n"));
}

TEST_F(HistoryFiles, ShowABarOnATerminalUntilTheyAreThere) {
  const std::string options = "respond " + short_steps + "--duration 0.3 ";
  const auto said = on_terminal(options + "--output history.csv");
  if (!said) GTEST_SKIP() << "the system gives no pseudo-terminal";
  EXPECT_TRUE(holds(*said, "\r\033[Kstickslip respond  ["));
  EXPECT_TRUE(holds(*said, "\n3001 rows written to history.csv, one in 100 time steps"));
  EXPECT_FALSE(holds(*on_terminal(options), "\033"));  // not among the rows
  EXPECT_TRUE(holds(*on_terminal("periodic reed"), "stickslip periodic  ["));
  EXPECT_TRUE(holds(*on_terminal("squeal reed"), "stickslip squeal  ["));
}

}  // namespace
}  // namespace stickslip::testing
