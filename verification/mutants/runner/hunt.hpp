#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "stickslip/mutants/mutant.hpp"
#include "stickslip/mutants/record.hpp"
#include "suite.hpp"
#include "workshop.hpp"

namespace stickslip::mutants {

/// Where a hunt works and how.
struct Hunt {
  std::filesystem::path source_tree;
  std::filesystem::path folder;  ///< of what is built and remembered
  const Workshop& workshop;
  const std::vector<TestProgram>& programs;
  unsigned threads{};
  std::function<void(double)> progress;  ///< called with the share done
};

/// Every quick test against every curated mutant, and the longer ones where those of two kinds do not kill
/// it. What has not changed since an earlier hunt in the same folder is not run again. Throws
/// std::runtime_error for a mutant that does not compile or is the same code.
[[nodiscard]] KillMatrix hunt_curated(const Hunt& hunt, const std::vector<CuratedMutant>& mutants);

/// The first `count` mutants of the sample that compile to other code, each until the first test that
/// fails, the longer tests last. A killed one whose killer still fails stays killed.
[[nodiscard]] GeneratedSample hunt_generated(const Hunt& hunt, int count, std::uint64_t seed);

}  // namespace stickslip::mutants
