// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/key.hpp"

namespace stickslip::studies {

/// Angular frequency Ω = 2 π f of the excitation, rad/s.
[[nodiscard]] double angular_frequency(const data::HarmonicExcitation& excitation);

/// μ_s P, N.
[[nodiscard]] double friction_limit(const data::Case& problem);

/// Whether the force that holds the contact, or its limit, is proportional to the number of a key: KeyEffects::is_a_factor, or
/// excitation.scale where analytic::is_proportional_to_scale().
[[nodiscard]] bool is_a_factor(const data::Case& problem, std::string_view key);

/// E/(κ G) of a rectangular section with κ = 5/6 and Poisson's ratio 0.3.
constexpr double shear_flexibility = 3.12;

/// The beam with the shear stiffness E A/shear_flexibility unless it has one; and rigid in shear.
[[nodiscard]] data::Beam with_shear(const data::Beam& beam);
[[nodiscard]] data::Beam without_shear(const data::Beam& beam);

/// The force at the tip of a cantilever over its deflection, 3 E I/L³, N/m.
[[nodiscard]] double tip_stiffness(const data::Beam& beam);

/// What wall.speed must be for them, and why, as the end of an error message.
inline constexpr std::string_view resting_wall =
    "0 here: a wall that moves bends the beam until it slips; respond (by finite elements or event-driven), "
    "animate, "
    "squeal and periodic follow it";

/// Throws data::FieldError if wall.speed is not 0: the wall then bends the beam until it slips, so that neither
/// the criterion nor the closed form of the stick state holds.
void require_resting_wall(const data::Case& problem);

/// Throws data::FieldError for a start off the wall or in motion, and for a constant force.
void require_start_at_rest(const data::Case& problem);

/// Throws data::FieldError if the static coefficient is 0, because a force ratio or a margin divides by it.
void require_friction(const data::Case& problem);

inline constexpr double two_pi = 2.0 * std::numbers::pi;

/// The natural frequency (Hz) of stick mode `mode` by the closed form, Eqs. (23) and (24). Throws what
/// stick_modes() throws.
[[nodiscard]] inline double stick_hz(const data::Beam& beam, int mode) {
  return analytic::stick_modes(beam, mode).back().frequency_hz();
}

}  // namespace stickslip::studies
