// SPDX-License-Identifier: MIT
/// Hermite element matrices against what they must do, whatever their entries.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "solver/element_integral.hpp"
#include "stickslip/solver/beam_element.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using solver::ElementMatrix;
using solver::ElementVector;

constexpr double length = 0.7;

// Degrees of freedom of a deflection given with its slope at both ends.
ElementVector nodal(double w1, double theta1, double w2, double theta2) { return {w1, theta1, w2, theta2}; }

const ElementVector translation = nodal(1.0, 0.0, 1.0, 0.0);
const ElementVector rotation = nodal(0.0, 1.0, length, 1.0);                   // w = x
const ElementVector parabola = nodal(0.0, 0.0, length* length, 2.0 * length);  // w = x^2

// int_0^l w_i w_j by the exact integral of the cubic shape functions.
ElementMatrix mass_by_quadrature(double mass_per_length) {
  return mass_per_length *
         element_integral(length, [](double s) { return solver::shape_functions(s, length); });
}

void expect_close(const ElementMatrix& computed, const ElementMatrix& expected) {
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j)
      EXPECT_TRUE(within(computed(i, j), expected(i, j), round_off(20, 1, expected.cwiseAbs().maxCoeff())))
          << "entry " << i << ", " << j;
}

STICKSLIP_VERIFIES(BeamElement, "F1");
TEST(BeamElement, ConsistentMassIsTheIntegralOfItsShapeFunctions) {
  expect_close(solver::consistent_mass(3.5, length), mass_by_quadrature(3.5));
}

TEST(BeamElement, ConsistentMassHoldsTheWholeMass) {
  const ElementMatrix m = solver::consistent_mass(3.5, length);
  EXPECT_TRUE(within(translation.dot(m * translation), 3.5 * length, round_off(20, 1, 3.5 * length)));
}

TEST(BeamElement, BendingStiffnessIsFreeOfRigidBodyForces) {
  const ElementMatrix k = solver::bending_stiffness(11.0, length);
  const double scale = k.cwiseAbs().maxCoeff();
  EXPECT_LE((k * translation).cwiseAbs().maxCoeff(), round_off(4, 1, scale).value);
  EXPECT_LE((k * rotation).cwiseAbs().maxCoeff(), round_off(4, 1, scale).value);
}

TEST(BeamElement, BendingStiffnessPassesTheConstantCurvaturePatchTest) {
  // w = x^2: moment 2 EI throughout, no shear force.
  const ElementVector force = solver::bending_stiffness(11.0, length) * parabola;
  const ElementVector expected = nodal(0.0, -22.0, 0.0, 22.0);
  for (Eigen::Index i = 0; i < 4; ++i) EXPECT_TRUE(within(force[i], expected[i], round_off(10, 10, 22.0)));
}

TEST(BeamElement, GeometricStiffnessMeasuresTheSlope) {
  const ElementMatrix k = solver::geometric_stiffness(length);
  // int (dx/dx)^2 = l, int (2x)^2 = 4 l^3/3, int 2x = l^2; a translation has no slope.
  EXPECT_TRUE(within(rotation.dot(k * rotation), length, round_off(20, 1, length)));
  const double expected = 4.0 * length * length * length / 3.0;
  EXPECT_TRUE(within(parabola.dot(k * parabola), expected, round_off(20, 10, expected)));
  EXPECT_TRUE(within(rotation.dot(k * parabola), length * length, round_off(20, 10, 1.0)));
  EXPECT_LE((k * translation).cwiseAbs().maxCoeff(), round_off(4, 1, k.cwiseAbs().maxCoeff()).value);
}

TEST(BeamElement, ConsistentLoadIsTheIntegralOfItsShapeFunctions) {
  const ElementVector load = solver::consistent_load(length);
  EXPECT_TRUE(within(load.dot(translation), length, round_off(10, 1, 1.0)));
  EXPECT_TRUE(within(load.dot(rotation), length * length / 2.0, round_off(10, 1, 1.0)));
  EXPECT_TRUE(within(load.dot(parabola), std::pow(length, 3) / 3.0, round_off(10, 1, 1.0)));
}

TEST(BeamElement, ShapeFunctionsInterpolateCubicsExactly) {
  const auto cubic = [](double x) { return 0.3 - 1.2 * x + 0.8 * x * x + 2.1 * x * x * x; };
  const auto slope = [](double x) { return -1.2 + 1.6 * x + 6.3 * x * x; };
  const ElementVector q = nodal(cubic(0.0), slope(0.0), cubic(length), slope(length));
  for (const double s : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0})
    EXPECT_TRUE(within(solver::shape_functions(s, length).dot(q), cubic(s * length), round_off(20, 1, 2.0)));
}

}  // namespace
}  // namespace stickslip::testing
