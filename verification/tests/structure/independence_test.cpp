// SPDX-License-Identifier: MIT
/// The two implementations share nothing but the problem statement.

#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

// Lines of a folder's sources that include, and of its build files that link, something forbidden.
std::string forbidden_lines(const std::filesystem::path& folder,
                            const std::vector<std::string_view>& includes,
                            const std::vector<std::string_view>& targets) {
  std::ostringstream found;
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    const bool is_source = extension == ".cpp" || extension == ".hpp";
    if (!is_source && extension != ".txt") continue;
    ++files;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      if (is_source && line.find("#include") == std::string::npos) continue;
      for (const std::string_view word : is_source ? includes : targets)
        if (line.find(word) != std::string::npos) found << entry.path().filename() << ": " << line << "\n";
    }
  }
  EXPECT_GT(files, 3) << folder;
  return found.str();
}

const std::filesystem::path root(STICKSLIP_SOURCE_DIRECTORY);

STICKSLIP_VERIFIES(Independence, "P4");
TEST(Independence, SolverKnowsNeitherAnalyticNorGsl) {
  EXPECT_EQ(
      forbidden_lines(root / "solver", {"analytic/", "studies/", "gsl/"}, {"analytic", "studies", "GSL"}),
      "");
}

TEST(Independence, AnalyticKnowsNeitherSolverNorEigen) {
  EXPECT_EQ(
      forbidden_lines(root / "analytic", {"solver/", "studies/", "Eigen/"}, {"solver", "studies", "Eigen"}),
      "");
}

TEST(Independence, CertifiedKnowsNothingElse) {
  EXPECT_EQ(forbidden_lines(root / "verification/certified",
                            {"solver/", "analytic/", "studies/", "data/", "Eigen/", "gsl/"},
                            {"solver", "analytic", "studies", "data", "Eigen", "GSL"}),
            "");
}

TEST(Independence, DataKnowsNeitherImplementation) {
  EXPECT_EQ(forbidden_lines(root / "data", {"solver/", "analytic/", "studies/", "Eigen/", "gsl/"},
                            {"stickslip::solver", "stickslip::analytic", "Eigen", "GSL"}),
            "");
}

}  // namespace
}  // namespace stickslip::testing
