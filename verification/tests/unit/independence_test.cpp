/// The two implementations share nothing but the problem statement.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace stickslip::testing {
namespace {

// Lines of a folder's sources and build file that match a pattern.
std::string matching_lines(const std::filesystem::path& folder, const std::regex& pattern) {
  std::ostringstream found;
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".hpp" && extension != ".txt") continue;
    ++files;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      if (std::regex_search(line, pattern)) found << entry.path().filename() << ": " << line << "\n";
  }
  EXPECT_GT(files, 3) << folder;
  return found.str();
}

const std::filesystem::path root(STICKSLIP_SOURCE_DIRECTORY);

TEST(Independence, SolverKnowsNeitherAnalyticNorGsl) {
  const std::regex forbidden(
      R"((#\s*include\s*[<"].*(analytic/|studies/|gsl/))|(stickslip::analytic|GSL::))");
  EXPECT_EQ(matching_lines(root / "solver", forbidden), "");
}

TEST(Independence, AnalyticKnowsNeitherSolverNorEigen) {
  const std::regex forbidden(
      R"((#\s*include\s*[<"].*(solver/|studies/|Eigen/))|(stickslip::solver|Eigen3::))");
  EXPECT_EQ(matching_lines(root / "analytic", forbidden), "");
}

TEST(Independence, DataKnowsNeitherImplementation) {
  const std::regex forbidden(
      R"((#\s*include\s*[<"].*(solver/|analytic/|studies/|Eigen/|gsl/))|stickslip::(solver|analytic))");
  EXPECT_EQ(matching_lines(root / "data", forbidden), "");
}

}  // namespace
}  // namespace stickslip::testing
