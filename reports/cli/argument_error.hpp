// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stickslip::cli {

/// What is wrong with the arguments, in one sentence: names the option or the argument, what was given, what
/// is allowed, and for a misspelt subcommand or option the one that is nearest.
[[nodiscard]] std::string sentence_for(const CLI::App& app, const CLI::ParseError& error);

/// Throws CLI::RequiredError, naming the subcommands there are, if the one that was reached needs another
/// one.
void require_subcommand(const CLI::App& app);

}  // namespace stickslip::cli
