// SPDX-License-Identifier: MIT
#include "stickslip/data/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

#include "json_file.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace {

constexpr std::string_view radius_suffix = "_radius";

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

const Field& require_column(const Resource& resource, const JsonNode& node) {
  const std::string name = node.text();
  const Field* const field = resource.field(name);
  if (field == nullptr)
    node.fail_unless("a field of the schema" + suggestion(name, names_of(resource.fields)) + ": " +
                     joined(names_of(resource.fields)));
  return *field;
}

void require_number_column(const Resource& resource, const JsonNode& node) {
  if (require_column(resource, node).type == FieldType::string) node.fail_unless("a field of numbers");
}

void require_positive(const JsonNode& node) {
  if (!(node.number() > 0.0)) node.fail_unless("a number above 0");
}

void require_not_negative(const JsonNode& node) {
  if (!(node.number() >= 0.0)) node.fail_unless("a number that is not negative");
}

std::vector<JsonNode> require_elements(const JsonNode& node,
                                       const char* allowed = "an array that is not empty") {
  auto elements = node.elements();
  if (elements.empty()) node.fail_unless(allowed);
  return elements;
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

void check_schema(const JsonNode& schema, const Resource& resource) {
  const auto nodes = require_elements(schema.at("fields"), "an array of fields that is not empty");
  std::set<std::string> names;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Field& field = resource.fields[i];
    if (!names.insert(field.name).second) nodes[i].at("name").fail("stands twice: " + field.name);
    const auto constraints = nodes[i].find("constraints");
    const auto allowed = constraints ? constraints->find("enum") : std::nullopt;
    if (allowed && (field.allowed.empty() || field.type != FieldType::string))
      allowed->fail_unless("an array of the words of a field of words");
  }
  require_radii(resource, nodes);
  if (const auto keys = schema.find("foreignKeys"))
    for (const JsonNode& node : keys->elements()) require_column(resource, node.at("fields"));
  const auto key = schema.find("primaryKey");
  if (!key) return;
  if (key->value().is_string())
    require_column(resource, *key);
  else
    for (const JsonNode& column : key->elements()) require_column(resource, column);
}

void check_interpolation(const JsonNode& node, const Resource& resource) {
  const JsonNode order = node.at("order");
  if (order.integer() < 1 || order.integer() > 9) order.fail_unless("an integer from 1 to 9");
  for (const auto& [field, bound] : node.at("error").members()) {
    if (resource.field(field) == nullptr)
      bound.fail("is of no field of the schema" + suggestion(field, names_of(resource.fields)));
    require_not_negative(bound);
  }
  for (const ComparedValue& value : resource.comparison->values)
    if (!resource.comparison->interpolation->error.contains(value.field))
      node.at("error").fail("lacks " + value.field + ", which is compared");
}

void check_compared_value(const JsonNode& node, const ComparedValue& value, const Resource& resource) {
  require_not_negative(node.at("tolerance"));
  const JsonNode field = node.at("field");
  const auto deciding = node.find("decided_by");
  if (value.norm != Norm::word) {
    if (deciding) deciding->fail("is for words only");
    require_number_column(resource, field);
    return;
  }
  if (require_column(resource, field).type != FieldType::string) field.fail_unless("a column of words");
  if (!deciding) return;
  require_number_column(resource, deciding->at("field"));
  if (std::ranges::count(resource.comparison->values, value.decided_by->field, &ComparedValue::field) == 0)
    deciding->at("field").fail_unless("one of the compared values");
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

void check_comparison(const JsonNode& node, const Resource& resource) {
  const ComparisonRule& rule = *resource.comparison;
  require_columns(rule.kind, node, resource);
  require_keys_of(rule.kind, node);
  const auto values = require_elements(node.at("values"));
  for (std::size_t i = 0; i < values.size(); ++i) check_compared_value(values[i], rule.values[i], resource);
  const bool is_sampled = rule.kind == ComparisonKind::curve || rule.kind == ComparisonKind::phases;
  if (is_sampled) require_number_column(resource, node.at("abscissa"));
  if (is_sampled && std::ranges::count(rule.values, Norm::word, &ComparedValue::norm) > 0)
    node.at("kind").fail_unless("table or events, because words are compared");
  if (const auto interpolation = node.find("interpolation")) check_interpolation(*interpolation, resource);
  if (rule.kind == ComparisonKind::phases) static_cast<void>(node.at("events"));
  if (const auto horizon = node.find("horizon")) require_positive(*horizon);
  if (const auto shortest = node.find("shortest_phase")) require_not_negative(*shortest);
}

void check_diagnosis(const JsonNode& node, const Resource& resource) {
  if (const JsonNode problem = node.at("case"); problem.value().is_object())
    require_column(resource, problem.at("column"));
  require_number_column(resource, node.at("abscissa"));
  require_number_column(resource, node.at("value"));
}

// Numbers, words, columns that the schema has, and objects of them.
void require_problem(const JsonNode& node, const Resource& resource) {
  node.require_spelling({"beam", "tip", "excitation", "damping", "friction", "initial_state", "modes",
                         "duration", "column", "frequency_hz", "amplitude", "kelvin_voigt",
                         "static_coefficient", "kinetic_coefficient", "decay", "shear_coefficient",
                         "poisson_ratio", "frequency_ratio", "force_ratio"});
  if (const auto tip = node.find("tip")) static_cast<void>(tip->one_of({"held", "free", "friction"}));
  if (const auto duration = node.find("duration"); duration && !duration->value().is_object())
    require_positive(*duration);
  for (const auto& [key, member] : node.members()) {
    if (key == "column")
      require_column(resource, member);
    else if (member.value().is_object())
      require_problem(member, resource);
    else if (!member.value().is_number() && !member.value().is_string())
      member.fail_unless("a number, a word or an object");
  }
}

void add_numbers(std::map<std::string, double>& numbers, const std::string& prefix, const JsonNode& node) {
  for (const auto& [key, member] : node.members()) {
    if (member.value().is_number()) numbers[prefix + key] = member.value().get<double>();
    if (member.value().is_object()) add_numbers(numbers, prefix + key + ".", member);
  }
}

StatedProblem stated_problem(const JsonNode& node) {
  StatedProblem stated;
  for (const auto& [key, member] : node.members()) {
    if (member.value().is_string() && key == "beam") stated.beam = member.text();
    if (member.value().is_string() && key == "tip") stated.tip = member.text();
  }
  add_numbers(stated.numbers, "", node);
  return stated;
}

void require_word(const JsonNode& node, const std::string& key, const std::string& word) {
  if (const auto member = node.find(key)) static_cast<void>(member->one_of({word}));
}

Resource resource_of(const JsonNode& node) {
  Resource resource = read_description(node);
  if (!is_inside(resource.path)) node.at("path").fail_unless("a path inside the folder of the package");
  check_schema(node.at("schema"), resource);
  if (const auto problem = node.find("problem")) {
    require_problem(*problem, resource);
    resource.stated = stated_problem(*problem);
  }
  if (resource.comparison) check_comparison(node.at("comparison"), resource);
  if (resource.diagnosis) check_diagnosis(node.at("diagnosis"), resource);
  require_elements(node.at("provenance").at("checks"));
  return resource;
}

void require_licenses(const JsonNode& licenses) {
  const std::vector<std::string> keys{"name", "path", "title"};
  for (const JsonNode& license : require_elements(licenses)) {
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
    for (const std::string& name : resource_.primary_key) key.push_back(find_column(columns_, name));
    if (const auto rows = duplicate_rows(key))
      throw InputError(csv_.place(lines_[rows->second]) + ": the primary key " +
                       joined(resource_.primary_key) + " stands in line " +
                       std::to_string(lines_[rows->first]) + " already, but must stand once");
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
                     suggestion(wanted, names_of(resources)) + ", but must be one of the " +
                     std::to_string(resources.size()) + " that 'stickslip reference list' names");
  return *found;
}

const Column* find_column(const std::vector<Column>& columns, std::string_view name) {
  const auto found =
      std::ranges::find(columns, name, [](const Column& c) { return std::string_view(c.field.name); });
  return found == columns.end() ? nullptr : &*found;
}

const Column& ReferenceTable::column(std::string_view name) const {
  if (const Column* found = find_column(columns, name)) return *found;
  throw std::out_of_range("no column " + std::string(name) + " in " + resource.name);
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
  const auto nodes = require_elements(root.at("resources"));
  for (const JsonNode& node : nodes) package.resources.push_back(resource_of(node));
  require_consistent(package, nodes);
  return package;
}

ReferenceTable read_table(const ReferencePackage& package, const std::string& name) {
  const Resource& resource = package.resource(name);
  const std::filesystem::path file = package.folder / resource.path;
  ReferenceTable table{
      .resource = resource, .csv = read_bounded(file, limit::table_bytes.most), .columns = {}};
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

std::optional<std::pair<std::size_t, std::size_t>> duplicate_rows(const std::vector<const Column*>& key) {
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
  return std::minmax({*twice, *(twice + 1)});
}

}  // namespace stickslip::data
