// SPDX-License-Identifier: MIT
#pragma once

/// The stick state of a beam with shear and rotary inertia in closed form (Timoshenko, Phil. Mag. 41, 1921; frequency
/// equations without axial force: Huang, J. Appl. Mech. 28, 1961). With the rotation φ of the section, K = k G A and
/// an axial force along the axis of the beam (Engesser's choice),
///
///     ρ A w_tt = [K (w_x - φ) - P w_x]_x,       ρ I φ_tt = EI φ_xx + K (w_x - φ),
///
/// w = φ = 0 at x = 0 and, at x = L, φ_x = 0 and w = 0 (held) or K (w_x - φ) - P w_x + (1 - χ) P φ = 0 (free).
/// With
///
///     r² = I/(A L²),  s² = EI/(K L²),  z = P L²/EI,  e = 1 - z s²,  B = ρ A L⁴ ω²/EI
///
/// the solutions are sums of exp(±√(q) x/L) with the two roots q_1 > q_2 of
///
///     e q² + [B s² + z + B r² e] q - B (1 - B r² s²) = 0.
///
/// q_2 < 0; q_1 is positive below the cut-off frequency √(K/(ρ I)) and negative above. Let a = e q + B s², so that
/// a_1 a_2 = -B, and C = cosh(√q), T = sinh(√q)/√(q), entire functions of q. The amplitude of the friction force
/// f in the steady vibration with the tip held and a unit amplitude of the base is
///
///     f L³/EI = B {[a_1 + (1 - χ) z] C_1 - [a_2 + (1 - χ) z] C_2}/D,     D = q_1 T_1 a_2 C_2 - q_2 T_2 a_1 C_1,
///
/// D = 0 is the frequency equation, and the shares c_n of ModalReaction are the residues (EI/L³) {...}/D'(B), with
/// D' by a complex step. At B = 0, f L³/EI = e² [1 - χ (1 - c0)]/(c2 - c3 + s² e c0) with the Stumpff functions at
/// z/e. r = s = 0 is the beam of Euler and Bernoulli.
///
/// No mode is missed: the clamped-pinned beam is the pinned-pinned one with one constraint, φ(0) = 0, so that their
/// frequencies interlace, and those of the latter are known. With n = j π, j = 1, 2, ... they are the two roots of
/// r² s² B² - [1 + n² (s² + r² e)] B + e n⁴ - z n² = 0, and the cut-off frequency.

#include <vector>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The first `count` natural frequencies, rad/s, ascending. Relative error: a few eps times the number of the mode and
/// times P_cr/(P_cr - P). Throws data::FieldError, naming beam.shear_stiffness unless it is positive, beam.axial_force
/// at the buckling load or over it and, with a free tip, unless it is 0, and numerics.modes unless 1 ≤ count ≤ 1000 and,
/// with a free tip, all of them are below the cut-off frequency. That none is missed is not proven for a free tip.
[[nodiscard]] std::vector<double> timoshenko_frequencies(const data::Beam& beam, TipSupport tip, int count);

/// The reaction as a sum over the first `modes` modes. Throws as timoshenko_frequencies().
[[nodiscard]] ModalReaction timoshenko_reaction(const data::Beam& beam, int modes);

/// The same with the exact steady part at Ω, rad/s, as SteadyPart::exact. Throws data::FieldError, naming
/// numerics.modes, unless the highest mode is at 2 Ω or above.
[[nodiscard]] ModalReaction timoshenko_reaction(const data::Beam& beam, int modes, double omega);

/// Amplitude of f in the steady vibration per unit amplitude of the base, N/m, signed as StickResponse's.
[[nodiscard]] double timoshenko_steady_force(const data::Beam& beam, double omega);

/// Estimate of what the free vibrations beyond those of `reaction` can add to |f|/A0, N/m. High frequencies rise as n,
/// and amplitudes fall as n⁻³ at the slowest: N/2 times the largest of the last four, doubled.
[[nodiscard]] double timoshenko_omitted_transient(const ModalReaction& reaction, double omega);

}  // namespace stickslip::analytic
