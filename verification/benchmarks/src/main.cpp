// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "record.hpp"
#include "render/text_file.hpp"

/// Accepts the options of Google Benchmark and --record FILE, which writes the record for the report.
int main(int argc, char** argv) {
  std::vector<char*> arguments;
  std::string record;
  for (int i = 0; i < argc; ++i) {
    if (std::string(argv[i]) == "--record" && i + 1 < argc)
      record = argv[++i];
    else
      arguments.push_back(argv[i]);
  }
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  stickslip::benchmarks::Recorder recorder;
  benchmark::RunSpecifiedBenchmarks(&recorder);
  try {
    if (!record.empty()) stickslip::report::replace_text(record, text_of(recorder.record()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "stickslip_benchmarks: {}\n", error.what());
    return 1;
  }
  return 0;
}
