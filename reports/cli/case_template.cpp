// SPDX-License-Identifier: MIT
#include "case_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "stickslip/data/input_text.hpp"
#include "stickslip/data/toml_file.hpp"

namespace stickslip::cli {

namespace {

// What may stand in place of a line.
constexpr std::pair<std::string_view, std::string_view> replacements[]{
    {"beam.density", "beam.material"},
    {"beam.youngs_modulus", "beam.material"},
    {"beam.area", "section"},
    {"beam.second_moment_of_area", "section"},
    {"excitation.velocity_amplitude", "excitation.amplitude"},
    {"excitation.acceleration_amplitude", "excitation.amplitude"}};

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

constexpr const char* damping_hint = R"(
# Without damping the free vibrations of the start never end. Remove the two # to damp them:
# [damping]
# ratio = "1 %"                  # of critical damping in every mode with a free tip
)";
constexpr const char* numerics_hint = R"(
# The program chooses mesh, time step and number of modes. [numerics] states them instead; see the user guide.
)";

// The value of a key as --set gives it, without the quotes that TOML wants.
std::string without_quotes(const std::string& value) {
  const bool is_quoted =
      value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
  return is_quoted ? value.substr(1, value.size() - 2) : value;
}

}  // namespace

std::vector<CaseLine> steel_blade() {
  return {{"beam", "length", "400 mm", "L, from the clamp to the wall"},
          {"beam", "material", "steel", "or density and youngs_modulus in its place"},
          {"beam", "axial_force", "8 N", "P, presses the tip against the wall"},
          {"section", "shape", "rectangle", "rectangle, circle or tube"},
          {"section", "width", "30 mm", "across the vibration"},
          {"section", "height", "1.5 mm", "in the direction of the vibration"},
          {"section", "diameter", "10 mm", "outside"},
          {"section", "wall_thickness", "1 mm", "of the tube"},
          {"friction", "static_coefficient", "0.5", "largest friction force at rest over the axial force"},
          {"friction", "kinetic_coefficient", "0.3", "the same at high sliding velocity"},
          {"friction", "decay", "1.0", "s/m, how fast the coefficient falls with the sliding velocity"},
          {"excitation", "frequency_hz", "20 Hz", "of the clamp"},
          {"excitation", "amplitude", "2 mm", "or acceleration_amplitude = \"2 g\", or velocity_amplitude"}};
}

std::vector<CaseLine> for_shape(std::vector<CaseLine> lines) {
  const auto given = std::ranges::find(lines, "section.shape", &CaseLine::path);
  if (given == lines.end()) return lines;
  const std::string shape = given->value;
  std::erase_if(lines, [&](const CaseLine& line) {
    const bool is_flat = line.key == "width" || line.key == "height";
    return line.is_asked && line.table == "section" &&
           ((is_flat && shape != "rectangle") || (line.key == "diameter" && shape == "rectangle") ||
            (line.key == "wall_thickness" && shape != "tube"));
  });
  return lines;
}

std::string template_text(const std::vector<CaseLine>& lines, const std::string& file) {
  std::string text =
      fmt::format("# A beam of your own. Try: stickslip criterion {}\n", data::printable(file));
  std::string table;
  for (const CaseLine& line : lines) {
    if (line.table != table) text += fmt::format("{}[{}]\n", table.empty() ? "" : "\n", line.table);
    table = line.table;
    const std::string assignment = fmt::format("{} = {}", line.key, quoted(line.value));
    text += line.comment.empty() ? assignment + "\n" : fmt::format("{:<32}# {}\n", assignment, line.comment);
  }
  if (std::ranges::count(lines, "damping", &CaseLine::table) == 0) text += damping_hint;
  return text + numerics_hint;
}

void set(std::vector<CaseLine>& lines, const data::Override& override) {
  for (const auto& [key, replaced] : replacements)
    if (key == override.key)
      std::erase_if(lines, [name = replaced](const CaseLine& line) {
        return line.is_asked && (line.path() == name || line.table == name);
      });
  const std::string value = without_quotes(override.value);
  const auto line = std::ranges::find(lines, override.key, &CaseLine::path);
  if (line != lines.end()) {
    line->value = value;
    line->is_asked = false;
    return;
  }
  const auto dot = override.key.find('.');
  const std::string table = override.key.substr(0, dot);
  const auto last = std::ranges::find(lines.rbegin(), lines.rend(), table, &CaseLine::table);
  lines.insert(last == lines.rend() ? lines.end() : last.base(),
               {table, dot == std::string::npos ? "" : override.key.substr(dot + 1), value, "", false});
}

}  // namespace stickslip::cli
