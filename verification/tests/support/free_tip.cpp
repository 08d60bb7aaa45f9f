// SPDX-License-Identifier: MIT
#include "support/free_tip.hpp"

#include "support/beams.hpp"

namespace stickslip::testing {

solver::ContactSystem free_tip_system(const solver::BeamModel& model, const solver::PrescribedMotion& base,
                                      const data::Damping& damping) {
  constexpr double speed = 1e3;
  solver::ContactSystem system = solver::beam_contact_system(model, paper_friction(), base, damping);
  system.normal_force = 0.0;
  system.wall = {.displacement = [](double t) { return speed * t; },
                 .velocity = [](double) { return speed; },
                 .acceleration = [](double) { return 0.0; }};
  return system;
}

}  // namespace stickslip::testing
