// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>

namespace stickslip::studies {

/// Where a condition that is true at `low` and false at `high` changes: the middle of the last of the intervals that are halved, which
/// is no longer than `accuracy` or has no number inside. If it changes several times, one of these places.
template <class Condition>
[[nodiscard]] double bisected(double low, double high, const Condition& is_below, double accuracy = 0.0) {
  double middle = std::midpoint(low, high);
  while (high - low > accuracy && low < middle && middle < high) {
    (is_below(middle) ? low : high) = middle;
    middle = std::midpoint(low, high);
  }
  return middle;
}

}  // namespace stickslip::studies
