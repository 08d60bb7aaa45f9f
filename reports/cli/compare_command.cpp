// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "comparison/diagnosis/diagnosis.hpp"
#include "comparison_output.hpp"
#include "exit_status.hpp"
#include "render/comparison_figure.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

struct CompareOptions {
  std::string name, file, events;
  std::string package = data::reference_directory().string();
  std::vector<std::string> columns, tolerances;
  std::optional<double> until;
  std::string json, junit, figure;
  bool quiet{};
};

// "QUANTITY=VALUE", or "VALUE" for all.
std::pair<std::string, double> parse_tolerance(const std::string& text) {
  const auto equals = text.find('=');
  const std::string number = equals == std::string::npos ? text : text.substr(equals + 1);
  const auto value = parse<double>(number);
  if (!value || equals == 0)
    throw data::FieldError("--tolerance", fmt::format("'{}'", data::printable(text)),
                           "a number or QUANTITY=NUMBER, as in frequency=1e-3");
  return {equals == std::string::npos ? "" : text.substr(0, equals), *value};
}

std::vector<data::ColumnMapping> mappings_of(const CompareOptions& options) {
  std::vector<data::ColumnMapping> mappings;
  for (const std::string& text : options.columns) mappings.push_back(data::ColumnMapping::parse(text));
  return mappings;
}

// The mappings of columns that the data set has.
std::vector<data::ColumnMapping> mappings_for(const data::ReferenceTable& reference,
                                              const std::vector<data::ColumnMapping>& all) {
  std::vector<data::ColumnMapping> mappings;
  for (const data::ColumnMapping& mapping : all)
    if (reference.resource.field(mapping.reference) != nullptr) mappings.push_back(mapping);
  return mappings;
}

comparison::Comparison compare(const CompareOptions& options, report::Progress& progress) {
  const data::ReferencePackage package = data::load_reference(options.package);
  const comparison::Reference reference = comparison::read_reference(package, options.name);
  comparison::Settings settings{.tolerances = {}, .until = options.until, .events = {}};
  for (const std::string& text : options.tolerances) {
    const auto [quantity, value] = parse_tolerance(text);
    settings.tolerances[quantity] = value;
  }

  const auto mappings = mappings_of(options);
  std::vector<const data::ReferenceTable*> references{&reference.table};
  if (!options.events.empty()) {
    if (!reference.events)
      throw data::InputError(
          fmt::format("--events is given, but {} is no history with events of its own", options.name));
    references.push_back(&*reference.events);
  }
  data::require_known_columns(mappings, references);
  if (!options.events.empty())
    settings.events =
        data::read_user_table(options.events, *reference.events, mappings_for(*reference.events, mappings));
  const data::UserTable theirs =
      data::read_user_table(options.file, reference.table, mappings_for(reference.table, mappings));
  comparison::Comparison result = comparison::compare(reference, theirs, settings);
  result.diagnoses =
      comparison::diagnose(result, package, reference.table, theirs, [&](double share) { progress(share); });
  return result;
}

Answer compared(const CompareOptions& options, Outputs& outputs) {
  if (options.json == "-" && options.junit == "-")
    throw data::InputError(
        "--json - and --junit - both want standard output, but one of them must be a file");
  if (options.file == "-" && options.events == "-")
    throw data::InputError("FILE and --events both are standard input, but one of them must be a file");
  const bool has_table = !options.quiet && options.json != "-" && options.junit != "-";
  outputs.open({{"the table", has_table ? "-" : ""},
                {"--json", options.json},
                {"--junit", options.junit},
                {"--figure", options.figure}});
  const comparison::Comparison result = compare(options, outputs.progress(": known mistakes"));
  outputs.write("the table", [&] { return text_of(result); });
  outputs.write("--json", [&] { return json_of(result, options.file).dump(2) + "\n"; });
  outputs.write("--junit", [&] { return junit_of(result, options.file); });
  outputs.draw(options.name, [&](const report::Look& look) { return report::draw(result, look); });
  Answer answer;
  if (result.agreement == comparison::Agreement::differs) answer.status = failed;
  return answer;
}

void add_options(CLI::App& command, CompareOptions& options) {
  command.add_option("NAME", options.name, "A data set that 'stickslip reference list' lists")->required();
  command
      .add_option("FILE", options.file,
                  "CSV file with the columns of the data set, '-' for standard input; a unit may follow a "
                  "name, as in 'frequency [kHz]'")
      ->check(file_name())
      ->required();
  command
      .add_option("--events", options.events,
                  "CSV file with the changes of contact of the same run, for a history with stick and slip")
      ->check(file_name());
  command
      .add_option("--column", options.columns,
                  "Which column of yours is which, and in which unit, as in frequency=f1:kHz; repeatable")
      ->type_name("REFERENCE=YOURS[:UNIT]")
      ->allow_extra_args(false);
  command
      .add_option("--tolerance", options.tolerances,
                  "Instead of that of the data set, of one quantity or of all; repeatable")
      ->type_name("[QUANTITY=]NUMBER")
      ->allow_extra_args(false);
  command.add_option("--until", options.until, "Compare nothing later, s; a run of yours must reach it")
      ->check(time());
  command.add_option("--json", options.json, "JSON file with all numbers, '-' for standard output")
      ->check(file_name());
  command.add_option("--junit", options.junit, "XML file in JUnit's format, '-' for standard output")
      ->check(file_name());
  add_figure_option(command, options.figure);
  add_package_option(command, options.package);
  command.add_flag("--quiet", options.quiet, "Print nothing");
}

}  // namespace

void add_compare_command(CLI::App& app) {
  add<CompareOptions>(
      app, {.name = "compare",
            .help = "Results of your own against the reference data. Exit status 0: they agree, or nothing "
                    "differs; 1: they differ; 2: they cannot be compared",
            .examples = {"stickslip reference export stick-frequencies --output mine.csv",
                         "stickslip compare stick-frequencies mine.csv --tolerance 1e-6"},
            .add_options = add_options,
            .run = compared});
}

}  // namespace stickslip::cli
