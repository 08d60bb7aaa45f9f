// SPDX-License-Identifier: MIT
/// The beam element with shear against what it must do: its integrals, its limits, exact deflections, no locking.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "solver/element_integral.hpp"
#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using solver::ElementMatrix;
using solver::ElementVector;

constexpr double element_length = 0.7;

data::Beam square_beam(double length, double shear_stiffness) {
  return data::Beam({.length = length,
                     .area = 0.01,
                     .second_moment_of_area = 1e-4 / 12.0,
                     .density = 1000.0,
                     .youngs_modulus = 2e9,
                     .axial_force = 0.0,
                     .shear_stiffness = shear_stiffness});
}

// N' - theta, constant over the element: in equilibrium -EI theta''/(k G A), with the third derivatives
// (12, 6 l, -12, 6 l)/l^3 of Hermite's functions over 1 + g.
ElementVector shear_strains(double g) {
  return ElementVector(-1.0 / element_length, -0.5, 1.0 / element_length, -0.5) * g / (1.0 + g);
}

// Derivative of the cubic shape functions, which a central difference of two steps gives exactly.
ElementVector slopes(double s, double g) {
  constexpr double d = 0.25;
  const auto difference = [&](double step) -> ElementVector {
    return (solver::shape_functions(s + step, element_length, g) -
            solver::shape_functions(s - step, element_length, g)) /
           (2.0 * step * element_length);
  };
  return (4.0 * difference(d) - difference(2.0 * d)) / 3.0;
}

void expect_equal(const ElementMatrix& computed, const ElementMatrix& expected) {
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j)
      EXPECT_TRUE(within(computed(i, j), expected(i, j), round_off(60, 4, expected.cwiseAbs().maxCoeff())))
          << i << ", " << j;
}

STICKSLIP_VERIFIES(ShearElement, "F12");
TEST(ShearElement, HasTheIntegralsOfItsShapeFunctions) {
  for (const double g : {0.0, 0.01, 1.0, 30.0}) {
    const ElementVector strain = shear_strains(g);
    const auto rotation = [&](double s) -> ElementVector { return slopes(s, g) - strain; };
    const auto curvature = [&](double s) -> ElementVector {  // rotations are parabolas
      return (rotation(s + 0.25) - rotation(s - 0.25)) / (0.5 * element_length);
    };
    expect_equal(solver::consistent_mass(3.5, element_length, g),
                 3.5 * element_integral(element_length, [&](double s) {
                   return solver::shape_functions(s, element_length, g);
                 }));
    expect_equal(solver::rotary_mass(0.3, element_length, g),
                 0.3 * element_integral(element_length, rotation));
    expect_equal(solver::geometric_stiffness(element_length, g),
                 element_integral(element_length, [&](double s) { return slopes(s, g); }));
    ElementMatrix stiffness = 11.0 * element_integral(element_length, curvature);
    if (g > 0.0)
      stiffness += 12.0 * 11.0 / (g * element_length * element_length) *
                   element_integral(element_length, [&](double) { return strain; });
    expect_equal(solver::bending_stiffness(11.0, element_length, g), stiffness);
    const ElementVector at_ends = rotation(0.0) + 2.0 * rotation(1.0);
    for (Eigen::Index i = 0; i < 4; ++i)
      EXPECT_TRUE(within(at_ends[i], i == 1 ? 1.0 : i == 3 ? 2.0 : 0.0, round_off(60, 4, 2.0)));
  }
}

TEST(ShearElement, WithoutShearIsHermitesToTheBit) {
  const auto expect_same = [](const ElementMatrix& with, const ElementMatrix& without) {
    EXPECT_EQ((with - without).cwiseAbs().maxCoeff(), 0.0);
  };
  expect_same(solver::consistent_mass(3.5, element_length, 0.0),
              solver::consistent_mass(3.5, element_length));
  const solver::BeamModel rigid(square_beam(2.0, 0.0), 3), stiff(square_beam(2.0, 1e30), 3);
  EXPECT_EQ(Eigen::MatrixXd(rigid.elastic_stiffness() - stiff.elastic_stiffness()).cwiseAbs().maxCoeff(),
            0.0);
}

// A force F and a moment T at the free tip: w = F (x^2 (3 L - x)/(6 EI) + x/(k G A)) + T x^2/(2 EI), whatever the mesh, and
// however slender or stout the beam: nothing locks.
TEST(ShearElement, BendsAndShearsExactlyAtTheNodesOfAnyMesh) {
  for (const double length : {0.05, 0.5, 5.0, 500.0})
    for (const int elements : {1, 3}) {
      const solver::BeamModel model(square_beam(length, 0.01 * 2e9 / 3.12), elements);
      Eigen::VectorXd load = Eigen::VectorXd::Zero(model.degrees_of_freedom());
      load[model.tip_deflection()] = 2.0;
      load[model.tip_rotation()] = 0.3 * length;
      const Eigen::VectorXd q = Eigen::MatrixXd(model.elastic_stiffness()).ldlt().solve(load);
      const double bending = 2e9 * 1e-4 / 12.0, shear = 0.01 * 2e9 / 3.12;
      for (int node = 1; node <= elements; ++node) {
        const double x = length * node / elements;
        const double w = 2.0 * (x * x * (3.0 * length - x) / (6.0 * bending) + x / shear) +
                         0.3 * length * x * x / (2.0 * bending);
        // A tip force meets the stiffness of the clamp 12 elements^3 times more compliant.
        EXPECT_TRUE(within(q[2 * node - 2], w, round_off(20, 12.0 * std::pow(elements, 3), w))) << length;
      }
    }
}

}  // namespace
}  // namespace stickslip::testing
