// SPDX-License-Identifier: MIT
#pragma once

#include "contact_motion.hpp"

namespace stickslip::solver {

/// When a stuck contact lets go in the step from motion.time() to end_time, s: the excess force, below zero
/// now, is above it at the end.
[[nodiscard]] double onset_time(ContactMotion& motion, double excess_now, double end_time,
                                double excess_at_end);

/// When a sliding contact comes to rest in the step from motion.time() to end_time, s: its velocity in the
/// direction of the phase is no longer positive at the end.
[[nodiscard]] double rest_time(ContactMotion& motion, double end_time, double forward_velocity_at_end);

}  // namespace stickslip::solver
