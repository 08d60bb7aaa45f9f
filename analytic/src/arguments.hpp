// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "stickslip/data/input_error.hpp"

namespace stickslip::analytic {

/// A mistake of the caller, which no input of a user can cause, in the words of data::FieldError.
[[nodiscard]] inline std::invalid_argument wrong_argument(std::string_view name, double value,
                                                          std::string_view allowed) {
  return std::invalid_argument(data::FieldError(name, value, allowed).what());
}

/// Throws data::FieldError unless the value is positive and finite.
inline void require_positive(std::string_view field, double value) {
  if (!(value > 0.0 && std::isfinite(value))) throw data::FieldError(field, value, "positive and finite");
}

}  // namespace stickslip::analytic
