// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "map_work.hpp"
#include "range_text.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

constexpr const char* verdict_name = "verdict";
constexpr double usual_tolerance = 0.05;
constexpr std::size_t most_parts = 1'000'000;

struct MapOptions {
  CaseOptions problem;
  std::string x = "frequency=1:120:240";
  std::string y = "amplitude=5e-5:1e-3:20";
  std::optional<std::string> method;
  bool states_only{};
  std::string quantity = verdict_name;
  std::optional<double> transient;
  std::optional<double> tolerance;
  bool dry_run{};
  studies::MapPart part;
  std::string from, output = "-", figure;
};

// "K/M".
studies::MapPart parse_part(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto part = parse<std::size_t>(std::string_view(text).substr(0, slash));
  const auto parts = parse<std::size_t>(std::string_view(text).substr(std::min(slash + 1, text.size())));
  if (!part || !parts || *part < 1 || *part > *parts || *parts > most_parts)
    throw data::FieldError("--shard", fmt::format("'{}'", data::printable(text)),
                           fmt::format("K/M with integers 1 <= K <= M <= {}", most_parts));
  return {*part, *parts};
}

// NAME or NAME,NAME...; none for the verdict.
std::vector<const studies::MotionQuantity*> quantities_of(const std::string& text) {
  if (text == verdict_name) return {};
  std::vector<std::string> known{verdict_name};
  for (const auto& quantity : studies::motion_quantities) known.emplace_back(quantity.name);
  const auto names = split(text, ',');
  for (const std::string_view name : names)
    if (name == verdict_name || std::ranges::find(known, name) == known.end())
      throw data::FieldError(
          "--quantity", fmt::format("'{}'", data::printable(name)),
          fmt::format("one of {}, or some of those after the first with commas between them{}",
                      data::joined(known), data::suggestion(name, known)));
  std::vector<const studies::MotionQuantity*> quantities;
  for (const std::string_view name : names)
    if (const auto* named = &studies::motion_quantity(name); std::ranges::count(quantities, named) == 0)
      quantities.push_back(named);
  return quantities;
}

// What a map of quantities rules out, or what it needs.
void require_consistent(const MapOptions& options, bool has_quantities) {
  if (has_quantities && options.states_only)
    throw data::InputError("--states-only is an option of the verdict, but --quantity is " +
                           options.quantity);
  if (has_quantities && options.method)
    throw data::InputError("--method is an option of the verdict, but --quantity is " + options.quantity);
  if (!has_quantities && (options.transient || options.tolerance))
    throw data::InputError(fmt::format("{} needs a --quantity of the motion, but it is verdict",
                                       options.transient ? "--transient" : "--tolerance"));
  if (options.tolerance && !(*options.tolerance > 0.0 && *options.tolerance < 1.0))
    throw data::FieldError("--tolerance", *options.tolerance, "above 0 and below 1");
}

studies::MapTask map_task(const MapOptions& options) {
  const auto quantities = quantities_of(options.quantity);
  require_consistent(options, !quantities.empty());
  studies::MapTask task{.problem = load_case(options.problem),
                        .x = parse_axis("--x", options.x),
                        .y = parse_axis("--y", options.y),
                        .method = &studies::method(options.method.value_or(studies::closed_form().name)),
                        .states_only = options.states_only,
                        .quantities = quantities,
                        .tolerance = options.tolerance.value_or(usual_tolerance),
                        .part = options.part};
  for (const auto& [axis, option] : {std::pair(&task.x, "--x"), std::pair(&task.y, "--y")}) {
    require_no_fixed_value(options.problem, axis->parameter, option);
    if (axis->parameter == "excitation.frequency_hz")
      task.problem.numerics = numerics_up_to(axis->values.back(), task.problem);
  }
  task.transient = options.transient.value_or(0.5 * task.problem.numerics.duration());
  studies::require_resting_wall(task.problem);
  return task;
}

// --from takes from the file what the other options say.
void add_part_options(CLI::App& command, MapOptions& options) {
  CLI::Option* const figure = command.get_option("--figure");
  auto* const shard =
      command
          .add_option_function<std::string>(
              "--shard", [&options](const std::string& text) { options.part = parse_part(text); },
              "Make only part K of M of the cells; the outputs of all parts, one after another, are the map")
          ->type_name("K/M")
          ->excludes(figure);
  auto* const from = command
                         .add_option("--from", options.from,
                                     "Make no map, but draw the one that this file holds: an output, or "
                                     "those of all shards joined")
                         ->check(file_name())
                         ->type_name("FILE")
                         ->needs(figure)
                         ->excludes(shard);
  for (const char* const of_a_new_map :
       {"CASE", "--set", "--hz", "--amplitude", "--x", "--y", "--method", "--duration", "--states-only",
        "--quantity", "--transient", "--tolerance", "--dry-run", "--output"})
    from->excludes(command.get_option(of_a_new_map));
}

void add_motion_options(CLI::App& command, MapOptions& options) {
  std::string quantities;
  for (const auto& quantity : studies::motion_quantities)
    quantities += fmt::format("{} ({}), ", quantity.name, quantity.label);
  command
      .add_option("--quantity", options.quantity,
                  "What to map: the verdict of the criterion, or of the motion " + quantities +
                      "where a period is that of a base that moves by one sine; some with commas between "
                      "them give a column each")
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option(
          "--transient", options.transient,
          "What a quantity of the motion leaves out from the start, s (default: half of the duration)")
      ->transform(time());
  command
      .add_option(
          "--tolerance", options.tolerance,
          "Largest relative change of a quantity, with twice the time step and between the halves of the "
          "record, with which it counts as converged (default: 0.05)")
      ->transform(number());
}

void add_output_options(CLI::App& command, MapOptions& options) {
  command.add_flag("--dry-run", options.dry_run,
                   "Write no map, but time some evaluations and print what the map will take");
  add_file_option(command, "--output", options.output, "CSV file, '-' for standard output");
  add_figure_option(command, options.figure);
}

void add_options(CLI::App& command, MapOptions& options) {
  add_case_options(command, options.problem);
  add_excitation_options(command, options.problem);
  const std::string axis =
      "PARAMETER=FROM:TO:COUNT, in equal steps, or PARAMETER=FROM:TO:COUNT:log, in equal ratios; PARAMETER "
      "is one of " +
      axis_help();
  command.add_option("--x", options.x, axis)->type_name("AXIS")->capture_default_str();
  command.add_option("--y", options.y, "As --x, another parameter")->type_name("AXIS")->capture_default_str();
  command
      .add_option("--method", options.method,
                  "Closed form, or one linear finite-element run with the tip held for each evaluation "
                  "(default: closed-form)")
      ->check(one_of({studies::closed_form().name, studies::finite_elements().name}));
  add_duration_option(command, options.problem);
  command.add_flag("--states-only", options.states_only,
                   "Leave out the force ratio: only whether each cell sticks or slips");
  add_motion_options(command, options);
  add_output_options(command, options);
  add_threads_option(command);
  add_part_options(command, options);
}

Answer run(const MapOptions& options, Outputs& outputs) {
  if (!options.from.empty()) return drawn_map(options.from, options.figure, outputs);
  const studies::MapTask task = map_task(options);
  if (options.dry_run) return cost_of_map(task, outputs);
  outputs.open({{"--output", options.output}, {"--figure", options.figure}});
  return made_map(task, outputs);
}

}  // namespace

void add_map_command(CLI::App& app) {
  add<MapOptions>(app,
                  {.name = "map",
                   .help = "The criterion or the motion over two parameters, as CSV and as a figure",
                   .examples = {"stickslip map paper --x frequency=10:40:31 --y amplitude=1e-4:1e-3:10:log "
                                "--output map.csv --figure map.svg",
                                "stickslip map damped --set numerics.time_step=1e-4 --duration 2 --x "
                                "frequency=20:30:6 --y damping=0.002:0.02:3 --quantity work,period --output "
                                "motion.csv"},
                   .add_options = add_options,
                   .run = run});
}

}  // namespace stickslip::cli
