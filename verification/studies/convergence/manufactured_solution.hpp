#pragma once

/// Manufactured solutions: a motion u(x,t) = phi(x) g(t) is chosen, the load and the tip force that it
/// implies are applied, and the finite elements have to return it. With D = EI and g_tt = s g the load is
///
///     q = rho A u_tt + (1 + eta d/dt) D u'''' + P u'',
///
/// integrated with the shape functions by Gauss quadrature; at the tip the bending moment D u''(L) and, in
/// slip, the force -D u'''(L) are applied (the follower force takes P u' along). In stick the wall moves the
/// tip by u(L,t), and the force -D u'''(L) has to come back as the friction force.
///
///     phi = A sin^2(a x/L) exp(b x/L),   phi(0) = phi'(0) = 0,
///
/// is no polynomial, and no derivative of it vanishes at the tip.

#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/convergence/convergence.hpp"

namespace stickslip::studies {

enum class ManufacturedTip {
  stick,    ///< held by a moving wall; g = cos(omega t)
  slip,     ///< free, with the implied force as a load; g = cos(omega t)
  friction  ///< free, the implied force is that of the friction law; g = exp(-lambda t), with damping
};

/// Errors over a sequence of levels, with what theory predicts for each of them where it does.
struct PredictedErrors {
  std::vector<double> error;
  std::vector<double> predicted;  ///< leading term; empty where there is none
  /// Of round-off, about eps (sqrt(n) + 12 N^k) times the exact quantity: the roundings of n steps add up as
  /// random ones do, and on N elements the k-th derivative of the deflection multiplies by 12 N^k what the
  /// last one leaves at the nodes.
  std::vector<double> floor;
  OrderEstimate order;
};

/// Errors in space at one instant, against the exact motion, in steps of time whose error is far smaller. The
/// run starts on the semi-discrete solution, so that no free vibration of the size of the error comes on top.
///
/// Interpolation by cubic Hermite elements of length l leaves ||u - Iu|| = l^4/sqrt(9!) ||u''''||, its first
/// derivative l^3/sqrt(30240) and its second l^2/sqrt(720) of the same. The elements return Iu but for
/// l^4/720 E, where E is the weak solution of
///
///     B(E, v) = int u'''' (P v'' + rho A s v) dx,
///     B(u, v) = int (D u'' v'' - P u' v' + rho A s u v) dx + P u'(L) v(L),
///
/// since l^4/720 u'''' is the mean of u - Iu over an element. That enters the deflection, moves the tip by
/// l^4/720 E(L) in slip and the friction force in stick by l^4/720 (P u^(5) - D E''')(L).
struct ManufacturedSpaceErrors {
  ManufacturedTip tip{};
  double load_factor{};  ///< P L^2/EI
  std::vector<int> elements;
  std::vector<double> element_length;  ///< m
  /// Relative, behind the leading term: l^2/24 (||phi_6||/||phi_4|| + (||phi_5||/||phi_4||)^2).
  std::vector<double> next_term;
  std::vector<double> nodal_share_of_slope;  ///< of the predicted slope error: what E adds, falls as l^2
  PredictedErrors deflection;                ///< L2 norm of u_h - u, m^(3/2)
  PredictedErrors slope;                     ///< of its first derivative
  PredictedErrors curvature;  ///< of its second derivative; predicted with the term behind the leading one
  PredictedErrors tip_deflection;  ///< slip and friction, m; empty in stick
  PredictedErrors force;           ///< f_d, stick and friction, N; empty in slip, no prediction with friction
  std::vector<double> temporal_share;  ///< predicted, of the predicted deflection error; empty with friction
  std::vector<double> temporal_share_of_force;  ///< the same of the force; stick
  /// With friction: by how much a deviation of the tip changes f_d, alpha lambda |f_d|, over 3 EI/L^3.
  std::optional<double> friction_coupling;
};

/// Errors in time against the semi-discrete manufactured problem on one mesh: the nodal values of phi times g
/// are its exact solution, so that nothing of the mesh enters.
///
/// Up to h^4 generalised-alpha solves M (1 + k_A h^2 d^2/dt^2) q_tt + K (1 + k_B h^2 d^2/dt^2) q = F, with
/// m = 1 - alpha_m, f = 1 - alpha_f
///
///     k_A = m/2 - m f + f^2/2 - 1/6 + gamma/2 - beta,   k_B = f (1 - f)/2,
///
/// (f_d comes from the balance at t_n). A motion cos(omega t) Q that starts at rest is off by
/// (k_A omega^2 - k_B omega_n^2) omega^2 h^2/(omega_n^2 - omega^2) (cos(omega_n t) - cos(omega t)) of its
/// share of every mode.
struct ManufacturedTimeErrors {
  ManufacturedTip tip{};
  double load_factor{};
  double spectral_radius{};
  std::vector<double> time_step;  ///< s
  /// Relative, behind the leading one, 2 d w h + w T (w h)^2/24 over the time T: d = (1 - r)/(1 + r)
  /// dissipates by the next power of h, and the phase error drifts. With the second natural frequency for w.
  std::vector<double> next_term;
  std::vector<double> next_term_of_all_modes;  ///< with the highest one
  PredictedErrors displacement;  ///< L2 norm of the deflection, m^(3/2); no prediction with friction
  PredictedErrors velocity;      ///< L2 norm, m^(3/2)/s; no prediction
  PredictedErrors force;         ///< f_d, N; empty in slip, no prediction with friction
};

[[nodiscard]] ManufacturedSpaceErrors manufactured_space_errors(const data::Beam& beam, ManufacturedTip tip,
                                                                double load_factor,
                                                                const std::vector<int>& elements);

[[nodiscard]] ManufacturedTimeErrors manufactured_time_errors(const data::Beam& beam, ManufacturedTip tip,
                                                              double load_factor, double spectral_radius,
                                                              const std::vector<int>& steps);

/// Both, for the report.
struct ManufacturedSolutionStudy {
  std::vector<ManufacturedSpaceErrors> space;
  std::vector<ManufacturedTimeErrors> time;
};

[[nodiscard]] ManufacturedSolutionStudy manufactured_solution_study(const data::Beam& beam);

}  // namespace stickslip::studies
