// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/certified/beam.hpp"
#include "stickslip/certified/real.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/reference/package.hpp"

namespace stickslip::reference {

using data::Norm;
using data::ValueClass;

/// A case with its exact decimals, as published.
struct NamedBeam {
  std::string name;  ///< of the case file, without extension
  data::Case problem;
  certified::Beam beam;
};

[[nodiscard]] NamedBeam named_beam(const std::string& name);

/// The beams of the data sets of modes and shapes: that of the paper, a steel strip, a soft and short beam, a beam near
/// buckling, and a beam in tension.
[[nodiscard]] const std::vector<NamedBeam>& beams();

/// The decimal in a case file, as an exact number.
[[nodiscard]] certified::Rational exact(double value);

/// A word or a number without a radius, in one cell; or a value and its radius, in two.
struct Cell {
  std::vector<std::string> texts;

  Cell(std::string text) : texts{std::move(text)} {}
  Cell(const char* text) : texts{text} {}
  Cell(double number) : texts{data::shortest_text(number)} {}
  Cell(int number) : texts{std::to_string(number)} {}
  Cell(std::string value, std::string radius) : texts{std::move(value), std::move(radius)} {}
};

/// Throws std::runtime_error if the radius is above 1e-28 of the larger of |value| and `scale`.
[[nodiscard]] Cell enclosed(const certified::Real& value, double scale = 0.0);
/// The value has one digit more than the radius, which must be positive, justifies.
[[nodiscard]] Cell converged(double value, double radius);

void add_row(DataSet& set, const std::vector<Cell>& cells);

/// Descriptions of columns without a radius: one of the words allowed (any, if none are given), integer, exact
/// number.
[[nodiscard]] data::Field word(std::string name, std::string description,
                               std::vector<std::string> allowed = {});
[[nodiscard]] data::Field integer(std::string name, std::string description);
[[nodiscard]] data::Field exact_number(std::string name, std::string unit, std::string description);
/// The name of a beam, which refers to the data set beams (beam_key), and the number of a mode.
[[nodiscard]] data::Field beam_column();
[[nodiscard]] data::Field mode_column();
/// Adds the description of a value and of its radius.
void add_value(std::vector<data::Field>& fields, const std::string& name, const std::string& unit,
               const std::string& description, ValueClass value_class);

/// Name and version of the software, such as "stickslip 1.0.0".
[[nodiscard]] std::string software();

[[nodiscard]] DataSet data_set(std::string name, std::string path, std::string title,
                               std::string description);

/// The key of a column "beam", which refers to the data set beams.
[[nodiscard]] data::ForeignKey beam_key();

/// A member of a problem whose value stands in a column.
[[nodiscard]] std::string in_column(std::string_view column);

/// The problem without excitation of each beam in the column "beam". tip: "held" or "free".
[[nodiscard]] std::string problem_of_each_beam(std::string_view tip);

/// The problem of a case on a beam of the data set beams. tip: "held" or "friction". `others`: members by their
/// pointers ("/excitation/amplitude"), as JSON, beside or instead of those of the case; all modes, if it has none.
[[nodiscard]] std::string problem_of(const data::Case& problem, std::string_view beam, std::string_view tip,
                                     const std::map<std::string, std::string>& others);

/// The first columns of a data set, which are its primary key.
void set_key(data::Resource& resource, std::vector<data::Field> columns);

/// A value of a data set with the rule to compare it.
struct Value {
  std::string name, unit, description;
  Norm norm{};
  double tolerance{};
};

/// Adds a column for each value and one for its radius, and the comparison of the values row by row.
void add_values(data::Resource& resource, ValueClass value_class, const std::vector<Value>& values);

/// Makes the comparison one along this column, without interpolation.
void compare_along(data::Resource& resource, std::string abscissa);

[[nodiscard]] data::ComparisonRule by_rows(std::vector<data::ComparedValue> values);

/// The diagnosis for one case, or for each beam with the case of the same name.
[[nodiscard]] data::DiagnosisRule in_case(std::string quantity, std::string name, std::string abscissa,
                                          std::string value);
[[nodiscard]] data::DiagnosisRule for_each_beam(std::string quantity, std::string abscissa,
                                                std::string value);

/// The provenance of values enclosed by ball arithmetic.
[[nodiscard]] data::Provenance enclosed_by(std::string method, std::string settings,
                                           std::vector<std::string> checks);

/// The provenance of values from a converged sequence.
[[nodiscard]] data::Provenance converged_by(std::string method, std::string settings,
                                            std::vector<std::string> checks);

/// The recipes of the data sets in each file.
[[nodiscard]] std::vector<Recipe> enclosed_sets();
[[nodiscard]] std::vector<Recipe> converged_sets();
[[nodiscard]] std::vector<Recipe> field_sets();
[[nodiscard]] std::vector<Recipe> exact_sets();
[[nodiscard]] std::vector<Recipe> published_sets();
[[nodiscard]] std::vector<Recipe> random_sets();
[[nodiscard]] std::vector<Recipe> record_sets();

}  // namespace stickslip::reference
