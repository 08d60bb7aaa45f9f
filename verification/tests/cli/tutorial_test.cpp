/// The tutorial: every command in it runs, in the order of the text, and prints what is shown.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/command_line.hpp"

namespace stickslip::testing {
namespace {

// ```language ... ```, indented or not, with the file that the text before it names last.
struct Block {
  std::string language, text, file;
};

std::vector<Block> blocks_of(const std::string& markdown) {
  const std::regex fence("^( *)```([a-z]+)$"), file_name("`([a-z-]+\\.[a-z]+)`");
  std::vector<Block> blocks;
  std::string file;
  std::istringstream lines(markdown);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    for (std::sregex_iterator name(line.begin(), line.end(), file_name), end; name != end; ++name)
      file = name->str(1);
    if (!std::regex_match(line, match, fence)) continue;
    const std::string indentation = match.str(1);
    Block block{match.str(2), "", file};
    while (std::getline(lines, line) && line != indentation + "```")
      block.text += line.substr(std::min(indentation.size(), line.size())) + "\n";
    blocks.push_back(block);
  }
  return blocks;
}

std::optional<double> number_of(const std::string& word) {
  double value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

// Words between blanks and commas; an empty one for each end of a line.
std::vector<std::string> words_of(std::string text) {
  std::ranges::replace(text, ',', ' ');
  std::vector<std::string> words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); words.emplace_back()) {
    std::istringstream stream(line);
    for (std::string word; stream >> word;) words.push_back(word);
  }
  return words;
}

// The tutorial promises six digits.
bool is_as_shown(const std::string& printed, const std::string& shown) {
  const auto a = number_of(printed), b = number_of(shown);
  return printed == shown || (a && b && std::abs(*a - *b) <= 1e-6 * std::abs(*b));
}

class Tutorial : public CommandLine {
 protected:
  // Standard output and standard error of a script in the test's folder, as a terminal shows them.
  [[nodiscard]] Outcome terminal(const std::string& script) const {
    const std::string program = std::filesystem::path(STICKSLIP_PROGRAM).parent_path().string();
    return shell(fmt::format("cd '{}' && PATH='{}':$PATH\nexec 2>&1\nset -e\n{}", path(""), program, script));
  }
};

TEST_F(Tutorial, PrintsWhatItShows) {
  const auto blocks = blocks_of(contents(STICKSLIP_SOURCE_DIRECTORY "/reports/tutorial.md"));
  std::string printed;
  std::size_t scripts = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    if (block.language == "sh") {
      ++scripts;
      const Outcome outcome = terminal(block.text);
      EXPECT_EQ(outcome.status, 0) << block.text << outcome.output;
      printed = outcome.output;
      EXPECT_TRUE(i + 1 < blocks.size() && blocks[i + 1].language == "text")
          << block.text << "shows no output";
    } else if (block.language == "text") {
      EXPECT_TRUE(std::ranges::equal(words_of(printed), words_of(block.text), is_as_shown))
          << "prints\n"
          << printed << "but shows\n"
          << block.text;
    } else {
      ASSERT_TRUE(block.file.ends_with(block.language)) << block.text << "has no file name before it";
      std::ofstream(path(block.file)) << block.text;
    }
  }
  EXPECT_GE(scripts, 10U);
}

TEST_F(Tutorial, BeginsAsTheReadmeDoes) {
  const auto first = [](const std::string& file, const std::string& language) {
    const auto blocks = blocks_of(contents(STICKSLIP_SOURCE_DIRECTORY "/" + file));
    const auto found = std::ranges::find(blocks, language, &Block::language);
    EXPECT_NE(found, blocks.end()) << file;
    return found == blocks.end() ? "" : found->text;
  };
  for (const std::string language : {"toml", "text"})
    EXPECT_EQ(first("README.md", language), first("reports/tutorial.md", language));
}

}  // namespace
}  // namespace stickslip::testing
