#include "manual_page.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <utility>

namespace stickslip::cli {

namespace {

// A line of text that roff prints as it stands.
std::string roff(std::string_view text) {
  std::string escaped = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else if (c == '\'')
      escaped += "\\(aq";
    else if (c == '"')
      escaped += "\\(dq";
    else
      escaped += c;
  }
  return escaped;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string usage_of(const Command& program, const Command& command) {
  std::string usage = program.name;
  if (!command.path.empty()) usage += " " + command.path;
  usage += " [OPTIONS]";
  if (!command.subcommands.empty()) usage += " SUBCOMMAND";
  for (const Argument& argument : command.positionals)
    usage += argument.required ? " " + argument.name : " [" + argument.name + "]";
  return usage;
}

std::string description_of(const Argument& argument) {
  std::string notes = argument.description;
  if (argument.required && !argument.value.empty()) notes += "; required";
  if (!argument.range.empty()) notes += "; " + argument.range;
  if (!argument.default_value.empty()) notes += "; default " + argument.default_value;
  return notes + ".";
}

std::string paragraph_of(const Argument& argument) {
  std::string head = argument.short_name.empty() ? "" : bold(argument.short_name) + ", ";
  head += bold(argument.name);
  if (!argument.value.empty()) head += " " + italic(argument.value);
  return fmt::format(".TP\n{}\n{}\n", head, roff(description_of(argument)));
}

std::string examples_of(const Command& command) {
  std::string text = ".PP\nExamples:\n.PP\n.nf\n.RS\n";
  for (const std::string& example : command.examples) text += roff(example) + "\n";
  return text + ".RE\n.fi\n";
}

std::string body_of(const Command& command) {
  std::string text;
  for (const auto* arguments : {&command.positionals, &command.options})
    for (const Argument& argument : *arguments) text += paragraph_of(argument);
  return text + examples_of(command);
}

std::string definitions(std::initializer_list<std::pair<std::string_view, std::string_view>> entries) {
  std::string text;
  for (const auto& [name, meaning] : entries) text += fmt::format(".TP\n{}\n{}\n", bold(name), roff(meaning));
  return text;
}

}  // namespace

std::string manual_page(const Command& program, std::string_view version) {
  std::string text =
      fmt::format(".\\\" Made by {0} itself.\n.TH STICKSLIP 1 \"\" \"{0} {1}\" \"User Commands\"\n",
                  program.name, version);
  text += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}\n.SH OPTIONS\n{}", program.name,
                      roff(program.description), roff(usage_of(program, program)), body_of(program));
  text += ".SH SUBCOMMANDS\n";
  for (const Command* command : all_commands(program))
    if (command != &program)
      text += fmt::format(".SS {}\n{}.\n{}", roff(usage_of(program, *command)), roff(command->description),
                          body_of(*command));
  text += ".SH EXIT STATUS\n" + definitions({{"0", "Done."},
                                             {"1", "A run or a check failed."},
                                             {"2", "Unusable input or output; nothing was written."}});
  text += ".SH ENVIRONMENT\n" +
          definitions({{"STICKSLIP_DATA",
                        "The folder with cases/, paper/ and reference/ (else that of the installation)."},
                       {"STICKSLIP_REPORTS",
                        "The folder with the scripts of the figures (else that of the installation)."}});
  return text;
}

}  // namespace stickslip::cli
