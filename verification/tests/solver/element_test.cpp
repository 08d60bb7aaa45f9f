// SPDX-License-Identifier: MIT
/// The beam element against what it must do, whatever its entries: integrals, no locking.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using solver::ElementMatrix;
using solver::ElementVector;

constexpr double length = 0.7;
constexpr double mass_per_length = 3.5;
constexpr double flexural_rigidity = 11.0;

const ElementVector translation(1.0, 0.0, 1.0, 0.0);
const ElementVector rotation(0.0, 1.0, length, 1.0);  // w = x

void expect_equal(const Eigen::MatrixXd& computed, const Eigen::MatrixXd& expected, double operations) {
  const double scale = expected.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index j = 0; j < expected.cols(); ++j)
      EXPECT_TRUE(within(computed(i, j), expected(i, j), round_off(operations, 1, scale))) << i << ", " << j;
}

// int v v^T dx of an element vector v(x/l) by Gauss's rule of four points, exact where v is of degree 3 at most.
template <class Integrand>
ElementMatrix integral(const Integrand& integrand) {
  const double a = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double b = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(6.0 / 5.0));
  const double wa = (18.0 + std::sqrt(30.0)) / 36.0, wb = (18.0 - std::sqrt(30.0)) / 36.0;
  ElementMatrix sum = ElementMatrix::Zero();
  for (const auto& [point, weight] :
       std::array<std::array<double, 2>, 4>{{{-b, wb}, {-a, wa}, {a, wa}, {b, wb}}}) {
    const ElementVector value = integrand(0.5 * (1.0 + point));
    sum += 0.5 * length * weight * value * value.transpose();
  }
  return sum;
}

// N' of the cubic shape functions, which central differences of two steps give exactly but for round-off.
ElementVector slopes(double s, double g) {
  const auto difference = [&](double step) -> ElementVector {
    return (solver::shape_functions(s + step, length, g) - solver::shape_functions(s - step, length, g)) /
           (2.0 * step * length);
  };
  return (4.0 * difference(1.0) - difference(2.0)) / 3.0;
}

void expect_integrals_of_shape_functions(double g) {
  // N' - theta, constant over the element: in equilibrium -EI theta''/(k G A), with the third derivatives
  // (12, 6 l, -12, 6 l)/l^3 of Hermite's functions over 1 + g.
  const ElementVector strain = ElementVector(-1.0 / length, -0.5, 1.0 / length, -0.5) * g / (1.0 + g);
  const auto theta = [&](double s) -> ElementVector { return slopes(s, g) - strain; };
  const auto curvature = [&](double s) -> ElementVector {  // theta is a parabola
    return (theta(s + 0.25) - theta(s - 0.25)) / (0.5 * length);
  };
  expect_equal(solver::consistent_mass(mass_per_length, length, g),
               mass_per_length * integral([&](double s) { return solver::shape_functions(s, length, g); }),
               20);
  expect_equal(solver::rotary_mass(0.3, length, g), 0.3 * integral(theta), 20);
  expect_equal(solver::geometric_stiffness(length, g), integral([&](double s) { return slopes(s, g); }), 20);
  ElementMatrix stiffness = flexural_rigidity * integral(curvature);
  if (g > 0.0)
    stiffness += 12.0 * flexural_rigidity / (g * length * length) * integral([&](double) { return strain; });
  expect_equal(solver::bending_stiffness(flexural_rigidity, length, g), stiffness, 20);

  // Each shape function has its own value or rotation 1 at its own node, and 0 otherwise.
  ElementMatrix at_nodes;
  at_nodes << solver::shape_functions(0.0, length, g), theta(0.0), solver::shape_functions(1.0, length, g),
      theta(1.0);
  expect_equal(at_nodes, ElementMatrix::Identity(), 20);
}

STICKSLIP_VERIFIES(BeamElement, "F1");
TEST(BeamElement, HasTheIntegralsOfItsShapeFunctions) { expect_integrals_of_shape_functions(0.0); }

TEST(BeamElement, ShapeFunctionsInterpolateCubicsExactly) {
  const auto cubic = [](double x) { return 0.3 - 1.2 * x + 0.8 * x * x + 2.1 * x * x * x; };
  const auto slope = [](double x) { return -1.2 + 1.6 * x + 6.3 * x * x; };
  const ElementVector q(cubic(0.0), slope(0.0), cubic(length), slope(length));
  for (const double s : {0.0, 0.1, 0.2, 0.37, 0.5, 0.77, 0.9, 1.0}) {
    const ElementVector n = solver::shape_functions(s, length);
    EXPECT_TRUE(within(n.dot(q), cubic(s * length), round_off(20, 1, 2.0))) << s;
    EXPECT_TRUE(within(n.dot(translation), 1.0, round_off(5, 1, 1.0))) << s;
    EXPECT_TRUE(within(n.dot(rotation), s * length, round_off(5, 1, 1.0))) << s;
  }
}

STICKSLIP_VERIFIES(ShearElement, "F12");
TEST(ShearElement, HasTheIntegralsOfItsShapeFunctions) {
  for (const double g : {0.01, 1.0, 30.0}) {
    SCOPED_TRACE(g);
    expect_integrals_of_shape_functions(g);
  }
}

data::Beam square_beam(double beam_length, double shear_stiffness) {
  return data::Beam({.length = beam_length,
                     .area = 0.01,
                     .second_moment_of_area = 1e-4 / 12.0,
                     .density = 1000.0,
                     .youngs_modulus = 2e9,
                     .axial_force = 0.0,
                     .shear_stiffness = shear_stiffness});
}

TEST(ShearElement, WithoutShearIsHermitesToTheBit) {
  const solver::BeamModel rigid(square_beam(2.0, 0.0), 3), stiff(square_beam(2.0, 1e30), 3);
  EXPECT_EQ(Eigen::MatrixXd(rigid.elastic_stiffness() - stiff.elastic_stiffness()).cwiseAbs().maxCoeff(),
            0.0);
}

// A force F and a moment T at the free tip: w = F (x^2 (3 L - x)/(6 EI) + x/(k G A)) + T x^2/(2 EI), whatever the mesh, and
// however slender or stout the beam: nothing locks.
TEST(ShearElement, BendsAndShearsExactlyAtTheNodesOfAnyMesh) {
  const double bending = 2e9 * 1e-4 / 12.0, shear = 0.01 * 2e9 / 3.12;
  for (const double end : {0.05, 0.5, 5.0, 500.0})
    for (const int elements : {1, 3}) {
      const solver::BeamModel model(square_beam(end, shear), elements);
      Eigen::VectorXd load = Eigen::VectorXd::Zero(model.degrees_of_freedom());
      load[model.tip_deflection()] = 2.0;
      load[model.tip_rotation()] = 0.3 * end;
      const Eigen::VectorXd q = Eigen::MatrixXd(model.elastic_stiffness()).ldlt().solve(load);
      for (int node = 1; node <= elements; ++node) {
        const double x = end * node / elements;
        const double w = 2.0 * (x * x * (3.0 * end - x) / (6.0 * bending) + x / shear) +
                         0.3 * end * x * x / (2.0 * bending);
        // A tip force meets the stiffness of the clamp 12 elements^3 times more compliant.
        EXPECT_TRUE(within(q[2 * node - 2], w, round_off(20, 12.0 * std::pow(elements, 3), w)))
            << end << " m, " << elements << " elements";
      }
    }
}

}  // namespace
}  // namespace stickslip::testing
