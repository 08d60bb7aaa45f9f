// SPDX-License-Identifier: MIT
#pragma once

/// The published reference data: a Frictionless data package (datapackage.json with a tabular resource for
/// each data set), in SI units, each value with its uncertainty and its provenance. File:
/// data/reference/datapackage.json.
///
/// Everything that reads it throws InputError for what is missing, altered or inconsistent, naming the file and
/// the place in it.

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip::data {

enum class FieldType { string, integer, number };

/// How well a value is known.
enum class ValueClass {
  enclosed,   ///< between rigorous bounds
  exact,      ///< to all its digits
  converged,  ///< by a sequence of meshes, steps or modes
  external    ///< published elsewhere
};

inline constexpr std::array<std::string_view, 4> value_class_names{"enclosed", "exact", "converged",
                                                                   "external"};
[[nodiscard]] constexpr std::string_view to_string(ValueClass value_class) noexcept {
  return value_class_names[static_cast<std::size_t>(value_class)];
}

/// A column of a data set. The half-width of the uncertainty of a column `x` is the column `x_radius`.
struct Field {
  std::string name;
  FieldType type{};
  std::string unit;  ///< empty for a pure number or a word
  std::string description;
  std::optional<ValueClass> value_class;
  bool required{};                     ///< no cell may be empty
  std::vector<std::string> allowed{};  ///< the words that may stand in a cell; empty: any
};

/// What an error is measured by.
enum class Norm {
  relative,  ///< |e|/|reference|, row by row; where that is 0, over the largest of the column
  scale,     ///< |e| over the largest |reference| of the curve
  absolute,  ///< |e|, in the unit of the value
  range,     ///< |e| over the largest less the smallest reference of the curve
  word       ///< the number of words that differ
};

inline constexpr std::array<std::string_view, 5> norm_names{"relative", "scale", "absolute", "range", "word"};
[[nodiscard]] constexpr std::string_view to_string(Norm norm) noexcept {
  return norm_names[static_cast<std::size_t>(norm)];
}

enum class ComparisonKind {
  table,   ///< rows by primary key
  curve,   ///< smooth in the abscissa
  events,  ///< rows in sequence
  phases   ///< smooth between events only
};

inline constexpr std::array<std::string_view, 4> comparison_kind_names{"table", "curve", "events", "phases"};
[[nodiscard]] constexpr std::string_view to_string(ComparisonKind kind) noexcept {
  return comparison_kind_names[static_cast<std::size_t>(kind)];
}

/// The value that decides a word: one word below the threshold, another one above it.
struct DecidingValue {
  std::string field;  ///< one of the compared values
  double threshold{};
};

struct ComparedValue {
  std::string field;
  Norm norm{};
  double tolerance{};
  /// A word is not judged where this value of the reference is nearer to the threshold than its tolerance and
  /// its uncertainty.
  std::optional<DecidingValue> decided_by = std::nullopt;
};

/// Lagrange's polynomial through the nearest order + 1 samples.
struct Interpolation {
  int order{};
  std::map<std::string, double> error;  ///< bound by field, in its unit
};

/// How to compare with a data set.
struct ComparisonRule {
  ComparisonKind kind{};
  std::vector<ComparedValue> values;
  std::string abscissa;  ///< curve and phases: the column
  std::optional<Interpolation> interpolation;
  std::string events;             ///< phases: the data set with the events
  std::optional<double> horizon;  ///< s; nothing later is compared
  /// events, s: a stick or a slip that is shorter counts as part of what is round it
  double shortest_phase = 0.0;
};

/// Which quantity of the wrong models (comparison::Quantity) a data set is; "force ratio" is |f|_max/(mu_s P) of a
/// case in each row.
struct DiagnosisRule {
  std::string quantity;     ///< "stick frequency"
  std::string case_name;    ///< the case file, or
  std::string case_column;  ///< the column that names it
  std::string abscissa, value;
};

struct Provenance {
  ValueClass value_class{};
  std::string method;
  std::string settings;  ///< as JSON
  std::string software;
  std::vector<std::string> checks;
};

/// A column whose cells stand in a column of another data set.
struct ForeignKey {
  std::string column, resource, reference_column;
};

/// The parts of a problem that are the same in all rows of a data set.
struct StatedProblem {
  std::string beam, tip;                  ///< empty if not given
  std::map<std::string, double> numbers;  ///< by their keys in a case, such as "excitation.amplitude"
};

/// A data set without its numbers.
struct Resource {
  std::string name;
  std::filesystem::path path;  ///< relative to the package
  std::size_t bytes{};
  std::string sha256;  ///< 64 hexadecimal digits
  std::string title, description;
  std::vector<Field> fields;
  std::vector<std::string> primary_key;
  std::vector<ForeignKey> foreign_keys;
  /// The problem that was solved, as JSON; empty if there is none. Its members are numbers, words, {"column": c}
  /// where the column c holds the value, or objects of such members: beam, tip, excitation, damping, friction,
  /// initial_state, modes, duration. data/reference/README.md defines them.
  std::string problem;
  StatedProblem stated;
  std::optional<ComparisonRule> comparison;
  std::optional<DiagnosisRule> diagnosis;
  Provenance provenance;

  /// Null if there is none.
  [[nodiscard]] const Field* field(std::string_view column) const;
};

struct ReferencePackage {
  std::filesystem::path folder;
  std::string name, title, description, version;
  std::vector<Resource> resources;

  /// Throws InputError, naming the nearest one, if there is none of that name.
  [[nodiscard]] const Resource& resource(const std::string& name) const;
};

/// A column with its cells; `values` has NaN where a cell is empty or a word.
struct Column {
  Field field;
  std::vector<std::string> text;  ///< as it stands in the file, with all digits
  std::vector<double> values;
};

/// The column with this name; null if there is none.
[[nodiscard]] const Column* find_column(const std::vector<Column>& columns, std::string_view name);

/// A data set with its numbers.
struct ReferenceTable {
  Resource resource;
  std::string csv;  ///< the file, byte for byte
  std::vector<Column> columns;

  [[nodiscard]] std::size_t rows() const { return columns.front().text.size(); }
  /// Throws std::out_of_range naming the column.
  [[nodiscard]] const Column& column(std::string_view name) const;
  /// The half-widths of a column, 0 where they are not given.
  [[nodiscard]] std::vector<double> radius_of(const std::string& column) const;
};

/// data_directory()/reference
[[nodiscard]] std::filesystem::path reference_directory();

[[nodiscard]] ReferencePackage load_reference(const std::filesystem::path& folder = reference_directory());

/// Reads a data set after checking its size and its hash.
[[nodiscard]] ReferenceTable read_table(const ReferencePackage& package, const std::string& name);

/// Whether two numbers of a key are the same one: to 1e-9, relative.
[[nodiscard]] bool is_same_key(double a, double b);

/// The first two rows with the same key, which has one column or more: the same words, and the same numbers as
/// is_same_key() compares them.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> duplicate_rows(
    const std::vector<const Column*>& key);

/// The JSON object of a data set in datapackage.json, from which load_reference() makes the same one.
[[nodiscard]] std::string json_text(Resource resource);

}  // namespace stickslip::data
