// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_model.hpp"

namespace stickslip::solver {

/// A prescribed motion with its exact derivatives; at rest by default.
struct PrescribedMotion {
  std::function<double(double)> displacement{[](double) { return 0.0; }};  ///< m, of t in s
  std::function<double(double)> velocity{[](double) { return 0.0; }};      ///< m/s
  std::function<double(double)> acceleration{[](double) { return 0.0; }};  ///< m/s²
};

/// The normal force of a bonded contact, which never slips: the system is then linear.
constexpr double bonding_force = std::numeric_limits<double>::infinity();

/// A linear system with one frictional contact on one degree of freedom c:
///
///     M q̈ + C q̇ + K q = p s(t) + Σ_i p_i s_i(t) + e_c f_d,        v_s = q̇[c] - ẇ(t).
///
/// v_s is the sliding velocity relative to a wall that moves by w(t) in the coordinates of q; f_d is the friction
/// force on the system.
///
///     slip:    f_d = -sgn(v_s) μ(v_s) N,               K = K_slip
///     stick:   q[c] = q[c](t_s) + w(t) - w(t_s),       K = K_stick in all rows but that of c
///
/// The row of c of the slip-state balance then yields f_d, which may not exceed μ_s N.
struct ContactSystem {
  /// p_i and s_i, as p and s.
  struct Load {
    Eigen::VectorXd shape;
    std::function<double(double)> history;
  };

  SparseMatrix mass;                           ///< M, symmetric positive definite but for rows of zeros
  SparseMatrix damping;                        ///< C
  SparseMatrix stick_stiffness;                ///< K_stick
  SparseMatrix slip_stiffness;                 ///< K_slip, may be unsymmetric
  Eigen::VectorXd load_shape;                  ///< p
  std::function<double(double)> load_history;  ///< s, of t in s
  Eigen::Index contact{};                      ///< c
  PrescribedMotion wall{};                     ///< w
  double normal_force{};                       ///< N, newton, ≥ 0; or bonding_force
  data::FrictionLaw friction;
  data::TangentialContact tangential{};  ///< a spring or a smooth law takes the place of stick
  std::vector<Load> further_loads{};

  /// p s(t) + Σ_i p_i s_i(t).
  void set_load(double t, Eigen::VectorXd& load) const {
    load.noalias() = load_history(t) * load_shape;
    for (const Load& further : further_loads) load += further.history(t) * further.shape;
  }
};

/// μ(v) = μ_m + (μ_s - μ_m) exp(-α |v|) + β |v|, Eq. (7) with a viscous term, v in m/s. α must be
/// finite (data::FrictionLaw::in_slip).
[[nodiscard]] double friction_coefficient(const data::FrictionLaw& law, double sliding_velocity);

/// Its slope over the speed, d μ/d|v| = β - (μ_s - μ_m) α exp(-α |v|), s/m.
[[nodiscard]] double friction_coefficient_slope(const data::FrictionLaw& law, double sliding_velocity);

}  // namespace stickslip::solver
