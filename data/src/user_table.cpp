// SPDX-License-Identifier: MIT
#include "stickslip/data/user_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

// The names that the files of `stickslip respond` have for columns of the data sets, and t for time.
const std::vector<std::pair<std::string, std::string>> other_names{
    {"phase", "state"}, {"position", "tip_displacement"}, {"time", "t"}, {"t", "time"}};

class UserTableReader {
 public:
  UserTableReader(const std::filesystem::path& file, const ReferenceTable& reference,
                  const std::vector<ColumnMapping>& mappings, const std::vector<std::string>& names,
                  bool is_quoted)
      : reference_(reference),
        mappings_(mappings),
        is_quoted_(is_quoted),
        text_(read_table_text(file)),
        csv_(file, text_, names) {
    table_.file = file == "-" ? "standard input" : file;
  }

  [[nodiscard]] UserTable read() {
    find_columns();
    while (const auto cells = csv_.next_row()) add_row(*cells);
    if (table_.rows() == 0)
      throw InputError(csv_.place(csv_.line()) + ": the table has no rows, but must have at least one");
    add_constant_keys();
    require_order();
    require_unique_keys();
    return std::move(table_);
  }

 private:
  // One of their columns that is read.
  struct Source {
    std::size_t position;
    const Field* field;
    std::optional<Unit> unit;
  };

  [[nodiscard]] const Resource& resource() const { return reference_.resource; }

  // --- columns

  [[nodiscard]] const ColumnMapping* mapping_of(const std::string& name) const {
    const auto found = std::ranges::find(
        mappings_, folded(name), [](const ColumnMapping& mapping) { return folded(mapping.reference); });
    return found == mappings_.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::optional<Source> find(const Field& field) const {
    const ColumnMapping* mapping = mapping_of(field.name);
    if (mapping != nullptr) return find_named(field, mapping->theirs, mapping);
    auto source = find_named(field, field.name, nullptr);
    for (const auto& [name, other] : other_names)
      if (!source && field.name == name) source = find_named(field, other, nullptr);
    return source;
  }

  [[nodiscard]] std::optional<Source> find_named(const Field& field, const std::string& name,
                                                 const ColumnMapping* mapping) const {
    std::optional<Source> source;
    for (std::size_t i = 0; i < csv_.names().size(); ++i) {
      const auto header = header_named(csv_.names()[i], name);
      if (!header) continue;
      if (source)
        throw InputError(csv_.place(csv_.line_of_names(), i) + ": the column " + printable(name) +
                         " stands twice, in column " + std::to_string(source->position + 1) + " as '" +
                         printable(csv_.names()[source->position]) + "'");
      source = Source{i, &field, std::nullopt};
      const std::string unit =
          mapping != nullptr && !mapping->unit.empty() ? mapping->unit : header->unit.value_or(field.unit);
      if (field.type != FieldType::string) source->unit = unit_for(field, unit, i);
    }
    if (!source && mapping != nullptr) throw_missing(name, " (for " + field.name + ")");
    return source;
  }

  [[nodiscard]] Unit unit_for(const Field& field, const std::string& name, std::size_t position) const {
    if (name == field.unit) return {.si = field.unit};
    const auto unit = unit_named(name);
    if (!unit || unit->si != field.unit)
      throw InputError(csv_.place(csv_.line_of_names(), position) + ": the unit of " + field.name + " is '" +
                       printable(name) + "', but must be one of " + units_convertible_to(field.unit));
    return *unit;
  }

  // Throws if so large a share of the names are numbers.
  void require_names(double share) const {
    const auto numbers = static_cast<double>(csv_.numbers_in(csv_.names()));
    if (numbers >= share * static_cast<double>(csv_.names().size()))
      throw InputError(
          csv_.place(csv_.line_of_names()) +
          ": the line is numbers, not the names of the columns (--columns NAME,NAME,... gives them)");
  }

  [[noreturn]] void throw_missing(const std::string& name, const std::string& purpose) const {
    require_names(0.5);
    std::vector<std::string> names;
    for (const std::string& header : csv_.names()) names.push_back(printable(header));
    throw InputError(csv_.place(csv_.line_of_names()) + ": the column " + printable(name) + purpose +
                     " is missing" +
                     (is_quoted_ ? suggestion(name, names) + "; the file has " + joined(names) : "") +
                     " (--column REFERENCE=THEIRS says which is which)");
  }

  // Events are in sequence and need no number.
  [[nodiscard]] bool is_number_of_event(const std::string& name) const {
    return name == "index" && resource().comparison->kind == ComparisonKind::events;
  }

  [[nodiscard]] bool must_have(const std::string& name) const {
    const ComparisonRule& rule = *resource().comparison;
    const bool is_event = rule.kind == ComparisonKind::events;
    if (name == rule.abscissa || (is_event && (name == "change" || name == "time"))) return true;
    const bool is_key = std::ranges::count(resource().primary_key, name) > 0;
    return is_key && !is_number_of_event(name) && !constant(name);
  }

  // The one value that the data set has in a column.
  [[nodiscard]] std::optional<std::string> constant(const std::string& name) const {
    const auto& text = reference_.column(name).text;
    const bool is_one =
        std::ranges::all_of(text, [&](const std::string& cell) { return cell == text.front(); });
    return is_one ? std::optional(text.front()) : std::nullopt;
  }

  [[nodiscard]] bool is_compared(const std::string& name) const {
    const auto& values = resource().comparison->values;
    return std::ranges::find(values, name, &ComparedValue::field) != values.end();
  }

  void find_columns() {
    if (!resource().comparison)
      throw InputError("the data set " + resource().name + " says nothing of how to compare with it");
    require_names(1.0);
    bool has_value = false;
    for (const Field& field : resource().fields) {
      const auto source = find(field);
      if (!source && must_have(field.name)) throw_missing(field.name, "");
      if (!source) continue;
      has_value = has_value || is_compared(field.name);
      sources_.push_back(*source);
      table_.columns.push_back({field, {}, {}});
    }
    if (!has_value) throw_missing(resource().comparison->values.front().field, "");
  }

  // --- rows

  void add_row(const std::vector<std::string>& cells) {
    table_.lines.push_back(csv_.line());
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      table_.columns[i].values.push_back(value_of(sources_[i], cells[sources_[i].position]));
      table_.columns[i].text.push_back(cells[sources_[i].position]);
    }
  }

  [[nodiscard]] double value_of(const Source& source, const std::string& cell) const {
    const auto fail_unless = [&](const std::string& allowed) {
      throw InputError(csv_.place(csv_.line(), source.position) + ": " + source.field->name + " is '" +
                       printable(cell) + "', but must be " + allowed);
    };
    if (source.field->type == FieldType::string) {
      if (cell.empty() || cell != printable(cell)) fail_unless("a word");
      return std::numeric_limits<double>::quiet_NaN();
    }
    const auto number = csv_.number(cell);
    if (!number) fail_unless("a finite number that fits a double, as 0.025 or 2.5e-2");
    if (source.field->type == FieldType::integer && *number != std::floor(*number)) fail_unless("an integer");
    const double value = source.unit->to_si(*number);
    if (!std::isfinite(value)) fail_unless("a number that is finite in " + source.field->unit);
    return value;
  }

  void add_constant_keys() {
    for (const std::string& name : resource().primary_key) {
      if (table_.column(name) != nullptr || is_number_of_event(name)) continue;
      const Column& reference = reference_.column(name);
      table_.columns.push_back({reference.field, std::vector(table_.rows(), reference.text.front()),
                                std::vector(table_.rows(), reference.values.front())});
    }
  }

  // The abscissa does not decrease within a curve or a sequence of events. A time may stand twice: before and
  // after an event.
  void require_order() const {
    const ComparisonRule& rule = *resource().comparison;
    if (rule.kind == ComparisonKind::table) return;
    const Column& abscissa = *table_.column(rule.kind == ComparisonKind::events ? "time" : rule.abscissa);
    std::map<std::vector<std::string>, std::size_t> previous;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      std::vector<std::string> group;
      for (const std::string& name : group_columns(resource()))
        group.push_back(table_.column(name)->text[row]);
      const auto [entry, is_first] = previous.try_emplace(group, row);
      const std::size_t before = std::exchange(entry->second, row);
      if (is_first) continue;
      const double step = abscissa.values[row] - abscissa.values[before];
      if (step < 0.0)
        throw InputError(place_of(abscissa, row) + ": " + abscissa.field.name + " is " + abscissa.text[row] +
                         ", but must not be below " + abscissa.text[before] + " of line " +
                         std::to_string(table_.lines[before]));
    }
  }

  void require_unique_keys() const {
    const ComparisonKind kind = resource().comparison->kind;
    const bool has_key = kind == ComparisonKind::table ||
                         (kind == ComparisonKind::events && table_.column("index") != nullptr);
    if (resource().primary_key.empty() || !has_key) return;
    std::vector<const Column*> key;
    for (const std::string& name : resource().primary_key) key.push_back(table_.column(name));
    const auto twice = duplicate_rows(key);
    if (!twice) return;
    std::string values;
    for (const std::string& name : resource().primary_key)
      values += (values.empty() ? "" : ", ") + name + " = " + table_.column(name)->text[twice->second];
    throw InputError(table_.place(twice->second) + ": " + printable(values) + " stands in line " +
                     std::to_string(table_.lines[twice->first]) + " already, but must stand once");
  }

  [[nodiscard]] std::string place_of(const Column& column, std::size_t row) const {
    const auto source =
        std::ranges::find(sources_, column.field.name, [](const Source& s) { return s.field->name; });
    return csv_.place(table_.lines[row], source->position);
  }

  const ReferenceTable& reference_;
  const std::vector<ColumnMapping>& mappings_;
  const bool is_quoted_;
  std::string text_;
  CsvReader csv_;
  std::vector<Source> sources_;
  UserTable table_;
};

}  // namespace

ColumnMapping ColumnMapping::parse(std::string_view text) {
  const auto equals = text.find('=');
  const std::string_view reference = trimmed(text.substr(0, equals));
  std::string_view theirs =
      equals == std::string_view::npos ? std::string_view{} : trimmed(text.substr(equals + 1));
  std::string_view unit;
  if (const auto colon = theirs.rfind(':'); colon != std::string_view::npos) {
    unit = trimmed(theirs.substr(colon + 1));
    theirs = trimmed(theirs.substr(0, colon));
  }
  if (reference.empty() || theirs.empty())
    throw FieldError("column", printable(text),
                     "REFERENCE=THEIRS or REFERENCE=THEIRS:unit, as in frequency=f1:kHz");
  return {std::string(reference), std::string(theirs), std::string(unit)};
}

std::string UserTable::place(std::size_t row) const {
  return file.string() + ":" + std::to_string(lines[row]);
}

std::vector<std::string> group_columns(const Resource& resource) {
  std::vector<std::string> names;
  if (!resource.comparison) return names;
  for (const std::string& name : resource.primary_key)
    if (name != resource.comparison->abscissa && name != "index") names.push_back(name);
  return names;
}

void require_known_columns(const std::vector<ColumnMapping>& mappings,
                           const std::vector<const ReferenceTable*>& references) {
  std::vector<std::string> names;
  for (const ReferenceTable* reference : references)
    for (const Field& field : reference->resource.fields)
      if (std::ranges::count(names, field.name) == 0) names.push_back(field.name);
  for (const ColumnMapping& mapping : mappings) {
    const bool is_known = std::ranges::any_of(
        names, [&](const std::string& name) { return folded(name) == folded(mapping.reference); });
    if (!is_known)
      throw InputError("column " + printable(mapping.reference) + " is unknown" +
                       suggestion(mapping.reference, names) + ", but must be one of " + joined(names));
    const auto count = std::ranges::count(mappings, folded(mapping.reference),
                                          [](const ColumnMapping& other) { return folded(other.reference); });
    if (count > 1)
      throw InputError("column " + printable(mapping.reference) + " is given " + std::to_string(count) +
                       " times, but must be given once");
  }
}

UserTable read_user_table(const std::filesystem::path& file, const ReferenceTable& reference,
                          const std::vector<ColumnMapping>& mappings, const std::vector<std::string>& names,
                          bool is_quoted) {
  return UserTableReader(file, reference, mappings, names, is_quoted).read();
}

}  // namespace stickslip::data
