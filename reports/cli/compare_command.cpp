// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "comparison/diagnosis/diagnosis.hpp"
#include "comparison_output.hpp"
#include "exit_status.hpp"
#include "render/comparison_figure.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

struct CompareOptions {
  std::string name, file, events, rows, manifest;
  std::string package = data::reference_directory().string();
  std::vector<std::string> columns, names, tolerances;
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

// "1:12,15"
std::vector<std::pair<std::size_t, std::size_t>> parse_rows(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  for (const std::string& range : CLI::detail::split(text, ',')) {
    const auto colon = std::min(range.find(':'), range.size());
    const auto first = parse<std::size_t>(range.substr(0, colon));
    const auto last = colon < range.size() ? parse<std::size_t>(range.substr(colon + 1)) : first;
    if (!first || !last)
      throw data::FieldError("--rows", fmt::format("'{}'", data::printable(text)),
                             "numbers of rows of the data set, as in 1:12 or 1:3,7");
    ranges.emplace_back(*first, *last);
  }
  return ranges;
}

// The comparisons that are asked for: one, or those of the lines of the manifest, whose files are next to it.
std::vector<CompareOptions> runs_of(const CompareOptions& options) {
  if (options.manifest.empty()) return {options};
  constexpr std::array<std::pair<std::string_view, std::string CompareOptions::*>, 4> columns{
      {{"data_set", &CompareOptions::name},
       {"file", &CompareOptions::file},
       {"events", &CompareOptions::events},
       {"rows", &CompareOptions::rows}}};
  const std::string text = data::read_table_text(options.manifest);
  data::CsvReader csv(options.manifest, text);
  std::vector<std::string CompareOptions::*> members;
  for (const std::string& name : csv.names()) {
    const auto known = std::ranges::find(columns, name, [](const auto& column) { return column.first; });
    if (known == columns.end())
      throw data::FieldError("a column of the manifest", data::printable(name),
                             "one of data_set, file, events, rows");
    members.push_back(known->second);
  }
  std::vector<CompareOptions> runs;
  while (const auto cells = csv.next_row()) {
    CompareOptions& run = runs.emplace_back(options);
    for (std::size_t i = 0; i < members.size(); ++i) run.*members[i] = (*cells)[i];
    if (run.name.empty() || run.file.empty())
      throw data::InputError(csv.place(csv.line()) + ": data_set or file is empty, but must be a name");
    for (std::string* const file : {&run.file, &run.events})
      if (!file->empty()) *file = (std::filesystem::path(options.manifest).parent_path() / *file).string();
  }
  if (runs.empty())
    throw data::InputError(options.manifest + ": the manifest has no rows, but must have at least one");
  return runs;
}

comparison::Comparison compare(const CompareOptions& options, const data::ReferencePackage& package,
                               const std::function<void(double)>& progress) {
  const comparison::Reference reference = comparison::read_reference(package, options.name);
  comparison::Settings settings{.tolerances = {}, .until = options.until};
  if (!options.rows.empty()) settings.rows = parse_rows(options.rows);
  for (const std::string& text : options.tolerances) {
    const auto [quantity, value] = parse_tolerance(text);
    settings.tolerances[quantity] = value;
  }

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
    settings.events = data::read_user_table(options.events, *reference.events, mappings);
  const data::UserTable theirs =
      data::read_user_table(options.file, reference.table, mappings, options.names);
  comparison::Comparison result = comparison::compare(reference, theirs, settings);
  result.diagnoses = comparison::diagnose(result, package, reference.table, theirs, progress);
  return result;
}

Answer compared(const CompareOptions& options, Outputs& outputs) {
  if (options.json == "-" && options.junit == "-")
    throw data::InputError(
        "--json - and --junit - both want standard output, but one of them must be a file");
  if (options.file == "-" && options.events == "-")
    throw data::InputError("FILE and --events both are standard input, but one of them must be a file");
  if (options.manifest.empty() && (options.name.empty() || options.file.empty()))
    throw CLI::RequiredError(options.name.empty() ? "NAME" : "FILE");
  const bool has_table = !options.quiet && options.json != "-" && options.junit != "-";
  outputs.open({{"the table", has_table ? "-" : ""},
                {"--json", options.json},
                {"--junit", options.junit},
                {"--figure", options.figure}});
  const data::ReferencePackage package = data::load_reference(options.package);
  const std::vector<CompareOptions> runs = runs_of(options);
  report::Progress& progress = outputs.progress(": known mistakes");
  constexpr std::array statuses{done, undecided, failed, unusable};  // from the best to the worst
  std::size_t worst = 0;
  std::vector<Judged> all;
  for (const CompareOptions& run : runs) {
    Judged& one = all.emplace_back(Judged{.name = run.name, .file = run.file});
    const auto before = static_cast<double>(all.size() - 1), total = static_cast<double>(runs.size());
    std::size_t rank = 3;
    try {
      one.comparison = compare(run, package, [&](double share) { progress((before + share) / total); });
      const auto agreement = one.comparison->agreement;
      rank = agreement == comparison::Agreement::differs     ? 2
             : agreement == comparison::Agreement::undecided ? 1
                                                             : 0;
    } catch (const data::InputError& error) {
      one.refusal = error.what();
    }
    worst = std::max(worst, rank);
  }
  outputs.write("--junit", [&] { return junit_of(all); });
  const bool is_one = options.manifest.empty();
  if (is_one && !all.front().comparison) throw data::InputError(all.front().refusal);
  outputs.write("the table", [&] { return is_one ? text_of(*all.front().comparison) : text_of(all); });
  outputs.write("--json", [&] {
    return (is_one ? json_of(*all.front().comparison, options.file) : json_of(all)).dump(2) + "\n";
  });
  outputs.draw(options.name,
               [&](const report::Look& look) { return report::draw(*all.front().comparison, look); });
  Answer answer;
  answer.status = statuses.at(worst);
  return answer;
}

void add_options(CLI::App& command, CompareOptions& options) {
  command.add_option("NAME", options.name, "A data set that 'stickslip reference list' lists");
  command
      .add_option("FILE", options.file,
                  "CSV file with the columns of the data set, '-' for standard input; a unit may follow a "
                  "name, as in 'frequency [kHz]'")
      ->check(file_name());
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
      .add_option("--columns", options.names,
                  "The names of the columns of FILE, in their order, if it has no line of names; '-' for one "
                  "that does "
                  "not count")
      ->type_name("NAME,NAME,...")
      ->delimiter(',');
  command
      .add_option(
          "--rows", options.rows,
          "The rows of the data set that FILE must have, counted from 1 (default: all), as in 1:12 or 1:3,7")
      ->type_name("FIRST:LAST,...");
  command
      .add_option("--tolerance", options.tolerances,
                  "Instead of that of the data set, of one quantity or of all; repeatable")
      ->type_name("[QUANTITY=]NUMBER")
      ->allow_extra_args(false);
  command.add_option("--until", options.until, "Compare nothing later, s; a run of yours must reach it")
      ->transform(time());
  command.add_option("--json", options.json, "JSON file with all numbers, '-' for standard output")
      ->check(file_name());
  command.add_option("--junit", options.junit, "XML file in JUnit's format, '-' for standard output")
      ->check(file_name());
  add_figure_option(command, options.figure);
  add_package_option(command, options.package);
  command.add_flag("--quiet", options.quiet, "Print nothing");
  auto* const manifest = command.add_option("--manifest", options.manifest,
                                            "CSV file with the columns data_set and file, and events and "
                                            "rows if need be: compares them all, instead of NAME and FILE");
  manifest->check(file_name());
  for (const char* single :
       {"NAME", "FILE", "--events", "--column", "--columns", "--rows", "--until", "--figure"})
    manifest->excludes(command.get_option(single));
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
                    "stickslip compare stick-frequencies mine.csv --rows 1:3"},
       .add_options = add_options,
       .run = compared});
}

}  // namespace stickslip::cli
