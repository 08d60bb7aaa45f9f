// SPDX-License-Identifier: MIT
#pragma once

/// Figures of periodic motions, read off noisy records with their uncertainty, and what is read off those of the experiments.

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "validation/records.hpp"

namespace stickslip::validation {

/// A figure and its standard uncertainty (one standard deviation of its error), from so many cycles.
struct Figure {
  double value{};
  double uncertainty{};
  std::size_t count{};
};

/// The indices of maxima and minima in turn, a maximum first. A point counts once the values have come back from it by
/// `threshold`.
[[nodiscard]] std::vector<std::size_t> turning_points(std::span<const double> values, double threshold);

/// The standard deviation of the noise that differs from sample to sample, by the median of |f_(i+3) - 3 f_(i+2) + 3 f_(i+1) - f_i|:
/// neither impulses nor a smooth signal of 20 samples a period or more count.
[[nodiscard]] double noise_of(std::span<const double> values);

/// The mean of values in the order of time. Its uncertainty is the larger one of that of independent values and that of the
/// means of eight blocks, so that a drift counts, joined with `resolution`. Infinite for fewer than two values.
[[nodiscard]] Figure mean_of(std::span<const double> values, double resolution);

/// The period of an evenly sampled signal by the first maximum of its autocorrelation after half of `guess`, s; a
/// running mean over four guesses is taken off before. The uncertainty is that of the mean of four parts.
[[nodiscard]] Figure period_by_autocorrelation(const Record& record, double guess);

using Figures = std::map<std::string, Figure>;

/// A slider of the weight m g on paper, pulled through a spring k whose end moves at V.
struct Slider {
  double mass{0.0307};        ///< m of the weight, kg
  double stiffness{};         ///< k, N/m
  double speed{};             ///< V, m/s
  double gravity{9.81};       ///< g, m/s²
  double moved_mass{0.0307};  ///< m_i of the inertia, kg

  [[nodiscard]] double angular_frequency() const;  ///< ω = √(k/m_i), rad/s
  [[nodiscard]] double stick_rate()
      const;  ///< k V/(m g), 1/s: of the force of the spring while the slider rests
};

/// Reads off a record of the force of the spring, in parts of the weight: `period`, s; `force_range`, from the minimum to the
/// maximum of a cycle; `highest` and `lowest`, the means of these; `mean_force`; `fall_time`, from 90 to 10 % of the range, s;
/// `rise_ratio`, the mean rate from a minimum to the next maximum in parts of k V/(m g). Where the motion is regular (above 1
/// mm/s) also `second_period`, s, by autocorrelation.
///
/// Impulses are taken out by a running median over a twelfth of 2 π/ω. A turning point counts if the force comes back
/// by eight times the noise. The uncertainty holds half of what counting from twelve times changes, and the noise that is left.
[[nodiscard]] Figures read_slider(const Record& record, const Slider& slider);

/// Reads off a record of the damper, over the cycles within 5 % of the largest stroke: `amplitude`, m, half the stroke;
/// `slip_force`, N, half the difference of the medians of the force in the second half of the strokes up and down, without
/// their last 5 %; `force_offset`, N, half the sum of these; `energy`, J, the integral of the force over a cycle;
/// `contact_stiffness`, N/m, the slope from 80 to 30 % of the force after a reversal; `play`, m, the way between 10 % of the
/// force on either side of zero; `peak_force`, N, the mean of the largest forces of both strokes.
[[nodiscard]] Figures read_damper(const Record& record);

/// Reads off the spectrum of a strip `frequency_1` to `frequency_4`, Hz: of the largest level within 15 % of each frequency of
/// strip_frequencies() at its nominal dimensions. A spectrum tells frequencies one step apart: the uncertainty is that of a uniform
/// distribution over a step.
[[nodiscard]] Figures read_strip(const Record& spectrum);

}  // namespace stickslip::validation
