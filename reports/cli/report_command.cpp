// SPDX-License-Identifier: MIT
#include "render/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "stickslip/version.hpp"

namespace stickslip::cli {

namespace {

struct Options : report::ReportOptions {
  std::vector<std::string> set;
};

Answer vv_report(const Options& options, Outputs& outputs) {
  report::ReportOptions of_this_build = options;
  for (const std::string& text : options.set) of_this_build.overrides.push_back(data::Override::parse(text));
  of_this_build.look = outputs.look();
  of_this_build.version = version;
  of_this_build.commit = commit;
  of_this_build.quiet = outputs.is_quiet();
  const auto drawn = report::write_report(of_this_build);
  Answer answer;
  if (!options.only.empty())
    answer.add_line(fmt::format("{} in {}, each as .pdf, .png and .csv", fmt::join(drawn, ", "),
                                options.output.string()));
  else
    answer.add_line(fmt::format("{0}/vv-report.pdf, its figures in {0}, pages of evidence in {0}/site",
                                options.output.string()));
  return answer;
}

void add_options(CLI::App& command, Options& options) {
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
                  fmt::format("Only these figures, without the PDF report (fig6 and fig11 are in limits): {}",
                              fmt::join(report::figure_names(), ", ")))
      ->delimiter(',')
      ->type_name("FIG,...")
      ->excludes("--tests")
      ->allow_extra_args(false);
  add_set_option(command, options.set,
                 "Replace a key of the paper's cases, as in friction.decay=2; repeatable");
  command.get_option("--set")->needs("--only");
  add_look_options(command, "--only");
  add_threads_option(command);
}

}  // namespace

void add_report_command(CLI::App& app) {
  add<Options>(app, {.name = "report",
                     .help = "Figures and V&V report as PDF, from runs of both implementations",
                     .examples = {"stickslip report --only fig1,fig2 --output figures",
                                  "stickslip report --only fig2 --set friction.decay=2 --size 12x5"},
                     .add_options = add_options,
                     .run = vv_report});
}

}  // namespace stickslip::cli
