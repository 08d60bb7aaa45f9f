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
    {"model.damping_matrix", "damping"},
    {"excitation.force", "excitation.amplitude"},
    {"excitation.velocity_amplitude", "excitation.amplitude"},
    {"excitation.acceleration_amplitude", "excitation.amplitude"}};

// A value that is no text.
bool is_toml_value(const std::string& value) {
  try {
    return !data::parse_toml("", "value = " + value).get("value")->is_string();
  } catch (const data::InputError&) {
    return false;
  }
}

std::string quoted(const std::string& value) {
  if (value.find_first_of("\"\\\r\n") != std::string::npos) return data::printable(value);
  return is_toml_value(value) ? value : "\"" + value + "\"";
}

constexpr const char* damping_hint = R"(
# Without damping the free vibrations of the start never end. Remove the two # to damp them:
# [damping]
# ratio = "1 %"                  # of critical damping in every mode with a free tip
)";
constexpr const char* held_damping_hint = R"(
# Remove the two # to damp the modes of the held contact, unless there is a damping_matrix:
# [damping]
# ratio = "1 %"                  # of critical damping; or ratios = [0.01, 0.02], mode by mode
)";
constexpr const char* numerics_hint = R"(
# The program chooses mesh, time step and number of modes. [numerics] states them instead; see the user guide.
)";
constexpr const char* model_hint = R"(
# The program chooses time step and number of modes. [numerics] states them instead; see the user guide.
)";
constexpr const char* matrices_hint = R"(
# The files are yours: put them beside this one or below. Matrix Market files as here, or those of CalculiX:
#   mass_matrix = "x.mas"          # *FREQUENCY, SOLVER=MATRIXSTORAGE; no *BOUNDARY at the base
#   stiffness_matrix = "x.sti"
#   dofs = "x.dof"
#   base = { nodes = "clamp.nam", direction = "z" }    # or nodes = [1, 2]; directions not named are held
#   contact = { nodes = [37], direction = "z" }
# Further keys of [model]:
#   damping_matrix = "c.mtx"       # excludes damping.ratio
#   fixed = [2]                    # rows that stay
#   load = 9                       # with [excitation] force = "3 N" in place of an amplitude
)";

// The value of a key as --set gives it, without the quotes that TOML wants.
std::string without_quotes(const std::string& value) {
  const bool is_quoted =
      value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
  return is_quoted ? value.substr(1, value.size() - 2) : value;
}

// What all cases end with.
std::vector<CaseLine> with_friction(std::vector<CaseLine> lines) {
  const CaseLine common[]{
      {"friction", "static_coefficient", "0.5", "largest friction force at rest over the normal force"},
      {"friction", "kinetic_coefficient", "0.3", "the same at high sliding velocity"},
      {"friction", "decay", "1.0", "s/m, how fast the coefficient falls with the sliding velocity"},
      {"excitation", "frequency_hz", "20 Hz", "of the base"},
      {"excitation", "amplitude", "2 mm", "or acceleration_amplitude = \"2 g\", or velocity_amplitude"}};
  lines.insert(lines.end(), std::begin(common), std::end(common));
  return lines;
}

bool has(const std::vector<CaseLine>& lines, std::string_view path) {
  return std::ranges::find(lines, path, &CaseLine::path) != lines.end();
}

}  // namespace

std::vector<CaseLine> one_mass() {
  return with_friction({{"model", "mass", "0.5 kg", "on a spring and a damper to the base"},
                        {"model", "stiffness", "7 N/mm", "of the spring, may be 0"},
                        {"model", "damping", "5 N s/m", "of the damper, may be 0"},
                        {"model", "normal_force", "20 N", "N, closes the contact"}});
}

std::vector<CaseLine> matrices() {
  return with_friction(
      {{"model", "mass_matrix", "m.mtx", "over all degrees of freedom, the base included"},
       {"model", "stiffness_matrix", "k.mtx", "with the effect of a preload, if there is one"},
       {"model", "base", "[1]", "rows from 1 that move with the base"},
       {"model", "contact", "41", "or { rows = [41, 43], weights = [0.5, 0.5] }"},
       {"model", "normal_force", "20 N", "N, closes the contact; it does not change the matrices"},
       {"model", "units", "m", "of the files: m (m, kg, s) or mm (mm, t, s)"}});
}

std::vector<CaseLine> steel_blade() {
  return with_friction({{"beam", "length", "400 mm", "L, from the clamp to the wall"},
                        {"beam", "material", "steel", "or density and youngs_modulus in its place"},
                        {"beam", "axial_force", "8 N", "P, presses the tip against the wall"},
                        {"section", "shape", "rectangle", "rectangle, circle or tube"},
                        {"section", "width", "30 mm", "across the vibration"},
                        {"section", "height", "1.5 mm", "in the direction of the vibration"},
                        {"section", "diameter", "10 mm", "outside"},
                        {"section", "wall_thickness", "1 mm", "of the tube"}});
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
  const bool is_mass = has(lines, "model.mass"), is_model = has(lines, "model.normal_force");
  std::string text = fmt::format("# {} of your own. Try: stickslip criterion {}\n",
                                 is_mass    ? "A mass"
                                 : is_model ? "A structure"
                                            : "A beam",
                                 data::printable(file));
  std::string table;
  for (const CaseLine& line : lines) {
    if (line.table != table) text += fmt::format("{}[{}]\n", table.empty() ? "" : "\n", line.table);
    table = line.table;
    const std::string assignment = fmt::format("{} = {}", line.key, quoted(line.value));
    text += line.comment.empty() ? assignment + "\n" : fmt::format("{:<32}# {}\n", assignment, line.comment);
  }
  if (std::ranges::count(lines, "damping", &CaseLine::table) == 0 && !is_mass)
    text += is_model ? held_damping_hint : damping_hint;
  if (is_model && !is_mass) text += matrices_hint;
  return text + (is_model ? model_hint : numerics_hint);
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
