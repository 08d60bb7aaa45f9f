#pragma once

#include "document.hpp"
#include "environment.hpp"
#include "studies/common/input_matrix.hpp"
#include "study_results.hpp"
#include "test_results.hpp"

namespace stickslip::report {

/// The rows of every table of the report, as table-*.tex; columns, heads and captions are the template's.
[[nodiscard]] Document make_tables(StudyResults& results, const Environment& environment,
                                   const std::vector<TestResult>& tests,
                                   const std::vector<studies::BadInput>& inputs);

}  // namespace stickslip::report
