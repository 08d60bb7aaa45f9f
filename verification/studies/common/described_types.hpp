// SPDX-License-Identifier: MIT
#pragma once

/// The members of the problem, and of what both implementations return, as studies hand them on.

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/common/members.hpp"

namespace stickslip::data {
STICKSLIP_MEMBERS(Beam, (length(), "m"), (area(), "m^2"), (second_moment_of_area(), "m^4"),
                  (density(), "kg/m^3"), (youngs_modulus(), "Pa"), (axial_force(), "N"),
                  (axial_direction(), "1"), (shear_stiffness(), "N"))
STICKSLIP_MEMBERS(FrictionLaw, (static_coefficient(), "1"), (kinetic_coefficient(), "1"), (decay(), "s/m"),
                  (viscous(), "s/m"))
STICKSLIP_MEMBERS(ContactEvent, (change, "-"), (time, "s"), (position, "m"))
STICKSLIP_MEMBERS(HarmonicExcitation, (frequency_hz(), "Hz"), (amplitude(), "m"))
STICKSLIP_MEMBERS(NumericalSettings, (elements(), "1"), (time_step(), "s"), (spectral_radius(), "1"),
                  (velocity_threshold(), "m/s"), (modes(), "1"), (duration(), "s"))
STICKSLIP_MEMBERS(Case, (beam), (friction), (excitation), (numerics))
STICKSLIP_MEMBERS(PrintedNumber, (id, "-"), (value), (unit, "-"), (printed, "-"), (printed_unit, "-"),
                  (place, "-"), (meaning, "-"))
}  // namespace stickslip::data

namespace stickslip::analytic {
STICKSLIP_MEMBERS(Bounds, (lower), (upper), (midpoint()))
STICKSLIP_MEMBERS(FrequencyBand, (from_hz, "Hz"), (to_hz, "Hz"))
STICKSLIP_MEMBERS(EventDrivenEnergy, (kinetic, "J"), (potential, "J"), (base_work, "J"), (follower_work, "J"),
                  (damping_loss, "J"), (friction_loss, "J"))
}  // namespace stickslip::analytic

namespace stickslip::solver {
STICKSLIP_MEMBERS(EnergyBalance, (kinetic, "J"), (elastic, "J"), (base_work, "J"), (follower_work, "J"),
                  (damping_loss, "J"), (friction_loss, "J"), (capture_loss, "J"), (initial_energy, "J"),
                  (change(), "J"), (residual(), "J"))
}  // namespace stickslip::solver
