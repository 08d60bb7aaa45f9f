// SPDX-License-Identifier: MIT
/// The templates of the report: what is filled in, and what is refused.

#include <nlohmann/json.hpp>

#include "render/document.hpp"
#include "render/output_folder.hpp"
#include "render/report.hpp"
#include "render/study_table.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "support/input_folder.hpp"
#include "support/requirements.hpp"
#include "support/testing.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A folder of templates with the renderer of the report and one template, and a folder of values.
class ReportTemplates : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder :
         {"values", "templates/figures", "templates/report", "templates/site", "verification/mutants",
          "verification/benchmarks/results", "verification/peers"})
      fs::create_directories(folder_ / folder);
    for (const char* file : {"render.py", "macros.jinja"})
      fs::copy(report::templates_directory() / "report" / file, templates_ / "report");
    ::setenv("STICKSLIP_REPORTS", templates_.c_str(), 1);
    for (const auto& [file, text] : std::map<std::string, std::string>{
             {"values/tests.json", "[]"},
             {"verification/mutants/summary.csv", "part,killed\n"},
             {"verification/mutants/survivors.toml", "equivalent = []\n"},
             {"verification/acceptance.toml",
              "result = []\npaper = []\nquantity = []\nexcluded = {}\nguide = []\nmutants = {}\n"},
             {"verification/requirements.toml", "requirements = []\n"},
             {"verification/benchmarks/comparisons.toml", "comparison = []\n"},
             {"verification/benchmarks/results/speed.json",
              R"({"context": {"processor": "one"}, "benchmarks": []})"},
             {"verification/peers/scoreboard.csv", "code,verdict\n"},
             {"verification/history.csv", "commit\n"}})
      data::write_text(folder_ / file, text);
  }
  void TearDown() override { ::unsetenv("STICKSLIP_REPORTS"); }

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

  const testing::InputFolder temporary_;
  const fs::path folder_ = temporary_.path();
  const fs::path templates_ = folder_ / "templates";
};

struct Interval {
  double from{}, to{};
  [[nodiscard]] double length() const { return to - from; }
};
STICKSLIP_MEMBERS(Interval, (from, "m"), (to, "m"), (length(), "m"))

struct Intervals {
  std::vector<Interval> intervals{{0.1, 1.0 / 3.0}};
  double infinite = std::numeric_limits<double>::infinity();
  std::optional<double> nothing{};
};
STICKSLIP_MEMBERS(Intervals, (intervals), (infinite, "m"), (nothing, "m"))

STICKSLIP_VERIFIES(ReportTemplates, "U4");
TEST_F(ReportTemplates, ReadEveryDigitOfAResult) {
  data::write_text(values() / "results.json", report::json_text(report::json_of(Intervals())));
  EXPECT_EQ(filled_in("<< results.intervals[0].to | plain >>, << results.intervals[0].length | fixed(3) >>, "
                      "<< results.infinite == 'inf' >>, << results.nothing is none >>"),
            "0.3333333333333333, 0.233, True, True");
}

TEST_F(ReportTemplates, NameAValueThatIsMissing) {
  data::write_text(values() / "results.json", R"({"present": 1})");
  const std::string text = error_of("<< results.present >>\n<< results.absent | fixed(2) >>\n");
  EXPECT_TRUE(testing::holds(text, "a.tex, line 2: "));
  EXPECT_TRUE(testing::holds(text, "'absent'"));
  EXPECT_TRUE(testing::holds(error_of("<< nowhere.value >>"), "'nowhere' is undefined"));
}

TEST_F(ReportTemplates, RefuseInfiniteNumbers) {
  data::write_text(values() / "results.json", R"({"value": 0.25, "infinite": "inf"})");
  EXPECT_TRUE(
      testing::holds(error_of("\n\n<< results.value >>"), "a.tex, line 3: the number 0.25 has no filter"));
  EXPECT_TRUE(testing::holds(error_of("<< results.infinite | sig(2) >>"), "inf cannot stand in the report"));
}

TEST_F(ReportTemplates, AreNotBlamedForOtherPages) {
  data::write_text(templates_ / "site" / "site.py", "raise SystemExit('a value is missing')\n");
  report::OutputFolder output(folder_ / "output");
  testing::expect_error_message<std::runtime_error>(
      [&] { report::write_site(values(), output); },
      {"the pages of evidence cannot be made: a value is missing"});
}

TEST_F(ReportTemplates, FormatAsTheExamplesSay) {
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
TEST_F(PaperIndex, CoversEveryEquationAndFigure) {
  json tests = json::array();
  for (const auto& requirement : testing::requirements())
    tests.push_back({{"source", requirement.source},
                     {"requirement", requirement.id},
                     {"requirement_text", ""},
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
    data::write_text(xml_ / file,
                     "<?xml version=\"1.0\"?><testsuites><testsuite name=\"" + suite +
                         "\"><testcase name=\"" + name + "\" classname=\"" + suite +
                         "\" file=\"verdict_test.cpp\" line=\"25\" status=\"run\" time=\"0.25\">" + inside +
                         "</testcase></testsuite></testsuites>");
  }

  static std::string property(const std::string& name, const std::string& value) {
    return "<property name=\"" + name + "\" value=\"" + value + "\"/>";
  }

  [[nodiscard]] json read() const { return json::parse(report::read_test_results(xml_)); }

  const fs::path xml_ = folder_ / "xml";
};

STICKSLIP_VERIFIES(TestResults, "U6");
TEST_F(TestResults, HoldRequirementAndClaim) {
  std::string properties;
  for (const auto& [name, value] : std::vector<std::pair<const char*, const char*>>{
           {"requirement", "V1"},
           {"requirement_position", "7"},
           {"source", "Fig. 4"},
           {"comparisons", "2"},
           {"computed", "2.5"},
           {"expected", "2"},
           {"error", "0.5"},
           {"tolerance", "1"},
           {"margin", "0.5"},
           {"class", "reference"},
           {"derivation", "a datum; of which"},
           {"tolerances.reference", "2; 0.5; 1; 0.5; a datum; of which"},
           {"claim", "fig4"},
           {"finding", "35 Hz sticks"}})
    properties += property(name, value);
  write("cross.Figures/Verdict.IsPrinted.xml", "Figures/Verdict", "IsPrinted/4a",
        "<properties>" + properties + "</properties>");
  const json tests = read();
  ASSERT_EQ(tests.size(), 1U);
  const json wanted =
      json::parse(
          R"({"id": "cross.Figures/Verdict.IsPrinted", "file": "verdict_test.cpp", "line": "25", "passed": true,
    "requirement": "V1", "source": "Fig. 4", "comparisons": 2, "seconds": 0.25, "claim": "fig4", "finding": "35 Hz sticks",
    "worst": {"computed": 2.5, "margin": 0.5},
    "tolerances": [{"class": "reference", "count": 2, "tolerance": 1.0, "derivation": "a datum; of which"}]})")
          .flatten();
  for (const auto& [place, value] : wanted.items())
    EXPECT_EQ(tests[0].flatten().value(place, json()), value) << place;
}

TEST_F(TestResults, TellWhatFailedInOrder) {
  write("unit.B.xml", "B", "Fails",
        "<properties>" + property("requirement_position", "10") + "</properties><failure message=\"no\"/>");
  write("unit.C.xml", "C", "Holds", "<properties>" + property("requirement_position", "9") + "</properties>");
  const json tests = read();
  ASSERT_EQ(tests.size(), 2U);
  EXPECT_EQ(tests[0]["name"], "Holds");
  EXPECT_EQ(tests[0]["passed"], true);
  EXPECT_EQ(tests[1]["passed"], false);
}

TEST_F(TestResults, TellWhatWasSkipped) {
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

TEST_F(TestResults, AreRefusedIfUnreadable) {
  EXPECT_THROW((void)read(), data::InputError);
  EXPECT_THROW((void)report::read_test_results(folder_ / "nowhere"), data::InputError);
  data::write_text(xml_ / "unit.A.xml", "<testsuites><testsuite>");
  EXPECT_THROW((void)read(), data::InputError);
  for (const std::string& broken :
       {property("comparisons", "many"), property("comparisons", "1"), property("tolerances.x", "1; 2")}) {
    write("unit.A.xml", "A", "Holds", "<properties>" + broken + "</properties>");
    EXPECT_THROW((void)read(), data::InputError) << broken;
  }
}

}  // namespace
}  // namespace stickslip
