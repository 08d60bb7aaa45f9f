// SPDX-License-Identifier: MIT
/// What `respond` writes and draws by default: enough for the eye, whatever the step and the duration.

#include "support/random_cases.hpp"
#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using Rows = std::vector<std::vector<std::string>>;
using Line = std::vector<std::pair<double, double>>;  // pixels

// The lines of a curve of an SVG figure behind its sample in the legend, which one without a title has not.
std::vector<Line> curve(const std::string& svg, const std::string& title) {
  const std::size_t begin = svg.find("<title>" + title + "</title>"), end = svg.find("</g>\n\t</g>", begin);
  std::vector<Line> lines;
  for (auto path = svg.find(" d='", begin); path < end; path = svg.find(" d='", path + 1)) {
    std::istringstream words(svg.substr(path + 4, svg.find('\'', path + 4) - path - 4));
    for (std::string word; words >> word;) {
      if (word.front() == 'M') lines.emplace_back();
      if (word.front() == 'M' || word.front() == 'L') word.erase(0, 1);
      lines.back().emplace_back(std::stod(word), std::stod(word.substr(word.find(',') + 1)));
    }
  }
  if (!title.starts_with("gnuplot") && !lines.empty()) lines.erase(lines.begin());
  return lines;
}

double range(std::vector<double> values) {
  const auto [least, most] = std::ranges::minmax(values);
  return most - least;
}

std::vector<double> column_of(const Rows& rows, std::size_t column) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(std::stod(row[column]));
  return values;
}

class HistoryFiles : public SignalledRun {
 protected:
  // The rows of the command's history behind the names of the columns.
  [[nodiscard]] Rows rows_of(const std::string& options) const {
    const Outcome outcome = run("respond " + options + " --output history.csv");
    EXPECT_EQ(outcome.status, 0) << options << outcome.errors;
    return rows_in("history.csv");
  }

  [[nodiscard]] static Rows rows_in(const std::string& file) {
    Rows rows = csv(contents(file));
    rows.erase(rows.begin());
    return rows;
  }

  static inline const std::string short_steps =
      "paper --hz 25 --amplitude 1e-3 --set numerics.time_step=1e-6 ";
};

// 100 rows in 0.04 s are 4e-4 s, 20 in a period of 24.97 Hz 2e-3 s: at 0.5 s the 2000 rows decide, 2.5e-4 s.
STICKSLIP_VERIFIES(HistoryFiles, "U1");
TEST_F(HistoryFiles, HaveTheRowsThatAnEyeNeeds) {
  const std::string of_time = "paper --method closed-form --set numerics.time_step=";
  for (const auto& [options, rows] : std::vector<std::pair<std::string, std::size_t>>{
           {short_steps + "--duration 0.5", 2501},  // of 200 steps
           {short_steps + "--duration 1 --method event-driven", 5001},
           {of_time + "1e-6 --hz 250 --duration 0.2", 10'001},  // of 20 steps; 40 would be 4e-5 s
           {short_steps + "--duration 0.5 --rate 700", 701 / 2 + 1},
           {of_time + "1e-4 --duration 0.01 --rate 1e9", 101}})  // each step
    EXPECT_EQ(rows_of(options).size(), rows) << options;
  expect_refused("respond --rate 0", "--rate is 0, but must be from 1e-09 to 1e+12 (1/s)");
  expect_refused("respond --rate 10 --every 10", "--every excludes --rate");
}

TEST_F(HistoryFiles, HaveTheRowsOfAWindow) {
  const auto rows = rows_of(short_steps + "--duration 0.1 --from 0.06 --to 0.061 --events events.csv");
  ASSERT_EQ(rows.size(), 1001u);  // each step
  EXPECT_EQ(rows.front()[0], "0.06");
  EXPECT_EQ(rows.back()[0], "0.061");
  EXPECT_LT(std::stod(rows_in("events.csv").front()[0]), 0.06);
  expect_refused("respond --duration 0.1 --from 0.2", "--from is 0.2, but must be below the duration, 0.1 s");
  expect_refused("respond --duration 0.1 --from 0.05 --to 0.05",
                 "--to is 0.05, but must be above --from, 0.05 s, and at most the duration, 0.1 s");
}

TEST_F(HistoryFiles, LoseNoExtremeBetweenTheirRows) {
  const std::string options = "respond " + short_steps + "--duration 0.08 --output history.csv ";
  const auto all = json(options + "--every 1"),
             few =
                 nlohmann::json::parse(run(options + "--every 4001 --json").output);  // a process of its own
  EXPECT_EQ(few["rows"], 20);
  for (const char* key : {"largest_friction_force_N", "largest_deflection_m", "first_slip_s"})
    EXPECT_EQ(all[key], few[key]) << key;
  EXPECT_EQ(few["time_steps_in_a_row"], 4001);
  EXPECT_TRUE(few["program"].get<std::string>().starts_with("stickslip "));
  EXPECT_TRUE(few["command"].get<std::string>().ends_with(options + "--every 4001 --json"));
}

// To a pixel: the curves reach as far as the rows of the file, and the force is thick where the events say that the tip slips.
TEST_F(HistoryFiles, AreDrawnAsTheyAre) {
  int thick = 0;
  on_random_cases(3, {.lowest_load = 1.5, .shortest = 2.0, .longest = 6.0}, [&](const CaseText& text, auto&) {
    std::ofstream("random.toml") << text.text();
    const auto rows =
        rows_of("random.toml --method event-driven --events events.csv --figure drawn.svg --size 12x8");
    const std::string svg = contents("drawn.svg");
    EXPECT_TRUE(holds(svg, "width=\"453\" height=\"302\""));  // 96 pixels in 2.54 cm
    const auto of = [&](std::size_t column) { return column_of(rows, column); };
    const auto height = [&](const char* title) {
      std::vector<double> ys;
      for (const Line& line : curve(svg, title))
        for (const auto& [x, y] : line) ys.push_back(y);
      return range(ys);
    };
    const double scale = height("base") / range(of(1));
    EXPECT_NEAR(height("tip"), scale * range(of(2)), 1.0);
    EXPECT_NEAR(height("midspan"), scale * range(of(3)), 1.0);

    const auto level = [&](const char* title) { return curve(svg, title).back().front().second; };
    const data::Case problem = text.problem();
    const double limit = problem.contact.friction.static_coefficient() * problem.beam().axial_force();
    EXPECT_NEAR(height("stick"), (level("gnuplot_plot_5b") - level("limit")) * range(of(5)) / (2.0 * limit),
                1.0);

    const Line whole = curve(svg, "stick").front();
    EXPECT_LT(whole.size(), 4000u);
    const auto [left, right] = std::pair(whole.front().first, whole.back().first);
    const auto slips = curve(svg, "slip");
    const auto times = of(0);
    const double pixel = (times.back() - times.front()) / (right - left);
    const Rows events = rows_in("events.csv");
    for (double x = left; x <= right; x += 0.5) {
      const double time = times.front() + pixel * (x - left);
      bool is_at_an_event = false, slips_then = false;
      for (const auto& event : events) {
        is_at_an_event = is_at_an_event || std::abs(std::stod(event[0]) - time) < 1.5 * pixel;
        if (std::stod(event[0]) < time) slips_then = event[1] != "capture";
      }
      const bool is_thick = std::ranges::any_of(
          slips, [x = x](const Line& line) { return line.front().first <= x && x <= line.back().first; });
      if (is_at_an_event) continue;
      ASSERT_EQ(is_thick, slips_then) << time;
      thick += is_thick;
    }
  });
  EXPECT_GT(thick, 100);
}

// The first slip that the record of `road` begins, to a pixel, on the force that would hold the contact; and the window of its film.
TEST_F(HistoryFiles, DrawAndFilmTheFirstSlip) {
  const std::string road = " road --set excitation.scale=3 --json ";
  const auto found = nlohmann::json::parse(run("criterion" + road + "--figure held.svg").output);
  const double first = found["first_slip_s"], duration = found["duration_s"];
  const std::string svg = contents("held.svg");
  const Line held = curve(svg, "held").front(), slip = curve(svg, "first slip").front();
  const double left = held.front().first, right = held.back().first;
  EXPECT_NEAR(slip.front().first, left + first / duration * (right - left), 1.0);

  install_gnuplot(draw_all);
  const auto film = nlohmann::json::parse(run("animate" + road + "--frames 3 --output film").output);
  EXPECT_EQ(film["method"], "event-driven");
  EXPECT_TRUE(holds(run("animate --hz 25 --amplitude 1e-3 --duration 0.1 --frames 3 --output beam").output,
                    "\nfe: "));
  const Rows rows = rows_in("film/motion.csv");
  const double from = film["from_s"], length = film["duration_s"];
  EXPECT_NEAR(from + 0.5 * length, first, 1e-9);
  EXPECT_NEAR(std::stod(rows.front()[1]), from, 1e-4);
  EXPECT_NEAR(std::stod(rows.back()[1]), from + length, 1e-4);
}

TEST_F(HistoryFiles, HaveTheColumnsThatAreAskedFor) {
  const auto last = rows_of("road --duration 0.1 --columns clamp-moment,base-reaction").back();
  ASSERT_EQ(last.size(), 9U);                                             // in the order of the list
  EXPECT_GT(std::abs(std::stod(last[7])), std::abs(std::stod(last[8])));  // N and N m of a beam of 2 m
  EXPECT_TRUE(holds(contents("history.csv"), "friction_force_N,state,base_reaction_N,clamp_moment_N_m\n"));
  expect_refused("respond sdnd100 --columns clamp-moment", "--columns is clamp-moment, but must be left out");
}

// By the smallest and largest values in each of a thousand columns.
TEST_F(HistoryFiles, AreDrawnFromFewRows) {
  install_gnuplot("cat \"${folder}history.csv\" > $output\n");
  const auto all = rows_of(short_steps + "--duration 0.08 --every 1 --figure drawn.svg");
  const auto drawn = rows_in("drawn.svg");
  EXPECT_LT(drawn.size(), 2100u);
  for (const std::size_t column : {1u, 2u, 3u, 5u})
    EXPECT_EQ(range(column_of(drawn, column)), range(column_of(all, column)));
}

// The motion is that of the window with the most slips; a mark for each window that has some.
TEST_F(HistoryFiles, AreDrawnWithTheirWindows) {
  const std::string nvh = "nvh rough-road --set excitation.scale=1.8 --json --figure drawn.svg";
  const auto answer = nlohmann::json::parse(run(nvh).output);
  const std::string svg = contents("drawn.svg");
  const auto marks = [&](const std::string& title) {  // but for that in the legend
    int count = -1;
    const std::size_t begin = svg.find("<title>" + title + "</title>"), end = svg.find("</g>\n\t</g>", begin);
    for (auto use = svg.find("<use", begin); use < end; use = svg.find("<use", use + 1)) ++count;
    return count;
  };
  install_gnuplot("cat \"${folder}history-windows.csv\" \"${folder}history.csv\" > $output\n");
  EXPECT_EQ(run(nvh).status, 0);
  const Rows rows = rows_in("drawn.svg");
  int with_slips = 0;
  double slips = 0.0, most = 0.0, from = -1.0, ranges = 0.0;
  for (std::size_t i = 0; i < 10; ++i) {
    const double of_window = std::stod(rows[i][1]);
    with_slips += of_window > 0.0 ? 1 : 0;
    slips += of_window, ranges += std::stod(rows[i][2]) / 10.0;
    if (of_window > most) most = of_window, from = std::stod(rows[i][0]);
  }
  EXPECT_TRUE(with_slips > 0 && with_slips < 10) << with_slips;
  EXPECT_EQ(slips, answer["slips"]);
  EXPECT_NEAR(ranges, answer["peak_to_peak_m"]["value"], 1e-12);
  EXPECT_NEAR(std::stod(rows[11][0]), from, 1e-4);  // a row step is 9e-5 s
  EXPECT_NEAR(std::stod(rows.back()[0]), from + 1.0, 1e-4);
  EXPECT_LT(rows.size(), 4100u);
  EXPECT_EQ(marks("windows"), with_slips);
  EXPECT_EQ(marks("at left"), 1);
}

// The wall moves by a W^-2 sin(W t + pi) with a = 15 m/s^2 beside the base.
TEST_F(HistoryFiles, AreDrawnWithAWallThatHasTheBase) {
  install_gnuplot("cat \"${folder}history.csv\" > $output\n");
  EXPECT_GT(
      rows_of("sdnd104 --set wall.with_base=true --amplitude 0.01 --duration 1 --figure drawn.svg").size(),
      100u);
  constexpr double turn = 2.0 * std::numbers::pi;
  for (const auto& row : rows_in("drawn.svg"))
    EXPECT_NEAR(std::stod(row[4]) - std::stod(row[1]),
                -15.0 / (turn * turn) * std::sin(turn * std::stod(row[0])), 1e-10);
}

// Slips every 0.042 s, and columns of 0.1 s.
TEST_F(HistoryFiles, AreDrawnWithFewBands) {
  install_gnuplot("cat \"${folder}history-slips.csv\" > $output\n");
  EXPECT_GT(
      rows_of("squeak-stand --method event-driven --duration 100 --events events.csv --figure drawn.svg")
          .size(),
      2000u);
  const Rows events = rows_in("events.csv"), bands = rows_in("drawn.svg");
  EXPECT_GT(events.size(), 4000u);
  EXPECT_EQ(bands.size(), 1u);
  EXPECT_EQ(bands.back()[0], "0");  // the first slip is in the first column
  EXPECT_EQ(bands.back()[1], events.back()[1] == "capture" ? events.back()[0] : "100");
}

TEST_F(HistoryFiles, AreDrawnInASizeThatHoldsThem) {
  for (const std::string size : {"12", "3x12", "12x101"})
    expect_refused("criterion paper --figure a.png --size " + size,
                   "--size is " + size + ", but must be WIDTHxHEIGHT");
  expect_refused("criterion paper --size 12x8", "--size requires --figure");
  install_gnuplot(
      "echo drawn > $output; [ $chosen_width = 4.5 ] || echo 'difficulty fitting plot titles into key' "
      ">&2\n");
  expect_refused("criterion paper --figure a.png --size 4x4",
                 "--size is 4x4, but must be at least 4.5x4.5 for all labels of this figure");
  for (const std::string font : {"Times", ",9", "Times,3", "Times,9pt"})
    expect_refused("criterion paper --figure a.png --font " + font,
                   "--font is " + font + ", but must be NAME,SIZE, a size of 4 to 40 points");
  install_gnuplot("echo drawn > $output\n");
  EXPECT_TRUE(holds(run("map damped --set numerics.time_step=1e-3 --duration 0.5 --x frequency=24:26:2 --y "
                        "amplitude=1e-3:2e-3:2 --quantity work,period --output map.csv --figure map.svg")
                        .output,
                    "Drawn in map.svg: work, the first quantity\n"));
}

// 3 w/(2 L) of a cantilever: 27/8 (w/L)^2 is above 5 % from 12.2 % of the length on.
TEST_F(HistoryFiles, WarnOfALargeDeflection) {
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

TEST_F(HistoryFiles, ShowABarUntilTheyAreThere) {
  const std::string options = "respond " + short_steps + "--duration 0.3 ",
                    bar = "\r\033[Kstickslip respond  [";
  const auto said = on_terminal(options + "--output history.csv");
  if (!said) GTEST_SKIP() << "the system gives no pseudo-terminal";
  EXPECT_EQ(said->status, 0);
  EXPECT_TRUE(holds(said->output, bar));
  EXPECT_LT(said->output.rfind(bar), said->output.rfind("\r\033[K"));  // which erases it
  EXPECT_TRUE(holds(said->output, "\n3001 rows written to history.csv, one in 100 time steps"));
  // Once there is a pace, the share of so long a run is below 1 %.
  EXPECT_TRUE(holds(on_terminal("respond --duration 1e5 --output history.csv", " left")->output, "]  0 %  "));
  for (const std::string& none :
       {options, "--quiet " + options + "--output h.csv", options + "--quiet --output h.csv"})
    EXPECT_FALSE(holds(on_terminal(none)->output, "\033")) << none;
}

}  // namespace
}  // namespace stickslip::testing
