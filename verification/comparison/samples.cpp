// SPDX-License-Identifier: MIT
#include "comparison/samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

namespace stickslip::comparison {

namespace {

// The index of the first sample at x or behind it.
std::size_t next_of(const Samples& samples, double x) {
  return static_cast<std::size_t>(std::ranges::lower_bound(samples.abscissa, x) - samples.abscissa.begin());
}

// The sample at x (to `coincidence`); empty if there is none.
std::optional<Interpolated> sample_at(const Samples& samples, double x, double coincidence) {
  const std::size_t next = next_of(samples, x - coincidence);
  if (next == samples.abscissa.size() || std::abs(samples.abscissa[next] - x) > coincidence)
    return std::nullopt;
  return Interpolated{samples.values[next], samples.half_width[next]};
}

// The distance between the two samples on either side of x; infinite outside the samples.
double gap_at(const Samples& samples, double x) {
  const std::size_t next = next_of(samples, x);
  if (next == 0 || next == samples.abscissa.size()) return std::numeric_limits<double>::infinity();
  return samples.abscissa[next] - samples.abscissa[next - 1];
}

// The interpolation polynomial through these samples.
Interpolated polynomial(const Samples& samples, double x, std::span<const std::size_t> points) {
  const auto& xs = samples.abscissa;
  Interpolated result;
  for (const std::size_t i : points) {
    double weight = 1.0;
    for (const std::size_t j : points)
      if (j != i) weight *= (x - xs[j]) / (xs[i] - xs[j]);
    result.value += weight * samples.values[i];
    result.half_width += std::abs(weight) * samples.half_width[i];
  }
  return result;
}

// The same through this number of samples, half of them before the sample `next`.
Interpolated polynomial(const Samples& samples, double x, std::size_t next, std::size_t number) {
  std::vector<std::size_t> points(number);
  std::iota(points.begin(), points.end(),
            std::min(next - std::min(next, number / 2), samples.abscissa.size() - number));
  return polynomial(samples, x, points);
}

// The error with which the cubic through its four neighbours reproduces a sample.
double error_without(const Samples& samples, std::size_t left_out) {
  std::array<std::size_t, 4> points{};
  std::size_t point = std::min(left_out - std::min<std::size_t>(left_out, 2), samples.abscissa.size() - 5);
  for (std::size_t& one : points) {
    if (point == left_out) ++point;
    one = point++;
  }
  return std::abs(polynomial(samples, samples.abscissa[left_out], points).value - samples.values[left_out]);
}

}  // namespace

std::optional<Interpolated> interpolated(const Samples& samples, double x, const data::Interpolation& rule,
                                         double error_bound) {
  const auto points = static_cast<std::size_t>(rule.order) + 1;
  if (samples.abscissa.size() < points) return std::nullopt;
  Interpolated result = polynomial(samples, x, next_of(samples, x), points);
  result.half_width += error_bound;
  return result;
}

double roughness_at(const Samples& samples, double x) {
  const std::size_t size = samples.abscissa.size();
  if (size < 5) return std::numeric_limits<double>::infinity();
  constexpr std::size_t reach = 8;
  const std::size_t next = std::clamp<std::size_t>(next_of(samples, x), 1, size - 1);
  double largest = 0.0;
  for (std::size_t i = next - std::min(next - 1, reach); i < std::min(next + reach, size - 1); ++i)
    largest = std::max(largest, error_without(samples, i));
  return largest;
}

std::optional<Interpolated> interpolated(const Samples& samples, double x, double most_rough) {
  const std::size_t size = samples.abscissa.size();
  if (size < 3) return std::nullopt;
  const std::size_t next = std::clamp<std::size_t>(next_of(samples, x), 1, size - 1);
  Interpolated result = polynomial(samples, x, next, std::min<std::size_t>(4, size));
  const double first = samples.abscissa[next - 1];
  const double place = (x - first) / (samples.abscissa[next] - first);
  result.half_width += size < 5
                           ? std::abs(result.value - polynomial(samples, x, next, 2).value)
                           : 8.0 * place * (1.0 - place) * std::min(most_rough, roughness_at(samples, x));
  return result;
}

ComparedSamples by_stated_interpolation(const Samples& reference, const Samples& theirs,
                                        const data::Interpolation& rule, double error_bound,
                                        double coincidence) {
  ComparedSamples result;
  for (std::size_t i = 0; i < theirs.abscissa.size(); ++i) {
    const double x = theirs.abscissa[i];
    auto value = sample_at(reference, x, coincidence);
    if (!value) value = interpolated(reference, x, rule, error_bound);
    result.points.push_back({x, {theirs.values[i], 0.0}, value});
  }
  return result;
}

ComparedSamples by_own_interpolation(const Samples& reference, const Samples& theirs, double spacing,
                                     double coincidence) {
  const double near = 1.01 * spacing;
  // A time that was rounded to single precision may mean that of the reference. The difference counts as
  // uncertainty.
  constexpr double single_precision = 0x1p-24;
  const auto& xs = theirs.abscissa;
  ComparedSamples result;
  for (std::size_t i = 0; i < reference.abscissa.size(); ++i) {
    const double x = reference.abscissa[i];
    auto value = sample_at(theirs, x, coincidence);
    if (!value && gap_at(theirs, x) <= near) value = interpolated(theirs, x, roughness_at(reference, x));
    if (const auto sample = sample_at(theirs, x, single_precision * std::abs(x)); value && sample)
      value->half_width += std::abs(value->value - sample->value);
    if (value)
      result.points.push_back({x, *value, Interpolated{reference.values[i], reference.half_width[i]}});
  }
  for (std::size_t i = 0; i < xs.size(); ++i) {
    if (sample_at(reference, xs[i], coincidence)) continue;
    const bool is_alone = xs.size() < 3 || (i > 0 && xs[i] - xs[i - 1] > near) ||
                          (i + 1 < xs.size() && xs[i + 1] - xs[i] > near);
    const bool is_inside = xs[i] > reference.abscissa.front() && xs[i] < reference.abscissa.back();
    const auto value = is_alone && is_inside ? interpolated(reference, xs[i]) : std::nullopt;
    if (value) result.points.push_back({xs[i], {theirs.values[i], 0.0}, value});
    result.between += is_alone ? 0 : 1;
    result.past_last += is_alone && !value ? 1 : 0;
  }
  std::ranges::sort(result.points, {}, &ComparedSample::abscissa);
  return result;
}

using data::Norm;

double unit_of(Norm norm, double reference, double scale) {
  if (norm == Norm::relative) return reference == 0.0 ? scale : std::abs(reference);
  return norm == Norm::scale || norm == Norm::range ? scale : 1.0;
}

double allowed_error(const Comparison::Quantity& quantity, double reference, double scale) {
  return std::max(quantity.tolerance * unit_of(quantity.norm, reference, scale),
                  level_limits.at(quantity.required_level) * scale);
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
  series.allowed.push_back(half_width + allowed_error(quantity, reference, scale));
  ++quantity.compared;

  const double distance = std::abs(theirs - reference), error = distance / unit,
               uncertainty = half_width / unit;
  const double scaled_error = (distance - half_width) / scale,
               limit = level_limits.at(quantity.required_level);
  quantity.scaled_error = std::max(quantity.scaled_error, scaled_error);
  quantity.is_strict = quantity.is_strict && uncertainty <= quantity.own_tolerance &&
                       error <= quantity.own_tolerance + uncertainty;
  const bool differs = error > quantity.tolerance + uncertainty && scaled_error > limit;
  const bool undecided = !differs && uncertainty > quantity.tolerance && half_width / scale > limit;
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
  if (quantity.is_strict) return strict_level;
  std::size_t level = 0;
  while (level + 1 < strict_level && quantity.scaled_error <= level_limits.at(level + 1)) ++level;
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
