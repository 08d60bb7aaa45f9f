// SPDX-License-Identifier: MIT
#pragma once

#include "stickslip/data/problem.hpp"

namespace stickslip::data {

/// excitation.duration where a case does not state it: that of the paper, s.
constexpr double default_duration = 10.0;

/// Settings for a case that does not state them, from its shortest vibration that matters. That is stick mode
/// k: the tenth, or the first of more than four times the excitation frequency if that is higher, at most the
/// 200th. Its frequency without axial force is f_k = ((k + 1/4) pi)^2 sqrt(EI/(rho A L^4))/(2 pi), to 1e-7 of
/// itself.
///
///     elements            4 k: four for each half-wave of mode k
///     time_step           1/(50 f_k), rounded down to 1, 2 or 5 times a power of ten, at most the duration if that is
///                         positive, s
///     spectral_radius     0.9
///     velocity_threshold  0 m/s
///     modes               k
///
/// Why these: see the user guide, "Defaults of [numerics]".
[[nodiscard]] NumericalChoices default_numerics(const Beam& beam, const HarmonicExcitation& excitation,
                                                double duration);

}  // namespace stickslip::data
