// SPDX-License-Identifier: MIT
/// The fuzz targets, fed by their corpus and by a few thousand mutations of it, the same ones each time.

#include <cstdint>
#include <random>

#include "support/testing.hpp"
#include "target.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

using Input = std::vector<std::uint8_t>;

struct Seed {
  std::string name;
  Input input;
};

// verification/fuzz/corpus.py says what the file of a corpus looks like.
std::vector<Seed> corpus_of(std::string_view target) {
  constexpr std::string_view marker = "\n=== seed ";
  std::ifstream stream(fs::path(STICKSLIP_SOURCE_DIRECTORY) / "verification/fuzz/corpus" / target,
                       std::ios::binary);
  const std::string text = "\n" + std::string(std::istreambuf_iterator<char>(stream), {});
  std::vector<Seed> seeds;
  for (std::size_t start = text.find(marker); start != std::string::npos;) {
    const std::size_t name = start + marker.size(), line_break = text.find('\n', name);
    start = text.find(marker, line_break);
    const std::string_view content =
        std::string_view(text).substr(0, std::min(start, text.size() - 1)).substr(line_break + 1);
    seeds.push_back({text.substr(name, line_break - name), Input(content.begin(), content.end())});
  }
  return seeds;
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
  const auto seeds = corpus_of(GetParam().name);
  ASSERT_FALSE(seeds.empty());
  for (const Seed& seed : seeds) EXPECT_NO_THROW(GetParam().function(seed.input)) << seed.name;
}

TEST_P(FuzzTarget, HoldsOnMutationsOfItsCorpus) {
  const auto seeds = corpus_of(GetParam().name);
  ASSERT_FALSE(seeds.empty());
  const std::size_t rounds = (GetParam().name == "respond" ? 150 : 2000) / seeds.size() + 1;
  Mutator mutate;
  for (std::size_t round = 0; round < rounds; ++round)
    for (const Seed& seed : seeds) {
      const Input input = mutate(seed.input);
      ASSERT_NO_THROW(GetParam().function(input))
          << seed.name << ", round " << round << ": " << ::testing::PrintToString(input);
    }
}

INSTANTIATE_TEST_SUITE_P(FuzzTargets, FuzzTarget, ::testing::ValuesIn(fuzz::targets),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace stickslip::testing
