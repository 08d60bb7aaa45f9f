// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

class ChebyshevTable;

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
  double inertia{};  ///< m, N s²/m: f/A0 has m Ω² sin(Ω t) besides, of modes that are not among these
};

/// The first `modes` shares, with shear if the beam has it (timoshenko_modes.hpp). Throws what stick_modes() throws.
[[nodiscard]] std::vector<ModalForce> modal_forces(const data::Beam& beam, int modes);
[[nodiscard]] ModalReaction modal_reaction(const data::Beam& beam, int modes);

/// The modal reactions of all beams with one χ whose load factor z = P L²/EI lies in a range, without
/// finding a root.
///
/// Made dimensionless with L, EI and ρA the modes depend on z alone. With Ω_n² = (ρA L⁴/EI) ω_n²,
///
///     1/(L³ S'''(L)),     Ω_n²,     Ω_n² c_n L³/EI
///
/// are analytic in z, up to the buckling load and beyond (where ω_1 is 0 and c_1 and S''' have a pole), and
/// s L³/EI = L³ S'''(L) (1 - χ (1 - cos(√z))). They are interpolated in Chebyshev points, as many as it takes
/// for the last coefficients to be rounding. The error is then a few roundings of the largest value in the range;
/// relative to ω_1 and c_1, that times the condition number of the first mode.
class ModalReactionTable {
 public:
  /// Of the first `modes` modes for lowest ≤ z ≤ highest. Throws std::invalid_argument unless 0 ≤ lowest
  /// ≤ highest, and what stick_modes() throws, at the buckling load for one.
  ModalReactionTable(double lowest_load_factor, double highest_load_factor, int modes,
                     double axial_direction = 0.0);

  /// Whether the beam's load factor is in the range, its χ that of the table, and the beam rigid in shear.
  [[nodiscard]] bool holds(const data::Beam& beam) const;

  /// modal_reaction(beam, modes). Throws std::invalid_argument unless holds(beam).
  [[nodiscard]] ModalReaction at(const data::Beam& beam) const;

 private:
  double lowest_, highest_, axial_direction_;
  std::shared_ptr<const ChebyshevTable> table_;
};

}  // namespace stickslip::analytic
