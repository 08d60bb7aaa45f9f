// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "comparison/diagnosis/diagnosis.hpp"
#include "comparison_json.hpp"
#include "comparison_output.hpp"
#include "program.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "stickslip/data/input_text.hpp"
#include "validation_output.hpp"

namespace stickslip::cli {

namespace {

struct CompareOptions {
  std::string name, file, events, rows, names, manifest, junit, figure, level;
  std::string row_tolerances;  // of a row of a manifest, with blanks between
  std::string package = data::reference_directory().string();
  std::vector<std::string> columns, tolerances;
  std::optional<double> until;
  OwnComparison own;
};

bool is_own_run(const CompareOptions& options) { return options.name.ends_with(".csv"); }

// The comparisons that are asked for: one, or those of the lines of the manifest, whose files are next to it.
std::vector<CompareOptions> runs_of(const CompareOptions& options) {
  if (options.manifest.empty()) return {options};
  const std::map<std::string, std::string CompareOptions::*> columns{
      {"data_set", &CompareOptions::name},
      {"file", &CompareOptions::file},
      {"events", &CompareOptions::events},
      {"rows", &CompareOptions::rows},
      {"tolerance", &CompareOptions::row_tolerances},
      {"level", &CompareOptions::level}};
  std::vector<CompareOptions> runs;
  for (const auto& row : read_rows(options.manifest, "the manifest")) {
    CompareOptions& run = runs.emplace_back(options);
    for (const auto& [column, cell, place] : row) {
      if (!columns.contains(column) || std::ranges::count(row, column, &data::Override::key) > 1)
        throw data::FieldError("a column of the manifest", data::printable(column),
                               "one of data_set, file, events, rows, tolerance, level, and stand once");
      const bool is_file = column == "file" || column == "events" || cell.ends_with(".csv");
      if (is_file && !data::is_inside(cell))
        throw data::FieldError(place, data::printable(cell), "a path inside the folder of the manifest");
      const auto folder = std::filesystem::path(options.manifest).parent_path();
      if (!cell.empty()) run.*columns.at(column) = is_file ? (folder / cell).string() : cell;
    }
    if (run.name.empty() || run.file.empty())
      throw data::InputError(row.front().place + ": data_set or file is empty, but must be a name");
  }
  return runs;
}

// The tolerances of the options, and in place of them those of the row.
std::vector<std::string> tolerances_of(const CompareOptions& options) {
  std::vector<std::string> texts = options.tolerances;
  for (const std::string_view text : split(options.row_tolerances, ' '))
    if (!text.empty()) texts.emplace_back(text);
  return texts;
}

std::size_t parse_level(const std::string& text) {
  const auto* const found =
      std::find(comparison::level_names.begin() + 1, comparison::level_names.end(), text);
  if (found == comparison::level_names.end())
    throw data::FieldError("--level", fmt::format("'{}'", data::printable(text)),
                           fmt::format("one of {}", fmt::join(comparison::level_names.begin() + 1,
                                                              comparison::level_names.end(), ", ")));
  return static_cast<std::size_t>(found - comparison::level_names.begin());
}

// Adds the comparison that is asked for, and what is said of it.
void compare(Judged& judged, const CompareOptions& options, const data::ReferencePackage& package,
             const std::function<void(double)>& progress) {
  const bool is_quoted = options.manifest.empty();
  const comparison::Reference reference = is_own_run(options)
                                              ? comparison::own_run(options.name, is_quoted)
                                              : comparison::read_reference(package, options.name);
  comparison::Settings settings{.tolerances = parse_tolerances(tolerances_of(options)),
                                .until = options.until};
  if (!options.level.empty()) settings.level = parse_level(options.level);
  if (!options.rows.empty()) settings.rows = parse_rows(options.rows);
  std::vector<data::ColumnMapping> mappings;
  for (const std::string& text : options.columns) mappings.push_back(data::ColumnMapping::parse(text));
  std::vector<const data::ReferenceTable*> references{&reference.table};
  if (!options.events.empty()) {
    if (!reference.events)
      throw data::InputError(
          fmt::format("--events is given, but {} is no history with events of its own", options.name));
    references.push_back(&*reference.events);
  }
  data::require_known_columns(mappings, references);
  if (!options.events.empty())
    settings.events = data::read_user_table(options.events, *reference.events, mappings, {}, is_quoted);
  std::vector<std::string> names;
  for (const std::string_view name : split(options.names, ','))
    if (!options.names.empty()) names.emplace_back(name);
  const auto theirs = data::read_user_table(options.file, reference.table, mappings, names, is_quoted);
  auto comparison = comparison::compare(reference, theirs, settings);
  if (!is_own_run(options))
    judged.diagnoses = comparison::diagnose(comparison, package, reference.table, theirs, progress);
  judged.comparison = std::move(comparison);
}

ExitStatus exit_status_of(comparison::Agreement agreement) {
  if (agreement == comparison::Agreement::agrees) return done;
  return agreement == comparison::Agreement::differs ? failed : undecided;
}

// Of some files the worst counts: one that cannot be compared, then one that differs.
int severity(ExitStatus status) {
  constexpr std::array ranking{done, undecided, failed, unusable};
  return static_cast<int>(std::ranges::find(ranking, status) - ranking.begin());
}

Answer compared(const CompareOptions& options, Outputs& outputs) {
  if (!options.own.problem.empty()) return compared_with_case(options.name, options.own, outputs);
  if (options.own.json == "-" && options.junit == "-")
    throw data::InputError("--json - and --junit - both want standard output; one must be a file");
  if (options.file == "-" && options.events == "-")
    throw data::InputError("FILE and --events both are standard input, but one of them must be a file");
  if (options.manifest.empty() && (options.name.empty() || options.file.empty()))
    throw CLI::RequiredError(options.name.empty() ? "NAME" : "FILE");
  const bool has_table = !options.own.quiet && options.own.json != "-" && options.junit != "-";
  outputs.open({{"the table", has_table ? "-" : ""},
                {"--json", options.own.json},
                {"--junit", options.junit},
                {"--figure", options.figure}});
  const std::vector<CompareOptions> runs = runs_of(options);
  data::ReferencePackage package;
  if (!std::ranges::all_of(runs, is_own_run)) package = data::load_reference(options.package);
  report::Progress& progress = outputs.progress(": known mistakes");
  ExitStatus worst = done;
  std::vector<Judged> all;
  for (const CompareOptions& run : runs) {
    Judged& one = all.emplace_back(Judged{.name = run.name, .file = run.file});
    const auto before = static_cast<double>(all.size() - 1), total = static_cast<double>(runs.size());
    ExitStatus status = unusable;
    try {
      compare(one, run, package, [&](double share) { progress((before + share) / total); });
      status = exit_status_of(one.comparison->agreement);
    } catch (const data::InputError& error) {
      one.refusal = error.what();
    }
    worst = std::max(worst, status, [](ExitStatus a, ExitStatus b) { return severity(a) < severity(b); });
  }
  outputs.write("--junit", [&] { return junit_of(all); });
  const bool is_one = options.manifest.empty();
  if (is_one && !all.front().comparison) throw data::InputError(all.front().refusal);
  outputs.write("the table", [&] { return data::plain_text(is_one ? text_of(all.front()) : text_of(all)); });
  if (is_one)
    outputs.write_json(json_of(all.front()));
  else
    outputs.write("--json", [&] { return json_text(json_of(all)); });
  outputs.draw(options.name,
               [&](const report::Look& look) { return report::draw(*all.front().comparison, look); });
  Answer answer;
  answer.status = worst;
  return answer;
}

void add_options(CLI::App& command, CompareOptions& options) {
  const auto words = [&](const char* name, auto& value, const char* type, const char* help) {
    return command.add_option(name, value, help)->type_name(type);
  };
  command.add_option("NAME", options.name,
                     "A data set that 'stickslip reference list' lists, or the .csv file of a run of your "
                     "own; with --case the file of a measurement");
  add_file_option(
      command, "FILE", options.file,
      "CSV file with the columns of the data set, '-' for standard input; a unit may follow a name, as in "
      "'frequency [kHz]'");
  auto* problem = add_own_options(command, options.own);
  add_file_option(command, "--events", options.events,
                  "CSV file with the changes of contact of the same run, for a history with stick and slip");
  words("--column", options.columns, "REFERENCE=YOURS[:UNIT]",
        "Which column of yours is which, and in which unit, as in frequency=f1:kHz; repeatable")
      ->allow_extra_args(false);
  words("--columns", options.names, "NAME,NAME,...",
        "The names of the columns of FILE, if it has no line of names; '-' for one that does not count");
  words("--rows", options.rows, "FIRST:LAST,...",
        "The rows of the data set that FILE must have, counted from 1 (default: all), as in 1:12 or 1:3,7");
  words("--tolerance", options.tolerances, "[QUANTITY=]NUMBER",
        "Instead of that of the data set, of one quantity or of all; repeatable")
      ->allow_extra_args(false);
  words("--level", options.level, "LEVEL",
        "Agree as well with a scaled error of at most 1e-1, 1e-2 or 1e-3; strict, the default, has the "
        "tolerances alone")
      ->check(one_of({comparison::level_names.begin() + 1, comparison::level_names.end()}));
  command.add_option("--until", options.until, "Compare nothing later, s; a run of yours must reach it")
      ->transform(time());
  add_file_option(command, "--junit", options.junit, "XML file in JUnit's format, '-' for standard output");
  add_figure_option(command, options.figure);
  add_package_option(command, options.package);
  auto* manifest = add_file_option(
      command, "--manifest", options.manifest,
      "CSV file with the columns data_set and file, and events, rows, tolerance and level if need be: "
      "compares them all");
  manifest->excludes(command.get_option("NAME"));
  for (const char* single : {"FILE", "--events", "--column", "--columns", "--rows", "--until", "--figure"}) {
    manifest->excludes(command.get_option(single));
    problem->excludes(command.get_option(single));
  }
  for (const char* other : {"--tolerance", "--level", "--junit", "--manifest", "--package"})
    problem->excludes(command.get_option(other));
}

}  // namespace

void add_compare_command(CLI::App& app) {
  add<CompareOptions>(
      app,
      {.name = "compare",
       .help =
           "Results of your own against the reference data. Exit status 0: all agrees; 1: something "
           "differs; 2: a file cannot be compared; 3: nothing differs, but something is undecided or missing",
       .examples = {"stickslip reference export stick-frequencies --output mine.csv",
                    "stickslip compare stick-frequencies mine.csv --tolerance 1e-6",
                    "stickslip compare stick-frequencies mine.csv --rows 1:3 --level 1e-2"},
       .add_options = add_options,
       .run = compared});
}

}  // namespace stickslip::cli
