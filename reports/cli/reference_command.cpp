// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>

#include "command.hpp"
#include "commands.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::cli {

namespace {

struct ReferenceOptions {
  std::string package = data::reference_directory().string();
  std::string name;
  std::string output = "-";
};

Answer list(const ReferenceOptions& options, Outputs& /*outputs*/) {
  const data::ReferencePackage package = data::load_reference(options.package);
  Table table{.columns = {{"name", ""}, {"class", "", 11}, {"   rows", ""}, {"title", ""}}, .rows = {}};
  for (const auto& resource : package.resources)
    table.rows.push_back({word(resource.name), word(to_string(resource.provenance.value_class)),
                          word(fmt::format("{:>7}", data::read_table(package, resource.name).rows())),
                          word(resource.title)});
  Answer answer;
  answer.add_line(fmt::format("{}, version {}\n", package.title, package.version));
  answer.text += table.text();
  return answer;
}

std::string type_of(const data::Field& field) {
  switch (field.type) {
    case data::FieldType::string:
      return "word";
    case data::FieldType::integer:
      return "integer";
    case data::FieldType::number:
      break;
  }
  return field.unit.empty() ? "1" : field.unit;
}

void add_columns(Answer& answer, const data::Resource& resource) {
  Table table{.columns = {{"name", ""}, {"unit", "", 9}, {"class", "", 11}, {"description", ""}}, .rows = {}};
  for (const auto& field : resource.fields)
    table.rows.push_back({word("  " + field.name), word(type_of(field)),
                          word(field.value_class ? to_string(*field.value_class) : ""),
                          word(field.description)});
  answer.add_line("columns");
  answer.text += table.text(false);
  answer.add_line(fmt::format("  key: {}", fmt::join(resource.primary_key, ", ")));
}

// The smallest and the largest half-width of each compared value.
void add_uncertainties(Answer& answer, const data::ReferenceTable& table) {
  for (const auto& value : table.resource.comparison->values) {
    if (value.norm == data::Norm::word) {
      answer.add_line(fmt::format("  {}: word by word", value.field));
      continue;
    }
    const std::string name = table.resource.field(value.field)->unit, unit = name.empty() ? "" : " " + name;
    double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
    for (const double radius : table.radius_of(value.field)) {
      least = std::min(least, radius);
      greatest = std::max(greatest, radius);
    }
    answer.add_line(fmt::format("  {}: uncertainty {:.2g} to {:.2g}{}, tolerance {:g}{} ({})", value.field,
                                least, greatest, unit, value.tolerance,
                                value.norm == data::Norm::absolute ? unit : "", to_string(value.norm)));
  }
}

void add_comparison(Answer& answer, const data::ReferenceTable& table) {
  const auto& rule = *table.resource.comparison;
  answer.add_line(fmt::format("\ncomparison: {}", to_string(rule.kind)));
  add_uncertainties(answer, table);
  if (rule.interpolation)
    for (const auto& [field, error] : rule.interpolation->error)
      answer.add_line(fmt::format("  {}: interpolated by polynomials of order {} to {:.2g}", field,
                                  rule.interpolation->order, error));
  if (rule.horizon) answer.add_line(fmt::format("  up to {:g} s", *rule.horizon));
  if (!rule.events.empty()) answer.add_line("  events: " + rule.events);
}

Answer show(const ReferenceOptions& options, Outputs& /*outputs*/) {
  const data::ReferencePackage package = data::load_reference(options.package);
  const data::ReferenceTable table = data::read_table(package, options.name);
  const data::Resource& resource = table.resource;
  Answer answer;
  answer.add_line(fmt::format("{}: {}\n{}\n{} rows, {}\n", resource.name, resource.title,
                              resource.description, table.rows(), (package.folder / resource.path).string()));
  add_columns(answer, resource);
  if (resource.comparison) add_comparison(answer, table);
  const auto& [value_class, method, settings, software, checks] = resource.provenance;
  answer.add_line(fmt::format("\nprovenance: {}\n  method: {}\n  settings: {}\n  software: {}",
                              to_string(value_class), method, settings, software));
  for (const std::string& check : checks) answer.add_line("  check: " + check);
  return answer;
}

Answer export_table(const ReferenceOptions& options, Outputs& outputs) {
  const data::ReferenceTable table = data::read_table(data::load_reference(options.package), options.name);
  std::error_code error;  // what is no folder is taken for a file
  const bool is_folder = options.output != "-" && std::filesystem::is_directory(options.output, error);
  outputs.open({{"--output",
                 is_folder ? (std::filesystem::path(options.output) / table.resource.path.filename()).string()
                           : options.output}});
  outputs.write("--output", [&] { return table.csv; });
  return Answer();
}

void add_package(CLI::App& command, ReferenceOptions& options) {
  add_package_option(command, options.package);
}

void add_name(CLI::App& command, ReferenceOptions& options) {
  add_package(command, options);
  command.add_option("NAME", options.name, "A data set that 'stickslip reference list' lists")->required();
}

void add_output(CLI::App& command, ReferenceOptions& options) {
  add_name(command, options);
  add_file_option(command, "--output", options.output, "File or folder, '-' for standard output");
}

}  // namespace

void add_reference_command(CLI::App& app) {
  auto* command = app.add_subcommand("reference", "The published reference data");
  command->require_subcommand(0, 1);  // require_subcommand() asks for one once the arguments are read
  add_examples(*command, {"stickslip reference list", "stickslip reference export stick-history --output ."});
  add<ReferenceOptions>(*command, {.name = "list",
                                   .help = "What there is",
                                   .examples = {"stickslip reference list"},
                                   .add_options = add_package,
                                   .run = list});
  add<ReferenceOptions>(*command,
                        {.name = "show",
                         .help = "What one data set holds, how well it is known and where it comes from",
                         .examples = {"stickslip reference show stick-frequencies"},
                         .add_options = add_name,
                         .run = show});
  add<ReferenceOptions>(*command, {.name = "export",
                                   .help = "Its CSV file",
                                   .examples = {"stickslip reference export stick-frequencies"},
                                   .add_options = add_output,
                                   .run = export_table});
}

}  // namespace stickslip::cli
