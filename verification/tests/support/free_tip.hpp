// SPDX-License-Identifier: MIT
#pragma once

/// The beam with a tip that slides without friction: a linear system.

#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::testing {

/// The beam's contact system without normal force, pulled past a wall that is faster than any tip (1 km/s),
/// so that the sliding velocity never changes its sign and no step is divided.
[[nodiscard]] solver::ContactSystem free_tip_system(const solver::BeamModel& model,
                                                    const solver::PrescribedMotion& base,
                                                    const data::Damping& damping);

}  // namespace stickslip::testing
