// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

/// The tip at the begin of a period of the base motion, h = 0 and h_t > 0: a point of the Poincare section.
struct SectionPoint {
  double displacement{};    ///< y(L), m
  double velocity{};        ///< y_t(L), m/s
  double friction_force{};  ///< f, N, mean over the step before
};

/// One value of the parameter.
struct SweepPoint {
  bool up{};
  double value{};
  std::vector<SectionPoint> section;  ///< one for each period
  int period{};                       ///< as of period_of()
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

}  // namespace stickslip::studies
