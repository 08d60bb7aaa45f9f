// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The beam of the paper as a HeldStructure without a mesh: its clamped-pinned modes U_n, mass-normalised, and
/// the static shape σ(x) = -S(x) of a unit tip deflection, all in closed form. In the frame of the base
///
///     u(x,t) = σ(x) u_L(t) + Σ_n U_n(x) T_n(t),     y = h + u,
///
/// and, by Galerkin's method on
///
///     ρA ü + EI (u + η u̇)'''' + P u'' = -ρA ḧ,      EI (u + η u̇)'''(L) + χ P u'(L) = -f_d,
///
/// the coefficients are
///
///     a_n = ρ A ∫ U_n σ dx,    m_c = ρ A ∫ σ² dx,    k_c = -EI σ'''(L) - P σ'(L),
///     l_n = (1 - χ) P U_n'(L),    l_c = (1 - χ) P σ'(L),    p = ρ A ∫ (U_n, σ) dx.
///
/// Kelvin-Voigt damping is η times the bending stiffness, K + P ∫ u' u' dx. Modal damping gives the
/// fraction ζ_n of critical to mode n of the same space with its tip free and P = 0.
///
/// Truncation in slip. The coefficients of u fall as n⁻⁵, and those of the adjoint problem as P n⁻³. The slip
/// frequencies converge as P N⁻³ + N⁻⁵, and so does the motion of the tip if friction is smooth or the beam is damped.
/// Undamped stick-slip need not converge: the mass m that N modes oppose to an impulse at the tip falls as 1/N, and the
/// rate that bounds the growth of a disturbance is at least (μ_s - μ_m) α P/m. Use boundary_integral.hpp there.
///
/// Truncation in stick. σ carries the static part of the reaction. Its terms at Ω alternate and fall as
/// P n⁻⁴ + n⁻⁶ (those of Eq. (28) as n⁻²), the free vibrations of the start as n⁻⁴, which is N⁻³ in sum.
class HeldBeam {
 public:
  /// Throws data::FieldError, naming beam.axial_force, unless 0 < P < P_cr, and what stick_modes()
  /// throws.
  HeldBeam(const data::Beam& beam, const data::Damping& damping, int modes);

  [[nodiscard]] const HeldStructure& structure() const noexcept { return structure_; }

  /// U_n(x), the σ(x) last: u(x) is its product with (T, u_L). 0 ≤ x ≤ L in m.
  [[nodiscard]] std::vector<double> shapes(double x) const;

 private:
  void add_damping(const data::Beam& beam, const data::Damping& damping, const Matrix& mass);

  std::vector<StickMode> modes_;
  QuasiStaticShape static_shape_;
  std::vector<double> scale_;  // 1/√(ρ A ∫ U_n² dx)
  HeldStructure structure_;
};

/// y(x,t) = h + u, m, of a run of a HeldBeam at its time(); `shapes` are HeldBeam::shapes(x).
[[nodiscard]] double absolute_displacement(const std::vector<double>& shapes, const EventDriven& run);

}  // namespace stickslip::analytic
