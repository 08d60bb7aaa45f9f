// SPDX-License-Identifier: MIT
/// The finite-element matrices before they judge anything: symmetry, definiteness, patch tests on unequal
/// elements, and the exact forms of polynomials on the assembled beam.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <vector>

#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "support/beams.hpp"
#include "support/energy.hpp"
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
const ElementVector rotation(0.0, 1.0, length, 1.0);

// Derivatives of a cubic by s from its values, exact but for round-off.
ElementVector slopes(double s) {
  const auto n = [s](double d) { return solver::shape_functions(s + d, length); };
  return (8.0 * (n(1.0) - n(-1.0)) - (n(2.0) - n(-2.0))) / (12.0 * length);
}

ElementVector curvatures(double s) {
  const auto n = [s](double d) { return solver::shape_functions(s + d, length); };
  return (n(1.0) - 2.0 * n(0.0) + n(-1.0)) / (length * length);
}

// int of the dyad of `row` over the element: three-point Gauss rule, exact to degree 5.
template <class Row>
ElementMatrix integral_of_dyad(const Row& row) {
  const double offset = 0.5 * std::sqrt(0.6);
  ElementMatrix sum = 4.0 / 9.0 * row(0.5) * row(0.5).transpose();
  for (const double s : {0.5 - offset, 0.5 + offset}) sum += 5.0 / 18.0 * row(s) * row(s).transpose();
  return length * sum;
}

void expect_equal(const Eigen::MatrixXd& computed, const Eigen::MatrixXd& expected, double operations) {
  const double scale = expected.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index j = 0; j < expected.cols(); ++j)
      EXPECT_TRUE(within(computed(i, j), expected(i, j), round_off(operations, 1, scale))) << i << ", " << j;
}

STICKSLIP_VERIFIES(BeamElement, "F1");
TEST(BeamElement, MatricesAreSymmetric) {
  for (const ElementMatrix& matrix :
       {solver::consistent_mass(mass_per_length, length),
        solver::bending_stiffness(flexural_rigidity, length), solver::geometric_stiffness(length)})
    EXPECT_EQ(matrix, ElementMatrix(matrix.transpose()));
}

TEST(BeamElement, StiffnessesAreTheIntegralsOfTheirShapeFunctions) {
  expect_equal(solver::bending_stiffness(flexural_rigidity, length),
               flexural_rigidity * integral_of_dyad(curvatures), 20);
  expect_equal(solver::geometric_stiffness(length), integral_of_dyad(slopes), 20);
}

TEST(BeamElement, ShapeFunctionsBelongToTheirDegreesOfFreedom) {
  // Each has its own value or slope 1 at its own node, and 0 otherwise.
  ElementMatrix at_nodes;
  at_nodes << solver::shape_functions(0.0, length), slopes(0.0), solver::shape_functions(1.0, length),
      slopes(1.0);
  expect_equal(at_nodes, ElementMatrix::Identity(), 20);
  for (const double s : {0.0, 0.2, 0.5, 0.77, 1.0}) {
    const ElementVector n = solver::shape_functions(s, length);
    EXPECT_TRUE(within(n.dot(translation), 1.0, round_off(5, 1, 1.0)));
    EXPECT_TRUE(within(n.dot(rotation), s * length, round_off(5, 1, 1.0)));
  }
}

TEST(BeamElement, MassOfARigidBodyIsThatOfARod) {
  const ElementMatrix m = solver::consistent_mass(mass_per_length, length);
  const double whole = mass_per_length * length;
  EXPECT_TRUE(within(translation.dot(m * rotation), whole * length / 2.0, round_off(10, 1, whole)));
  EXPECT_TRUE(within(rotation.dot(m * rotation), whole * length * length / 3.0, round_off(10, 1, whole)));
  // The inertia forces of both, on every degree of freedom.
  expect_equal(m * translation, mass_per_length * solver::consistent_load(length), 10);
}

TEST(BeamElement, HasTwoRigidMotionsWithoutStrainAndOneWithoutSlope) {
  const auto eigenvalues = [](const ElementMatrix& matrix) {
    return Eigen::SelfAdjointEigenSolver<ElementMatrix>(matrix).eigenvalues();
  };
  const Eigen::Vector4d mass = eigenvalues(solver::consistent_mass(mass_per_length, length));
  const Eigen::Vector4d bending = eigenvalues(solver::bending_stiffness(flexural_rigidity, length));
  const Eigen::Vector4d geometric = eigenvalues(solver::geometric_stiffness(length));
  EXPECT_GT(mass[0], 1e-4 * mass[3]);
  for (const Eigen::Index i : {0, 1}) EXPECT_TRUE(within(bending[i], 0.0, round_off(4, 1, bending[3])));
  EXPECT_GT(bending[2], 1e-4 * bending[3]);
  EXPECT_TRUE(within(geometric[0], 0.0, round_off(4, 1, geometric[3])));
  EXPECT_GT(geometric[1], 1e-4 * geometric[3]);
}

// Three unequal elements, and a polynomial c_0 + c_1 x + c_2 x^2 + c_3 x^3 on them.
const std::vector<double> patch{0.3, 0.8, 0.45};
constexpr double patch_length = 1.55;

template <class Element>
Eigen::MatrixXd assembled_patch(const Element& element) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(8, 8);
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const auto first = static_cast<Eigen::Index>(2 * i);
    matrix.block<4, 4>(first, first) += element(patch[i]);
  }
  return matrix;
}

Eigen::VectorXd patch_values(const std::array<double, 4>& c) {
  Eigen::VectorXd values(8);
  double x = 0.0;
  for (Eigen::Index node = 0; node < 4; ++node) {
    values[2 * node] = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
    values[2 * node + 1] = c[1] + x * (2.0 * c[2] + x * 3.0 * c[3]);
    if (node < 3) x += patch[static_cast<std::size_t>(node)];
  }
  return values;
}

TEST(BeamElement, UnequalElementsPassThePatchTestsOfConstantAndLinearCurvature) {
  // Nothing but the moments EI w'' and the shear forces -EI w''' at the ends holds them.
  const Eigen::MatrixXd k =
      assembled_patch([](double l) { return solver::bending_stiffness(flexural_rigidity, l); });
  const double ei = flexural_rigidity, end = patch_length;
  Eigen::VectorXd parabola(8), cubic(8);
  parabola << 0.0, -2.0 * ei, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0 * ei;
  cubic << 6.0 * ei, 0.0, 0.0, 0.0, 0.0, 0.0, -6.0 * ei, 6.0 * ei * end;
  // Entries of 12 EI/l^3 on the shortest element cancel.
  const double largest = 12.0 * ei / std::pow(patch[0], 3);
  const auto expect_forces = [&](const std::array<double, 4>& c, const Eigen::VectorXd& expected) {
    const Eigen::VectorXd forces = k * patch_values(c);
    for (Eigen::Index i = 0; i < 8; ++i)
      EXPECT_TRUE(within(forces[i], expected[i], round_off(4, 1, largest * std::pow(end, 3)))) << i;
  };
  expect_forces({0.0, 0.0, 1.0, 0.0}, parabola);
  expect_forces({0.0, 0.0, 0.0, 1.0}, cubic);
  expect_forces({0.4, -1.3, 0.0, 0.0}, Eigen::VectorXd::Zero(8));
}

TEST(BeamElement, UnequalElementsUnderAxialForcePassThePatchTestOfConstantSlope) {
  // w = x: a string under unit tension, pulled down at one end and up at the other.
  const Eigen::VectorXd forces = assembled_patch([](double l) { return solver::geometric_stiffness(l); }) *
                                 patch_values({0.0, 1.0, 0.0, 0.0});
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(8);
  expected[0] = -1.0;
  expected[6] = 1.0;
  for (Eigen::Index i = 0; i < 8; ++i)
    EXPECT_TRUE(within(forces[i], expected[i], round_off(4, 1, 1.2 / patch[0] * patch_length))) << i;
}

// w = x^power on the clamped beam.
Eigen::VectorXd power_of_x(const solver::BeamModel& model, int power) {
  Eigen::VectorXd values(model.degrees_of_freedom());
  for (Eigen::Index node = 1; node <= model.elements(); ++node) {
    const double x = model.beam().length() * static_cast<double>(node) / model.elements();
    values[2 * node - 2] = std::pow(x, power);
    values[2 * node - 1] = power * std::pow(x, power - 1);
  }
  return values;
}

STICKSLIP_VERIFIES(BeamModel, "F2");
TEST(BeamModel, FormsOfPolynomialsAreTheirIntegrals) {
  const data::Beam beam = paper_beam_with_axial_force(9e3);
  const double end = beam.length(), m = beam.density() * beam.area();
  const double ei = beam.youngs_modulus() * beam.second_moment_of_area();
  for (const int elements : {1, 2, 5}) {
    const solver::BeamModel model(beam, elements);
    // Entries of 12 EI/l^3 add up to EI/L^3.
    const double condition = std::pow(elements, 3);
    const auto same = [&](double computed, double expected) {
      return within(computed, expected, round_off(20, condition, expected));
    };
    const Eigen::VectorXd q2 = power_of_x(model, 2), q3 = power_of_x(model, 3);
    EXPECT_TRUE(same(q2.dot(model.mass() * q2), m * std::pow(end, 5) / 5.0));
    EXPECT_TRUE(same(q2.dot(model.mass() * q3), m * std::pow(end, 6) / 6.0));
    EXPECT_TRUE(same(q2.dot(model.elastic_stiffness() * q3), 6.0 * ei * end * end));
    EXPECT_TRUE(same(q3.dot(model.elastic_stiffness() * q3), 12.0 * ei * std::pow(end, 3)));
    EXPECT_TRUE(same(q2.dot(model.geometric_stiffness() * q3), 1.5 * std::pow(end, 4)));
    EXPECT_TRUE(same(model.base_load().dot(q2), m * std::pow(end, 3) / 3.0));
    EXPECT_TRUE(same(model.base_load().dot(q3), m * std::pow(end, 4) / 4.0));
    EXPECT_TRUE(same(elastic_energy(model, q2), 2.0 * ei * end));
    EXPECT_TRUE(same(geometric_energy(model, q2), -2.0 / 3.0 * 9e3 * std::pow(end, 3)));
    EXPECT_TRUE(
        same(q2.dot(model.stick_stiffness() * q2), 4.0 * ei * end - 4.0 / 3.0 * 9e3 * std::pow(end, 3)));
    EXPECT_TRUE(within(model.interpolation(0.37).dot(q3), std::pow(0.37, 3), round_off(20, 1, 0.37)));
  }
}

TEST(BeamModel, SlipStateHoldsAParabolaByItsLoadAndItsTipMomentAlone) {
  // EI w'''' + P w'' = 2 P along the beam, EI w'' = 2 EI at the tip, EI w''' = 0: no tip force, although P w'
  // is not zero there. In stick the tip's row keeps -P w'(L).
  for (const double axial_force : {-4e4, 9e3}) {
    const data::Beam beam = paper_beam_with_axial_force(axial_force);
    const double ei = beam.youngs_modulus() * beam.second_moment_of_area(), end = beam.length();
    const solver::BeamModel model(beam, 5);
    const Eigen::VectorXd q = power_of_x(model, 2);
    Eigen::VectorXd expected = 2.0 * axial_force / (beam.density() * beam.area()) * model.base_load();
    expected[model.tip_rotation()] += 2.0 * ei;
    const double largest = 12.0 * ei / std::pow(end / 5.0, 3) * end * end;
    const auto expect_forces = [&](const solver::SparseMatrix& stiffness) {
      const Eigen::VectorXd forces = stiffness * q;
      for (Eigen::Index i = 0; i < q.size(); ++i)
        EXPECT_TRUE(within(forces[i], expected[i], round_off(4, 1, largest)))
            << i << " at P = " << axial_force;
    };
    expect_forces(model.slip_stiffness());
    expected[model.tip_deflection()] -= axial_force * 2.0 * end;
    expect_forces(model.stick_stiffness());
  }
}

TEST(BeamModel, MatricesOfTheClampedBeamArePositiveDefiniteAndSymmetric) {
  const solver::BeamModel model(paper_beam_with_axial_force(-1e4), 6);
  for (const solver::SparseMatrix* sparse :
       {&model.mass(), &model.elastic_stiffness(), &model.geometric_stiffness(), &model.stick_stiffness()}) {
    const Eigen::MatrixXd matrix = *sparse;
    EXPECT_EQ(matrix, Eigen::MatrixXd(matrix.transpose()));
    EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(matrix).info(), Eigen::Success);
  }
  EXPECT_NE(Eigen::MatrixXd(model.slip_stiffness()), Eigen::MatrixXd(model.slip_stiffness().transpose()));
}

}  // namespace
}  // namespace stickslip::testing
