// SPDX-License-Identifier: MIT
#include "render/values.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>

#include "render/external_tool.hpp"
#include "render/json_text.hpp"

namespace stickslip::report {

namespace {

using nlohmann::json;

// The moment that reproducible builds give, else now.
std::time_t time_of_report() {
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH"); epoch != nullptr) {
    const std::string_view text(epoch);
    long long seconds = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (error == std::errc{} && end == text.data() + text.size()) return static_cast<std::time_t>(seconds);
  }
  return std::time(nullptr);
}

std::string distribution() {
  std::ifstream stream("/etc/os-release");
  const std::string_view key = "PRETTY_NAME=\"";
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(key) && line.ends_with('"'))
      return line.substr(key.size(), line.size() - key.size() - 1);
  return "unknown";
}

std::string kernel() {
  utsname name{};
  return ::uname(&name) == 0 ? fmt::format("{} {}, {}", name.sysname, name.release, name.machine) : "unknown";
}

std::string or_unknown(const std::string& text) { return text.empty() ? "unknown" : text; }

}  // namespace

std::string environment_json(const ReportOptions& options, const std::filesystem::path& scratch) {
  return json_text(
      {{"version", or_unknown(options.version)},
       {"commit", or_unknown(options.commit)},
       {"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(time_of_report()))},
       {"compiler", STICKSLIP_COMPILER},
       {"eigen", STICKSLIP_EIGEN_VERSION},
       {"gsl", STICKSLIP_GSL_VERSION},
       {"rest", json::array({json::array({"Build type", or_unknown(STICKSLIP_BUILD_TYPE)}),
                             json::array({"System", distribution()}), json::array({"Kernel", kernel()}),
                             json::array({"Figures", tool_version("gnuplot", scratch)}),
                             json::array({"Typesetting", tool_version("lualatex", scratch)})})}});
}

}  // namespace stickslip::report
