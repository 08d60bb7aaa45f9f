// SPDX-License-Identifier: MIT
#include "validation/estimators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace stickslip::validation {

namespace {

// The time at which the values pass the level between i and i + 1.
double crossing(const Record& record, std::span<const double> values, std::size_t i, double level) {
  const double share = (level - values[i]) / (values[i + 1] - values[i]);
  return record.time[i] + share * (record.time[i + 1] - record.time[i]);
}

double fall_time(const Record& record, std::span<const double> values, std::size_t top, std::size_t bottom) {
  const double drop = values[top] - values[bottom];
  std::size_t first = top, last = bottom;
  for (std::size_t i = top; i < bottom; ++i)
    if (values[i] >= values[top] - 0.1 * drop) first = i;
  for (std::size_t i = bottom; i > first; --i)
    if (values[i] <= values[bottom] + 0.1 * drop) last = i;
  return crossing(record, values, last - 1, values[bottom] + 0.1 * drop) -
         crossing(record, values, first, values[top] - 0.1 * drop);
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_error(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  if (values.size() < 2) return std::numeric_limits<double>::infinity();
  const double middle = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / (n - 1.0) / n);
}

std::vector<double> without_drift(std::span<const double> values, std::size_t half_width) {
  std::vector<double> sums{0.0};
  for (const double value : values) sums.push_back(sums.back() + value);
  std::vector<double> rest;
  for (std::size_t i = half_width; i + half_width < values.size(); ++i)
    rest.push_back(values[i] - (sums[i + half_width + 1] - sums[i - half_width]) /
                                   static_cast<double>(2 * half_width + 1));
  return rest;
}

// The lag in samples of the first maximum of the autocorrelation above `from`, by a parabola through three values.
double first_maximum(std::span<const double> values, std::size_t from) {
  const auto correlation = [&](std::size_t lag) {
    return std::inner_product(values.begin(), values.end() - static_cast<std::ptrdiff_t>(lag),
                              values.begin() + static_cast<std::ptrdiff_t>(lag), 0.0) /
           static_cast<double>(values.size() - lag);
  };
  double before = correlation(from), here = correlation(from + 1);
  for (std::size_t lag = from + 1; lag + 1 < values.size() / 2; ++lag) {
    const double after = correlation(lag + 1);
    if (here > 0.0 && here >= before && here > after)
      return static_cast<double>(lag) + 0.5 * (before - after) / (before - 2.0 * here + after);
    before = std::exchange(here, after);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

double noise_of(std::span<const double> values) {
  std::vector<double> differences;
  for (std::size_t i = 3; i < values.size(); ++i)
    differences.push_back(std::abs(values[i] - 3.0 * values[i - 1] + 3.0 * values[i - 2] - values[i - 3]));
  // 0.6745: the median of |x| of a standard normal x; 20 = 1 + 9 + 9 + 1.
  return median_of(std::move(differences)) / (0.6745 * std::sqrt(20.0));
}

std::vector<double> running_median(std::span<const double> values, std::size_t width) {
  width = std::min(width, values.size());
  std::vector<double> medians;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t begin = std::min(std::max(i, width / 2) - width / 2, values.size() - width);
    const auto window = values.subspan(begin, width);
    medians.push_back(median_of({window.begin(), window.end()}));
  }
  return medians;
}

std::vector<std::size_t> turning_points(std::span<const double> values, double threshold) {
  std::vector<std::size_t> points;
  std::size_t high = 0, low = 0;
  bool falls = false;  // whether the last point was a maximum
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[high]) high = i;
    if (values[i] < values[low]) low = i;
    if (!falls && values[high] - values[i] > threshold) {
      points.push_back(high);
      falls = true;
      low = i;
    } else if (falls && values[i] - values[low] > threshold) {
      points.push_back(low);
      falls = false;
      high = i;
    }
  }
  return points;
}

std::vector<Cycle> cycles_of(const Record& record, double threshold) {
  const std::span<const double> force = record.force;
  const std::vector<std::size_t> points = turning_points(force, threshold);
  if (points.size() < 3) return {};
  std::vector<double> periods;
  for (std::size_t i = 0; i + 2 < points.size(); i += 2)
    periods.push_back(record.time[points[i + 2]] - record.time[points[i]]);
  const double longest = 0.05 * median_of(periods);
  std::vector<Cycle> cycles;
  for (std::size_t i = 0; i + 2 < points.size(); i += 2) {
    const auto [top, bottom, next] = std::tuple(points[i], points[i + 1], points[i + 2]);
    double gap = 0.0;
    for (std::size_t j = top; j < next; ++j) gap = std::max(gap, record.time[j + 1] - record.time[j]);
    if (gap > longest) continue;
    cycles.push_back(
        {.begin = record.time[top],
         .period = record.time[next] - record.time[top],
         .highest = force[top],
         .lowest = force[bottom],
         .fall_time = fall_time(record, force, top, bottom),
         .rise_rate = (force[next] - force[bottom]) / (record.time[next] - record.time[bottom])});
  }
  return cycles;
}

Figure mean_of(std::span<const double> values, double resolution) {
  constexpr std::size_t blocks = 8;
  std::vector<double> means;
  if (values.size() >= 2 * blocks)
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t begin = b * values.size() / blocks, end = (b + 1) * values.size() / blocks;
      means.push_back(mean(values.subspan(begin, end - begin)));
    }
  const double spread = std::max(standard_error(values), means.empty() ? 0.0 : standard_error(means));
  return {mean(values), std::hypot(spread, resolution), values.size()};
}

Figure period_by_autocorrelation(const Record& record, double guess) {
  constexpr std::size_t parts = 4;
  const double step =
      (record.time.back() - record.time.front()) / static_cast<double>(record.time.size() - 1);
  const auto samples = static_cast<std::size_t>(guess / step);
  const std::vector<double> rest = without_drift(record.force, 2 * samples);
  std::vector<double> periods;
  for (std::size_t p = 0; p < parts; ++p) {
    const std::size_t begin = p * rest.size() / parts, end = (p + 1) * rest.size() / parts;
    periods.push_back(step * first_maximum(std::span(rest).subspan(begin, end - begin), samples / 2));
  }
  return {std::accumulate(periods.begin(), periods.end(), 0.0) / static_cast<double>(parts),
          standard_error(periods), parts};
}

}  // namespace stickslip::validation
