// SPDX-License-Identifier: MIT
#include "stickslip/solver/beam_element.hpp"

namespace stickslip::solver {

ElementMatrix consistent_mass(double mass_per_length, double element_length) {
  const double l = element_length, l2 = l * l;
  ElementMatrix m;
  m << 156.0, 22.0 * l, 54.0, -13.0 * l,        //
      22.0 * l, 4.0 * l2, 13.0 * l, -3.0 * l2,  //
      54.0, 13.0 * l, 156.0, -22.0 * l,         //
      -13.0 * l, -3.0 * l2, -22.0 * l, 4.0 * l2;
  return m * (mass_per_length * l / 420.0);
}

ElementMatrix bending_stiffness(double flexural_rigidity, double element_length) {
  const double l = element_length, l2 = l * l;
  ElementMatrix k;
  k << 12.0, 6.0 * l, -12.0, 6.0 * l,         //
      6.0 * l, 4.0 * l2, -6.0 * l, 2.0 * l2,  //
      -12.0, -6.0 * l, 12.0, -6.0 * l,        //
      6.0 * l, 2.0 * l2, -6.0 * l, 4.0 * l2;
  return k * (flexural_rigidity / (l2 * l));
}

ElementMatrix geometric_stiffness(double element_length) {
  const double l = element_length, l2 = l * l;
  ElementMatrix k;
  k << 36.0, 3.0 * l, -36.0, 3.0 * l,    //
      3.0 * l, 4.0 * l2, -3.0 * l, -l2,  //
      -36.0, -3.0 * l, 36.0, -3.0 * l,   //
      3.0 * l, -l2, -3.0 * l, 4.0 * l2;
  return k / (30.0 * l);
}

ElementVector consistent_load(double element_length) {
  const double l = element_length;
  return ElementVector(0.5, l / 12.0, 0.5, -l / 12.0) * l;
}

ElementVector shape_functions(double s, double element_length) {
  const double s2 = s * s, s3 = s2 * s;
  return {1.0 - 3.0 * s2 + 2.0 * s3, element_length * (s - 2.0 * s2 + s3), 3.0 * s2 - 2.0 * s3,
          element_length * (s3 - s2)};
}

}  // namespace stickslip::solver
