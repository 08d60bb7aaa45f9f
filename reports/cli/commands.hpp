// SPDX-License-Identifier: MIT
#pragma once

/// The subcommands of `stickslip`. Each adds itself to the application and runs from its callback, which
/// throws data::InputError for an input that cannot be used, OutputError for an output, and CLI::RuntimeError
/// when a check has failed or a signal has come and has said so.

#include <CLI/CLI.hpp>

namespace stickslip::cli {

void add_new_command(CLI::App& app);
void add_modes_command(CLI::App& app);
void add_respond_command(CLI::App& app);
void add_animate_command(CLI::App& app);
void add_criterion_command(CLI::App& app);
void add_map_command(CLI::App& app);
void add_sweep_command(CLI::App& app);
void add_design_command(CLI::App& app);
void add_uncertainty_command(CLI::App& app);
void add_squeal_command(CLI::App& app);
void add_nvh_command(CLI::App& app);
void add_periodic_command(CLI::App& app);
void add_reference_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_validate_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_cases_command(CLI::App& app);

/// `complete`, which --help does not list: what may stand for the last of the words of a command line, one
/// candidate a line with its description behind a tab. The completion scripts of the shells ask for it.
void add_complete_command(CLI::App& app);

/// All of them, in the order of --help.
constexpr void (*all_commands[])(CLI::App&){
    add_new_command,         add_modes_command,   add_respond_command,  add_animate_command,
    add_criterion_command,   add_map_command,     add_sweep_command,    add_design_command,
    add_uncertainty_command, add_squeal_command,  add_nvh_command,      add_periodic_command,
    add_reference_command,   add_compare_command, add_validate_command, add_report_command,
    add_cases_command,       add_complete_command};

}  // namespace stickslip::cli
