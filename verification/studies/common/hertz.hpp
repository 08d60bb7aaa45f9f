// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "stickslip/analytic/stick_modes.hpp"

namespace stickslip::studies {

inline constexpr double two_pi = 2.0 * std::numbers::pi;

/// The natural frequency (Hz) of stick mode `mode` by the closed form, Eqs. (23) and (24). Throws what
/// stick_modes() throws.
[[nodiscard]] inline double stick_hz(const data::Beam& beam, int mode) {
  return analytic::stick_modes(beam, mode).back().frequency_hz();
}

}  // namespace stickslip::studies
