// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "case_options.hpp"
#include "case_template.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

struct NewOptions {
  std::string file;
  std::vector<std::string> overrides;
  bool ask{};
  std::string model;
};

// Throws data::InputError if the lines are no case.
void require_case(const std::vector<CaseLine>& lines, const std::string& file) {
  (void)data::parse_case(file, template_text(for_shape(lines), file));
}

// Asks until the value is one that the case may have; an empty answer keeps it.
void ask(std::vector<CaseLine>& lines, std::size_t asked, const std::string& file) {
  for (;;) {
    std::vector<CaseLine> changed = lines;
    CaseLine& line = changed[asked];
    std::cerr << fmt::format("{} ({}) [{}]: ", line.path(), line.comment, line.value);
    std::string answer;
    if (!std::getline(std::cin, answer))
      throw data::InputError("standard input ends before " + line.path() +
                             " is answered; nothing is written");
    if (const auto value = data::trimmed(answer); !value.empty()) line.value = value;
    try {
      require_case(changed, file);
      lines = std::move(changed);
      return;
    } catch (const data::InputError& error) {
      std::cerr << data::plain_text(error.what()) << "\n";
    }
  }
}

void ask_all(std::vector<CaseLine>& lines, const std::string& file) {
  std::cerr << "Enter keeps the value in brackets.\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].is_asked) continue;
    ask(lines, i, file);
    if (lines[i].path() == "section.shape") lines = for_shape(std::move(lines));
  }
}

Answer new_case(const NewOptions& options, Outputs& outputs) {
  std::error_code unusable;  // which opening it reports
  if (std::filesystem::exists(options.file, unusable))
    throw data::FieldError("FILE", data::printable(options.file), "a file that does not exist yet");
  std::vector<CaseLine> lines = options.model == "mass"       ? one_mass()
                                : options.model == "matrices" ? matrices()
                                                              : steel_blade();
  for (const std::string& text : options.overrides) set(lines, data::Override::parse(text));
  const bool at_a_terminal =
      options.overrides.empty() && ::isatty(STDIN_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1;
  require_case(lines, options.file);
  if (options.ask || at_a_terminal) ask_all(lines, options.file);
  outputs.open({{"FILE", options.file}});
  outputs.write("FILE", [&] { return template_text(for_shape(lines), options.file); });
  Answer answer;
  answer.add_line(fmt::format("{0} written; whether it slips{1}: stickslip criterion {0}", options.file,
                              options.model == "matrices" ? ", once its files are beside it" : ""));
  return answer;
}

void add_options(CLI::App& command, NewOptions& options) {
  command.add_option("FILE", options.file, "TOML file to write, which must not exist yet")
      ->check(file_name())
      ->required();
  add_set_option(
      command, options.overrides,
      "A value of the new case, as in 'beam.length=250 mm'; repeatable. On a terminal, without --set, "
      "the values are asked for");
  command
      .add_option("--model", options.model, "A structure in place of a beam: one mass, or matrices in files")
      ->check(one_of({"mass", "matrices"}));
  command.add_flag("--ask", options.ask, "Ask for the values that --set does not give, terminal or not");
}

}  // namespace

void add_new_command(CLI::App& app) {
  add<NewOptions>(
      app, {.name = "new",
            .help = "Write a case file with comments, to start from",
            .examples = {"stickslip new my-tube.toml --set section.shape=tube --set 'beam.length=1.2 m'",
                         "stickslip new my-clip.toml --model matrices"},
            .add_options = add_options,
            .run = new_case});
}

}  // namespace stickslip::cli
