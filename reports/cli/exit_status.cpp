// SPDX-License-Identifier: MIT
#include "exit_status.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

int told(const std::string& sentence, ExitStatus status) {
  constexpr std::size_t longest = 2000;
  fmt::print(stderr, "stickslip: {}\n", data::printable(sentence, longest));
  return status;
}

// The subcommand, of a subcommand, that the arguments reached.
const CLI::App& reached(const CLI::App& app) {
  const CLI::App* deepest = &app;
  while (!deepest->get_subcommands().empty()) deepest = deepest->get_subcommands().back();
  return *deepest;
}

std::vector<std::string> subcommands_of(const CLI::App& app) {
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
    return fmt::format("the option {} is unknown{}", text, data::suggestion(name, options_of(command)));
  }
  if (const auto names = subcommands_of(command); !names.empty())
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

}  // namespace

int exit_status_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const data::InputErrors& errors) {
    std::istringstream lines(errors.what());
    for (std::string line; std::getline(lines, line);) told(line, unusable);
    return unusable;
  } catch (const data::InputError& error) {
    return told(error.what(), unusable);
  } catch (const data::OutputError& error) {
    return told(error.what(), unusable);
  } catch (const std::logic_error& error) {
    return told(fmt::format("this is a mistake in stickslip itself, not in the input: {}", error.what()),
                failed);
  } catch (const std::bad_alloc&) {
    return told("the memory does not suffice for this problem", failed);
  } catch (const std::exception& error) {
    return told(error.what(), failed);
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
  const auto names = subcommands_of(command);
  if (!names.empty())
    throw CLI::RequiredError("a subcommand of " + command.get_name() + ", one of " + data::joined(names) +
                             ",");
}

}  // namespace stickslip::cli
