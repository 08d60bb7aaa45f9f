// SPDX-License-Identifier: MIT
#pragma once

/// The program as a whole: with which status it ends, and with which sentence if an argument is wrong.

#include <functional>
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace stickslip::cli {

enum ExitStatus : int {
  done = 0,
  failed = 1,    ///< a check, a run or the program itself
  unusable = 2,  ///< an input or an output that the user can mend
  undecided = 3  ///< a comparison in which nothing differs, but not all agrees
};

/// What `work` returns or, if it throws, the status for the kind of the exception, which is told in one
/// sentence on standard error: `unusable` for data::InputError and OutputError, else `failed`.
/// std::logic_error is told as a mistake of the program.
[[nodiscard]] int exit_status_of(const std::function<int()>& work);

/// What is wrong with the arguments, in one sentence: names the option or the argument, what was given, what
/// is allowed, and for a misspelt subcommand or option the one that is nearest.
[[nodiscard]] std::string sentence_for(const CLI::App& app, const CLI::ParseError& error);

/// Throws CLI::RequiredError, naming the subcommands there are, if the one that was reached needs another
/// one.
void require_subcommand(const CLI::App& app);

/// Runs the command line `stickslip` and returns with what it ends.
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace stickslip::cli
