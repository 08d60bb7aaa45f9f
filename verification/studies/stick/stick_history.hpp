#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/convergence/convergence.hpp"

namespace stickslip::studies {

/// Fig. 9: y(L/2, t) and f(t) in the stick state by both implementations. The reference is the closed form
/// without truncation: exact steady part, `reference_modes` free vibrations.
struct StickHistoryLevel {
  int elements{};
  double time_step{};
  double displacement_error{};            ///< sup |y_h - y|, m, on the common grid
  double force_error{};                   ///< sup |f_h - f|, N
  double predicted_displacement_error{};  ///< drift_bound of the free vibrations, m
  double predicted_force_error{};         ///< N
};

struct StickHistoryStudy {
  double displacement_peak{};  ///< max |y|, m
  double force_peak{};         ///< max |f|, N
  std::vector<StickHistoryLevel> levels;
  OrderEstimate displacement_order;  ///< in the time step, elements refined as its square root
  OrderEstimate force_order;
  double predicted_displacement_order{};  ///< the same slope through the predicted errors
  double predicted_force_order{};
  std::vector<double> time;                             ///< s, the common grid (that of the first level)
  std::vector<double> displacement, force;              ///< closed form
  std::vector<double> first_displacement, first_force;  ///< finite elements, first level
};

/// Level k has time step h/4^k and 2^k times the elements of numerics, so that the errors of time (h^2) and
/// mesh (l^4) fall alike. Compared on the grid of the first level over 0 ... numerics.duration().
[[nodiscard]] StickHistoryStudy stick_history_study(const data::Beam& beam,
                                                    const data::HarmonicExcitation& excitation,
                                                    const data::NumericalSettings& numerics, int levels,
                                                    int reference_modes = 200);

}  // namespace stickslip::studies
