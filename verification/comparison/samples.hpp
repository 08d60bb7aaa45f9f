// SPDX-License-Identifier: MIT
#pragma once

/// Curves given by samples, and their values between the samples.

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::comparison {

/// The samples of a curve. The abscissas increase.
struct Samples {
  std::vector<double> abscissa, values, half_width;
};

struct Interpolated {
  double value{}, half_width{};
};

/// The interpolation polynomial of this rule through the nearest order + 1 samples. The half-width is the
/// stated bound of the error and the amplified half-widths of the samples. Empty for too few samples.
[[nodiscard]] std::optional<Interpolated> interpolated(const Samples& samples, double x,
                                                       const data::Interpolation& rule, double error_bound);

/// The largest error with which the cubic through its four neighbours reproduces a sample, of the eight samples
/// on either side of x. Infinite for less than five samples.
[[nodiscard]] double roughness_at(const Samples& samples, double x);

/// The cubic through the nearest four samples, or the parabola through three. To the amplified half-widths of
/// the samples it adds the estimated error of the interpolation: twice the roughness, or twice `most_rough` if
/// that is less, times 4 s (1 - s), where s is the place of x between its two neighbours, from 0 to 1. That is
/// generous for a smooth curve, and it shows what varies faster than the samples. It is no bound: nothing shows
/// what has the period of the samples. With less than five samples the error is the difference to the straight
/// line. Empty for less than three samples.
[[nodiscard]] std::optional<Interpolated> interpolated(
    const Samples& samples, double x, double most_rough = std::numeric_limits<double>::infinity());

/// A value of the user and of the reference at the same abscissa.
struct ComparedSample {
  double abscissa{};
  Interpolated theirs;
  std::optional<Interpolated> reference;
};

struct ComparedSamples {
  std::vector<ComparedSample> points;
  std::size_t between{};    ///< samples of the user that serve the interpolation only
  std::size_t past_last{};  ///< samples of the user where the reference has none
};

/// Compares at the user's abscissas, where the data set states the error of its interpolation.
[[nodiscard]] ComparedSamples by_stated_interpolation(const Samples& reference, const Samples& theirs,
                                                      const data::Interpolation& rule, double error_bound,
                                                      double coincidence);

/// Compares at the samples of the reference that have samples of the user near by, and at the user's samples
/// that have none of their own near by. "Near by" is the spacing of the reference. Where the reference is
/// smooth, a rough result of the user is no uncertainty but an error.
[[nodiscard]] ComparedSamples by_own_interpolation(const Samples& reference, const Samples& theirs,
                                                   double spacing, double coincidence);

// The judgement of single points of a comparison.

/// The divisor that converts an error to the norm of the quantity: for the norm relative |reference| or, where
/// that is 0, the scale.
[[nodiscard]] double unit_of(data::Norm norm, double reference, double scale);

/// The error that is allowed beyond the half-widths, in the unit of the quantity: by its tolerance or its level.
[[nodiscard]] double allowed_error(const Comparison::Quantity& quantity, double reference, double scale);

/// Whether the values are angles, which are right to whole turns.
[[nodiscard]] bool is_angle(const std::string& unit, data::Norm norm);

/// The angle plus or minus whole turns that is nearest to the reference, rad.
[[nodiscard]] double nearest_angle(double angle, double reference);

void skip(Comparison::Quantity& quantity, const std::string& reason);

/// Adds the point to the last series and updates the result of the quantity; skips it where the reference has no
/// value. `scale` is that of the group, for norms that have one and for the level.
void judge(Comparison::Quantity& quantity, const ComparedSample& point, double scale,
           const std::string& where);

[[nodiscard]] std::size_t level_of(const Comparison::Quantity& quantity);

/// A quantity that counts deviations, such as words that differ or events that are missing. It differs if there
/// are more of them than its tolerance.
[[nodiscard]] Comparison::Quantity count_of(const std::string& name, const std::string& unit,
                                            data::Norm norm = data::Norm::absolute, double tolerance = 0.0);
void count(Comparison::Quantity& quantity, const std::string& where);

}  // namespace stickslip::comparison
