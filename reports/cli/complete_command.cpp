// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "commands.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::cli {

namespace {

struct Candidate {
  std::string text, description;
};

// bash makes words of '=' and ':', too, so that --band=20:30 is five of them; here it is two.
std::vector<std::string> words_of(const std::vector<std::string>& pieces) {
  std::vector<std::string> joined;
  bool is_joined = false;
  for (const std::string& piece : pieces) {
    const bool joins = piece == "=" || piece == ":";
    if (!joined.empty() && (joins || is_joined))
      joined.back() += piece;
    else
      joined.push_back(piece);
    is_joined = joins;
  }
  std::vector<std::string> words;
  for (const std::string& word : joined) {
    const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    words.push_back(word.substr(0, equals));
    if (equals != std::string::npos) words.push_back(word.substr(equals + 1));
  }
  return words;
}

std::vector<const CLI::App*> subcommands_of(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

std::vector<const CLI::Option*> options_of(const CLI::App& command, bool positional) {
  return command.get_options(
      [positional](const CLI::Option* option) { return option->get_positional() == positional; });
}

// The cases, the data sets, or what stands in braces behind the type, as in "TEXT:{closed-form,fe}".
std::vector<Candidate> values_of(const CLI::Option& option) {
  std::vector<Candidate> values;
  const std::string name = option.get_name(), type = option.get_type_name();
  if (name.starts_with("CASE"))
    for (const auto& [case_name, title] : data::list_cases()) values.push_back({case_name, title});
  if (name == "NAME")
    for (const auto& resource : data::load_reference().resources)
      values.push_back({resource.name, resource.title});
  if (const auto brace = type.find(":{"); brace != std::string::npos)
    for (const auto& word : CLI::detail::split(type.substr(brace + 2, type.size() - brace - 3), ','))
      values.push_back({word, ""});
  return values;
}

// What may stand for the last of the words.
std::vector<Candidate> candidates_for(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* command = &program;
  const CLI::Option* option = nullptr;  // whose value comes next
  std::size_t place = 0;                // among the positional arguments
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string& word = words[i];
    if (option != nullptr) {
      option = nullptr;
    } else if (word.starts_with('-')) {
      option = command->get_option_no_throw(word);
      if (option != nullptr && option->get_items_expected_max() == 0) option = nullptr;
    } else {
      const auto below = subcommands_of(*command);
      const auto sub = std::ranges::find(below, word, &CLI::App::get_name);
      if (sub == below.end())
        ++place;
      else
        command = *sub;
    }
  }
  if (option != nullptr) return values_of(*option);
  std::vector<Candidate> candidates;
  if (words.back().starts_with('-')) {
    for (const CLI::Option* one : options_of(*command, false))
      for (const std::string& name : one->get_lnames())
        candidates.push_back({"--" + name, one->get_description()});
    return candidates;
  }
  for (const CLI::App* sub : subcommands_of(*command))
    candidates.push_back({sub->get_name(), sub->get_description()});
  if (const auto positionals = options_of(*command, true); candidates.empty() && place < positionals.size())
    return values_of(*positionals[place]);
  return candidates;
}

struct CompleteOptions {
  const CLI::App* program{};
  std::vector<std::string> words;
};

Answer completions(const CompleteOptions& options, Outputs&) {
  const auto& pieces = options.words;
  const auto words = words_of(pieces);
  Answer answer;
  // Of --method=fe, which is one word elsewhere, all is replaced.
  const std::string& last = pieces.back();
  const std::size_t kept = last.starts_with("--") ? last.find('=') + 1 : 0;  // npos + 1 is 0
  for (const auto& [text, description] : candidates_for(*options.program, words))
    if (text.starts_with(words.back()))
      answer.add_line(fmt::format("{}{}\t{}", last.substr(0, kept), text, description));
  return answer;
}

void add_options(CLI::App& command, CompleteOptions& options) {
  command.group("");
  options.program = command.get_parent();
  command.add_option("WORDS", options.words)->required();
}

}  // namespace

void add_complete_command(CLI::App& app) {
  add<CompleteOptions>(app, {.name = "complete",
                             .help = "What may stand for the last of the words of a command line",
                             .examples = {},
                             .add_options = add_options,
                             .run = completions});
}

}  // namespace stickslip::cli
