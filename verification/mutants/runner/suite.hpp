#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "stickslip/mutants/record.hpp"

namespace stickslip::mutants {

/// One of the suite's programs, and what a run without a mistake showed.
struct TestProgram {
  std::string kind;  ///< unit, order, paper or cross
  std::filesystem::path file;
  std::map<std::string, double> seconds;  ///< of each test about the models
  std::string fingerprint;                ///< of the file
};

/// The tests that are quick enough for every mutant to face all of them: up to 0.1 s.
[[nodiscard]] std::set<std::string> quick_tests(const TestProgram& program);
/// Those that only a survivor of the quick ones faces: up to 0.6 s.
[[nodiscard]] std::set<std::string> longer_tests(const TestProgram& program);

/// The four programs of a build tree, each of whose tests about the models has passed. Of the unit tests
/// these are the ones in files solver_* and analytic_*. What the programs showed is kept in `folder`, and
/// asked again when a program or a library has changed. Throws std::runtime_error if a test fails.
[[nodiscard]] std::vector<TestProgram> test_programs(const std::filesystem::path& build_tree,
                                                     const std::filesystem::path& folder);

/// Runs tests of a program against the libraries in `libraries` and returns those that do not pass: that
/// fail, end the program, or are at work when its time is up, which is six times the usual one and four
/// seconds. What is left is then run again without them, up to three times. With `stop_at_first`, returns
/// with the first. Logs into `folder`.
[[nodiscard]] std::vector<std::string> failing_tests(const TestProgram& program, std::set<std::string> tests,
                                                     const std::filesystem::path& libraries,
                                                     const std::filesystem::path& folder, bool stop_at_first);

}  // namespace stickslip::mutants
