// SPDX-License-Identifier: MIT
#pragma once

/// How a series rises or falls: measures of "generally".

#include <cstddef>
#include <vector>

namespace stickslip::testing {

/// Kendall's rank correlation of the values with their order: the share of pairs that rise less that of those
/// that fall, from -1 (every value below all before it) to 1. At -0.5 three pairs of four fall.
inline double rank_correlation(const std::vector<double>& values) {
  int balance = 0, pairs = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = i + 1; k < values.size(); ++k, ++pairs)
      balance += (values[k] > values[i] ? 1 : 0) - (values[k] < values[i] ? 1 : 0);
  return static_cast<double>(balance) / pairs;
}

/// The number of neighbours of which the second is smaller.
inline int falling_steps(const std::vector<double>& values) {
  int falling = 0;
  for (std::size_t i = 1; i < values.size(); ++i) falling += values[i] < values[i - 1] ? 1 : 0;
  return falling;
}

}  // namespace stickslip::testing
