// SPDX-License-Identifier: MIT
#include "render/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command.hpp"
#include "commands.hpp"
#include "stickslip/version.hpp"

namespace stickslip::cli {

namespace {

Answer vv_report(const report::ReportOptions& options, Outputs& outputs) {
  report::ReportOptions of_this_build = options;
  of_this_build.version = version;
  of_this_build.commit = commit;
  of_this_build.quiet = outputs.is_quiet();
  report::write_report(of_this_build);
  return Answer();
}

void add_options(CLI::App& command, report::ReportOptions& options) {
  options.output = "vv-report";
  command.add_option("--output", options.output, "Folder for vv-report.pdf and the figures (CSV, PDF, PNG)")
      ->check(file_name())
      ->capture_default_str();
  command
      .add_option("--tests", options.tests,
                  "Folder with GoogleTest's XML files of a test run, for the traceability matrix")
      ->check(folder())
      ->type_name("FOLDER");
  command
      .add_option("--only", options.only,
                  fmt::format("Only these figures, without the PDF report: {}",
                              fmt::join(report::figure_names(), ", ")))
      ->delimiter(',')
      ->type_name("FIG,...")
      ->excludes("--tests")
      ->allow_extra_args(false);
  add_threads_option(command);
}

}  // namespace

void add_report_command(CLI::App& app) {
  add<report::ReportOptions>(app, {.name = "report",
                                   .help = "Figures and V&V report as PDF, from runs of both implementations",
                                   .examples = {"stickslip report --only fig1,fig2 --output figures"},
                                   .add_options = add_options,
                                   .run = vv_report});
}

}  // namespace stickslip::cli
