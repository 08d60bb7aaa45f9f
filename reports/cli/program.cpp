// SPDX-License-Identifier: MIT
#include "program.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "command.hpp"
#include "commands.hpp"
#include "render/progress.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::cli {

namespace {

int report_error(const std::string& sentence, ExitStatus status) {
  report::tell("stickslip", sentence);
  return status;
}

// The subcommand, of a subcommand, that the arguments reached.
const CLI::App& reached(const CLI::App& app) {
  const CLI::App* deepest = &app;
  while (!deepest->get_subcommands().empty()) deepest = deepest->get_subcommands().back();
  return *deepest;
}

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand :
       app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); }))
    names.push_back(subcommand->get_name());
  return names;
}

// Those of the command and of all above it.
std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command = &app; command != nullptr; command = command->get_parent())
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string unexpected(const CLI::App& app, const std::string& argument) {
  const CLI::App& command = reached(app);
  const std::string text = data::printable(argument);
  if (argument.starts_with('-') && argument.size() > 1) {
    const std::string name = argument.substr(0, argument.find('='));
    if (app.get_option_no_throw(name) != nullptr && &command != &app)
      return fmt::format("the option {} must stand before {}", text, command.get_name());
    return fmt::format("the option {} is unknown{}", text, data::suggestion(name, options_of(command)));
  }
  if (const auto names = subcommand_names(command); !names.empty())
    return fmt::format("the subcommand {} is unknown{}, but must be one of {}", text,
                       data::suggestion(argument, names), data::joined(names));
  return fmt::format("the argument {} is one more than {} takes", text, command.get_name());
}

// What CLI11 says of a value that is missing, stands twice, or follows a flag, begins with the option's name,
// a flag's without the dashes.
std::string mismatch(const CLI::App& app, const std::string& text) {
  const std::string name = text.substr(0, text.find_first_of(": "));
  const CLI::App& command = reached(app);
  if (const CLI::Option* flag = command.get_option_no_throw("--" + name); flag != nullptr)
    return fmt::format("--{} is given a value, but must stand alone", name);
  const CLI::Option* option = command.get_option_no_throw(name);
  const std::size_t given = option == nullptr ? 0 : option->results().size();
  return given > 1 ? fmt::format("{} is given {} times, but must be given once", name, given)
                   : fmt::format("{} is given without a value, but must have one", name);
}

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
  data::protect_inputs(true);  // an output must not overwrite a file that the command has read
  CLI::App app("Friction-driven vibration of beams, in closed form and by finite elements", "stickslip");
  add_commands(app);
  try {
    app.parse(argc, argv);
    require_subcommand(app);
  } catch (const CLI::Success& request) {  // --help, --version
    app.exit(request);
  } catch (const CLI::RuntimeError& outcome) {  // of finish(): a verdict, nothing went wrong
    return outcome.get_exit_code();
  } catch (const CLI::ParseError& error) {
    throw data::InputError(sentence_for(app, error));
  }
  std::cout.flush();  // a full disk shows here at the earliest
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout)
    throw data::OutputError("standard output cannot be written");
  return done;
}

}  // namespace

int exit_status_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const data::InputErrors& errors) {
    std::istringstream lines(errors.what());
    for (std::string line; std::getline(lines, line);) report_error(line, unusable);
    return unusable;
  } catch (const data::InputError& error) {
    return report_error(error.what(), unusable);
  } catch (const data::OutputError& error) {
    return report_error(error.what(), unusable);
  } catch (const std::logic_error& error) {  // InputError is one as well, and came before
    return report_error(
        fmt::format("this is a mistake in stickslip itself, not in the input: {}", error.what()), failed);
  } catch (const std::bad_alloc&) {
    return report_error("the memory does not suffice for this problem", failed);
  } catch (const std::exception& error) {
    return report_error(error.what(), failed);
  }
}

std::string sentence_for(const CLI::App& app, const CLI::ParseError& error) {
  std::string sentence = error.what();
  const auto arguments = app.remaining(true);  // unknown ones, of which a required one may be a misspelling
  if (!arguments.empty()) {
    sentence = unexpected(app, arguments.front());
  } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    sentence = mismatch(app, sentence);
  } else if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) {
    sentence.erase(sentence.find(':'), 1);  // "--count: is 0, but must be ..."
  }
  return sentence + " (--help says what is allowed)";
}

void require_subcommand(const CLI::App& app) {
  const CLI::App& command = reached(app);
  const auto names = subcommand_names(command);
  if (!names.empty())
    throw CLI::RequiredError("a subcommand of " + command.get_name() + ", one of " + data::joined(names) +
                             ",");
}

int run_program(int argc, const char* const* argv) {
  const int status = exit_status_of([=] { return run(argc, argv); });
  data::protect_inputs(false);
  return status;
}

}  // namespace stickslip::cli
