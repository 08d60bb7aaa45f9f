#pragma once

#include <map>
#include <string>

#include "environment.hpp"
#include "stickslip/report/output_folder.hpp"
#include "study_results.hpp"
#include "test_results.hpp"

namespace stickslip::report {

/// What the LaTeX template gets from the studies: file name and contents.
using Document = std::map<std::string, std::string>;

/// numbers.tex and the tables. Runs the studies that no figure has run; `tests` may be empty.
[[nodiscard]] Document make_document(StudyResults& results, const Environment& environment,
                                     const std::vector<TestResult>& tests);

/// Puts the generated files beside the template in the scratch folder, runs pdflatex until references settle
/// and moves vv-report.pdf in place. Throws std::runtime_error, with LaTeX's first error, if that fails or
/// pdflatex is missing.
void typeset_document(const Document& document, OutputFolder& output);

}  // namespace stickslip::report
