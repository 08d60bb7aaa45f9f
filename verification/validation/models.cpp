// SPDX-License-Identifier: MIT
#include "validation/models.hpp"

#include <cmath>
#include <numbers>

namespace stickslip::validation {

using std::numbers::pi;

Values rigid_slider(const Slider& slider, double kinetic, double excess) {
  const double omega = slider.angular_frequency();
  const double ratio = excess * omega / slider.stick_rate();
  const double period = 2.0 / omega * (pi - std::atan(ratio) + ratio);
  const double range = 2.0 * std::hypot(excess, slider.stick_rate() / omega);
  return {{"period", period},
          {"force_range", range},
          {"fall_time", (std::acos(-0.8) - std::acos(0.8)) / omega},
          {"mean_force", kinetic},
          {"rise_ratio", range / (slider.stick_rate() * (period - pi / omega))}};
}

double rigid_slider_force(const Slider& slider, double kinetic, double excess, double t) {
  const double omega = slider.angular_frequency();
  const double ratio = excess * omega / slider.stick_rate();
  const double slip = 2.0 * (pi - std::atan(ratio)) / omega;
  const double since = std::fmod(t, slip + 2.0 * ratio / omega);
  if (since > slip) return kinetic - excess + slider.stick_rate() * (since - slip);
  return kinetic + excess * std::cos(omega * since) + slider.stick_rate() / omega * std::sin(omega * since);
}

Values damper_loop(double amplitude, double slip_force, double contact_stiffness, double play) {
  return {{"slip_force", slip_force},
          {"energy", 4.0 * slip_force * (amplitude - slip_force / contact_stiffness - 0.5 * play)}};
}

Values strip_frequencies(const Strip& strip) {
  const double first = strip.height * std::sqrt(strip.modulus / (12.0 * strip.density)) /
                       (2.0 * pi * strip.length * strip.length);
  Values values;
  for (int n = 1; n <= 4; ++n) {
    double b = (n - 0.5) * pi;
    // Newton's method for cos(b) + 1/cosh(b) = 0.
    for (int i = 0; i < 8; ++i)
      b += (std::cos(b) + 1.0 / std::cosh(b)) / (std::sin(b) + std::tanh(b) / std::cosh(b));
    values["frequency_" + std::to_string(n)] = first * b * b;
  }
  return values;
}

Figures propagated(const std::function<Values(const std::vector<double>&)>& model,
                   const std::vector<Figure>& inputs) {
  std::vector<double> values;
  for (const Figure& input : inputs) values.push_back(input.value);
  Figures results;
  for (const auto& [quantity, value] : model(values)) results[quantity].value = value;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    values[i] = inputs[i].value + inputs[i].uncertainty;
    const Values above = model(values);
    values[i] = inputs[i].value - inputs[i].uncertainty;
    const Values below = model(values);
    values[i] = inputs[i].value;
    for (auto& [quantity, result] : results)
      result.uncertainty = std::hypot(result.uncertainty, 0.5 * (above.at(quantity) - below.at(quantity)));
  }
  return results;
}

}  // namespace stickslip::validation
