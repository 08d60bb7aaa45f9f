// SPDX-License-Identifier: MIT
/// The manual: every command in it runs, in the order of the text, and prints what is shown; every link leads
/// somewhere.

#include <cctype>
#include <charconv>
#include <regex>

#include "support/command_line.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

const fs::path root = STICKSLIP_SOURCE_DIRECTORY;

// ```language ... ```, indented or not, with the file that the text before it names last.
struct Block {
  std::string language, text, file;
};

// The lines outside of blocks, and the blocks.
struct Page {
  std::vector<std::string> lines;
  std::vector<Block> blocks;
};

Page read_page(const std::string& markdown) {
  const std::regex fence("^( *)```([a-z]*)$"), file_name("`([a-z-]+\\.[a-z]+)`");
  Page page;
  std::string file;
  std::istringstream lines(markdown);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    for (std::sregex_iterator name(line.begin(), line.end(), file_name), end; name != end; ++name)
      file = name->str(1);
    if (!std::regex_match(line, match, fence)) {
      page.lines.push_back(line);
      continue;
    }
    const std::string indentation = match.str(1);
    Block block{match.str(2), "", file};
    while (std::getline(lines, line) && line != indentation + "```")
      block.text += line.substr(std::min(indentation.size(), line.size())) + "\n";
    page.blocks.push_back(block);
  }
  return page;
}

std::optional<double> number_of(const std::string& word) {
  double value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

// Words between blanks and commas; an empty one for each end of a line.
std::vector<std::string> printed_words(std::string text) {
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

// The anchor of a heading, as forges make it.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(c));
    else if (c == ' ')
      anchor += '-';
  }
  return anchor;
}

std::set<std::string> anchors_of(const Page& page) {
  const std::regex heading("^#+ (.*)$");
  std::set<std::string> anchors;
  std::smatch match;
  for (const std::string& line : page.lines)
    if (std::regex_match(line, match, heading)) anchors.insert(anchor_of(match.str(1)));
  return anchors;
}

// Targets of [text](target) and [label]: target.
std::vector<std::string> links_of(const Page& page) {
  const std::regex link("\\]\\(([^)]+)\\)|^\\[[^\\]]+\\]: (.+)$");
  std::vector<std::string> targets;
  for (const std::string& line : page.lines)
    for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match)
      targets.push_back(match->str(1) + match->str(2));
  return targets;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> files{root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md",
                              root / "data/reference/README.md"};
  for (const auto& entry : fs::directory_iterator(root / "reports/manual"))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  return files;
}

class Manual : public CommandLine {
 protected:
  // What a slow machine prints besides: "stickslip respond: 40 %, ..." every five seconds.
  static std::string without_progress(const std::string& output) {
    static const std::regex line("stickslip [a-z]+: [0-9]+ %[^\n]*\n");
    return std::regex_replace(output, line, "");
  }

  // Standard output and standard error of a script in the test's folder, as a terminal shows them.
  [[nodiscard]] Outcome terminal(const std::string& script) const {
    const std::string program = fs::path(STICKSLIP_PROGRAM).parent_path().string();
    return shell(fmt::format("export PATH='{}':$PATH PYTHONPATH='{}'\nexec 2>&1\nset -e\n{}", program,
                             (root / "reports/python").string(), script));
  }
};

STICKSLIP_VERIFIES(Manual, "U9");
TEST_F(Manual, CommandsRunAndPrintWhatIsShown) {
  for (const std::string page : {"README.md", "reports/manual/tutorial.md", "reports/manual/user-guide.md",
                                 "reports/manual/reference-data.md", "reports/manual/python.md"}) {
    SCOPED_TRACE(page);
    const auto blocks = read_page(contents(root / page)).blocks;
    EXPECT_TRUE(std::ranges::count(blocks, "sh", &Block::language) > 0);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Block& block = blocks[i];
      if (block.file.ends_with("." + block.language)) std::ofstream(path(block.file)) << block.text;
      if (block.language != "sh") continue;
      const Outcome outcome = terminal(block.text);
      EXPECT_EQ(outcome.status, 0) << block.text << outcome.output;
      if (i + 1 == blocks.size() || blocks[i + 1].language != "text") continue;
      EXPECT_TRUE(std::ranges::equal(printed_words(without_progress(outcome.output)),
                                     printed_words(blocks[i + 1].text), is_as_shown))
          << block.text << "prints\n"
          << outcome.output << "but the page shows\n"
          << blocks[i + 1].text;
    }
  }
}

TEST_F(Manual, LinksLeadToFilesAndHeadings) {
  for (const fs::path& page : pages())
    for (const std::string& target : links_of(read_page(contents(page)))) {
      if (target.starts_with("http")) continue;
      const std::size_t hash = std::min(target.find('#'), target.size());
      const fs::path file = hash == 0 ? page : page.parent_path() / target.substr(0, hash);
      ASSERT_TRUE(fs::exists(file)) << page << ": " << target;
      if (hash == target.size()) continue;
      EXPECT_TRUE(anchors_of(read_page(contents(file))).contains(target.substr(hash + 1)))
          << page << ": " << target;
    }
}

}  // namespace
}  // namespace stickslip::testing
