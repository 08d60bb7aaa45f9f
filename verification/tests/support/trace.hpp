// SPDX-License-Identifier: MIT
#pragma once

/// The traceability of a test run. While a test runs, every comparison of two numbers (tolerance.hpp) is
/// noted here; when it ends, GoogleTest's XML receives as properties of the test
///
///     requirement, requirement_position, requirement_text, source   what it serves (requirements.hpp)
///
/// and those of Trace::properties(). A test that serves no requirement fails.

#include <map>
#include <string>

namespace stickslip::testing {

/// What a comparison found.
struct ComparedNumber {
  double computed{}, expected{}, error{}, tolerance{};
  std::string tolerance_class;  ///< round-off, discretisation or reference
  std::string derivation;

  /// Error over tolerance: above 1 the comparison has failed. Infinite for NaN.
  [[nodiscard]] double margin() const;
};

/// The comparisons of one test.
class Trace {
 public:
  void note(const ComparedNumber& comparison);

  /// comparisons                             how many there were
  /// computed, expected, error, tolerance, margin, class, derivation   of the one with the largest margin
  /// tolerances.<class>                      "how many; error; tolerance; margin; derivation" of those of the
  ///                                         class, the four last ones of that with the largest margin
  ///
  /// A comparison that fails in a test that passes was meant to fail, and is left out.
  [[nodiscard]] std::map<std::string, std::string> properties(bool test_passed) const;

 private:
  std::multimap<double, ComparedNumber> by_margin_;
};

/// Notes a comparison of the running test.
void note(const ComparedNumber& comparison);

}  // namespace stickslip::testing
