// SPDX-License-Identifier: MIT
#include "comparison/points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::comparison {

using data::Norm;

double unit_of(Norm norm, double reference, double scale) {
  if (norm == Norm::relative) return reference == 0.0 ? scale : std::abs(reference);
  return norm == Norm::scale || norm == Norm::range ? scale : 1.0;
}

bool is_angle(const std::string& unit, Norm norm) { return unit == "rad" && norm == Norm::absolute; }

double nearest_angle(double angle, double reference) {
  return reference + std::remainder(angle - reference, 2.0 * std::numbers::pi);
}

void skip(Comparison::Quantity& quantity, const std::string& reason) {
  const auto known = std::ranges::find(quantity.skipped, reason, &std::pair<std::string, std::size_t>::first);
  if (known == quantity.skipped.end())
    quantity.skipped.emplace_back(reason, 1);
  else
    ++known->second;
}

void judge(Comparison::Quantity& quantity, const ComparedSample& point, const Scales& scales,
           const std::string& where) {
  if (!point.reference || !std::isfinite(point.reference->value))
    return skip(quantity, "without a value in the data set");
  const double reference = point.reference->value,
               theirs = is_angle(quantity.unit, quantity.norm) ? nearest_angle(point.theirs.value, reference)
                                                               : point.theirs.value,
               half_width = point.reference->half_width + point.theirs.half_width,
               unit = unit_of(quantity.norm, reference, scales.norm);
  Comparison::Series& series = quantity.series.back();
  series.abscissa.push_back(point.abscissa);
  series.theirs.push_back(theirs);
  series.reference.push_back(reference);
  series.half_width.push_back(half_width);
  series.allowed.push_back(half_width + quantity.tolerance * unit);
  ++quantity.compared;

  const double distance = std::abs(theirs - reference), error = distance / unit,
               uncertainty = half_width / unit;
  quantity.scaled_error = std::max(quantity.scaled_error, (distance - half_width) / scales.level);
  quantity.is_strict = quantity.is_strict && uncertainty <= quantity.own_tolerance &&
                       error <= quantity.own_tolerance + uncertainty;
  const bool differs = error > quantity.tolerance + uncertainty;
  const bool undecided = !differs && uncertainty > quantity.tolerance;
  quantity.undecided += undecided ? 1 : 0;
  if (differs)
    quantity.agreement = Agreement::differs;
  else if (undecided && quantity.agreement == Agreement::agrees)
    quantity.agreement = Agreement::undecided;
  if (!quantity.error || error - uncertainty > *quantity.error - *quantity.uncertainty) {
    quantity.error = error;
    quantity.uncertainty = uncertainty;
    quantity.where = where;
  }
}

std::size_t level_of(const Comparison::Quantity& quantity) {
  if (quantity.compared == 0) return 0;
  if (quantity.is_strict) return level_names.size() - 1;
  std::size_t level = 0;
  for (const double limit : {1e-1, 1e-2, 1e-3}) level += quantity.scaled_error <= limit ? 1 : 0;
  return level;
}

Comparison::Quantity count_of(const std::string& name, const std::string& unit, Norm norm, double tolerance) {
  Comparison::Quantity quantity;
  quantity.name = name, quantity.unit = unit, quantity.norm = norm, quantity.tolerance = tolerance;
  quantity.error = quantity.uncertainty = 0.0;
  return quantity;
}

void count(Comparison::Quantity& quantity, const std::string& where) {
  if (quantity.error == 0.0) quantity.where = where;
  *quantity.error += 1.0;
  quantity.is_strict = *quantity.error <= quantity.own_tolerance;
  if (*quantity.error > quantity.tolerance) quantity.agreement = Agreement::differs;
}

}  // namespace stickslip::comparison
