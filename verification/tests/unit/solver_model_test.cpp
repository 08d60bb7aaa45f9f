/// The assembled beam: statics that a Hermite mesh reproduces exactly, the follower term, input errors.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>
#include <string>

#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "support/beams.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

double rigidity(const data::Beam& beam) { return beam.youngs_modulus() * beam.second_moment_of_area(); }

Eigen::VectorXd solve_slip_statics(const solver::BeamModel& model, const Eigen::VectorXd& load) {
  return Eigen::PartialPivLU<Eigen::MatrixXd>(Eigen::MatrixXd(model.slip_stiffness())).solve(load);
}

TEST(BeamModel, TipLoadBendsTheCantileverExactly) {
  const data::Beam beam = paper_beam_with_axial_force(0.0);
  for (const int elements : {1, 2, 7}) {
    const solver::BeamModel model(beam, elements);
    const Eigen::VectorXd load = Eigen::VectorXd::Unit(model.degrees_of_freedom(), model.tip_deflection());
    const double expected = std::pow(beam.length(), 3) / (3.0 * rigidity(beam));
    EXPECT_TRUE(within(solve_slip_statics(model, load)[model.tip_deflection()], expected,
                       round_off(14, std::pow(elements, 4), expected)));
  }
}

TEST(BeamModel, UniformAccelerationBendsTheCantileverExactlyAtItsTip) {
  const data::Beam beam = paper_beam_with_axial_force(0.0);
  const solver::BeamModel model(beam, 5);
  const double per_length = beam.density() * beam.area();
  const double expected = per_length * std::pow(beam.length(), 4) / (8.0 * rigidity(beam));
  EXPECT_TRUE(within(solve_slip_statics(model, model.base_load())[model.tip_deflection()], expected,
                     round_off(14, 625, expected)));
}

TEST(BeamModel, BaseLoadHoldsTheWholeMass) {
  const data::Beam beam = paper_beam();
  const solver::BeamModel model(beam, 6);
  double forces = 0.0;
  for (Eigen::Index i = 0; i < model.degrees_of_freedom(); i += 2) forces += model.base_load()[i];
  // The clamped node keeps half an element.
  const double expected = beam.density() * beam.area() * beam.length() * (1.0 - 0.5 / 6.0);
  EXPECT_TRUE(within(forces, expected, round_off(6, 1, expected)));
}

TEST(BeamModel, UnitTipDeflectionIsTheProppedCantileverShape) {
  // P = 0: (3 xi^2 - xi^3)/2, a cubic, so exact everywhere.
  const solver::BeamModel model(paper_beam_with_axial_force(0.0), 4);
  const Eigen::VectorXd shape = model.unit_tip_deflection();
  for (const double xi : {0.1, 0.25, 0.6, 0.93, 1.0})
    EXPECT_TRUE(within(model.interpolation(2.0 * xi).dot(shape), 0.5 * (3.0 * xi * xi - xi * xi * xi),
                       round_off(8, 256, 1.0)));
}

TEST(BeamModel, FollowerTermIsTheAxialForceInTheTipRowAlone) {
  const solver::BeamModel model(paper_beam(), 5);
  Eigen::MatrixXd difference =
      Eigen::MatrixXd(model.slip_stiffness()) - Eigen::MatrixXd(model.stick_stiffness());
  EXPECT_DOUBLE_EQ(difference(model.tip_deflection(), model.tip_rotation()), 500.0);
  difference(model.tip_deflection(), model.tip_rotation()) = 0.0;
  EXPECT_EQ(difference.cwiseAbs().maxCoeff(), 0.0);
}

TEST(BeamModel, WithoutTheFollowerTermAFreeTipBucklesUnderADeadLoad) {
  // Euler: pi^2/4. The load error of a Hermite mesh is (pi/2 l/L)^4/720 at leading order.
  const data::Beam beam = paper_beam();
  const solver::BeamModel model(beam, 10);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigenvalues(
      Eigen::MatrixXd(model.geometric_stiffness()), Eigen::MatrixXd(model.elastic_stiffness()));
  const double factor = std::pow(beam.length(), 2) / (rigidity(beam) * eigenvalues.eigenvalues().tail(1)[0]);
  const double expected = std::pow(std::numbers::pi / 2.0, 2);
  const double predicted = expected * std::pow(std::numbers::pi / 20.0, 4) / 720.0;
  EXPECT_TRUE(within(factor, expected, discretisation(predicted, 1.1, "(pi l/2L)^4/720")));
  EXPECT_GT(factor, expected);
}

TEST(BeamModel, HeldTipBucklesAtTheClampedPinnedLoad) {
  // z^2 with z = tan z; buckling mode sin and linear, leading error of order (z l/L)^4/720.
  const data::Beam beam = paper_beam();
  const double z_squared = 20.190728556426629;
  const double factor =
      solver::stick_buckling_load(solver::BeamModel(beam, 12)) * std::pow(beam.length(), 2) / rigidity(beam);
  const double predicted = z_squared * std::pow(z_squared, 2) / std::pow(12.0, 4) / 720.0;
  EXPECT_TRUE(within(factor, z_squared, discretisation(predicted, 1.5, "(z l/L)^4/720")));
  EXPECT_GT(factor, z_squared);
}

TEST(BeamModel, InterpolationReturnsNodalValues) {
  const solver::BeamModel model(paper_beam(), 8);
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(model.degrees_of_freedom(), 1.0, 16.0);
  EXPECT_DOUBLE_EQ(model.interpolation(0.0).dot(q), 0.0);
  EXPECT_DOUBLE_EQ(model.interpolation(1.0).dot(q), q[6]);
  EXPECT_DOUBLE_EQ(model.interpolation(2.0).dot(q), q[14]);
  EXPECT_THROW((void)model.interpolation(2.1), std::invalid_argument);
  EXPECT_THROW((void)model.interpolation(-0.1), std::invalid_argument);
}

TEST(BeamModel, RefusesAForceAtOrOverTheBucklingLoadAndNamesIt) {
  const solver::BeamModel model(paper_beam_with_axial_force(90e3), 8);
  try {
    (void)model.unit_tip_deflection();
    FAIL() << "no exception";
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("beam.axial_force = 90000 N"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("buckling load, 841"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)solver::stick_modes(model, 1), std::domain_error);
  EXPECT_THROW(solver::BeamModel(paper_beam(), 0), std::invalid_argument);
}

TEST(ModalAnalysis, ModesAreOrthonormalAndSolveTheirPencil) {
  const solver::BeamModel model(paper_beam(), 10);
  const auto modes = solver::stick_modes(model, 6);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    EXPECT_EQ(modes[i].shape[model.tip_deflection()], 0.0);
    for (std::size_t j = 0; j < modes.size(); ++j)
      EXPECT_TRUE(within(modes[i].shape.dot(model.mass() * modes[j].shape), i == j ? 1.0 : 0.0,
                         round_off(20, 1e3, 1.0)));
    const double square = std::pow(modes[i].angular_frequency, 2);
    EXPECT_TRUE(within(modes[i].shape.dot(model.stick_stiffness() * modes[i].shape), square,
                       round_off(20, 1e3, square)));
  }
}

TEST(ModalAnalysis, SlipFrequenciesBeyondFlutterAreRefused) {
  const double flutter = 20.05 * rigidity(paper_beam()) / 4.0;
  EXPECT_NO_THROW(
      (void)solver::slip_modes(solver::BeamModel(paper_beam_with_axial_force(0.98 * flutter), 8), 2));
  EXPECT_THROW((void)solver::slip_modes(solver::BeamModel(paper_beam_with_axial_force(1.02 * flutter), 8), 2),
               std::domain_error);
  EXPECT_THROW((void)solver::stick_modes(solver::BeamModel(paper_beam(), 2), 4), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
