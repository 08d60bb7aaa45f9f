// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The share of one mode in the stick-state reaction.
struct ModalForce {
  double angular_frequency{};  ///< ω_n, rad/s
  double coefficient{};        ///< c_n = [EI U_n''' + χ P U_n'](L) C_n, N/m
};

/// The stick-state reaction of Eq. (28) per unit amplitude of the base, as a sum over modes: with φ_n =
/// Ω² g_n of Eq. (26),
///
///     f(t)/A0 = s sin(Ω t) + Σ_n c_n φ_n(t),        s = [EI S''' + χ P S'](L).
///
/// None of these numbers depends on the excitation.
struct ModalReaction {
  double quasi_static{};          ///< s, N/m
  std::vector<ModalForce> modes;  ///< ascending
};

/// The first `modes` shares, with shear if the beam has it (timoshenko_modes.hpp). Throws what stick_modes() throws.
[[nodiscard]] std::vector<ModalForce> modal_forces(const data::Beam& beam, int modes);
[[nodiscard]] ModalReaction modal_reaction(const data::Beam& beam, int modes);

}  // namespace stickslip::analytic
