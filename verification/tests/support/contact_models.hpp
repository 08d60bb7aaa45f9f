// SPDX-License-Identifier: MIT
#pragma once

/// The systems of single_mass.hpp and exact_pair.hpp once more, as the ContactModel of the event-driven
/// engine: reduced by hand, so that they share nothing with the finite-element reduction of studies/.

#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "support/exact_pair.hpp"

namespace stickslip::testing {

struct MassModel {
  double mass{1.0};
  double stiffness{};  ///< of a spring to the fixed frame
  double normal_force{};
  data::FrictionCoefficients friction{};
  double wall_acceleration{};  ///< w_tt = wall_acceleration sin(omega t)
  double omega{1.0};
};

/// A single mass has no held modes.
[[nodiscard]] analytic::ContactModel contact_model(const MassModel& mass);

/// Mass 1 kg, mu N = 1 N, on a plane shaken by w_tt = amplitude sin(2 pi t): case SDND104 of a public
/// validation manual.
[[nodiscard]] analytic::ContactModel shaken_plane(double amplitude);

/// Its mean of 10 N |v_s| over 4 <= t <= 12 s, W, from a computation with 40 digits.
struct FrictionPower {
  double amplitude, mean;
};
inline constexpr FrictionPower sdnd104_friction_powers[] = {
    {15.0, 15.2670995893716}, {1.5, 0.409062451015709}, {1.01, 2.26164121279787e-4}, {0.99, 0.0}};

/// q_1 = sigma q_2 + U T with sigma = -K_12/K_11 and U = 1/sqrt(M_11).
[[nodiscard]] double static_shape(const ForcedPair& pair);
[[nodiscard]] double mode_shape(const ForcedPair& pair);

[[nodiscard]] analytic::ContactModel contact_model(const ForcedPair& pair);

/// The `count` lowest angular frequencies, rad/s, of a model whose contact is free and whose damping and friction are left out:
/// for the beam, approximations of the clamped-free modes under follower load. From 1/omega^2 as eigenvalues of K^-1 M, so that
/// round-off is relative to the lowest. Throws std::runtime_error if one of them is complex.
[[nodiscard]] std::vector<double> free_contact_frequencies(const analytic::ContactModel& model, int count);

}  // namespace stickslip::testing
