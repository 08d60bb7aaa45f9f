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
  // The case that `new` writes with these options.
  [[nodiscard]] data::Case made(const std::string& options) const {
    std::filesystem::remove("my-beam.toml");
    const Outcome outcome = run_line("new my-beam.toml " + options);
    EXPECT_EQ(outcome.status, 0) << options << outcome.errors;
    return data::load_case("my-beam.toml");
  }
};

STICKSLIP_VERIFIES(NewCase, "P1");
TEST_F(NewCase, HoldsTheValuesThatAreSet) {
  const data::Case tube = made(
      "--set section.shape=tube --set 'beam.length=1.2 m' --set 'excitation.acceleration_amplitude=\"1 g\"' "
      "--set damping.ratio=0.02");
  EXPECT_EQ(tube.beam().length(), 1.2);
  EXPECT_EQ(tube.beam().density(), 7850.0);
  EXPECT_NEAR(tube.beam().area(), std::numbers::pi * (25e-6 - 16e-6), 1e-19);
  EXPECT_NEAR(tube.excitation().amplitude(), 9.80665 / std::pow(40.0 * std::numbers::pi, 2), 1e-18);
  EXPECT_EQ(tube.damping.ratio(), 0.02);
  const data::Case numbers = made(
      "--set beam.area=1e-4 --set beam.second_moment_of_area=1e-9 --set 'beam.density=1.2 g/cm^3' --set "
      "beam.youngs_modulus=3e9");
  EXPECT_EQ(numbers.beam().second_moment_of_area(), 1e-9);
  EXPECT_EQ(numbers.beam().density(), 1200.0);
}

// A number is what a case file takes for one, and so what --set of the other commands does.
TEST_F(NewCase, TakesTheNumbersOfACaseFile) {
  for (const auto& [text, value] :
       {std::pair{"+1", 1.0}, {"+1.5e-1", 0.15}, {"1_0.5", 10.5}, {"0x2", 2.0}, {"5e-1", 0.5}}) {
    const std::string set = std::string("beam.length=") + text;
    EXPECT_EQ(made("--set friction.decay=+inf --set beam.axial_force=1e-3 --set " + set).beam().length(),
              value);
    EXPECT_EQ(data::load_case("paper", {data::Override::parse(set)}).beam().length(), value) << text;
  }
  std::filesystem::remove("my-beam.toml");
  for (const std::string text : {".5", "1.", "infinity", "1__0", "'+1 m'", "inf", "-inf", "nan", "+nan"})
    expect_refused("new my-beam.toml --set beam.length=" + text, "beam.length is ");
}

TEST_F(NewCase, HasATableForEachGroupWithComments) {
  (void)made("--set \"section.shape='circle'\" --set friction.decay=0.50 --set damping.ratio=0.02");
  const std::string text = contents("my-beam.toml");
  for (const char* part : {"# A beam of your own. Try: stickslip criterion my-beam.toml\n[beam]\nlength = "
                           "\"400 mm\"               # L, ",
                           "\n\n[section]\nshape = \"circle\"                # rectangle, circle or "
                           "tube\ndiameter = \"10 mm\"   ",
                           "\n\n[friction]\n", "\ndecay = 0.50                    # s/m, how fast",
                           "\n\n[damping]\nratio = 0.02\n\n# The program chooses"})
    EXPECT_TRUE(holds(text, part));
}

TEST_F(NewCase, HasACommentThatBecomesDamping) {
  (void)made("");
  std::string text = contents("my-beam.toml");
  for (const std::string line : {"[damping]", "ratio"}) text.erase(text.find("\n# " + line) + 1, 2);
  EXPECT_EQ(data::parse_case("mine.toml", text).damping.ratio(), 0.01);
}

// Of matrices the files are the user's, and may come later.
TEST_F(NewCase, MayBeAModel) {
  EXPECT_EQ(made("--model mass --set 'model.mass=538 g'").model()->properties().mass, 0.538);
  std::filesystem::remove("my-beam.toml");
  const std::string ratio = "--set damping.ratios=[0.01,0.02] --set wall.with_base=true";
  EXPECT_EQ(run_line("new my-beam.toml --model matrices " + ratio).status, 0);
  expect_refused("criterion my-beam.toml", "m.mtx: cannot be opened for reading");
  for (const char* name : {"m.mtx", "k.mtx"}) {
    std::ofstream file(name);
    file << "%%MatrixMarket matrix coordinate real symmetric\n41 41 41\n";
    for (int row = 1; row <= 41; ++row) file << fmt::format("{0} {0} 1.0\n", row);
  }
  const data::Case rig = made("--model matrices " + ratio);
  EXPECT_EQ(rig.model()->matrices().rows, 41);
  EXPECT_EQ(rig.damping.ratio_of(2), 0.02);
  EXPECT_TRUE(rig.contact.wall.moves_with_base());
  EXPECT_EQ(
      made("--model matrices --set 'model.contact={ rows = [2, 3] }'").model()->matrices().contact.size(),
      2U);
  expect_refused("new other.toml --model plate", "--model is plate, but must be one of mass, matrices");
}

// The second answer is refused and asked again; the others are kept.
TEST_F(NewCase, AsksForWhatIsNotSet) {
  const std::string ask = "'" STICKSLIP_PROGRAM "' new my-beam.toml --ask --set beam.material=glass";
  const Outcome outcome = shell("printf '250 mm\\ntwo\\n\\ncircle\\n8 mm\\n\\n\\n\\n\\n\\n' | " + ask);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(holds(outcome.errors, "\nbeam.length (L, from the clamp to the wall) [400 mm]: "));
  EXPECT_TRUE(holds(outcome.errors, "beam.axial_force is 'two' (a string)"));
  const data::Case problem = data::load_case("my-beam.toml");
  EXPECT_EQ(problem.beam().length(), 0.25);
  EXPECT_EQ(problem.beam().axial_force(), 8.0);
  EXPECT_EQ(problem.beam().density(), 2500.0);
  EXPECT_NEAR(problem.beam().area(), std::numbers::pi * 16e-6, 1e-19);
  std::filesystem::remove("my-beam.toml");
  const Outcome unanswered = shell(ask + " < /dev/null");
  EXPECT_EQ(unanswered.status, 2);
  EXPECT_TRUE(holds(unanswered.errors, "ends before beam.length is answered; nothing is written\n"));
  EXPECT_FALSE(std::filesystem::exists("my-beam.toml"));
}

TEST_F(NewCase, WritesNoOtherThanACaseAndOverNothing) {
  for (const auto& [options, part] :
       {std::pair{"--set beam.lenth=1", "unknown key beam.lenth (did you mean beam.length?)"},
        {"--set section.height=0", "section.height is 0,"},
        {"--set section.width=3mm --set section.shape=circle", "a circle does not have it"},
        {"--set beam.material=glass --set beam.density=1", "must be missing where beam.material is given"}})
    expect_refused(std::string("new my-beam.toml ") + options, part);
  EXPECT_FALSE(std::filesystem::exists("my-beam.toml"));
  (void)made("");
  expect_refused("new my-beam.toml", "but must be a file that does not exist yet");
}

// f_10 of the paper's beam is (10.25 pi)^2 sqrt(16666.7/10)/(2 pi 4) = 1684 Hz, 1/(50 f_10) = 1.19e-5 s; at 500 Hz the
// first mode above 2000 Hz is the 11th (2029 Hz).
STICKSLIP_VERIFIES(DefaultNumerics, "P1");
TEST(DefaultNumerics, FollowTheHighestMode) {
  const data::Case paper = data::load_case("paper");
  const auto at = [&](double hz, double duration) {
    return data::default_numerics(paper.beam(), hz, duration);
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
    EXPECT_EQ(data::default_numerics(data::load_case("paper", {{"beam.length", length}}).beam(),
                                     paper.excitation().frequency_hz(), 10.0)
                  .time_step,
              step)
        << length;
}

class RespondFigure : public Drawing {};

// The same columns of a history and of what is drawn of it.
const Words row_names{"time_s", "base_displacement_m", "tip_displacement_m", "midspan_displacement_m",
                      "friction_force_N"},
    drawn_names{"time", "base", "tip", "midspan", "force"};

// The rows of these columns of a table of numbers.
using Numbers = std::vector<std::vector<double>>;
Numbers numbers_in(const std::string& table, const Words& names) {
  auto columns = columns_of(table);
  Numbers rows(columns[names.front()].size());
  for (const std::string& name : names)
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(std::stod(columns[name].at(i)));
  return rows;
}

STICKSLIP_VERIFIES(RespondFigure, "U1");
TEST_F(RespondFigure, IsDrawnFromTheRowsAndTheLimit) {
  install_gnuplot("cat \"${folder}history.csv\" \"${folder}history-values.csv\" > $output\n");
  const Outcome outcome =
      run_line("respond paper --duration 0.001 --output history.csv --figure history.png");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const std::string drawn = contents("history.png");
  EXPECT_EQ(numbers_in(drawn.substr(0, drawn.find("# Single")), drawn_names),
            numbers_in(contents("history.csv"), row_names));
  EXPECT_TRUE(holds(drawn, "\nlimit,300,N\n")) << drawn;
}

// The rows of a table of numbers under its names.
Numbers numbers(const std::vector<Words>& table) {
  Numbers values;
  for (std::size_t i = 1; i < table.size(); ++i) {
    auto& row = values.emplace_back();
    for (const std::string& cell : table[i]) row.push_back(std::stod(cell));
  }
  return values;
}

// Of more rows than two for each of a thousand columns, the smallest and the largest value of each column in the order in which
// they come, of the rows that stick and of those that slip apart.
TEST_F(RespondFigure, HasTheExtremesOfEachState) {
  install_gnuplot("cat \"${folder}history.csv\" > $output\n");
  using Groups = std::map<std::pair<double, std::string>, Numbers>;
  std::size_t slipping = 0, mixed = 0;
  const auto expect_extremes = [&](const std::string& options, double duration) {
    EXPECT_EQ(run_line("respond " + options + " --every 1 --output history.csv --figure history.png").status,
              0);
    const auto groups_of = [&](const std::string& file, const Words& names) {
      Groups groups;
      const std::string table = contents(file);
      const auto rows = numbers_in(table, names);
      const Words states = columns_of(table)["state"];
      for (std::size_t i = 0; i < rows.size(); ++i)
        groups[{std::floor(rows[i][0] / (duration / 1000.0)), states.at(i)}].push_back(rows[i]);
      return groups;
    };
    const Groups all = groups_of("history.csv", row_names), drawn = groups_of("history.png", drawn_names);
    ASSERT_EQ(all.size(), drawn.size());
    for (const auto& [place, rows] : all) {
      const Numbers& two = drawn.at(place);
      EXPECT_EQ(two.size(), std::min<std::size_t>(rows.size(), 2));
      slipping += place.second == "slip" ? 1 : 0;
      mixed += place.second == "slip" && all.contains({place.first, "stick"}) ? 1 : 0;
      for (std::size_t i = 1; i < rows[0].size(); ++i) {
        const auto [least, most] =
            std::ranges::minmax_element(rows, {}, [&](const auto& row) { return row[i]; });
        // An extreme that comes twice, but for rounding, may stand first or last.
        const bool turns = (*most)[i] - (*least)[i] < 1e-12 * std::abs((*most)[i]) &&
                           two.front()[i] != (*std::min(least, most))[i];
        EXPECT_EQ(two.front()[i], (*(turns ? std::max(least, most) : std::min(least, most)))[i])
            << place.first;
        EXPECT_EQ(two.back()[i], (*(turns ? std::min(least, most) : std::max(least, most)))[i])
            << place.first;
      }
    }
  };
  expect_extremes("paper --hz 70 --duration 0.02 --set numerics.time_step=2e-6", 0.02);
  on_random_cases(3, {.lowest_load = 2.0, .shortest = 3.0, .jump = 0.0}, [&](const CaseText& text, auto&) {
    std::ofstream(path("random.toml")) << text.text();
    const double duration = text.problem().numerics.duration();
    expect_extremes("random.toml --method event-driven --set numerics.time_step=" +
                        data::shortest_text(duration / 4096.0),
                    duration);
  });
  EXPECT_GT(slipping, 300u);
  EXPECT_GT(mixed, 10u);
}

class FigureOfAVerdict : public Drawing {};

// The curve at the frequency of the case is its critical amplitude, to half of the width that is drawn, 1e-3; 16 = 4 x 4.
STICKSLIP_VERIFIES(FigureOfAVerdict, "U1");
TEST_F(FigureOfAVerdict, IsTheCriticalAmplitude) {
  install_gnuplot("cat \"${folder}criterion.csv\" > $output; cat \"${folder}criterion-natural.csv\" > '" +
                  path("marks.csv") + "'; cat \"${folder}criterion-values.csv\" > '" + path("values.csv") +
                  "'\n");
  for (const std::string name : {"paper", "damped", "paper --set beam.shear_stiffness=6410256.41"}) {
    const auto answer = json("criterion " + name + " --hz 35 --figure curve.svg");
    const auto rows = numbers(csv(contents("curve.svg")));
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
  EXPECT_NEAR(numbers(csv(contents("curve.svg"))).back()[0], 1.25 * natural, 1e-12);
}

class FigureOfModes : public Drawing {};

// A held tip has no deflection, a sliding one the largest of its first mode; the mesh has the shapes of the beam.
STICKSLIP_VERIFIES(FigureOfModes, "U1");
TEST_F(FigureOfModes, HasTheShapesByBothMethods) {
  install_gnuplot("cat \"${folder}modes.csv\" > $output\n");
  const auto drawn = [&](const std::string& options) {
    EXPECT_EQ(run_line("modes paper --count 2 --figure modes.pdf " + options).status, 0);
    return numbers(csv(contents("modes.pdf")));
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
  EXPECT_EQ(run_line("modes paper --count 8 --figure modes.pdf").status, 0);
}

}  // namespace
}  // namespace stickslip::testing
