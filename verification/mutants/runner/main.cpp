/// Runs the suite against wrong versions of the models, and writes what it catches.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <thread>

#include "hunt.hpp"
#include "stickslip/mutants/verdict.hpp"
#include "stickslip/report/interruption.hpp"
#include "stickslip/report/progress.hpp"

using namespace stickslip::mutants;
using stickslip::report::Interruption;
using stickslip::report::Progress;

int main(int argc, char** argv) {
  CLI::App app{"Builds wrong versions of solver/ and analytic/ and runs the test suite against each."};
  const std::string source_tree = STICKSLIP_SOURCE_DIRECTORY, build_tree = STICKSLIP_BUILD_DIRECTORY;
  std::string output = record_directory().string();
  int count = 400;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  bool curated = false, generated = false, quiet = false;
  app.add_flag("--curated", curated, "Only the curated mutants: every quick test against each");
  app.add_flag("--generated", generated, "Only the generated mutants: until the first test that fails");
  app.add_option("--count", count, "Generated mutants in the sample")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  app.add_option("--seed", seed, "Of the sample")->capture_default_str();
  app.add_option("--jobs", threads, "Mutants at a time")->capture_default_str()->check(CLI::Range(1, 1024));
  app.add_option("--output", output, "Folder for kill-matrix.csv and generated.json")->capture_default_str();
  app.add_flag("--quiet", quiet, "No progress on standard error");
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
    // Shows how far a hunt is, and says so where it is interrupted.
    const auto watched = [&](const std::string& what, std::size_t mutants, const auto& run) {
      Progress progress("stickslip_mutants: " + what, Progress::standard_error(quiet), mutants);
      const Interruption interruption([&] {
        progress.finish();
        return fmt::format("interrupted after {:.0f} % of the {}; what is known of them is kept in {}",
                           100.0 * progress.share(), what, folder.string());
      });
      hunt.progress = std::ref(progress);
      return run();
    };
    std::vector<std::string> complaints;
    if (both || curated) {
      const auto mutants = curated_mutants();
      const KillMatrix matrix =
          watched("curated mutants", mutants.size(), [&] { return hunt_curated(hunt, mutants); });
      write(matrix, output);
      fmt::print("{}\n", summary(matrix));
      complaints = survivors(matrix);
    }
    if (both || generated) {
      const GeneratedSample sample = watched("generated mutants", static_cast<std::size_t>(count),
                                             [&] { return hunt_generated(hunt, count, seed); });
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
