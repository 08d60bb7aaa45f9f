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

}  // namespace stickslip::report
