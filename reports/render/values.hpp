// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "render/environment.hpp"
#include "render/study_results.hpp"

namespace stickslip::report {

/// Runs the studies that no figure has run and writes what the templates read besides the results of studies:
/// environment, cases and findings, each as <name>.json.
void write_values(StudyResults& results, const Environment& environment, const std::filesystem::path& folder);

}  // namespace stickslip::report
