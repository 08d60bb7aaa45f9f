#pragma once

/// The traceability of a test run. While a test runs, every comparison of two numbers (tolerance.hpp) is
/// noted here; when it ends, GoogleTest's XML receives as properties of the test
///
///     requirement, requirement_position, requirement_text, source   what the test's suite serves
///     (requirements.hpp) comparisons                             how many there were computed, expected,
///     error, tolerance, margin, class, derivation   of the one with the largest margin compared.<name> the
///     same of each named comparison, separated by "; "
///
/// The margin is error over tolerance: above 1 the comparison has failed.

#include <string>

namespace stickslip::testing {

/// What a comparison found.
struct Comparison {
  std::string name;  ///< what was compared, as the report names it; may be empty
  double computed{}, expected{}, error{}, tolerance{};
  std::string tolerance_class;  ///< round-off, discretisation or reference
  std::string derivation;
};

void note(const Comparison& comparison);

}  // namespace stickslip::testing
