#include "command_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace stickslip::cli {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// "TEXT", "TEXT:{stick,slip}", "INT:1 ... 1000", or a name that the option chose, which may hold a colon,
// too.
void read_type(const std::string& type, Argument& argument) {
  const std::size_t colon = type.find(':');
  const std::string name = type.substr(0, colon);
  const std::string allowed = colon == std::string::npos ? "" : type.substr(colon + 1);
  argument.kind = ValueKind::other;
  argument.value = type;
  if (name == "TEXT" && allowed.starts_with('{')) {
    argument.kind = ValueKind::choice;
    argument.choices = split(allowed.substr(1, allowed.size() - 2), ',');
    argument.value = fmt::format("{}", fmt::join(argument.choices, "|"));
  } else if (name == "TEXT" || name == "FOLDER") {  // no option takes a text that is no path
    argument.kind = ValueKind::path;
    argument.value = "PATH";
  } else if (name == "INT") {
    argument.range = allowed;
    argument.value = name;
  }
}

Argument argument_of(const CLI::Option& option) {
  Argument argument;
  argument.description = option.get_description();
  argument.default_value = option.get_default_str();
  argument.required = option.get_required();
  argument.name = option.get_positional() ? option.get_name(true) : "--" + option.get_lnames().front();
  if (!option.get_snames().empty()) argument.short_name = "-" + option.get_snames().front();
  if (option.get_items_expected_max() == 0) return argument;
  argument.repeatable = option.get_expected_max() > 1;
  read_type(option.get_type_name(), argument);
  if (option.get_positional()) {
    argument.value.clear();
    if (argument.name == "CASE") argument.kind = ValueKind::case_name;
    if (argument.name == "NAME") argument.kind = ValueKind::data_set;
  }
  return argument;
}

Command command_of(const CLI::App& app, const std::string& path) {
  Command command;
  command.name = app.get_name();
  command.path = path;
  command.description = app.get_description();
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? command.positionals : command.options).push_back(argument_of(*option));
  for (const CLI::App* sub :
       app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); }))
    command.subcommands.push_back(
        command_of(*sub, path.empty() ? sub->get_name() : path + " " + sub->get_name()));
  for (const std::string& line : split(app.get_footer(), '\n'))
    if (line.starts_with("  ")) command.examples.push_back(line.substr(2));
  return command;
}

}  // namespace

Command command_tree(const CLI::App& app) { return command_of(app, ""); }

std::vector<const Command*> all_commands(const Command& command) {
  std::vector<const Command*> all{&command};
  for (const Command& sub : command.subcommands) {
    const auto below = all_commands(sub);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

}  // namespace stickslip::cli
