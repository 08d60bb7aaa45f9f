// SPDX-License-Identifier: MIT
#pragma once

#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::testing {

/// The beam with a tip that slides without friction, a linear system: no normal force, and a wall that is faster than any
/// tip (1 km/s), so that the sliding velocity never changes its sign and no step is divided.
inline solver::ContactSystem free_tip_system(const solver::BeamModel& model,
                                             const solver::PrescribedMotion& base,
                                             const data::Damping& damping) {
  constexpr double speed = 1e3;
  solver::ContactSystem system = solver::beam_contact_system(model, data::FrictionLaw({}), base, damping);
  system.normal_force = 0.0;
  system.wall = {.displacement = [](double t) { return speed * t; },
                 .velocity = [](double) { return speed; },
                 .acceleration = [](double) { return 0.0; }};
  return system;
}

}  // namespace stickslip::testing
