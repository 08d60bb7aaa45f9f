#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/data/paper.hpp"
#include "test_results.hpp"

namespace stickslip::report {

/// Counts over a test run.
struct TestCounts {
  std::size_t tests{}, failed{}, comparing{};
  std::size_t requirements{};
  int comparisons{};
  std::size_t tight{};     ///< classes of tolerances of a test whose largest margin is above 0.5
  std::size_t generous{};  ///< those whose largest margin is below 1e-3: the tolerance says little
};
[[nodiscard]] TestCounts test_counts(const std::vector<TestResult>& tests);

/// How many claims of the ledger have this verdict.
[[nodiscard]] std::size_t claims_with(const std::vector<data::Claim>& claims, data::ClaimVerdict verdict);

/// Rows: requirement, source, tests, largest margin.
[[nodiscard]] std::string requirement_rows(const std::vector<TestResult>& tests);

/// Rows, one for each comparison with a name: name, test, computed, reference, error, tolerance, margin.
[[nodiscard]] std::string named_comparison_rows(const std::vector<TestResult>& tests);

/// The ledger of one class of tolerances: test, comparisons, error, tolerance, margin and derivation of the
/// comparison with the largest margin.
[[nodiscard]] std::string tolerance_rows(const std::vector<TestResult>& tests,
                                         const std::string& tolerance_class);

/// Rows, one for each class of tolerances of a test whose largest margin is below 1e-3, or above 0.5: test,
/// class, error, tolerance, margin, derivation.
[[nodiscard]] std::string generous_rows(const std::vector<TestResult>& tests);
[[nodiscard]] std::string tight_rows(const std::vector<TestResult>& tests);

/// Rows, one for each test that compares numbers, under the heading of its requirement: test, computed,
/// reference, error, tolerance, margin, class of tolerance.
[[nodiscard]] std::string comparison_rows(const std::vector<TestResult>& tests);

/// The other tests, a paragraph for each requirement.
[[nodiscard]] std::string logical_tests(const std::vector<TestResult>& tests);

/// Rows, one for each defect of bad input: how many case files, options, columns and packages refuse it, and
/// how many accept it.
[[nodiscard]] std::string bad_input_rows(const std::vector<TestResult>& tests);

/// Rows, one for each reason to accept what looks like a defect: reason, how often; the most frequent first.
[[nodiscard]] std::string accepted_input_rows(const std::vector<TestResult>& tests);

/// Rows of the ledger: place and claim, how it was tested, what was found.
[[nodiscard]] std::string claim_rows(const std::vector<data::Claim>& claims,
                                     const std::vector<TestResult>& tests);

}  // namespace stickslip::report
