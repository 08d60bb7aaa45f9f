// SPDX-License-Identifier: MIT
#include "studies/analyses/squeal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "range_text.hpp"
#include "render/csv_table.hpp"
#include "render/drawing.hpp"

namespace stickslip::cli {

namespace {

struct SquealOptions {
  CaseOptions problem{.name = "reed"};
  int modes = 5;
  int settle = 200;
  std::string map, speeds, ratios, figure;
  int count = 41;
};

Value growth_of(const std::optional<std::complex<double>>& root) {
  if (!root) return {nullptr, "real root"};
  return {{{"growth_per_s", root->real()}, {"frequency_hz", root->imag() / (2.0 * std::numbers::pi)}},
          fmt::format("{:.6g}", root->real())};
}

Value limit_of(const std::optional<double>& value) {
  if (!value) return {nullptr, "none"};
  return std::isfinite(*value) ? rounded(*value, 6) : Value{nullptr, "every speed"};
}

Table modes_table(const std::vector<studies::SquealMode>& modes) {
  Table table{.columns = {{"mode", "", 5},
                          {"f / Hz", "frequency_hz", 13},
                          {"damping", "damping_ratio", 12},
                          {"growth / (1/s)", "root", 18},
                          {"growth, mesh", "finite_element_root", 18},
                          {"alone holds", "slope_held_alone_Ns_per_m", 16},
                          {"holds", "slope_held_Ns_per_m", 16},
                          {"unstable below / (m/s)", "critical_speed_m_per_s"},
                          {"", "unstable_at_every_speed"}},
              .rows = {}};
  for (const auto& mode : modes)
    table.rows.push_back({count(table.rows.size() + 1),
                          rounded(mode.frequency_hz, 7),
                          rounded(mode.damping_ratio, 4),
                          growth_of(mode.root),
                          growth_of(mode.finite_element_root),
                          rounded(mode.one_mode_slope, 6),
                          limit_of(mode.critical_slope),
                          limit_of(mode.critical_speed),
                          {mode.critical_speed && !std::isfinite(*mode.critical_speed), ""}});
  return table;
}

void add_verdict(Answer& answer, const studies::Squeal& squeal) {
  const std::string stability = squeal.is_stable() ? "stable" : "unstable";
  const Value fastest = growth_of(squeal.fastest);
  answer.add_members({{"fastest", fastest.json},
                      {"diverges", squeal.diverges()},
                      {"resolved_modes", squeal.resolved_modes},
                      {"resolved_hz", squeal.resolved_hz},
                      {"unresolved_mode_grows", squeal.unresolved_mode_grows},
                      {"verdict", stability}});
  answer.text += "\nsteady sliding is " + stability;
  if (squeal.diverges())
    answer.text +=
        fmt::format(": the contact runs away by {} 1/s without vibration (divergence)", fastest.text);
  else if (!squeal.is_stable())
    answer.text += fmt::format(": {:.6g} Hz grows by {} 1/s",
                               squeal.fastest.imag() / (2.0 * std::numbers::pi), fastest.text);
  answer.add_line(fmt::format("\njudged: the {} modes up to {:.3g} Hz, which the mesh has to 1 %{}",
                              squeal.resolved_modes, squeal.resolved_hz,
                              squeal.unresolved_mode_grows
                                  ? "; above it modes of the mesh grow, which are not those of the beam"
                                  : ""));
}

Answer squeal_answer(const studies::Squeal& squeal, const studies::Cycle& cycle) {
  Answer answer(34);
  const Value mesh = rounded(squeal.finite_element_displacement, 7),
              tip = rounded(squeal.tip_displacement, 7);
  answer.add_members({{"speed_m_per_s", squeal.speed}});
  answer.add_line(fmt::format("wall at {} m/s\n", data::shortest_text(squeal.speed)));
  answer.add_row("steady sliding", {"closed form", "finite elements"});
  answer.add_row(
      {"friction force on structure / N", "friction_force_on_beam_N", rounded(squeal.friction_force, 7)});
  answer.add_row("deflection of the contact / m", {tip.text, mesh.text});
  answer.add_members({{"tip_displacement_m", tip.json}, {"finite_element_tip_displacement_m", mesh.json}});
  answer.add_row({"falling slope / (N s/m)", "falling_slope_Ns_per_m", rounded(squeal.slope, 7)});
  answer.add_line();
  answer.add_table("modes", modes_table(squeal.modes));

  add_verdict(answer, squeal);
  answer.text += "from rest on the wall: ";
  add_cycle(answer, cycle, "cycle");
  return answer;
}

// Damping other than Kelvin-Voigt's is that of the modes of the case, which with the deflection of the tip have one root more.
void require_modes(const data::Case& problem, int modes) {
  const int most = problem.numerics.modes() + 1;
  if (!problem.damping.is_kelvin_voigt() && modes > most)
    throw data::FieldError(
        "--modes", modes,
        fmt::format("at most {} with damping other than kelvin_voigt: one more than numerics.modes", most));
}

std::string map_text(const data::Case& problem, const std::vector<double>& speeds,
                     const std::vector<double>& ratios, report::Progress& progress) {
  progress.stage("making the map");
  report::CsvTable table("Fastest growth of a disturbance of steady sliding, " + problem.name,
                         "speed [m/s], damping_ratio [1], growth [1/s], state [-]");
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const std::vector<double> growths = studies::sliding_growths(problem, speeds, ratios[i]);
    for (std::size_t j = 0; j < speeds.size(); ++j) {
      table.add(speeds[j]).add(ratios[i]).add(growths[j]);
      table.add(growths[j] > 0.0 ? "unstable" : "stable").end_row();
    }
    table.end_grid_line();
    progress(static_cast<double>(i + 1) / static_cast<double>(ratios.size()));
  }
  return table.text();
}

Answer steady_sliding(const SquealOptions& options, Outputs& outputs) {
  if (options.map.empty() && !options.figure.empty())
    throw data::InputError("--figure draws the map, but --map FILE is missing");
  const data::Case problem = load_case(options.problem);
  require_modes(problem, options.modes);
  const studies::Squeal squeal = studies::squeal_of(problem, options.modes);
  std::vector<double> speeds, ratios;
  if (!options.map.empty()) {
    speeds = parse_values("--speeds", "wall.speed", options.speeds, options.count);
    ratios = parse_values("--ratios", "damping.ratio", options.ratios, options.count);
    (void)with_value(problem, "damping.ratio", ratios.back());
  }
  outputs.set_case(problem);
  outputs.open({{"--map", options.map}, {"--figure", options.figure}});
  report::Progress& progress = outputs.progress();
  progress.stage("following the motion from rest");
  Answer answer = squeal_answer(squeal, studies::limit_cycle_of(problem, options.settle));
  answer.warnings = sentences_of(studies::history_warnings(problem, studies::event_driven()));
  add_warning(answer, studies::deflection_warning(problem, squeal.tip_displacement));
  require_finite(answer.json);
  const std::string map = options.map.empty() ? "" : map_text(problem, speeds, ratios, progress);
  outputs.write_table("--map", [&] { return map; });
  outputs.draw(problem.name, [&](const report::Look& look) {
    return report::drawing_of("squeal", look, {{"squeal.csv", map}});
  });
  return answer;
}

void add_options(CLI::App& command, SquealOptions& options) {
  add_case_options(command, options.problem);
  add_key_option(command, options.problem, "--speed", "wall.speed",
                 "Speed of the wall, m/s (else that of the case)");
  add_integer_option(command, "--modes", options.modes, 1, 50, "Number of modes to print");
  add_integer_option(command, "--settle", options.settle, 1, 100'000,
                     "Periods of the first mode before the limit cycle is looked for");
  auto* map = add_file_option(command, "--map", options.map,
                              "CSV file for the growth over speeds and damping ratios");
  auto* speeds =
      command.add_option("--speeds", options.speeds, "Speeds of the map, m/s")->type_name("FROM:TO");
  auto* ratios =
      command.add_option("--ratios", options.ratios, "Damping ratios of the map")->type_name("FROM:TO");
  map->needs(speeds);
  speeds->needs(ratios);
  ratios->needs(map);
  add_integer_option(command, "--count", options.count, 2, 500, "Values along each axis of the map")
      ->needs(map);
  add_figure_option(command, options.figure, "Figure of the map");
}

}  // namespace

void add_squeal_command(CLI::App& app) {
  add<SquealOptions>(
      app,
      {.name = "squeal",
       .help = "Steady sliding on a wall that moves: deflection, growth of each mode, critical speed, limit "
               "cycle",
       .examples = {"stickslip squeal reed --speed 0.5",
                    "stickslip squeal reed --map squeal.csv --speeds 0.05:1 --ratios 0.001:0.05 --figure "
                    "squeal.svg"},
       .add_options = add_options,
       .run = steady_sliding});
}

}  // namespace stickslip::cli
