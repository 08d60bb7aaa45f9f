#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "case_options.hpp"
#include "commands.hpp"
#include "figure_format.hpp"
#include "interruption.hpp"
#include "output_file.hpp"
#include "range_text.hpp"
#include "stickslip/report/criterion_map.hpp"
#include "stickslip/report/progress_in_tenths.hpp"
#include "stickslip/report/report.hpp"

namespace stickslip::cli {

namespace {

struct MapOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::string x = "frequency=1:120:240";
  std::string y = "amplitude=5e-5:1e-3:20";
  std::string method = "closed-form";
  std::optional<double> duration;
  std::string output = "-";
  std::string figure;
};

void write(OutputFile& file, std::string_view text) {
  file.write(text);
  file.commit();
}

// The table is in place by then.
void write_figure(const studies::CriterionMap& map, const report::CsvTable& table, const MapOptions& options,
                  OutputFile& file) {
  try {
    write(file, report::draw(table, map, figure_format(options.figure)));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}; the map itself is in {}", error.what(),
                                         options.output == "-" ? "standard output" : options.output));
  }
}

constexpr std::array states{studies::CellState::stick, studies::CellState::stick_slip,
                            studies::CellState::no_stick_state};

auto cells_in(const studies::CriterionMap& map, studies::CellState state) {
  return std::ranges::count(map.cells, state, &studies::CriterionMap::Cell::state);
}

void print_summary(const studies::CriterionMap& map, const MapOptions& options) {
  std::string counts;
  for (const auto state : states)
    counts +=
        fmt::format("{}{} {}", counts.empty() ? "" : ", ", cells_in(map, state), report::to_string(state));
  fmt::print("{} cells written to {}: {}\n", map.cells.size(), options.output, counts);
  if (!options.figure.empty()) fmt::print("Drawn in {}\n", options.figure);
}

Json to_json(const data::Case& problem, const studies::CriterionMap& map, const MapOptions& options) {
  Json object{{"case", problem.name},     {"method", options.method}, {"x", options.x},
              {"y", options.y},           {"output", options.output}, {"figure", nullptr},
              {"cells", map.cells.size()}};
  if (!options.figure.empty()) object["figure"] = options.figure;
  for (const auto state : states) object["states"][report::to_string(state)] = cells_in(map, state);
  return object;
}

void run(const MapOptions& options) {
  const bool to_standard_output = options.output == "-";
  if (options.problem.json && to_standard_output)
    throw data::InputError("--json and --output - both want standard output, but --json needs --output FILE");
  const studies::MapAxis x = parse_axis("--x", options.x), y = parse_axis("--y", options.y);
  const data::Case problem = load_case(options.problem, options.excitation, options.duration);
  const bool closed_form = options.method == "closed-form";
  if (closed_form) require_undamped(problem, "the map in closed form (--method fe follows the damping)");

  const Interruption interruption;
  OutputFile output(options.output);
  std::optional<OutputFile> figure;
  if (!options.figure.empty()) {
    (void)figure_format(options.figure);
    (void)report::templates_directory();  // refused now rather than after the map
    figure.emplace(options.figure);
  }
  const studies::CriterionMap map = studies::criterion_map(
      problem, x, y, closed_form ? studies::MapMethod::closed_form : studies::MapMethod::finite_elements,
      interruption.progress(report::progress_in_tenths("map")));
  const report::CsvTable table = report::table_of(problem, map);
  write(output, table.text());
  if (figure) write_figure(map, table, options, *figure);
  if (options.problem.json)
    print_json(to_json(problem, map, options));
  else if (!to_standard_output)
    print_summary(map, options);
}

}  // namespace

void add_map_command(CLI::App& app) {
  auto* command = app.add_subcommand("map", "The criterion over two parameters, as CSV and as a figure");
  auto options = std::make_shared<MapOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  const std::string axis =
      "PARAMETER=FROM:TO:COUNT, in equal steps, or PARAMETER=FROM:TO:COUNT:log, in equal ratios; PARAMETER "
      "is "
      "frequency (Hz), amplitude (m), length (m), force (P, N), stiffness (Young's modulus, Pa) or friction "
      "(static coefficient)";
  command->add_option("--x", options->x, axis)->type_name("AXIS")->capture_default_str();
  command->add_option("--y", options->y, "As --x, another parameter")
      ->type_name("AXIS")
      ->capture_default_str();
  command
      ->add_option("--method", options->method,
                   "Closed form, or one linear finite-element run with the tip held for each evaluation")
      ->check(CLI::IsMember({"closed-form", "fe"}))
      ->capture_default_str();
  command->add_option("--duration", options->duration, "Duration, s (else that of the case)")
      ->check(number());
  command->add_option("--output", options->output, "CSV file, '-' for standard output")
      ->capture_default_str();
  command->add_option("--figure", options->figure,
                      "Figure to draw, a .png, .pdf or .svg file (needs gnuplot)");
  add_examples(*command, {"stickslip map paper --x frequency=10:40:31 --y amplitude=1e-4:1e-3:10:log "
                          "--output map.csv --figure map.svg"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
