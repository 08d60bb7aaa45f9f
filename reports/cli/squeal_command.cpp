// SPDX-License-Identifier: MIT
#include "studies/stick_slip/squeal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "case_options.hpp"
#include "commands.hpp"
#include "figure_format.hpp"
#include "output_file.hpp"
#include "periodic_output.hpp"
#include "range_text.hpp"
#include "render/csv_table.hpp"
#include "render/drawing.hpp"
#include "render/interruption.hpp"

namespace stickslip::cli {

namespace {

struct SquealOptions {
  CaseOptions problem;
  std::optional<double> speed;
  int modes = 5;
  int settle = 200;
  std::string map, speeds, ratios, figure;
  int count = 41;
};

data::Case case_of(const SquealOptions& options) {
  auto overrides = overrides_of(options.problem);
  if (options.speed) overrides.push_back(override_with("wall.speed", *options.speed, "--speed"));
  return data::load_case(options.problem.name, overrides);
}

std::string seven_digits(double value) { return fmt::format("{:.7g}", value); }

std::string text_of(const std::optional<double>& value) {
  if (!value) return "none";
  return std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "every speed";
}

std::string growth_text(const std::optional<std::complex<double>>& root) {
  return root ? fmt::format("{:.6g}", root->real()) : "none";
}

void print_modes(const studies::Squeal& squeal) {
  fmt::print("\n{:<5}{:<13}{:<12}{:<18}{:<18}{:<16}{:<16}{}\n", "mode", "f / Hz", "damping", "growth / (1/s)",
             "growth, mesh", "alone holds", "holds", "unstable below / (m/s)");
  int number = 0;
  for (const auto& mode : squeal.modes)
    fmt::print("{:<5}{:<13.7g}{:<12.4g}{:<18}{:<18}{:<16.6g}{:<16}{}\n", ++number, mode.frequency_hz,
               mode.damping_ratio, growth_text(mode.root), growth_text(mode.finite_element_root),
               mode.one_mode_slope, text_of(mode.critical_slope), text_of(mode.critical_speed));
}

void print_table(const data::Case& problem, const studies::Squeal& squeal, const studies::Cycle& cycle) {
  const auto row = [](std::string_view name, const std::string& left, const std::string& right = "") {
    fmt::print("{:<34}{:<{}}{}\n", name, left, right.empty() ? 0 : 20, right);
  };
  fmt::print("{}: wall at {} m/s\n\n", problem.name, data::shortest_text(squeal.speed));
  row("steady sliding", "closed form", "finite elements");
  row("friction force on beam / N", seven_digits(squeal.friction_force));
  row("deflection of the tip / m", seven_digits(squeal.tip_displacement),
      seven_digits(squeal.finite_element_displacement));
  row("falling slope / (N s/m)", seven_digits(squeal.slope));
  print_modes(squeal);
  fmt::print("\nsteady sliding is {}", squeal.is_stable() ? "stable" : "unstable");
  if (!squeal.is_stable())
    fmt::print(": {:.6g} Hz grows by {:.6g} 1/s", squeal.fastest.imag() / (2.0 * std::numbers::pi),
               squeal.fastest.real());
  fmt::print("\nfrom rest on the wall: ");
  print_cycle(cycle);
}

Json complex_json(const std::optional<std::complex<double>>& root) {
  if (!root) return nullptr;
  return {{"growth_per_s", root->real()}, {"frequency_hz", root->imag() / (2.0 * std::numbers::pi)}};
}

Json number_json(const std::optional<double>& value) { return value ? finite_json(*value) : Json(); }

Json to_json(const data::Case& problem, const studies::Squeal& squeal, const studies::Cycle& cycle,
             const std::vector<std::string>& warnings) {
  Json modes = Json::array();
  for (const auto& mode : squeal.modes)
    modes.push_back(
        {{"frequency_hz", mode.frequency_hz},
         {"damping_ratio", mode.damping_ratio},
         {"root", complex_json(mode.root)},
         {"finite_element_root", complex_json(mode.finite_element_root)},
         {"slope_held_alone_Ns_per_m", mode.one_mode_slope},
         {"slope_held_Ns_per_m", number_json(mode.critical_slope)},
         {"critical_speed_m_per_s", number_json(mode.critical_speed)},
         {"unstable_at_every_speed", mode.critical_speed && !std::isfinite(*mode.critical_speed)}});
  return {{"case", problem.name},
          {"speed_m_per_s", squeal.speed},
          {"friction_force_on_beam_N", squeal.friction_force},
          {"tip_displacement_m", squeal.tip_displacement},
          {"finite_element_tip_displacement_m", squeal.finite_element_displacement},
          {"falling_slope_Ns_per_m", squeal.slope},
          {"modes", modes},
          {"fastest", complex_json(squeal.fastest)},
          {"verdict", squeal.is_stable() ? "stable" : "unstable"},
          {"cycle", cycle_json(cycle)},
          {"numerics", numerics_json(problem)},
          {"warnings", warnings}};
}

std::vector<double> values_of(const std::string& option, const std::string& text, int count) {
  const studies::ParameterRange range = parse_range(option, text);
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(std::lerp(range.from, range.to, static_cast<double>(i) / (count - 1)));
  return values;
}

void require_consistent(const SquealOptions& options) {
  if (options.map.empty() && !options.figure.empty())
    throw data::InputError("--figure draws the map, but --map FILE is missing");
  require_json_alone(options.problem.json, "--map", options.map);
  require_different_files({{"--map", options.map}, {"--figure", options.figure}});
}

// A damping ratio is that of the modes of the case, which with the deflection of the tip have one root more.
void require_modes(const data::Case& problem, int modes) {
  const int most = problem.numerics.modes() + 1;
  if (problem.damping.ratio() > 0.0 && modes > most)
    throw data::FieldError(
        "--modes", modes, fmt::format("at most {} with a damping.ratio: one more than numerics.modes", most));
}

// The map that is asked for, if any: checked, and its files opened, before the work begins.
struct Map {
  std::vector<double> speeds, ratios;
  std::optional<OutputFile> table, figure;

  Map(const data::Case& problem, const SquealOptions& options) {
    if (options.map.empty()) return;
    speeds = values_of("--speeds", options.speeds, options.count);
    ratios = values_of("--ratios", options.ratios, options.count);
    for (const double end : {speeds.front(), speeds.back()})
      data::require_magnitude("wall.speed", end, "--speeds");
    (void)data::Damping({.kelvin_voigt = problem.damping.kelvin_voigt(), .ratio = ratios.back()});
    table.emplace(options.map);
    open_figure(figure, options.figure);
  }

  void discard() const noexcept {
    if (table) table->discard();
    if (figure) figure->discard();
  }
};

std::string map_table(const std::vector<studies::SquealGrowth>& map, const data::Case& problem,
                      std::size_t speeds) {
  report::CsvTable table("Fastest growth of a disturbance of steady sliding, " + problem.name,
                         {{"speed", "m/s"}, {"damping_ratio", "1"}, {"growth", "1/s"}, {"state", "-"}});
  std::size_t row = 0;
  for (const auto& [speed, ratio, growth] : map) {
    table.add(speed)
        .add(ratio)
        .add(growth)
        .add(report::CsvText(growth > 0.0 ? "unstable" : "stable"))
        .end_row();
    if (++row % speeds == 0) table.end_grid_line();
  }
  return table.text();
}

void write_map(const data::Case& problem, const SquealOptions& options, Map& map) {
  if (!map.table) return;
  const std::string text =
      map_table(studies::squeal_map(problem, map.speeds, map.ratios), problem, map.speeds.size());
  map.table->write(text);
  if (map.figure)
    map.figure->write(report::drawing_of("squeal", figure_format(options.figure), {{"squeal.csv", text}}));
  map.table->commit();
  if (map.figure) map.figure->commit();
}

void run(const SquealOptions& options) {
  require_consistent(options);
  const data::Case problem = case_of(options);
  data::require_rigid(problem.contact, "squeal; respond takes it");
  require_modes(problem, options.modes);
  const auto inquiry = studies::Inquiry::event_driven_history;
  const studies::Squeal squeal = studies::squeal_of(problem, options.modes);
  Map map(problem, options);
  const report::Interruption interruption([&] {
    map.discard();
    return "interrupted before there was a result";
  });
  data::Case still = problem;
  still.excitation =
      data::HarmonicExcitation({.frequency_hz = problem.excitation.frequency_hz(), .amplitude = 0.0});
  const studies::Cycle cycle = studies::cycle_of(still, 1, options.settle);
  write_map(problem, options, map);
  const auto warnings = warnings_of(problem, inquiry);
  const Json answer = to_json(problem, squeal, cycle, warnings);
  require_finite(answer);
  print_warnings(warnings);
  if (options.problem.json) return print_json(answer);
  if (options.map == "-") return;
  print_table(problem, squeal, cycle);
}

}  // namespace

void add_squeal_command(CLI::App& app) {
  auto* command = app.add_subcommand(
      "squeal",
      "Steady sliding on a wall that moves: deflection, growth of each mode, critical speed, limit cycle");
  auto options = std::make_shared<SquealOptions>();
  options->problem.name = "reed";
  add_case_options(*command, options->problem);
  command->add_option("--speed", options->speed, "Speed of the wall, m/s (else that of the case)")
      ->check(number());
  command->add_option("--modes", options->modes, "Number of modes to print")
      ->check(integer_between(1, 50))
      ->capture_default_str();
  command
      ->add_option("--settle", options->settle,
                   "Periods of the first mode before the limit cycle is looked for")
      ->check(integer_between(1, 100'000))
      ->capture_default_str();
  auto* map =
      command->add_option("--map", options->map, "CSV file for the growth over speeds and damping ratios")
          ->check(file_name());
  auto* speeds =
      command->add_option("--speeds", options->speeds, "Speeds of the map, m/s")->type_name("FROM:TO");
  auto* ratios =
      command->add_option("--ratios", options->ratios, "Damping ratios of the map")->type_name("FROM:TO");
  map->needs(speeds)->needs(ratios);
  speeds->needs(map);
  ratios->needs(map);
  command->add_option("--count", options->count, "Values along each axis of the map")
      ->check(integer_between(2, 500))
      ->needs(map)
      ->capture_default_str();
  command
      ->add_option("--figure", options->figure,
                   "Figure of the map, a .png, .pdf or .svg file (needs gnuplot)")
      ->check(file_name());
  add_examples(*command,
               {"stickslip squeal reed --speed 0.5",
                "stickslip squeal reed --map squeal.csv --speeds 0.05:1 --ratios 0.001:0.05 --figure "
                "squeal.svg"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
