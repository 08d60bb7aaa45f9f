// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "output_file.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "render/drawing.hpp"
#include "render/interruption.hpp"
#include "render/progress.hpp"
#include "studies/stick_slip/parameter_sweep.hpp"

namespace stickslip::cli {

namespace {

struct SweepOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::string parameter = "amplitude=1e-4:1e-3:91";
  std::string direction = "both";
  int settle = 100;
  int periods = 32;
  std::string output = "-";
  std::string figure;
};

const std::map<std::string, studies::SweepDirection> directions{{"up", studies::SweepDirection::up},
                                                                {"down", studies::SweepDirection::down},
                                                                {"both", studies::SweepDirection::both}};

report::CsvTable table_of(const studies::SweepTask& task, const std::vector<studies::SweepPoint>& points) {
  report::CsvTable table("Poincare section of the tip for the case " + task.problem.name,
                         {{"direction", "-"},
                          report::column_of(task.parameter),
                          {"tip_displacement_m", "m"},
                          {"tip_velocity_m_per_s", "m/s"},
                          {"friction_force_N", "N"},
                          {"period", "1"}});
  for (const studies::SweepPoint& point : points)
    for (const studies::HistoryRow& at : point.section) {
      for (const double value : {at.tip_displacement, at.sliding_velocity, at.friction_force})
        if (!std::isfinite(value))
          data::throw_overflow(fmt::format("the motion at {} = {} is not finite", task.parameter,
                                           data::shortest_text(point.value)));
      table.add_row({point.up ? "up" : "down", report::csv_number(point.value),
                     report::csv_number(at.tip_displacement), report::csv_number(at.sliding_velocity + 0.0),
                     report::csv_number(at.friction_force + 0.0), std::to_string(point.period)});
    }
  return table;
}

std::string drawn(const report::CsvTable& table, const studies::SweepTask& task, const std::string& format) {
  const data::KeyAxis& axis = data::key_named(task.parameter).axis;
  const std::vector<report::FigureData::Value> values{{"label", 0.0, "-", std::string(axis.label)},
                                                      {"label_scale", axis.scale, "1"}};
  return report::drawing_of(
      "sweep", format,
      {{"sweep.csv", table.text()}, {"sweep-values.csv", report::values_table(values).text()}});
}

studies::SweepTask task_of(const SweepOptions& options) {
  const studies::MapAxis axis = parse_axis("--parameter", options.parameter);
  require_no_fixed_value(options.excitation, axis.parameter, "--parameter");
  data::Case problem = load_case(options.problem, options.excitation, {});
  if (axis.parameter == "excitation.frequency_hz")
    problem.numerics = numerics_up_to(axis.values.back(), options.problem, options.excitation, {});
  data::require_rigid(problem.contact, "a sweep; respond takes it");
  studies::require_resting_wall(problem);
  return {.problem = problem,
          .parameter = axis.parameter,
          .values = axis.values,
          .direction = directions.at(options.direction),
          .settle = options.settle,
          .periods = options.periods};
}

void run(const SweepOptions& options) {
  const bool to_standard_output = options.output == "-";
  require_json_alone(options.problem.json, "--output", options.output);
  const studies::SweepTask task = task_of(options);
  require_different_files({{"--output", options.output}, {"--figure", options.figure}});
  OutputFile output(options.output);
  std::optional<OutputFile> figure;
  open_figure(figure, options.figure);
  report::Progress progress("stickslip sweep", progress_surroundings());
  const report::Interruption interruption([&] {
    progress.finish();
    output.discard();
    if (figure) figure->discard();
    return std::string("interrupted; nothing is kept");
  });
  const auto points = studies::parameter_sweep(task, [&](double share) { progress(share); });
  progress.finish();
  const report::CsvTable table = table_of(task, points);
  output.write(table.text());
  output.commit();
  if (figure) {
    figure->write(drawn(table, task, figure_format(options.figure)));
    figure->commit();
  }
  const auto warnings = sentences_of(studies::warnings_common_to(task.problem, {task.parameter}));
  print_warnings(warnings);
  const std::size_t hysteresis =
      task.direction == studies::SweepDirection::both ? studies::values_with_hysteresis(points) : 0;
  if (options.problem.json) {
    Json object{{"case", task.problem.name},
                {"parameter", axis_text({task.parameter, task.values})},
                {"direction", options.direction},
                {"settle_periods", task.settle},
                {"periods", task.periods},
                {"output", options.output},
                {"figure", options.figure.empty() ? Json() : Json(options.figure)}};
    for (const auto& point : points)
      object["points"].push_back(
          {{"direction", point.up ? "up" : "down"}, {"value", point.value}, {"period", point.period}});
    object["values_with_hysteresis"] = hysteresis;
    object["warnings"] = warnings;
    print_json(object);
  } else if (!to_standard_output) {
    fmt::print("{} points written to {}", points.size(), options.output);
    if (task.direction == studies::SweepDirection::both)
      fmt::print("; up and down differ at {} of {} values", hysteresis, task.values.size());
    fmt::print("\n");
  }
}

}  // namespace

void add_sweep_command(CLI::App& app) {
  auto* command =
      app.add_subcommand("sweep", "The motion as one parameter rises and falls: bifurcations and hysteresis");
  auto options = std::make_shared<SweepOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  command
      ->add_option("--parameter", options->parameter,
                   "PARAMETER=FROM:TO:COUNT, in equal steps, or with :log in equal ratios, as an axis of map")
      ->type_name("AXIS")
      ->capture_default_str();
  command
      ->add_option("--direction", options->direction,
                   "up, down, or both: up and then down; each value starts from the end of the one before")
      ->check(one_of({"up", "down", "both"}))
      ->capture_default_str();
  command
      ->add_option("--settle", options->settle,
                   "Periods of the base motion that pass at each value before the section")
      ->check(integer_between(0, 1'000'000))
      ->capture_default_str();
  command->add_option("--periods", options->periods, "Periods at whose ends the section is taken")
      ->check(integer_between(1, 100'000))
      ->capture_default_str();
  command->add_option("--output", options->output, "CSV file, '-' for standard output")
      ->check(file_name())
      ->capture_default_str();
  add_figure_option(*command, options->figure);
  add_examples(*command,
               {"stickslip sweep damped --set numerics.time_step=1e-4 --hz 35 --parameter "
                "amplitude=5e-4:1.5e-3:11 --settle 30 --periods 8 --output section.csv --figure sweep.svg"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
