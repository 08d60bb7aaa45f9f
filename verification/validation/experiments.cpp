// SPDX-License-Identifier: MIT
#include "validation/experiments.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace stickslip::validation {

namespace {

// The mean of a value of the cycles; what a second count of the cycles changes counts by half.
Figure compared_mean(const std::vector<Cycle>& cycles, const std::vector<Cycle>& fewer,
                     const std::function<double(const Cycle&)>& value, double resolution) {
  const auto values_of = [&](const std::vector<Cycle>& all) {
    std::vector<double> values;
    for (const Cycle& cycle : all) values.push_back(value(cycle));
    return values;
  };
  const double second = fewer.size() < 2 ? 0.0 : mean_of(values_of(fewer), 0.0).value;
  Figure figure = mean_of(values_of(cycles), resolution);
  if (fewer.size() >= 2) figure.uncertainty = std::hypot(figure.uncertainty, 0.5 * (figure.value - second));
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

}  // namespace stickslip::validation
