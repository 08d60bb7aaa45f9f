// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/toml_file.hpp"

namespace stickslip::cli {

namespace {

struct NewOptions {
  std::string file;
  std::vector<std::string> overrides;
  bool ask{};
};

// A line of the new case. The value is as in the file, but without the quotes.
struct Line {
  std::string table, key, value, comment;
  bool is_asked{true};  // and not set by --set

  [[nodiscard]] std::string path() const { return table + "." + key; }
};

// The steel strip of the tutorial.
std::vector<Line> strip() {
  return {
      {"beam", "length", "400 mm", "L, from the clamp to the wall"},
      {"beam", "material", "steel", "or density and youngs_modulus in its place"},
      {"beam", "axial_force", "40 N", "P, presses the tip against the wall"},
      {"section", "shape", "rectangle", "rectangle, circle or tube"},
      {"section", "width", "30 mm", "across the vibration"},
      {"section", "height", "1.5 mm", "in the direction of the vibration"},
      {"section", "diameter", "10 mm", "outside"},
      {"section", "wall_thickness", "1 mm", "of the tube"},
      {"friction", "static_coefficient", "0.5", "largest friction force at rest over the axial force"},
      {"friction", "kinetic_coefficient", "0.3", "the same at high sliding velocity"},
      {"friction", "decay", "1.0", "s/m, how fast the coefficient falls with the sliding velocity"},
      {"excitation", "frequency_hz", "30 Hz", "of the clamp"},
      {"excitation", "amplitude", "0.5 mm", "or acceleration_amplitude = \"2 g\", or velocity_amplitude"}};
}

// What may stand in place of a line.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> replacements{
    {{"beam.density", "beam.material"},
     {"beam.youngs_modulus", "beam.material"},
     {"beam.area", "section"},
     {"beam.second_moment_of_area", "section"},
     {"excitation.velocity_amplitude", "excitation.amplitude"},
     {"excitation.acceleration_amplitude", "excitation.amplitude"}}};

bool is_toml_number(const std::string& value) {
  try {
    return data::parse_toml("", "value = " + value).get("value")->is_number();
  } catch (const data::InputError&) {
    return false;
  }
}

std::string quoted(const std::string& value) {
  if (value.find_first_of("\"\\\r\n") != std::string::npos) return data::printable(value);
  return is_toml_number(value) ? value : "\"" + value + "\"";
}

// Without the sides that a section of this shape does not have, unless --set gives them: the reader refuses those.
std::vector<Line> for_shape(std::vector<Line> lines) {
  const auto given = std::ranges::find(lines, "section.shape", &Line::path);
  if (given == lines.end()) return lines;
  const std::string shape = given->value;
  std::erase_if(lines, [&](const Line& line) {
    const bool is_flat = line.key == "width" || line.key == "height";
    return line.is_asked && line.table == "section" &&
           ((is_flat && shape != "rectangle") || (line.key == "diameter" && shape == "rectangle") ||
            (line.key == "wall_thickness" && shape != "tube"));
  });
  return lines;
}

std::string text_of(const std::vector<Line>& lines, const std::string& file) {
  std::string text =
      fmt::format("# A beam of your own. Try: stickslip criterion {}\n", data::printable(file));
  std::string table;
  for (const Line& line : lines) {
    if (line.table != table) text += fmt::format("{}[{}]\n", table.empty() ? "" : "\n", line.table);
    table = line.table;
    const std::string assignment = fmt::format("{} = {}", line.key, quoted(line.value));
    text += line.comment.empty() ? assignment + "\n" : fmt::format("{:<32}# {}\n", assignment, line.comment);
  }
  if (std::ranges::count(lines, "damping", &Line::table) == 0)
    text +=
        "\n# Without damping the free vibrations of the start never end. Remove the two # to damp them:\n"
        "# [damping]\n# ratio = \"1 %\"                  # of critical damping in every mode with a free "
        "tip\n";
  text +=
      "\n# The program chooses mesh, time step and number of modes. [numerics] states them instead; see the "
      "user guide.\n";
  return text;
}

// The value of a key as --set gives it, without the quotes that TOML wants.
std::string without_quotes(const std::string& value) {
  const bool is_quoted =
      value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
  return is_quoted ? value.substr(1, value.size() - 2) : value;
}

void set(std::vector<Line>& lines, const data::Override& override) {
  for (const auto& [key, replaced] : replacements)
    if (key == override.key)
      std::erase_if(lines, [name = replaced](const Line& line) {
        return line.is_asked && (line.path() == name || line.table == name);
      });
  const std::string value = without_quotes(override.value);
  const auto line = std::ranges::find(lines, override.key, &Line::path);
  if (line != lines.end()) {
    line->value = value;
    line->is_asked = false;
    return;
  }
  const auto dot = override.key.find('.');
  const std::string table = override.key.substr(0, dot);
  const auto last = std::ranges::find(lines.rbegin(), lines.rend(), table, &Line::table);
  lines.insert(last == lines.rend() ? lines.end() : last.base(),
               {table, dot == std::string::npos ? "" : override.key.substr(dot + 1), value, "", false});
}

// Throws data::InputError if the lines are no case.
void require_case(const std::vector<Line>& lines, const std::string& file) {
  (void)data::parse_case(file, text_of(for_shape(lines), file));
}

// Asks until the value is one that the case may have; an empty answer keeps it.
void ask(std::vector<Line>& lines, std::size_t asked, const std::string& file) {
  for (;;) {
    Line& line = lines[asked];
    fmt::print(stderr, "{} ({}) [{}]: ", line.path(), line.comment, line.value);
    std::string answer;
    if (!std::getline(std::cin, answer))
      throw data::InputError("standard input ends before " + line.path() +
                             " is answered; nothing is written");
    const std::string kept = line.value;
    if (const auto value = data::trimmed(answer); !value.empty()) line.value = value;
    try {
      require_case(lines, file);
      return;
    } catch (const data::InputError& error) {
      line.value = kept;
      fmt::print(stderr, "{}\n", error.what());
    }
  }
}

void ask_all(std::vector<Line>& lines, const std::string& file) {
  fmt::print(stderr, "Enter keeps the value in brackets.\n");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].is_asked) continue;
    ask(lines, i, file);
    if (lines[i].path() == "section.shape") lines = for_shape(std::move(lines));
  }
}

Answer new_case(const NewOptions& options, Outputs& outputs) {
  std::error_code unusable;  // which OutputFile reports
  if (std::filesystem::exists(options.file, unusable))
    throw data::FieldError("FILE", data::printable(options.file), "a file that does not exist yet");
  std::vector<Line> lines = strip();
  for (const std::string& text : options.overrides) set(lines, data::Override::parse(text));
  const bool at_a_terminal =
      options.overrides.empty() && ::isatty(STDIN_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1;
  require_case(lines, options.file);
  if (options.ask || at_a_terminal) ask_all(lines, options.file);
  outputs.open({{"FILE", options.file}});
  outputs.write("FILE", [&] { return text_of(for_shape(lines), options.file); });
  Answer answer;
  answer.add_line(fmt::format("{0} written; whether it slips: stickslip criterion {0}", options.file));
  return answer;
}

void add_options(CLI::App& command, NewOptions& options) {
  command.add_option("FILE", options.file, "TOML file to write, which must not exist yet")
      ->check(file_name())
      ->required();
  command
      .add_option("--set", options.overrides,
                  "A value of the new case, as in 'beam.length=250 mm'; repeatable. On a terminal, without "
                  "--set, the values are asked for")
      ->type_name("TABLE.KEY=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--ask", options.ask, "Ask for the values that --set does not give, terminal or not");
}

}  // namespace

void add_new_command(CLI::App& app) {
  add<NewOptions>(
      app, {.name = "new",
            .help = "Write a case file with comments, to start from",
            .examples = {"stickslip new my-tube.toml --set section.shape=tube --set 'beam.length=1.2 m'"},
            .add_options = add_options,
            .run = new_case});
}

}  // namespace stickslip::cli
