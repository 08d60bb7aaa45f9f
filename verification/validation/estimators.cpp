// SPDX-License-Identifier: MIT
#include "validation/estimators.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "validation/models.hpp"

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

// The middle one of the values in their order, the upper one of two; not a number for none.
double median_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// The median of the `width` values around each value; at the ends of the first or last ones. It takes out impulses and keeps
// steps.
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

}  // namespace

double noise_of(std::span<const double> values) {
  std::vector<double> differences;
  for (std::size_t i = 3; i < values.size(); ++i)
    differences.push_back(std::abs(values[i] - 3.0 * values[i - 1] + 3.0 * values[i - 2] - values[i - 3]));
  // 0.6745: the median of |x| of a standard normal x; 20 = 1 + 9 + 9 + 1.
  return median_of(std::move(differences)) / (0.6745 * std::sqrt(20.0));
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

namespace {

// From one maximum of the force to the next.
struct Cycle {
  double period{};     // s
  double highest{};    // the maximum at the begin
  double lowest{};     // the minimum that follows
  double fall_time{};  // from 90 to 10 % of the way between them, s
  double rise_rate{};  // the mean rate from the minimum to the next maximum, 1/s
};

// The cycles of the force between its turning points. A cycle with a gap in time of more than a twentieth of the median period is left out.
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
        {.period = record.time[next] - record.time[top],
         .highest = force[top],
         .lowest = force[bottom],
         .fall_time = fall_time(record, force, top, bottom),
         .rise_rate = (force[next] - force[bottom]) / (record.time[next] - record.time[bottom])});
  }
  return cycles;
}

// The mean of a value of the cycles. Half of what a second count of the cycles changes is uncertain.
Figure compared_mean(const std::vector<Cycle>& cycles, const std::vector<Cycle>& fewer,
                     const std::function<double(const Cycle&)>& value, double resolution) {
  std::vector<double> values, others;
  for (const Cycle& cycle : cycles) values.push_back(value(cycle));
  for (const Cycle& cycle : fewer) others.push_back(value(cycle));
  Figure figure = mean_of(values, resolution);
  if (others.size() >= 2)
    figure.uncertainty = std::hypot(figure.uncertainty, 0.5 * (figure.value - mean(others)));
  return figure;
}

// One stroke from a reversal of the displacement to the next, with the signs of a stroke upwards.
struct Stroke {
  std::vector<double> way;    // from the reversal on, m
  std::vector<double> force;  // N
};

Stroke stroke_of(const Record& record, std::size_t begin, std::size_t end) {
  Stroke stroke;
  const double sign = record.displacement[end] > record.displacement[begin] ? 1.0 : -1.0;
  for (std::size_t i = begin; i <= end; ++i) {
    stroke.way.push_back(sign * (record.displacement[i] - record.displacement[begin]));
    stroke.force.push_back(sign * record.force[i]);
  }
  return stroke;
}

double plateau(const Stroke& stroke) {
  std::vector<double> forces;
  for (std::size_t i = 0; i < stroke.way.size(); ++i)
    if (stroke.way[i] > 0.5 * stroke.way.back() && stroke.way[i] < 0.95 * stroke.way.back())
      forces.push_back(stroke.force[i]);
  return median_of(std::move(forces));
}

// The way after which the force first exceeds a level, m.
double way_to(const Stroke& stroke, double level) {
  const auto first = std::ranges::find_if(stroke.force, [&](double force) { return force > level; });
  return stroke.way[std::min(static_cast<std::size_t>(first - stroke.force.begin()), stroke.way.size() - 1)];
}

double work(const Stroke& stroke) {
  double sum = 0.0;
  for (std::size_t i = 1; i < stroke.way.size(); ++i)
    sum += 0.5 * (stroke.force[i] + stroke.force[i - 1]) * (stroke.way[i] - stroke.way[i - 1]);
  return sum;
}

// The strokes within 5 % of the longest one, by the turning points of the displacement; pairs begin with the same direction.
std::vector<std::pair<Stroke, Stroke>> full_cycles(const Record& record) {
  const auto [low, high] = std::ranges::minmax(record.displacement);
  const std::vector<std::size_t> points = turning_points(record.displacement, 0.1 * (high - low));
  std::vector<std::pair<Stroke, Stroke>> cycles;
  for (std::size_t i = 0; i + 2 < points.size(); i += 2) {
    std::pair pair(stroke_of(record, points[i], points[i + 1]),
                   stroke_of(record, points[i + 1], points[i + 2]));
    if (std::min(pair.first.way.back(), pair.second.way.back()) > 0.95 * (high - low))
      cycles.push_back(std::move(pair));
  }
  return cycles;
}

}  // namespace

double Slider::angular_frequency() const { return std::sqrt(stiffness / moved_mass); }

double Slider::stick_rate() const { return stiffness * speed / (mass * gravity); }

Figures read_slider(const Record& record, const Slider& slider) {
  const double step = record.time[1] - record.time[0];
  const double natural_period = 2.0 * std::numbers::pi / slider.angular_frequency();
  const auto width = static_cast<std::size_t>(natural_period / 12.0 / step) | 1U;
  const double noise = noise_of(record.force);
  const Record smooth{.time = record.time, .displacement = {}, .force = running_median(record.force, width)};
  const double left = noise_of(smooth.force);
  const std::vector<Cycle> cycles = cycles_of(smooth, 8.0 * noise), fewer = cycles_of(smooth, 12.0 * noise);
  const auto read = [&](auto value, double resolution) {
    return compared_mean(cycles, fewer, value, resolution);
  };
  Figures figures;
  figures["period"] = read([](const Cycle& c) { return c.period; }, 0.0);
  figures["force_range"] =
      read([](const Cycle& c) { return c.highest - c.lowest; }, std::numbers::sqrt2 * left);
  figures["highest"] = read([](const Cycle& c) { return c.highest; }, left);
  figures["lowest"] = read([](const Cycle& c) { return c.lowest; }, left);
  figures["fall_time"] = read([](const Cycle& c) { return c.fall_time; }, step / std::sqrt(12.0));
  figures["rise_ratio"] = read([&](const Cycle& c) { return c.rise_rate / slider.stick_rate(); }, 0.0);
  figures["mean_force"] = mean_of(record.force, 0.0);
  if (slider.speed > 1e-3) figures["second_period"] = period_by_autocorrelation(smooth, natural_period);
  return figures;
}

Figures read_damper(const Record& record) {
  std::map<std::string, std::vector<double>> values;
  for (const auto& [down, up] : full_cycles(record)) {
    const double force = 0.5 * (plateau(up) + plateau(down));
    values["amplitude"].push_back(0.25 * (up.way.back() + down.way.back()));
    values["slip_force"].push_back(force);
    values["force_offset"].push_back(0.5 * (plateau(up) - plateau(down)));
    values["peak_force"].push_back(0.5 * (std::ranges::max(up.force) + std::ranges::max(down.force)));
    values["energy"].push_back(work(up) + work(down));
    for (const auto& [stroke, before] : {std::pair(up, down), std::pair(down, up)}) {
      const double top = plateau(before);
      values["contact_stiffness"].push_back(0.5 * top /
                                            (way_to(stroke, -0.3 * top) - way_to(stroke, -0.8 * top)));
      values["play"].push_back(way_to(stroke, 0.1 * force) - way_to(stroke, -0.1 * force));
    }
  }
  Figures figures;
  for (const auto& [quantity, list] : values) figures[quantity] = mean_of(list, 0.0);
  return figures;
}

Figures read_strip(const Record& spectrum) {
  const double step = spectrum.time[1] - spectrum.time[0];
  Figures figures;
  for (const auto& [quantity, expected] : strip_frequencies(Strip{})) {
    const auto at = [&](double frequency) {
      return static_cast<std::size_t>(std::ranges::lower_bound(spectrum.time, frequency) -
                                      spectrum.time.begin());
    };
    const auto band =
        std::span(spectrum.force).subspan(at(0.85 * expected), at(1.15 * expected) - at(0.85 * expected));
    if (band.empty()) continue;
    const auto top = static_cast<std::size_t>(std::ranges::max_element(band) - band.begin());
    figures[quantity] = {spectrum.time[at(0.85 * expected) + top], step / std::sqrt(12.0), 1};
  }
  return figures;
}

}  // namespace stickslip::validation
