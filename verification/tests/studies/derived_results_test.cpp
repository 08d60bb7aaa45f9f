// SPDX-License-Identifier: MIT
/// Numbers that follow from the results of studies. The results here differ from each other, so that one taken for another
/// shows.

#include "stickslip/data/paper.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/classification.hpp"
#include "studies/verification/contact_histories.hpp"
#include "studies/verification/damped_benchmark.hpp"
#include "studies/verification/energy_audit.hpp"
#include "studies/verification/force_maximum.hpp"
#include "studies/verification/frequencies.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(DerivedResults, "U5");
TEST(DerivedResults, DifferencesOfForceMaxima) {
  const double printed = data::printed_number("force_max.15").value;
  const studies::ForceMaximumStudy row{.frequency_hz = 15.0,
                                       .sampled = 1.01 * printed,
                                       .truncated = {1.01 * printed, 1.03 * printed},
                                       .converged = {1.04 * printed, 1.06 * printed},
                                       .finite_element = 1.10 * printed,
                                       .predicted_finite_element = 1.15 * printed};
  // To the rounding of a quotient near 1.
  EXPECT_NEAR(row.sampling_difference(), 1.0 - 1.01 / 1.02, 1e-15);
  EXPECT_NEAR(row.truncation_difference(), 1.0 - 1.02 / 1.05, 1e-15);
  EXPECT_NEAR(row.discretisation_difference(), 1.10 / 1.05 - 1.0, 1e-15);
  EXPECT_NEAR(row.prediction_difference(), 1.0 - 1.10 / 1.15, 1e-15);
  EXPECT_NEAR(row.printed_difference(), 0.01, 1e-15);
}

TEST(DerivedResults, QuantilesOfAmplitudeRatios) {
  std::vector<studies::CriticalAmplitudePoint> reference, curve;
  for (int i = 1; i <= 21; ++i) {
    reference.push_back({1.0, 2.0});
    curve.push_back({0.7, 2.0 * (22 - i)});
  }
  const auto ratio = studies::amplitude_ratio(curve, reference);
  EXPECT_EQ(ratio.median, 11.0);
  EXPECT_EQ(ratio.low_tenth, 3.0);
  EXPECT_EQ(ratio.high_tenth, 19.0);
}

TEST(DerivedResults, WhatASearchOrAPanelHasOrHasNot) {
  const auto errors = studies::FlutterStudy{20.0, {4, 8}, {21.0, 19.0}, {}}.relative_error();
  EXPECT_TRUE(within(errors.at(0), 0.05, round_off(2, 1, 1)));
  EXPECT_TRUE(within(errors.at(1), -0.05, round_off(2, 1, 1)));
  studies::CriticalAmplitudeSearch search;
  search.cap = 1e-3;
  EXPECT_TRUE(search.above_the_cap());
  EXPECT_EQ(search.searched_amplitude(), 1e-3);
  search.searched = 2e-4;
  EXPECT_FALSE(search.above_the_cap());
  EXPECT_EQ(search.searched_amplitude(), 2e-4);
  for (const bool stepped : {false, true})
    for (const bool criterion : {false, true})
      for (const bool printed : {false, true}) {
        studies::ContactHistory panel;
        if (stepped) panel.finite_element_slip = 0.5;
        panel.criterion_slips = criterion;
        panel.printed_slips = printed;
        EXPECT_EQ(panel.verdicts_agree(), stepped == criterion && criterion == printed);
        EXPECT_FALSE(panel.first_slip_difference());
        panel.closed_form_slip = 0.625;
        EXPECT_EQ(panel.first_slip_difference(), stepped ? std::optional(0.125) : std::nullopt);
      }
  studies::DampedBenchmark benchmark;
  for (const auto& [size, step] : {std::pair{40, 2e-5}, {40, 1e-5}, {20, 1e-6}, {80, 0.0}}) {
    benchmark.runs.emplace_back();
    benchmark.runs.back().size = size;
    benchmark.runs.back().time_step = step;
  }
  EXPECT_EQ(benchmark.finest_stepped().time_step, 1e-5);
  std::ranges::reverse(benchmark.runs);
  EXPECT_EQ(benchmark.finest_stepped().time_step, 1e-5);
}

TEST(DerivedResults, UnexplainedShareOfEnergy) {
  studies::EnergyAudit audit;
  audit.event_driven = {.kinetic = 7.0,
                        .potential = 2.0,
                        .base_work = 4.0,
                        .follower_work = 8.0,
                        .damping_loss = 0.5,
                        .friction_loss = 3.5};
  audit.event_driven_initial = 3.0;
  EXPECT_EQ(audit.event_driven_change(), 6.0);
  EXPECT_EQ(audit.event_driven_residual(), -2.0);
  EXPECT_EQ(audit.event_driven_unexplained(), 0.5);  // whatever its sign
  const solver::EnergyBalance fine{.kinetic = 5.0,
                                   .elastic = 6.0,
                                   .base_work = 16.0,
                                   .follower_work = -4.0,
                                   .damping_loss = 1.5,
                                   .friction_loss = 2.5,
                                   .capture_loss = 0.25,
                                   .initial_energy = 1.0};
  solver::EnergyBalance coarse = fine;
  coarse.initial_energy = -1.0;
  studies::EnergyAudit::Mesh mesh{.elements = 10, .stepped = {coarse, fine}, .observed_order = {}};
  EXPECT_EQ(fine.change(), 10.0);
  EXPECT_EQ(mesh.residual(), (std::vector{4.25, 2.25}));
  EXPECT_EQ(mesh.base_work(), (std::vector{16.0, 16.0}));
  EXPECT_EQ(mesh.largest_unexplained(), 4.25 / 16.0);  // with any of the steps
  mesh.stepped[1].kinetic = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(mesh.largest_unexplained()));
}

STICKSLIP_VERIFIES(FrictionCurve, "P2");
TEST(FrictionCurve, OpposesTheSlidingVelocity) {
  const auto& law = paper().contact.friction;
  const double normal_force = paper().beam().axial_force();
  std::vector<double> at_rest;
  for (const auto& point : studies::friction_curve(law, normal_force)) {
    const double expected =
        law.kinetic_coefficient() + (law.static_coefficient() - law.kinetic_coefficient()) *
                                        std::exp(-law.decay() * std::abs(point.sliding_velocity));
    EXPECT_DOUBLE_EQ(point.coefficient, expected);
    EXPECT_DOUBLE_EQ(std::abs(point.friction_force), expected * normal_force);
    EXPECT_LE(point.friction_force * point.sliding_velocity, 0.0) << point.sliding_velocity;
    if (point.sliding_velocity == 0.0) at_rest.push_back(point.friction_force);
  }
  EXPECT_EQ(at_rest, (std::vector{300.0, -300.0}));
}

STICKSLIP_VERIFIES(ForceSurface, "A6");
TEST(ForceSurface, HoldsTheForceMaximaOfItsPoints) {
  std::vector<double> hz;
  for (int quarter = 4 * 20; quarter <= 4 * 35; ++quarter) hz.push_back(0.25 * quarter);
  const double natural = 24.97;
  const auto surface = studies::force_surface(studies::friction_limit(paper()),
                                              studies::critical_amplitude_curve(paper(), hz), {natural});
  // Every hertz, and the 12 quarters between 23 and 26.97 Hz.
  EXPECT_EQ(surface.size(), 16U + 12U);
  for (const double at : {25.0, 35.0}) {
    const auto line = std::ranges::find(surface, at, &studies::ForceLine::frequency_hz);
    ASSERT_NE(line, surface.end());
    EXPECT_DOUBLE_EQ(line->amplitude[9], 0.5e-3);
    const auto study = studies::force_maximum_study(with(paper(), shaking(at, 0.5e-3)));
    EXPECT_NEAR(line->force_max[9] / study.truncated.midpoint(), 1.0, 1e-4);  // two searches of one maximum
  }
}

}  // namespace
}  // namespace stickslip::testing
