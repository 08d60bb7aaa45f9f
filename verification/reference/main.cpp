// SPDX-License-Identifier: MIT
/// Generates the published reference data. Usage: stickslip_reference_data [--output FOLDER]

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "render/interruption.hpp"
#include "render/progress.hpp"
#include "render/text_file.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/reference/package.hpp"

int main(int argc, char** argv) {
  using namespace stickslip;
  namespace fs = std::filesystem;
  CLI::App app("Generates the published reference data.", "stickslip_reference_data");
  std::string output = data::reference_directory().string();
  app.add_option("--output", output, "Folder for the package")->capture_default_str();
  bool quiet = false;
  app.add_flag("--quiet", quiet, "No progress on standard error");
  CLI11_PARSE(app, argc, argv);
  try {
    const auto& recipes = reference::recipes();
    std::vector<reference::DataSet> sets;
    {
      report::Progress progress("stickslip_reference_data", report::Progress::standard_error(quiet),
                                recipes.size());
      const report::Interruption interruption([&] {
        progress.finish();
        return fmt::format("interrupted after {:.0f} % of the data sets; nothing is written",
                           100.0 * progress.share());
      });
      for (std::size_t i = 0; i < recipes.size(); ++i) {
        progress(static_cast<double>(i) / static_cast<double>(recipes.size()));
        progress.stage(recipes[i].name);
        sets.push_back(recipes[i].make());
      }
    }
    for (const auto& [name, text] : reference::package_files(sets)) {
      const fs::path file = fs::path(output) / name;
      fs::create_directories(file.parent_path());
      report::replace_text(file, text);
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stickslip_reference_data: {}\n", error.what());
    return 1;
  }
}
