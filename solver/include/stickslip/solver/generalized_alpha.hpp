// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace stickslip::solver {

/// Displacement, velocity and (algorithmic) acceleration of all degrees of freedom.
struct Kinematics {
  Eigen::VectorXd displacement;
  Eigen::VectorXd velocity;
  Eigen::VectorXd acceleration;
};

/// The generalised-alpha method of Chung & Hulbert (J. Appl. Mech. 60, 371-375, 1993) for
///
///     M a + C v + K q = F(t).
///
/// Convention of that paper: α_m and α_f weight the OLD state. With x_(n+1-α) = (1 - α) x_(n+1) + α x_n,
///
///     M a_(n+1-α_m) + C v_(n+1-α_f) + K q_(n+1-α_f) = F(t_star),   t_star = t_(n+1) - α_f h,
///     q_(n+1) = q_n + h v_n + h² [(1/2 - β) a_n + β a_(n+1)],
///     v_(n+1) = v_n + h [(1 - γ) a_n + γ a_(n+1)],
///
/// with, for the spectral radius r at infinite frequency,
///
///     α_m = (2r - 1)/(r + 1),   α_f = r/(r + 1),   γ = 1/2 - α_m + α_f,   β = (1 - α_m + α_f)²/4.
///
/// The load is taken at t_star, not interpolated between the ends of the step and not at t_(n+1). q and v are
/// then of second order at t_(n+1), unconditionally stable. a_(n+1) is only of first order there: it is a
/// second-order value at t_(n+1) + (α_m - α_f) h. Nothing but the method itself reads it; reactions
/// are formed from q and v.
class GeneralizedAlpha {
 public:
  /// Throws data::FieldError, naming spectral_radius, unless 0 ≤ spectral_radius ≤ 1.
  explicit GeneralizedAlpha(double spectral_radius);

  [[nodiscard]] double alpha_m() const noexcept { return alpha_m_; }
  [[nodiscard]] double alpha_f() const noexcept { return alpha_f_; }
  [[nodiscard]] double beta() const noexcept { return beta_; }
  [[nodiscard]] double gamma() const noexcept { return gamma_; }

  /// t_star for a step of length h that starts at t.
  [[nodiscard]] double load_time(double t, double h) const noexcept { return t + (1.0 - alpha_f_) * h; }

  /// Factors of M, C and K in the matrix that multiplies a_(n+1).
  [[nodiscard]] double mass_factor() const noexcept { return 1.0 - alpha_m_; }
  [[nodiscard]] double damping_factor(double h) const noexcept { return (1.0 - alpha_f_) * gamma_ * h; }
  [[nodiscard]] double stiffness_factor(double h) const noexcept { return (1.0 - alpha_f_) * beta_ * h * h; }

  /// What the balance at the α level contains of the old state, a_(n+1) left out.
  void predict(const Kinematics& old, double h, Kinematics& alpha_level) const;

  /// Replaces the old state by the new one, given a_(n+1).
  void update(Kinematics& state, double h, const Eigen::VectorXd& new_acceleration) const;

 private:
  double alpha_m_, alpha_f_, beta_, gamma_;
};

}  // namespace stickslip::solver
