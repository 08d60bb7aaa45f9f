// SPDX-License-Identifier: MIT
#include "render/document.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "render/external_tool.hpp"
#include "render/study_table.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/case_file.hpp"

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

namespace fs = std::filesystem;

namespace {

constexpr int most_runs = 4;

// Debian's, which has Jinja2, whatever other Python stands on the search path.
constexpr const char* python = "/usr/bin/python3";

bool mentions(const fs::path& log, std::initializer_list<std::string_view> phrases) {
  const std::string text = data::read_text(log);
  return std::ranges::any_of(phrases,
                             [&](std::string_view phrase) { return text.find(phrase) != std::string::npos; });
}

// "Rerun to get cross-references right.", "Table widths have changed. Rerun LaTeX."
bool wants_another_run(const fs::path& log) { return mentions(log, {"Rerun to get", "Rerun LaTeX"}); }

// "! Undefined control sequence." and the line after it, which says where.
std::string first_error(const fs::path& log) {
  std::ifstream stream(log);
  std::string line, next;
  while (std::getline(stream, line)) {
    if (!line.starts_with("! ")) continue;
    std::getline(stream, next);
    return fmt::format("{} {}", line.substr(2), next);
  }
  return "its log names no error";
}

void run_lualatex(const fs::path& folder) {
  const int status = run_tool("lualatex", {"-halt-on-error", "-interaction=nonstopmode", "vv-report.tex"},
                              folder, folder / "lualatex.out");
  if (status == 0) return;
  throw std::runtime_error(fmt::format("lualatex could not typeset the report (status {}): {}", status,
                                       first_error(folder / "vv-report.log")));
}

// The last line of what it says is its error message.
void run_script(const fs::path& script, std::vector<std::string> arguments, const fs::path& folder,
                std::string_view failure) {
  const fs::path log = folder / "render.log";
  arguments.insert(arguments.begin(), {"-I", "-B", (templates_directory() / script).string()});
  const int status = run_tool(python, arguments, folder, log);
  if (status == 0) return;
  std::string message = data::read_text(log);
  while (message.ends_with('\n')) message.pop_back();
  message.erase(0, message.rfind('\n') + 1);
  if (status == 2) throw data::InputError(message);
  throw std::runtime_error(fmt::format("{}: {}", failure, message));
}

void run_renderer(std::vector<std::string> arguments, const fs::path& folder) {
  run_script(fs::path("report") / "render.py", std::move(arguments), folder,
             "the templates of the report cannot be filled in");
}

std::runtime_error no_pdf(const ToolMissing& missing, const OutputFolder& output) {
  return std::runtime_error(fmt::format("{}, so that there is no PDF report; the figures are in {}",
                                        missing.what(), output.folder().string()));
}

}  // namespace

std::string read_test_results(const fs::path& tests) {
  const data::TemporaryFolder folder;
  const fs::path file = folder.path() / "tests.json";
  run_renderer({"tests", fs::absolute(tests).string(), file.string()}, folder.path());
  return data::read_text(file);
}

fs::path fill_in_templates(const fs::path& values, const OutputFolder& output) {
  const fs::path sources = output.scratch() / "latex";
  fs::create_directory(sources);
  try {
    run_renderer({"report", (templates_directory() / "report").string(), data::data_directory().string(),
                  values.string(), sources.string()},
                 output.scratch());
  } catch (const ToolMissing& missing) {
    throw no_pdf(missing, output);
  }
  return sources;
}

void write_site(const fs::path& values, OutputFolder& output) {
  const fs::path site = output.scratch() / "site";
  fs::create_directory(site);
  run_script(fs::path("site") / "site.py",
             {(templates_directory() / "report").string(), data::data_directory().string(), values.string(),
              output.folder().string(), site.string()},
             output.scratch(), "the pages of evidence cannot be made");
  fs::remove_all(output.folder() / "site");
  output.publish(site);
}

void typeset(const fs::path& sources, OutputFolder& output) {
  try {
    run_lualatex(sources);
    for (int run = 2; run <= most_runs; ++run) {
      run_lualatex(sources);
      if (!wants_another_run(sources / "vv-report.log")) break;
    }
  } catch (const ToolMissing& missing) {
    throw no_pdf(missing, output);
  }
  if (mentions(sources / "vv-report.log", {"undefined references", "multiply-defined labels"}))
    throw std::runtime_error(
        "the report refers to a figure, a table or a section that it does not have, or that stands twice");
  output.publish(sources / "vv-report.pdf");
}

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
