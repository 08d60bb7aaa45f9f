// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "render/output_folder.hpp"
#include "render/report.hpp"

namespace stickslip::report {

/// GoogleTest's XML files of a folder as one JSON text. Throws data::InputError if there are none, or one
/// cannot be used.
[[nodiscard]] std::string read_test_results(const std::filesystem::path& tests);

/// Fills in the templates of the report from the JSON files in the folder `values`; returns the folder with
/// the LaTeX sources. Throws std::runtime_error, naming the template and the value, if one is missing.
[[nodiscard]] std::filesystem::path fill_in_templates(const std::filesystem::path& values,
                                                      const OutputFolder& output);

/// Makes the pages of evidence, the folder `site`, from the JSON files in the folder `values` and the figures in the
/// folder of the report. Throws std::runtime_error if that fails.
void write_site(const std::filesystem::path& values, OutputFolder& output);

/// Runs lualatex on vv-report.tex until references settle and moves vv-report.pdf in place. Throws
/// std::runtime_error, with LaTeX's first error, if that fails or lualatex is missing.
void typeset(const std::filesystem::path& sources, OutputFolder& output);

/// What made the report, as JSON for the templates: version and commit, date (ISO 8601, UTC; SOURCE_DATE_EPOCH if that is
/// set), compiler, libraries, system and tools.
[[nodiscard]] std::string environment_json(const ReportOptions& options,
                                           const std::filesystem::path& scratch);

}  // namespace stickslip::report
