// SPDX-License-Identifier: MIT
/// Generates the published reference data.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/reference/package.hpp"

int main(int argc, char** argv) {
  using namespace stickslip;
  namespace fs = std::filesystem;
  CLI::App app("Generates the published reference data. Nothing is written before all of it is made.",
               "stickslip_reference_data");
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
    for (const reference::Recipe& recipe : recipes) {
      if (!quiet) fmt::print(stderr, "{} of {}: {}\n", sets.size() + 1, recipes.size(), recipe.name);
      sets.push_back(recipe.make());
    }
    const fs::path description = fs::path(output) / "datapackage.json";
    for (const auto& [name, text] :
         reference::package_files(sets, makes_all ? "" : data::read_text(description))) {
      const fs::path file = fs::path(output) / name;
      fs::create_directories(file.parent_path());
      data::write_text(file, text);
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stickslip_reference_data: {}\n", error.what());
    return 1;
  }
}
