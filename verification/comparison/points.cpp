// SPDX-License-Identifier: MIT
#include "comparison/points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::comparison {

using data::Norm;

double unit_of(Norm norm, double reference, double scale) {
  switch (norm) {
    case Norm::relative:
      return reference == 0.0 ? scale : std::abs(reference);
    case Norm::scale:
    case Norm::range:
      return scale;
    case Norm::absolute:
    case Norm::word:
      break;
  }
  return 1.0;
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

void judge(Comparison::Quantity& quantity, const ComparedSample& point, double scale,
           const std::string& where) {
  if (!point.reference || !std::isfinite(point.reference->value))
    return skip(quantity, "without a value in the data set");
  const double reference = point.reference->value,
               theirs = is_angle(quantity.unit, quantity.norm) ? nearest_angle(point.theirs.value, reference)
                                                               : point.theirs.value,
               half_width = point.reference->half_width + point.theirs.half_width,
               unit = unit_of(quantity.norm, reference, scale);
  Comparison::Series& series = quantity.series.back();
  series.abscissa.push_back(point.abscissa);
  series.theirs.push_back(theirs);
  series.reference.push_back(reference);
  series.half_width.push_back(half_width);
  series.allowed.push_back(half_width + quantity.tolerance * unit);
  ++quantity.compared;

  const double error = std::abs(theirs - reference) / unit;
  const double uncertainty = half_width / unit;
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

Comparison::Quantity count_of(const std::string& name, const std::string& unit, Norm norm, double tolerance) {
  Comparison::Quantity quantity;
  quantity.name = name, quantity.unit = unit, quantity.norm = norm, quantity.tolerance = tolerance;
  quantity.error = quantity.uncertainty = 0.0;
  return quantity;
}

void count(Comparison::Quantity& quantity, const std::string& where) {
  if (quantity.error == 0.0) quantity.where = where;
  *quantity.error += 1.0;
  if (*quantity.error > quantity.tolerance) quantity.agreement = Agreement::differs;
}

}  // namespace stickslip::comparison
