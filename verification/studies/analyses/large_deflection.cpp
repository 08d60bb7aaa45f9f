// SPDX-License-Identifier: MIT
#include "studies/analyses/large_deflection.hpp"

#include <fmt/format.h>

#include <cmath>

#include "studies/criterion/problem_warnings.hpp"

namespace stickslip::studies {

double curvature_error(const data::Beam& beam, double deflection) {
  return 27.0 / 8.0 * std::pow(deflection / beam.length(), 2);
}

std::optional<std::string> deflection_warning(const data::Beam& beam, double deflection) {
  const double error = curvature_error(beam, deflection);
  if (!(error > allowed_model_error)) return std::nullopt;
  return fmt::format(
      "the tip is deflected by {:.3g} m, {:.2g} % of the length: the model is that of small slopes, and its "
      "curvature is then wrong by about {:.2g} %",
      std::abs(deflection), 100.0 * std::abs(deflection) / beam.length(), 100.0 * error);
}

}  // namespace stickslip::studies
