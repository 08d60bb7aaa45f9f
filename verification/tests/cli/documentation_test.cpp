// SPDX-License-Identifier: MIT
/// What the program says of itself: examples of the help, manual pages and completion, against the help.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/command_line.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// What a heading of the help is followed by, without the indentation; what belongs to an entry goes on
// further to the right.
std::vector<std::string> entries(const std::string& help, const std::string& heading) {
  const auto lines = lines_of(help);
  std::vector<std::string> found;
  for (auto line = std::ranges::find(lines, heading);
       line != lines.end() && ++line != lines.end() && !line->empty();)
    if (line->starts_with("  ") && line->at(2) != ' ') found.push_back(line->substr(2));
  return found;
}

std::string first_word(const std::string& text) { return text.substr(0, text.find(' ')); }

// The pages of the build tree whose program this is.
fs::path manual_pages() { return fs::path(STICKSLIP_PROGRAM).parent_path().parent_path() / "share/man/man1"; }

// Whether a word stands in a text, and not as a part of a longer one.
bool holds_word(const std::string& text, const std::string& word) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-'; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_part(text[at - 1])) &&
        (at + word.size() == text.size() || !is_part(text[at + word.size()])))
      return true;
  return false;
}

class Documented : public Drawing {
 protected:
  [[nodiscard]] std::string help(const std::string& command) const {
    const Outcome outcome = run_line(command + " --help");
    EXPECT_EQ(outcome.status, 0) << command;
    return outcome.output;
  }

  // Paths of all subcommands, from "" for the program to "reference export".
  [[nodiscard]] std::vector<std::string> commands(const std::string& command = "") const {
    std::vector<std::string> all{command};
    for (const std::string& entry : entries(help(command), "Subcommands:"))
      for (const std::string& below : commands(command + (command.empty() ? "" : " ") + first_word(entry)))
        all.push_back(below);
    return all;
  }

  // "--hz" and the like, "-h" and the names of positional arguments.
  [[nodiscard]] std::vector<std::string> arguments(const std::string& command) const {
    std::vector<std::string> names;
    const std::string text = help(command);
    for (const std::string& entry : entries(text, "Positionals:")) names.push_back(first_word(entry));
    for (const std::string& entry : entries(text, "Options:")) {
      std::istringstream spellings(first_word(entry));
      for (std::string name; std::getline(spellings, name, ',');) names.push_back(name);
    }
    return names;
  }
};

using HelpExamples = Documented;
using HelpedCommand = Documented;
using ManualPage = Documented;
using Completion = Documented;

STICKSLIP_VERIFIES(HelpExamples, "U9");
// The first one of a command that has --json answers so, as the schema says.
TEST_F(HelpExamples, AreThereForEveryCommandAndRun) {
  install_gnuplot("case $4 in\nanimation.gp)\n" + std::string(draw_all) +
                  ";;\n*) echo drawn > $output ;;\nesac\n");
  std::ofstream(path("judge.py")) << R"(import json, jsonschema, sys
answer, schema = json.load(sys.stdin), json.load(open(sys.argv[1]))
of_command = {"definitions": schema["definitions"], "$ref": "#/definitions/" + sys.argv[2]}
for one in schema, of_command:
    jsonschema.Draft7Validator(one).validate(answer)
)";
  const std::string program = fs::path(STICKSLIP_PROGRAM).parent_path().string();
  const auto all = commands();
  ASSERT_GE(all.size(), 14U);
  int judged = 0;
  for (const std::string& command : all) {
    const std::string text = help(command);
    const auto examples = entries(text, "Examples:");
    EXPECT_FALSE(examples.empty()) << command;
    for (std::string example : examples) {
      ASSERT_TRUE(example.starts_with("stickslip ")) << example;
      if (example == examples.front() && holds(text, "Print one JSON object")) {
        ++judged;
        if (!holds(example, " --json")) example += " --json";
        example += fmt::format(" > answer && python3 judge.py {}/data/answers.schema.json {} < answer",
                               STICKSLIP_SOURCE_DIRECTORY, command);
      }
      const Outcome outcome = shell(fmt::format("PATH='{}':$PATH; {}", program, example));
      EXPECT_EQ(outcome.status, 0) << example << outcome.errors;
    }
    EXPECT_TRUE(std::ranges::any_of(examples, [&](const std::string& example) {
      return example.starts_with("stickslip " + command);
    })) << command;
  }
  EXPECT_GE(judged, 11);
}

// "stickslip", "stickslip-map", "stickslip-reference-show"
std::string page_of(const std::string& command) {
  std::string name = command.empty() ? "stickslip" : "stickslip " + command;
  std::ranges::replace(name, ' ', '-');
  return name;
}

// What stands in a page, without what formats it.
std::string words_of_page(const std::string& name) {
  return std::regex_replace(contents(manual_pages() / (name + ".1")), std::regex(R"(\\f.|\\[/,&]|\\(?=-))"),
                            "");
}

STICKSLIP_VERIFIES(HelpedCommand, "U6");
TEST_F(HelpedCommand, IsVerifiedOrExcludedByName) {
  const toml::table file = toml::parse_file(STICKSLIP_SOURCE_DIRECTORY "/verification/acceptance.toml");
  std::vector<std::string> named, all{"complete"};  // which the help does not list
  for (const auto& [command, reason] : *file["excluded"].as_table()) named.emplace_back(command);
  for (const toml::node& quantity : *file["quantity"].as_array())
    for (const toml::node& command : *(*quantity.as_table())["commands"].as_array())
      named.push_back(command.value_or(std::string()));
  for (const std::string& entry : entries(help(""), "Subcommands:")) all.push_back(first_word(entry));
  std::ranges::sort(named);
  std::ranges::sort(all);
  EXPECT_EQ(named, all);
}

// What the user guide says of its examples of motions that repeat.
TEST_F(HelpExamples, OfTheUserGuideFindWhatItSays) {
  const auto periodic = json("periodic damped --set numerics.modes=5");
  ASSERT_TRUE(periodic["found"]);
  const auto& largest = periodic["multipliers"][0];
  EXPECT_NEAR(std::hypot(largest["real"].get<double>(), largest["imaginary"].get<double>()), 1.24, 0.005);
  const auto map = json(
      "map damped --set numerics.time_step=1e-4 --duration 3 --x frequency=24:36:4 --y "
      "amplitude=3e-4:1.5e-3:3 --quantity slip-share,work,period --output motion.csv");
  EXPECT_EQ(map["converged"], (nlohmann::json{{"slip-share", 11}, {"work", 10}, {"period", 2}}));
}

STICKSLIP_VERIFIES(ManualPage, "U9");
TEST_F(ManualPage, HoldsOptionsAndExamples) {
  std::size_t pages = 0;
  for (const std::string& command : commands()) {
    const std::string name = page_of(command), page = words_of_page(name);
    EXPECT_TRUE(holds(page, "\n.SH NAME\n" + name + " - "));
    for (const std::string& argument : arguments(command))
      EXPECT_TRUE(holds_word(page, argument)) << command << " " << argument;
    for (const std::string& example : entries(help(command), "Examples:"))
      EXPECT_TRUE(holds(page, "\n" + example + "\n"));
    EXPECT_TRUE(holds(page, "STICKSLIP_DATA")) << name;
    ++pages;
  }
  const auto files = fs::directory_iterator(manual_pages());
  EXPECT_EQ(static_cast<std::size_t>(std::distance(begin(files), end(files))), pages);
}

TEST_F(ManualPage, IsTypesetWithoutAWarning) {
  for (const auto& page : fs::directory_iterator(manual_pages())) {
    const Outcome groff = shell("groff -man -Tutf8 -ww -z '" + page.path().string() + "'");
    EXPECT_EQ(groff.status, 0) << page.path();
    EXPECT_EQ(groff.errors, "") << page.path();
  }
}

STICKSLIP_VERIFIES(Completion, "U9");
TEST_F(Completion, OfBashKnowsAllWords) {
  const std::string script = STICKSLIP_SOURCE_DIRECTORY "/reports/cli/completion/stickslip";
  // What bash offers for the last of the words, into which it has split a line.
  const auto offered = [&](const std::string& words) {
    const Outcome outcome = shell(
        fmt::format("bash --norc -c 'source {}; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _stickslip; "
                    "printf \"%s|\" \"${{COMPREPLY[@]}}\"' bash '{}' {}",
                    script, STICKSLIP_PROGRAM, words));
    EXPECT_EQ(outcome.status, 0) << words;
    EXPECT_EQ(outcome.errors, "") << words;
    return outcome.output;
  };
  const std::string nothing = "|";  // so that bash offers files
  EXPECT_EQ(offered("cri"), "criterion|");
  EXPECT_EQ(offered("respond --m"), "--method|");
  EXPECT_EQ(offered("respond --method ''"), "boundary-integral|closed-form|event-driven|fe|");
  EXPECT_EQ(offered("respond --method = cl"), "closed-form|");
  EXPECT_EQ(offered("respond --method ="), "boundary-integral|closed-form|event-driven|fe|");
  EXPECT_EQ(offered("modes steel"), "steel-strip|");
  EXPECT_EQ(offered("criterion --set beam.length = 1 steel"), "steel-strip|");
  EXPECT_EQ(offered("design --band 20 : 30 --json steel"), "steel-strip|");
  EXPECT_EQ(offered("reference e"), "export|");
  EXPECT_EQ(offered("reference show stick-fr"), "stick-frequencies|");
  EXPECT_EQ(offered("compare stick-fr"), "stick-frequencies|");
  EXPECT_EQ(offered("compare stick-frequencies my-"), nothing);
  EXPECT_EQ(offered("criterion 'my b'"), nothing);
  EXPECT_EQ(offered("respond paper --output my-"), nothing);
  EXPECT_EQ(offered("criterion --hz 2"), nothing);
  EXPECT_EQ(offered("complet"), nothing);
  EXPECT_TRUE(
      holds(shell("bash --norc -c 'source " + script + "; complete -p stickslip'").output, "-o default"));
}

// zsh and fish hand over words as they are typed, and show the descriptions.
TEST_F(Completion, TakesAnEqualsSignAndDescribes) {
  EXPECT_EQ(run_line("complete -- respond --method=cl").output, "--method=closed-form\t\n");
  EXPECT_EQ(run_line("complete -- cri").output,
            "criterion\tWhether stick-slip occurs, and from which amplitude on (closed form)\n");
  EXPECT_EQ(run_line("complete -- modes --co").output, "--count\tHow many, from the lowest\n");
}

}  // namespace
}  // namespace stickslip::testing
