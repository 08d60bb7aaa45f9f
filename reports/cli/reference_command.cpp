// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "case_options.hpp"
#include "commands.hpp"
#include "output_file.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::cli {

namespace {

struct ReferenceOptions {
  std::string package = data::reference_directory().string();
  std::string name;
  std::string output = "-";
};

void list(const ReferenceOptions& options) {
  const data::ReferencePackage package = data::load_reference(options.package);
  std::size_t width = 4;
  std::vector<std::size_t> rows;
  for (const auto& resource : package.resources) {
    width = std::max(width, resource.name.size());
    rows.push_back(data::read_table(package, resource.name).rows());
  }
  fmt::print("{}, version {}\n\n", package.title, package.version);
  fmt::print("{:<{}}  {:<9}  {:>7}  title\n", "name", width, "class", "rows");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const data::Resource& resource = package.resources[i];
    fmt::print("{:<{}}  {:<9}  {:>7}  {}\n", resource.name, width, to_string(resource.provenance.value_class),
               rows[i], resource.title);
  }
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

void print_columns(const data::Resource& resource) {
  std::size_t width = 0;
  for (const auto& field : resource.fields) width = std::max(width, field.name.size());
  fmt::print("columns\n");
  for (const auto& field : resource.fields)
    fmt::print("  {:<{}}  {:<7}  {:<9}  {}\n", field.name, width, type_of(field),
               field.value_class ? to_string(*field.value_class) : "", field.description);
  fmt::print("  key: {}\n", fmt::join(resource.primary_key, ", "));
}

// The smallest and the largest half-width of each compared value.
void print_uncertainties(const data::ReferenceTable& table) {
  for (const auto& value : table.resource.comparison->values) {
    if (value.norm == data::Norm::word) {
      fmt::print("  {}: word by word\n", value.field);
      continue;
    }
    const std::string unit = table.resource.field(value.field)->unit;
    double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
    for (const double radius : table.radius_of(value.field)) {
      least = std::min(least, radius);
      greatest = std::max(greatest, radius);
    }
    fmt::print("  {}: uncertainty {:.2g} to {:.2g}{}, tolerance {:g}{} ({})\n", value.field, least, greatest,
               unit.empty() ? "" : " " + unit, value.tolerance,
               value.norm == data::Norm::absolute && !unit.empty() ? " " + unit : "", to_string(value.norm));
  }
}

void print_comparison(const data::ReferenceTable& table) {
  const auto& rule = *table.resource.comparison;
  fmt::print("\ncomparison: {}\n", to_string(rule.kind));
  print_uncertainties(table);
  if (rule.interpolation)
    for (const auto& [field, error] : rule.interpolation->error)
      fmt::print("  {}: interpolated by polynomials of order {} to {:.2g}\n", field,
                 rule.interpolation->order, error);
  if (rule.horizon) fmt::print("  up to {:g} s\n", *rule.horizon);
  if (!rule.events.empty()) fmt::print("  events: {}\n", rule.events);
}

void show(const ReferenceOptions& options) {
  const data::ReferencePackage package = data::load_reference(options.package);
  const data::ReferenceTable table = data::read_table(package, options.name);
  const data::Resource& resource = table.resource;
  fmt::print("{}: {}\n{}\n{} rows, {}\n\n", resource.name, resource.title, resource.description, table.rows(),
             (package.folder / resource.path).string());
  print_columns(resource);
  if (resource.comparison) print_comparison(table);
  const auto& provenance = resource.provenance;
  fmt::print("\nprovenance: {}\n  method: {}\n  settings: {}\n  software: {}\n",
             to_string(provenance.value_class), provenance.method, provenance.settings, provenance.software);
  for (const std::string& check : provenance.checks) fmt::print("  check: {}\n", check);
}

void export_table(const ReferenceOptions& options) {
  const data::ReferenceTable table = data::read_table(data::load_reference(options.package), options.name);
  std::error_code error;  // what is no folder is taken for a file
  const bool is_folder = options.output != "-" && std::filesystem::is_directory(options.output, error);
  OutputFile file(is_folder
                      ? (std::filesystem::path(options.output) / table.resource.path.filename()).string()
                      : options.output);
  file.write(table.csv);
  file.commit();
}

}  // namespace

void add_reference_command(CLI::App& app) {
  auto* command = app.add_subcommand("reference", "The published reference data");
  command->require_subcommand(0, 1);  // require_subcommand() asks for one once the arguments are read
  add_examples(*command, {"stickslip reference list", "stickslip reference export stick-history --output ."});
  auto options = std::make_shared<ReferenceOptions>();
  const auto add = [&](const char* name, const char* help, void (*action)(const ReferenceOptions&)) {
    auto* sub = command->add_subcommand(name, help);
    add_package_option(*sub, options->package);
    sub->callback([options, action] { action(*options); });
    return sub;
  };
  add_examples(*add("list", "What there is", list), {"stickslip reference list"});
  for (auto* sub :
       {add("show", "What one data set holds, how well it is known and where it comes from", show),
        add("export", "Its CSV file", export_table)}) {
    add_examples(*sub, {fmt::format("stickslip reference {} stick-frequencies", sub->get_name())});
    sub->add_option("NAME", options->name, "A data set that 'stickslip reference list' lists")->required();
    if (sub->get_name() == "export")
      sub->add_option("--output", options->output, "File or folder, '-' for standard output")
          ->check(file_name())
          ->capture_default_str();
  }
}

}  // namespace stickslip::cli
