#include "completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stickslip::cli {

namespace {

// What prints the published names, one a line; `program` calls the program.
std::string cases_of(std::string_view program) {
  return fmt::format("{} cases 2>/dev/null | cut -d' ' -f1", program);
}
std::string data_sets_of(std::string_view program) {
  return fmt::format("{} reference list 2>/dev/null | tail -n +4 | cut -d' ' -f1", program);
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

// bash: what fills COMPREPLY.
std::string bash_reply(const Argument& argument) {
  switch (argument.kind) {
    case ValueKind::choice:
      return fmt::format("_stickslip_words '{}'", fmt::join(argument.choices, " "));
    case ValueKind::case_name:
      return fmt::format("_stickslip_words \"$({})\"; _stickslip_paths", cases_of("\"$program\""));
    case ValueKind::data_set:
      return fmt::format("_stickslip_words \"$({})\"", data_sets_of("\"$program\""));
    case ValueKind::path:
      return "_stickslip_paths";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return ":";
}

// zsh: the action of a specification of _arguments.
std::string zsh_action(const Argument& argument) {
  switch (argument.kind) {
    case ValueKind::choice:
      return fmt::format("({})", fmt::join(argument.choices, " "));
    case ValueKind::case_name:
      return "_stickslip_cases";
    case ValueKind::data_set:
      return "_stickslip_data_sets";
    case ValueKind::path:
      return "_files";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return " ";
}

// fish: the options of `complete` that say what may follow.
std::string fish_values(const Argument& argument) {
  switch (argument.kind) {
    case ValueKind::none:
      return "";
    case ValueKind::choice:
      return fmt::format(" -x -a '{}'", fmt::join(argument.choices, " "));
    case ValueKind::case_name:
      return fmt::format(" -k -F -a \"({})\"", cases_of("stickslip"));
    case ValueKind::data_set:
      return fmt::format(" -f -a \"({})\"", data_sets_of("stickslip"));
    case ValueKind::path:
      return " -r -F";
    case ValueKind::other:
      break;
  }
  return " -x";
}

std::string escaped(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (c == '\'')
      result += "'\\'";  // ends the quotation; the next character begins it again
    else if (special.find(c) != std::string_view::npos)
      result += '\\';
    result += c;
  }
  return result;
}

// Inside '...' of a specification of _arguments.
std::string zsh_text(std::string_view text) { return escaped(text, "[]:\\"); }

std::string zsh_specifications(const Command& command, std::string_view indent) {
  std::string text;
  const auto add = [&](const std::string& specification) {
    text += fmt::format(" \\\n{}  '{}'", indent, specification);
  };
  for (const Argument& option : command.options) {
    const std::string value = option.kind == ValueKind::none
                                  ? ""
                                  : fmt::format(":{}:{}", zsh_text(option.value), zsh_action(option));
    add(fmt::format("{}{}[{}]{}", option.repeatable ? "*" : "", option.name, zsh_text(option.description),
                    value));
  }
  for (const Argument& positional : command.positionals)
    add(fmt::format("{}:{}:{}", positional.required ? "" : ":", positional.name, zsh_action(positional)));
  return text;
}

}  // namespace

std::string bash_completion(const Command& program) {
  std::string descents, with_values, values, positions, options;
  for (const Command* command : all_commands(program)) {
    for (const Command& sub : command->subcommands)
      descents += fmt::format("{}'{} {}'", descents.empty() ? "" : " | ", command->path, sub.name);
    for (const Argument& option : command->options) {
      if (option.kind == ValueKind::none) continue;
      with_values += fmt::format("{}'{} {}'", with_values.empty() ? "" : " | ", command->path, option.name);
      if (option.kind != ValueKind::other)
        values += fmt::format("    '{} {}') {} ;;\n", command->path, option.name, bash_reply(option));
    }
    options += fmt::format("      '{}'/-*) _stickslip_words '{}' ;;\n", command->path,
                           fmt::join(names_of(command->options), " "));
    if (!command->subcommands.empty())
      positions += fmt::format("          '{} 0') _stickslip_words '{}' ;;\n", command->path,
                               fmt::join(names_of(command->subcommands), " "));
    for (std::size_t place = 0; place < command->positionals.size(); ++place)
      positions += fmt::format("          '{} {}') {} ;;\n", command->path, place,
                               bash_reply(command->positionals[place]));
  }
  return fmt::format(R"sh(# Completion of stickslip for bash, made by the program itself.

_stickslip_words() {{
  local reply
  while IFS= read -r reply; do COMPREPLY+=("$reply"); done < <(compgen -W "$1" -- "$word")
}}

_stickslip_paths() {{
  local reply
  compopt -o filenames 2>/dev/null
  while IFS= read -r reply; do COMPREPLY+=("$reply"); done < <(compgen -f -- "$word")
}}

_stickslip() {{
  local program=${{COMP_WORDS[0]}} word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command= place=0 i
  COMPREPLY=()
  # bash makes words of '=' and ':', too.
  if [[ $word == = ]]; then
    word=
  elif [[ $previous == = ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  # The subcommand, and how many of its arguments stand before the cursor.
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${{COMP_WORDS[i]}}" in
    {0}) command=${{command:+$command }}${{COMP_WORDS[i]}} ;;
    {1})
      ((++i))
      [[ ${{COMP_WORDS[i]}} == = ]] && ((++i))
      ;;
    *' =' | *' :') ((++i)) ;;
    *' -'*) ;;
    *) ((++place)) ;;
    esac
  done
  case "$command $previous" in
{2}    {1}) ;; # a value that nobody knows but who asks
    *)
      case $command/$word in
{3}      *)
        case "$command $place" in
{4}        esac
        ;;
      esac
      ;;
  esac
}}

complete -F _stickslip stickslip
)sh",
                     descents, with_values, values, options, positions);
}

namespace {

// The body of a function that completes a command, and with it those below.
std::string zsh_body(const Command& command, const std::string& indent) {
  std::string text = indent + "_arguments";
  if (command.subcommands.empty()) return text + zsh_specifications(command, indent) + "\n";
  std::string subcommands;
  for (const Command& sub : command.subcommands)
    subcommands += fmt::format(" {}\\:\"{}\"", sub.name, escaped(sub.description, "\\\"$`"));
  text += " -C" + zsh_specifications(command, indent);
  text += fmt::format(" \\\n{0}  '1:subcommand:(({1} ))' \\\n{0}  '*::argument:->argument'\n", indent,
                      subcommands);
  text += fmt::format("{0}[[ $state == argument ]] || return\n{0}case $line[1] in\n", indent);
  for (const Command& sub : command.subcommands)
    text += fmt::format("{0}  {1})\n{2}{0}    ;;\n", indent, sub.name, zsh_body(sub, indent + "    "));
  return text + indent + "esac\n";
}

}  // namespace

std::string zsh_completion(const Command& program) {
  return fmt::format(R"sh(#compdef stickslip
# Completion of stickslip for zsh, made by the program itself.

_stickslip_cases() {{
  local -a names=(${{(f)"$({})"}})
  _alternative 'cases:case:compadd -a names' 'files:file:_files'
}}

_stickslip_data_sets() {{
  local -a names=(${{(f)"$({})"}})
  compadd -a names
}}

_stickslip() {{
  local curcontext=$curcontext state line
{}}}

_stickslip "$@"
)sh",
                     cases_of("stickslip"), data_sets_of("stickslip"), zsh_body(program, "  "));
}

namespace {

// fish: whether the line has come to this command, and not to one below it.
std::string fish_condition(const Command& command) {
  if (command.path.empty()) return "__fish_use_subcommand";
  const std::string seen = "__fish_seen_subcommand_from ";
  std::string condition = seen;
  for (const char c : command.path) condition += c == ' ' ? "; and " + seen : std::string(1, c);
  if (command.subcommands.empty()) return condition;
  return fmt::format("{}; and not {}{}", condition, seen, fmt::join(names_of(command.subcommands), " "));
}

}  // namespace

std::string fish_completion(const Command& program) {
  std::string text =
      "# Completion of stickslip for fish, made by the program itself.\ncomplete -c stickslip -f\n";
  for (const Command* command : all_commands(program)) {
    const std::string line = fmt::format("complete -c stickslip -n '{}'", fish_condition(*command));
    for (const Command& sub : command->subcommands)
      text += fmt::format("{} -a {} -d '{}'\n", line, sub.name, escaped(sub.description, "\\"));
    for (const Argument& option : command->options)
      text += fmt::format("{} -l {}{} -d '{}'\n", line, option.name.substr(2), fish_values(option),
                          escaped(option.description, "\\"));
    for (const Argument& positional : command->positionals)
      text +=
          fmt::format("{}{}\n", line, positional.kind == ValueKind::path ? " -F" : fish_values(positional));
  }
  return text;
}

}  // namespace stickslip::cli
