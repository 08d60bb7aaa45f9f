// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/generalized_alpha.hpp"
#include "stickslip/solver/held_tip_basis.hpp"

namespace stickslip::solver {

/// The undamped linear stick run of a bonded BeamSimulation, fast: the same grid, the same
/// method, the same numbers to rounding.
///
/// In the modes of the mesh with its tip held (HeldTipBasis) the generalised-alpha method is one recurrence per
/// mode. With x = (η, h η_t, h² η_tt) and k = (ω h)²,
///
///     x_3' = [h² r h_tt(t_star) - α_m x_3 - k (x_1 + s x_2 + s (1/2 - β) x_3)]/[1 - α_m + s β k],
///     x_2' = x_2 + (1 - γ) x_3 + γ x_3',
///     x_1' = x_1 + x_2 + (1/2 - β) x_3 + β x_3',
///
/// s = 1 - α_f, r = φᵀ (-b + M σ) with the static shape σ of the tip's motion. The state at
/// t_n with the weights w_k(t_n) of shifted_motion() is a vector y_n, a step y_(n+1) = T y_n and an output o y_n, so
/// that B outputs from t_n on are the product of a matrix with the rows o, o T, ... o T^(B-1) and y_n: one
/// matrix product for all blocks of B steps, whose states follow from each other by T^B.
class ModalStickRun {
 public:
  /// Uses beam, motion, and of the numerics elements, time_step and spectral_radius, and how the run starts. Needs all modes of the
  /// mesh, whose cost grows as the cube of the elements. Throws data::FieldError, naming beam.axial_force, if P is at or over
  /// the buckling load.
  explicit ModalStickRun(const data::Case& problem, const RunOptions& options = {});

  /// f at t_0 ... t_steps, N, sign of Eq. (28).
  [[nodiscard]] std::vector<double> friction_force(long steps) const;
  /// The displacement u(x) relative to the base at t_0 ... t_steps, m; 0 ≤ x ≤ L.
  [[nodiscard]] std::vector<double> relative_displacement(double x, long steps) const;

  /// max |f| over t_0 ... t_steps, N.
  [[nodiscard]] double max_abs_friction_force(long steps) const;

 private:
  // An output is modal . η + of_base h + of_acceleration h_tt.
  struct Output {
    Eigen::VectorXd modal;
    double of_base{};
    double of_acceleration{};
  };
  using Modes = Eigen::Array<double, Eigen::Dynamic, 3>;  // x_1, x_2, x_3 by mode

  struct Block;

  [[nodiscard]] Modes stepped(const Modes& state, double load) const;
  [[nodiscard]] Block block_of(const Output& output) const;
  template <class Sink>
  void march(const Output& output, long steps, Sink&& sink) const;
  [[nodiscard]] std::vector<double> history(const Output& output, long steps) const;

  BeamModel model_;
  GeneralizedAlpha method_;
  double h_;
  std::vector<ShiftedMotion> base_;
  HeldTipBasis basis_;
  Eigen::ArrayXd stiffness_;       // k
  Eigen::ArrayXd load_;            // h² r
  Eigen::ArrayXd inverse_factor_;  // 1/[1 - α_m + s β k]
  Modes start_;
  Output force_;
};

}  // namespace stickslip::solver
