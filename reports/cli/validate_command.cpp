// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string>
#include <vector>

#include "commands.hpp"
#include "program.hpp"
#include "render/studies.hpp"
#include "validation_output.hpp"

namespace stickslip::cli {

namespace {

struct ValidateOptions {
  std::string raw, readings, predictions, output, figure;
};

// The rows of figures.csv.
std::string readings_of(const validation::FigureTable& figures) {
  std::string text = "record,quantity,value,uncertainty,count\n";
  for (const auto& point : validation::set_points())
    for (const auto& [key, figure] : figures)
      if (key.first == point.record)
        text += fmt::format("{},{},{:.6g},{:.2g},{}\n", key.first, key.second, figure.value,
                            figure.uncertainty, figure.count);
  return text;
}

// The rows of predictions.csv, as the code makes them now.
std::string predictions_now() {
  std::string text = "entry,record,quantity,form,value,u_input,u_num\n";
  for (const auto& one : validation::predictions())
    text += fmt::format("{},{},{},{},{:.6g},{:.2g},{:.2g}\n", one.entry, one.record, one.quantity, one.form,
                        one.value, one.input_uncertainty, one.numerical_uncertainty);
  return text;
}

Table bias_table(const std::vector<validation::Bias>& biases) {
  Table table = table_with(
      "experiment quantity model predicted points resolved zero_outside bias_percent spread_percent");
  for (const auto& one : biases)
    table.rows.push_back({word(one.experiment), word(one.quantity), word(one.form),
                          word(one.blind ? "blind" : "after"), count(one.points), count(one.resolved),
                          count(one.beyond), rounded(100.0 * one.mean, 3), rounded(100.0 * one.spread, 3)});
  return table;
}

Answer validated(const ValidateOptions& options, Outputs& outputs) {
  outputs.open({{"--readings", options.readings},
                {"--predictions", options.predictions},
                {"--output", options.output},
                {"--figure", options.figure}});
  const auto figures =
      options.raw.empty() ? validation::measured_figures() : validation::raw_figures(options.raw);
  const auto comparisons = validation::comparisons(figures);
  const auto unrecorded = validation::unrecorded_predictions();
  Answer answer;
  add_comparisons(answer, comparisons);
  answer.add_line("\nBias and spread: mean and standard deviation of E/D over all set points");
  answer.add_table("bias", bias_table(validation::biases(comparisons)));
  const auto absent =
      options.raw.empty() ? std::vector<std::string>{} : validation::experiments_without_records(options.raw);
  for (const std::string& experiment : absent)
    answer.add_line(
        fmt::format("\n{}: no folder of raw records of {} below it; its values are those of figures.csv",
                    options.raw, experiment));
  answer.add_members({{"unrecorded_predictions", unrecorded}, {"experiments_without_records", absent}});
  answer.add_line(unrecorded.empty() ? "\nThe models predict now what is recorded." : "");
  for (const std::string& sentence : unrecorded) answer.add_line(sentence);
  require_finite(answer.json);
  outputs.write("--readings", [&] { return readings_of(figures); });
  outputs.write("--predictions", predictions_now);
  outputs.write_table("--output", [&] { return report::comparison_table(comparisons).text(); });
  outputs.draw("", [&](const report::Look& look) {
    return report::drawing_of("validation", look,
                              {{"validation.csv", report::comparison_table(comparisons).text()}});
  });
  answer.status = unrecorded.empty() ? done : failed;
  return answer;
}

void add_options(CLI::App& command, ValidateOptions& options) {
  auto* raw = command
                  .add_option("--raw", options.raw,
                              "Folder with the raw records: reads the measured values off them again")
                  ->check(folder());
  add_file_option(command, "--readings", options.readings, "CSV file for the values read off the raw records")
      ->needs(raw);
  add_file_option(command, "--predictions", options.predictions, "CSV file for what the models predict now");
  add_file_option(command, "--output", options.output, "CSV file for the comparisons");
  add_json_option(command);
  add_figure_option(command, options.figure, "Figure of the intervals E +- 2 u_val");
}

}  // namespace

void add_validate_command(CLI::App& app) {
  add<ValidateOptions>(
      app,
      {.name = "validate",
       .help =
           "Measurements of others against predictions: the error of the model, E +- 2 u_val. Exit status 1: "
           "a prediction is not the recorded one",
       .examples = {"stickslip validate",
                    "stickslip validate --output validation.csv --figure validation.svg"},
       .add_options = add_options,
       .run = validated});
}

}  // namespace stickslip::cli
