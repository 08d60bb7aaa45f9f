// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "output_file.hpp"

namespace stickslip::cli {

/// The option --figure.
void add_figure_option(CLI::App& command, std::string& figure);

/// "pdf", "png" or "svg", by the name of the file. Throws data::InputError for another one.
[[nodiscard]] std::string figure_format(const std::string& figure);

/// open_if_named() for a figure. Throws data::InputError if the name has no format or the scripts of the figures
/// are missing.
void open_figure(std::optional<OutputFile>& file, const std::string& figure);

}  // namespace stickslip::cli
