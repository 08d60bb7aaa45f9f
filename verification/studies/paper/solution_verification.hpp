#pragma once

/// The discretisation uncertainty of each result of the paper that finite elements yield, by the grid
/// convergence index (Roache, J. Fluids Eng. 116, 1994) where the levels allow it, and by what theory says of
/// mesh and step where they do not; both against the closed form, which knows the error.

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// What three levels f_0 (coarsest), f_1, f_2, each finer than the last by the ratio r, say of the error of
/// f_0.
///
/// Observed order p = ln[(f_0 - f_1)/(f_1 - f_2)]/ln r. The levels count as asymptotic if there is one, the
/// differences having the same sign, and if it is within a tenth of the formal order. Then the extrapolated
/// value is F = f_2 + (f_2 - f_1)/(r^p - 1) and
///
///     GCI = 1.25 |f_0 - f_1| r^p/(r^p - 1) = 1.25 |f_0 - F|.
///
/// Else p is the formal order, and GCI = 3 r^p/(r^p - 1) times the larger of |f_0 - f_1| and |f_0 - f_2|: an
/// estimate with a caution, not a bound.
struct GridConvergence {
  std::optional<double> observed_order;  ///< nothing where the differences change sign or vanish
  bool asymptotic{};
  double extrapolated{};
  double safety_factor{};  ///< 1.25 or 3
  double index{};          ///< GCI, in the unit of the values
};

/// Throws std::invalid_argument unless there are three values, ratio > 1 and formal_order > 0.
[[nodiscard]] GridConvergence grid_convergence(const std::vector<double>& values, double ratio,
                                               double formal_order);

struct VerificationLevel {
  int elements{};
  double time_step{};  ///< s; 0 where no time is stepped
  double value{};
};

/// One result with its discretisation uncertainty.
struct VerifiedResult {
  std::string id;                 ///< "frequency.stick.1": that of the printed number, if there is one
  std::string quantity;           ///< "stick frequency 1"
  std::string unit;               ///< "Hz"
  std::optional<double> printed;  ///< nothing if the paper does not print it
  std::vector<VerificationLevel> levels;  ///< the published settings first
  GridConvergence convergence;
  double reference{};    ///< the closed form
  double true_error{};   ///< of the first level: value - reference
  bool covered{};        ///< |true_error| <= convergence.index
  double uncertainty{};  ///< of the first level: the index, or the predicted error where it does not apply
  std::string obtained;  ///< how `uncertainty` was
};

struct SolutionVerification {
  double ratio{};         ///< of the element lengths of consecutive levels
  double formal_order{};  ///< in the element length; the step falls as its square
  std::vector<VerifiedResult> results;
};

/// 20, 30 and 45 elements; the time step falls with the square of the element length, 1e-4 s first, so that
/// the errors of step (h^2) and mesh (l^4) fall alike. `paper` is the case of data/cases/paper.toml. Uses two
/// threads; the result does not depend on that.
///
/// Predicted: frequencies, and the lengths at which one is met, are asymptotic. The others are maxima and
/// first passages of a force that holds free vibrations of every mode, whose phases drift by turns as mesh
/// and step are refined: only where one mode makes nearly all of it, as at 25 Hz, do three levels line up.
/// Their uncertainty is what theory predicts: the error of PredictedForce and its own uncertainty for
/// |f_max|, drift_bound() for a history, divided by the slope of the force for the instant of a first slip.
[[nodiscard]] SolutionVerification solution_verification(const data::Case& paper);

}  // namespace stickslip::studies
