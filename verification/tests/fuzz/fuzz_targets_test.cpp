// SPDX-License-Identifier: MIT
/// The fuzz targets, fed by their corpus and by a few thousand mutations of it, the same ones each time.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "support/requirements.hpp"
#include "target.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

using Input = std::vector<std::uint8_t>;

std::vector<fs::path> corpus_of(std::string_view target) {
  std::vector<fs::path> files;
  for (const auto& file :
       fs::directory_iterator(fs::path(STICKSLIP_SOURCE_DIRECTORY) / "verification/fuzz/corpus" / target))
    files.push_back(file.path());
  std::ranges::sort(files);
  return files;
}

Input bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// mt19937_64 is the same everywhere; the distributions of the standard library are not.
class Mutator {
 public:
  Input operator()(Input input) {
    for (std::uint64_t changes = 1 + below(4); changes > 0; --changes) change(input);
    return input;
  }

 private:
  std::uint64_t below(std::uint64_t bound) { return random_() % bound; }

  void change(Input& input) {
    constexpr std::string_view telling = "=.:,;\"'[]{}#-+e0159nil\n\r\t\x1e\x80\xff";
    const std::size_t place = below(input.size() + 1);
    const auto at = input.begin() + static_cast<std::ptrdiff_t>(place);
    const auto rest = static_cast<std::ptrdiff_t>(below(std::min<std::size_t>(input.size() - place, 32) + 1));
    const auto byte = below(2) == 0 ? static_cast<std::uint8_t>(telling[below(telling.size())])
                                    : static_cast<std::uint8_t>(below(256));
    switch (below(4)) {
      case 0:
        input.insert(at, byte);
        break;
      case 1:
        input.erase(at, at + rest);
        break;
      case 2: {
        const Input copy(at, at + rest);
        input.insert(input.begin() + static_cast<std::ptrdiff_t>(below(input.size() + 1)), copy.begin(),
                     copy.end());
        break;
      }
      default:
        if (at != input.end()) *at = byte;
    }
  }

  std::mt19937_64 random_{2018};
};

class FuzzTarget : public ::testing::TestWithParam<fuzz::Target> {};

STICKSLIP_VERIFIES(FuzzTarget, "U11");
TEST_P(FuzzTarget, HoldsOnItsCorpus) {
  const auto files = corpus_of(GetParam().name);
  ASSERT_FALSE(files.empty());
  for (const fs::path& file : files) EXPECT_NO_THROW(GetParam().function(bytes_of(file))) << file;
}

TEST_P(FuzzTarget, HoldsOnMutationsOfItsCorpus) {
  const auto files = corpus_of(GetParam().name);
  ASSERT_FALSE(files.empty());
  const std::size_t rounds = (GetParam().name == "respond" ? 150 : 2000) / files.size() + 1;
  Mutator mutate;
  for (std::size_t round = 0; round < rounds; ++round)
    for (const fs::path& file : files) {
      const Input input = mutate(bytes_of(file));
      ASSERT_NO_THROW(GetParam().function(input))
          << file << ", round " << round << ": " << ::testing::PrintToString(input);
    }
}

INSTANTIATE_TEST_SUITE_P(FuzzTargets, FuzzTarget, ::testing::ValuesIn(fuzz::targets),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace stickslip::testing
