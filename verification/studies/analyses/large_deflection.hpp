// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// The relative error of the linear curvature for a tip that is deflected by w (m) relative to the base. A beam has the
/// curvature y''/(1 + y'²)^(3/2), which y'' exceeds by 3/2 y'² to leading order; a cantilever with a force at its tip has the largest slope
/// there, 3 w/(2 L), so that
///
///     error = 27/8 (w/L)².
[[nodiscard]] double curvature_error(const data::Beam& beam, double deflection);

/// The warning that a deflection of the tip leaves the theory of small slopes: curvature_error() above allowed_model_error,
/// which is 12 % of the length.
[[nodiscard]] std::optional<std::string> deflection_warning(const data::Beam& beam, double deflection);

}  // namespace stickslip::studies
