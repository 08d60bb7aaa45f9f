// SPDX-License-Identifier: MIT
#pragma once

/// The stick state (clamped at x = 0, pinned at x = L, axial force P) in the usual formulas. Cancellation in
/// these formulas costs precision, which the radius includes. With p = P/EI and k = ρ A ω²/EI,
///
///     β² = -p/2 + √(p²/4 + k),     betabar² = p/2 + √(p²/4 + k),
///     U(x) = cosh(β x) - cos(betabar x) - r [betabar sinh(β x) - β sin(betabar x)],       (22)
///     r = [cosh(β L) - cos(betabar L)]/[betabar sinh(β L) - β sin(betabar L)],
///     β tan(betabar L) = betabar tanh(β L).                                                  (23)
///
/// U and C_n lose 1.44 β L bits: 256 bits give 30 digits up to about mode 30, and mode 200 needs 2048
/// bits.

#include <array>
#include <vector>

#include "stickslip/certified/beam.hpp"

namespace stickslip::certified {

/// A function value and its first three derivatives at one x.
using Derivatives = std::array<Real, 4>;

/// S(x) of Eq. (18): hyperbolic functions in tension, and the cubic polynomial at P = 0.
class QuasiStaticShape {
 public:
  /// Throws std::domain_error, naming beam.axial_force, unless P is certainly below the buckling load.
  explicit QuasiStaticShape(const Beam& beam);

  [[nodiscard]] Derivatives at(const Real& x) const;

 private:
  int sign_;  // of P
  Real length_;
  Real sigma_;  // √(|P|/EI), 1/m
};

struct StickMode {
  int number{};
  Real angular_frequency;          ///< ω, rad/s
  Real frequency_hz;               ///< ω/(2 π)
  Real hyperbolic_wave_number;     ///< β, 1/m
  Real trigonometric_wave_number;  ///< betabar, 1/m
  Real shape_ratio;                ///< r, m
  Real participation;              ///< C_n = -∫ U (1 + S) dx/∫ U² dx of Eq. (25)

  /// U(x) and its derivatives in the scale of the paper: U''(0) = β² + betabar².
  [[nodiscard]] Derivatives shape(const Real& x) const;
};

/// The first `count` modes: the roots of Eq. (23) in ascending order, as enclosures. The search starts below
/// π² √(1 - max(P, 0)/P_cr), in units of Beam::frequency_unit(). The first frequency is above this value
/// by Rayleigh's principle, since -P int u'² ≥ -(P/P_cr) EI int u''², and since the clamped end increases
/// the frequencies of the pinned-pinned beam. Throws std::invalid_argument unless 1 ≤ count ≤ 1000, and
/// what QuasiStaticShape throws. The computing time is proportional to (1 - P/P_cr)⁻¹/2 (10 ms at 1 - P/P_cr
/// = 1e-5).
[[nodiscard]] std::vector<StickMode> stick_modes(const Beam& beam, int count);

// The slip state: clamped at x = 0 and free at x = L under a follower force P. With b = β L and bb =
// betabar L of stick_modes.hpp, z = P L²/EI and κ = ω L² √(ρ A/EI) = b bb, the frequency
// equation is (Beck, ZAMP 3, 1952)
//
//     z² + 2 κ² [1 + cosh(b) cos(bb)] + z κ sinh(b) sin(bb) = 0.

/// The flutter factor P_flutter L²/EI, at which the two lowest roots coincide. The interval Newton method,
/// applied to the frequency equation and its derivative in κ, proves that the two vanish together at
/// exactly one point of a box.
[[nodiscard]] Real flutter_factor();

/// The first `count` frequencies ω of the slip state, rad/s, as enclosures. They are the roots of the frequency equation up to bb = 2 π
/// ceil(count/2), where its left side is positive. There must be two roots for each 2 π, as at P = 0. Throws
/// std::invalid_argument unless 1 ≤ count ≤ 1000, std::domain_error, naming beam.axial_force, unless P is
/// certainly below the flutter load, and what isolate_roots() throws.
[[nodiscard]] std::vector<Real> slip_frequencies(const Beam& beam, int count);

}  // namespace stickslip::certified
