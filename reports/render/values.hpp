// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "render/report.hpp"

namespace stickslip::report {

/// What made the report, as JSON for the templates: version and commit, date (ISO 8601, UTC; SOURCE_DATE_EPOCH if that is
/// set), compiler, libraries, system and tools.
[[nodiscard]] std::string environment_json(const ReportOptions& options,
                                           const std::filesystem::path& scratch);

/// The record of the benchmarks, as JSON for the templates.
[[nodiscard]] std::string speed_json();

}  // namespace stickslip::report
