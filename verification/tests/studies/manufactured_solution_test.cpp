// SPDX-License-Identifier: MIT
/// Manufactured solutions: the finite elements and the time stepper return a motion that is no polynomial,
/// under the load and the tip force that it implies, with the orders and the constants of theory.

#include "studies/verification/manufactured_solution.hpp"
#include "support/beams.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using studies::ManufacturedTip;
using studies::PredictedErrors;

std::string tip_name(ManufacturedTip tip) {
  switch (tip) {
    case ManufacturedTip::stick:
      return "stick";
    case ManufacturedTip::slip:
      return "slip";
    default:
      return "friction";
  }
}

// Relative, on each level: what the next terms, twice the time steps and anything else may add.
std::vector<double> allowance(const std::vector<double>& next_term, double margin,
                              const std::vector<double>& temporal_share = {}, double other_share = 0.0) {
  std::vector<double> sum;
  for (std::size_t i = 0; i < next_term.size(); ++i)
    sum.push_back(margin * next_term[i] + other_share +
                  (temporal_share.empty() ? 0.0 : 2.0 * temporal_share[i]));
  return sum;
}

std::vector<OrderLevel> levels(const std::vector<double>& steps, const PredictedErrors& errors,
                               const std::vector<double>& next_terms) {
  std::vector<OrderLevel> all;
  for (std::size_t i = 0; i < steps.size(); ++i)
    all.push_back({.step = steps[i],
                   .error = errors.error.at(i),
                   .next_term = next_terms.at(i),
                   .floor = errors.floor.at(i)});
  return all;
}

// On every level the error is the predicted one, to within the relative allowance.
void expect_predicted(const PredictedErrors& errors, const std::vector<double>& allowed,
                      const std::string& what) {
  ASSERT_EQ(errors.predicted.size(), errors.error.size());
  for (std::size_t i = 0; i < errors.error.size(); ++i)
    EXPECT_TRUE(within(errors.error[i] / errors.predicted[i], 1.0,
                       discretisation(allowed[i], 1.0, "terms behind the leading one")))
        << what << ", level " << i;
}

class ManufacturedSpace : public ::testing::TestWithParam<std::tuple<ManufacturedTip, double>> {};

STICKSLIP_VERIFIES(ManufacturedSpace, "F10");
// What the elements add to the interpolant, E, is a difference of a particular and a free part, each a few
// times as large: hence four times the share of the next terms wherever it enters.
TEST_P(ManufacturedSpace, ConvergesWithThePredictedOrdersAndConstants) {
  const auto [tip, load_factor] = GetParam();
  const auto study = studies::manufactured_space_errors(paper_beam(), tip, load_factor, {4, 6, 8, 12, 16});
  const double coupling = study.friction_coupling.value_or(0.0);
  const auto deflection = allowance(study.next_term, 4.0, study.temporal_share, 0.25 * coupling);
  EXPECT_TRUE(order_is(levels(study.element_length, study.deflection, deflection), 4.0));
  expect_predicted(study.deflection, deflection, "deflection");

  auto slope = allowance(study.next_term, 4.0);
  expect_predicted(study.slope, slope, "slope");
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] += study.nodal_share_of_slope[i];
  EXPECT_TRUE(order_is(levels(study.element_length, study.slope, slope), 3.0));

  EXPECT_TRUE(order_is(levels(study.element_length, study.curvature, allowance(study.next_term, 1.0)), 2.0));
  std::vector<double> curvature;
  for (const double next : study.next_term) curvature.push_back(next * next);
  expect_predicted(study.curvature, curvature, "curvature");

  if (tip != ManufacturedTip::stick) {
    const auto tip_deflection = allowance(study.next_term, 4.0, study.temporal_share, coupling);
    EXPECT_TRUE(order_is(levels(study.element_length, study.tip_deflection, tip_deflection), 4.0));
    expect_predicted(study.tip_deflection, tip_deflection, "tip");
  }
  if (tip != ManufacturedTip::slip) {
    const auto force = allowance(study.next_term, 4.0, study.temporal_share_of_force, coupling);
    EXPECT_TRUE(order_is(levels(study.element_length, study.force, force), 4.0));
    if (tip == ManufacturedTip::stick) expect_predicted(study.force, force, "force");
    // The rounding of a third derivative grows with the cube of the number of elements, from 4 to 16 of them; that of the
    // steps, which grows less, is 8.5 % of it or less.
    EXPECT_GT(study.force.floor.back() / study.force.floor.front(), 64.0 * (1.0 - 0.085));
  }
}

INSTANTIATE_TEST_SUITE_P(AllLoads, ManufacturedSpace,
                         ::testing::Combine(::testing::Values(ManufacturedTip::stick, ManufacturedTip::slip,
                                                              ManufacturedTip::friction),
                                            ::testing::Values(-10.0, 0.0, 10.0)),
                         [](const auto& instance) {
                           return tip_name(std::get<0>(instance.param)) + "_" +
                                  parameter_name(std::get<1>(instance.param));
                         });

// 2 d w h + w T (w h)^2/24 = a h + b h^2 with the same w in a and b.
void expect_next_terms(const std::vector<double>& h, const std::vector<double>& next_term, double radius) {
  const double b = (next_term.front() / h.front() - next_term.back() / h.back()) / (h.front() - h.back());
  const double a = next_term.back() / h.back() - b * h.back(), d = (1.0 - radius) / (1.0 + radius);
  EXPECT_NEAR(radius < 1.0 ? std::pow(0.5 * a / d, 3) * 1000.0 * h.front() / 24.0 : b + a / h.front(), b,
              1e-9 * b);
}

class ManufacturedTime : public ::testing::TestWithParam<std::tuple<ManufacturedTip, double, double>> {};

STICKSLIP_VERIFIES(ManufacturedTime, "F10");
TEST_P(ManufacturedTime, IsOfOrderTwoWithThePredictedConstant) {
  const auto [tip, load_factor, radius] = GetParam();
  const auto study =
      studies::manufactured_time_errors(paper_beam(), tip, load_factor, radius, {1000, 2000, 4000, 8000});
  const auto& all_modes = study.next_term_of_all_modes;
  expect_next_terms(study.time_step, study.next_term, radius);
  expect_next_terms(study.time_step, all_modes, radius);
  EXPECT_EQ(study.displacement.order.order,
            studies::observed_order(study.time_step, study.displacement.error));
  if (tip == ManufacturedTip::friction) {
    EXPECT_TRUE(order_is(levels(study.time_step, study.displacement, all_modes), 2.0));
    // At a spectral radius of 0 the leading terms of velocity and force nearly vanish here.
    if (radius == 0.0) return;
    EXPECT_TRUE(order_is(levels(study.time_step, study.velocity, all_modes), 2.0));
    EXPECT_TRUE(order_is(levels(study.time_step, study.force, all_modes), 2.0));
    return;
  }
  EXPECT_TRUE(order_is(levels(study.time_step, study.displacement, study.next_term), 2.0));
  expect_predicted(study.displacement, study.next_term, "displacement");
  EXPECT_TRUE(order_is(levels(study.time_step, study.velocity, all_modes), 2.0));
  if (tip != ManufacturedTip::stick) return;
  // All modes count in the force. A mode's leading term has the factor cos(w T) - cos(omega T), which may be
  // small where the slope of cos(w T), by which the phase drifts, is not.
  const auto force = allowance(all_modes, 3.0);
  EXPECT_TRUE(order_is(levels(study.time_step, study.force, force), 2.0));
  expect_predicted(study.force, force, "force");
}

INSTANTIATE_TEST_SUITE_P(AllRadii, ManufacturedTime,
                         ::testing::Combine(::testing::Values(ManufacturedTip::stick, ManufacturedTip::slip,
                                                              ManufacturedTip::friction),
                                            ::testing::Values(-10.0, 10.0), ::testing::Values(0.0, 0.9, 1.0)),
                         [](const auto& instance) {
                           return tip_name(std::get<0>(instance.param)) + "_" +
                                  parameter_name(std::get<1>(instance.param)) + "_radius_" +
                                  parameter_name(std::get<2>(instance.param));
                         });

}  // namespace
}  // namespace stickslip::testing
