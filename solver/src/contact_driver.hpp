// SPDX-License-Identifier: MIT
#pragma once

#include "contact_motion.hpp"

namespace stickslip::solver {

/// A ContactScheme, which decides when the contact changes: takes the motion towards end_time, the end of its grid step:
/// there, or to a change of the contact.
using ContactDriver = void (*)(ContactMotion& motion, double end_time);

[[nodiscard]] ContactDriver driver_of(const ContactMotion& motion);

}  // namespace stickslip::solver
