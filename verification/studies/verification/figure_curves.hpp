// SPDX-License-Identifier: MIT
#pragma once

/// What Figs. 2 and 10 of the paper draw.

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"
#include "studies/verification/force_maximum.hpp"

namespace stickslip::studies {

/// The friction law of Eq. (7) at a sliding velocity.
struct FrictionPoint {
  double sliding_velocity{};  ///< m/s
  double coefficient{};       ///< μ(v)
  double friction_force{};    ///< f_d = -sgn(v) μ(v) P, N
};
STICKSLIP_MEMBERS(FrictionPoint, (sliding_velocity, "m/s"), (coefficient, "1"), (friction_force, "N"))

/// Fig. 2, from -5 to 5 m/s. The force jumps at v = 0, which stands there twice.
[[nodiscard]] std::vector<FrictionPoint> friction_curve(const data::FrictionLaw& law, double normal_force);

/// Largest static friction forces at one frequency.
struct ForceLine {
  double frequency_hz{};
  std::vector<double> amplitude;  ///< m, ascending
  std::vector<double> force_max;  ///< |f_max|, N
};
STICKSLIP_MEMBERS(ForceLine, (frequency_hz, "Hz"), (amplitude, "m"), (force_max, "N"))

/// Fig. 10 up to 1 mm. |f_max| is proportional to the amplitude and reaches the friction limit μ_s P (N) at the critical
/// one, which `criterion` has: of its points every hertz, and every 0.25 Hz within 2 Hz of a natural frequency (Hz).
[[nodiscard]] std::vector<ForceLine> force_surface(double friction_limit,
                                                   const std::vector<CriticalAmplitudePoint>& criterion,
                                                   const std::vector<double>& natural_frequencies);

}  // namespace stickslip::studies
