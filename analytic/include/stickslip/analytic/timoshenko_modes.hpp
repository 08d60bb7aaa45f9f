// SPDX-License-Identifier: MIT
#pragma once

/// The stick state of a beam with shear and rotary inertia in closed form (Timoshenko, Phil. Mag. 41, 1921; frequency
/// equations without axial force: Huang, J. Appl. Mech. 28, 1961). With the rotation phi of the section, K = k G A and
/// an axial force along the axis of the beam (Engesser's choice),
///
///     rho A w_tt = [K (w_x - phi) - P w_x]_x,       rho I phi_tt = EI phi_xx + K (w_x - phi),
///
/// w = phi = 0 at x = 0 and, at x = L, phi_x = 0 and w = 0 (held) or K (w_x - phi) - P w_x + (1 - chi) P phi = 0 (free).
/// With
///
///     r^2 = I/(A L^2),  s^2 = EI/(K L^2),  z = P L^2/EI,  e = 1 - z s^2,  B = rho A L^4 omega^2/EI
///
/// the solutions are sums of exp(+-sqrt(q) x/L) with the two roots q_1 > q_2 of
///
///     e q^2 + [B s^2 + z + B r^2 e] q - B (1 - B r^2 s^2) = 0.
///
/// q_2 < 0; q_1 is positive below the cut-off frequency sqrt(K/(rho I)) and negative above. Let a = e q + B s^2, so that
/// a_1 a_2 = -B, and C = cosh(sqrt q), T = sinh(sqrt q)/sqrt(q), entire functions of q. The amplitude of the friction force
/// f in the steady vibration with the tip held and a unit amplitude of the base is
///
///     f L^3/EI = B {[a_1 + (1 - chi) z] C_1 - [a_2 + (1 - chi) z] C_2}/D,     D = q_1 T_1 a_2 C_2 - q_2 T_2 a_1 C_1,
///
/// D = 0 is the frequency equation, and the shares c_n of ModalReaction are the residues (EI/L^3) {...}/D'(B), with
/// D' by a complex step. At B = 0, f L^3/EI = e^2 [1 - chi (1 - c0)]/(c2 - c3 + s^2 e c0) with the Stumpff functions at
/// z/e. r = s = 0 is the beam of Euler and Bernoulli.
///
/// No mode is missed: the clamped-pinned beam is the pinned-pinned one with one constraint, phi(0) = 0, so that their
/// frequencies interlace, and those of the latter are known. With n = j pi, j = 1, 2, ... they are the two roots of
/// r^2 s^2 B^2 - [1 + n^2 (s^2 + r^2 e)] B + e n^4 - z n^2 = 0, and the cut-off frequency.

#include <vector>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The first `count` natural frequencies, rad/s, ascending. Relative error: a few eps times the number of the mode and
/// times P_cr/(P_cr - P). Throws data::FieldError, naming beam.shear_stiffness unless it is positive, beam.axial_force
/// at the buckling load or over it and, with a free tip, unless it is 0, and numerics.modes unless 1 <= count <= 1000 and,
/// with a free tip, all of them are below the cut-off frequency. That none is missed is not proven for a free tip.
[[nodiscard]] std::vector<double> timoshenko_frequencies(const data::Beam& beam, TipSupport tip, int count);

/// The reaction as a sum over the first `modes` modes. Throws as timoshenko_frequencies().
[[nodiscard]] ModalReaction timoshenko_reaction(const data::Beam& beam, int modes);

/// The same with the exact steady part at Omega, rad/s, as SteadyPart::exact. Throws data::FieldError, naming
/// numerics.modes, unless the highest mode is at 2 Omega or above.
[[nodiscard]] ModalReaction timoshenko_reaction(const data::Beam& beam, int modes, double omega);

/// Amplitude of f in the steady vibration per unit amplitude of the base, N/m, signed as StickResponse's.
[[nodiscard]] double timoshenko_steady_force(const data::Beam& beam, double omega);

/// Estimate of what the free vibrations beyond those of `reaction` can add to |f|/A0, N/m. High frequencies rise as n,
/// and amplitudes fall as n^-3 at the slowest: N/2 times the largest of the last four, doubled.
[[nodiscard]] double timoshenko_omitted_transient(const ModalReaction& reaction, double omega);

}  // namespace stickslip::analytic
