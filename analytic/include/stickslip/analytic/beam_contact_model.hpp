// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The beam of the paper as a ContactModel without a mesh: its clamped-pinned modes U_n, mass-normalised, and
/// the static shape sigma(x) = -S(x) of a unit tip deflection, all in closed form. In the frame of the base
///
///     u(x,t) = sigma(x) u_L(t) + sum_n U_n(x) T_n(t),     w(t) = V t - h(t),     y = h + u,
///
/// and, by Galerkin's method on rho A u_tt + EI (u + eta u_t)_xxxx + P u_xx = -rho A h_tt with the condition EI
/// (u + eta u_t)'''(L) + chi P u'(L) = -f_d,
///
///     a_n = rho A int U_n sigma dx,    m_c = rho A int sigma^2 dx,    k_c = -EI sigma'''(L) - P sigma'(L),
///     l_n = (1 - chi) P U_n'(L),    l_c = (1 - chi) P sigma'(L),    b = A0 Omega^2 rho A int (U_n, sigma) dx.
///
/// Kelvin-Voigt damping is eta times the bending stiffness, K + P int u' u' dx. Modal damping gives the
/// fraction zeta of critical to every mode of the same space with its tip free and P = 0.
///
/// Truncation in slip. The coefficients of u fall as n^-5, and those of the adjoint problem as P n^-3. The slip
/// frequencies converge as P N^-3 + N^-5, and so does the motion of the tip if friction is smooth or the beam is damped.
/// Undamped stick-slip need not converge: the mass m that N modes oppose to an impulse at the tip falls as 1/N, and the
/// rate that bounds the growth of a disturbance is at least (mu_s - mu_m) alpha P/m. Use boundary_integral.hpp there.
///
/// Truncation in stick. sigma carries the static part of the reaction. Its terms at Omega alternate and fall as
/// P n^-4 + n^-6 (those of Eq. (28) as n^-2), the free vibrations of the start as n^-4, which is N^-3 in sum.
class BeamContactModel {
 public:
  /// Throws data::FieldError, naming beam.axial_force, unless 0 < P < P_cr, and what stick_modes()
  /// throws.
  BeamContactModel(const data::Beam& beam, const data::FrictionLaw& friction,
                   const data::HarmonicExcitation& excitation, const data::Damping& damping, int modes,
                   const data::Wall& wall = {});

  [[nodiscard]] const ContactModel& model() const noexcept { return model_; }

  /// U_n(x), the sigma(x) last: u(x) is its product with (T, u_L). 0 <= x <= L in m.
  [[nodiscard]] std::vector<double> shapes(double x) const;

 private:
  void add_damping(const data::Beam& beam, const data::Damping& damping, const Matrix& mass);

  std::vector<StickMode> modes_;
  QuasiStaticShape static_shape_;
  std::vector<double> scale_;  // 1/sqrt(rho A int U_n^2 dx)
  ContactModel model_;
};

/// y(x,t) = h + u, m, of a run of a BeamContactModel at its time(), with `shapes` =
/// BeamContactModel::shapes(x).
[[nodiscard]] double absolute_displacement(const std::vector<double>& shapes, const EventDriven& run);

}  // namespace stickslip::analytic
