// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

/// One value of the parameter.
struct SweepPoint {
  bool up{};
  double value{};
  /// The Poincare section: the tip at the begin of each period of the base motion, h = 0 and h_t > 0; y(L), v_s and the
  /// mean f over the step before.
  std::vector<HistoryRow> section;
  int period{};  ///< as of period_of()
  bool slips{};  ///< in the periods of the section
};

enum class SweepDirection { up, down, both };

/// A quasi-static sweep by analytic::ModalContactRun.
struct SweepTask {
  data::Case problem;
  std::string_view parameter;  ///< the path of its key
  std::vector<double> values;  ///< ascending, SI units
  SweepDirection direction{};
  int settle{};   ///< periods of the base motion that pass at each value
  int periods{};  ///< periods after those, at which the section is taken
};

/// Follows the motion over the values of one parameter, up, down, or up and then down. The first value starts
/// quasi-statically, each other one from the end of the one before, between two periods: the amplitudes of the
/// held modes, their rates, the position of the tip on the wall and its sliding velocity go on. What up and
/// down differ in is hysteresis. `progress`, if given, receives the share done. Throws data::FieldError for a
/// value that its field refuses, and what response_model() and ModalContactRun throw.
[[nodiscard]] std::vector<SweepPoint> parameter_sweep(const SweepTask& task,
                                                      const std::function<void(double)>& progress = {});

/// At how many values up and down have other sections, by more than 1 % of the larger |f| in the smallest or the largest f.
struct Hysteresis {
  std::size_t moving{};   ///< the tip slips, up, down or both
  std::size_t resting{};  ///< it sticks both times, at another place
};
/// Of a sweep in both directions.
[[nodiscard]] Hysteresis hysteresis_of(const std::vector<SweepPoint>& points);

}  // namespace stickslip::studies
