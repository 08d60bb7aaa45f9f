// SPDX-License-Identifier: MIT
/// `new`: the case that it writes is the one that was asked for. And what a case without [numerics] gives.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/data/case_file.hpp"
#include "support/command_line.hpp"
#include "support/random_cases.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

class NewCase : public CommandLine {
 protected:
  [[nodiscard]] std::string command(const std::string& options = "") const {
    return "new my-beam.toml " + options;
  }
};

STICKSLIP_VERIFIES(NewCase, "P1");
TEST_F(NewCase, HoldsTheValuesThatAreSet) {
  const Outcome outcome =
      run(command("--set section.shape=tube --set 'beam.length=1.2 m' --set "
                  "'excitation.acceleration_amplitude=\"1 g\"' --set damping.ratio=0.02"));
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(outcome.output.ends_with("whether it slips: stickslip criterion my-beam.toml\n"));
  const data::Case problem = data::load_case("my-beam.toml");
  EXPECT_EQ(problem.beam.length(), 1.2);
  EXPECT_EQ(problem.beam.density(), 7850.0);
  EXPECT_NEAR(problem.beam.area(), std::numbers::pi * (25e-6 - 16e-6), 1e-19);
  EXPECT_NEAR(problem.excitation.amplitude(), 9.80665 / std::pow(40.0 * std::numbers::pi, 2), 1e-18);
  EXPECT_EQ(problem.damping.ratio(), 0.02);
  EXPECT_EQ(run("criterion my-beam.toml").status, 0);
}

// A number is what a case file takes for one, and so what --set of the other commands does.
TEST_F(NewCase, TakesTheNumbersOfACaseFile) {
  for (const auto& [text, value] :
       {std::pair{"+1", 1.0}, {"+1.5e-1", 0.15}, {"1_0.5", 10.5}, {"0x2", 2.0}, {"5e-1", 0.5}}) {
    const std::string set = std::string("--set beam.length=") + text;
    ASSERT_EQ(run(command(set + " --set friction.decay=+inf --set beam.axial_force=1e-3")).status, 0) << text;
    EXPECT_EQ(data::load_case("my-beam.toml").beam.length(), value) << text;
    EXPECT_EQ(data::load_case("paper", {data::Override::parse(set.substr(6))}).beam.length(), value) << text;
    std::filesystem::remove("my-beam.toml");
  }
  for (const std::string text : {".5", "1.", "infinity", "1__0", "'+1 m'"})
    expect_refused(command("--set beam.length=" + text), "a string), but must be a number (m) or a text of");
  for (const std::string text : {"inf", "-inf", "nan", "+nan"})
    expect_refused(command("--set beam.length=" + text), "but must be a finite number above 0 (m)");
}

TEST_F(NewCase, HasATableForEachGroupOfKeysWithComments) {
  ASSERT_EQ(
      run(command("--set \"section.shape='circle'\" --set friction.decay=0.50 --set damping.ratio=0.02"))
          .status,
      0);
  const std::string text = contents("my-beam.toml");
  EXPECT_TRUE(
      text.starts_with("# A beam of your own. Try: stickslip criterion my-beam.toml\n[beam]\nlength = \"400 "
                       "mm\"               # L, from the clamp to the wall\n"))
      << text;
  EXPECT_TRUE(holds(text,
                    "\n\n[section]\nshape = \"circle\"                # rectangle, circle or tube\n"
                    "diameter = \"10 mm\"              # outside\n\n[friction]\n"));
  EXPECT_TRUE(holds(text, "\ndecay = 0.50                    # s/m, how fast"));
  EXPECT_TRUE(holds(text, "\n\n[damping]\nratio = 0.02\n\n# The program chooses"));
}

TEST_F(NewCase, HasACommentThatBecomesDamping) {
  ASSERT_EQ(run(command()).status, 0);
  std::string text = contents("my-beam.toml");
  for (const std::string line : {"[damping]", "ratio"}) {
    const auto at = text.find("\n# " + line);
    ASSERT_NE(at, std::string::npos) << text;
    text.erase(at + 1, 2);
  }
  EXPECT_EQ(data::parse_case("mine.toml", text).damping.ratio(), 0.01);
}

TEST_F(NewCase, ReplacesASectionOrAMaterialByNumbers) {
  ASSERT_EQ(run(command("--set beam.area=1e-4 --set beam.second_moment_of_area=1e-9 --set "
                        "'beam.density=1.2 g/cm^3' --set beam.youngs_modulus=3e9"))
                .status,
            0);
  const data::Case problem = data::load_case("my-beam.toml");
  EXPECT_EQ(problem.beam.second_moment_of_area(), 1e-9);
  EXPECT_EQ(problem.beam.density(), 1200.0);
}

// The second answer is refused and asked again; the others are kept.
TEST_F(NewCase, AsksForWhatIsNotSet) {
  const std::string program = std::string("'") + STICKSLIP_PROGRAM + "' ";
  const std::string ask = program + command("--ask --set beam.material=glass");
  const Outcome outcome = shell("printf '250 mm\\ntwo\\n\\ncircle\\n8 mm\\n\\n\\n\\n\\n\\n' | " + ask);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(
      outcome.errors.starts_with("Enter keeps the value in brackets.\n"
                                 "beam.length (L, from the clamp to the wall) [400 mm]: "))
      << outcome.errors;
  EXPECT_TRUE(holds(outcome.errors, "beam.axial_force is 'two' (a string)"));
  const data::Case problem = data::load_case("my-beam.toml");
  EXPECT_EQ(problem.beam.length(), 0.25);
  EXPECT_EQ(problem.beam.axial_force(), 8.0);
  EXPECT_EQ(problem.beam.density(), 2500.0);
  EXPECT_NEAR(problem.beam.area(), std::numbers::pi * 16e-6, 1e-19);
}

TEST_F(NewCase, WritesNothingThatIsNoCaseAndOverwritesNothing) {
  expect_refused(command("--set beam.lenth=1"), "unknown key beam.lenth (did you mean beam.length?)");
  expect_refused(command("--set section.height=0"),
                 "section.height is 0, but must be a finite number above 0");
  expect_refused(command("--set section.width=3mm --set section.shape=circle"), "a circle does not have it");
  expect_refused(command("--set beam.material=glass --set beam.density=1"),
                 "must be missing where beam.material is given");
  const Outcome unanswered = run(command("--ask") + " < /dev/null");
  EXPECT_EQ(unanswered.status, 2);
  EXPECT_TRUE(unanswered.errors.ends_with(
      "stickslip: standard input ends before beam.length is answered; nothing is written\n"))
      << unanswered.errors;
  EXPECT_FALSE(std::filesystem::exists("my-beam.toml"));
  ASSERT_EQ(run(command()).status, 0);
  expect_refused(command(), "but must be a file that does not exist yet");
}

// f_10 of the paper's beam is (10.25 pi)^2 sqrt(16666.7/10)/(2 pi 4) = 1684 Hz, 1/(50 f_10) = 1.19e-5 s; at 500 Hz the
// first mode above 2000 Hz is the 11th (2029 Hz).
STICKSLIP_VERIFIES(DefaultNumerics, "P1");
TEST(DefaultNumerics, FollowTheHighestModeThatMatters) {
  const data::Case paper = data::load_case("paper");
  const auto at = [&](double hz, double duration) {
    return data::default_numerics(
        paper.beam, data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1e-3}), duration);
  };
  EXPECT_EQ(at(25.0, 10.0).elements, 40);
  EXPECT_EQ(at(25.0, 10.0).time_step, 1e-5);
  EXPECT_EQ(at(25.0, 10.0).modes, 10);
  EXPECT_EQ(at(25.0, 10.0).spectral_radius, 0.9);
  EXPECT_EQ(at(25.0, 10.0).velocity_threshold, 0.0);
  EXPECT_EQ(at(25.0, 10.0).duration, 10.0);
  EXPECT_EQ(at(421.0, 10.0).modes, 10);  // f_10/4 = 421.09 Hz
  EXPECT_EQ(at(421.2, 10.0).modes, 11);
  EXPECT_EQ(at(500.0, 10.0).modes, 11);
  EXPECT_EQ(at(500.0, 10.0).elements, 44);
  EXPECT_EQ(at(25.0, 2e-6).time_step, 2e-6);
  EXPECT_EQ(at(25.0, std::nextafter(1e-6, 0.0)).time_step, 5e-7);  // at most the duration
  for (const double none : {0.0, -1.0, std::nan("")}) EXPECT_EQ(at(25.0, none).time_step, 1e-5) << none;
  EXPECT_EQ(at(1e9, 10.0).modes, 200);
  // 1/(50 f_10) grows with the square of the length: 1.90e-5 s, 2.10e-5 s, 4.87e-5 s and 5.24e-5 s.
  for (const auto& [length, step] :
       {std::pair{"2.53", 1e-5}, {"2.66", 2e-5}, {"4.05", 2e-5}, {"4.2", 5e-5}, {"1e5", 10.0}})
    EXPECT_EQ(data::default_numerics(data::load_case("paper", {{"beam.length", length}}).beam,
                                     paper.excitation, 10.0)
                  .time_step,
              step)
        << length;
}

class DefaultRuns : public CommandLine {};

STICKSLIP_VERIFIES(DefaultRuns, "X9");
TEST_F(DefaultRuns, OfTheDampedCaseAgreeWithTheReferenceData) {
  ASSERT_EQ(run("respond damped --output history.csv --events events.csv").status, 0);
  const Outcome outcome = run("compare stick-slip-history history.csv --events events.csv");
  EXPECT_EQ(outcome.status, 0) << outcome.output << outcome.errors;
}

// With a threshold above 0 a slip that begins is taken for a stick at the end of a step that is short enough, with
// an impact: there are more changes.
TEST_F(DefaultRuns, ConvergeOnlyWithoutAVelocityThreshold) {
  const auto run_with = [&](const std::string& step, const std::string& threshold) {
    return json("respond damped --set numerics.time_step=" + step +
                " --set numerics.velocity_threshold=" + threshold + " --output history.csv");
  };
  for (const std::string step : {"2e-5", "1e-5", "5e-6"}) {
    const auto answer = run_with(step, "0");
    EXPECT_EQ(answer["changes_of_contact"], 47) << step;
    EXPECT_LE(answer["largest_friction_force_N"], 300.0) << step;
  }
  EXPECT_GT(run_with("5e-6", "1e-4")["changes_of_contact"], 47);
}

class RespondFigure : public Drawing {};

STICKSLIP_VERIFIES(RespondFigure, "U1");
TEST_F(RespondFigure, IsDrawnFromTheRowsAndTheLimit) {
  install_gnuplot("cat \"${folder}history.csv\" \"${folder}history-values.csv\" > $output\n");
  const Outcome outcome = run("respond paper --duration 0.001 --output history.csv --figure history.png");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const std::string drawn = contents("history.png");
  EXPECT_EQ(drawn.find(contents("history.csv").substr(contents("history.csv").find('\n') + 1)), 0u);
  EXPECT_TRUE(drawn.ends_with("limit,300,N\n")) << drawn;
  EXPECT_TRUE(
      drawn.starts_with("time_s,base_displacement_m,tip_displacement_m,midspan_displacement_m,"
                        "sliding_velocity_m_per_s,friction_force_N,state\n0,0,0,0,0,0,stick\n"));
  expect_refused("respond paper --duration 0.001 --figure a.jpg", "--figure is 'a.jpg'");
  for (const std::string other : {"--output", "--events", "--spectrum"})
    expect_refused("respond paper " + other + " b.png --figure b.png",
                   "--figure is b.png, but must be another file than " + other);
}

// Of more rows than two for each of a thousand columns, the smallest and the largest value of each column in the order in which
// they come, of the rows that stick and of those that slip apart.
TEST_F(RespondFigure, OfManyRowsHasTheExtremesOfEachState) {
  install_gnuplot("cat \"${folder}history.csv\" > $output\n");
  std::size_t slipping = 0, mixed = 0;
  const auto expect_extremes = [&](const std::string& options, double duration) {
    const Outcome outcome =
        run("respond " + options + " --every 1 --output history.csv --figure history.png");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto rows = csv(contents("history.csv")), drawn = csv(contents("history.png"));
    ASSERT_GT(rows.size(), 3000u);
    std::size_t at = 1;
    for (std::size_t first = 1, end = 1; first < rows.size(); first = end) {
      const auto column = [&](std::size_t row) {
        return std::floor(std::stod(rows[row][0]) / (duration / 1000.0));
      };
      std::vector<std::vector<std::vector<std::string>>> states;  // rows of a column with one state
      for (end = first; end < rows.size() && column(end) == column(first); ++end) {
        auto of =
            std::ranges::find(states, rows[end].back(), [](const auto& same) { return same.front().back(); });
        if (of == states.end()) of = states.emplace(states.end());
        of->push_back(rows[end]);
      }
      mixed += states.size() > 1 ? 1 : 0;
      for (const auto& same : states) {
        const std::size_t count = std::min<std::size_t>(same.size(), 2);
        ASSERT_LE(at + count, drawn.size());
        slipping += same.front().back() == "slip" ? 1 : 0;
        for (std::size_t i = 1; i + 1 < rows[0].size(); ++i) {
          const auto cell = [&](const auto& row) { return std::stod(row[i]); };
          const auto [least, most] = std::minmax_element(
              same.begin(), same.end(), [&](const auto& a, const auto& b) { return cell(a) < cell(b); });
          // An extreme that comes twice, but for rounding, may stand first or last.
          const bool turned = cell(*most) - cell(*least) < 1e-12 * std::abs(cell(*most)) &&
                              drawn[at][i] == std::max(least, most)->at(i);
          EXPECT_EQ(drawn[turned ? at + count - 1 : at][i], std::min(least, most)->at(i)) << same.front()[0];
          EXPECT_EQ(drawn[turned ? at : at + count - 1][i], std::max(least, most)->at(i)) << same.front()[0];
        }
        for (std::size_t k = 0; k < count; ++k, ++at) EXPECT_EQ(drawn[at].back(), same.front().back());
      }
    }
    EXPECT_EQ(at, drawn.size());
  };
  expect_extremes("paper --hz 70 --duration 0.02 --set numerics.time_step=2e-6", 0.02);
  on_random_cases(3, {.lowest_load = 2.0, .shortest = 3.0, .jump = 0.0}, [&](const CaseText& text, auto&) {
    std::ofstream(path("random.toml")) << text.text();
    const double duration = text.problem().numerics.duration();
    expect_extremes(fmt::format("random.toml --method event-driven --set numerics.time_step={}",
                                data::shortest_text(duration / 4096.0)),
                    duration);
  });
  EXPECT_GT(slipping, 300u);
  EXPECT_GT(mixed, 10u);
}

// The rows of a table of numbers under its names.
std::vector<std::vector<double>> numbers(const std::string& table) {
  auto rows = csv(table);
  std::vector<std::vector<double>> values;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    auto& row = values.emplace_back();
    for (const auto& cell : rows[i]) row.push_back(std::stod(cell));
  }
  return values;
}

class FigureOfAVerdict : public Drawing {};

// The curve at the frequency of the case is its critical amplitude, to half of the width that is drawn, 1e-3; 16 = 4 x 4.
STICKSLIP_VERIFIES(FigureOfAVerdict, "U1");
TEST_F(FigureOfAVerdict, IsTheCriticalAmplitudeAroundTheFrequency) {
  install_gnuplot("cat \"${folder}criterion.csv\" > $output; cat \"${folder}criterion-natural.csv\" > '" +
                  path("marks.csv") + "'; cat \"${folder}criterion-values.csv\" > '" + path("values.csv") +
                  "'\n");
  for (const std::string name : {"paper", "damped", "paper --set beam.shear_stiffness=6410256.41"}) {
    const auto answer = json("criterion " + name + " --hz 35 --figure curve.svg");
    const auto rows = numbers(contents("curve.svg"));
    ASSERT_EQ(rows.size(), 241u + 2u);  // two natural frequencies are among them
    EXPECT_TRUE(std::ranges::is_sorted(rows));
    EXPECT_NEAR(rows[0][0], 35.0 / 4.0, 1e-13);
    EXPECT_NEAR(rows.back()[0], 35.0 * 4.0, 1e-12);
    const auto here =
        std::ranges::find_if(rows, [](const auto& row) { return std::abs(row[0] - 35.0) < 1e-9; });
    ASSERT_NE(here, rows.end());
    const double critical = answer["critical_amplitude_m"].get<double>();
    EXPECT_NEAR((*here)[1], critical, 0.5e-3 * critical) << name;
    EXPECT_TRUE(holds(contents("marks.csv"), name.ends_with("41") ? "24.724" : "24.971958"));
    EXPECT_TRUE(holds(contents("values.csv"), "excitation_frequency,35,Hz"));
  }
  const double natural =
      json("criterion paper --hz 5 --figure curve.svg")["nearest_natural_frequency"]["frequency_hz"];
  EXPECT_NEAR(numbers(contents("curve.svg")).back()[0], 1.25 * natural, 1e-12);
  expect_refused("criterion paper --figure a.jpg", "--figure is 'a.jpg'");
}

class FigureOfModes : public Drawing {};

// A held tip has no deflection, a sliding one the largest of its first mode; the mesh has the shapes of the beam.
STICKSLIP_VERIFIES(FigureOfModes, "U1");
TEST_F(FigureOfModes, HasTheShapesByBothMethods) {
  install_gnuplot("cat \"${folder}modes.csv\" > $output\n");
  const auto drawn = [&](const std::string& options) {
    EXPECT_EQ(run("modes paper --count 2 --figure modes.pdf " + options).status, 0);
    return numbers(contents("modes.pdf"));
  };
  for (const std::string state : {"stick", "slip"}) {
    const auto exact = drawn("--state " + state), mesh = drawn("--method fe --state " + state);
    ASSERT_EQ(exact.size(), 401u);
    ASSERT_EQ(mesh.size(), exact.size());
    // Twenty elements and betabar L = 7.1: Hermite interpolation of mode 2 is wrong by (betabar h)^4/384 = 4.1e-5, and
    // its nodes are by (betabar h)^4/1440 of the slope of the shape over the frequency, betabar x < 7.1: 7.7e-5.
    for (std::size_t i = 0; i < exact.size(); ++i)
      for (std::size_t n = 0; n < 3; ++n)
        EXPECT_NEAR(exact[i][n], mesh[i][n], 1.2e-4) << state << " row " << i;
    EXPECT_NEAR(exact.back()[1], state == "slip" ? 1.0 : 0.0, 1e-12);
    if (state == "stick") {
      EXPECT_TRUE(holds(contents("modes.pdf"), ",1: 24.972 Hz"));
    }
  }
  EXPECT_EQ(run("modes paper --count 8 --figure modes.pdf").status, 0);
  expect_refused("modes paper --count 9 --figure a.png", "--count is 9, but must be at most 8 with --figure");
}

class CriterionOutlook : public CommandLine {};

// The blade of the manual: its first natural frequency is 33.742 Hz, and a tenth less length moves it most.
STICKSLIP_VERIFIES(CriterionOutlook, "U1");
TEST_F(CriterionOutlook, IsTheMarginTheNearestFrequencyAndTheBestChange) {
  ASSERT_EQ(run("new blade.toml").status, 0);
  const std::string blade = "criterion blade.toml ";
  const auto answer = json(blade);
  const auto& change = answer["best_change"];
  EXPECT_NEAR(answer["margin"]["lower"].get<double>(),
              4.0 / answer["all_modes"]["force_max_N"]["upper"].get<double>(), 1e-15);
  EXPECT_NEAR(answer["margin"]["upper"].get<double>(),
              4.0 / answer["all_modes"]["force_max_N"]["lower"].get<double>(), 1e-15);
  EXPECT_EQ(answer["nearest_natural_frequency"]["mode"], 1);
  EXPECT_NEAR(answer["nearest_natural_frequency"]["frequency_hz"].get<double>(), 33.74205445636756, 1e-12);
  EXPECT_NEAR(answer["nearest_natural_frequency"]["relative_distance"].get<double>(), 0.6871027, 1e-7);
  EXPECT_EQ(change["key"], "beam.length");
  EXPECT_EQ(change["factor"], 0.9);
  for (const std::string key : {"beam.length=0.44", "section.height=1.65e-3", "beam.axial_force=7.2",
                                "beam.axial_force=8.8", "friction.static_coefficient=0.55"}) {
    const auto other = json(blade + "--set " + key);
    EXPECT_LT(other["friction_limit_N"].get<double>() / other["force_max_N"]["upper"].get<double>(),
              change["margin"].get<double>())
        << key;
  }
  EXPECT_EQ(json(blade + "--set friction.kinetic_coefficient=0.5")["best_change"], change);
  const auto at_rest = json(blade + "--amplitude 0");
  for (const char* key : {"margin", "best_change"}) EXPECT_TRUE(at_rest.at(key).is_null()) << key;
}

}  // namespace
}  // namespace stickslip::testing
