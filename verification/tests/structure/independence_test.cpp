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

STICKSLIP_VERIFIES(Independence, "P4");
TEST(Independence, ImplementationsKnowDataAlone) {
  struct Rule {
    std::string folder;
    std::vector<std::string_view> includes, targets;
  };
  for (const auto& [folder, includes, targets] :
       std::vector<Rule>{{"solver", {"analytic/", "studies/", "gsl/"}, {"analytic", "studies", "GSL"}},
                         {"analytic", {"solver/", "studies/", "Eigen/"}, {"solver", "studies", "Eigen"}},
                         {"verification/certified",
                          {"solver/", "analytic/", "studies/", "data/", "Eigen/", "gsl/"},
                          {"solver", "analytic", "studies", "data", "Eigen", "GSL"}},
                         {"data",
                          {"solver/", "analytic/", "studies/", "Eigen/", "gsl/"},
                          {"stickslip::solver", "stickslip::analytic", "Eigen", "GSL"}}})
    EXPECT_EQ(forbidden_lines(std::filesystem::path(STICKSLIP_SOURCE_DIRECTORY) / folder, includes, targets),
              "");
}

}  // namespace
}  // namespace stickslip::testing
