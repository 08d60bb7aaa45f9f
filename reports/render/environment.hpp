// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "render/report.hpp"
#include "studies/common/members.hpp"

namespace stickslip::report {

/// What made the report, as plain text.
struct Environment {
  std::string version, commit;
  std::string date;      ///< of the report, ISO 8601, UTC; SOURCE_DATE_EPOCH if that is set
  std::string compiler;  ///< with its version
  std::string eigen, gsl;
  std::vector<std::pair<std::string, std::string>> rest;  ///< build type, system, tools
};
STICKSLIP_MEMBERS(Environment, (version, "-"), (commit, "-"), (date, "-"), (compiler, "-"), (eigen, "-"),
                  (gsl, "-"), (rest, "-"))

[[nodiscard]] Environment describe_environment(const ReportOptions& options,
                                               const std::filesystem::path& scratch);

}  // namespace stickslip::report
