/// Every test suite of every program serves exactly one requirement, and no requirement names a suite that
/// does not exist; comparisons are recorded for the report.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "support/listed_tests.hpp"
#include "support/requirements.hpp"
#include "support/trace.hpp"

namespace stickslip::testing {
namespace {

// Names of the test suites of all programs, without the prefixes of instantiations.
std::set<std::string> all_suites() {
  std::set<std::string> suites;
  for (const std::string& test : listed_tests()) {
    const std::size_t end = test.find('.'), slash = test.find('/');
    const std::size_t begin = slash < end ? slash + 1 : 0;
    suites.insert(test.substr(begin, end - begin));
  }
  return suites;
}

TEST(Traceability, EverySuiteServesExactlyOneRequirement) {
  for (const std::string& suite : all_suites()) {
    const auto serves = [&](const Requirement& requirement) {
      return std::ranges::any_of(requirement.suites,
                                 [&](auto pattern) { return stands_for(pattern, suite); });
    };
    EXPECT_EQ(std::ranges::count_if(requirements(), serves), 1) << suite;
  }
}

TEST(Traceability, EveryRequirementHasTheSuitesThatItNames) {
  const std::set<std::string> suites = all_suites();
  std::set<std::string_view> ids;
  for (const Requirement& requirement : requirements()) {
    EXPECT_TRUE(ids.insert(requirement.id).second) << requirement.id << " stands twice";
    EXPECT_FALSE(requirement.suites.empty()) << requirement.id;
    for (const std::string_view pattern : requirement.suites)
      EXPECT_TRUE(std::ranges::any_of(suites, [&](const auto& suite) { return stands_for(pattern, suite); }))
          << requirement.id << " names the suite " << pattern << ", which no program has";
  }
}

TEST(Traceability, InstantiatedSuitesServeTheRequirementOfTheirSuite) {
  ASSERT_NE(requirement_of("Figures4And5/Verdict"), nullptr);
  EXPECT_EQ(requirement_of("Figures4And5/Verdict"), requirement_of("Verdict"));
  EXPECT_EQ(requirement_of("NoSuchSuite"), nullptr);
}

Comparison compared(double computed, double error, double tolerance, const std::string& name = "") {
  return {name, computed, computed - error, error, tolerance, "reference", "a datum"};
}

TEST(Trace, TellsOfTheComparisonWithTheLargestMargin) {
  Trace trace;
  trace.note(compared(1.0, 0.0, 0.5));
  trace.note(compared(2.5, 0.25, 0.5));
  trace.note(compared(3.0, 0.125, 0.5));
  const auto properties = trace.properties(true);
  EXPECT_EQ(properties.at("comparisons"), "3");
  EXPECT_EQ(properties.at("computed"), "2.5");
  EXPECT_EQ(properties.at("expected"), "2.25");
  EXPECT_EQ(properties.at("error"), "0.25");
  EXPECT_EQ(properties.at("tolerance"), "0.5");
  EXPECT_EQ(properties.at("margin"), "0.5");
  EXPECT_EQ(properties.at("class"), "reference");
}

TEST(Trace, KeepsEachNamedComparison) {
  Trace trace;
  trace.note(compared(3.0, 0.125, 0.5, "a number"));
  trace.note(compared(2.5, 0.25, 0.5));
  EXPECT_EQ(trace.properties(true).at("compared.a number"), "3; 2.875; 0.125; 0.5; 0.25; reference; a datum");
}

TEST(Trace, KeepsTheLedgerOfEachClassOfTolerances) {
  Trace trace;
  trace.note(compared(3.0, 0.125, 0.5));
  trace.note(compared(2.5, 0.25, 0.5));
  trace.note({"", 1.0, 1.0, 0.0, 1e-15, "round-off", "a sum; of two"});
  const auto properties = trace.properties(true);
  EXPECT_EQ(properties.at("tolerances.reference"), "2; 0.25; 0.5; 0.5; a datum");
  EXPECT_EQ(properties.at("tolerances.round-off"), "1; 0; 1e-15; 0; a sum; of two");
}

TEST(Trace, LeavesOutWhatWasMeantToFail) {
  Trace trace;
  trace.note(compared(1.0, 0.25, 0.5));
  trace.note(compared(2.0, 1.0, 0.5));
  EXPECT_EQ(trace.properties(true).at("margin"), "0.5");
  EXPECT_EQ(trace.properties(true).at("comparisons"), "1");
  EXPECT_EQ(trace.properties(false).at("margin"), "2");
}

TEST(Trace, OfNotANumberFails) {
  Trace trace;
  trace.note(compared(std::nan(""), std::nan(""), 0.5));
  EXPECT_EQ(trace.properties(false).at("margin"), "inf");
}

}  // namespace
}  // namespace stickslip::testing
