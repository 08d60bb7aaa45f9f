// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// One level of Fig. 9: y(L/2, t) and f(t) in the stick state by both implementations. The reference is the
/// closed form with the exact steady part and 200 free vibrations.
struct StickHistoryLevel {
  int elements{};
  double time_step{};                     ///< s
  double displacement_error{};            ///< max |y_h - y| over the common times, m
  double force_error{};                   ///< max |f_h - f| over the common times, N
  double predicted_displacement_error{};  ///< drift_bound of the free vibrations, m
  double predicted_force_error{};         ///< N
  double relative_displacement_error{};   ///< over displacement_peak
  double relative_force_error{};          ///< over force_peak
};
STICKSLIP_MEMBERS(StickHistoryLevel, (elements, "1"), (time_step, "s"), (displacement_error, "m"),
                  (force_error, "N"), (predicted_displacement_error, "m"), (predicted_force_error, "N"),
                  (relative_displacement_error, "1"), (relative_force_error, "1"))

/// The histories of Fig. 9 and their errors on all levels.
struct StickHistoryStudy {
  double displacement_peak{};  ///< max |y|, m
  double force_peak{};         ///< max |f|, N
  std::vector<StickHistoryLevel> levels;
  /// In the time step; the number of elements is inversely proportional to its square root.
  OrderEstimate displacement_order;
  OrderEstimate force_order;
  double predicted_displacement_order{};  ///< slope of the predicted errors
  double predicted_force_order{};
  std::vector<double> time;                             ///< the common times, s: those of the first level
  std::vector<double> displacement, force;              ///< closed form, m and N
  std::vector<double> first_displacement, first_force;  ///< finite elements, first level, m and N
};
STICKSLIP_MEMBERS(StickHistoryStudy, (displacement_peak, "m"), (force_peak, "N"), (levels),
                  (displacement_order), (force_order), (predicted_displacement_order, "1"),
                  (predicted_force_order, "1"), (time, "s"), (displacement, "m"), (force, "N"),
                  (first_displacement, "m"), (first_force, "N"))

/// Compares the histories on the times of the first level over 0 ... numerics.duration(). Level k has the
/// time step h/4^k and 2^k times the elements of `numerics`, so that the errors of time (h²) and mesh (l⁴)
/// decrease at the same rate.
[[nodiscard]] StickHistoryStudy stick_history_study(const data::Beam& beam,
                                                    const data::HarmonicExcitation& excitation,
                                                    const data::NumericalSettings& numerics, int levels);

}  // namespace stickslip::studies
