// SPDX-License-Identifier: MIT
#include "sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace stickslip::reference {

using certified::Rational;
using certified::Real;

Rational exact(double value) { return {std::string_view(data::shortest_text(value))}; }

NamedBeam named_beam(const std::string& name) {
  data::Case problem = data::load_case(name);
  const data::BeamProperties& p = problem.beam().properties();
  if (p.axial_direction != 0.0)
    throw data::FieldError("beam.axial_direction", p.axial_direction,
                           "0: the enclosures have a follower force");
  certified::Beam beam({.length = exact(p.length),
                        .area = exact(p.area),
                        .second_moment_of_area = exact(p.second_moment_of_area),
                        .density = exact(p.density),
                        .youngs_modulus = exact(p.youngs_modulus),
                        .axial_force = exact(p.axial_force)});
  return {name, std::move(problem), std::move(beam)};
}

const std::vector<NamedBeam>& beams() {
  static const std::vector<NamedBeam> all = [] {
    std::vector<NamedBeam> list;
    for (const char* name : {"paper", "steel-strip", "soft-short", "near-buckling", "tension"})
      list.push_back(named_beam(name));
    return list;
  }();
  return all;
}

Cell enclosed(const Real& value, double scale) {
  const certified::Enclosure enclosure = certified::enclosure(value);
  if (!(std::stod(enclosure.radius) <= 1e-28 * std::max(std::abs(enclosure.midpoint), scale)))
    throw std::runtime_error(fmt::format("{} +- {} is less accurate than the published accuracy",
                                         enclosure.value, enclosure.radius));
  return {enclosure.value, enclosure.radius};
}

Cell converged(double value, double radius) {
  if (!(radius > 1e-57 && std::isfinite(radius)))  // smaller ones are no half-widths of what is published
    throw std::runtime_error("a radius must be positive and finite");
  // Rounded up by more than the rounding error of the printed value.
  const double printed_radius = 1.02 * radius;
  const int decimals = static_cast<int>(std::ceil(-std::log10(printed_radius))) + 2;
  return {fmt::format("{:.{}f}", value, std::max(decimals, 0)), fmt::format("{:.1e}", 1.05 * printed_radius)};
}

void add_row(DataSet& set, const std::vector<Cell>& cells) {
  std::vector<std::string>& row = set.rows.emplace_back();
  for (const Cell& cell : cells) row.insert(row.end(), cell.texts.begin(), cell.texts.end());
}

data::Field word(std::string name, std::string description, std::vector<std::string> allowed) {
  return {.name = std::move(name),
          .type = data::FieldType::string,
          .unit = {},
          .description = std::move(description),
          .value_class = {},
          .required = true,
          .allowed = std::move(allowed)};
}

data::Field integer(std::string name, std::string description) {
  data::Field field = word(std::move(name), std::move(description));
  field.type = data::FieldType::integer;
  return field;
}

data::Field exact_number(std::string name, std::string unit, std::string description) {
  data::Field field = word(std::move(name), std::move(description));
  field.type = data::FieldType::number;
  field.unit = std::move(unit);
  field.value_class = ValueClass::exact;
  return field;
}

data::Field beam_column() { return word("beam", "name of the beam, in beams.csv"); }

data::Field mode_column() { return integer("mode", "number n, from the lowest"); }

void add_value(std::vector<data::Field>& fields, const std::string& name, const std::string& unit,
               const std::string& description, ValueClass value_class) {
  fields.push_back(exact_number(name, unit, description));
  fields.back().value_class = value_class;
  fields.push_back(exact_number(name + "_radius", unit, "half-width of the uncertainty of " + name));
  fields.back().value_class.reset();
}

std::string software() { return "stickslip " STICKSLIP_VERSION; }

DataSet data_set(std::string name, std::string path, std::string title, std::string description) {
  DataSet set;
  set.resource.name = std::move(name);
  set.resource.path = std::move(path);
  set.resource.title = std::move(title);
  set.resource.description = std::move(description);
  return set;
}

data::ForeignKey beam_key() { return {.column = "beam", .resource = "beams", .reference_column = "beam"}; }

std::string in_column(std::string_view column) { return fmt::format(R"({{"column": "{}"}})", column); }

std::string problem_of_each_beam(std::string_view tip) {
  return fmt::format(R"({{"beam": {}, "tip": "{}", "damping": {{"kelvin_voigt": 0}}}})", in_column("beam"),
                     tip);
}

std::string problem_of(const data::Case& problem, std::string_view beam, std::string_view tip,
                       const std::map<std::string, std::string>& others) {
  using Json = nlohmann::ordered_json;
  Json json{{"beam", beam},
            {"tip", tip},
            {"excitation",
             {{"frequency_hz", problem.excitation().frequency_hz()},
              {"amplitude", problem.excitation().amplitude()}}},
            {"damping", {{"kelvin_voigt", problem.damping.kelvin_voigt()}}},
            {"friction",
             {{"static_coefficient", problem.contact.friction.static_coefficient()},
              {"kinetic_coefficient", problem.contact.friction.kinetic_coefficient()},
              {"decay", problem.contact.friction.decay()}}},
            {"initial_state", "y = 0, y_t = (1 + S(x)) h_t"},
            {"modes", "all"}};
  for (const auto& [pointer, value] : others) json[Json::json_pointer(pointer)] = Json::parse(value);
  return json.dump();
}

data::ComparisonRule by_rows(std::vector<data::ComparedValue> values) {
  data::ComparisonRule rule;
  rule.kind = data::ComparisonKind::table;
  rule.values = std::move(values);
  return rule;
}

void set_key(data::Resource& resource, std::vector<data::Field> columns) {
  resource.fields = std::move(columns);
  for (const data::Field& field : resource.fields) resource.primary_key.push_back(field.name);
}

void add_values(data::Resource& resource, ValueClass value_class, const std::vector<Value>& values) {
  std::vector<data::ComparedValue> compared;
  for (const auto& [name, unit, description, norm, tolerance] : values) {
    add_value(resource.fields, name, unit, description, value_class);
    compared.push_back({name, norm, tolerance});
  }
  resource.comparison = by_rows(std::move(compared));
}

void compare_along(data::Resource& resource, std::string abscissa) {
  resource.comparison->kind = data::ComparisonKind::curve;
  resource.comparison->abscissa = std::move(abscissa);
}

data::DiagnosisRule in_case(std::string quantity, std::string name, std::string abscissa, std::string value) {
  return {.quantity = std::move(quantity),
          .case_name = std::move(name),
          .case_column = {},
          .abscissa = std::move(abscissa),
          .value = std::move(value)};
}

data::DiagnosisRule for_each_beam(std::string quantity, std::string abscissa, std::string value) {
  data::DiagnosisRule rule = in_case(std::move(quantity), {}, std::move(abscissa), std::move(value));
  rule.case_column = "beam";
  return rule;
}

data::Provenance enclosed_by(std::string method, std::string settings, std::vector<std::string> checks) {
  checks.emplace_back(
      "the double-precision library agrees to a few units in the last place times the condition");
  return {.value_class = ValueClass::enclosed,
          .method = "ball arithmetic (Arb), every rounding accounted for: " + std::move(method),
          .settings = std::move(settings),
          .software = software() + ", Arb " + std::string(arb_version),
          .checks = std::move(checks)};
}

data::Provenance converged_by(std::string method, std::string settings, std::vector<std::string> checks) {
  return {.value_class = ValueClass::converged,
          .method = std::move(method),
          .settings = std::move(settings),
          .software = software(),
          .checks = std::move(checks)};
}

}  // namespace stickslip::reference
