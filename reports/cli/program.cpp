// SPDX-License-Identifier: MIT
#include "program.hpp"

#include <sched.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "command.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::cli {

namespace {

void add_commands(CLI::App& app) {
  app.require_subcommand(0, 1);  // run() requires one, so that a misspelt one is named
  app.option_defaults()->disable_flag_override();
  app.set_version_flag("--version", program());
  for (const auto add_to : all_commands) add_to(app);
  add_quiet_option(app);
  add_examples(app, {"stickslip criterion steel-strip", "stickslip criterion --help"});
}

// Those that the process may use, by taskset or a scheduler of jobs; nothing is known of more than 1024.
void use_allowed_processors() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    studies::set_thread_count(static_cast<unsigned>(CPU_COUNT(&allowed)));
}

int run(int argc, const char* const* argv) {
  use_allowed_processors();
  CLI::App app("Friction-driven vibration of beams, in closed form and by finite elements", "stickslip");
  add_commands(app);
  try {
    app.parse(argc, argv);
    require_subcommand(app);
  } catch (const CLI::Success& request) {  // --help, --version
    app.exit(request);
  } catch (const CLI::RuntimeError& outcome) {
    return outcome.get_exit_code();
  } catch (const CLI::ParseError& error) {
    throw data::InputError(sentence_for(app, error));
  }
  std::cout.flush();
  if (std::fflush(stdout) != 0 || !std::cout) throw data::OutputError("standard output cannot be written");
  return done;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  return exit_status_of([=] { return run(argc, argv); });
}

}  // namespace stickslip::cli
