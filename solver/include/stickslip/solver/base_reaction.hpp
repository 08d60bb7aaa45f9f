// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::solver {

/// What the base must apply to a structure in time steps, in the sense of the displacement y and of its slope: the residual of the
/// equations at the rows that the base moves,
///
///     R = M_b q_tt + C_b q_t + K_b q + (M_bb h_tt + C_bb h_t + K_bb h) - rᵀ C_rel q_t,
///
/// of a beam without damping the shear force EI u'''(0) and the moment -EI u''(0). The last term is the counterforce of [damping], C_rel,
/// which acts between the structure and the base; r moves all rows with the base (of the moment: turns them with it). q_tt is that of
/// the balance, M q_tt = p s - C q_t - K_slip q + e_c f_d, so that R is of second order in the step, as q and q_t are.
class BaseReaction {
 public:
  /// `simulation` must outlive this.
  BaseReaction(const data::Case& problem, const BeamSimulation& simulation);

  [[nodiscard]] double force() const { return value(rows_.front()); }  ///< N
  [[nodiscard]] double moment() const {
    return rows_.size() > 1 ? value(rows_.back()) : 0.0;
  }  ///< N m, of a beam

 private:
  struct Row {
    MotionRow motion;               // its acceleration in the other terms
    double load{}, contact{};       // of s(t) and of f_d
    std::vector<double> further{};  // of the further loads
  };
  void add(
      MotionRow row,
      const Eigen::VectorXd& relative_drag);  // C r of a rigid motion r, what acts between structure and base
  [[nodiscard]] double value(const Row& row) const;

  const BeamSimulation& simulation_;
  std::vector<Row> rows_;
};

}  // namespace stickslip::solver
