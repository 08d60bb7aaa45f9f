// SPDX-License-Identifier: MIT
#include "friction_contact.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace stickslip::solver {

double friction_coefficient(const data::FrictionLaw& law, double sliding_velocity) {
  const double speed = std::abs(sliding_velocity);
  return law.kinetic_coefficient() +
         (law.static_coefficient() - law.kinetic_coefficient()) * std::exp(-law.decay() * speed) +
         law.viscous() * speed;
}

FrictionContact::FrictionContact(const ContactSystem& system)
    : law_(system.friction.in_slip()),
      normal_force_(system.normal_force),
      limit_(normal_force_ == bonding_force ? bonding_force
                                            : system.friction.static_coefficient() * normal_force_) {}

double FrictionContact::force(double direction, double sliding_velocity) const {
  return -direction * friction_coefficient(law_, sliding_velocity) * normal_force_;
}

// f_d = -d mu(v) N, v = free_velocity + mobility f_d the sliding velocity at the alpha level. With w = d v
// this is w + mobility N mu(w) = d free_velocity; mu is held at mu_s for w < 0, where a trial step has
// overshot the end of the phase. (For a jump mu_s is mu_m here.) The left side is convex and rises as long as mobility N (mu_s - mu_m) alpha
// < 1, so that Newton's method from above converges without leaving the right side of the root.
double FrictionContact::alpha_level_force(double direction, double free_velocity, double mobility) const {
  const double forward = direction * free_velocity;
  const double strength = mobility * normal_force_;
  double w = forward - strength * law_.kinetic_coefficient();
  if (forward <= strength * law_.static_coefficient())
    return -direction * law_.static_coefficient() * normal_force_;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double residual = w + strength * friction_coefficient(law_, w) - forward;
    const double slope =
        1.0 - strength * weakening() * std::exp(-law_.decay() * w) + strength * law_.viscous();
    const double next = std::max(w - residual / slope, 0.0);
    if (std::abs(next - w) <= 1e-15 * std::max(w, forward)) break;
    w = next;
  }
  return force(direction, w);
}

void FrictionContact::require_unique_force(double mobility, double time, double time_step) const {
  const double fall = mobility * normal_force_ * weakening();
  if (fall < 1.0) return;
  std::ostringstream text;
  text << "time_step = " << time_step << " s: at t = " << time
       << " s the friction law falls faster than a step can follow; the step must be shorter than about "
       << time_step / fall << " s";
  throw std::runtime_error(text.str());
}

// (mu_s - mu_m) alpha, s/m: the steepest fall of mu.
double FrictionContact::weakening() const noexcept {
  return (law_.static_coefficient() - law_.kinetic_coefficient()) * law_.decay();
}

}  // namespace stickslip::solver
