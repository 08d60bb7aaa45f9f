// SPDX-License-Identifier: MIT
#pragma once

/// Steady sliding on a wall that moves with the constant speed V, and its small disturbances: friction-induced vibration
/// (squeal). The tip is at rest, v_s = -V, and the friction force pulls the tip along with the wall, f_d = sgn(V) μ(|V|) P.
///
/// A small change of the sliding velocity changes the friction force by κ v_s, with the falling slope
///
///     κ(V) = -P μ'(|V|) = P [(μ_s - μ_m) α exp(-α |V|) - β],
///
/// a negative damping of the tip if it is above 0. With the mobility Y of the sliding contact (tip_mobility.hpp), v_s = Y
/// f_d, so that the disturbances exp(s t) are the roots of
///
///     Z(s) = κ,     Z = 1/Y.
///
/// Each mode k of the structure without friction is a root s_k of Z = 0. To first order in κ its root moves by R_k
/// κ with the residue R_k = 1/Z'(s_k), half the g_k of free_mode_run.hpp if there is no damping. So the damping of mode
/// k alone holds the slope
///
///     κ_k = -Re s_k/Re R_k,     2 ζ_k ω_k m_k if the damping is light, m_k = 1/g_k,
///
/// that is ζ_k ω_k = κ g_k/2, (μ_s - μ_m) α P g_k/2 at low speed. The contact couples the modes: this is
/// the first term in κ. The coupled value is that of the Hopf point, where a pair of roots is on the imaginary axis:
///
///     Im Z(i ω) = 0,     κ = Re Z(i ω).

#include <complex>
#include <optional>
#include <vector>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// κ(V), N s/m.
[[nodiscard]] double falling_slope(const data::FrictionLaw& friction, double normal_force, double speed);

/// The speed V ≥ 0, m/s, above which κ(V) is below `slope` (N s/m): ln[(μ_s - μ_m) α P/(slope + β P)]/α.
/// 0 if it is at every speed, infinity if it is at none.
[[nodiscard]] double speed_of_slope(const data::FrictionLaw& friction, double normal_force, double slope);

/// Steady sliding.
struct SteadySliding {
  double friction_force{};    ///< f_d on the structure, N
  double tip_displacement{};  ///< u of the contact, m
};

/// u(L) = f_d L³/EI (c_2(z) - c_3(z))/(1 - χ z c_2(z)) with the Stumpff functions of z = P L²/EI: the static
/// flexibility of the slip state, L³/(3 EI) at P = 0. To round-off, times the closeness to the buckling load.
[[nodiscard]] SteadySliding steady_sliding(const data::Beam& beam, const data::FrictionLaw& friction,
                                           const data::Wall& wall);

/// The same of a case; of a Model u = f_d/k_c. Throws data::FieldError, naming model.stiffness, for one mass without a spring.
[[nodiscard]] SteadySliding steady_sliding(const data::Case& problem);

/// The natural frequencies of the free contact without damping, ascending, rad/s: of the modes and the contact, as many as have mass. With
/// held modes left out, that at ω is high by about ω²/2 α/(m_c ω_o²) of itself, α and ω_o of HeldStructure::omitted. Throws
/// std::invalid_argument for a follower force.
[[nodiscard]] std::vector<double> free_angular_frequencies(const HeldStructure& structure);

/// All eigenvalues s with Im s ≥ 0 of small disturbances of a model at the slope κ (N s/m), 1/s, by falling real part. Throws
/// what require_free_mass() throws.
[[nodiscard]] std::vector<std::complex<double>> sliding_eigenvalues(const ContactModel& model, double kappa);

/// The mobility of the contact of a model, with any damping: s [(s² M + s C + K)⁻¹]_cc, by elimination; infinite
/// where s is an eigenvalue. Where damping does not couple the held modes, the cost is that of a sum over them.
[[nodiscard]] Mobility contact_mobility(const ContactModel& model);
/// That of a case: of a beam with all modes (TipMobility), or, for damping other than Kelvin-Voigt's and for a Model, with this model of it.
[[nodiscard]] Mobility contact_mobility(const data::Case& problem, const ContactModel& model);

/// Where a pair of roots crosses the imaginary axis as κ grows.
struct HopfPoint {
  double slope{};              ///< κ, N s/m
  double angular_frequency{};  ///< rad/s
};

/// One mode of the sliding structure.
struct SlidingMode {
  std::complex<double> free_root;  ///< s_k, 1/s
  double one_mode_slope{};         ///< κ_k, N s/m
  std::optional<HopfPoint>
      hopf;  ///< of this mode, followed from κ = 0; nothing if it does not reach the axis
  std::optional<std::complex<double>>
      root;  ///< of Z = κ, 1/s; nothing if the search loses it (overdamped modes)
};

/// The modes near the natural frequencies given (rad/s, of the structure without damping and friction) at the slope
/// `kappa`, N s/m. Newton's method on Z, followed from κ = 0: to the accuracy of the mobility. A mode without a root
/// s_k of its own in the upper half plane (more than critically damped) is left out, with all that follow.
[[nodiscard]] std::vector<SlidingMode> sliding_modes(const Mobility& mobility,
                                                     const std::vector<double>& angular_frequencies,
                                                     double kappa);

}  // namespace stickslip::analytic
