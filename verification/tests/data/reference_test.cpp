// SPDX-License-Identifier: MIT
/// The reader of the published reference data: what it returns, and that a package with any defect is refused
/// in one sentence that names the file and the place in it.

#include <nlohmann/json.hpp>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/reference.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

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

class ReferenceReader : public ::testing::Test {
 protected:
  ReferenceReader() {
    folder_.write("history.csv", valid_history);
    folder_.write("events.csv", valid_events);
  }

  // Writes the package with the size and the digest of these tables.
  void write_package(json package, const std::string& history = valid_history) const {
    const auto sign = [&](std::size_t i, const std::string& csv) {
      if (!package.contains("resources") || package["resources"].size() <= i) return;
      package["resources"][i]["bytes"] = csv.size();
      package["resources"][i]["hash"] = "sha256:" + data::sha256(csv);
    };
    sign(0, history);
    sign(1, valid_events);
    folder_.write("datapackage.json", package.dump(1));
  }

  // The sentence that refuses the package or one of its tables, or "accepted".
  [[nodiscard]] std::string error_message(const std::string& table = "") const {
    return folder_.error_message([&] {
      const auto package = data::load_reference(folder());
      if (!table.empty()) static_cast<void>(data::read_table(package, table));
    });
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

  const InputFolder folder_;
};

STICKSLIP_VERIFIES(ReferenceReader, "P5");
TEST_F(ReferenceReader, ReturnsWhatAPackageSays) {
  write_package(valid_package());
  const auto package = data::load_reference(folder());
  EXPECT_EQ(package.name, "small");
  EXPECT_EQ(package.title, "Small");
  EXPECT_EQ(package.description, "For a test");
  EXPECT_EQ(package.version, "1.0.0");
  ASSERT_EQ(package.resources.size(), 2u);
  const data::Resource &history = package.resource("history"), &events = package.resource("events");
  EXPECT_EQ(history.field("z"), nullptr);
  EXPECT_FALSE(history.field("y_radius")->value_class.has_value());
  EXPECT_FALSE(history.field("y")->required);
  EXPECT_EQ(history.stated.beam, "paper");
  EXPECT_EQ(history.stated.tip, "friction");
  EXPECT_EQ(history.stated.numbers,
            (std::map<std::string, double>{{"duration", 0.4}, {"excitation.amplitude", 1e-3}}));
  EXPECT_EQ(history.primary_key, std::vector<std::string>{"t"});
  EXPECT_EQ(events.primary_key, std::vector<std::string>{"index"});
  EXPECT_EQ(events.problem, "");
  EXPECT_FALSE(events.diagnosis.has_value());
}

// Reading and writing are one list of members; what is written is compared with the structs in package_test.cpp.
TEST_F(ReferenceReader, WritesAgainWhatItHasRead) {
  for (const auto& package : {data::load_reference(fixture), data::load_reference()}) {
    const json resources = json::parse(std::ifstream(package.folder / "datapackage.json"))["resources"];
    ASSERT_EQ(resources.size(), package.resources.size());
    for (std::size_t i = 0; i < resources.size(); ++i)
      EXPECT_EQ(json::parse(data::json_text(package.resources[i])), resources[i]);
  }
}

TEST_F(ReferenceReader, KeepsEveryDigit) {
  const auto table = data::read_table(data::load_reference(fixture), "stick-frequencies");
  ASSERT_EQ(table.rows(), 12u);
  const auto& frequency = table.column("frequency");
  EXPECT_EQ(frequency.text[0], "24.9719580926706706070503365542");
  EXPECT_EQ(frequency.values[0], 24.9719580926706706070503365542);
  EXPECT_TRUE(std::isnan(table.column("beam").values[0]));
  EXPECT_EQ(table.radius_of("frequency")[2], 1e-26);
  EXPECT_EQ(table.radius_of("mode"), std::vector<double>(12, 0.0));
  EXPECT_THROW((void)table.column("none"), std::out_of_range);
}

TEST_F(ReferenceReader, TakesAnEmptyCellForNoValue) {
  write_package(valid_package());
  const auto table = data::read_table(data::load_reference(folder()), "history");
  ASSERT_EQ(table.rows(), 3u);
  EXPECT_EQ(table.csv, valid_history);
  EXPECT_EQ(table.column("y").values[1], 1e-3);
  EXPECT_TRUE(std::isnan(table.column("y").values[2]));
  EXPECT_TRUE(std::isnan(table.radius_of("y")[2]));
}

TEST_F(ReferenceReader, NamesTheValueThatIsWrong) {
  const auto nested = [](std::size_t levels) {
    return std::string(levels, '[') + "1" + std::string(levels, ']');
  };
  for (const auto& [text, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"{\n \"name\": \"small\",\n  oops\n}\n", "is not valid JSON: parse error at line 3, column 3: "},
           {R"({"name": -1e999})", "holds a number that no double holds: number overflow parsing '-1e999'"},
           {nested(100), "the package is an array, but must be an object"},
           {nested(101), "is nested deeper than the 100 levels that are allowed"}}) {
    folder_.write("datapackage.json", text);
    EXPECT_TRUE(error_message().starts_with("datapackage.json: " + sentence)) << error_message();
  }
  std::filesystem::remove(folder() / "datapackage.json");
  EXPECT_EQ(error_message(), "datapackage.json: cannot be opened for reading");
}

// A value of the package that is replaced, a part of the sentence that refuses it, and a second value. A place is a JSON
// pointer, which begins at the history unless it begins with "/"; a value is JSON, or empty to erase the key.
struct Defect {
  std::string place, value, part, other_place{}, other_value{};
};

json spoiled(const Defect& defect) {
  json package = valid_package();
  for (const auto& [place, value] :
       {std::pair{defect.place, defect.value}, {defect.other_place, defect.other_value}}) {
    const json::json_pointer at(place.starts_with('/') ? place : "/resources/0/" + place);
    if (place.empty()) continue;
    if (value.empty())
      package[at.parent_pointer()].erase(at.back());
    else
      package[at] = json::parse(value);
  }
  return package;
}

const std::vector<Defect> defects{
    {"/licenses", "[]", "licenses is an array, but must be an array that"},
    {"/resources", "[]", "resources is an array, but must be an array"},
    {"/resources/1/name", R"("history")", "name stands twice: history"},
    {"path", R"("../history.csv")", "path is \"../history.csv\", but must be a path inside"},
    {"path", R"("/etc/passwd")", "but must be a path inside"},
    {"format", R"("xlsx")", "\"xlsx\", but must be one of csv"},
    {"encoding", R"("latin1")", "but must be one of utf-8"},
    {"profile", R"("data-resource")", "tabular-data-resource"},
    {"schema/fields", "[]", "an array of fields that is not empty"},
    {"schema/fields/2/name", R"("t")", "schema/fields/t/name stands twice: t"},
    {"schema/fields/0/type", R"("float")", "\"float\", but must be one of string, integer, number"},
    {"schema/fields/2/class", R"("good")", "but must be one of enclosed, exact, converged, external"},
    {"schema/fields/1/class", R"("exact")", "has a class, but holds words"},
    {"schema/fields/0/constraints/enum", R"(["a"])", "but must be an array of the words of a field of words"},
    {"schema/fields/2/class", R"("converged")", "y is converged, but the schema lacks",
     "schema/fields/3/name", R"("radius")"},
    {"schema/fields/2/class", R"("enclosed")", "y is enclosed, but the schema lacks", "schema/fields/3/name",
     R"("radius")"},
    {"schema/fields/2/class", "", "is the radius of no field", "schema/fields/3/name", R"("z_radius")"},
    {"schema/fields/3/type", R"("string")", "schema/fields/y_radius is a radius, but holds words"},
    {"schema/fields/3/unit", R"("mm")", "has the unit 'mm', but must have that of y, 'm'"},
    {"schema/primaryKey", R"(["tt"])", "primaryKey/0 is \"tt\", but must be a field of the schema: t, phase"},
    {"schema/foreignKeys/0/fields", R"("tt")", "/0/fields is \"tt\", but must be a field of the schema"},
    {"schema/foreignKeys/0/reference/resource", R"("none")", "is no column of the package: none/time"},
    {"schema/foreignKeys/0/reference/fields", R"("none")", "is no column of the package: events/none"},
    {"schema/fields/1/name", R"("state")", "the schema lacks the field phase"},
    {"/resources/1/schema/fields/1/name", R"("kind")", "the schema lacks the field change"},
    {"comparison/kind", R"("list")", "one of table, curve, events, phases"},
    {"comparison/kind", R"("table")", "the schema lacks a primaryKey", "schema/primaryKey", ""},
    {"comparison/values", "[]", "values is an array, but must be an array"},
    {"comparison/values/0/field", R"("y_radiu")", "a field of the schema (did you mean y_radius?)"},
    {"comparison/values/0/field", R"("phase")", "but must be a field of numbers"},
    {"comparison/values/0/norm", R"("word")", "field is \"y\", but must be a column of words"},
    {"comparison/values/0/norm", R"("l2")", "one of relative, scale, absolute, range"},
    {"comparison/values/-", R"({"field": "phase", "norm": "word", "tolerance": 0})",
     "must be table or events"},
    {"comparison/values/0/decided_by", R"({"field": "y", "threshold": 1})", "decided_by is for words only"},
    {"/resources/1/comparison/values/-",
     R"({"field": "change", "norm": "word", "tolerance": 0, "decided_by": {"threshold": 1}})",
     "comparison/values/1/decided_by lacks field"},
    {"comparison/values/-",
     R"({"field": "phase", "norm": "word", "tolerance": 0, "decided_by": {"field": "t", "threshold": 1}})",
     "but must be one of the compared values"},
    {"comparison/abscissa", R"("time")", "a field of the schema"},
    {"comparison/interpolation/order", "10", "an integer from 1 to 9"},
    {"comparison/interpolation/order", "2.5", "2.5, but must be an integer"},
    {"comparison/interpolation/error/y_radiu", "1", "is of no field of the schema (did you mean y_radius?)"},
    {"comparison/interpolation/error/y", "", "lacks y, which is compared"},
    {"comparison/kind", R"("table")", "comparison/abscissa is given, but must be missing for the kind table"},
    {"comparison/kind", R"("table")", "interpolation is given, but must", "comparison/abscissa", ""},
    {"/resources/1/comparison/interpolation", R"({"order": 3, "error": {"time": 1e-9}})",
     "interpolation is given"},
    {"/resources/1/comparison/events", R"("events")", "events/comparison/events is given, but must be"},
    {"/resources/1/comparison/kind", R"("table")", "shortest_phase is given, but must be missing"},
    {"/resources/1/comparison/kind", R"("table")", "horizon is given", "/resources/1/comparison/horizon",
     "1"},
    {"comparison/shortest_phase", "1e-5", "shortest_phase is given, but must be missing for the kind phases"},
    {"comparison/events", R"("changes")", "a resource of the kind events"},
    {"comparison/events", R"("history")", "a resource of the kind events"},
    {"problem/tip", R"("loose")", "problem/tip is \"loose\", but must be one of held, free, friction"},
    {"problem/exitation", "1", "problem/exitation is unknown (did you mean excitation?)"},
    {"problem/beam", R"({"column": "beam"})", "problem/beam/column is \"beam\", but must be a field"},
    {"problem/modes", "[1, 2]", "problem/modes is an array, but must be a number, a word or an object"},
    {"problem/duration", "0", "problem/duration is 0, but must be a number above 0"},
    {"diagnosis/case", R"({"column": "beam"})", "case/column is \"beam\", but must be a field of the schema"},
    {"provenance/settings", R"("none")", "settings is \"none\", but must be an object"},
    {"provenance/checks", "[]", "checks is an array, but"},
    {"provenance/method", R"("")", "method is \"\", but must be a string"}};

TEST_F(ReferenceReader, AcceptsWhatIsJustAllowed) {
  for (const auto& [place, value] :
       std::vector<std::pair<std::string, std::string>>{{"comparison/interpolation/order", "1"},
                                                        {"comparison/interpolation/order", "9"},
                                                        {"schema/primaryKey", ""}}) {
    write_package(spoiled({place, value, ""}));
    EXPECT_EQ(error_message("history"), "accepted") << place;
    EXPECT_EQ(error_message("events"), "accepted") << place;
  }
}

// PackageKeys in input_matrix_test.cpp leaves out each key of a published package, and gives it values of the wrong
// type, sign or size.
TEST_F(ReferenceReader, RefusesADefectOfAPackage) {
  for (const Defect& defect : defects) {
    write_package(spoiled(defect));
    const std::string sentence = error_message();
    EXPECT_TRUE(holds(sentence, defect.part)) << defect.place << " " << defect.value;
    EXPECT_TRUE(sentence.starts_with("datapackage.json: ")) << sentence;
  }
}

// By another program, from FIPS 180-4.
STICKSLIP_VERIFIES(Sha256, "P5");
TEST(Sha256, IsThatOfAnotherProgram) {
  EXPECT_EQ(data::sha256(valid_history), "de909ee5ca04e29fcb804619937393d0b8c460b858250d1d59d68f38a9175d0e");
  EXPECT_EQ(data::sha256(valid_events), "7c166cea6316dda398d3414823a7a0aec171f215f74593818eea2c2a61a697ab");
}

TEST_F(ReferenceReader, RefusesFalseDigestsAndSizes) {
  const std::string digest = "resources/history/hash is \"";
  for (const auto& [key, value, sentence] : std::vector<std::tuple<const char*, json, std::string>>{
           {"hash", "sha256:12", digest},
           {"hash", "md5:" + std::string(64, '0'), digest},
           {"hash", "", digest},
           {"hash", "sha256:" + std::string(64, 'g'), digest},
           {"hash", nullptr, "resources/history lacks hash"},
           {"bytes", nullptr, "resources/history lacks bytes"},
           {"bytes", 0, "resources/history/bytes is 0, but must be an integer above 0"},
           {"bytes", "12", "resources/history/bytes is \"12\", but must be an integer"},
           {"bytes", 7,
            "its size is 65 bytes, but must be 7 as in datapackage.json: the file has been altered"},
           {"hash", "sha256:" + std::string(64, '0'), "its SHA-256 digest is "}}) {
    write_package(valid_package());
    json package = json::parse(std::ifstream(folder() / "datapackage.json"));
    package["resources"][0][key] = value;
    if (value.is_null()) package["resources"][0].erase(key);
    folder_.write("datapackage.json", package.dump(1));
    EXPECT_TRUE(holds(error_message("history"), ": " + sentence));
  }
}

TEST_F(ReferenceReader, RefusesADefectOfATable) {
  const std::string names = "t,phase,y,y_radius\n", good = names + "0.1,stick,0,1e-9\n";
  for (const auto& [csv, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"t,phase,y\n0,stick,0\n", "1: the column y_radius of the schema is missing"},
           {"t,phase,y,y_radius,z\n0,stick,0,0,1\n",
            "1, column 5 (z): the name of the column is 'z', but the schema has no further column"},
           {names, "1: the table has no rows, but must have at least one"},
           {names + "0,stick,0,1e-9,\n", "2: the line has 5 cells, but must have 4 as the line of names has"},
           {names + "0,stick,0,\n",
            "2, column 4 (y_radius): y_radius is '', but must be empty exactly where y is"},
           {names + "0,stick,,1e-9\n",
            "2, column 4 (y_radius): y_radius is '1e-9', but must be empty exactly where y is"},
           {names + "0,,0,1e-9\n", "2, column 2 (phase): phase is '', but must be a value"},
           {names + "0,stuck,0,1e-9\n",
            "2, column 2 (phase): phase is 'stuck', but must be one of stick, slip"},
           {names + ",stick,0,1e-9\n", "2, column 1 (t): t is '', but must be a value"},
           {good + "0.2,stick,0,1e-9\n0.1,slip,0,1e-9\n",
            "4: the primary key t stands in line 2 already, but must stand once"},
           {good + "0.10000000000001,stick,0,1e-9\n",
            "3: the primary key t stands in line 2 already, but must stand once"}}) {
    write_package(valid_package(), csv);
    folder_.write("history.csv", csv);
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
