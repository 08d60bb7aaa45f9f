// SPDX-License-Identifier: MIT
#pragma once

/// The two experiments: what is read off their records, and what the models say of it.

#include <map>
#include <string>

#include "validation/estimators.hpp"

namespace stickslip::validation {

/// Figures by the names of their quantities.
using Figures = std::map<std::string, Figure>;

/// A slider of the weight m g on paper, pulled through a spring k whose end moves at V.
struct Slider {
  double mass{0.0307};        ///< m of the weight, kg
  double stiffness{};         ///< k, N/m
  double speed{};             ///< V, m/s
  double gravity{9.81};       ///< g, m/s^2
  double moved_mass{0.0307};  ///< m_i of the inertia, kg

  [[nodiscard]] double angular_frequency() const;  ///< omega = sqrt(k/m_i), rad/s
  [[nodiscard]] double stick_rate()
      const;  ///< k V/(m g), 1/s: of the force of the spring while the slider rests
};

/// Reads off a record of the force of the spring, in parts of the weight: `period`, s; `force_range`, from the minimum to the
/// maximum of a cycle; `highest` and `lowest`, the means of these; `mean_force`; `fall_time`, from 90 to 10 % of the range, s;
/// `rise_ratio`, the mean rate from a minimum to the next maximum in parts of k V/(m g). Where the motion is regular (above 1
/// mm/s) also `second_period`, s, by autocorrelation.
///
/// Impulses are taken out by a running median over a twelfth of 2 pi/omega. A turning point counts if the force comes back
/// by eight times the noise. The uncertainty holds half of what counting from twelve times changes, and the noise that is left.
[[nodiscard]] Figures read_slider(const Record& record, const Slider& slider);

/// Reads off a record of the damper, over the cycles within 5 % of the largest stroke: `amplitude`, m, half the stroke;
/// `slip_force`, N, half the difference of the medians of the force in the second half of the strokes up and down, without
/// their last 5 %; `force_offset`, N, half the sum of these; `energy`, J, the integral of the force over a cycle;
/// `contact_stiffness`, N/m, the slope from 80 to 30 % of the force after a reversal; `play`, m, the way between 10 % of the
/// force on either side of zero; `peak_force`, N, the mean of the largest forces of both strokes.
[[nodiscard]] Figures read_damper(const Record& record);

}  // namespace stickslip::validation
