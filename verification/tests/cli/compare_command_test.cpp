// SPDX-License-Identifier: MIT
/// The commands that hand out the reference data and compare with them: exit status, streams, JSON, JUnit,
/// figure.

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>

#include "comparison_json.hpp"
#include "support/command_line.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

const std::string fixture = STICKSLIP_SOURCE_DIRECTORY "/verification/tests/golden/reference";

std::string in_fixture(const std::string& command) { return command + " --package '" + fixture + "' "; }

class ReferenceCommand : public CommandLine {
 protected:
  static inline const nlohmann::json package = nlohmann::json::parse(contents(fixture + "/datapackage.json"));
};

STICKSLIP_VERIFIES(ReferenceCommand, "U1");
TEST_F(ReferenceCommand, ListsEveryDataSet) {
  const std::string list = run(in_fixture("reference list")).output;
  for (const auto& resource : package["resources"]) {
    const auto at = list.find(fmt::format("\n{} ", resource["name"].get<std::string>()));
    ASSERT_NE(at, std::string::npos) << resource["name"];
    const std::string line = list.substr(at + 1, list.find('\n', at + 1) - at - 1);
    const auto rows = csv(contents(fixture + "/" + resource["path"].get<std::string>())).size() - 1;
    EXPECT_TRUE(line.ends_with(fmt::format("  {}  {}", rows, resource["title"].get<std::string>()))) << line;
    EXPECT_TRUE(holds(line, resource["provenance"]["class"].get<std::string>()));
  }
}

TEST_F(ReferenceCommand, ShowsWhatThePackageSaysOfOne) {
  const std::regex shown(
      "/(title|description|provenance/.*|comparison/.*|schema/fields/[0-9]+/(name|unit|class|description))");
  for (const auto& resource : package["resources"]) {
    const std::string text = run(in_fixture("reference show " + resource["name"].get<std::string>())).output;
    const auto flat = resource.flatten();
    for (const auto& [place, value] : flat.items()) {
      if (!std::regex_match(place, shown) || value.is_null()) continue;
      EXPECT_TRUE(holds(
          text, value.is_string() ? value.get<std::string>() : fmt::format("{:.2g}", value.get<double>())))
          << place;
    }
  }
  EXPECT_TRUE(holds(run(in_fixture("reference show damped-history")).output, "301 rows"));
  EXPECT_TRUE(holds(run(in_fixture("reference show damped-history")).output,
                    "tip_displacement: uncertainty 4.2e-08 to 4.2e-08 m, tolerance 0.01 (scale)"));
}

TEST_F(ReferenceCommand, ExportsWholeFilesAlone) {
  const std::string original = contents(fixture + "/damped/history.csv");
  EXPECT_EQ(run(in_fixture("reference export damped-history")).output, original);
  EXPECT_EQ(run(in_fixture("reference export damped-history") + "--output mine.csv").status, 0);
  EXPECT_EQ(contents("mine.csv"), original);
  std::filesystem::create_directory("folder");
  EXPECT_EQ(run(in_fixture("reference export damped-history") + "--output folder").output,
            "Written: folder/history.csv\n");
  EXPECT_EQ(contents("folder/history.csv"), original);
  expect_refused(in_fixture("reference export damped-history") + "--output none/mine.csv", "none/mine.csv");
  expect_refused(in_fixture("reference export damped-histori") + "--output other.csv",
                 "did you mean damped-history?");
  EXPECT_FALSE(std::filesystem::exists("other.csv"));
}

TEST_F(ReferenceCommand, RefusesAnAlteredPackage) {
  std::filesystem::copy(fixture, "package", std::filesystem::copy_options::recursive);
  std::ofstream("package/beams.csv", std::ios::app) << "strip,1,20\n";
  expect_refused("reference export beams --package package", "beams.csv: its size is");
  std::filesystem::resize_file("package/beams.csv", 50'000'001);
  expect_refused("reference list --package package", "beams.csv: is larger than the 50000000 bytes");
  std::filesystem::resize_file("package/datapackage.json", 10'000'001);
  expect_refused("compare beams mine.csv --package package", "datapackage.json: is larger than the 10000000");
  expect_refused("reference list --package none", "--package is none, but must be a folder that exists");
  expect_refused("reference", "a subcommand of reference, one of list, show, export, is required");
}

using MeasurementOfACase = Drawing;

class CompareCommand : public Drawing {
 protected:
  // `stickslip compare <set> <a file with this text> <options>`
  [[nodiscard]] std::string command(const std::string& set, const std::string& text,
                                    const std::string& options = "") const {
    std::ofstream("mine.csv", std::ios::binary) << text;
    return in_fixture("compare " + set + " mine.csv") + options;
  }

  [[nodiscard]] nlohmann::json comparison(const std::string& command, int status) const {
    const Outcome outcome = run(command + " --json -");
    EXPECT_EQ(outcome.status, status) << outcome.errors;
    EXPECT_TRUE(outcome.output.starts_with("{\n  \"")) << outcome.output;
    return nlohmann::json::parse(outcome.output);
  }

  static constexpr const char* right =
      "beam;Mode;Frequency [kHz]\r\npaper;1;0.02497196\r\npaper;2;0.0810776\r\n";
  static constexpr const char* printed = "beam,mode,frequency\npaper,1,1.607\npaper,2,7.231\npaper,3,16.03\n";
};

TEST_F(MeasurementOfACase, SaysWhereTheCaseIsSure) {
  std::ofstream("measured.csv") << "quantity,at,value,half_width\nstick_frequency,1,25,0.2\n";
  for (const auto* name : {"paper", "uncertain"})
    EXPECT_EQ(
        holds(run(std::string("compare measured.csv --samples 100 --case ") + name).output, "u_input is 0"),
        name == std::string("paper"));
}

// sigma_E/(2 E) = 1 % of a frequency, and the length and the load add a little.
STICKSLIP_VERIFIES(MeasurementOfACase, "K3");
TEST_F(MeasurementOfACase, HasTheFormOfOthers) {
  const auto compared = [&](const std::string& row, int status) {
    std::ofstream("measured.csv") << "quantity,at,value,half_width\n" << row << "\n";
    const Outcome outcome = run("compare measured.csv --case uncertain --samples 400 --json -");
    EXPECT_EQ(outcome.status, status) << outcome.errors;
    return nlohmann::json::parse(outcome.output)["comparisons"][0];
  };
  const double hz = json("modes uncertain --state stick --count 1")["frequencies_hz"][0];
  const auto one = compared("stick_frequency,1,24.6,0.2", 0);
  EXPECT_DOUBLE_EQ(one["u_D"].get<double>(), 0.1);
  EXPECT_TRUE(within(one["S"], hz, round_off(10, 1, hz)));
  EXPECT_TRUE(within(one["E"], hz - 24.6, round_off(10, 1, hz)));
  EXPECT_TRUE(within(one["u_input"], 0.01 * hz,
                     reference(0.3 * 0.01 * hz, "400 samples and what length and load add")));
  EXPECT_TRUE(within(one["u_val"], std::hypot(0.1, one["u_input"].get<double>(), one["u_num"].get<double>()),
                     round_off(10, 1, 1.0)));
  EXPECT_EQ(one["resolved"], one["E"].get<double>() >= one["u_val"].get<double>());
  EXPECT_EQ(compared("slip_frequency,2,10,0.1", 1)["resolved"], true);
  const auto amplitude = compared("critical_amplitude,35,5.9e-4,1e-5", 0);
  const double critical = json("criterion uncertain --hz 35")["all_modes"]["critical_amplitude_m"];
  EXPECT_TRUE(within(amplitude["S"], critical, round_off(10, 1, critical)));
  EXPECT_TRUE(within(amplitude["u_input"].get<double>() / critical, 0.096,
                     reference(0.02, "400 samples; 0.083 by mu_s")));
}

TEST_F(MeasurementOfACase, IsRefusedAtItsPlace) {
  const std::string head = "quantity,at,value,half_width\n";
  for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
           {"quantity,at,value\n", "the columns must be quantity, at, value and half_width"},
           {head, "has no rows, but must have at least one"},
           {head + "frequency,1,2,3\n",
            "measured.csv:2, column 1 (quantity) is frequency, but must be stick_frequency,"},
           {head + "stick_frequency,1.5,2,3\n", "column 2 (at) is 1.5, but must be the number of a mode"},
           {head + "stick_frequency,1,x,3\n", "column 3 (value) is x, but must be a finite number"},
           {head + "stick_frequency,1,0,3\n", "column 3 (value) is 0, but must be above 0"},
           {head + "stick_frequency,1,2,-3\n", "column 4 (half_width) is -3, but must be 0 or more"},
           {head + "critical_amplitude,0,2,3\n", "the column at: excitation.frequency_hz is 0"}}) {
    std::ofstream("measured.csv") << text;
    expect_refused("compare measured.csv --case uncertain", part);
  }
  expect_refused("compare measured.csv --case uncertain --tolerance 1", "--case excludes --tolerance");
  expect_refused("compare --case uncertain", "NAME is required");
}

STICKSLIP_VERIFIES(CompareCommand, "U1");
TEST_F(CompareCommand, ReadsHistoriesOfRespond) {
  for (const char* step : {"7e-5", "3e-4"}) {
    ASSERT_EQ(run(fmt::format("respond damped --method event-driven --set numerics.modes=20 --duration 0.5 "
                              "--set numerics.time_step={} --output history.csv --events events.csv",
                              step))
                  .status,
              0);
    const Outcome outcome = run("compare stick-slip-history history.csv --events events.csv");
    EXPECT_TRUE(outcome.output.ends_with("\nagrees\n")) << step << outcome.output << outcome.errors;
  }
  EXPECT_TRUE(run("compare stick-slip-events events.csv").output.ends_with("\nagrees\n"));
}

TEST_F(CompareCommand, ReadsStandardInputAndWritesXml) {
  std::ofstream("mine.csv") << right;
  EXPECT_EQ(run(in_fixture("compare stick-frequencies -") + "--rows 1:2 < mine.csv").status, 0);
  expect_refused(in_fixture("compare damped-history - --events -"),
                 "FILE and --events both are standard input, but one of them must be a file");
  const std::string xml = run(in_fixture("compare stick-frequencies mine.csv --junit -")).output;
  EXPECT_TRUE(xml.starts_with("<?xml") && xml.ends_with("</testsuites>\n")) << xml;
  const std::string unnamed = command("stick-frequencies", "paper 1 0.02497196\n", "--rows 1");
  EXPECT_EQ(run(unnamed + " --columns beam,mode,frequency_kHz").status, 0);
}

// A search for the number that is wrong meets models whose motion ends before it begins.
TEST_F(CompareCommand, JudgesEventsAtAnyTimeAndPlace) {
  const std::string right_events = run("reference export published-problems").output,
                    first = "sdnd106,1,onset,";
  const auto begin = right_events.find(first) + first.size(), end = right_events.find('\n', begin);
  for (const std::string wrong : {"0.0351240736552036,1e-15,1,1e-30", "-1,1e-30,0,1e-30"}) {
    std::ofstream("mine.csv") << std::string(right_events).replace(begin, end - begin, wrong);
    const Outcome outcome = run("compare published-problems mine.csv");
    EXPECT_EQ(outcome.status, 1) << outcome.errors;
    EXPECT_TRUE(outcome.output.ends_with("\ndiffers\n")) << wrong;
  }
}

// The motion of a tip that sticks is proportional to the amplitude; the other method has another error, far below 1 %.
TEST_F(CompareCommand, ComparesTwoRunsOfTheUser) {
  const std::string respond = "respond paper --hz 30 --duration 0.2 --amplitude ";
  ASSERT_EQ(run(respond + "1e-4 --output one.csv").status, 0);
  ASSERT_EQ(run(respond + "1e-4 --method closed-form --rate 3000 --output other.csv").status, 0);
  ASSERT_EQ(run(respond + "1.05e-4 --output larger.csv").status, 0);
  EXPECT_TRUE(run("compare one.csv other.csv --package .").output.ends_with("\nagrees\n"));
  const auto answer = comparison("compare one.csv larger.csv", 1);
  EXPECT_EQ(answer["data_set"], "one.csv");
  EXPECT_TRUE(within(answer["quantities"].back()["error"], 0.025,
                     reference(0.002, "5 % of a range that is twice the largest value")));
  EXPECT_EQ(run("compare one.csv larger.csv --tolerance 0.06").status, 0);
  expect_refused("compare none.csv other.csv", "none.csv");
}

TEST_F(CompareCommand, SaysWhatDiffers) {
  const std::string rows = "--rows 1:2 --tolerance 1e-9 ";
  EXPECT_EQ(run(command("stick-frequencies", right, rows)).status, 1);
  EXPECT_EQ(run(command("stick-frequencies", right, rows + "--tolerance frequency=1e-6")).status, 0);
  const Outcome outcome = run(command("stick-frequencies", printed));
  EXPECT_EQ(outcome.errors, "");
  for (const char* part :
       {"like 'second-moment-as-printed'", "9 of 12 rows of the data set are not in the file", "\ndiffers\n"})
    EXPECT_TRUE(holds(outcome.output, part));
  const Outcome quiet = run(command("stick-frequencies", printed, "--quiet"));
  EXPECT_EQ(quiet.status, 1);
  EXPECT_EQ(quiet.output + quiet.errors, "");

  const auto answer = comparison(command("stick-frequencies", printed), 1);
  EXPECT_EQ(answer["kind"], "table");
  EXPECT_EQ(answer["abscissa"], "mode");
  const auto& frequency = answer["quantities"][0];
  EXPECT_TRUE(
      within(frequency["error"], 1.0 - 1.607 / 24.97195809, reference(1e-9, "ten digits of the frequency")));
  EXPECT_EQ(frequency["where"], "beam = paper, mode = 1");
  EXPECT_EQ(frequency["series"][0]["theirs"], nlohmann::json({1.607, 7.231, 16.03}));
  const auto& diagnosis = answer["diagnoses"][0];
  EXPECT_EQ(diagnosis["named"][0], "second-moment-as-printed");
  EXPECT_LT(diagnosis["ranking"][0]["distance"], 1e-4);
  EXPECT_GT(diagnosis["ranking"].size(), 10u);
  EXPECT_EQ(comparison(command("stick-frequencies", right), 3)["diagnoses"].size(), 0u);
}

TEST_F(CompareCommand, TakesNoPartForTheWhole) {
  const Outcome part = run(command("stick-frequencies", right, "--junit a.xml"));
  EXPECT_EQ(part.status, 3);
  EXPECT_TRUE(holds(part.output,
                    "\nagrees in 2 of 12 rows, but more are asked for; --rows 1:2 asks for these alone\n"));
  EXPECT_TRUE(holds(contents("a.xml"), "<error message=\"coverage: 16.7 %, at least 100 % needed\""));
  const auto answer = comparison(command("stick-frequencies", right), 3);
  EXPECT_EQ(answer["verdict"], "undecided");
  EXPECT_EQ(answer["rows"], nlohmann::json::parse(R"({"compared": 2, "of": 12, "numbers": "1:2"})"));
  const Outcome meant = run(command("stick-frequencies", right, "--rows 1,2 --junit a.xml"));
  EXPECT_EQ(meant.status, 0);
  EXPECT_TRUE(holds(meant.output, "\nlevel: strict of 1e-1, 1e-2, 1e-3, strict\nagrees in 2 of 12 rows\n"));
  EXPECT_TRUE(holds(contents("a.xml"), "name=\"coverage in 2 of 12 rows\" />"));
  for (const std::string rows : {"1:", "a", "1:2:3", "1,,2"})
    expect_refused(command("stick-frequencies", right, "--rows " + rows),
                   "--rows is '" + rows + "', but must be");
}

TEST_F(CompareCommand, JudgesTheFilesOfAManifest) {
  std::filesystem::create_directory("results");
  std::ofstream("results/right.csv") << right;
  std::ofstream("results/printed.csv") << printed;
  const auto judged = [&](const std::string& lines, const std::string& options = "") {
    std::ofstream("results/all.csv") << "data_set,file,rows\n" + lines;
    return run(in_fixture("compare --manifest results/all.csv " + options));
  };
  const std::string agrees = "stick-frequencies,right.csv,1:2\n", part = "stick-frequencies,right.csv,\n",
                    differs = "stick-frequencies,printed.csv,1:3\n",
                    refused = "stick-frequencies,none.csv,\n";
  EXPECT_EQ(judged(agrees).status, 0);
  EXPECT_EQ(judged(agrees + part).status, 3);
  EXPECT_EQ(judged(differs + part).status, 1);
  const Outcome all = judged(refused + agrees + differs, "--junit a.xml");
  EXPECT_EQ(all.status, 2);
  EXPECT_TRUE(holds(all.output, "  -       refused: results/none.csv: cannot be opened"));
  EXPECT_TRUE(holds(all.output, "results/right.csv    strict  agrees in 2 of 12 rows\n"));
  EXPECT_TRUE(all.output.ends_with("results/printed.csv  none    differs\n")) << all.output;
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file("a.xml"));
  EXPECT_EQ(document.select_nodes("/testsuites/testsuite").size(), 3u);
  EXPECT_EQ(document.select_node("/testsuites").node().attribute("errors").as_int(), 1);
  EXPECT_EQ(nlohmann::json::parse(judged(refused, "--json -").output)[0]["verdict"], "refused");
  EXPECT_TRUE(holds(judged("").errors, "all.csv: the manifest has no rows"));
  EXPECT_TRUE(holds(judged("stick-frequencies,,\n").errors, ": data_set or file is empty"));
  expect_refused("compare --manifest results/all.csv stick-frequencies", "NAME excludes --manifest");
  expect_refused("compare --manifest results/right.csv",
                 "a column of the manifest is beam, but must be one of data_set");
}

TEST_F(CompareCommand, JudgesEachSequence) {
  std::string text = contents(fixture + "/cubic/events.csv");
  text.replace(text.find("0.455"), 5, "0.456");
  const Outcome outcome = run(command("cubic-events", text, "--junit a.xml"));
  EXPECT_TRUE(holds(outcome.output,
                    "\nrun = a  agrees   strict  -\nrun = b  differs  1e-2    time: 0.001 s at event 1"));
  EXPECT_TRUE(holds(contents("a.xml"), "name=\"run = a\" />"));
  EXPECT_EQ(comparison(command("cubic-events", text), 1)["parts"][1]["verdict"], "differs");
}

// A comparison that differs and covers too little, with all that can be said of a quantity.
cli::Judged made_up() {
  using comparison::Agreement;
  cli::Judged judged{.name = "set", .file = "mine.csv"};
  comparison::Comparison& comparison = judged.comparison.emplace();
  comparison.name = "set", comparison.title = "A title";
  comparison.abscissa = "x", comparison.abscissa_unit = "m";
  comparison.agreement = Agreement::differs;
  comparison.coverage = 0.5834, comparison.required_coverage = 0.9;
  comparison.remarks = {"a remark"};
  const auto add = [&](const char* name, const char* unit, data::Norm norm, std::optional<double> error,
                       Agreement agreement) -> comparison::Comparison::Quantity& {
    auto& one = comparison.quantities.emplace_back();
    one.name = name, one.unit = unit, one.norm = norm, one.agreement = agreement;
    one.tolerance = 0.005, one.error = error;
    if (error) one.uncertainty = 0.5 * *error;
    return one;
  };
  auto& y = add("y", "m", data::Norm::range, 0.163, Agreement::differs);
  y.where = "x = 2 m", y.compared = 2;
  y.skipped = {{"beyond the horizon", 2}, {"outside the range", 3}};
  y.series = {{"run = a", {1.0, 2.0}, {3.0, 4.5}, {3.0, 4.0}, {0.25, 0.5}, {0.125, 0.75}}};
  auto& t = add("t", "s", data::Norm::absolute, 0.02, Agreement::undecided);
  t.where = "event 1", t.compared = 6, t.undecided = 5;
  add("f", "N", data::Norm::relative, {}, Agreement::undecided);
  add("w", "", data::Norm::word, 0.0, Agreement::agrees).compared = 4;
  judged.diagnoses = {{.group = "run = a",
                       .quantity = "y",
                       .sentence = "like one",
                       .finding = comparison::Finding::unexplained,
                       .from_reference = 0.1,
                       .uncertainty = 0.25,
                       .required_ratio = 4.0,
                       .ranked = {{.name = "tension", .distance = 0.5, .from_reference = 0.75}},
                       .named = {"one"}},
                      {.quantity = "t", .sentence = "no diagnosis"}};
  return judged;
}

TEST_F(CompareCommand, SaysAllThatTheComparisonFound) {
  const std::string text =
      "set: A title\n\n"
      "quantity  norm      compared  error   at       uncertainty  tolerance  verdict\n"
      "y         range     2         16.3 %  x = 2 m  8.15 %       0.5 %      differs\n"
      "t         absolute  6         0.02 s  event 1  0.01 s       0.005 s    undecided (5 of 6)\n"
      "f         relative  0         -       -        -            0.005      undecided\n"
      "w         word      4         0       -        0            0.005      agrees\n\n"
      "y: not compared: 2 beyond the horizon, 3 outside the range\na remark\n"
      "coverage: 58.3 %, at least 90 % needed\nlevel: none of 1e-1, 1e-2, 1e-3, strict\n"
      "y: run = a: like one\nt: no diagnosis\n";
  auto judged = made_up();
  comparison::Comparison& comparison = *judged.comparison;
  EXPECT_EQ(cli::text_of(judged), text + "differs\n");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(cli::junit_of({judged}).c_str()));
  for (const auto& suite : document.select_nodes("//testsuites | //testsuite"))
    for (const auto& [attribute, count] : {std::pair{"tests", 5}, {"failures", 1}, {"errors", 3}})
      EXPECT_EQ(suite.node().attribute(attribute).as_int(), count);
  const auto message = [&](const std::string& name) {
    return std::string(
        document.select_node(("//testcase[@name='" + name + "']/*/@message").c_str()).attribute().value());
  };
  EXPECT_EQ(message("coverage"), "coverage: 58.3 %, at least 90 % needed");
  EXPECT_EQ(message("y"), "error 16.3 % at x = 2 m, tolerance 0.5 %, uncertainty of the reference 8.15 %");
  EXPECT_EQ(message("f"), "no point could be compared");
  EXPECT_EQ(message("w"), "");
  EXPECT_EQ(document.select_nodes("//failure[@type='differs'] | //error[@type='undecided']").size(), 4u);
  EXPECT_EQ(document.select_node("//system-out").node().text().get(), "mine.csv\n" + text + "differs\n");
  comparison.agreement = comparison::Agreement::undecided;
  EXPECT_TRUE(
      cli::text_of(judged).ends_with("\nundecided: nothing differs, but the file covers too little\n"));
  comparison.coverage = comparison.required_coverage;
  EXPECT_TRUE(cli::text_of(judged).ends_with(
      "\nundecided: nothing differs, but the reference does not settle everything\n"));
  comparison.quantities.resize(1);
  EXPECT_TRUE(holds(cli::text_of(judged), "strict\nrun = a: like one\n"));

  comparison.quantities = {made_up().comparison->quantities.back()};
  comparison.rows = 21, comparison.all_rows = 40;
  comparison.row_numbers = std::string(40, '1');
  EXPECT_TRUE(holds(cli::text_of(judged), "more are asked for; --rows " + comparison.row_numbers));
  comparison.row_numbers += '1';  // which is too long to be repeated
  EXPECT_TRUE(holds(cli::text_of(judged), "more are asked for\n"));

  const auto json = cli::json_of(made_up());
  EXPECT_EQ(json["quantities"][0], cli::Json::parse(R"({"quantity": "y", "unit": "m", "norm": "range",
    "error": 0.163, "where": "x = 2 m", "uncertainty": 0.0815, "tolerance": 0.005, "verdict": "differs",
    "level": "none", "scaled_error": 0.0, "compared": 2, "undecided": 0, "skipped": [{"reason": "beyond the horizon", "points": 2},
    {"reason": "outside the range", "points": 3}], "series": [{"group": "run = a", "abscissa": [1.0, 2.0],
    "theirs": [3.0, 4.5], "reference": [3.0, 4.0], "half_width": [0.25, 0.5], "allowed": [0.125, 0.75]}]})"));
  EXPECT_EQ(json["quantities"][2]["error"], nullptr);
  EXPECT_EQ(json["diagnoses"],
            cli::Json::parse(R"([{"group": "run = a", "quantity": "y", "sentence": "like one",
    "finding": "unexplained", "distance_from_truth": 0.1, "uncertainty": 0.25, "required_ratio": 4.0,
    "named": ["one"], "ranking": [{"name": "tension", "distance": 0.5, "distance_from_truth": 0.75}]},
    {"group": "", "quantity": "t", "sentence": "no diagnosis", "finding": null}])"));
}

TEST_F(CompareCommand, DrawsWhatItCompared) {
  install_gnuplot("cat \"${folder}comparison-1.csv\" \"${folder}comparison-labels.csv\" > $output\n");
  const Outcome outcome = run(command("stick-frequencies", printed, "--figure figure.svg"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.errors, "");
  const auto rows = csv(contents("figure.svg"));
  ASSERT_GE(rows.size(), 6u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"abscissa", "theirs", "reference", "half_width", "allowed"}));
  EXPECT_EQ(rows[1][1], "1.607");
  EXPECT_EQ(rows[rows.size() - 2], std::vector<std::string>{"mode"});
  EXPECT_EQ(rows.back(), std::vector<std::string>{"frequency / Hz"});
}

TEST_F(CompareCommand, RefusesAndWritesNothing) {
  for (const auto& [options, part] : std::vector<std::pair<std::string, std::string>>{
           {"--tolerance time=1", "the quantity of a tolerance is time, but must be one of"},
           {"--column f=g", "column f is unknown"},
           {"--events mine.csv", "--events is given, but"},
           {"--until 1", "a latest time is given"}})
    expect_refused(command("stick-frequencies", right, "--json a.json --junit a.xml " + options), part);
  EXPECT_FALSE(std::filesystem::exists("a.json"));
  EXPECT_TRUE(holds(contents("a.xml"), R"(<error message="a latest time is given,)"));
  expect_refused(command("stick-frequencies", "beam,mode,frequency\npaper,9,1\n"),
                 "beam = paper, mode = 9 is not in the data set");
  expect_refused(command("stick-frequencies", right, "--json - --junit -"), "both want standard output");
  expect_refused("compare stick-frequencies", "FILE is required");
}

}  // namespace
}  // namespace stickslip::testing
