// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "command.hpp"
#include "commands.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/key.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::cli {

namespace {

struct CasesOptions {
  bool schema{};
};

Json typed(const char* type) { return {{"type", type}}; }

Json one_of_words(const std::vector<std::string>& words) { return {{"enum", words}}; }

Json list_of(Json items) { return {{"type", "array"}, {"minItems", 1}, {"items", std::move(items)}}; }

Json table_of(Json properties) {
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

Json quantity() {
  return {{"type", Json::array({"number", "string"})}, {"pattern", "^[ \\t]*[-+]?[.]?[0-9]"}};
}

// The keys that hold no number, by their names.
std::map<std::string_view, Json> types_of_shorthand() {
  std::vector<std::string> materials;
  for (const data::Material& material : data::list_materials()) materials.push_back(material.name);
  const Json numbers = list_of(typed("integer")), directions = one_of_words({"x", "y", "z"});
  const Json rows{
      {"anyOf",
       Json::array({typed("integer"), numbers,
                    table_of({{"rows", {{"anyOf", Json::array({typed("integer"), numbers})}}},
                              {"nodes", {{"type", Json::array({"integer", "array", "string"})}}},
                              {"direction", {{"anyOf", Json::array({directions, list_of(directions)})}}},
                              {"weights", list_of(typed("number"))}})})}};
  return {{"material", one_of_words(materials)},
          {"shape", one_of_words({"rectangle", "circle", "tube"})},
          {"ratios", list_of(quantity())},
          {"units", one_of_words({"m", "mm"})},
          {"mass_matrix", typed("string")},
          {"stiffness_matrix", typed("string")},
          {"damping_matrix", typed("string")},
          {"dofs", typed("string")},
          {"base", rows},
          {"fixed", rows},
          {"contact", rows},
          {"load", rows},
          {"sines", list_of({{"type", "array"}, {"minItems", 2}, {"maxItems", 3}, {"items", quantity()}})},
          {"sweep", table_of({{"from", quantity()}, {"to", quantity()}, {"rate", typed("string")}})},
          {"shock", table_of({{"shape", one_of_words({"half-sine", "sawtooth", "trapezoid", "rectangle"})},
                              {"duration", quantity()}})},
          {"file", typed("string")},
          {"spectrum", {{"type", Json::array({"array", "string"})}}},
          {"seed", typed("integer")},
          {"column", typed("string")},
          {"quantity", one_of_words({"displacement", "velocity", "acceleration", "force"})},
          {"unit", typed("string")}};
}

Json schema_of(const data::Key& key, const std::map<std::string_view, Json>& shorthand) {
  const auto& [smallest, largest, unit] = key.magnitudes;
  if (key.member.is_flag) return typed("boolean");
  if (key.member.is_integer) return typed("integer");
  if (key.member.get == nullptr && unit.empty()) return shorthand.at(key.name());
  Json schema = quantity();
  std::string text(key.axis.label.empty() ? key.name() : key.axis.label);
  text += ": " + data::quantity_allowed("", unit);
  if (std::isfinite(largest))
    text += fmt::format(", from {} to {} in magnitude", data::shortest_text(smallest),
                        data::shortest_text(largest));
  schema["description"] = text;
  return schema;
}

Json schema_of_distribution() {
  Json schema =
      table_of({{"distribution", one_of_words({"normal", "lognormal", "uniform", "triangular", "samples"})}});
  for (const char* name : {"mean", "standard_deviation", "lower", "mode", "upper"})
    schema["properties"][name] = quantity();
  for (const char* name : {"file", "column"}) schema["properties"][name] = typed("string");
  schema["required"] = {"distribution"};
  return schema;
}

// The JSON Schema of a case file, for editors. What depends on several keys it leaves to the program.
Json case_schema() {
  Json tables = Json::object(), uncertain{{"correlation", typed("array")}};
  const auto shorthand = types_of_shorthand();
  for (const data::Key& key : data::case_keys()) {
    Json& table = tables.emplace(key.table(), table_of(Json::object())).first.value();
    table["properties"][std::string(key.name())] = schema_of(key, shorthand);
    if (key.is_real()) uncertain[std::string(key.path)] = schema_of_distribution();
  }
  tables["uncertainty"] = table_of(std::move(uncertain));
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "A case file of stickslip"}};
  schema.update(table_of(std::move(tables)));
  return schema;
}

Answer listed_cases(const CasesOptions& options, Outputs& /*outputs*/) {
  if (options.schema) {
    Answer schema;
    schema.text = json_text(case_schema());
    return schema;
  }
  Table table{.columns = {{"name", "name"}, {"title", "title"}, {"", "file"}}, .rows = {}};
  for (const auto& [name, title] : data::list_cases())
    table.rows.push_back({word(name), word(title), word(data::find_case(name).string())});
  Answer answer;
  answer.text = table.text(false);
  answer.add_members({{"cases", table.json()}});
  return answer;
}

}  // namespace

void add_cases_command(CLI::App& app) {
  add<CasesOptions>(app, {.name = "cases",
                          .help = "List the published cases",
                          .examples = {"stickslip cases", "stickslip cases --json",
                                       "stickslip cases --schema > case.schema.json"},
                          .add_options =
                              [](CLI::App& command, CasesOptions& options) {
                                add_json_option(command);
                                command.add_flag("--schema", options.schema)
                                    ->description("Print the JSON Schema of a case file, for editors")
                                    ->excludes(command.get_option("--json"));
                              },
                          .run = listed_cases});
}

}  // namespace stickslip::cli
