#pragma once

/// The command line as plain data, for what is made from it: manual page and completions.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace stickslip::cli {

/// What may stand for an argument, as far as a shell can complete it.
enum class ValueKind {
  none,       ///< a flag takes no value
  choice,     ///< one of `choices`
  case_name,  ///< a published case, or a file
  data_set,   ///< a published data set
  path,       ///< a file or a folder
  other
};

struct Argument {
  std::string name;        ///< "--method", "CASE"
  std::string short_name;  ///< "-h", or empty
  std::string value;       ///< "closed-form|fe", "PATH", "FLOAT"; empty for flags and positionals
  ValueKind kind{};
  std::vector<std::string> choices;
  std::string range;          ///< "1 ... 1000", or empty
  std::string default_value;  ///< or empty
  std::string description;
  bool required{};
  bool repeatable{};
};

struct Command {
  std::string name;  ///< "export"
  std::string path;  ///< "reference export", empty for the program
  std::string description;
  std::vector<Argument> options, positionals;
  std::vector<Command> subcommands;
  std::vector<std::string> examples;
};

/// What --help of the program and of its subcommands shows; what it hides is left out.
[[nodiscard]] Command command_tree(const CLI::App& app);

/// The command and all below it, each before those below it.
[[nodiscard]] std::vector<const Command*> all_commands(const Command& command);

}  // namespace stickslip::cli
