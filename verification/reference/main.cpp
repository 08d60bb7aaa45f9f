// SPDX-License-Identifier: MIT
/// Generates the published reference data.

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
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/reference/package.hpp"

int main(int argc, char** argv) {
  using namespace stickslip;
  namespace fs = std::filesystem;
  CLI::App app("Generates the published reference data.", "stickslip_reference_data");
  std::string output = data::reference_directory().string();
  app.add_option("--output", output, "Folder for the package")->capture_default_str();
  std::vector<std::string> only;
  app.add_option("--only", only, "Make only these data sets, and keep the others in the folder");
  bool quiet = false;
  app.add_flag("--quiet", quiet, "No progress on standard error");
  CLI11_PARSE(app, argc, argv);
  try {
    const bool makes_all = only.empty();
    std::vector<reference::Recipe> recipes;
    for (const reference::Recipe& recipe : reference::recipes())
      if (makes_all || std::erase(only, recipe.name) > 0) recipes.push_back(recipe);
    if (!only.empty()) throw data::InputError("the data set " + only.front() + " is unknown");
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
    const fs::path description = fs::path(output) / "datapackage.json";
    for (const auto& [name, text] :
         reference::package_files(sets, makes_all ? "" : report::read_text(description))) {
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
