/// Runs the suite against wrong versions of the models, and writes what it catches.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <thread>

#include "hunt.hpp"
#include "stickslip/mutants/verdict.hpp"

namespace {

using namespace stickslip::mutants;

// A line on a terminal, nothing elsewhere.
std::function<void(double)> progress_of(const char* what) {
  if (::isatty(STDERR_FILENO) == 0) return {};
  return [what](double share) {
    fmt::print(stderr, "\r{}: {:3.0f} %{}", what, 100.0 * share, share < 1.0 ? "" : "\n");
  };
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Builds wrong versions of solver/ and analytic/ and runs the test suite against each."};
  const std::string source_tree = STICKSLIP_SOURCE_DIRECTORY, build_tree = STICKSLIP_BUILD_DIRECTORY;
  std::string output = record_directory().string();
  int count = 400;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  bool curated = false, generated = false;
  app.add_flag("--curated", curated, "Only the curated mutants: every quick test against each");
  app.add_flag("--generated", generated, "Only the generated mutants: until the first test that fails");
  app.add_option("--count", count, "Generated mutants in the sample")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  app.add_option("--seed", seed, "Of the sample")->capture_default_str();
  app.add_option("--jobs", threads, "Mutants at a time")->capture_default_str()->check(CLI::Range(1, 1024));
  app.add_option("--output", output, "Folder for kill-matrix.csv and generated.json")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const bool both = curated == generated;

  try {
    const std::filesystem::path folder = std::filesystem::path(build_tree) / "mutants";
    std::filesystem::create_directories(folder);
    std::filesystem::create_directories(output);
    const Workshop workshop(source_tree, build_tree);
    const auto programs = test_programs(build_tree, folder);
    Hunt hunt{.source_tree = source_tree,
              .folder = folder,
              .workshop = workshop,
              .programs = programs,
              .threads = threads,
              .progress = {}};
    std::vector<std::string> complaints;
    if (both || curated) {
      hunt.progress = progress_of("curated mutants");
      const KillMatrix matrix = hunt_curated(hunt, curated_mutants());
      write(matrix, output);
      fmt::print("{}\n", summary(matrix));
      complaints = survivors(matrix);
    }
    if (both || generated) {
      hunt.progress = progress_of("generated mutants");
      const GeneratedSample sample = hunt_generated(hunt, count, seed);
      write(sample, output);
      const auto proofs = equivalences();
      fmt::print("{}\n", summary(sample, proofs));
      const auto more = survivors(sample, proofs);
      complaints.insert(complaints.end(), more.begin(), more.end());
    }
    for (const auto& complaint : complaints) fmt::print("{}\n", complaint);
    return complaints.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stickslip_mutants: {}\n", error.what());
    return 2;
  }
}
