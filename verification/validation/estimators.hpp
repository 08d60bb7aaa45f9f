// SPDX-License-Identifier: MIT
#pragma once

/// Figures of periodic motions, read off noisy records with their uncertainty.

#include <cstddef>
#include <span>
#include <vector>

#include "validation/records.hpp"

namespace stickslip::validation {

/// A figure and its standard uncertainty (one standard deviation of its error), from so many cycles.
struct Figure {
  double value{};
  double uncertainty{};
  std::size_t count{};
};

/// From one maximum of the force to the next.
struct Cycle {
  double begin{};      ///< s
  double period{};     ///< s
  double highest{};    ///< the maximum at the begin
  double lowest{};     ///< the minimum that follows
  double fall_time{};  ///< from 90 to 10 % of the way between them, s
  double rise_rate{};  ///< the mean rate from the minimum to the next maximum, 1/s
};

/// The middle one of the values in their order, the upper one of two; not a number for none.
[[nodiscard]] double median_of(std::vector<double> values);

/// The indices of maxima and minima in turn, a maximum first. A point counts once the values have come back from it by
/// `threshold`.
[[nodiscard]] std::vector<std::size_t> turning_points(std::span<const double> values, double threshold);

/// The standard deviation of the noise that differs from sample to sample, by the median of |f_(i+3) - 3 f_(i+2) + 3 f_(i+1) - f_i|:
/// neither impulses nor a smooth signal of 20 samples a period or more count.
[[nodiscard]] double noise_of(std::span<const double> values);

/// The median of the `width` values around each value; at the ends of the first or last ones. It takes out impulses and keeps
/// steps.
[[nodiscard]] std::vector<double> running_median(std::span<const double> values, std::size_t width);

/// The cycles of the force between its turning points. A cycle with a gap in time of more than a twentieth of the median period is left out.
[[nodiscard]] std::vector<Cycle> cycles_of(const Record& record, double threshold);

/// The mean of values in the order of time. Its uncertainty is the larger one of that of independent values and that of the
/// means of eight blocks, so that a drift counts, joined with `resolution`. Infinite for fewer than two values.
[[nodiscard]] Figure mean_of(std::span<const double> values, double resolution);

/// The period of an evenly sampled signal by the first maximum of its autocorrelation after half of `guess`, s; a
/// running mean over four guesses is taken off before. The uncertainty is that of the mean of four parts.
[[nodiscard]] Figure period_by_autocorrelation(const Record& record, double guess);

}  // namespace stickslip::validation
