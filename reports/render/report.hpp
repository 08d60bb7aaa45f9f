// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/drawing.hpp"
#include "stickslip/data/case_file.hpp"

/// The V&V report: figures by gnuplot, a PDF by LaTeX, every number in it from a study.
namespace stickslip::report {

struct ReportOptions {
  std::filesystem::path output;  ///< folder that receives the figures and vv-report.pdf; made if missing
  /// Folder with GoogleTest's XML files of a test run, for the traceability; empty for none.
  std::filesystem::path tests{};
  std::vector<std::string> only;  ///< names of figures to render, without the PDF report; empty: everything
  std::vector<data::Override> overrides{};  ///< of the paper's cases; only with `only`
  Look look{};                              ///< size and font of the figures
  bool quiet{};                             ///< no progress on standard error, whatever that is
  std::string version;                      ///< of the program, for the title page
  std::string commit;                       ///< that was built, for the title page
};

/// Runs the studies on the paper's case and writes `<figure>.csv`, `.pdf` and `.png` for each figure and,
/// unless `only` is given, vv-report.pdf. Each file appears whole or not at all.
///
/// The folder's studies/ receives all numbers behind it as JSON: a file for each study, and what else the
/// templates of the report read.
///
/// Returns the names of the figures that are drawn.
///
/// Throws data::InputError for an unknown figure or an output folder that cannot be used, std::runtime_error
/// if gnuplot, Python or lualatex is missing or fails (the CSV files are in place by then).
std::vector<std::string> write_report(const ReportOptions& options);

/// What `only` may hold, in the order of the report. Figures 6 and 11 of the paper are in limits.
[[nodiscard]] std::vector<std::string> figure_names();

/// The folder with figures/ and report/: data::installed_folder() with the environment variable
/// STICKSLIP_REPORTS. Throws data::InputError if it lacks one of them.
[[nodiscard]] std::filesystem::path templates_directory();

}  // namespace stickslip::report
