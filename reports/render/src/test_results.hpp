#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip::report {

/// A comparison of two numbers that a test made.
struct TestComparison {
  std::string name;  ///< what was compared; may be empty
  double computed{}, expected{}, error{}, tolerance{};
  double margin{};  ///< error over tolerance
  std::string tolerance_class;
};

/// The tolerances of one class that a test used: the closest of them.
struct ToleranceEntry {
  std::string tolerance_class;  ///< round-off, discretisation or reference
  int comparisons{};
  double error{}, tolerance{};
  double margin{};  ///< the largest
  std::string derivation;
};

/// A test as its XML tells of it.
struct TestResult {
  std::string kind;   ///< of the program that holds it: unit, order, paper, cross or slow
  std::string suite;  ///< without the prefix of an instantiation
  std::string name;   ///< "IsThePrintedOneByBothImplementations/Figure4a"
  bool passed{};
  bool skipped{};
  std::string requirement, requirement_text, source;
  int requirement_position{};  ///< in the list of requirements
  int comparisons{};
  std::optional<TestComparison> worst;     ///< the one with the largest margin, if there was any
  std::vector<TestComparison> named;       ///< those with a name
  std::vector<ToleranceEntry> tolerances;  ///< by class
  std::string claim, finding;              ///< of the ledger, where the test judges one
  std::map<std::string, std::pair<int, int>> bad_input;  ///< refused and accepted, by "<place>.<defect>"
  std::map<std::string, int> accepted_input;             ///< by the reason why it is accepted
};

/// The results in a folder of GoogleTest's XML files, by requirement, then suite, then name. Throws
/// data::InputError if the folder holds no such file, or one that cannot be read.
[[nodiscard]] std::vector<TestResult> read_test_results(const std::filesystem::path& folder);

}  // namespace stickslip::report
