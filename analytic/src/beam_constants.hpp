// SPDX-License-Identifier: MIT
#pragma once

/// What the closed forms need of a beam, derived here and nowhere else on this side.

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// EI, N m^2.
[[nodiscard]] inline double bending_stiffness(const data::Beam& beam) {
  return beam.youngs_modulus() * beam.second_moment_of_area();
}

/// rho A, kg/m.
[[nodiscard]] inline double mass_per_length(const data::Beam& beam) { return beam.density() * beam.area(); }

/// z = P L^2/EI, dimensionless, positive in compression.
[[nodiscard]] inline double axial_load_factor(const data::Beam& beam) {
  return beam.axial_force() * beam.length() * beam.length() / bending_stiffness(beam);
}

}  // namespace stickslip::analytic
