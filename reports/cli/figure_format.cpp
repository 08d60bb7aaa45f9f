// SPDX-License-Identifier: MIT
#include "figure_format.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "case_options.hpp"
#include "render/report.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

std::string figure_format(const std::string& figure) {
  const std::string extension = std::filesystem::path(figure).extension().string();
  if (extension == ".pdf" || extension == ".png" || extension == ".svg") return extension.substr(1);
  throw data::FieldError("--figure", fmt::format("'{}'", data::printable(figure)),
                         "a file whose name ends in .pdf, .png or .svg");
}

void open_figure(std::optional<OutputFile>& file, const std::string& figure) {
  if (figure.empty()) return;
  (void)figure_format(figure);
  (void)report::templates_directory();  // throws now rather than after the work
  file.emplace(figure);
}

void add_figure_option(CLI::App& command, std::string& figure) {
  command.add_option("--figure", figure, "Figure to draw, a .png, .pdf or .svg file (needs gnuplot)")
      ->check(file_name());
}

}  // namespace stickslip::cli
