// SPDX-License-Identifier: MIT
/// Each test serves a known requirement, and comparisons and benchmarks are recorded for the report.

#include <gtest/gtest-spi.h>

#include <nlohmann/json.hpp>

#include "stickslip/data/toml_file.hpp"
#include "support/testing.hpp"
#include "support/trace.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(Traceability, "U6");
TEST(Traceability, RequirementsHaveDifferentIds) {
  std::set<std::string> ids;
  for (const Requirement& requirement : requirements())
    EXPECT_TRUE(ids.insert(requirement.id).second) << requirement.id << " stands twice";
}

TEST(Traceability, TakesInstantiatedSuites) {
  EXPECT_EQ(requirement_of("Trace"), "U6");
  EXPECT_EQ(requirement_of("Figures4And5/Trace"), "U6");
}

TEST(Traceability, RefusesUnknownRequirements) {
  EXPECT_EQ(requirement_of("NoSuchSuite"), "");
  EXPECT_NONFATAL_FAILURE(record_requirement(""), "the suite states no requirement");
  EXPECT_NONFATAL_FAILURE(record_requirement("Z9"), "has no requirement Z9");
}

ComparedNumber compared(double computed, double error, double tolerance) {
  return {computed, computed - error, error, tolerance, "reference", "a datum"};
}

STICKSLIP_VERIFIES(Trace, "U6");
TEST(Trace, KeepsTheLargestOfEachClass) {
  Trace trace;
  trace.note(compared(1.0, 0.0, 0.5));
  trace.note(compared(2.5, 0.25, 0.5));
  trace.note(compared(3.0, 0.125, 0.5));
  trace.note({1.0, 1.0, 0.0, 1e-15, "round-off", "a sum; of two"});
  EXPECT_EQ(trace.properties(true),
            (std::map<std::string, std::string>{{"comparisons", "4"},
                                                {"computed", "2.5"},
                                                {"expected", "2.25"},
                                                {"error", "0.25"},
                                                {"tolerance", "0.5"},
                                                {"margin", "0.5"},
                                                {"class", "reference"},
                                                {"derivation", "a datum"},
                                                {"tolerances.reference", "3; 0.25; 0.5; 0.5; a datum"},
                                                {"tolerances.round-off", "1; 0; 1e-15; 0; a sum; of two"}}));
}

TEST(Trace, LeavesOutWhatWasMeantToFail) {
  Trace trace;
  trace.note(compared(1.0, 0.25, 0.5));
  trace.note(compared(2.0, 1.0, 0.5));
  EXPECT_EQ(trace.properties(true).at("margin"), "0.5");
  EXPECT_EQ(trace.properties(true).at("comparisons"), "1");
  EXPECT_EQ(trace.properties(false).at("margin"), "2");
  trace.note(compared(std::nan(""), std::nan(""), 0.5));
  EXPECT_EQ(trace.properties(false).at("margin"), "inf");
}

// --- benchmarks

const std::filesystem::path benchmarks = STICKSLIP_SOURCE_DIRECTORY "/verification/benchmarks";

STICKSLIP_VERIFIES(BenchmarkRecord, "U8");
TEST(BenchmarkRecord, HasATimeForEachComparison) {
  std::ifstream file(benchmarks / "results" / "speed.json");
  const auto record = nlohmann::json::parse(file);
  EXPECT_FALSE(record.at("context").at("processor").get<std::string>().empty());
  std::map<std::string, double> times;
  for (const auto& timed : record.at("benchmarks")) times[timed.at("run_name")] = timed.at("real_time");
  const auto comparisons = data::read_all(
      benchmarks / "comparisons.toml", "comparison",
      {"work", "plain", "plain_benchmark", "fast", "fast_benchmark"}, [&](const data::Record& line) {
        for (const char* benchmark : {"plain_benchmark", "fast_benchmark"})
          EXPECT_GT(times[line.text(benchmark)], 0.0) << line.text(benchmark);
        return line.text("work") + line.text("plain") + line.text("fast");
      });
  EXPECT_GE(comparisons.size(), 7u);
  for (const char* elements : {"20", "100", "500", "2000", "20000"})
    EXPECT_GT(times[std::string("elements/") + elements], 0.0) << elements;
}

}  // namespace
}  // namespace stickslip::testing
