// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "render/drawing.hpp"
#include "studies/analyses/contact_response.hpp"

namespace stickslip::cli {

namespace {

struct SweepOptions {
  CaseOptions problem;
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

report::CsvTable sections_table(const studies::SweepTask& task,
                                const std::vector<studies::SweepPoint>& points) {
  report::CsvTable table("Poincare section of the contact for the case " + task.problem.name,
                         fmt::format("direction [-], {}, tip_displacement_m [m], tip_velocity_m_per_s [m/s], "
                                     "friction_force_N [N], period [1]",
                                     report::column_of(task.parameter)));
  for (const studies::SweepPoint& point : points)
    for (const studies::HistoryRow& at : point.section)
      table.add_row({point.up ? "up" : "down", report::csv_number(point.value),
                     report::csv_number(at.tip_displacement), report::csv_number(at.sliding_velocity + 0.0),
                     report::csv_number(at.friction_force + 0.0), std::to_string(point.period)});
  return table;
}

std::string drawn(const report::CsvTable& table, const studies::SweepTask& task, const report::Look& look) {
  const data::KeyAxis& axis = data::key_named(task.parameter).axis;
  const std::vector<report::FigureData::Value> values{{"label", 0.0, "-", std::string(axis.label)},
                                                      {"label_scale", axis.scale, "1"}};
  return report::drawing_of(
      "sweep", look,
      {{"sweep.csv", table.text()}, {"sweep-values.csv", report::values_table(values).text()}});
}

studies::SweepTask sweep_task(const SweepOptions& options) {
  const studies::MapAxis axis = parse_axis("--parameter", options.parameter);
  require_no_fixed_value(options.problem, axis.parameter, "--parameter");
  data::Case problem = load_case(options.problem);
  if (axis.parameter == "excitation.frequency_hz")
    problem.numerics = numerics_up_to(axis.values.back(), problem);
  studies::require_resting_wall(problem);
  return {.problem = problem,
          .parameter = axis.parameter,
          .values = axis.values,
          .direction = directions.at(options.direction),
          .settle = options.settle,
          .periods = options.periods};
}

Answer sweep_answer(const studies::SweepTask& task, const std::vector<studies::SweepPoint>& points,
                    const SweepOptions& options) {
  Answer answer;
  const bool has_both = task.direction == studies::SweepDirection::both;
  const auto [moving, resting] = has_both ? studies::hysteresis_of(points) : studies::Hysteresis{};
  answer.add_line(fmt::format(
      "{} points written to {}{}{}", points.size(), options.output,
      has_both ? fmt::format("; hysteresis at {} of {} values", moving, task.values.size()) : "",
      resting > 0 ? fmt::format("; at {} the contact sticks at another place on the way back", resting)
                  : ""));
  answer.add_members({{"parameter", axis_text({task.parameter, task.values})},
                      {"direction", options.direction},
                      {"settle_periods", task.settle},
                      {"periods", task.periods},
                      {"output", options.output},
                      {"figure", options.figure.empty() ? Json() : Json(options.figure)}});
  for (const auto& point : points)
    answer.json["points"].push_back(
        {{"direction", point.up ? "up" : "down"}, {"value", point.value}, {"period", point.period}});
  answer.add_members({{"values_with_hysteresis", moving}, {"values_that_stick_elsewhere", resting}});
  answer.warnings = sentences_of(studies::warnings_common_to(task.problem, {task.parameter}));
  double largest = 0.0;
  for (const auto& point : points)
    for (const auto& row : point.section) largest = std::max(largest, std::abs(row.tip_displacement));
  add_warning(answer, studies::deflection_warning(task.problem, largest));
  const data::Case last = data::with_value(task.problem, task.parameter, task.values.back());
  add_warning(answer, studies::fixed_step_warning(
                          last, 1.0 / (last.excitation().frequency_hz() * studies::steps_per_period(last))));
  return answer;
}

Answer sweep(const SweepOptions& options, Outputs& outputs) {
  const studies::SweepTask task = sweep_task(options);
  outputs.set_case(task.problem);
  outputs.open({{"--output", options.output}, {"--figure", options.figure}});
  report::Progress& progress = outputs.progress();
  const auto points = studies::parameter_sweep(task, [&](double share) { progress(share); });
  const report::CsvTable table = sections_table(task, points);
  outputs.write_table("--output", [&] { return table.text(); });
  outputs.draw(task.problem.name, [&](const report::Look& look) { return drawn(table, task, look); });
  return sweep_answer(task, points, options);
}

void add_options(CLI::App& command, SweepOptions& options) {
  add_case_options(command, options.problem);
  add_excitation_options(command, options.problem);
  command
      .add_option("--parameter", options.parameter,
                  "PARAMETER=FROM:TO:COUNT, in equal steps, or with :log in equal ratios, as an axis of map")
      ->type_name("AXIS")
      ->capture_default_str();
  add_choice_option(command, "--direction", options.direction, {"up", "down", "both"},
                    "up, down, or both: up and then down; each value starts from the end of the one before");
  add_integer_option(command, "--settle", options.settle, 0, 1'000'000,
                     "Periods of the base motion that pass at each value before the section");
  add_integer_option(command, "--periods", options.periods, 1, 100'000,
                     "Periods at whose ends the section is taken");
  add_file_option(command, "--output", options.output, "CSV file, '-' for standard output");
  add_figure_option(command, options.figure);
}

}  // namespace

void add_sweep_command(CLI::App& app) {
  add<SweepOptions>(
      app, {.name = "sweep",
            .help = "The motion as one parameter rises and falls: bifurcations and hysteresis",
            .examples =
                {"stickslip sweep damped --set numerics.time_step=1e-4 --hz 35 --parameter "
                 "amplitude=5e-4:1.5e-3:11 --settle 30 --periods 8 --output section.csv --figure sweep.svg"},
            .add_options = add_options,
            .run = sweep});
}

}  // namespace stickslip::cli
