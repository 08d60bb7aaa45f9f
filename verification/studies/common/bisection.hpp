// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <utility>

namespace stickslip::studies {

/// Two places between which a condition that is true at `low` and false at `high` changes. It is true at the first of them and false
/// at the second, and they are no more than `accuracy` apart or have no number between them. If it changes several times, around one
/// of these places.
template <class Condition>
[[nodiscard]] std::pair<double, double> bracketed(double low, double high, const Condition& is_below,
                                                  double accuracy = 0.0) {
  for (double middle = std::midpoint(low, high); high - low > accuracy && low < middle && middle < high;
       middle = std::midpoint(low, high))
    (is_below(middle) ? low : high) = middle;
  return {low, high};
}

/// The middle between them.
template <class Condition>
[[nodiscard]] double bisected(double low, double high, const Condition& is_below, double accuracy = 0.0) {
  const auto [below, above] = bracketed(low, high, is_below, accuracy);
  return std::midpoint(below, above);
}

}  // namespace stickslip::studies
