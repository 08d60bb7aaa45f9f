// SPDX-License-Identifier: MIT
#pragma once

/// The judgement of single points of a comparison.

#include <string>

#include "comparison/comparison.hpp"
#include "comparison/samples.hpp"

namespace stickslip::comparison {

/// The divisor that converts an error to the norm of the quantity: for the norm relative |reference| or, where
/// that is 0, the scale.
[[nodiscard]] double unit_of(data::Norm norm, double reference, double scale);

/// Whether the values are angles, which are right to whole turns.
[[nodiscard]] bool is_angle(const std::string& unit, data::Norm norm);

/// The angle plus or minus whole turns that is nearest to the reference, rad.
[[nodiscard]] double nearest_angle(double angle, double reference);

/// Counts a point that was not compared.
void skip(Comparison::Quantity& quantity, const std::string& reason);

/// What errors of a group are measured by: in the norm of the quantity, and on the ladder of levels.
struct Scales {
  double norm{}, level{};
};

/// Adds the point to the last series and updates the result of the quantity; skips it where the reference has no
/// value.
void judge(Comparison::Quantity& quantity, const ComparedSample& point, const Scales& scales,
           const std::string& where);

/// The index in level_names.
[[nodiscard]] std::size_t level_of(const Comparison::Quantity& quantity);

/// A quantity that counts deviations, such as words that differ or events that are missing. It differs if there
/// are more of them than its tolerance.
[[nodiscard]] Comparison::Quantity count_of(const std::string& name, const std::string& unit,
                                            data::Norm norm = data::Norm::absolute, double tolerance = 0.0);
void count(Comparison::Quantity& quantity, const std::string& where);

}  // namespace stickslip::comparison
