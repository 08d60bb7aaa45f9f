// SPDX-License-Identifier: MIT
#include "comparison/points.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::studies {

namespace {

using data::Norm;

// |x| in a norm.
double measured(double x, Norm norm, double reference, double scale) {
  return std::abs(x) / unit_of(norm, reference, scale);
}

}  // namespace

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
  series.allowed.push_back(point.half_width +
                           quantity.tolerance * unit_of(quantity.norm, point.reference, scale));
  ++quantity.compared;

  const double error = measured(point.theirs - point.reference, quantity.norm, point.reference, scale);
  const double uncertainty = measured(point.half_width, quantity.norm, point.reference, scale);
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
  return {.name = name,
          .unit = unit,
          .norm = norm,
          .tolerance = tolerance,
          .error = 0.0,
          .uncertainty = 0.0,
          .where = {},
          .agreement = Agreement::agrees,
          .compared = 0,
          .undecided = 0,
          .skipped = {},
          .series = {}};
}

void count(Comparison::Quantity& quantity, const std::string& where) {
  if (quantity.error == 0.0) quantity.where = where;
  *quantity.error += 1.0;
  if (*quantity.error > quantity.tolerance) quantity.agreement = Agreement::differs;
}

}  // namespace stickslip::studies
