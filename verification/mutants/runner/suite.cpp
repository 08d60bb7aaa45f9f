#include "suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "external_tool.hpp"
#include "fingerprint.hpp"
#include "stickslip/report/text_file.hpp"

namespace stickslip::mutants {

namespace fs = std::filesystem;

namespace {

constexpr double quick_seconds = 0.1, longest_seconds = 0.6;
constexpr long memory_limit_bytes = 4L << 30;

// What GoogleTest says on a line about a test: "[  FAILED  ] Suite.Name/0, where GetParam() = 3 (2 ms)".
std::string name_after(std::string_view line, std::string_view mark) {
  if (!line.starts_with(mark)) return "";
  line.remove_prefix(mark.size());
  return std::string(line.substr(0, line.find_first_of(", \r")));
}

struct ProgramRun {
  std::set<std::string> passed, failed;
  std::string unfinished;  // the test at work when the program ended
  int status{};
};

ProgramRun run(const TestProgram& program, const std::set<std::string>& tests, const fs::path& libraries,
               const fs::path& folder, double seconds, bool stop_at_first) {
  std::string filter = "--gtest_filter=";
  for (const auto& test : tests) filter += test + ':';
  const fs::path flags = folder / (program.kind + "-flags.txt"), log = folder / (program.kind + ".log");
  report::write_text(flags, filter + (stop_at_first ? "\n--gtest_fail_fast\n" : "\n"));
  ProgramRun result;
  result.status = report::run_tool(
      "timeout",
      {"--signal=KILL", std::to_string(std::lround(std::ceil(seconds))), "prlimit",
       fmt::format("--as={}", memory_limit_bytes), "--core=0", "env", "LD_LIBRARY_PATH=" + libraries.string(),
       program.file.string(), "--gtest_flagfile=" + flags.string(), "--gtest_color=no"},
      folder, log);
  std::istringstream stream(report::read_text(log));
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("[==========]") && line.find(" ran.") != std::string::npos) break;
    // Output without a final newline may stand before a mark.
    const std::size_t mark = line.find("[  FAILED  ] ");
    if (const auto name = name_after(line, "[ RUN      ] "); !name.empty()) result.unfinished = name;
    if (const auto name = name_after(line, "[       OK ] "); !name.empty()) result.passed.insert(name);
    if (mark != std::string::npos) result.failed.insert(name_after(line.substr(mark), "[  FAILED  ] "));
  }
  if (result.passed.contains(result.unfinished) || result.failed.contains(result.unfinished))
    result.unfinished.clear();
  return result;
}

double usual_seconds(const TestProgram& program, const std::set<std::string>& tests) {
  double sum = 0.0;
  for (const auto& test : tests) sum += program.seconds.at(test);
  return sum;
}

std::set<std::string> tests_that_take(const TestProgram& program, double above, double up_to) {
  std::set<std::string> tests;
  for (const auto& [test, seconds] : program.seconds)
    if (seconds > above && seconds <= up_to) tests.insert(test);
  return tests;
}

// Runs all tests and keeps what they take.
void measure(TestProgram& program, const fs::path& build_tree, const fs::path& folder) {
  const fs::path answer = folder / (program.kind + ".json");
  const std::string output = "--gtest_output=json:" + answer.string();
  const fs::path log = folder / (program.kind + "-baseline.log");
  const std::string filter = program.kind == "unit" ? "--gtest_filter=-*Command*:DrawnFigures*" : "";
  std::vector<std::string> arguments{output};
  if (!filter.empty()) arguments.push_back(filter);
  // Tests that are not about the models may fail here: some judge the very record that is to be made.
  if (report::run_tool(program.file.string(), arguments, build_tree, log) > 1)
    throw std::runtime_error(fmt::format("{} broke off; see {}", program.file.string(), log.string()));
  const auto results = nlohmann::json::parse(report::read_text(answer));
  for (const auto& suite : results.at("testsuites")) {
    const std::string suite_name = suite.at("name");
    for (const auto& test : suite.at("testsuite")) {
      const std::string file = fs::path(std::string(test.at("file"))).filename();
      if (program.kind == "unit" && !file.starts_with("solver_") && !file.starts_with("analytic_")) continue;
      const std::string name = suite_name + "." + std::string(test.at("name"));
      if (test.contains("failures"))
        throw std::runtime_error(fmt::format("{} fails without any mistake; see {}", name, log.string()));
      const std::string time = test.at("time");  // "0.012s"
      double seconds{};
      std::from_chars(time.data(), time.data() + time.size(), seconds);
      program.seconds[name] = seconds;
    }
  }
}

}  // namespace

std::set<std::string> quick_tests(const TestProgram& program) {
  return tests_that_take(program, -1.0, quick_seconds);
}
std::set<std::string> longer_tests(const TestProgram& program) {
  return tests_that_take(program, quick_seconds, longest_seconds);
}

std::vector<TestProgram> test_programs(const fs::path& build_tree, const fs::path& folder) {
  std::vector<TestProgram> programs;
  for (const char* kind : {"unit", "order", "paper", "cross"}) {
    TestProgram program{.kind = kind,
                        .file = build_tree / fmt::format("bin/stickslip_{}_tests", kind),
                        .seconds = {},
                        .fingerprint = {}};
    if (!fs::exists(program.file))
      throw std::runtime_error(program.file.string() + " is missing; build the preset 'mutants' first");
    program.fingerprint = report::Fingerprint().add_file(program.file).text();
    std::string key = program.fingerprint;
    for (const char* component : {"solver", "analytic"})
      key += report::Fingerprint()
                 .add_file(build_tree / fmt::format("{0}/libstickslip_{0}.so", component))
                 .text();
    const fs::path memory = folder / fmt::format("{}-baseline.json", kind);
    const auto known = nlohmann::json::parse(report::read_text(memory), nullptr, false);
    if (!known.is_discarded() && known.at("key") == key) {
      program.seconds = known.at("seconds").get<std::map<std::string, double>>();
    } else {
      fmt::print("all {} tests without a mistake\n", kind);
      std::fflush(stdout);
      measure(program, build_tree, folder);
      report::write_text(memory, nlohmann::json{{"key", key}, {"seconds", program.seconds}}.dump());
    }
    programs.push_back(std::move(program));
  }
  return programs;
}

std::vector<std::string> failing_tests(const TestProgram& program, std::set<std::string> tests,
                                       const fs::path& libraries, const fs::path& folder,
                                       bool stop_at_first) {
  std::vector<std::string> failing;
  for (int attempt = 0; attempt < 4 && !tests.empty(); ++attempt) {
    const double seconds = 4.0 + 6.0 * usual_seconds(program, tests);
    const ProgramRun result = run(program, tests, libraries, folder, seconds, stop_at_first);
    if (result.status != 0 && result.failed.empty() && result.unfinished.empty())
      return {tests.begin(), tests.end()};  // the program does not even start
    failing.insert(failing.end(), result.failed.begin(), result.failed.end());
    if (result.unfinished.empty()) break;
    failing.push_back(result.unfinished);
    if (stop_at_first) break;
    for (const auto& test : result.passed) tests.erase(test);
    for (const auto& test : failing) tests.erase(test);
  }
  std::ranges::sort(failing);
  return failing;
}

}  // namespace stickslip::mutants
