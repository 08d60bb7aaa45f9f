#pragma once

#include <string>

#include "command_tree.hpp"

namespace stickslip::cli {

/// Completions for the shells: subcommands, options and their values, cases, data sets and paths. What is
/// published they ask the program for, at each completion.
[[nodiscard]] std::string bash_completion(const Command& program);
[[nodiscard]] std::string zsh_completion(const Command& program);
[[nodiscard]] std::string fish_completion(const Command& program);

}  // namespace stickslip::cli
