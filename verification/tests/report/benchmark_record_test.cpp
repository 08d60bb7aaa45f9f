// SPDX-License-Identifier: MIT
/// What the report shows of the benchmarks is in the record of their last run.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "stickslip/data/toml_file.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

const std::filesystem::path benchmarks = STICKSLIP_SOURCE_DIRECTORY "/verification/benchmarks";

STICKSLIP_VERIFIES(BenchmarkRecord, "U8");
TEST(BenchmarkRecord, HasATimeForEachComparison) {
  std::ifstream file(benchmarks / "results" / "speed.json");
  const auto record = nlohmann::json::parse(file);
  EXPECT_FALSE(record.at("context").at("processor").get<std::string>().empty());
  std::map<std::string, double> times;
  for (const auto& timed : record.at("benchmarks")) times[timed.at("run_name")] = timed.at("real_time");
  const auto comparisons =
      data::read_all(benchmarks / "comparisons.toml", "comparison",
                     {"work", "plain", "plain_benchmark", "fast", "fast_benchmark", "repetitions"},
                     [&](const data::Record& line) {
                       for (const char* benchmark : {"plain_benchmark", "fast_benchmark"})
                         EXPECT_GT(times[line.text(benchmark)], 0.0) << line.text(benchmark);
                       return line.text("work") + line.text("plain") + line.text("fast");
                     });
  EXPECT_GE(comparisons.size(), 10u);
  for (const char* elements : {"20", "100", "500", "2000", "20000"})
    EXPECT_GT(times[std::string("elements/") + elements], 0.0) << elements;
}

}  // namespace
}  // namespace stickslip::testing
