// SPDX-License-Identifier: MIT
#pragma once

/// The subcommands of `stickslip`. Each adds itself to the application and runs from its callback, which
/// throws data::InputError for an input that cannot be used, OutputError for an output, and CLI::RuntimeError
/// when a check has failed or a signal has come and has said so.

#include <CLI/CLI.hpp>

namespace stickslip::cli {

/// `new`: a case file to start from.
void add_new_command(CLI::App& app);

/// `modes`: natural frequencies of the stick or the slip state.
void add_modes_command(CLI::App& app);

/// `respond`: the motion of the tip and of midspan and the friction force, as CSV.
void add_respond_command(CLI::App& app);

/// `animate`: the motion of the whole beam as a sequence of PNG files.
void add_animate_command(CLI::App& app);

/// `criterion`: |f_max| against mu_s P, the critical amplitude, the verdict.
void add_criterion_command(CLI::App& app);

/// `map`: the criterion or the motion over two parameters, as CSV and as a figure.
void add_map_command(CLI::App& app);

/// `sweep`: the motion over one parameter, up and down: Poincare section, period, hysteresis.
void add_sweep_command(CLI::App& app);

/// `design`: the margin to slipping over a band of frequencies; lengths and axial forces that keep it.
void add_design_command(CLI::App& app);

/// `uncertainty`: the probability of slip with uncertain keys, and which of them it hangs on.
void add_uncertainty_command(CLI::App& app);

/// `squeal`: steady sliding on a wall that moves, its stability, and the limit cycle.
void add_squeal_command(CLI::App& app);

/// `periodic`: a periodic motion with its Floquet multipliers.
void add_periodic_command(CLI::App& app);

/// `report`: the figures and the V&V report.
void add_report_command(CLI::App& app);

/// `reference`: lists, describes and hands out the published reference data.
void add_reference_command(CLI::App& app);

/// `compare`: somebody's results against the reference data.
void add_compare_command(CLI::App& app);

/// `cases`: what data/cases holds.
void add_cases_command(CLI::App& app);

/// `complete`, which --help does not list: what may stand for the last of the words of a command line, one
/// candidate a line with its description behind a tab. The completion scripts of the shells ask for it.
void add_complete_command(CLI::App& app);

}  // namespace stickslip::cli
