// SPDX-License-Identifier: MIT
#include "stickslip/reference/package.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "sets.hpp"
#include "stickslip/data/sha256.hpp"

namespace stickslip::reference {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* type_names[] = {"string", "integer", "number"};

Json field_json(const data::Field& field) {
  Json json{{"name", field.name}, {"type", type_names[static_cast<std::size_t>(field.type)]}};
  if (!field.unit.empty()) json["unit"] = field.unit;
  json["description"] = field.description;
  if (field.value_class) json["class"] = data::to_string(*field.value_class);
  json["constraints"] = {{"required", true}};
  if (!field.allowed.empty()) json["constraints"]["enum"] = field.allowed;
  return json;
}

Json comparison_json(const data::ComparisonRule& rule) {
  Json json{{"kind", data::to_string(rule.kind)}, {"values", Json::array()}};
  for (const data::ComparedValue& value : rule.values) {
    json["values"].push_back(
        {{"field", value.field}, {"norm", data::to_string(value.norm)}, {"tolerance", value.tolerance}});
    if (value.decided_by)
      json["values"].back()["decided_by"] = {{"field", value.decided_by->field},
                                             {"threshold", value.decided_by->threshold}};
  }
  if (!rule.abscissa.empty()) json["abscissa"] = rule.abscissa;
  if (rule.interpolation)
    json["interpolation"] = {{"order", rule.interpolation->order}, {"error", rule.interpolation->error}};
  if (!rule.events.empty()) json["events"] = rule.events;
  if (rule.horizon) json["horizon"] = *rule.horizon;
  if (rule.shortest_phase > 0.0) json["shortest_phase"] = rule.shortest_phase;
  return json;
}

Json diagnosis_json(const data::DiagnosisRule& rule) {
  Json json{{"quantity", rule.quantity}};
  if (rule.case_column.empty())
    json["case"] = rule.case_name;
  else
    json["case"] = {{"column", rule.case_column}};
  json["abscissa"] = rule.abscissa;
  json["value"] = rule.value;
  return json;
}

Json resource_json(const DataSet& set, const std::string& csv) {
  const data::Resource& resource = set.resource;
  Json json{{"name", resource.name},
            {"path", resource.path.generic_string()},
            {"profile", "tabular-data-resource"},
            {"format", "csv"},
            {"mediatype", "text/csv"},
            {"encoding", "utf-8"},
            {"bytes", csv.size()},
            {"hash", "sha256:" + data::sha256(csv)},
            {"title", resource.title},
            {"description", resource.description}};
  if (!resource.problem.empty()) json["problem"] = Json::parse(resource.problem);
  Json fields = Json::array();
  for (const data::Field& field : resource.fields) fields.push_back(field_json(field));
  json["schema"] = {{"fields", fields}, {"primaryKey", resource.primary_key}};
  for (const data::ForeignKey& key : resource.foreign_keys)
    json["schema"]["foreignKeys"].push_back(
        {{"fields", key.column},
         {"reference", {{"resource", key.resource}, {"fields", key.reference_column}}}});
  if (resource.comparison) json["comparison"] = comparison_json(*resource.comparison);
  if (resource.diagnosis) json["diagnosis"] = diagnosis_json(*resource.diagnosis);
  const data::Provenance& provenance = resource.provenance;
  json["provenance"] = {{"class", data::to_string(provenance.value_class)},
                        {"method", provenance.method},
                        {"settings", Json::parse(provenance.settings)},
                        {"software", provenance.software},
                        {"checks", provenance.checks}};
  return json;
}

// The text of a JSON value. An object or array of at most 120 characters stands on one line. In a longer object the
// members share lines of that length, in a longer array each element has a line of its own.
std::string text_of(const Json& json, std::size_t indent = 0) {
  if (!json.is_structured()) return json.dump();
  constexpr std::size_t width = 120;
  const auto is_broken = [](const std::string& text) { return text.find('\n') != std::string::npos; };
  std::vector<std::string> members;
  for (const auto& [key, value] : json.items())
    members.push_back((json.is_object() ? Json(key).dump() + ": " : "") + text_of(value, indent + 1));
  const auto [open, close] = json.is_object() ? std::pair('{', '}') : std::pair('[', ']');
  std::string text = fmt::format("{}{}{}", open, fmt::join(members, ", "), close);
  if (text.size() <= width && !is_broken(text)) return text;
  text = open + members.front();
  std::size_t column = indent + text.size();
  for (std::size_t i = 1; i < members.size(); ++i) {
    const bool stays = json.is_object() && !is_broken(members[i - 1]) && !is_broken(members[i]) &&
                       column + 2 + members[i].size() < width;
    text += stays ? ", " : ",\n" + std::string(indent + 1, ' ');
    text += members[i];
    column = (stays ? column + 2 : indent + 1) + members[i].size();
  }
  return text + close;
}

// The text of the CSV file of a data set.
std::string csv_of(const DataSet& set) {
  std::string text;
  for (const data::Field& field : set.resource.fields) text += (text.empty() ? "" : ",") + field.name;
  text += '\n';
  for (const auto& row : set.rows) {
    if (row.size() != set.resource.fields.size())
      throw std::logic_error(fmt::format("{}: a row of {} cells for {} fields", set.resource.name, row.size(),
                                         set.resource.fields.size()));
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  return text;
}

}  // namespace

const std::vector<Recipe>& recipes() {
  const auto undamped = [](const char* name) {
    return Recipe{name, [name] { return undamped_history(name); }, false};
  };
  const auto timoshenko = [](const char* name, bool is_held) {
    return Recipe{name, [is_held] { return timoshenko_frequencies(is_held); }, true};
  };
  static const std::vector<Recipe> all{{"beams", beam_table, true},
                                       {"stick-frequencies", stick_frequencies, true},
                                       {"slip-frequencies", slip_frequencies, true},
                                       timoshenko("timoshenko-stick-frequencies", true),
                                       timoshenko("timoshenko-slip-frequencies", false),
                                       {"critical-loads", critical_loads, true},
                                       {"participation", participation, true},
                                       {"static-shapes", static_shapes, true},
                                       {"mode-shapes", mode_shapes, true},
                                       {"stick-history-ten-modes", stick_history_of_ten_modes, true},
                                       {"stick-history", stick_history, true},
                                       {"friction-maxima", friction_maxima, true},
                                       {"critical-amplitudes", critical_amplitudes, true},
                                       {"classification", classification, true},
                                       {"length-force", length_force_ratios, true},
                                       {"stick-velocities", stick_velocities, true},
                                       {"stick-fields", stick_fields, true},
                                       {"damped-stick-history", damped_stick_history, true},
                                       {"damped-steady-state", damped_steady_state, true},
                                       {"friction-maxima-all-modes", all_modes_maxima, false},
                                       {"critical-amplitudes-all-modes", all_modes_amplitudes, false},
                                       {"stick-slip-events", stick_slip_events, false},
                                       {"stick-slip-history", stick_slip_history, false},
                                       {"stick-slip-velocities", stick_slip_velocities, false},
                                       {"stick-slip-fields", stick_slip_fields, false},
                                       {"stick-slip-energy", stick_slip_energy, false},
                                       {"stick-slip-spectrum", stick_slip_spectrum, false},
                                       undamped("undamped-history-25"),
                                       undamped("undamped-history-35"),
                                       undamped("undamped-history-70"),
                                       undamped("undamped-history-steel-strip"),
                                       undamped("undamped-history-soft-short"),
                                       {"undamped-sticks", undamped_sticks, false},
                                       {"undamped-fields", undamped_fields, false},
                                       {"single-mass-events", single_mass_events, true},
                                       {"friction-powers", friction_powers, true},
                                       {"manufactured-motion", manufactured_motion, true},
                                       {"published-problems", published_problems, true},
                                       {"stops-per-period", stops_per_period, true},
                                       {"non-stop-limits", non_stop_limits, true},
                                       {"beam-matrices", beam_matrices, true}};
  return all;
}

std::map<std::string, std::string> package_files(const std::vector<DataSet>& sets,
                                                 const std::string& before) {
  std::map<std::string, std::string> files;
  std::map<std::string, Json> by_name;
  const Json kept = before.empty() ? Json::array() : Json::parse(before).at("resources");
  for (const Json& resource : kept) by_name[resource.at("name")] = resource;
  for (const DataSet& set : sets) {
    const std::string csv = csv_of(set);
    by_name[set.resource.name] = resource_json(set, csv);
    files[set.resource.path.generic_string()] = csv;
  }
  Json resources = Json::array();
  for (const Recipe& recipe : recipes())
    if (const auto made = by_name.find(std::string(recipe.name)); made != by_name.end())
      resources.push_back(made->second);
  const Json package{
      {"profile", "tabular-data-package"},
      {"name", "stickslip-reference"},
      {"title", "Reference data for the stick-slip vibration of beams"},
      {"description",
       "The problem of Won, Lee and Chung, Stick-slip vibration of a cantilever beam subjected to harmonic "
       "base excitation, Nonlinear Dynamics (2018), and its parts: numbers with the half-widths of their "
       "uncertainties, for checking other implementations. README.md explains the files."},
      {"version", "1.0.0"},
      {"licenses",
       {{{"name", "MIT"}, {"path", "https://opensource.org/licenses/MIT"}, {"title", "MIT License"}}}},
      {"resources", resources}};
  files["datapackage.json"] = text_of(package) + '\n';
  return files;
}

}  // namespace stickslip::reference
