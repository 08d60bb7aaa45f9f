// SPDX-License-Identifier: MIT
#include "studies/verification/figure_curves.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

std::vector<FrictionPoint> friction_curve(const data::FrictionLaw& law, double normal_force) {
  std::vector<FrictionPoint> curve;
  const auto add = [&](double velocity, double sign) {
    const double coefficient = solver::friction_coefficient(law, velocity);
    curve.push_back({velocity, coefficient, -sign * coefficient * normal_force});
  };
  constexpr int per_unit = 20, units = 5;  // points per m/s, m/s
  for (int i = -units * per_unit; i <= 0; ++i) add(static_cast<double>(i) / per_unit, -1.0);
  for (int i = 0; i <= units * per_unit; ++i) add(static_cast<double>(i) / per_unit, 1.0);
  return curve;
}

std::vector<ForceLine> force_surface(double friction_limit,
                                     const std::vector<CriticalAmplitudePoint>& criterion,
                                     const std::vector<double>& natural_frequencies) {
  std::vector<ForceLine> surface;
  for (const auto& [hz, critical_amplitude] : criterion) {
    const bool near_resonance = std::ranges::any_of(
        natural_frequencies, [&](double natural) { return std::abs(hz - natural) < 2.0; });
    const double step = near_resonance ? 0.25 : 1.0;
    if (std::abs(hz - step * std::round(hz / step)) > 1e-9) continue;
    ForceLine line{.frequency_hz = hz, .amplitude = {}, .force_max = {}};
    for (int i = 1; i <= 20; ++i) {
      line.amplitude.push_back(0.05e-3 * i);
      line.force_max.push_back(friction_limit * line.amplitude.back() / critical_amplitude);
    }
    surface.push_back(line);
  }
  return surface;
}

}  // namespace stickslip::studies
