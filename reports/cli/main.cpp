/// The command line `stickslip`. Exit status: 0 done, 1 a check or a run failed, 2 unusable input or output.
/// A failure is one sentence on standard error.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include "argument_error.hpp"
#include "case_options.hpp"
#include "commands.hpp"
#include "input_text.hpp"
#include "long_work.hpp"
#include "output_file.hpp"
#include "stickslip/version.hpp"

namespace stickslip::cli {

namespace {

enum ExitStatus : int { done = 0, failed = 1, unusable = 2 };

int refuse(const std::string& sentence, ExitStatus status) {
  constexpr std::size_t longest = 2000;
  fmt::print(stderr, "stickslip: {}\n", data::printable(sentence, longest));
  return status;
}

void add_commands(CLI::App& app) {
  app.require_subcommand(0, 1);  // none at all is refused by run(), which lets a misspelt one be named
  app.option_defaults()->disable_flag_override();
  app.set_version_flag("--version", fmt::format("stickslip {} (commit {})", version, commit));
  add_modes_command(app);
  add_respond_command(app);
  add_animate_command(app);
  add_criterion_command(app);
  add_map_command(app);
  add_design_command(app);
  add_reference_command(app);
  add_compare_command(app);
  add_report_command(app);
  add_cases_command(app);
  add_quiet_option(app);
  add_complete_command(app);
  add_examples(app, {"stickslip criterion steel-strip", "stickslip criterion --help"});
}

int run(int argc, char** argv) {
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
    return refuse(sentence_for(app, error), unusable);
  }
  std::cout.flush();
  if (std::fflush(stdout) != 0 || !std::cout) return refuse("standard output cannot be written", unusable);
  return done;
}

}  // namespace

}  // namespace stickslip::cli

int main(int argc, char** argv) {
  using namespace stickslip::cli;
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like a full disk
  try {
    return run(argc, argv);
  } catch (const std::logic_error& error) {  // what the arguments, the case or the physics rule out
    return refuse(error.what(), unusable);
  } catch (const OutputError& error) {
    return refuse(error.what(), unusable);
  } catch (const std::bad_alloc&) {
    return refuse("the memory does not suffice for this problem", failed);
  } catch (const std::exception& error) {
    return refuse(error.what(), failed);
  }
}
