// SPDX-License-Identifier: MIT
/// The reader of the published reference data: what it returns, and that a package with any defect is refused
/// in one sentence that names the file and the place in it.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/reference.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using nlohmann::json;

const std::filesystem::path fixture(std::filesystem::path(STICKSLIP_SOURCE_DIRECTORY) /
                                    "verification/tests/golden/reference");

// A package of two resources, a history and its events, that a test spoils.
json valid_package() {
  return json::parse(R"({
 "name": "small", "title": "Small", "description": "For a test", "version": "1.0.0", "licenses": [{"name": "MIT"}],
 "resources": [
  {"name": "history", "path": "history.csv", "format": "csv", "encoding": "utf-8", "profile": "tabular-data-resource",
   "title": "A history", "description": "Of a tip",
   "schema": {"fields": [{"name": "t", "type": "number", "unit": "s"},
                         {"name": "phase", "type": "string", "constraints": {"required": true, "enum": ["stick", "slip"]}},
                         {"name": "y", "type": "number", "unit": "m", "class": "converged", "description": "of the tip"},
                         {"name": "y_radius", "type": "number", "unit": "m"}],
              "primaryKey": ["t"],
              "foreignKeys": [{"fields": "t", "reference": {"resource": "events", "fields": "time"}}]},
   "problem": {"beam": "paper", "tip": "friction", "excitation": {"frequency_hz": {"column": "t"}, "amplitude": 1e-3},
               "duration": 0.4},
   "comparison": {"kind": "phases", "values": [{"field": "y", "norm": "scale", "tolerance": 1e-3}], "abscissa": "t",
                  "interpolation": {"order": 3, "error": {"y": 1e-9}}, "events": "events", "horizon": 0.4},
   "diagnosis": {"quantity": "tip displacement", "case": "damped", "abscissa": "t", "value": "y"},
   "provenance": {"class": "converged", "method": "by hand", "settings": {"modes": 3}, "software": "none",
                  "checks": ["looked at"]}},
  {"name": "events", "path": "events.csv", "title": "Events", "description": "Of the history",
   "schema": {"fields": [{"name": "index", "type": "integer"}, {"name": "change", "type": "string"},
                         {"name": "time", "type": "number", "unit": "s", "class": "exact"}],
              "primaryKey": "index"},
   "comparison": {"kind": "events", "values": [{"field": "time", "norm": "absolute", "tolerance": 1e-6}],
                  "shortest_phase": 1e-5},
   "provenance": {"class": "exact", "method": "by hand", "settings": {}, "software": "none", "checks": ["looked at"]}}
 ]})");
}

const std::string valid_history = "t,phase,y,y_radius\n0,stick,0,1e-9\n0.1,stick,1e-3,1e-9\n0.2,slip,,\n";
const std::string valid_events = "index,change,time\n1,onset,0.15\n2,capture,0.25\n";

// FIPS 180-4, by another program.
constexpr const char* history_digest = "de909ee5ca04e29fcb804619937393d0b8c460b858250d1d59d68f38a9175d0e";
constexpr const char* events_digest = "7c166cea6316dda398d3414823a7a0aec171f215f74593818eea2c2a61a697ab";

class ReferenceReader : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_);
    write("history.csv", valid_history);
    write("events.csv", valid_events);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  // Writes the package with the sizes and the digests of the valid tables.
  void write_package(json package) const {
    const auto sign = [&](std::size_t i, std::size_t bytes, const std::string& digest) {
      if (!package.contains("resources") || package["resources"].size() <= i) return;
      package["resources"][i]["bytes"] = bytes;
      package["resources"][i]["hash"] = "sha256:" + digest;
    };
    sign(0, valid_history.size(), history_digest);
    sign(1, valid_events.size(), events_digest);
    write("datapackage.json", package.dump(1));
  }

  // The sentence that refuses the package or one of its tables, without the folder, or "accepted".
  [[nodiscard]] std::string error_message(const std::string& table = "") const {
    try {
      const auto package = data::load_reference(folder_);
      if (!table.empty()) static_cast<void>(data::read_table(package, table));
    } catch (const data::InputError& error) {
      std::string sentence = error.what();
      const std::string prefix = folder_.string() + "/";
      if (const auto at = sentence.find(prefix); at != std::string::npos) sentence.erase(at, prefix.size());
      EXPECT_EQ(std::ranges::count(sentence, '\n'), 0) << sentence;
      return sentence;
    }
    return "accepted";
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("stickslip-reference-" + std::to_string(::getpid()));
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

STICKSLIP_VERIFIES(ReferenceReader, "P5");
TEST_F(ReferenceReader, ReturnsWhatAPackageSays) {
  write_package(valid_package());
  const auto package = data::load_reference(folder());
  EXPECT_EQ(package.name, "small");
  EXPECT_EQ(package.title, "Small");
  EXPECT_EQ(package.description, "For a test");
  EXPECT_EQ(package.version, "1.0.0");
  ASSERT_EQ(package.resources.size(), 2u);
  const data::Resource& history = package.resource("history");
  EXPECT_EQ(history.title, "A history");
  EXPECT_EQ(history.description, "Of a tip");
  ASSERT_EQ(history.fields.size(), 4u);
  EXPECT_EQ(history.field("y")->unit, "m");
  EXPECT_EQ(history.field("y")->description, "of the tip");
  EXPECT_EQ(history.field("y")->value_class, data::ValueClass::converged);
  EXPECT_FALSE(history.field("y_radius")->value_class.has_value());
  EXPECT_EQ(history.field("phase")->type, data::FieldType::string);
  EXPECT_TRUE(history.field("phase")->required);
  EXPECT_FALSE(history.field("y")->required);
  EXPECT_EQ(history.field("phase")->allowed, (std::vector<std::string>{"stick", "slip"}));
  ASSERT_EQ(history.foreign_keys.size(), 1u);
  EXPECT_EQ(history.foreign_keys[0].column, "t");
  EXPECT_EQ(history.foreign_keys[0].resource, "events");
  EXPECT_EQ(history.foreign_keys[0].reference_column, "time");
  EXPECT_EQ(json::parse(history.problem)["tip"], "friction");
  EXPECT_EQ(history.stated.beam, "paper");
  EXPECT_EQ(history.stated.tip, "friction");
  EXPECT_EQ(history.stated.numbers, (std::map<std::string, double>{{"excitation.amplitude", 1e-3}}));
  EXPECT_EQ(package.resource("events").problem, "");
  EXPECT_EQ(history.field("z"), nullptr);
  EXPECT_EQ(history.primary_key, std::vector<std::string>{"t"});
  const auto& rule = history.comparison.value();
  EXPECT_EQ(rule.kind, data::ComparisonKind::phases);
  ASSERT_EQ(rule.values.size(), 1u);
  EXPECT_EQ(rule.values[0].field, "y");
  EXPECT_EQ(rule.values[0].norm, data::Norm::scale);
  EXPECT_EQ(rule.values[0].tolerance, 1e-3);
  EXPECT_EQ(rule.abscissa, "t");
  EXPECT_EQ(rule.interpolation.value().order, 3);
  EXPECT_EQ(rule.interpolation.value().error.at("y"), 1e-9);
  EXPECT_EQ(rule.events, "events");
  EXPECT_EQ(rule.horizon, 0.4);
  EXPECT_EQ(history.diagnosis.value().quantity, "tip displacement");
  EXPECT_EQ(history.diagnosis.value().case_name, "damped");
  EXPECT_EQ(history.diagnosis.value().case_column, "");
  EXPECT_EQ(history.diagnosis.value().abscissa, "t");
  EXPECT_EQ(history.diagnosis.value().value, "y");
  EXPECT_EQ(history.provenance.value_class, data::ValueClass::converged);
  EXPECT_EQ(history.provenance.method, "by hand");
  EXPECT_EQ(history.provenance.settings, R"({"modes":3})");
  EXPECT_EQ(history.provenance.software, "none");
  EXPECT_EQ(history.provenance.checks, std::vector<std::string>{"looked at"});
  EXPECT_EQ(package.resource("events").comparison->shortest_phase, 1e-5);
  EXPECT_EQ(package.resource("events").primary_key, std::vector<std::string>{"index"});
  EXPECT_FALSE(package.resource("events").diagnosis.has_value());
}

TEST_F(ReferenceReader, KeepsEveryDigitAndTheNearestDouble) {
  const auto table = data::read_table(data::load_reference(fixture), "stick-frequencies");
  ASSERT_EQ(table.rows(), 12u);
  const auto& frequency = table.column("frequency");
  EXPECT_EQ(frequency.text[0], "24.9719580926706706070503365542");
  EXPECT_EQ(frequency.values[0], 24.9719580926706706070503365542);
  EXPECT_EQ(table.column("beam").text[11], "paper-half-stiffness");
  EXPECT_TRUE(std::isnan(table.column("beam").values[0]));
  EXPECT_EQ(table.radius_of("frequency")[2], 1e-26);
  EXPECT_EQ(table.radius_of("mode"), std::vector<double>(12, 0.0));
  EXPECT_THROW(static_cast<void>(table.column("none")), std::out_of_range);
}

TEST_F(ReferenceReader, TakesAnEmptyCellForNoValue) {
  write_package(valid_package());
  const auto table = data::read_table(data::load_reference(folder()), "history");
  ASSERT_EQ(table.rows(), 3u);
  EXPECT_EQ(table.csv, valid_history);
  EXPECT_EQ(table.column("y").values[1], 1e-3);
  EXPECT_TRUE(std::isnan(table.column("y").values[2]));
  EXPECT_TRUE(std::isnan(table.radius_of("y")[2]));
  EXPECT_EQ(table.radius_of("t")[2], 0.0);
}

TEST_F(ReferenceReader, NamesTheNearestDataSet) {
  write_package(valid_package());
  EXPECT_EQ(error_message("histroy"),
            "the data set histroy is unknown (did you mean history?), but must be one of history, events");
}

TEST_F(ReferenceReader, NamesTheValueThatIsWrong) {
  write("datapackage.json", "{\n \"name\": \"small\",\n   \"title\": 3\n}\n");
  EXPECT_EQ(error_message(), "datapackage.json: title is 3, but must be a string that is not empty");
  write("datapackage.json", "{\n \"name\": \"small\",\n   \"name\": \"twice\"\n}\n");
  EXPECT_EQ(error_message(), "datapackage.json: the key name stands twice in an object");
  write("datapackage.json", "{\n \"name\": \"small\",\n  oops\n}\n");
  EXPECT_TRUE(
      error_message().starts_with("datapackage.json: is not valid JSON: parse error at line 3, column 3: "))
      << error_message();
  write("datapackage.json", "{\n \"name\": \"small\"");
  EXPECT_TRUE(
      error_message().starts_with("datapackage.json: is not valid JSON: parse error at line 2, column 17: "))
      << error_message();
  write("datapackage.json", "{\"name\": {}}");
  EXPECT_EQ(error_message(), "datapackage.json: name is an object, but must be a string that is not empty");
  write("datapackage.json", std::string(100, '[') + "1" + std::string(100, ']'));
  EXPECT_EQ(error_message(), "datapackage.json: the package is an array, but must be an object");
  write("datapackage.json", std::string(101, '[') + "1" + std::string(101, ']'));
  EXPECT_EQ(error_message(), "datapackage.json: is nested deeper than the 100 levels that are allowed");
  write("datapackage.json", "[]");
  EXPECT_EQ(error_message(), "datapackage.json: the package is an array, but must be an object");
  std::filesystem::remove(folder() / "datapackage.json");
  EXPECT_EQ(error_message(), "datapackage.json: cannot be opened for reading");
}

// What is done to the package, and a part of the sentence that refuses it.
struct Defect {
  std::string name;
  std::function<void(json&)> spoil;
  std::string part;
};

// The first resource is the history.
json& history_of(json& package) { return package["resources"][0]; }
json& fields_of(json& package) { return history_of(package)["schema"]["fields"]; }
json& rule_of(json& package) { return history_of(package)["comparison"]; }

struct Defects {
  std::vector<Defect> all;

  void add(const std::string& name, const std::function<void(json&)>& spoil, const std::string& part) {
    all.push_back({name, spoil, part});
  }
};

// Keys that are missing.
void add_missing_keys(Defects& list) {
  for (const char* key : {"name", "title", "description", "version", "licenses", "resources"})
    list.add(
        std::string("without_") + key, [key](json& p) { p.erase(key); },
        std::string("the package lacks ") + key);
  for (const char* key : {"name", "path", "title", "description", "schema", "provenance"})
    list.add(
        std::string("resource_without_") + key, [key](json& p) { history_of(p).erase(key); },
        (key == std::string("name") ? "resources/0 lacks " : "resources/history lacks ") + std::string(key));
  for (const char* key : {"class", "method", "settings", "software", "checks"})
    list.add(
        std::string("provenance_without_") + key, [key](json& p) { history_of(p)["provenance"].erase(key); },
        std::string("resources/history/provenance lacks ") + key);
  for (const char* key : {"kind", "values", "abscissa", "events"})
    list.add(
        std::string("comparison_without_") + key, [key](json& p) { rule_of(p).erase(key); },
        std::string("resources/history/comparison lacks ") + key);
  for (const char* key : {"field", "norm", "tolerance"})
    list.add(
        std::string("value_without_") + key, [key](json& p) { rule_of(p)["values"][0].erase(key); },
        std::string("resources/history/comparison/values/0 lacks ") + key);
  for (const char* key : {"quantity", "case", "abscissa", "value"})
    list.add(
        std::string("diagnosis_without_") + key, [key](json& p) { history_of(p)["diagnosis"].erase(key); },
        std::string("resources/history/diagnosis lacks ") + key);
}

// Resources and their fields.
void add_resource_defects(Defects& list) {
  list.add(
      "no_licence", [](json& p) { p["licenses"] = json::array(); },
      "licenses is an array, but must be an array that");
  list.add(
      "no_resource", [](json& p) { p["resources"] = json::array(); },
      "resources is an array, but must be an array");
  list.add(
      "name_twice", [](json& p) { p["resources"][1]["name"] = "history"; },
      "resources/history/name stands twice: history");
  list.add(
      "path_outside", [](json& p) { history_of(p)["path"] = "../history.csv"; },
      "path is \"../history.csv\", but must be a path inside");
  list.add(
      "path_absolute", [](json& p) { history_of(p)["path"] = "/etc/passwd"; }, "but must be a path inside");
  list.add(
      "other_format", [](json& p) { history_of(p)["format"] = "xlsx"; }, "\"xlsx\", but must be one of csv");
  list.add(
      "other_encoding", [](json& p) { history_of(p)["encoding"] = "latin1"; }, "but must be one of utf-8");
  list.add(
      "other_profile", [](json& p) { history_of(p)["profile"] = "data-resource"; }, "tabular-data-resource");
  list.add(
      "no_fields", [](json& p) { fields_of(p) = json::array(); }, "an array of fields that is not empty");
  list.add(
      "field_twice", [](json& p) { fields_of(p)[2]["name"] = "t"; }, "schema/fields/t/name stands twice: t");
  list.add(
      "unknown_type", [](json& p) { fields_of(p)[0]["type"] = "float"; },
      "\"float\", but must be one of string, integer, number");
  list.add(
      "type_is_no_word", [](json& p) { fields_of(p)[0]["type"] = 7; }, "type is 7, but must be one of");
}

// Classes and radii of fields.
void add_field_defects(Defects& list) {
  list.add(
      "unknown_class", [](json& p) { fields_of(p)[2]["class"] = "good"; },
      "\"good\", but must be one of enclosed, exact, converged, external");
  list.add(
      "class_of_words", [](json& p) { fields_of(p)[1]["class"] = "exact"; }, "has a class, but holds words");
  list.add(
      "required_is_no_flag", [](json& p) { fields_of(p)[1]["constraints"]["required"] = 1; },
      "required is 1, but must be true or false");
  for (const char* known : {"converged", "enclosed"})
    list.add(
        std::string(known) + "_without_radius",
        [known](json& p) {
          fields_of(p)[2]["class"] = known;
          fields_of(p)[3]["name"] = "radius";
        },
        std::string("resources/history/schema/fields/y is ") + known + ", but the schema lacks y_radius");
  list.add(
      "radius_of_nothing",
      [](json& p) {
        fields_of(p)[2].erase("class");
        fields_of(p)[3]["name"] = "z_radius";
      },
      "is the radius of no field: z_radius");
  list.add(
      "radius_in_another_unit", [](json& p) { fields_of(p)[3]["unit"] = "mm"; },
      "has the unit 'mm', but must have that of y, 'm'");
}

// Rules of comparison.
void add_rule_defects(Defects& list) {
  list.add(
      "unknown_key", [](json& p) { history_of(p)["schema"]["primaryKey"] = {"tt"}; },
      "primaryKey/0 is \"tt\", but must be a field of the schema: t, phase, y, y_radius");
  list.add(
      "unknown_kind", [](json& p) { rule_of(p)["kind"] = "list"; }, "one of table, curve, events, phases");
  list.add(
      "no_values", [](json& p) { rule_of(p)["values"] = json::array(); },
      "values is an array, but must be an array");
  list.add(
      "unknown_value", [](json& p) { rule_of(p)["values"][0]["field"] = "y_radiu"; },
      "a field of the schema (did you mean y_radius?)");
  list.add(
      "value_of_words", [](json& p) { rule_of(p)["values"][0]["field"] = "phase"; },
      "but must be a field of numbers");
  list.add(
      "word_of_numbers", [](json& p) { rule_of(p)["values"][0]["norm"] = "word"; },
      "field is \"y\", but must be a column of words");
  list.add(
      "words_in_phases",
      [](json& p) {
        rule_of(p)["values"].push_back({{"field", "phase"}, {"norm", "word"}, {"tolerance", 0}});
      },
      "but must be table or events, because words are compared");
  list.add(
      "number_decided_by", [](json& p) { rule_of(p)["values"][0]["decided_by"] = json::object(); },
      "decided_by");
  list.add(
      "word_decided_by_another",
      [](json& p) {
        rule_of(p)["values"].push_back({{"field", "phase"},
                                        {"norm", "word"},
                                        {"tolerance", 0},
                                        {"decided_by", {{"field", "t"}, {"threshold", 1}}}});
      },
      "but must be one of the compared values");
  list.add(
      "unknown_norm", [](json& p) { rule_of(p)["values"][0]["norm"] = "l2"; },
      "one of relative, scale, absolute, range");
  list.add(
      "negative_tolerance", [](json& p) { rule_of(p)["values"][0]["tolerance"] = -1; },
      "tolerance is -1, but must be a number that is not negative");
  list.add(
      "tolerance_is_no_number", [](json& p) { rule_of(p)["values"][0]["tolerance"] = "1e-3"; },
      "must be a number");
  list.add(
      "unknown_abscissa", [](json& p) { rule_of(p)["abscissa"] = "time"; }, "a field of the schema");
}

// Interpolation and events of a rule.
void add_interpolation_defects(Defects& list) {
  list.add(
      "order_of_0", [](json& p) { rule_of(p)["interpolation"]["order"] = 0; },
      "order is 0, but must be an integer from 1");
  list.add(
      "order_of_10", [](json& p) { rule_of(p)["interpolation"]["order"] = 10; }, "an integer from 1 to 9");
  list.add(
      "order_is_no_integer", [](json& p) { rule_of(p)["interpolation"]["order"] = 2.5; },
      "2.5, but must be an integer");
  list.add(
      "error_of_unknown_field", [](json& p) { rule_of(p)["interpolation"]["error"]["y_radiu"] = 1.0; },
      "is of no field of the schema (did you mean y_radius?)");
  list.add(
      "error_missing", [](json& p) { rule_of(p)["interpolation"]["error"].erase("y"); },
      "lacks y, which is compared");
  list.add(
      "negative_error", [](json& p) { rule_of(p)["interpolation"]["error"]["y"] = -1e-9; },
      "that is not negative");
  list.add(
      "horizon_of_0", [](json& p) { rule_of(p)["horizon"] = 0; },
      "horizon is 0, but must be a number above 0");
  list.add(
      "events_of_no_resource", [](json& p) { rule_of(p)["events"] = "changes"; },
      "a resource of the kind events");
  list.add(
      "events_of_another_kind", [](json& p) { rule_of(p)["events"] = "history"; },
      "a resource of the kind events");
}

// Statements of the problem, foreign keys and words.
void add_problem_defects(Defects& list) {
  const auto key = [](json& p) -> json& { return history_of(p)["schema"]["foreignKeys"][0]; };
  list.add(
      "unknown_tip", [](json& p) { history_of(p)["problem"]["tip"] = "loose"; },
      "problem/tip is \"loose\", but must be one of held, free, friction");
  list.add(
      "misspelt_problem", [](json& p) { history_of(p)["problem"]["exitation"] = 1; },
      "problem/exitation is unknown (did you mean excitation?)");
  list.add(
      "problem_in_unknown_column",
      [](json& p) {
        history_of(p)["problem"]["beam"] = {{"column", "beam"}};
      },
      "problem/beam/column is \"beam\", but must be a field of the schema");
  list.add(
      "problem_with_array",
      [](json& p) {
        history_of(p)["problem"]["modes"] = {1, 2};
      },
      "problem/modes is an array, but must be a number, a word or an object");
  list.add(
      "problem_without_end", [](json& p) { history_of(p)["problem"]["duration"] = 0; },
      "problem/duration is 0, but must be a number above 0");
  list.add(
      "key_of_unknown_column", [key](json& p) { key(p)["fields"] = "tt"; },
      "schema/foreignKeys/0/fields is \"tt\", but must be a field of the schema");
  for (const char* part : {"resource", "fields"})
    list.add(
        std::string("key_to_unknown_") + part, [key, part](json& p) { key(p)["reference"][part] = "none"; },
        "schema/foreignKeys/0/reference is no column of the package: ");
  list.add(
      "words_of_numbers", [](json& p) { fields_of(p)[0]["constraints"]["enum"] = {"a"}; },
      "enum is an array, but must be an array of the words of a field of words");
}

// Columns that a kind of table needs, provenance and diagnosis.
void add_remaining_defects(Defects& list) {
  list.add(
      "phases_without_phase", [](json& p) { fields_of(p)[1]["name"] = "state"; },
      "the schema lacks the field phase");
  list.add(
      "events_without_change", [](json& p) { p["resources"][1]["schema"]["fields"][1]["name"] = "kind"; },
      "is of the kind events, but the schema lacks the field change");
  list.add(
      "table_without_key",
      [](json& p) {
        rule_of(p)["kind"] = "table";
        history_of(p)["schema"].erase("primaryKey");
      },
      "is of the kind table, but the schema lacks a primaryKey");
  list.add(
      "case_in_unknown_column",
      [](json& p) {
        history_of(p)["diagnosis"]["case"] = {{"column", "beam"}};
      },
      "case/column is \"beam\", but must be a field of the schema");
  list.add(
      "settings_are_no_object", [](json& p) { history_of(p)["provenance"]["settings"] = "none"; },
      "settings is \"none\", but must be an object");
  list.add(
      "no_checks", [](json& p) { history_of(p)["provenance"]["checks"] = json::array(); },
      "checks is an array, but");
  list.add(
      "empty_method", [](json& p) { history_of(p)["provenance"]["method"] = ""; },
      "method is \"\", but must be a string");
}

std::vector<Defect> defects() {
  Defects list;
  add_missing_keys(list);
  add_resource_defects(list);
  add_field_defects(list);
  add_rule_defects(list);
  add_interpolation_defects(list);
  add_problem_defects(list);
  add_remaining_defects(list);
  return list.all;
}

TEST_F(ReferenceReader, RefusesEveryDefectOfAPackageAtItsPlace) {
  write_package(valid_package());
  ASSERT_EQ(error_message("history"), "accepted");
  ASSERT_EQ(error_message("events"), "accepted");
  for (const int order : {1, 9}) {
    json package = valid_package();
    rule_of(package)["interpolation"]["order"] = order;
    write_package(package);
    EXPECT_EQ(error_message(), "accepted") << order;
  }
  json without_key = valid_package();
  history_of(without_key)["schema"].erase("primaryKey");
  write_package(without_key);
  EXPECT_EQ(error_message("history"), "accepted");
  for (const Defect& defect : defects()) {
    json package = valid_package();
    defect.spoil(package);
    write_package(package);
    const std::string sentence = error_message();
    EXPECT_TRUE(contains(sentence, defect.part)) << defect.name << ": " << sentence;
    EXPECT_TRUE(sentence.starts_with("datapackage.json: ")) << sentence;
  }
}

TEST_F(ReferenceReader, RefusesDigestsAndSizesThatAreNone) {
  const auto with = [&](const std::string& key, const json& value) {
    write_package(valid_package());
    json package = json::parse(std::ifstream(folder() / "datapackage.json"));
    package["resources"][0][key] = value;
    write("datapackage.json", package.dump(1));
    return error_message("history");
  };
  for (const char* hash : {"sha256:12", "md5:0", "", "sha256:"})
    EXPECT_TRUE(contains(with("hash", hash), "hash is \"")) << with("hash", hash);
  EXPECT_TRUE(contains(with("hash", std::string("sha256:") + std::string(64, 'g')), "64 hexadecimal digits"));
  EXPECT_TRUE(contains(with("bytes", 0), "bytes is 0, but must be an integer above 0"));
  EXPECT_TRUE(contains(with("bytes", "12"), "bytes is \"12\", but must be an integer"));
  EXPECT_TRUE(contains(with("bytes", 7), "history.csv: its size is")) << with("bytes", 7);
  EXPECT_TRUE(contains(with("hash", std::string("sha256:") + std::string(64, '0')), "its SHA-256 digest is"));
}

TEST_F(ReferenceReader, NoticesASingleAlteredByte) {
  std::string altered = valid_history;
  altered[altered.size() - 12] = '2';
  write_package(valid_package());
  write("history.csv", altered);
  const std::string sentence = error_message("history");
  EXPECT_TRUE(sentence.starts_with("history.csv: its SHA-256 digest is ")) << sentence;
  EXPECT_TRUE(contains(sentence, history_digest)) << sentence;
  std::filesystem::remove(folder() / "history.csv");
  EXPECT_EQ(error_message("history"), "history.csv: cannot be opened for reading");
}

TEST_F(ReferenceReader, RefusesEveryDefectOfATableAtItsPlace) {
  struct Table {
    std::string csv, digest, sentence;
  };
  const std::vector<Table> tables{
      {"t,phase,y\n0,stick,0\n", "8f3de1d5a674da074c9a1cf219afef659f1081b6ad42f4a26622e0de9c60a162",
       "1: the column y_radius of the schema is missing"},
      {"t,phase,yy,y_radius\n0,stick,0,0\n",
       "3ed3e0519462675b07a55a53425dc0388e5a61d3e3f889b6017f6de839983193",
       "1, column 3 (yy): the name of the column is 'yy', but must be y as in the schema"},
      {"t,phase,y,y_radius\n", "6e88325a028eb9352b668ddea29195cce9d92560975c880673ea080ffa86fe2d",
       "1: the table has no rows, but must have at least one"},
      {"t,phase,y,y_radius\n0,stick,0,1e-9\n0.1,stick,0\n",
       "de26ae500c8e5f6884c29b4c90766ab32087ddb4db7c5ee1f22e5f29e15753ae",
       "3: the line has 3 cells, but must have 4 as the line of names has"},
      {"t,phase,y,y_radius\n0,stick,0,1e-9,\n",
       "225ebd41b29bf165cf1f792e9a6aee7411613e5a73ab0169a568f24c0cdd9e46",
       "2: the line has 5 cells, but must have 4 as the line of names has"},
      {"t,phase,y,y_radius\n0,stick,1.0x,1e-9\n",
       "5622ed0d6978f08f17adf68922a565e610453933f8ed980c1e078485bd89e692",
       "2, column 3 (y): y is '1.0x', but must be a finite number"},
      {"t,phase,y,y_radius\n0,stick,nan,1e-9\n",
       "2e0b3b49524bedc43ddb72c559f1bb151473c378b4e880fdbb20afd1440ca591",
       "2, column 3 (y): y is 'nan', but must be a finite number"},
      {"t,phase,y,y_radius\n0,stick,inf,1e-9\n",
       "e4bfacd810fff2c9241dbdf46d95e9f7179eb39c6ab6bf53e5036d372d6f3655",
       "2, column 3 (y): y is 'inf', but must be a finite number"},
      {"t,phase,y,y_radius\n0,stick,1e999,1e-9\n",
       "d6a9cf9fbe19a02db6082658a4d8f5eb3f36703319f43badbe4ce9a2abe73c7d",
       "2, column 3 (y): y is '1e999', but must be a finite number"},
      {"t,phase,y,y_radius\n0,stick,0,-1e-9\n",
       "22e43ef3b6050347f63cc0a27d7ddedb0c0910de3a4eef1deb4d2caf437c8211",
       "2, column 4 (y_radius): y_radius is '-1e-9', but must be a number that is not negative"},
      {"t,phase,y,y_radius\n0,stick,0,nan\n",
       "48b5361b00a36cd0414140181ed0f5c907c280e18f530add13505faaf79978e9",
       "2, column 4 (y_radius): y_radius is 'nan', but must be a finite number"},
      {"t,phase,y,y_radius\n0,stick,0,\n", "dd347b080895c0f319980f6da16d82b538af1f5b6b538e6e698dc5ce607ff77f",
       "2, column 4 (y_radius): y_radius is '', but must be empty exactly where y is"},
      {"t,phase,y,y_radius\n0,stick,,1e-9\n",
       "e15ac334df24253744aa79be1deadc4a10230c8f050201759563675fad90cd41",
       "2, column 4 (y_radius): y_radius is '1e-9', but must be empty exactly where y is"},
      {"t,phase,y,y_radius\n0,,0,1e-9\n", "26e6e9b058e170db15ef2a8ef3daf1707575d4bae668ab6c0d5e112702a5bc0d",
       "2, column 2 (phase): phase is '', but must be a value"},
      {"t,phase,y,y_radius\n,stick,0,1e-9\n",
       "609d4b4052f28eefc959dcf680bedc5057283705608e7bbe1bb31d727a1bd072",
       "2, column 1 (t): t is '', but must be a value"},
      {"t,phase,y,y_radius\n0,stick,0,1e-9\n0.1,stick,0,1e-9\n0,slip,0,1e-9\n",
       "4a021096c1eacff765979318da054269461ca7d52b38cfde9b18c6cdbf8035d1",
       "4: the primary key t stands in line 2 already, but must stand once"},
      {"t,phase,y,y_radius\n0.1,stick,0,1e-9\n0.10000000000001,stick,0,1e-9\n",
       "6b601f7cad52053e8677314ca2c701c958cd3db829e52bd33b33882fb330d238",
       "3: the primary key t stands in line 2 already, but must stand once"},
  };
  for (const auto& [csv, digest, sentence] : tables) {
    json package = valid_package();
    write_package(package);
    package = json::parse(std::ifstream(folder() / "datapackage.json"));
    package["resources"][0]["bytes"] = csv.size();
    package["resources"][0]["hash"] = "sha256:" + digest;
    write("datapackage.json", package.dump());
    write("history.csv", csv);
    EXPECT_EQ(error_message("history"), "history.csv:" + sentence);
  }
}

STICKSLIP_VERIFIES(ReferenceKeys, "P5");
TEST(ReferenceKeys, AreTheSameTo1e9) {
  EXPECT_TRUE(data::is_same_key(25.0, 25.0 * (1.0 + 0.9e-9)));
  EXPECT_FALSE(data::is_same_key(25.0, 25.0 * (1.0 + 1.1e-9)));
  EXPECT_TRUE(data::is_same_key(0.0, 0.0));
  EXPECT_FALSE(data::is_same_key(0.0, 1e-300));
  EXPECT_FALSE(data::is_same_key(1.0, -1.0));
}

}  // namespace
}  // namespace stickslip::testing
