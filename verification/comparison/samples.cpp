// SPDX-License-Identifier: MIT
#include "comparison/samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace stickslip::studies {

namespace {

// The index of the first sample at x or behind it.
std::size_t next_of(const Samples& samples, double x) {
  return static_cast<std::size_t>(std::ranges::lower_bound(samples.abscissa, x) - samples.abscissa.begin());
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

std::optional<Interpolated> sample_at(const Samples& samples, double x, double coincidence) {
  const std::size_t next = next_of(samples, x - coincidence);
  if (next == samples.abscissa.size() || std::abs(samples.abscissa[next] - x) > coincidence)
    return std::nullopt;
  return Interpolated{samples.values[next], samples.half_width[next]};
}

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
  result.half_width += size < 5 ? std::abs(result.value - polynomial(samples, x, next, 2).value)
                                : 2.0 * std::clamp(4.0 * place * (1.0 - place), 0.0, 1.0) *
                                      std::min(most_rough, roughness_at(samples, x));
  return result;
}

double gap_at(const Samples& samples, double x) {
  const std::size_t next = next_of(samples, x);
  if (next == 0 || next == samples.abscissa.size()) return std::numeric_limits<double>::infinity();
  return samples.abscissa[next] - samples.abscissa[next - 1];
}

}  // namespace stickslip::studies
