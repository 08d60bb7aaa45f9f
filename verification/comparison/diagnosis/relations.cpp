// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/relations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "comparison/groups.hpp"
#include "comparison/samples.hpp"

namespace stickslip::comparison {

namespace {

using Series = Comparison::Series;
using Values = std::vector<double>;
using Candidates = std::vector<Hypothesis>;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool has_key(const data::Resource& resource, const char* column) {
  return std::ranges::count(resource.primary_key, column) > 0;
}

// --- factors

struct UsualFactor {
  double value;
  const char* text;
};
constexpr std::array usual_factors{
    UsualFactor{-1.0, "-1: the opposite sign"},
    UsualFactor{2.0, "2: a load, an amplitude or a rigidity is twice the right one"},
    UsualFactor{0.5, "1/2: a load, an amplitude or a rigidity is half the right one"},
    UsualFactor{std::numbers::sqrt2,
                "sqrt 2: EI is double or rho A half, or a peak is given for an rms value"},
    UsualFactor{1.0 / std::numbers::sqrt2,
                "1/sqrt 2: EI is half or rho A double, or an rms value is given for a peak"},
    UsualFactor{2.0 * std::numbers::pi, "2 pi: rad/s for Hz"},
    UsualFactor{0.5 / std::numbers::pi, "1/(2 pi): divided by 2 pi once too often"},
    UsualFactor{1e3, "1000: another unit, such as mm for m or mHz for Hz"},
    UsualFactor{1e-3, "1/1000: another unit, such as kN for N or km for m"},
    UsualFactor{1e2, "100: another unit, such as cm for m"},
    UsualFactor{1e-2, "1/100: another unit"},
    UsualFactor{1e6, "1e6: another unit, such as um for m"},
    UsualFactor{-2.0, "-2"},
    UsualFactor{-0.5, "-1/2"},
    UsualFactor{-1e3, "-1000: another unit and the opposite sign"},
    UsualFactor{-1e-3, "-1/1000: another unit and the opposite sign"}};

// The least squares factor, in the measure of the distances.
double fitted_factor(const Series& series, data::Norm norm) {
  const Values scales = scales_of(norm, series.reference);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    product += series.theirs[i] * series.reference[i] / (scales[i] * scales[i]);
    square += series.reference[i] * series.reference[i] / (scales[i] * scales[i]);
  }
  return product / square;
}

Candidates factors(const DeviatingQuantity& deviating) {
  const Series& series = deviating.series;
  const data::Norm norm = deviating.quantity.norm;
  const bool is_shape =
      has_key(deviating.reference.resource, "mode") && has_key(deviating.reference.resource, "x");
  Candidates found;
  if (is_angle(deviating.quantity.unit, norm)) return found;
  const auto add = [&](double factor, const std::string& text, int free) {
    Hypothesis& one = found.emplace_back();
    for (const double value : series.reference) one.values.push_back(factor * value);
    one.name = is_shape ? "scaled-shape" : "constant-factor";
    one.free = free;
    one.sentence = is_shape ? "MAC = 1: the same shape in another scale or with another sign"
                            : "all values are those of the data set times " + text;
  };
  for (const auto& [factor, text] : usual_factors) add(factor, text, 0);
  // Any one or two values have a factor.
  if (std::ranges::count_if(series.reference, [](double value) { return value != 0.0; }) < 3) return found;
  const double factor = fitted_factor(series, norm);
  if (const std::string text = fmt::format("{:.5g}", factor); text != "1" && factor != 0.0)
    add(factor, text, 1);
  return found;
}

// --- angles and constants

// The conventions of a phase. sin(omega t + phase) = cos(omega t + phase - pi/2).
struct AngleConvention {
  double factor, plus;
  const char* text;
};
constexpr double right_angle = std::numbers::pi / 2.0;
constexpr std::array angle_conventions{
    AngleConvention{1.0, 2.0 * right_angle, "plus half a turn: what they belong to has the opposite sign"},
    AngleConvention{1.0, -right_angle, "minus a quarter turn: those of a cosine"},
    AngleConvention{1.0, right_angle, "plus a quarter turn"},
    AngleConvention{-1.0, 2.0 * right_angle, "with the opposite sign, plus half a turn"},
    AngleConvention{-1.0, -right_angle, "with the opposite sign, minus a quarter turn"},
    AngleConvention{-1.0, right_angle, "with the opposite sign, plus a quarter turn"},
    AngleConvention{180.0 / std::numbers::pi, 0.0, "in degrees"}};

Candidates angles(const DeviatingQuantity& deviating) {
  Candidates found;
  if (!is_angle(deviating.quantity.unit, deviating.quantity.norm)) return found;
  const auto add = [&](double factor, double plus, const std::string& text) {
    Hypothesis& one = found.emplace_back();
    one.name = "angle-convention";
    for (std::size_t i = 0; i < deviating.series.theirs.size(); ++i)
      one.values.push_back(
          nearest_angle(factor * deviating.series.reference[i] + plus, deviating.series.theirs[i]));
    one.sentence = "all values are those of the data set " + text;
  };
  for (const auto& [factor, plus, text] : angle_conventions) add(factor, plus, text);
  for (const auto& [factor, text] : usual_factors) add(factor, 0.0, fmt::format("times {}", text));
  return found;
}

// The same constant added to all values. Events that are late by it have the same delay.
Candidates constant(const DeviatingQuantity& deviating) {
  const Values &theirs = deviating.series.theirs, &reference = deviating.series.reference;
  double added = 0.0;
  for (std::size_t i = 0; i < theirs.size(); ++i)
    added += (theirs[i] - reference[i]) / static_cast<double>(theirs.size());
  Hypothesis one{.name = "constant-added", .values = reference, .free = 1};
  for (double& value : one.values) value += added;
  const std::string& unit = deviating.quantity.unit;
  const bool is_delay = deviating.comparison.kind == data::ComparisonKind::events && unit == "s";
  one.sentence =
      is_delay ? fmt::format("all events are {:.3g} s {}", std::abs(added), added > 0.0 ? "late" : "early")
               : fmt::format("all values are those of the data set {} {:.5g}{}{}",
                             added > 0.0 ? "plus" : "minus", std::abs(added), unit.empty() ? "" : " ", unit);
  return {one};
}

// --- modes, zeros, single values

Candidates missing_mode(const DeviatingQuantity& deviating) {
  const auto& reference = deviating.series.reference;
  Candidates found;
  if (deviating.quantity.unit != "Hz" || deviating.comparison.abscissa != "mode") return found;
  for (std::size_t mode = 0; mode < reference.size(); ++mode) {
    Hypothesis& one = found.emplace_back();
    one.name = "missing-mode";
    one.values = reference;
    one.values.erase(one.values.begin() + static_cast<std::ptrdiff_t>(mode));
    one.values.push_back(nothing);
    one.sentence =
        fmt::format("mode {:.0f} of the data set is missing in the file", deviating.series.abscissa[mode]);
  }
  return found;
}

Candidates zeros(const DeviatingQuantity& deviating) {
  // A tip of which the displacement is 0 sticks, and a wrong model may say why.
  if (deviating.quantity.name == "tip_displacement") return {};
  return {{.name = "zeros",
           .values = Values(deviating.series.theirs.size(), 0.0),
           .sentence = "all values are 0"}};
}

// At most a twentieth of the values differ, or one of four or more; that is empirical. The first of them counts as fitted.
Candidates single_values(const DeviatingQuantity& deviating) {
  const Series& series = deviating.series;
  const Comparison& comparison = deviating.comparison;
  Hypothesis one{.name = "single-values", .values = series.reference, .free = 1};
  Rows wrong;
  const std::size_t size = series.theirs.size();
  for (std::size_t i = 0; i < size; ++i)
    if (series.differs_at(i)) {
      wrong.push_back(i);
      one.values[i] = series.theirs[i];
    }
  if (wrong.empty() || size < 4 || wrong.size() > std::max<std::size_t>(1, size / 20)) return {};
  one.sentence =
      fmt::format("only {} of {} values differ{}", wrong.size(), size, wrong.size() == 1 ? "s" : "");
  const data::Resource& resource = deviating.reference.resource;
  if (!comparison.abscissa.empty() && (!rows_are_cases(resource) || resource.primary_key.size() == 1))
    one.sentence += fmt::format(", {}at {} = {:.9g}{}{}", wrong.size() == 1 ? "" : "the first ",
                                comparison.abscissa, series.abscissa[wrong.front()],
                                comparison.abscissa_unit.empty() ? "" : " ", comparison.abscissa_unit);
  return {one};
}

// --- another column, another data set

// The values of another compared column, at the same rows.
Candidates other_columns(const DeviatingQuantity& deviating) {
  Candidates found;
  for (const Comparison::Quantity& swapped : deviating.comparison.quantities)
    for (const Series& series : groups_of(deviating.comparison, swapped, deviating.reference.resource))
      if (swapped.name != deviating.quantity.name && series.group == deviating.series.group &&
          series.abscissa == deviating.series.abscissa)
        found.push_back({.name = "other-column",
                         .values = series.reference,
                         .sentence = fmt::format("the values are those of {}", swapped.name)});
  return found;
}

// The values of another data set in the rows of the group; NaN where it has none.
Values at_the_same_rows(const data::ReferenceTable& other, const DeviatingQuantity& deviating) {
  const Series& series = deviating.series;
  const data::ReferenceTable& reference = deviating.reference;
  const std::string& abscissa = deviating.comparison.abscissa;
  Values found(series.abscissa.size(), nothing);
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    if (!series.group.empty() && group_of(reference, abscissa, row) != series.group) continue;
    const double x = reference.column(abscissa).values[row];
    const auto at = std::ranges::find_if(series.abscissa, [x](double a) { return data::is_same_key(a, x); });
    if (at == series.abscissa.end()) continue;
    if (const auto there = row_like(other, reference.resource.primary_key, reference.columns, row))
      found[static_cast<std::size_t>(at - series.abscissa.begin())] =
          other.column(deviating.quantity.name).values[*there];
  }
  return found;
}

Candidates other_data_sets(const DeviatingQuantity& deviating) {
  const Comparison& comparison = deviating.comparison;
  const data::Resource& resource = deviating.reference.resource;
  Candidates found;
  if (comparison.abscissa.empty() || comparison.kind == data::ComparisonKind::events ||
      rows_are_cases(resource))
    return found;
  for (const data::Resource& other : deviating.package.resources) {
    const data::Field* field = other.field(deviating.quantity.name);
    if (other.name != comparison.name && field != nullptr && field->unit == deviating.quantity.unit &&
        other.comparison && other.comparison->kind == comparison.kind &&
        other.primary_key == resource.primary_key)
      found.push_back({.name = "other-data-set",
                       .values = at_the_same_rows(data::read_table(deviating.package, other.name), deviating),
                       .sentence = fmt::format("the values are those of {}", other.name)});
  }
  return found;
}

// --- the table

struct Relation {
  Kind kind;
  Candidates (*candidates_of)(const DeviatingQuantity&);
  bool reads_files{};  // and is tried only if the others leave something to explain
};
constexpr std::array relations{
    Relation{Kind::factor, factors},       Relation{Kind::relation, angles},
    Relation{Kind::relation, constant},    Relation{Kind::relation, missing_mode},
    Relation{Kind::zeros, zeros},          Relation{Kind::relation, single_values},
    Relation{Kind::factor, other_columns}, Relation{Kind::relation, other_data_sets, true}};
constexpr double count_of_tried = 30.0;  // 17 factors, and about as many others

}  // namespace

bool is_of_one_motion(const data::Resource& resource) {
  return !resource.stated.beam.empty() && has_key(resource, "time");
}

bool rows_are_cases(const data::Resource& resource) {
  if (resource.comparison->kind != data::ComparisonKind::table) return false;
  if (resource.diagnosis) return resource.diagnosis->case_column.empty();
  return is_of_one_motion(resource) || (resource.stated.beam.empty() && resource.field("beam") == nullptr);
}

std::vector<Series> groups_of(const Comparison& comparison, const Comparison::Quantity& quantity,
                              const data::Resource& resource) {
  if (!rows_are_cases(resource) && !comparison.abscissa.empty()) return quantity.series;
  Series all;
  for (const Series& group : quantity.series)
    for (const auto column :
         {&Series::abscissa, &Series::theirs, &Series::reference, &Series::half_width, &Series::allowed})
      (all.*column).insert((all.*column).end(), (group.*column).begin(), (group.*column).end());
  return {all};
}

std::string group_of(const data::ReferenceTable& reference, const std::string& abscissa, std::size_t row) {
  std::vector<std::string> columns = data::group_columns(reference.resource);
  std::erase(columns, abscissa);
  return label_of(reference, columns, row);
}

std::optional<std::size_t> row_like(const data::ReferenceTable& table, const std::vector<std::string>& key,
                                    const std::vector<data::Column>& other, std::size_t other_row) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (are_alike(table.columns, row, other, other_row, key)) return row;
  return std::nullopt;
}

bool is_explained(const DeviatingQuantity& deviating, const std::vector<Hypothesis>& tried) {
  const Series& series = deviating.series;
  const double tolerance =
      distance(deviating.quantity.norm, series.reference, series.allowed, Values(series.allowed.size()));
  const Hypothesis* const nearest = nearest_of(tried);
  return nearest != nullptr && nearest->distance <= tolerance;
}

std::vector<Hypothesis> relations_of(const DeviatingQuantity& deviating) {
  std::vector<Hypothesis> all;
  for (const auto& [kind, candidates_of, reads_files] : relations)
    if (!reads_files || !is_explained(deviating, all))
      for (Hypothesis& one : candidates_of(deviating)) {
        one.kind = kind;
        all.push_back(judged(deviating.quantity.norm, deviating.series, std::move(one), count_of_tried));
      }
  return all;
}

}  // namespace stickslip::comparison
