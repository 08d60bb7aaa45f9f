// SPDX-License-Identifier: MIT
#include "long_work.hpp"

#include "case_options.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::cli {

namespace {

bool quiet = false;  // of the one command line there is

}  // namespace

void add_quiet_option(CLI::App& app) {
  if (app.get_option_no_throw("--quiet") == nullptr)  // a subcommand may have one that says more
    app.add_flag("--quiet", quiet, "No progress on standard error");
  for (CLI::App* command : app.get_subcommands(nullptr)) add_quiet_option(*command);
}

bool is_quiet() noexcept { return quiet; }

report::Progress::Surroundings progress_surroundings() { return report::Progress::standard_error(quiet); }

void add_threads_option(CLI::App& command) {
  command
      .add_option_function<unsigned>(
          "--threads", [](const unsigned& count) { studies::set_thread_count(count); },
          "Threads to work on, of which no result depends (default: as many as the machine runs at once)")
      ->check(integer_between(1, 1024));
}

}  // namespace stickslip::cli
