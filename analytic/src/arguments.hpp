// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "stickslip/data/input_error.hpp"

namespace stickslip::analytic {

/// A mistake in the program, not in the input of a user, with the message of data::FieldError.
[[nodiscard]] inline std::invalid_argument wrong_argument(std::string_view name, double value,
                                                          std::string_view allowed) {
  return std::invalid_argument(data::FieldError(name, value, allowed).what());
}

/// Throws data::FieldError unless the condition holds.
inline void require(bool condition, std::string_view field, double value, std::string_view allowed) {
  if (!condition) throw data::FieldError(field, value, allowed);
}

inline void require_positive(std::string_view field, double value) {
  require(value > 0.0 && std::isfinite(value), field, value, "positive and finite");
}

inline void require_mode_count(int modes) {
  require(modes >= 1 && modes <= 1000, "numerics.modes", modes, "1 ... 1000");
}

/// Of the bounds of a maximum. Throws std::invalid_argument.
inline void require_relative_width(double relative_width, double smallest = 1e-13) {
  if (relative_width >= smallest && relative_width < 1.0) return;
  throw wrong_argument("relative_width", relative_width, data::shortest_text(smallest) + " ... 1");
}

}  // namespace stickslip::analytic
