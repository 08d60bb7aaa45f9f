// SPDX-License-Identifier: MIT
#pragma once

/// What subcommands that take long have in common.

#include <CLI/CLI.hpp>

#include "render/progress.hpp"

namespace stickslip::cli {

/// --quiet, before or after the subcommand: no progress on standard error.
void add_quiet_option(CLI::App& app);
[[nodiscard]] bool is_quiet() noexcept;

/// Standard error, unless --quiet.
[[nodiscard]] report::Progress::Surroundings progress_surroundings();

/// --threads N, which sets studies::thread_count().
void add_threads_option(CLI::App& command);

}  // namespace stickslip::cli
