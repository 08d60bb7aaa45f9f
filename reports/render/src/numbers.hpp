#pragma once

#include <string>

#include "environment.hpp"
#include "study_results.hpp"
#include "test_results.hpp"

namespace stickslip::report {

/// numbers.tex: one macro for each number in the running text and the captions.
[[nodiscard]] std::string make_numbers(StudyResults& results, const Environment& environment,
                                       const std::vector<TestResult>& tests);

}  // namespace stickslip::report
