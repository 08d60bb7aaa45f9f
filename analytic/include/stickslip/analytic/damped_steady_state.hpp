// SPDX-License-Identifier: MIT
#pragma once

/// The steady vibration of the beam with Kelvin-Voigt damping, bending moment E I (u_xx + η u_xxt), on a
/// base that moves by h(t) = A0 sin(Ω t), in closed form. With y = h + u = Im[Y(x) exp(i Ω t)] and
/// the complex rigidity D = E I (1 + i Ω η), Eq. (1) becomes
///
///     D Y'''' + P Y'' - ρ A Ω² Y = 0,        Y(0) = A0,  Y'(0) = 0,  D Y''(L) = 0,
///
/// and Y(L) = 0 with the tip held to the wall, or D Y'''(L) + χ P Y'(L) = 0 with a tip that slides without
/// friction. The exponents r of the solutions exp(r x/L) are ±b and ±c,
///
///     b² = -z/2 + √(z²/4 + s²),   c² = -z/2 - √(z²/4 + s²),
///     z = P L²/D,                      s² = ρ A Ω² L⁴/D,
///
/// complex, with real parts that are not negative. (Undamped, c = i bb with the bb of stick_modes.hpp.)

#include <array>
#include <complex>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// What holds at x = L.
enum class TipSupport {
  held,  ///< the stick state
  free   ///< the slip state without friction; also its response beyond the flutter or buckling load
};

/// Complex amplitudes of the steady vibration: a quantity is Im[amplitude exp(i Ω t)], its phase that
/// against the base. Accuracy: round-off, times max(1, min(|b|, |c|)⁻³) at low frequency, and times the
/// resonance factor.
class DampedSteadyState {
 public:
  using Complex = std::complex<double>;

  /// Throws data::FieldError, naming the key, for damping other than Kelvin-Voigt's: there is no such closed form with
  /// an axial force.
  DampedSteadyState(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                    const data::Damping& damping, TipSupport tip);

  /// Y(x), absolute, m; 0 ≤ x ≤ L in m.
  [[nodiscard]] Complex displacement(double x) const { return derivative(0, x); }
  /// d^order Y/dx^order, m^(1 - order).
  [[nodiscard]] Complex derivative(int order, double x) const;
  /// D = E I (1 + i Ω η), N m².
  [[nodiscard]] Complex rigidity() const noexcept { return rigidity_; }
  /// f = D Y'''(L) + χ P Y'(L), N: the sign of Eq. (28), f = -f_d with the friction force f_d on the beam. Round-off of 0
  /// with a free tip.
  [[nodiscard]] Complex friction_force() const;
  /// Heat per period, π Ω η E I ∫ |Y''|² dx, J, with the integral in closed form. It is what the
  /// base and, with a free tip, the follower force put in: π Im[A0 D Y'''(0) - (1 - χ) P Y'(L) conj(Y(L))].
  [[nodiscard]] double dissipated_energy() const;

 private:
  // weight exp(-exponent distance), with the distance from the clamp or from the tip, in lengths of the beam.
  struct BoundaryWave {
    Complex exponent, weight;
    bool from_clamp{};
  };

  data::Beam beam_;
  double length_;
  double loss_;  // π Ω η E I
  Complex rigidity_;
  std::array<BoundaryWave, 4> waves_;
};

}  // namespace stickslip::analytic
