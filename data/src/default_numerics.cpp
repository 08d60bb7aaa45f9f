// SPDX-License-Identifier: MIT
#include "stickslip/data/default_numerics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::data {

namespace {

constexpr int fewest_modes = 10, most_modes = 200;

// The largest of 1, 2 and 5 times a power of ten that is not above the value, as the double nearest to it.
double rounded_down(double value) {
  int exponent = static_cast<int>(std::floor(std::log10(value)));
  const auto multiple = [&exponent](double factor) {
    const double power = std::pow(10.0, std::abs(exponent));  // exact up to 1e22
    return exponent < 0 ? factor / power : factor * power;
  };
  if (multiple(1.0) > value) --exponent;  // just below a power of ten log10 is rounded up
  for (const double factor : {5.0, 2.0})
    if (multiple(factor) <= value) return multiple(factor);
  return multiple(1.0);
}

}  // namespace

NumericalChoices default_numerics(const Beam& beam, const HarmonicExcitation& excitation, double duration) {
  constexpr double pi = std::numbers::pi;
  const double bending_stiffness = beam.youngs_modulus() * beam.second_moment_of_area();
  const double mass = beam.density() * beam.area();
  const double unit =
      std::sqrt(bending_stiffness / mass) / (beam.length() * beam.length()) / (2.0 * pi);  // Hz
  const double resolved = 4.0 * excitation.frequency_hz();
  const double above = std::ceil(std::sqrt(resolved / unit) / pi - 0.25);
  const int k = static_cast<int>(std::clamp(above, double{fewest_modes}, double{most_modes}));
  const double wave_number = (k + 0.25) * pi;
  const double step = 1.0 / (50.0 * (wave_number * wave_number * unit));
  return {.elements = 4 * k,
          .time_step = rounded_down(duration > 0.0 ? std::min(duration, step) : step),
          .spectral_radius = 0.9,
          .velocity_threshold = 0.0,
          .modes = k,
          .duration = duration};
}

}  // namespace stickslip::data
