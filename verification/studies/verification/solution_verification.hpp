// SPDX-License-Identifier: MIT
#pragma once

/// The discretisation uncertainty of the results of the paper that finite elements compute. It is the grid
/// convergence index (Roache, J. Fluids Eng. 116, 1994) where the levels allow it, and the predicted error of
/// mesh and time step otherwise. Both are compared with the true error against the closed form.

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The estimated error of the coarsest of three levels f_0, f_1, f_2, each finer than the previous one by the
/// ratio r.
///
/// Observed order p = ln[(f_0 - f_1)/(f_1 - f_2)]/ln r. The levels count as asymptotic if the differences
/// have the same sign, so that p exists, and if p is within a tenth of the formal order. Then the
/// extrapolated value is F = f_2 + (f_2 - f_1)/(r^p - 1) and
///
///     GCI = 1.25 |f_0 - f_1| r^p/(r^p - 1) = 1.25 |f_0 - F|.
///
/// Otherwise p is the formal order, and GCI = 3 r^p/(r^p - 1) max(|f_0 - f_1|, |f_0 - f_2|), which is a
/// cautious estimate and not a bound.
struct GridConvergence {
  std::optional<double> observed_order;  ///< empty if the differences change sign or vanish
  bool asymptotic{};
  double extrapolated{};
  double safety_factor{};  ///< 1.25 or 3
  double index{};          ///< GCI, in the unit of the values
};
STICKSLIP_MEMBERS(GridConvergence, (observed_order, "1"), (asymptotic, "1"), (extrapolated),
                  (safety_factor, "1"), (index))

/// The grid convergence of three values. Throws std::invalid_argument unless there are three values, ratio >
/// 1 and formal_order > 0.
[[nodiscard]] GridConvergence grid_convergence(const std::vector<double>& values, double ratio,
                                               double formal_order);

struct VerificationLevel {
  int elements{};
  double time_step{};  ///< s; 0 for results without time integration
  double value{};
};
STICKSLIP_MEMBERS(VerificationLevel, (elements, "1"), (time_step, "s"), (value))

struct VerifiedResult {
  /// Such as "frequency.stick.1"; that of the printed number, if there is one.
  std::string id;
  std::string quantity;                   ///< such as "stick frequency 1"
  std::string unit;                       ///< such as "Hz"
  std::optional<double> printed;          ///< empty if the paper does not print it
  std::vector<VerificationLevel> levels;  ///< the first has the published settings
  GridConvergence convergence;
  double reference{};   ///< the closed form
  double true_error{};  ///< of the first level: value - reference
  bool covered{};       ///< |true_error| ≤ convergence.index
  /// Of the first level: the index, or the predicted error if the levels are not asymptotic.
  double uncertainty{};
  std::string obtained;  ///< how `uncertainty` was determined
};
STICKSLIP_MEMBERS(VerifiedResult, (id, "-"), (quantity, "-"), (unit, "-"), (printed), (levels), (convergence),
                  (reference), (true_error), (covered, "1"), (uncertainty), (obtained, "-"))

struct SolutionVerification {
  double ratio{};         ///< of the element lengths of consecutive levels
  double formal_order{};  ///< in the element length; the time step is proportional to its square
  std::vector<VerifiedResult> results;
};
STICKSLIP_MEMBERS(SolutionVerification, (ratio, "1"), (formal_order, "1"), (results))

/// Verifies the results of the case of data/cases/paper.toml with 20, 30 and 45 elements. The time step is
/// proportional to the square of the element length, 1e-4 s for the first level, so that the errors of time
/// step (h²) and mesh (l⁴) decrease at the same rate. Uses thread_count() threads; the result does not
/// depend on their number.
///
/// Predicted: frequencies, and lengths with a given frequency, are asymptotic. The other results are maxima
/// or first passages of a force that contains free vibrations of all modes. Their phases change when mesh and
/// step are refined, so the levels are asymptotic only if one mode dominates, as at 25 Hz. Otherwise the
/// uncertainty is the predicted one: for |f_max| the error of PredictedForce plus its own uncertainty, for a
/// history drift_bound(), and for the time of a first slip drift_bound() divided by the slope of the force.
/// For the position of the tip after the first slip there is no prediction: its uncertainty is the index, an
/// estimate that the comparison with the boundary integral confirms. What follows has no entry: later slips of
/// the undamped beam do not converge on these meshes (history_convergence.hpp).
[[nodiscard]] SolutionVerification solution_verification(const data::Case& paper);

}  // namespace stickslip::studies
