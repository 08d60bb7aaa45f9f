// SPDX-License-Identifier: MIT
#pragma once

namespace stickslip::cli {

/// Runs the command line `stickslip` and returns with what it ends (exit_status.hpp).
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace stickslip::cli
