// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stickslip::cli {

/// "pdf", "png" or "svg", by the name of the file that --figure gives. Throws data::InputError for another
/// one.
[[nodiscard]] std::string figure_format(const std::string& figure);

/// The option --figure.
CLI::Option* add_figure_option(CLI::App& command, std::string& figure);

}  // namespace stickslip::cli
