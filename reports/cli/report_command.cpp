// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "case_options.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "render/report.hpp"
#include "stickslip/version.hpp"

namespace stickslip::cli {

void add_report_command(CLI::App& app) {
  auto* command =
      app.add_subcommand("report", "Figures and V&V report as PDF, from runs of both implementations");
  auto options = std::make_shared<report::ReportOptions>();
  options->output = "vv-report";
  options->version = version;
  options->commit = commit;
  command->add_option("--output", options->output, "Folder for vv-report.pdf and the figures (CSV, PDF, PNG)")
      ->check(file_name())
      ->capture_default_str();
  command
      ->add_option("--tests", options->tests,
                   "Folder with GoogleTest's XML files of a test run, for the traceability matrix")
      ->check(file_name())
      ->type_name("FOLDER");
  command
      ->add_option("--only", options->only,
                   fmt::format("Only these figures, without the PDF report: {}",
                               fmt::join(report::figure_names(), ", ")))
      ->delimiter(',')
      ->type_name("FIG,...")
      ->excludes("--tests")
      ->allow_extra_args(false);
  add_threads_option(*command);
  add_examples(*command, {"stickslip report --only fig1,fig2 --output figures"});
  command->callback([options] {
    options->quiet = is_quiet();
    report::write_report(*options);
  });
}

}  // namespace stickslip::cli
