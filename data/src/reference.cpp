// SPDX-License-Identifier: MIT
#include "stickslip/data/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "json_file.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/sha256.hpp"

namespace stickslip::data {

namespace {

constexpr std::string_view radius_suffix = "_radius";

template <std::size_t N>
std::vector<std::string> words(const std::array<std::string_view, N>& names) {
  return {names.begin(), names.end()};
}

ValueClass value_class_of(const JsonNode& node) {
  return static_cast<ValueClass>(node.one_of(words(value_class_names)));
}

std::string optional_text(const JsonNode& node, const std::string& key) {
  const auto member = node.find(key);
  return member ? member->text() : "";
}

template <class Named>  // Field, Resource
std::vector<std::string> names_of(const std::vector<Named>& items) {
  std::vector<std::string> names;
  for (const Named& item : items) names.push_back(item.name);
  return names;
}

// The name of a column that the schema has.
std::string column_in(const Resource& resource, const JsonNode& node) {
  std::string name = node.text();
  if (resource.field(name) == nullptr)
    node.fail_unless("a field of the schema" + suggestion(name, names_of(resource.fields)) + ": " +
                     joined(names_of(resource.fields)));
  return name;
}

std::string number_column_in(const Resource& resource, const JsonNode& node) {
  std::string name = column_in(resource, node);
  if (resource.field(name)->type == FieldType::string) node.fail_unless("a field of numbers");
  return name;
}

Field field_of(const JsonNode& node) {
  node.require_spelling({"name", "type", "unit", "description", "class", "constraints", "title", "format"});
  Field field;
  field.name = node.at("name").text();
  field.type = static_cast<FieldType>(node.at("type").one_of({"string", "integer", "number"}));
  field.unit = optional_text(node, "unit");
  field.description = optional_text(node, "description");
  if (const auto value_class = node.find("class")) field.value_class = value_class_of(*value_class);
  if (const auto constraints = node.find("constraints")) {
    constraints->require_spelling(
        {"required", "unique", "minimum", "maximum", "minLength", "maxLength", "pattern", "enum"});
    if (const auto required = constraints->find("required")) field.required = required->flag();
    if (const auto allowed = constraints->find("enum")) {
      field.allowed = allowed->texts();
      if (field.allowed.empty() || field.type != FieldType::string)
        allowed->fail_unless("an array of the words of a field of words");
    }
  }
  return field;
}

// A radius for each value that needs one, in its unit, and none without a value.
void require_radii(const Resource& resource, const std::vector<JsonNode>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Field& field = resource.fields[i];
    const bool is_radius = field.name.ends_with(radius_suffix);
    if (is_radius) {
      const Field* value =
          resource.field(std::string_view(field.name).substr(0, field.name.size() - radius_suffix.size()));
      if (value == nullptr) nodes[i].fail("is the radius of no field: " + field.name);
      if (field.type == FieldType::string) nodes[i].fail("is a radius, but holds words");
      if (value->unit != field.unit)
        nodes[i].fail("has the unit '" + field.unit + "', but must have that of " + value->name + ", '" +
                      value->unit + "'");
    }
    const bool needs_one =
        field.value_class == ValueClass::enclosed || field.value_class == ValueClass::converged;
    if (needs_one && resource.field(field.name + std::string(radius_suffix)) == nullptr)
      nodes[i].fail("is " + std::string(to_string(*field.value_class)) + ", but the schema lacks " +
                    field.name + std::string(radius_suffix));
    if (field.value_class && field.type == FieldType::string) nodes[i].fail("has a class, but holds words");
  }
}

ForeignKey foreign_key_of(const JsonNode& node, const Resource& resource) {
  node.require_spelling({"fields", "reference"});
  const JsonNode reference = node.at("reference");
  reference.require_spelling({"resource", "fields"});
  return {.column = column_in(resource, node.at("fields")),
          .resource = reference.at("resource").text(),
          .reference_column = reference.at("fields").text()};
}

void read_schema(const JsonNode& schema, Resource& resource) {
  schema.require_spelling({"fields", "primaryKey", "foreignKeys", "missingValues"});
  const auto nodes = schema.at("fields").elements();
  if (nodes.empty()) schema.at("fields").fail_unless("an array of fields that is not empty");
  for (const JsonNode& node : nodes) {
    Field field = field_of(node);
    if (resource.field(field.name) != nullptr) node.at("name").fail("stands twice: " + field.name);
    resource.fields.push_back(std::move(field));
  }
  require_radii(resource, nodes);
  if (const auto keys = schema.find("foreignKeys"))
    for (const JsonNode& node : keys->elements())
      resource.foreign_keys.push_back(foreign_key_of(node, resource));
  const auto key = schema.find("primaryKey");
  if (!key) return;
  if (key->value().is_string()) {
    resource.primary_key = {column_in(resource, *key)};
    return;
  }
  for (const JsonNode& column : key->elements()) resource.primary_key.push_back(column_in(resource, column));
}

double positive(const JsonNode& node) {
  const double value = node.number();
  if (!(value > 0.0)) node.fail_unless("a number above 0");
  return value;
}

double not_negative(const JsonNode& node) {
  const double value = node.number();
  if (!(value >= 0.0)) node.fail_unless("a number that is not negative");
  return value;
}

Interpolation interpolation_of(const JsonNode& node, const Resource& resource) {
  node.require_spelling({"order", "error"});
  Interpolation interpolation;
  const JsonNode order = node.at("order");
  if (order.integer() < 1 || order.integer() > 9) order.fail_unless("an integer from 1 to 9");
  interpolation.order = static_cast<int>(order.integer());
  for (const auto& [field, bound] : node.at("error").members()) {
    if (resource.field(field) == nullptr)
      bound.fail("is of no field of the schema" + suggestion(field, names_of(resource.fields)));
    interpolation.error[field] = not_negative(bound);
  }
  return interpolation;
}

ComparedValue compared_value_of(const JsonNode& node, const Resource& resource) {
  node.require_spelling({"field", "norm", "tolerance", "decided_by"});
  ComparedValue value;
  value.norm = static_cast<Norm>(node.at("norm").one_of(words(norm_names)));
  value.tolerance = not_negative(node.at("tolerance"));
  const JsonNode field = node.at("field");
  if (value.norm != Norm::word) {
    if (const auto deciding = node.find("decided_by")) deciding->fail("is for words only");
    value.field = number_column_in(resource, field);
    return value;
  }
  value.field = column_in(resource, field);
  if (resource.field(value.field)->type != FieldType::string) field.fail_unless("a column of words");
  if (const auto deciding = node.find("decided_by")) {
    deciding->require_spelling({"field", "threshold"});
    value.decided_by = {.field = number_column_in(resource, deciding->at("field")),
                        .threshold = deciding->at("threshold").number()};
  }
  return value;
}

// The columns that a comparison of this kind works on.
void require_columns(ComparisonKind kind, const JsonNode& node, const Resource& resource) {
  if (kind == ComparisonKind::table && resource.primary_key.empty())
    node.fail("is of the kind table, but the schema lacks a primaryKey");
  const auto require = [&](const char* column) {
    if (resource.field(column) == nullptr)
      node.fail("is of the kind " + std::string(to_string(kind)) + ", but the schema lacks the field " +
                column);
  };
  if (kind == ComparisonKind::events)
    for (const char* column : {"change", "time"}) require(column);
  if (kind == ComparisonKind::phases) require("phase");
}

// Every key is one that a comparison of this kind uses.
void require_keys_of(ComparisonKind kind, const JsonNode& node) {
  using enum ComparisonKind;
  const std::vector<std::pair<std::string, std::vector<ComparisonKind>>> kinds_of_key{
      {"abscissa", {curve, phases}},
      {"interpolation", {curve, phases}},
      {"events", {phases}},
      {"horizon", {curve, events, phases}},
      {"shortest_phase", {events}}};
  for (const auto& [key, kinds] : kinds_of_key)
    if (const auto member = node.find(key); member && std::ranges::count(kinds, kind) == 0)
      member->fail("is given, but must be missing for the kind " + std::string(to_string(kind)));
}

ComparisonRule comparison_of(const JsonNode& node, const Resource& resource) {
  node.require_spelling(
      {"kind", "values", "abscissa", "interpolation", "events", "horizon", "shortest_phase"});
  ComparisonRule rule;
  rule.kind = static_cast<ComparisonKind>(node.at("kind").one_of(words(comparison_kind_names)));
  require_columns(rule.kind, node, resource);
  require_keys_of(rule.kind, node);
  const auto values = node.at("values").elements();
  if (values.empty()) node.at("values").fail_unless("an array that is not empty");
  for (const JsonNode& value : values) rule.values.push_back(compared_value_of(value, resource));
  for (const JsonNode& value : values)
    if (const auto deciding = value.find("decided_by"))
      if (std::ranges::count(rule.values, deciding->at("field").text(), &ComparedValue::field) == 0)
        deciding->at("field").fail_unless("one of the compared values");
  const bool is_sampled = rule.kind == ComparisonKind::curve || rule.kind == ComparisonKind::phases;
  if (is_sampled) rule.abscissa = number_column_in(resource, node.at("abscissa"));
  if (is_sampled && std::ranges::count(rule.values, Norm::word, &ComparedValue::norm) > 0)
    node.at("kind").fail_unless("table or events, because words are compared");
  if (const auto interpolation = node.find("interpolation")) {
    rule.interpolation = interpolation_of(*interpolation, resource);
    for (const ComparedValue& value : rule.values)
      if (!rule.interpolation->error.contains(value.field))
        interpolation->at("error").fail("lacks " + value.field + ", which is compared");
  }
  if (rule.kind == ComparisonKind::phases) rule.events = node.at("events").text();
  if (const auto horizon = node.find("horizon")) rule.horizon = positive(*horizon);
  if (const auto shortest = node.find("shortest_phase")) rule.shortest_phase = not_negative(*shortest);
  return rule;
}

DiagnosisRule diagnosis_of(const JsonNode& node, const Resource& resource) {
  node.require_spelling({"quantity", "case", "abscissa", "value"});
  DiagnosisRule rule;
  rule.quantity = node.at("quantity").text();
  if (const JsonNode problem = node.at("case"); problem.value().is_object()) {
    problem.require_spelling({"column"});
    rule.case_column = column_in(resource, problem.at("column"));
  } else {
    rule.case_name = problem.text();
  }
  rule.abscissa = number_column_in(resource, node.at("abscissa"));
  rule.value = number_column_in(resource, node.at("value"));
  return rule;
}

// Numbers, words, columns that the schema has, and objects of them.
void require_problem(const JsonNode& node, const Resource& resource) {
  node.require_spelling({"beam", "tip", "excitation", "damping", "friction", "initial_state", "modes",
                         "duration", "column", "frequency_hz", "amplitude", "kelvin_voigt",
                         "static_coefficient", "kinetic_coefficient", "decay", "shear_coefficient",
                         "poisson_ratio"});
  if (const auto tip = node.find("tip")) static_cast<void>(tip->one_of({"held", "free", "friction"}));
  if (const auto duration = node.find("duration"); duration && !duration->value().is_object())
    static_cast<void>(positive(*duration));
  for (const auto& [key, member] : node.members()) {
    if (key == "column")
      static_cast<void>(column_in(resource, member));
    else if (member.value().is_object())
      require_problem(member, resource);
    else if (!member.value().is_number() && !member.value().is_string())
      member.fail_unless("a number, a word or an object");
  }
}

StatedProblem stated_problem(const JsonNode& node) {
  StatedProblem stated;
  for (const auto& [key, member] : node.members()) {
    if (member.value().is_string() && key == "beam") stated.beam = member.text();
    if (member.value().is_string() && key == "tip") stated.tip = member.text();
    if (!member.value().is_object()) continue;
    for (const auto& [name, number] : member.members())
      if (number.value().is_number()) stated.numbers[key + "." + name] = number.value().get<double>();
  }
  return stated;
}

Provenance provenance_of(const JsonNode& node) {
  node.require_spelling({"class", "method", "settings", "software", "checks"});
  Provenance provenance;
  provenance.value_class = value_class_of(node.at("class"));
  provenance.method = node.at("method").text();
  if (const JsonNode settings = node.at("settings"); settings.value().is_object())
    provenance.settings = settings.value().dump();
  else
    settings.fail_unless("an object");
  provenance.software = node.at("software").text();
  provenance.checks = node.at("checks").texts();
  if (provenance.checks.empty()) node.at("checks").fail_unless("an array that is not empty");
  return provenance;
}

// Inside the package.
std::filesystem::path safe_path(const JsonNode& node) {
  std::filesystem::path path = node.text();
  if (path.is_absolute() || std::ranges::count(path, std::filesystem::path("..")) > 0)
    node.fail_unless("a path inside the folder of the package");
  return path;
}

std::string digest_of(const JsonNode& node) {
  constexpr std::string_view method = "sha256:";
  const std::string text = node.text();
  const std::string digest = text.substr(std::min(text.size(), method.size()));
  const bool is_digest =
      digest.size() == 64 && digest.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!text.starts_with(method) || !is_digest) node.fail_unless("sha256: and 64 hexadecimal digits");
  return digest;
}

void require_word(const JsonNode& node, const std::string& key, const std::string& word) {
  if (const auto member = node.find(key)) static_cast<void>(member->one_of({word}));
}

Resource resource_of(const JsonNode& node) {
  node.require_spelling({"name", "path", "profile", "format", "mediatype", "encoding", "bytes", "hash",
                         "title", "description", "problem", "schema", "comparison", "diagnosis", "provenance",
                         "licenses", "sources", "dialect"});
  Resource resource;
  resource.name = node.at("name").text();
  resource.path = safe_path(node.at("path"));
  require_word(node, "profile", "tabular-data-resource");
  require_word(node, "format", "csv");
  require_word(node, "mediatype", "text/csv");
  require_word(node, "encoding", "utf-8");
  const long bytes = node.at("bytes").integer();
  if (bytes < 1) node.at("bytes").fail_unless("an integer above 0");
  resource.bytes = static_cast<std::size_t>(bytes);
  resource.sha256 = digest_of(node.at("hash"));
  resource.title = node.at("title").text();
  resource.description = node.at("description").text();
  read_schema(node.at("schema"), resource);
  if (const auto problem = node.find("problem")) {
    require_problem(*problem, resource);
    resource.problem = problem->value().dump();
    resource.stated = stated_problem(*problem);
  }
  if (const auto comparison = node.find("comparison"))
    resource.comparison = comparison_of(*comparison, resource);
  if (const auto diagnosis = node.find("diagnosis")) resource.diagnosis = diagnosis_of(*diagnosis, resource);
  resource.provenance = provenance_of(node.at("provenance"));
  return resource;
}

void require_licenses(const JsonNode& licenses) {
  const std::vector<std::string> keys{"name", "path", "title"};
  if (licenses.elements().empty()) licenses.fail_unless("an array that is not empty");
  for (const JsonNode& license : licenses.elements()) {
    license.require_spelling(keys);
    for (const std::string& key : keys) static_cast<void>(optional_text(license, key));
  }
}

// The column that a foreign key refers to is there.
void require_reference(const ReferencePackage& package, const JsonNode& node, const ForeignKey& key) {
  const auto other = std::ranges::find(package.resources, key.resource, &Resource::name);
  if (other == package.resources.end() || other->field(key.reference_column) == nullptr)
    node.at("reference").fail("is no column of the package: " + key.resource + "/" + key.reference_column);
}

// Every set of phases has its events, every foreign key its columns, and no name stands twice.
void require_consistent(const ReferencePackage& package, const std::vector<JsonNode>& nodes) {
  std::set<std::string> names;
  for (const JsonNode& node : nodes)
    if (const JsonNode name = node.at("name"); !names.insert(name.text()).second)
      name.fail("stands twice: " + name.text());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Resource& resource = package.resources[i];
    for (std::size_t k = 0; k < resource.foreign_keys.size(); ++k)
      require_reference(package, nodes[i].at("schema").at("foreignKeys").elements()[k],
                        resource.foreign_keys[k]);
    if (!resource.comparison || resource.comparison->events.empty()) continue;
    const auto events = std::ranges::find(package.resources, resource.comparison->events, &Resource::name);
    if (events == package.resources.end() || !events->comparison ||
        events->comparison->kind != ComparisonKind::events)
      nodes[i].at("comparison").at("events").fail_unless("a resource of the kind events");
  }
}

class TableReader {
 public:
  TableReader(const std::filesystem::path& file, const Resource& resource, const std::string& csv)
      : resource_(resource), csv_(file, csv) {}

  [[nodiscard]] std::vector<Column> columns() {
    require_names();
    for (const Field& field : resource_.fields) columns_.push_back({field, {}, {}});
    while (const auto cells = csv_.next_row()) add_row(*cells);
    if (lines_.empty())
      throw InputError(csv_.place(csv_.line()) + ": the table has no rows, but must have at least one");
    require_unique_keys();
    return std::move(columns_);
  }

 private:
  void require_names() const {
    const auto &names = csv_.names(), expected = names_of(resource_.fields);
    for (std::size_t i = 0; i < std::min(names.size(), expected.size()); ++i)
      if (names[i] != expected[i])
        throw InputError(csv_.place(csv_.line_of_names(), i) + ": the name of the column is '" +
                         printable(names[i]) + "', but must be " + expected[i] + " as in the schema");
    if (names.size() > expected.size())
      throw InputError(csv_.place(csv_.line_of_names(), expected.size()) + ": the name of the column is '" +
                       printable(names[expected.size()]) + "', but the schema has no further column");
    if (names.size() < expected.size())
      throw InputError(csv_.place(csv_.line_of_names()) + ": the column " + expected[names.size()] +
                       " of the schema is missing");
  }

  // A table of the package has neither empty lines nor comments, which a user's table may have.
  void require_next_line() const {
    const std::size_t next = (lines_.empty() ? csv_.line_of_names() : lines_.back()) + 1;
    if (csv_.line() != next)
      throw InputError(csv_.place(next) + ": the line is empty or a comment, but must be a row of the table");
  }

  void add_row(const std::vector<std::string>& cells) {
    require_next_line();
    lines_.push_back(csv_.line());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      columns_[i].values.push_back(value_of(i, cells[i]));
      columns_[i].text.push_back(cells[i]);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) require_radius(i, cells);
  }

  [[nodiscard]] double value_of(std::size_t i, const std::string& cell) const {
    const Field& field = resource_.fields[i];
    const bool is_key = std::ranges::count(resource_.primary_key, field.name) > 0;
    if (cell.empty()) {
      if (field.required || is_key) fail_unless("a value", i, cell);
      return std::numeric_limits<double>::quiet_NaN();
    }
    if (field.type == FieldType::string) {
      if (cell != printable(cell)) fail_unless("a word, in UTF-8 and of 60 bytes at most", i, cell);
      if (!field.allowed.empty() && std::ranges::count(field.allowed, cell) == 0)
        fail_unless("one of " + joined(field.allowed), i, cell);
      return std::numeric_limits<double>::quiet_NaN();
    }
    const auto value = finite_number(cell);
    if (!value) fail_unless("a finite number", i, cell);
    if (field.type == FieldType::integer && *value != std::floor(*value)) fail_unless("an integer", i, cell);
    return *value;
  }

  // A value and its radius are both there or both empty, and the radius is not negative.
  void require_radius(std::size_t i, const std::vector<std::string>& cells) const {
    const std::string& name = resource_.fields[i].name;
    if (!name.ends_with(radius_suffix)) return;
    const auto value =
        std::ranges::find(resource_.fields, name.substr(0, name.size() - radius_suffix.size()), &Field::name);
    if (columns_[i].values.back() < 0.0) fail_unless("a number that is not negative", i, cells[i]);
    if (cells[i].empty() != cells[static_cast<std::size_t>(value - resource_.fields.begin())].empty())
      fail_unless("empty exactly where " + value->name + " is", i, cells[i]);
  }

  void require_unique_keys() const {
    if (resource_.primary_key.empty()) return;
    std::vector<const Column*> key;
    for (const std::string& name : resource_.primary_key)
      key.push_back(&*std::ranges::find(columns_, name, [](const Column& c) { return c.field.name; }));
    if (const auto twice = repeated_key(key))
      throw InputError(csv_.place(lines_[twice->second]) + ": the primary key " +
                       joined(resource_.primary_key) + " stands in line " +
                       std::to_string(lines_[twice->first]) + " already, but must stand once");
  }

  [[noreturn]] void fail_unless(const std::string& allowed, std::size_t i, const std::string& cell) const {
    throw InputError(csv_.place(csv_.line(), i) + ": " + resource_.fields[i].name + " is '" +
                     printable(cell) + "', but must be " + allowed);
  }

  const Resource& resource_;
  CsvReader csv_;
  std::vector<Column> columns_;
  std::vector<std::size_t> lines_;  // of each row
};

}  // namespace

const Field* Resource::field(std::string_view column) const {
  const auto found = std::ranges::find(fields, column, &Field::name);
  return found == fields.end() ? nullptr : &*found;
}

const Resource& ReferencePackage::resource(const std::string& wanted) const {
  const auto found = std::ranges::find(resources, wanted, &Resource::name);
  if (found == resources.end())
    throw InputError("the data set " + (wanted.empty() ? "\"\"" : printable(wanted)) + " is unknown" +
                     suggestion(wanted, names_of(resources)) + ", but must be one of " +
                     joined(names_of(resources)));
  return *found;
}

const Column& ReferenceTable::column(std::string_view name) const {
  const auto found =
      std::ranges::find(columns, name, [](const Column& c) { return std::string_view(c.field.name); });
  if (found == columns.end())
    throw std::out_of_range("no column " + std::string(name) + " in " + resource.name);
  return *found;
}

std::vector<double> ReferenceTable::radius_of(const std::string& column_name) const {
  const std::string radius = column_name + std::string(radius_suffix);
  if (resource.field(radius) == nullptr) return std::vector<double>(rows(), 0.0);
  return column(radius).values;
}

std::filesystem::path reference_directory() { return data_directory() / "reference"; }

ReferencePackage load_reference(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "datapackage.json";
  const nlohmann::json json = read_json(file);
  const JsonNode root(file, json);
  root.require_spelling({"profile", "name", "id", "title", "description", "version", "licenses", "resources",
                         "homepage", "created", "keywords", "contributors", "sources", "image"});
  ReferencePackage package{.folder = folder,
                           .name = root.at("name").text(),
                           .title = root.at("title").text(),
                           .description = root.at("description").text(),
                           .version = root.at("version").text(),
                           .resources = {}};
  require_word(root, "profile", "tabular-data-package");
  require_licenses(root.at("licenses"));
  const auto nodes = root.at("resources").elements();
  if (nodes.empty()) root.at("resources").fail_unless("an array that is not empty");
  for (const JsonNode& node : nodes) package.resources.push_back(resource_of(node));
  require_consistent(package, nodes);
  return package;
}

ReferenceTable read_table(const ReferencePackage& package, const std::string& name) {
  const Resource& resource = package.resource(name);
  const std::filesystem::path file = package.folder / resource.path;
  ReferenceTable table{.resource = resource, .csv = read_bounded(file, largest_table), .columns = {}};
  const auto altered = [&](const std::string& what, const std::string& is, const std::string& expected) {
    throw InputError(file.string() + ": " + what + " is " + is + ", but must be " + expected +
                     " as in datapackage.json: the file has been altered");
  };
  if (table.csv.size() != resource.bytes)
    altered("its size", std::to_string(table.csv.size()) + " bytes", std::to_string(resource.bytes));
  if (const std::string digest = sha256(table.csv); digest != resource.sha256)
    altered("its SHA-256 digest", digest, resource.sha256);
  table.columns = TableReader(file, resource, table.csv).columns();
  return table;
}

bool is_same_key(double a, double b) {
  constexpr double tolerance = 1e-9;
  return a == b || std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

std::optional<Twice> repeated_key(const std::vector<const Column*>& key) {
  const auto is_word = [](const Column* column) { return column->field.type == FieldType::string; };
  const auto is_before = [&](std::size_t a, std::size_t b) {
    for (const Column* column : key) {
      const auto& [field, text, values] = *column;
      if (is_word(column) ? text[a] != text[b] : values[a] != values[b])
        return is_word(column) ? text[a] < text[b] : values[a] < values[b];
    }
    return false;
  };
  const auto is_same = [&](std::size_t a, std::size_t b) {
    return std::ranges::all_of(key, [&](const Column* column) {
      return is_word(column) ? column->text[a] == column->text[b]
                             : is_same_key(column->values[a], column->values[b]);
    });
  };
  std::vector<std::size_t> order(key.front()->text.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, is_before);
  const auto twice = std::ranges::adjacent_find(order, is_same);
  if (twice == order.end()) return std::nullopt;
  return Twice{std::min(*twice, *(twice + 1)), std::max(*twice, *(twice + 1))};
}

}  // namespace stickslip::data
