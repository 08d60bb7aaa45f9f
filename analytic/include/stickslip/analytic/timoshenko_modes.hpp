// SPDX-License-Identifier: MIT
#pragma once

/// Natural frequencies of the Timoshenko beam without axial force, clamped at x = 0, in closed form. With the
/// deflection w, the rotation phi of the section, the shear modulus G and the shear coefficient k,
///
///     rho A w_tt = k G A (w_xx - phi_x),       rho I phi_tt = EI phi_xx + k G A (w_x - phi),
///
/// w = phi = 0 at x = 0, and at x = L w = phi_x = 0 (held, a pin) or phi_x = w_x - phi = 0 (free). (Timoshenko,
/// Phil. Mag. 41, 1921; frequency equations: Huang, J. Appl. Mech. 28, 1961.) With
///
///     r^2 = I/(A L^2),   s^2 = EI/(k G A L^2),   B = rho A L^4 omega^2/EI
///
/// the solutions are sums of cosh, sinh(m x/L) and cos, sin(n x/L), where m^2 and -n^2 are the roots of
/// q^2 + B (r^2 + s^2) q - B (1 - B r^2 s^2) = 0. With a = m^2 + B s^2 and c = n^2 - B s^2 = B/a the frequency
/// equations are
///
///     held:  a sin(n) cosh(m) - c m/n cos(n) sinh(m) = 0,
///     free:  2 + (a/c + c/a) cosh(m) cos(n) + (m/n - n/m) sinh(m) sin(n) = 0.
///
/// r = s = 0 is the beam of Euler and Bernoulli. Below the cut-off frequency sqrt(k G A/(rho I)), where m = 0,
/// mode j lies in j pi < n < (j + 1/2) pi (held) or (j - 1) pi < n < j pi (free): the left side changes its sign
/// there. That there is no second root in between is not proven; the tests find none.

#include <vector>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// What a section does in shear.
struct ShearProperties {
  double shear_coefficient{5.0 / 6.0};  ///< k > 0: the share of the area that takes the shear force
  double poisson_ratio{0.3};            ///< nu, -1 < nu < 0.5: G = E/(2 (1 + nu))
};

/// s^2 above, dimensionless. Throws data::FieldError for properties that are not allowed.
[[nodiscard]] double shear_flexibility(const data::Beam& beam, const ShearProperties& shear);

/// The cut-off frequency sqrt(k G A/(rho I)), rad/s. Throws as shear_flexibility().
[[nodiscard]] double timoshenko_cutoff(const data::Beam& beam, const ShearProperties& shear);

/// The first `count` natural frequencies, rad/s, ascending. Relative error: a few eps times the number of the
/// mode. Throws data::FieldError, naming beam.axial_force unless it is 0, numerics.modes unless 1 <= count and
/// all of them are below the cut-off frequency, and as shear_flexibility().
[[nodiscard]] std::vector<double> timoshenko_frequencies(const data::Beam& beam, const ShearProperties& shear,
                                                         TipSupport tip, int count);

}  // namespace stickslip::analytic
