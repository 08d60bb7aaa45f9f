/// Observed orders in the mesh, with their constants.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/studies/convergence.hpp"
#include "stickslip/studies/frequencies.hpp"
#include "support/beams.hpp"
#include "support/order.hpp"
#include "support/parameter_name.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

const std::vector<int> meshes{8, 12, 16, 24, 32, 48};

// The orders of a frequency against 4. The term behind (beta l)^4/720 is about (beta l)^2/40 relative between
// supports; where the tip is free, u'''' does not vanish and raises it by about 10/(beta L) of itself: by 3.3
// in the second mode, which is the largest that matters (in the first all of it is small).
void expect_order_four(const studies::FrequencyStudy& study, double first_wave_number, double margin) {
  for (const auto& mode : study.modes) {
    const double beta_length = first_wave_number + (mode.mode - 1) * std::numbers::pi;
    std::vector<double> lengths, next_terms;
    for (std::size_t i = 0; i < study.elements.size(); ++i) {
      lengths.push_back(1.0 / study.elements[i]);
      // The eigenvalue solver's round-off, omega_max^2/omega^2 eps, is 1e-11 of omega^2 at worst.
      next_terms.push_back(margin * std::pow(beta_length * lengths[i], 2) / 40.0 +
                           1e-11 / std::abs(mode.predicted_error[i]));
    }
    EXPECT_TRUE(order_is(mode.observed_order, 4.0, lengths, next_terms)) << "mode " << mode.mode;
  }
}

class StickFrequencyOrder : public ::testing::TestWithParam<double> {};

TEST_P(StickFrequencyOrder, IsFourWithThePredictedConstant) {
  // The constant by the next term: 2 % for mode 5 on 48 elements at most.
  const double unit = 16666.666666666668 / 4.0;  // EI/L^2
  const auto study =
      studies::stick_frequency_study(paper_beam_with_axial_force(GetParam() * unit), 5, meshes);
  // An axial force of half the buckling load shortens the waves of mode 1, trigonometric ones, by a fifth.
  expect_order_four(study, 1.25 * std::numbers::pi, GetParam() > 1.0 ? 3.0 : 1.1);
  for (const auto& mode : study.modes) {
    EXPECT_NEAR(mode.leading_constant_ratio, 1.0, 0.02) << "mode " << mode.mode;
    for (const double error : mode.relative_error)
      EXPECT_GT(error, 0.0) << "a Rayleigh quotient is an upper bound";
  }
}

INSTANTIATE_TEST_SUITE_P(AxialForce, StickFrequencyOrder, ::testing::Values(-5.0, 0.0, 0.12, 10.0),
                         NameOfDouble());

TEST(StickFrequencyOrder, ConstantWithoutAxialForceIsBetaLToTheFourthOver720) {
  const data::Beam beam = paper_beam_with_axial_force(0.0);
  const auto study = studies::stick_frequency_study(beam, 3, {12, 24});
  const double roots[] = {3.926602312047919, 7.068582745628732, 10.210176122813031};
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = std::pow(roots[i] / 24.0, 4) / 720.0;
    EXPECT_TRUE(within(study.modes[i].predicted_error.back(), expected,
                       reference(1e-8 * expected, "Simpson's rule")));
    // Next term about (beta l)^2/40 relative.
    EXPECT_TRUE(within(study.modes[i].relative_error.back(), expected,
                       discretisation(expected * std::pow(roots[i] / 24.0, 2) / 40.0, 2.0, "(beta l)^2/40")));
  }
}

TEST(SlipFrequencyOrder, IsFourUnderTheFollowerLoad) {
  // The constant is that of P = 0: at P L^2/EI = 0.12 it is off by 0.12/beta^2, 3.4 % in the first mode.
  const auto study = studies::slip_frequency_study(paper_beam(), 5, meshes);
  expect_order_four(study, 0.6 * std::numbers::pi, 4.0);
  for (const auto& mode : study.modes) {
    EXPECT_NEAR(mode.leading_constant_ratio, 1.0, 0.035) << "mode " << mode.mode;
  }
}

TEST(FlutterLoadOrder, IsFourAndTendsToBecksLoad) {
  const auto study = studies::flutter_study(paper_beam(), {4, 6, 8, 12, 16});
  // Where the modes meet, omega = 11.0 sqrt(EI/rho A)/L^2 and beta_bar L = 5.0 (Eq. 23); margin of a free
  // tip.
  std::vector<double> lengths, next_terms;
  for (const int elements : study.elements) {
    lengths.push_back(1.0 / elements);
    next_terms.push_back(4.0 * std::pow(5.0 / elements, 2) / 40.0);
  }
  EXPECT_TRUE(order_is(study.observed_order, 4.0, lengths, next_terms));
  EXPECT_TRUE(within(study.closed_form, 20.05, reference(5e-3, "Beck's load as usually printed")));
  const double extrapolated =
      study.finite_element[4] + (study.finite_element[4] - study.finite_element[2]) / 15.0;
  EXPECT_TRUE(within(
      extrapolated, study.closed_form,
      discretisation((study.finite_element[2] - study.closed_form) / 15.0, 0.2, "extrapolation of order 4")));
}

// Steady vibration of the semi-discrete stick state at the excitation frequency, tip prescribed, amplitude 1
// of the base.
Eigen::VectorXd steady_state(const solver::BeamModel& model, double omega) {
  const Eigen::Index tip = model.tip_deflection();
  Eigen::MatrixXd dynamic =
      Eigen::MatrixXd(model.stick_stiffness()) - omega * omega * Eigen::MatrixXd(model.mass());
  Eigen::VectorXd right_side = omega * omega * model.base_load() + dynamic.col(tip);
  dynamic.row(tip).setZero();
  dynamic.col(tip).setZero();
  dynamic(tip, tip) = 1.0;
  right_side[tip] = -1.0;
  return dynamic.partialPivLu().solve(right_side);
}

// f = -f_d by the balance of the tip's row, including the follower term.
double reaction_by_residual(const solver::BeamModel& model, const Eigen::VectorXd& q, double omega) {
  const Eigen::VectorXd balance =
      model.slip_stiffness() * q - omega * omega * (model.mass() * q + model.base_load());
  return -balance[model.tip_deflection()];
}

// f = EI u''' from the shape functions of the last element, in which it is constant.
double reaction_by_shape_functions(const solver::BeamModel& model, const Eigen::VectorXd& q) {
  const double l = model.beam().length() / model.elements();
  const double rigidity = model.beam().youngs_modulus() * model.beam().second_moment_of_area();
  const Eigen::Vector4d third(12.0, 6.0 * l, -12.0, 6.0 * l);
  return rigidity / (l * l * l) * third.dot(q.tail<4>());
}

// EI u''' of the last element is its value in the middle, half an element off the tip. That would be of order
// one, were the next derivative not zero there: EI u''''(L) = -rho A y_tt(L) - P u''(L), and a stuck tip
// neither accelerates nor bends.
TEST(ReactionOrder, IsFourByTheResidualAndTwoByTheShapeFunctions) {
  for (const double hz : {15.0, 35.0, 70.0}) {
    const double omega = 2.0 * std::numbers::pi * hz;
    const double exact = analytic::StickResponse(paper_beam(), data::HarmonicExcitation({hz, 1.0}), 10,
                                                 analytic::SteadyPart::exact)
                             .steady_force_amplitude();
    std::vector<double> lengths, residual_errors, shape_errors;
    for (const int elements : {8, 12, 16, 24, 32, 48}) {
      const solver::BeamModel model(paper_beam(), elements);
      const Eigen::VectorXd q = steady_state(model, omega);
      lengths.push_back(2.0 / elements);
      residual_errors.push_back(std::abs(reaction_by_residual(model, q, omega) - exact));
      shape_errors.push_back(std::abs(reaction_by_shape_functions(model, q) - exact));
    }
    EXPECT_TRUE(within(studies::observed_order(lengths, residual_errors), 4.0, next_terms(0.1)))
        << hz << " Hz";
    EXPECT_LT(residual_errors.back(), 1e-5 * std::abs(exact));
    EXPECT_TRUE(within(studies::observed_order(lengths, shape_errors), 2.0, next_terms(0.1))) << hz << " Hz";
  }
}

TEST(StaticShapeOrder, IsFourAgainstTheClosedForm) {
  // At half the buckling load the shape is no cubic: the mesh must converge to S(x).
  const data::Beam beam = paper_beam_with_axial_force(42e3);
  const analytic::QuasiStaticShape shape(beam);
  std::vector<double> lengths, errors;
  for (const int elements : {4, 8, 16, 32}) {
    const solver::BeamModel model(beam, elements);
    const Eigen::VectorXd q = model.unit_tip_deflection();
    double error = 0.0;
    for (int i = 1; i < 40; ++i)
      error = std::max(error, std::abs(model.interpolation(0.05 * i).dot(q) + shape.value(0.05 * i)));
    lengths.push_back(2.0 / elements);
    errors.push_back(error);
  }
  EXPECT_TRUE(within(studies::observed_order(lengths, errors), 4.0, next_terms(0.1)));
}

}  // namespace
}  // namespace stickslip::testing
