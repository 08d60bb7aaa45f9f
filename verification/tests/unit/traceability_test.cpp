/// Every test suite of every program serves exactly one requirement, and no requirement names a suite that
/// does not exist; comparisons are recorded for the report.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <set>
#include <string>

#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

// Names of the test suites of all programs, without the prefixes of instantiations.
std::set<std::string> all_suites() {
  std::set<std::string> suites;
  for (const std::string program : {STICKSLIP_TEST_PROGRAMS}) {
    const std::string command = "'" + program + "' --gtest_list_tests";
    const auto close = [](std::FILE* stream) { ::pclose(stream); };
    const std::unique_ptr<std::FILE, decltype(close)> stream(::popen(command.c_str(), "r"), close);
    std::array<char, 1000> line{};
    int found = 0;
    while (stream && std::fgets(line.data(), line.size(), stream.get()) != nullptr) {
      const std::string text(line.data());
      const std::size_t end = text.find('.');
      if (text.starts_with(' ') || text.starts_with("Running main") || end == std::string::npos) continue;
      const std::size_t slash = text.find('/');
      const std::size_t begin = slash < end ? slash + 1 : 0;
      suites.insert(text.substr(begin, end - begin));
      ++found;
    }
    EXPECT_GT(found, 0) << program << " lists no tests";
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

// What the properties of a finished test say of it, in the XML of a run of its own.
std::string properties_of(const std::string& test) {
  const std::string file = ::testing::TempDir() + "stickslip-traceability.xml";
  const std::string own_program = ::testing::internal::GetArgvs().front();
  const std::string command =
      "'" + own_program + "' --gtest_filter=" + test + " --gtest_output=xml:" + file + " > /dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::string text;
  const auto close = [](std::FILE* stream) { std::fclose(stream); };
  const std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(file.c_str(), "r"), close);
  for (int c = 0; stream && (c = std::fgetc(stream.get())) != EOF;) text += static_cast<char>(c);
  std::remove(file.c_str());
  return text;
}

TEST(Traceability, ComparisonsPassUpToTheirTolerance) {
  EXPECT_TRUE(within(1.0, 1.0, reference(0.5, "a datum")));
  EXPECT_TRUE(within(2.5, 2.0, reference(0.5, "another datum")));
  EXPECT_TRUE(within(3.0, 3.125, discretisation(0.25, 2.0, "a law"), "a number"));
}

TEST(Traceability, RecordsTheComparisonWithTheLargestMarginAndThoseWithAName) {
  const std::string xml = properties_of("Traceability.ComparisonsPassUpToTheirTolerance");
  for (const std::string property :
       {"name=\"requirement\" value=\"U5\"", "name=\"comparisons\" value=\"3\"",
        "name=\"computed\" value=\"2.5\"", "name=\"expected\" value=\"2\"", "name=\"error\" value=\"0.5\"",
        "name=\"tolerance\" value=\"0.5\"", "name=\"margin\" value=\"1\"",
        "name=\"class\" value=\"reference\"",
        "name=\"compared.a number\" value=\"3; 3.125; 0.125; 0.5; 0.25; discretisation; a law predicts 0.25, "
        "margin 2\""})
    EXPECT_NE(xml.find(property), std::string::npos) << property << " is missing in\n" << xml;
}

}  // namespace
}  // namespace stickslip::testing
