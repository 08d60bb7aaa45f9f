#pragma once

#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// One panel of Figs. 4 and 5: the tip's history with contact, by finite elements, and the verdicts of both.
struct ContactHistory {
  double frequency_hz{};
  double amplitude{};                         ///< m
  std::vector<double> time;                   ///< s
  std::vector<double> tip_displacement;       ///< m
  std::optional<double> finite_element_slip;  ///< time of the first slip, s
  std::optional<double> closed_form_slip;     ///< first time |f| > mu_s P in the closed form, s
  bool criterion_slips{};                     ///< Eqs. (29), (30) over numerics.duration()
  /// Time until which each of three other histories stays within 1 % of the range of the tip's motion, s: on
  /// twice the elements, with a tenth of the step, and by the event-driven method on twenty modes of the
  /// continuous beam. The history is not to be trusted beyond it.
  double trusted_until{};
};

/// Runs to `shown` seconds for the history (the verdicts use numerics.duration()).
[[nodiscard]] ContactHistory contact_history(const data::Beam& beam, const data::FrictionLaw& friction,
                                             const data::HarmonicExcitation& excitation,
                                             const data::NumericalSettings& numerics, double shown);

/// The first time at which |f| of the closed form (exact steady part) exceeds the limit, or nothing within
/// the duration: looked for on a grid of 1/2000 of the shorter period, of the excitation and of the first
/// mode, and located to 1/20000 of that.
[[nodiscard]] std::optional<double> closed_form_first_slip(const data::Beam& beam,
                                                           const data::FrictionLaw& friction,
                                                           const data::HarmonicExcitation& excitation,
                                                           double duration);

}  // namespace stickslip::studies
