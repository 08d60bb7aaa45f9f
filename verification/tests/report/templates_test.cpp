// SPDX-License-Identifier: MIT
/// The templates of the report: what is filled in, what is refused, and the numbers that are drawn from studies.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/document.hpp"
#include "render/figures.hpp"
#include "render/findings.hpp"
#include "render/json_text.hpp"
#include "render/output_folder.hpp"
#include "render/report.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/paper.hpp"
#include "support/error_message.hpp"
#include "support/requirements.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A folder of templates with the renderer of the report and one template, and a folder of values.
class ReportTemplates : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(values());
    fs::create_directories(templates_ / "figures");
    fs::create_directories(templates_ / "report");
    fs::create_directories(templates_ / "site");
    fs::copy(report::templates_directory() / "report" / "render.py", templates_ / "report");
    fs::copy(report::templates_directory() / "report" / "macros.jinja", templates_ / "report");
    ::setenv("STICKSLIP_REPORTS", templates_.c_str(), 1);
    data::write_text(values() / "tests.json", "[]");
    fs::create_directories(folder_ / "verification" / "mutants");
    data::write_text(folder_ / "verification" / "mutants" / "summary.csv", "part,killed\n");
    data::write_text(folder_ / "verification" / "mutants" / "survivors.toml", "equivalent = []\n");
    data::write_text(folder_ / "verification" / "acceptance.toml", "result = []\n");
    fs::create_directories(folder_ / "verification" / "benchmarks" / "results");
    data::write_text(folder_ / "verification" / "benchmarks" / "comparisons.toml", "comparison = []\n");
    data::write_text(folder_ / "verification" / "benchmarks" / "results" / "speed.json",
                     R"({"context": {"processor": "one"}, "benchmarks": []})");
    fs::create_directories(folder_ / "verification" / "peers");
    data::write_text(folder_ / "verification" / "peers" / "scoreboard.csv", "code,verdict\n");
  }
  void TearDown() override {
    ::unsetenv("STICKSLIP_REPORTS");
    fs::remove_all(folder_);
  }

  [[nodiscard]] fs::path values() const { return folder_ / "values"; }

  /// What a template becomes.
  [[nodiscard]] std::string filled_in(const std::string& text) const {
    data::write_text(templates_ / "report" / "a.tex", text);
    const report::OutputFolder output(folder_ / "output");
    return data::read_text(report::fill_in_templates(values(), output) / "a.tex");
  }

  [[nodiscard]] std::string error_of(const std::string& text) const {
    return testing::error_message_of<std::runtime_error>([&] { (void)filled_in(text); });
  }

  const fs::path folder_ = fs::temp_directory_path() / ("stickslip-templates-" + std::to_string(::getpid()));
  const fs::path templates_ = folder_ / "templates";
};

struct Interval {
  double from{}, to{};
  [[nodiscard]] double length() const { return to - from; }
};
STICKSLIP_JSON(Interval, from, to, length())

STICKSLIP_VERIFIES(ReportTemplates, "U4");
TEST_F(ReportTemplates, ReadEveryDigitOfAResult) {
  const json results{
      {"intervals", std::vector<Interval>{{0.1, 1.0 / 3.0}}},
      {"infinite", std::numeric_limits<double>::infinity()},
      {"nothing", std::optional<double>{}},
  };
  data::write_text(values() / "results.json", report::json_text(results));
  EXPECT_EQ(filled_in("<< results.intervals[0].to | plain >>, << results.intervals[0].length | fixed(3) >>, "
                      "<< results.infinite == 'inf' >>, << results.nothing is none >>"),
            "0.3333333333333333, 0.233, True, True");
}

TEST_F(ReportTemplates, NameAValueThatIsMissing) {
  data::write_text(values() / "results.json", R"({"present": 1})");
  const std::string text = error_of("<< results.present >>\n<< results.absent | fixed(2) >>\n");
  EXPECT_NE(text.find("a.tex, line 2: "), std::string::npos) << text;
  EXPECT_NE(text.find("'absent'"), std::string::npos) << text;
  EXPECT_NE(error_of("<< nowhere.value >>").find("'nowhere' is undefined"), std::string::npos);
}

TEST_F(ReportTemplates, RefuseANumberWithoutDigitsAndOneThatIsNotFinite) {
  data::write_text(values() / "results.json", R"({"value": 0.25, "infinite": "inf"})");
  EXPECT_NE(error_of("\n\n<< results.value >>").find("a.tex, line 3: the number 0.25 has no filter"),
            std::string::npos);
  EXPECT_NE(error_of("<< results.infinite | sig(2) >>").find("inf cannot stand in the report"),
            std::string::npos);
}

TEST_F(ReportTemplates, AreNotBlamedForWhatThePagesOfEvidenceLack) {
  data::write_text(templates_ / "site" / "site.py", "raise SystemExit('a value is missing')\n");
  report::OutputFolder output(folder_ / "output");
  testing::expect_error_message<std::runtime_error>(
      [&] { report::write_site(values(), output); },
      {"the pages of evidence cannot be made: a value is missing"});
}

TEST_F(ReportTemplates, FormatNumbersAndWordsAsTheExamplesInTheRendererSay) {
  ::unsetenv("STICKSLIP_REPORTS");
  for (const fs::path script : {"report/render.py", "site/site.py"}) {
    const std::string command =  // by path: `-m doctest site.py` would take the module site of Python
        "/usr/bin/python3 -I -B -c 'import doctest, importlib.util as util, sys\n"
        "spec = util.spec_from_file_location(\"examples\", sys.argv[1])\n"
        "module = util.module_from_spec(spec)\n"
        "spec.loader.exec_module(module)\n"
        "results = doctest.testmod(module)\n"
        "sys.exit(results.failed > 0 or results.attempted == 0)' '" +
        (report::templates_directory() / script).string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
  }
}

class PaperIndex : public ReportTemplates {};

STICKSLIP_VERIFIES(PaperIndex, "U6");
TEST_F(PaperIndex, HasARequirementOrAClaimForEveryEquationAndFigure) {
  json tests = json::array();
  for (const auto& requirement : testing::requirements())
    tests.push_back({{"source", requirement.source},
                     {"requirement", requirement.id},
                     {"requirement_text", ""},
                     {"named", json::array()},
                     {"tolerances", json::array()}});
  data::write_text(values() / "tests.json", tests.dump());
  EXPECT_EQ(filled_in("<% for kind, count in (('Eq', 30), ('Fig', 14)) %>"
                      "<% for item in indexed(kind, count) if not item.tests and not item.claims %>"
                      "<< kind >> << item.number >> <% endfor %><% endfor %>"),
            "");
}

class TestResults : public ReportTemplates {
 protected:
  void SetUp() override {
    ReportTemplates::SetUp();
    fs::create_directories(xml_ / "cross.Figures");
  }

  void write(const std::string& file, const std::string& suite, const std::string& name,
             const std::string& inside) const {
    data::write_text(xml_ / file, "<?xml version=\"1.0\"?><testsuites><testsuite name=\"" + suite +
                                      "\"><testcase name=\"" + name + "\" classname=\"" + suite +
                                      "\" file=\"verdict_test.cpp\" line=\"25\" status=\"run\">" + inside +
                                      "</testcase></testsuite></testsuites>");
  }

  static std::string property(const std::string& name, const std::string& value) {
    return "<property name=\"" + name + "\" value=\"" + value + "\"/>";
  }

  [[nodiscard]] json read() const { return json::parse(report::read_test_results(xml_)); }

  const fs::path xml_ = folder_ / "xml";
};

STICKSLIP_VERIFIES(TestResults, "U6");
TEST_F(TestResults, HoldRequirementComparisonsAndClaim) {
  write(
      "cross.Figures/Verdict.IsPrinted.xml", "Figures/Verdict", "IsPrinted/4a",
      "<properties>" + property("requirement", "V1") + property("requirement_position", "7") +
          property("requirement_text", "Verdicts are printed.") + property("source", "Fig. 4") +
          property("comparisons", "2") + property("computed", "2.5") + property("expected", "2") +
          property("error", "0.5") + property("tolerance", "1") + property("margin", "0.5") +
          property("class", "reference") + property("derivation", "a datum; of which") +
          property("compared.L1, closed form", "3; 3.125; 0.125; 0.5; 0.25; discretisation; a law; really") +
          property("tolerances.reference", "2; 0.5; 1; 0.5; a datum; of which") + property("claim", "fig4") +
          property("finding", "35 Hz sticks") + "</properties>");
  const json tests = read();
  ASSERT_EQ(tests.size(), 1U);
  const json& test = tests[0];
  EXPECT_EQ(test["id"], "cross.Figures/Verdict.IsPrinted");
  EXPECT_EQ(test["file"], "verdict_test.cpp");
  EXPECT_EQ(test["line"], "25");
  EXPECT_EQ(test["full_name"], "Verdict.IsPrinted/4a");
  EXPECT_EQ(test["passed"], true);
  EXPECT_EQ(test["requirement"], "V1");
  EXPECT_EQ(test["source"], "Fig. 4");
  EXPECT_EQ(test["comparisons"], 2);
  EXPECT_EQ(test["worst"]["computed"], 2.5);
  EXPECT_EQ(test["worst"]["margin"], 0.5);
  ASSERT_EQ(test["named"].size(), 1U);
  EXPECT_EQ(test["named"][0]["name"], "L1, closed form");
  EXPECT_EQ(test["named"][0]["expected"], 3.125);
  ASSERT_EQ(test["tolerances"].size(), 1U);
  EXPECT_EQ(test["tolerances"][0]["class"], "reference");
  EXPECT_EQ(test["tolerances"][0]["count"], 2);
  EXPECT_EQ(test["tolerances"][0]["tolerance"], 1.0);
  EXPECT_EQ(test["tolerances"][0]["derivation"], "a datum; of which");
  EXPECT_EQ(test["claim"], "fig4");
  EXPECT_EQ(test["finding"], "35 Hz sticks");
}

TEST_F(TestResults, TellWhatFailedInTheOrderOfTheRequirements) {
  write("unit.B.xml", "B", "Fails",
        "<properties>" + property("requirement_position", "10") + "</properties><failure message=\"no\"/>");
  write("unit.C.xml", "C", "Holds", "<properties>" + property("requirement_position", "9") + "</properties>");
  const json tests = read();
  ASSERT_EQ(tests.size(), 2U);
  EXPECT_EQ(tests[0]["name"], "Holds");
  EXPECT_EQ(tests[0]["passed"], true);
  EXPECT_EQ(tests[1]["passed"], false);
}

TEST_F(TestResults, TellWhatWasSkippedAndCountBadInput) {
  write("unit.A.xml", "A", "Waits", "<skipped message=\"no pseudo-terminal\"/>");
  write("unit.B.xml", "B", "Options",
        "<properties>" + property("bad_input.option.zero", "3; 1") +
            property("accepted_input.nothing moves", "1") + "</properties>");
  const json tests = read();
  ASSERT_EQ(tests.size(), 2U);
  EXPECT_EQ(tests[0]["skipped"], true);
  EXPECT_EQ(tests[0]["passed"], false);
  data::write_text(values() / "tests.json", tests.dump());
  EXPECT_EQ(filled_in("<< bad_input.by_defect.zero.option.refused >>, << bad_input.by_reason[0][1] >>"),
            "3, 1");
}

TEST_F(TestResults, DoNotCountBeforeTheRunHasEnded) {
  write("unit.A.xml", "A", "Holds", "");
  data::write_text(xml_ / "commit", "");
  EXPECT_EQ(read(), json::array());
  data::write_text(xml_ / "commit", "0123456789ab\n");
  EXPECT_EQ(read().size(), 1U);
}

TEST_F(TestResults, AreRefusedWhereThereAreNoneOrTheyCannotBeRead) {
  EXPECT_THROW((void)read(), data::InputError);
  EXPECT_THROW((void)report::read_test_results(folder_ / "nowhere"), data::InputError);
  data::write_text(xml_ / "unit.A.xml", "<testsuites><testsuite>");
  EXPECT_THROW((void)read(), data::InputError);
  for (const std::string& broken : {property("comparisons", "many"), property("comparisons", "1"),
                                    property("compared.x", "1; 2; 3"), property("tolerances.x", "1; 2")}) {
    write("unit.A.xml", "A", "Holds", "<properties>" + broken + "</properties>");
    EXPECT_THROW((void)read(), data::InputError) << broken;
  }
}

// Results of studies with numbers that differ from each other, so that one taken for another shows.
STICKSLIP_VERIFIES(Findings, "U5");
TEST(Findings, AreTheLargestDifferencesOfTwoRoutesToAForce) {
  const double printed = data::printed_number("force_max.15").value;
  const studies::ForceMaximumStudy row{.frequency_hz = 15.0,
                                       .sampled = 1.01 * printed,
                                       .truncated = {1.01 * printed, 1.03 * printed},
                                       .converged = {1.04 * printed, 1.06 * printed},
                                       .finite_element = 1.10 * printed,
                                       .predicted_finite_element = 1.15 * printed};
  studies::ForceMaximumStudy exact = row;
  for (double* value : {&exact.sampled, &exact.truncated.lower, &exact.truncated.upper,
                        &exact.converged.lower, &exact.converged.upper, &exact.finite_element})
    *value = exact.predicted_finite_element = printed;
  for (const auto& rows : {std::vector{row, exact}, std::vector{exact, row}}) {
    const json found = report::force_differences(rows);  // to the rounding of a quotient near 1
    EXPECT_NEAR(found["sampling"].get<double>(), 1.0 - 1.01 / 1.02, 1e-15);
    EXPECT_NEAR(found["truncation"].get<double>(), 1.0 - 1.02 / 1.05, 1e-15);
    EXPECT_NEAR(found["discretisation"].get<double>(), 1.10 / 1.05 - 1.0, 1e-15);
    EXPECT_NEAR(found["prediction"].get<double>(), 1.0 - 1.10 / 1.15, 1e-15);
    EXPECT_NEAR(found["printed"].get<double>(), 0.01, 1e-15);
  }
}

TEST(Findings, HoldThePointsOfTheGuardBandAlone) {
  const studies::ClassificationStudy study{
      .frequencies = {{5.0, 1e-3, 0.1, 0.2}, {10.0, 2e-3, 0.03, 0.04}},
      .points = {{5.0, 0.5e-3, false, true, false}, {10.0, 2.1e-3, true, false, true}}};
  const json points = report::guard_points(study);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0]["frequency_hz"], 10.0);
  EXPECT_EQ(points[0]["amplitude"], 2.1e-3);
  EXPECT_NEAR(points[0]["distance"].get<double>(), 0.05, 1e-15);
  EXPECT_DOUBLE_EQ(points[0]["relative_guard"], 0.07);
  EXPECT_EQ(points[0]["closed_form"], "stick-slip");
  EXPECT_EQ(points[0]["finite_element"], "stick");
}

TEST(Findings, CompareHalfTheStiffnessWithTheWhole) {
  std::vector<studies::CriticalAmplitudePoint> full, half;
  for (int i = 1; i <= 21; ++i) {
    full.push_back({1.0, 2.0});
    half.push_back({0.7, 2.0 * (22 - i)});
  }
  const json ratio = report::half_stiffness_ratio(full, half);
  EXPECT_EQ(ratio["median"], 11.0);
  EXPECT_EQ(ratio["low_tenth"], 3.0);
  EXPECT_EQ(ratio["high_tenth"], 19.0);
}

TEST(Findings, CountAPanelOnlyIfPaperCriterionAndFiniteElementsAgree) {
  std::vector<studies::ContactHistory> panels;  // of Figs. 4a to 5d
  for (const auto& verdict : data::printed_verdicts()) {
    const bool slips = verdict.verdict == "stick-slip";
    panels.emplace_back();
    panels.back().criterion_slips = slips;
    if (slips) panels.back().closed_form_slip = panels.back().finite_element_slip = 0.25;
  }
  EXPECT_EQ(report::histories(panels)["verdicts_agreeing"], 8);
  panels[0].criterion_slips = true;
  panels[2].finite_element_slip = 0.5;
  panels[5].finite_element_slip.reset();
  panels[6].finite_element_slip = 0.125;
  panels[7].converged.emplace();
  panels[7].converged->tip_half_width = {0.0, 0.5};
  panels[7].converged->tip_range = 2.0;
  const json found = report::histories(panels);
  EXPECT_EQ(found["verdicts_agreeing"], 5);
  EXPECT_EQ(found["first_slip_difference"], 0.125);
  EXPECT_EQ(found["half_width"], 0.25);
}

TEST(Findings, TakeTheDifferencesOfTheFinestStepOnTheFinestMesh) {
  const auto run = [](int size, double step, double difference) {
    return studies::BenchmarkRun{.method = "",
                                 .size = size,
                                 .time_step = step,
                                 .first_ten = {difference, 2.0 * difference},
                                 .all = {3.0 * difference, 4.0 * difference},
                                 .each = {}};
  };
  studies::DampedBenchmark low;
  low.kelvin_voigt = 1e-3;
  low.runs = {run(40, 2e-5, 100.0), run(40, 1e-5, 1.0), run(20, 1e-6, 200.0), run(80, 0.0, 300.0)};
  low.events.resize(3);
  low.history.events.resize(7);
  studies::DampedBenchmark high = low;
  high.runs = {run(40, 1e-5, 2.0), run(40, 2e-5, 100.0)};
  high.history.events.resize(5);
  const json found = report::benchmark_extremes({low, high}, 25.0);
  EXPECT_EQ(found["elements"], 40);
  EXPECT_EQ(found["time_step"], 1e-5);
  EXPECT_EQ(found["first_ten"], json({{"time", 2.0}, {"position", 4.0}}));
  EXPECT_EQ(found["all"], json({{"time", 6.0}, {"position", 8.0}}));
  EXPECT_EQ(found["events"], 6);
  EXPECT_EQ(found["merged_sticks"], 3);
  EXPECT_DOUBLE_EQ(found["damping_ratio"], std::numbers::pi * 0.025);  // eta omega_1/2

  low.runs[1].all.time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(report::benchmark_extremes({low, high}, 25.0)["all"]["time"].get<double>()));
}

TEST(Findings, BalanceTheEnergyOfEachRun) {
  studies::EnergyAudit audit;
  audit.kelvin_voigt = 1e-3;
  audit.modes = 20;
  audit.event_driven = {.kinetic = 7.0,
                        .potential = 2.0,
                        .base_work = 4.0,
                        .follower_work = 8.0,
                        .damping_loss = 0.5,
                        .friction_loss = 3.5};
  audit.event_driven_initial = 3.0;
  audit.time_step = {1e-4, 1e-5};
  const solver::EnergyBalance stepped{.kinetic = 5.0,
                                      .elastic = 6.0,
                                      .base_work = 16.0,
                                      .follower_work = -4.0,
                                      .damping_loss = 1.5,
                                      .friction_loss = 2.5,
                                      .capture_loss = 0.25,
                                      .initial_energy = 1.0};
  solver::EnergyBalance coarse = stepped;
  coarse.initial_energy = -1.0;
  audit.meshes = {{.elements = 10, .stepped = {coarse, stepped}, .observed_order = {}}};
  const json found = report::energy_balances({audit});
  EXPECT_EQ(found["rows"][0], json({{"change", 6.0},
                                    {"base_work", 4.0},
                                    {"follower_work", 8.0},
                                    {"damping_loss", 0.5},
                                    {"friction_loss", 3.5},
                                    {"residual", -2.0},
                                    {"modes", 20},
                                    {"kelvin_voigt", 1e-3}}));
  EXPECT_EQ(found["rows"][1], json({{"change", 10.0},
                                    {"base_work", 16.0},
                                    {"follower_work", -4.0},
                                    {"damping_loss", 1.5},
                                    {"friction_loss", 2.5},
                                    {"residual", 2.25},
                                    {"elements", 10},
                                    {"time_step", 1e-5},
                                    {"kelvin_voigt", 1e-3}}));
  EXPECT_EQ(found["event_driven"], 0.5);        // whatever its sign
  EXPECT_EQ(found["unresolved"], 4.25 / 16.0);  // with any of the steps
}

TEST(Findings, HoldTheLargestDifferencesOfTheMotion) {
  studies::BeamMotionStudy a, b;
  a.peak = 2.0, a.difference = 0.5, a.half_width = 0.125;
  a.stick_difference = 0.25, a.predicted_stick_difference = 1.0;
  b.peak = 8.0, b.difference = 1.0, b.half_width = 1.0;
  b.stick_difference = 0.125, b.predicted_stick_difference = 3.0;
  EXPECT_EQ(report::motion({b, a}), json({{"stick_difference", 0.25},
                                          {"predicted_stick_difference", 1.0},
                                          {"difference", 0.25},
                                          {"half_width", 0.125}}));
}

TEST(Findings, CompareEachValueWithItsReference) {
  studies::PrintedCheck holds;
  holds.printed.id = "a", holds.method = "hand";
  holds.printed.value = 4.0, holds.computed = 5.0, holds.allowed = 1.0;
  studies::PrintedCheck fails = holds;
  fails.allowed = 0.5;
  studies::VerifiedResult verified;
  verified.reference = 8.0;
  verified.levels = {{10, 0.0, 9.0}, {20, 0.0, 7.0}};
  studies::SolutionVerification verification;
  verification.results = {verified};
  const auto values = report::checked_results({holds, fails}, verification);
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0].what, "a by hand");
  EXPECT_EQ(values[0].reference, "printed");
  EXPECT_EQ(values[0].relative_difference(), 0.25);
  EXPECT_FALSE(values[0].known_erratum);
  EXPECT_TRUE(values[1].known_erratum);
  EXPECT_EQ(values[2].reference, "mesh-free");
  EXPECT_EQ(values[2].relative_difference(), 0.125);
}

TEST(Findings, HaveTheMeanAndTheStandardDeviationOfTheDifferences) {
  const auto value = [](double computed, bool erratum = false, const char* reference = "printed") {
    return report::CheckedResult{"", reference, computed, 1.0, erratum};
  };
  const auto found = report::differences_from(
      {value(1.0), value(1.25), value(1.5), value(7.0, true), value(7.0, false, "mesh-free")}, "printed");
  EXPECT_EQ(found.count, 3U);
  EXPECT_DOUBLE_EQ(found.bias, 0.25);
  EXPECT_DOUBLE_EQ(found.spread, 0.25);  // sqrt((0.25^2 + 0 + 0.25^2)/2)
}

// The tables of those figures that take no time.
class FigureTables : public ReportTemplates {
 protected:
  using Rows = std::vector<std::vector<std::string>>;

  void SetUp() override {
    ReportTemplates::SetUp();
    ::unsetenv("STICKSLIP_REPORTS");
  }

  report::FigureData figure(const std::string& name) {
    return std::ranges::find(report::all_figures(), name, &report::Figure::name)->data(results_);
  }

  /// Without the title, the units and the names of the columns.
  static Rows rows_of(const report::CsvTable& table) {
    std::istringstream stream(table.text());
    Rows rows;
    for (std::string line; std::getline(stream, line);) {
      if (line.empty() || line.front() == '#') continue;
      std::istringstream cells(line);
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    rows.erase(rows.begin());
    return rows;
  }

  static std::vector<double> numbers_of(const std::vector<std::string>& row) {
    std::vector<double> numbers;
    for (const std::string& cell : row) numbers.push_back(std::stod(cell));
    return numbers;
  }

  static double value_of(const report::FigureData& data, const std::string& name) {
    return std::get<double>(std::ranges::find(data.values, name, &report::FigureData::Value::name)->value);
  }

  report::StudyResults results_{[](const std::string&) {}, values()};
};

STICKSLIP_VERIFIES(FigureTables, "U5");
TEST_F(FigureTables, HoldAFrictionThatOpposesTheSlidingVelocity) {
  const auto rows = rows_of(figure("fig2").tables.front().table);
  const auto& beam = results_.paper().beam;
  const auto& law = results_.paper().friction;
  int at_rest = 0;
  for (const auto& row : rows) {
    const double velocity = std::stod(row[0]), coefficient = std::stod(row[1]), force = std::stod(row[2]);
    const double expected =
        law.kinetic_coefficient() +
        (law.static_coefficient() - law.kinetic_coefficient()) * std::exp(-law.decay() * std::abs(velocity));
    EXPECT_DOUBLE_EQ(coefficient, expected);
    EXPECT_DOUBLE_EQ(std::abs(force), expected * beam.axial_force());
    EXPECT_LE(force * velocity, 0.0) << velocity;
    if (velocity == 0.0) {
      EXPECT_EQ(force > 0.0, at_rest == 0);
      ++at_rest;
    }
  }
  EXPECT_EQ(at_rest, 2);
}

TEST_F(FigureTables, HoldModesThatEndAtRestInStickAndMoveInSlip) {
  const auto data = figure("fig7");
  const auto rows = rows_of(data.tables.front().table);
  for (std::size_t panel = 1; panel <= 6; ++panel) {
    const bool slip = panel % 2 == 0;
    const auto& study = slip ? results_.slip_frequencies() : results_.stick_frequencies();
    EXPECT_DOUBLE_EQ(value_of(data, "hz" + std::to_string(panel)),
                     study.modes[(panel - 1) / 2].closed_form_hz);
    for (const std::size_t column : {2 * panel - 1, 2 * panel}) {
      double largest = 0.0;
      for (const auto& row : rows) largest = std::max(largest, std::abs(std::stod(row[column])));
      EXPECT_NEAR(largest, 1.0, 1e-3);
      EXPECT_NEAR(std::stod(rows.front()[column]), 0.0, 1e-12);
      if (slip)
        EXPECT_GT(std::abs(std::stod(rows.back()[column])), 0.5);
      else
        EXPECT_NEAR(std::stod(rows.back()[column]), 0.0, 1e-9);
    }
  }
}

TEST_F(FigureTables, HoldTheSameForcesInTheSurfaceOfFigure10AndInItsPoints) {
  const auto data = figure("fig10");
  const auto surface = rows_of(data.tables[0].table), points = rows_of(data.tables[1].table);
  const std::vector<std::pair<std::string, std::string>> letters{
      {"A", "15"}, {"C", "25"}, {"B", "35"}, {"D", "70"}};  // the paper's
  ASSERT_EQ(points.size(), letters.size());
  EXPECT_DOUBLE_EQ(value_of(data, "limit"), 300.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i][0], letters[i].first);
    EXPECT_EQ(points[i][1], letters[i].second);
    const auto same = std::ranges::find_if(surface, [&](const auto& row) {
      return row[0] == points[i][1] && std::abs(std::stod(row[1]) - std::stod(points[i][2])) < 1e-9;
    });
    ASSERT_NE(same, surface.end()) << points[i][0];
    EXPECT_NEAR(std::stod((*same)[2]) / std::stod(points[i][3]), 1.0, 1e-4);  // two searches of one maximum
  }
}

TEST_F(FigureTables, HoldTheCriticalAmplitudesOfEachStiffnessAtItsOwnFrequencies) {
  const auto data = figure("fig13");
  const double ratio = value_of(data, "half1") / value_of(data, "natural1");
  EXPECT_NEAR(ratio, std::sqrt(0.5), 0.01);
  EXPECT_GT(value_of(data, "natural2"), value_of(data, "half2"));
  const auto curve = rows_of(figure("fig11").tables.front().table);
  const auto rows = rows_of(data.tables.front().table);
  ASSERT_EQ(rows.size(), curve.size());
  double softer_bears_more = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], curve[i][0]);
    EXPECT_EQ(rows[i][1], curve[i][1]);
    EXPECT_NEAR(std::stod(rows[i][2]), ratio * std::stod(rows[i][0]), 1e-12 * std::stod(rows[i][0]));
    softer_bears_more += std::stod(rows[i][3]) > std::stod(rows[i][1]) ? 1.0 : 0.0;
  }
  EXPECT_GT(softer_bears_more / static_cast<double>(rows.size()), 0.9);
}

TEST_F(FigureTables, HoldTheErrorsOfEachMeshBesideTheirPrediction) {
  const auto data = figure("convergence");
  const auto meshes = rows_of(data.tables[0].table), steps = rows_of(data.tables[1].table);
  const auto& first = results_.stick_frequencies().modes.front();
  EXPECT_DOUBLE_EQ(std::stod(meshes[0][4]), first.relative_error[0]);
  EXPECT_DOUBLE_EQ(std::stod(meshes[0][5]), first.predicted_error[0]);
  for (const auto& row : meshes) {
    EXPECT_DOUBLE_EQ(std::stod(row[3]) * std::stod(row[2]), results_.paper().beam.length());
    if (row[0] == "stick" && row[1] == "1") {
      EXPECT_NEAR(std::stod(row[4]) / std::stod(row[5]), 1.0, 0.05) << row[2];
    }
  }
  const auto& study = results_.time_orders().front();
  EXPECT_DOUBLE_EQ(std::stod(steps[0][0]), study.spectral_radius);
  EXPECT_DOUBLE_EQ(std::stod(steps[0][1]), study.time_step[0]);
  EXPECT_DOUBLE_EQ(std::stod(steps[0][2]), study.displacement_error[0]);
  EXPECT_DOUBLE_EQ(std::stod(steps[0][3]), study.velocity_error[0]);
  EXPECT_DOUBLE_EQ(std::stod(steps[0][4]), study.reaction_error[0]);
}

TEST_F(FigureTables, HoldTheMotionOfTheBeamFromItsBaseToItsTip) {
  const auto rows = rows_of(figure("fig3").tables.front().table);
  const auto& motions = results_.beam_motions();
  std::size_t row = 0;
  for (std::size_t panel = 0; panel < motions.size(); ++panel) {
    const auto& study = motions[panel];
    const auto& snapshots = study.finite_element.snapshots;
    const double omega = 2.0 * std::numbers::pi * study.frequency_hz;
    // The phase omega t of the base is below 20, and so its sine is known to 20 eps.
    const double rounding = 20.0 * std::numeric_limits<double>::epsilon() * study.amplitude;
    for (std::size_t i = 0; i < snapshots.size(); ++i)
      for (std::size_t k = 0; k < study.finite_element.position.size(); ++k, ++row) {
        ASSERT_LT(row, rows.size());
        const auto cells = numbers_of(rows[row]);
        ASSERT_EQ(cells.size(), 9U);
        EXPECT_EQ(cells[0], static_cast<double>(panel + 1));
        EXPECT_EQ(cells[1], study.frequency_hz);
        EXPECT_EQ(cells[2], static_cast<double>(i + 1));
        EXPECT_DOUBLE_EQ(cells[4], (cells[3] - snapshots.front().time) * study.frequency_hz);
        EXPECT_EQ(cells[5] == 1.0, snapshots[i].sticks);
        EXPECT_EQ(cells[7], snapshots[i].displacement[k]);
        EXPECT_EQ(cells[8], study.reference.snapshots[i].displacement[k]);
        if (cells[6] == 0.0) {  // the base
          const double base = study.amplitude * std::sin(omega * cells[3]);
          EXPECT_NEAR(cells[7], base, rounding);
          EXPECT_NEAR(cells[8], base, rounding);
        }
      }
  }
  EXPECT_EQ(row, rows.size());
}

TEST_F(FigureTables, HoldTheLengthsOfResonanceAndOfBucklingUnderEachForce) {
  const auto data = figure("fig14");
  const auto ratios = rows_of(data.tables[0].table), limits = rows_of(data.tables[1].table);
  EXPECT_EQ(value_of(data, "hz"), 25.0);
  const double coefficient = value_of(data, "buckling_coefficient");  // z^2 with tan z = z
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double z = std::sqrt(coefficient);
  EXPECT_NEAR(std::tan(z) / z, 1.0, 50.0 * epsilon);  // condition number z^2 = 20
  const data::Beam& beam = results_.flat_section().beam;
  const double rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  const auto number = [](const std::string& cell) { return std::stod(cell); };
  ASSERT_EQ(limits.size(), 100U);
  ASSERT_EQ(ratios.size() % limits.size(), 0U);
  const std::size_t lengths = ratios.size() / limits.size();
  for (std::size_t line = 0; line < limits.size(); ++line) {
    const double force = number(limits[line][0]), buckling = number(limits[line].back());
    EXPECT_NEAR(buckling * buckling * force / (coefficient * rigidity), 1.0, 10.0 * epsilon);
    std::size_t largest = line * lengths;
    for (std::size_t row = line * lengths; row < (line + 1) * lengths; ++row) {
      EXPECT_EQ(ratios[row][1], limits[line][0]);
      EXPECT_LT(number(ratios[row][0]), buckling);
      if (number(ratios[row][2]) > number(ratios[largest][2])) largest = row;
    }
    // Far from buckling the force is largest at the first resonance.
    if (force < 500.0) {
      EXPECT_EQ(ratios[largest][0], limits[line][1]) << force << " N";
    }
    if (!limits[line][2].empty()) {
      EXPECT_LT(number(limits[line][1]), number(limits[line][2]));
    }
  }
}

TEST_F(FigureTables, HoldTheErrorsThroughEventsWithAndWithoutTheirLocation) {
  const auto rows = rows_of(figure("event-order").tables.front().table);
  std::size_t row = 0;
  for (const auto& study : results_.event_orders())
    for (std::size_t i = 0; i < study.time_step.size(); ++i, ++row) {
      ASSERT_LT(row, rows.size());
      EXPECT_EQ(
          numbers_of(rows[row]),
          (std::vector<double>{study.spectral_radius, study.time_step[i], study.located.event_time_error[i],
                               study.at_end_of_step.event_time_error[i], study.located.tip_error[i],
                               study.at_end_of_step.tip_error[i]}));
    }
  EXPECT_EQ(row, rows.size());
}

}  // namespace
}  // namespace stickslip
