// SPDX-License-Identifier: MIT
#include "validation/experiments.hpp"

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

}  // namespace

double Slider::angular_frequency() const { return std::sqrt(stiffness / mass); }

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
  return figures;
}

}  // namespace stickslip::validation
