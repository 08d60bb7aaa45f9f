// SPDX-License-Identifier: MIT
#include "stickslip/solver/beam_element.hpp"

namespace stickslip::solver {

namespace {

// A matrix of an element that looks the same from both ends, by its entries (w1, w1), (w1, θ1), (w1, w2),
// (w1, θ2), (θ1, θ1), (θ1, θ2).
ElementMatrix symmetric(double a, double b, double c, double d, double e, double f) {
  ElementMatrix m;
  m << a, b, c, d,   //
      b, e, -d, f,   //
      c, -d, a, -b,  //
      d, f, -b, e;
  return m;
}

double squared(double x) { return x * x; }

}  // namespace

ElementMatrix consistent_mass(double mass_per_length, double element_length, double shear_parameter) {
  const double l = element_length, l2 = l * l, g = shear_parameter;
  return symmetric(156.0 + g * (294.0 + 140.0 * g), l * (22.0 + g * (38.5 + 17.5 * g)),
                   54.0 + g * (126.0 + 70.0 * g), -l * (13.0 + g * (31.5 + 17.5 * g)),
                   l2 * (4.0 + g * (7.0 + 3.5 * g)), -l2 * (3.0 + g * (7.0 + 3.5 * g))) *
         (mass_per_length * l / (420.0 * squared(1.0 + g)));
}

ElementMatrix rotary_mass(double rotary_inertia_per_length, double element_length, double shear_parameter) {
  const double l = element_length, l2 = l * l, g = shear_parameter;
  return symmetric(36.0, l * (3.0 - 15.0 * g), -36.0, l * (3.0 - 15.0 * g), l2 * (4.0 + g * (5.0 + 10.0 * g)),
                   -l2 * (1.0 + g * (5.0 - 5.0 * g))) *
         (rotary_inertia_per_length / (30.0 * l * squared(1.0 + g)));
}

ElementMatrix bending_stiffness(double flexural_rigidity, double element_length, double shear_parameter) {
  const double l = element_length, l2 = l * l, g = shear_parameter;
  return symmetric(12.0, 6.0 * l, -12.0, 6.0 * l, l2 * (4.0 + g), l2 * (2.0 - g)) *
         (flexural_rigidity / (l2 * l * (1.0 + g)));
}

ElementMatrix geometric_stiffness(double element_length, double shear_parameter) {
  const double l = element_length, l2 = l * l, g = shear_parameter;
  const double translation = 36.0 + g * (60.0 + 30.0 * g);
  return symmetric(translation, 3.0 * l, -translation, 3.0 * l, l2 * (4.0 + g * (5.0 + 2.5 * g)),
                   -l2 * (1.0 + g * (5.0 + 2.5 * g))) /
         (30.0 * l * squared(1.0 + g));
}

ElementVector consistent_load(double element_length) {
  const double l = element_length;
  return ElementVector(0.5, l / 12.0, 0.5, -l / 12.0) * l;
}

ElementVector shape_functions(double s, double element_length, double shear_parameter) {
  const double s2 = s * s, s3 = s2 * s, g = shear_parameter;
  const ElementVector numerators{
      1.0 - 3.0 * s2 + 2.0 * s3 + g * (1.0 - s), element_length * (s - 2.0 * s2 + s3 + 0.5 * g * (s - s2)),
      3.0 * s2 - 2.0 * s3 + g * s, element_length * (s3 - s2 - 0.5 * g * (s - s2))};
  return numerators / (1.0 + g);
}

}  // namespace stickslip::solver
