// SPDX-License-Identifier: MIT
#pragma once

/// Manufactured solutions: a motion u(x,t) = φ(x) g(t) is chosen, the load and the tip force that it
/// requires are applied, and the finite elements must reproduce it. With D = EI and g_tt = s g the load is
///
///     q = ρ A u_tt + (1 + η d/dt) D u'''' + P u''.
///
/// It is integrated with the shape functions by Gauss quadrature. The bending moment D u''(L) and, in slip,
/// the force -D u'''(L) are applied at the tip; the follower force already contributes P u'. In stick the
/// wall moves the tip by u(L,t), and the friction force must be -D u'''(L).
///
///     φ = A sin²(a x/L) exp(b x/L),   φ(0) = φ'(0) = 0,
///
/// is not a polynomial, and none of its derivatives that are used here vanishes at the tip.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The boundary condition at the tip and the time function g(t) of a manufactured solution.
enum class ManufacturedTip {
  stick,    ///< held by a moving wall; g = cos(ω t)
  slip,     ///< free, with the required tip force as a load; g = cos(ω t)
  friction  ///< free, the required tip force is that of the friction law; g = exp(-λ t), with damping
};
/// "stick", "slip" or "slip, friction law".
[[nodiscard]] constexpr std::string_view to_string(ManufacturedTip tip) noexcept {
  constexpr std::array<std::string_view, 3> names{"stick", "slip", "slip, friction law"};
  return names[static_cast<std::size_t>(tip)];
}

/// Errors over a sequence of levels, with the predicted error of each level where theory gives one.
struct PredictedErrors {
  std::vector<double> error;
  std::vector<double> predicted;  ///< leading term; empty if there is no prediction
  /// Estimated round-off error, eps (√(n) + 12 N^k) times the exact quantity: no bound, and nothing in it is fitted.
  /// The errors eps of n steps add up to √(n) eps if they are independent. Shape functions have k-th derivatives
  /// of at most 12/l^k by their first nodal value, so that its rounding changes the k-th derivative of the deflection by
  /// 12 N^k eps, if that derivative is of the size of the deflection over L^k.
  std::vector<double> floor;
  OrderEstimate order;

  [[nodiscard]] std::optional<double> over_predicted() const {
    return predicted.empty() ? std::nullopt : std::optional(error.back() / predicted.back());
  }
};
STICKSLIP_MEMBERS(PredictedErrors, (error), (predicted), (floor), (order), (over_predicted(), "1"))

/// Spatial errors at one instant against the exact motion. The time steps are so short that their error is
/// far smaller. The run starts on the semi-discrete solution, so that it excites no additional free
/// vibration.
///
/// Interpolation by cubic Hermite elements of length l has the L2 errors
///
///     ||u - Iu|| = l⁴/√(9!) ||u''''||,   ||(u - Iu)'|| = l³/√(30240) ||u''''||,
///     ||(u - Iu)''|| = l²/√(720) ||u''''||.
///
/// The finite-element solution differs from Iu by l⁴/720 E, where E is the weak solution of
///
///     B(E, v) = ∫ u'''' (P v'' + ρ A s v) dx,
///     B(u, v) = ∫ (D u'' v'' - P u' v' + ρ A s u v) dx + P u'(L) v(L),
///
/// since l⁴/720 u'''' is the mean of u - Iu over an element. This term changes the deflection, moves the tip
/// by l⁴/720 E(L) in slip, and changes the friction force in stick by l⁴/720 (P u^(5) - D E''')(L).
struct ManufacturedSpaceErrors {
  ManufacturedTip tip{};
  double load_factor{};  ///< P L²/EI
  std::vector<int> elements;
  std::vector<double> element_length;  ///< m
  /// Size of the next term relative to the leading term: l²/24 (||φ_6||/||φ_4|| +
  /// (||φ_5||/||φ_4||)²).
  std::vector<double> next_term;
  std::vector<double> nodal_share_of_slope;  ///< share of E in the predicted slope error; proportional to l²
  PredictedErrors deflection;                ///< L2 norm of u_h - u, m^(3/2)
  PredictedErrors slope;                     ///< of its first derivative
  PredictedErrors curvature;       ///< of its second derivative; the prediction includes the next term
  PredictedErrors tip_deflection;  ///< slip and friction, m; empty in stick
  PredictedErrors force;           ///< f_d, N; empty in slip, no prediction with friction
  std::vector<double>
      temporal_share;  ///< predicted, over the predicted deflection error; empty with friction
  std::vector<double> temporal_share_of_force;  ///< the same for the force; in stick only
  /// With friction: the change of f_d with a deviation of the tip, α λ |f_d|, over 3 EI/L³.
  std::optional<double> friction_coupling;
};
STICKSLIP_MEMBERS(ManufacturedSpaceErrors, (tip, "-"), (load_factor, "1"), (elements, "1"),
                  (element_length, "m"), (deflection), (slope), (curvature), (tip_deflection), (force))

/// Temporal errors against the semi-discrete manufactured problem on one mesh. Its exact solution is the
/// vector of the nodal values of φ times g, so that the spatial error does not enter.
///
/// Up to terms of order h⁴, generalised-alpha with m = 1 - α_m and f = 1 - α_f solves
///
///     M (1 + k_A h² d²/dt²) q_tt + K (1 + k_B h² d²/dt²) q = F,
///     k_A = m/2 - m f + f²/2 - 1/6 + γ/2 - β,   k_B = f (1 - f)/2
///
/// (f_d comes from the balance at t_n). The error of a motion Q cos(ω t) that starts at rest is, for its
/// share of each mode,
///
///     (k_A ω² - k_B ω_n²) ω² h²/(ω_n² - ω²) (cos(ω_n t) - cos(ω t)).
struct ManufacturedTimeErrors {
  ManufacturedTip tip{};
  double load_factor{};
  double spectral_radius{};
  std::vector<double> time_step;  ///< s
  /// Size of the next term relative to the leading term, 2 d w h + w T (w h)²/24 over the duration T. d = (1
  /// - r)/(1 + r) is the numerical dissipation, which enters with the next power of h, and the second summand
  /// is the drift of the phase error. w is the second natural frequency.
  std::vector<double> next_term;
  std::vector<double> next_term_of_all_modes;  ///< the same with the highest natural frequency for w
  PredictedErrors displacement;  ///< L2 norm of the deflection, m^(3/2); no prediction with friction
  PredictedErrors velocity;      ///< L2 norm, m^(3/2)/s; no prediction
  PredictedErrors force;         ///< f_d, N; empty in slip, no prediction with friction
};
STICKSLIP_MEMBERS(ManufacturedTimeErrors, (tip, "-"), (load_factor, "1"), (spectral_radius, "1"),
                  (time_step, "s"), (displacement), (velocity), (force))

/// Spatial errors of one problem with P = load_factor EI/L² on meshes with the given numbers of elements.
[[nodiscard]] ManufacturedSpaceErrors manufactured_space_errors(const data::Beam& beam, ManufacturedTip tip,
                                                                double load_factor,
                                                                const std::vector<int>& elements);

/// Temporal errors of one problem with P = load_factor EI/L² for the given numbers of steps.
[[nodiscard]] ManufacturedTimeErrors manufactured_time_errors(const data::Beam& beam, ManufacturedTip tip,
                                                              double load_factor, double spectral_radius,
                                                              const std::vector<int>& steps);

/// Spatial and temporal errors of the problems that the report shows.
struct ManufacturedSolutionStudy {
  std::vector<ManufacturedSpaceErrors> space;
  std::vector<ManufacturedTimeErrors> time;
};
STICKSLIP_MEMBERS(ManufacturedSolutionStudy, (space), (time))

[[nodiscard]] ManufacturedSolutionStudy manufactured_solution_study(const data::Beam& beam);

}  // namespace stickslip::studies
