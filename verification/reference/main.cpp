/// Writes the published reference data. Usage: stickslip_reference_data [--output FOLDER]

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "stickslip/data/reference.hpp"
#include "stickslip/reference/package.hpp"
#include "stickslip/report/text_file.hpp"

int main(int argc, char** argv) {
  using namespace stickslip;
  namespace fs = std::filesystem;
  CLI::App app("Makes the published reference data.", "stickslip_reference_data");
  std::string output = data::reference_directory().string();
  app.add_option("--output", output, "Folder for the package")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const bool on_terminal = ::isatty(STDERR_FILENO) != 0;
    std::vector<reference::DataSet> sets;
    for (const reference::Recipe& recipe : reference::recipes()) {
      if (on_terminal)
        fmt::print(stderr, "\r\033[K{} of {}: {}", sets.size() + 1, reference::recipes().size(), recipe.name);
      sets.push_back(recipe.make());
    }
    if (on_terminal) fmt::print(stderr, "\r\033[K");
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
