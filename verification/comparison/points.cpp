// SPDX-License-Identifier: MIT
#include "comparison/points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::studies {

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

bool is_phase(const std::string& unit, Norm norm) { return unit == "rad" && norm == Norm::absolute; }

double nearest_angle(double angle, double reference) {
  return reference + std::remainder(angle - reference, 2.0 * std::numbers::pi);
}

void skip(Comparison::Quantity& quantity, const std::string& reason) {
  const auto known = std::ranges::find(quantity.skipped, reason, &Comparison::Skipped::reason);
  if (known == quantity.skipped.end())
    quantity.skipped.push_back({reason, 1});
  else
    ++known->points;
}

void judge(Comparison::Quantity& quantity, const Point& point, double scale) {
  Comparison::Series& series = quantity.series.back();
  series.abscissa.push_back(point.abscissa);
  series.theirs.push_back(point.theirs);
  series.reference.push_back(point.reference);
  series.half_width.push_back(point.half_width);
  const double unit = unit_of(quantity.norm, point.reference, scale);
  series.allowed.push_back(point.half_width + quantity.tolerance * unit);
  ++quantity.compared;

  const double error = std::abs(point.theirs - point.reference) / unit;
  const double uncertainty = point.half_width / unit;
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
    quantity.where = point.where;
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

}  // namespace stickslip::studies
