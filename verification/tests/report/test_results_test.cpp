/// What the report makes of GoogleTest's XML.

#include "test_results.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>
#include <string>

#include "paper_index.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/report/text_file.hpp"
#include "support/requirements.hpp"
#include "traceability.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;

class TestResults : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "cross.Figures");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::string& suite, const std::string& name,
             const std::string& inside) const {
    report::write_text(folder_ / file, "<?xml version=\"1.0\"?><testsuites><testsuite name=\"" + suite +
                                           "\"><testcase name=\"" + name + "\" classname=\"" + suite +
                                           "\" status=\"run\">" + inside +
                                           "</testcase></testsuite></testsuites>");
  }

  static std::string property(const std::string& name, const std::string& value) {
    return "<property name=\"" + name + "\" value=\"" + value + "\"/>";
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("stickslip-test-results-" + std::to_string(::getpid()));
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
  const auto results = report::read_test_results(folder_);
  ASSERT_EQ(results.size(), 1U);
  const report::TestResult& test = results.front();
  EXPECT_EQ(test.kind, "cross");
  EXPECT_EQ(test.suite, "Verdict");
  EXPECT_EQ(test.name, "IsPrinted/4a");
  EXPECT_TRUE(test.passed);
  EXPECT_EQ(test.requirement, "V1");
  EXPECT_EQ(test.requirement_position, 7);
  EXPECT_EQ(test.source, "Fig. 4");
  EXPECT_EQ(test.comparisons, 2);
  ASSERT_TRUE(test.worst.has_value());
  EXPECT_EQ(test.worst->computed, 2.5);
  EXPECT_EQ(test.worst->margin, 0.5);
  ASSERT_EQ(test.named.size(), 1U);
  EXPECT_EQ(test.named[0].name, "L1, closed form");
  EXPECT_EQ(test.named[0].expected, 3.125);
  EXPECT_EQ(test.named[0].tolerance_class, "discretisation");
  ASSERT_EQ(test.tolerances.size(), 1U);
  EXPECT_EQ(test.tolerances[0].tolerance_class, "reference");
  EXPECT_EQ(test.tolerances[0].comparisons, 2);
  EXPECT_EQ(test.tolerances[0].tolerance, 1.0);
  EXPECT_EQ(test.tolerances[0].derivation, "a datum; of which");
  EXPECT_EQ(test.claim, "fig4");
  EXPECT_EQ(test.finding, "35 Hz sticks");
}

TEST_F(TestResults, TellWhatFailed) {
  write("unit.A.xml", "A", "Holds", "");
  write("unit.B.xml", "B", "Fails", "<failure message=\"no\"/>");
  const auto results = report::read_test_results(folder_);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_TRUE(results[0].passed);
  EXPECT_FALSE(results[1].passed);
  const auto counts = report::test_counts(results);
  EXPECT_EQ(counts.tests, 2U);
  EXPECT_EQ(counts.failed, 1U);
  EXPECT_NE(report::logical_tests(results).find("Fails \\textbf{(failed)}"), std::string::npos);
}

TEST_F(TestResults, TellWhatWasSkipped) {
  write("unit.A.xml", "A", "Waits", "<skipped message=\"no pseudo-terminal\"/>");
  const auto results = report::read_test_results(folder_);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_FALSE(results[0].passed);
  EXPECT_EQ(report::test_counts(results).failed, 0U);
  EXPECT_NE(report::logical_tests(results).find("Waits \\textbf{(skipped)}"), std::string::npos);
}

TEST_F(TestResults, CountBadInputByDefectAndByReasonOverAllTests) {
  write("unit.A.xml", "A", "Options",
        "<properties>" + property("bad_input.option.zero", "3; 1") +
            property("accepted_input.nothing moves", "1") + "</properties>");
  write("unit.B.xml", "B", "More",
        "<properties>" + property("bad_input.option.zero", "5; 1") +
            property("bad_input.column.zero", "2; 0") + property("accepted_input.nothing moves", "1") +
            "</properties>");
  const auto results = report::read_test_results(folder_);
  EXPECT_EQ(report::bad_input_rows(results), "zero & 0 & 0 & 8 & 2 & 2 & 0 & 0 & 0 \\\\\n");
  EXPECT_EQ(report::accepted_input_rows(results), "nothing moves & 2 \\\\\n");
}

TEST_F(TestResults, ComeInTheOrderOfTheRequirements) {
  write("unit.B.xml", "B", "Second",
        "<properties>" + property("requirement_position", "10") + "</properties>");
  write("unit.C.xml", "C", "First", "<properties>" + property("requirement_position", "9") + "</properties>");
  const auto results = report::read_test_results(folder_);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].name, "First");
}

TEST_F(TestResults, AreRefusedWhereThereAreNoneOrTheyCannotBeRead) {
  EXPECT_THROW((void)report::read_test_results(folder_), data::InputError);
  EXPECT_THROW((void)report::read_test_results(folder_ / "nowhere"), data::InputError);
  report::write_text(folder_ / "unit.A.xml", "<testsuites><testsuite>");
  EXPECT_THROW((void)report::read_test_results(folder_), data::InputError);
  write("unit.A.xml", "A", "Holds", "<properties>" + property("comparisons", "many") + "</properties>");
  EXPECT_THROW((void)report::read_test_results(folder_), data::InputError);
  write("unit.A.xml", "A", "Holds", "<properties>" + property("compared.x", "1; 2; 3") + "</properties>");
  EXPECT_THROW((void)report::read_test_results(folder_), data::InputError);
}

TEST_F(TestResults, ListTheTolerancesThatSayNothingAndThoseThatAreNearlyUsedUp) {
  const auto with_margin = [](const std::string& margin) {
    return "<properties>" + property("comparisons", "1") + property("computed", "1") +
           property("expected", "1") + property("error", "1") + property("tolerance", "1") +
           property("margin", margin) + property("class", "round-off") +
           property("tolerances.round-off", "1; 1; 1; " + margin + "; a sum") + "</properties>";
  };
  write("unit.A.xml", "A", "Generous", with_margin("1e-4"));
  write("unit.B.xml", "B", "Fair", with_margin("0.1"));
  write("unit.C.xml", "C", "Tight", with_margin("0.75"));
  const auto results = report::read_test_results(folder_);
  const auto generous = report::generous_rows(results), tight = report::tight_rows(results);
  EXPECT_NE(generous.find("Generous"), std::string::npos);
  EXPECT_EQ(generous.find("Fair"), std::string::npos);
  EXPECT_EQ(generous.find("Tight"), std::string::npos);
  EXPECT_NE(tight.find("Tight"), std::string::npos);
  EXPECT_EQ(tight.find("Fair"), std::string::npos);
  EXPECT_EQ(tight.find("Generous"), std::string::npos);
  for (const char* name : {"Generous", "Fair", "Tight"})
    EXPECT_NE(report::tolerance_rows(results, "round-off").find(name), std::string::npos) << name;
  EXPECT_EQ(report::tolerance_rows(results, "reference"), "");
}

STICKSLIP_VERIFIES(PaperIndex, "U6");
TEST(PaperIndex, ReadsTheNumbersOfEquationsAndFigures) {
  using Numbers = std::set<int>;
  EXPECT_EQ(report::numbers_named("Eqs. (1) to (3), (24) to (28); E3", "Eq"),
            (Numbers{1, 2, 3, 24, 25, 26, 27, 28}));
  EXPECT_EQ(report::numbers_named("Eq. (4) and the text below it", "Eq"), (Numbers{4}));
  EXPECT_EQ(report::numbers_named("Eqs. (9) and (11)", "Eq"), (Numbers{9, 11}));
  EXPECT_EQ(report::numbers_named("Eqs. (6), (7); Fig. 2", "Eq"), (Numbers{6, 7}));
  EXPECT_EQ(report::numbers_named("Sect. 3, text on Figs. 3b and 4b", "Fig"), (Numbers{3, 4}));
  EXPECT_EQ(report::numbers_named("Sect. 5, text on Fig. 12, and Sect. 4", "Fig"), (Numbers{12}));
  EXPECT_EQ(report::numbers_named("Sect. 5; E6", "Fig"), Numbers{});
}

TEST(PaperIndex, HasARequirementOrAClaimForEveryEquationAndFigure) {
  std::string places;
  for (const auto& requirement : testing::requirements()) places += std::string(requirement.source) + "; ";
  for (const auto& claim : data::claims()) places += claim.place + "; ";
  const auto equations = report::numbers_named(places, "Eq"), figures = report::numbers_named(places, "Fig");
  for (int number = 1; number <= report::paper_equations; ++number)
    EXPECT_TRUE(equations.contains(number)) << number;
  for (int number = 1; number <= report::paper_figures; ++number)
    EXPECT_TRUE(figures.contains(number)) << number;
  EXPECT_EQ(*equations.rbegin(), report::paper_equations);
  EXPECT_EQ(*figures.rbegin(), report::paper_figures);
}

}  // namespace
}  // namespace stickslip
