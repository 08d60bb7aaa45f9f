// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// N μ(v), N, and its derivative by v, N s/m.
struct SlipResistance {
  double force{};
  double slope{};
};

/// The resistance of a contact that slides with the speed v. Analytic through v = 0, so that a trial step may pass
/// it. The law has a finite decay (FrictionLaw::in_slip()).
[[nodiscard]] inline SlipResistance slip_resistance(const data::FrictionLaw& law, double normal_force,
                                                    double speed) {
  const double weakening = law.static_coefficient() - law.kinetic_coefficient();
  const double falling = weakening * std::exp(-law.decay() * speed);
  return {normal_force * (law.kinetic_coefficient() + falling + law.viscous() * speed),
          normal_force * (law.viscous() - law.decay() * falling)};
}

/// The speed at which the resistance falls by `fall`, N s/m, with the speed: the inverse of -slip_resistance().slope.
/// Zero if it nowhere falls so fast, infinity if it does so at each speed.
[[nodiscard]] inline double speed_of_fall(const data::FrictionLaw& law, double normal_force, double fall) {
  const double weakening = law.static_coefficient() - law.kinetic_coefficient();
  const double at_rest = normal_force * weakening * law.decay();
  const double exponential = fall + law.viscous() * normal_force;
  if (at_rest <= exponential) return 0.0;
  return exponential > 0.0 ? std::log(at_rest / exponential) / law.decay()
                           : std::numeric_limits<double>::infinity();
}

}  // namespace stickslip::analytic
