// SPDX-License-Identifier: MIT
/// The discretisation uncertainties of the paper's results, against errors that the closed form knows.

#include "studies/verification/solution_verification.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using studies::grid_convergence;
using studies::GridConvergence;

STICKSLIP_VERIFIES(GridConvergenceIndex, "X16");
TEST(GridConvergenceIndex, IsExactForAPowerLaw) {
  for (const double ratio : {1.5, 2.0, 3.0}) {
    for (const double order : {1.0, 2.0, 4.0}) {
      for (const double error : {0.3, -0.02}) {
        std::vector<double> values;
        for (int k = 0; k < 3; ++k) values.push_back(7.0 + error * std::pow(ratio, -order * k));
        const GridConvergence result = grid_convergence(values, ratio, order);
        // The finer difference is no less than 1/(3^4) of error, and cancels from 7.
        const double condition = 7.0 / std::abs(error) * std::pow(ratio, order);
        ASSERT_TRUE(result.asymptotic && result.observed_order);
        EXPECT_TRUE(within(*result.observed_order, order, round_off(10, condition, order)));
        EXPECT_TRUE(within(result.extrapolated, 7.0, round_off(20, condition, std::abs(error))));
        EXPECT_EQ(result.safety_factor, 1.25);
        EXPECT_TRUE(within(result.index, 1.25 * std::abs(error), round_off(20, condition, error)));
      }
    }
  }
}

// Formal order 2 at ratio 2: r^p/(r^p - 1) = 4/3 of the last difference. Differences that change sign, that grow, and that have
// the order 4, with the order found, or 0.
TEST(GridConvergenceIndex, TreblesIfNotAsymptotic) {
  struct Row {
    std::vector<double> values;
    double largest, order;
  };
  for (const auto& [values, largest, order] :
       {Row{{1.0, 1.3, 0.9}, 0.3, 0.0}, {{1.0, 1.1, 0.6}, 0.4, 0.0}, {{16.0, 1.0, 0.0625}, 15.9375, 4.0}}) {
    const GridConvergence result = grid_convergence(values, 2.0, 2.0);
    EXPECT_FALSE(result.asymptotic);
    EXPECT_TRUE(within(result.observed_order.value_or(0.0), order, round_off(10, 1, 4)));
    EXPECT_TRUE(within(result.index, 3.0 * largest * 4.0 / 3.0, round_off(10, 10, largest)));
    EXPECT_TRUE(within(result.extrapolated, values[2] + (values[2] - values[1]) / 3.0, round_off(10, 10, 1)));
    EXPECT_EQ(result.safety_factor, 3.0);
  }
  // A tenth of the order on either side: values 2^(-p k) have the order p.
  for (const double order : {1.0, 1.78, 1.82, 2.18, 2.22})
    EXPECT_EQ(grid_convergence({1.0, std::pow(2.0, -order), std::pow(4.0, -order)}, 2.0, 2.0).asymptotic,
              std::abs(order - 2.0) < 0.2)
        << order;
  EXPECT_EQ(grid_convergence({2.0, 2.0, 2.0}, 2.0, 2.0).index, 0.0);
}

TEST(GridConvergenceIndex, RefusesWhatItCannotUse) {
  EXPECT_THROW((void)grid_convergence({1.0, 2.0}, 2.0, 2.0), std::invalid_argument);
  EXPECT_THROW((void)grid_convergence({1.0, 2.0, 3.0}, 1.0, 2.0), std::invalid_argument);
  EXPECT_THROW((void)grid_convergence({1.0, 2.0, 3.0}, 2.0, 0.0), std::invalid_argument);
}

const studies::SolutionVerification& study() {
  static const studies::SolutionVerification result =
      studies::solution_verification(data::load_case("paper"));
  return result;
}

const studies::VerifiedResult& result(const std::string& id) {
  const auto& results = study().results;
  const auto found = std::ranges::find(results, id, &studies::VerifiedResult::id);
  if (found == results.end()) throw std::runtime_error("no result " + id);
  return *found;
}

void uncertainties_cover_the_true_errors() {
  ASSERT_EQ(study().results.size(), 23u);
  for (const auto& r : study().results) {
    ASSERT_EQ(r.levels.size(), 3u);
    EXPECT_EQ(r.true_error, r.levels.front().value - r.reference);
    EXPECT_LE(std::abs(r.true_error), r.uncertainty) << r.quantity << ", " << r.obtained;
    if (r.convergence.asymptotic) {
      EXPECT_TRUE(r.covered) << r.quantity;
      EXPECT_EQ(r.obtained, "grid convergence index");
      EXPECT_EQ(r.uncertainty, r.convergence.index);
      EXPECT_LE(std::abs(r.levels.back().value - r.reference), 0.1 * std::abs(r.true_error))
          << r.quantity << ": (1/1.5)^8 = 0.04 of the error should be left";
    }
  }
}

void frequencies_and_their_lengths_are_asymptotic_of_order_four() {
  // The next term, c = (beta l)^2/40 of the first on the coarsest mesh, moves the order of three levels by
  // -c (1 - r^-2)(1 - r^-6)/((1 - r^-4) ln r) = -1.56 c. Of the error l^4 leaves 1/(1 + c) after 1.25.
  const auto check = [](const std::string& id, int mode) {
    const auto& r = result(id);
    const double next_term = std::pow((mode + 0.25) * 3.14159 / r.levels.front().elements, 2) / 40.0;
    ASSERT_TRUE(r.convergence.asymptotic) << id;
    EXPECT_TRUE(within(*r.convergence.observed_order, 4.0 - 1.56 * next_term,
                       discretisation(1.56 * next_term, 0.5, "the terms behind (beta l)^2/40")))
        << id;
    EXPECT_TRUE(within(r.convergence.index, 1.25 * std::abs(r.true_error),
                       discretisation(1.25 * r.true_error * next_term, 1.0, "the next term")))
        << id;
    EXPECT_TRUE(within(r.convergence.extrapolated, r.reference,
                       discretisation(r.true_error * next_term, 1.0, "the next term")))
        << id;
  };
  for (int mode = 1; mode <= 3; ++mode) {
    check("frequency.stick." + std::to_string(mode), mode);
    check("frequency.stick." + std::to_string(mode) + ".half_stiffness", mode);
    if (mode < 3) check("figure14.length." + std::to_string(mode), mode);
  }
}

// All modes, at any time, with what the omitted ones can add.
void the_value_of_a_force_and_its_uncertainty_hold_the_enclosed_one() {
  const data::Case paper = data::load_case("paper");
  for (const double hz : {15.0, 25.0, 35.0, 70.0}) {
    const analytic::StickResponse response(
        paper.beam(), data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.5e-3}), 100,
        analytic::SteadyPart::exact);
    const analytic::Bounds exact = response.max_abs_friction_force(paper.numerics.duration());
    const double omitted = response.omitted_transient_bound();
    const auto& r = result("force_max." + std::to_string(std::lround(hz)));
    EXPECT_LE(r.levels.front().value - r.uncertainty, exact.lower - omitted) << hz;
    EXPECT_GE(r.levels.front().value + r.uncertainty, exact.upper + omitted) << hz;
  }
}

void printed_results_are_those_of_the_paper() {
  EXPECT_EQ(result("force_max.70").printed.value(), 977.54);
  EXPECT_EQ(result("frequency.stick.3.half_stiffness").printed.value(), 119.6);
  EXPECT_EQ(result("figure14.length.2").printed.value(), 1.58);
  EXPECT_FALSE(result("figure9.force_peak").printed);
  EXPECT_EQ(result("frequency.stick.1").levels.front().time_step, 0.0);
  EXPECT_EQ(result("force_max.15").levels.front().time_step, 1e-4);
  EXPECT_EQ(result("force_max.15").levels[2].elements, 45);
  EXPECT_DOUBLE_EQ(result("force_max.15").levels[2].time_step, 1e-4 / std::pow(1.5, 4));
}

// 60 modes make the times of slip, found to 1e-9 s: the force changes by 1e-3 N. mu_s P A_0 is 0.15 N m.
void references_are_those_of_their_figures() {
  const data::Case paper = data::load_case("paper");
  for (const auto& [id, hz, amplitude] : {std::tuple{"figure4b.first_slip", 25.0, 0.5e-3},
                                          {"figure4d.first_slip", 70.0, 0.5e-3},
                                          {"figure5b.first_slip", 25.0, 1e-3},
                                          {"figure5c.first_slip", 35.0, 1e-3},
                                          {"figure5d.first_slip", 70.0, 1e-3}})
    EXPECT_TRUE(within(std::abs(analytic::StickResponse(paper.beam(), shaking(hz, amplitude), 60,
                                                        analytic::SteadyPart::exact)
                                    .friction_force(result(id).reference)),
                       300.0, discretisation(1e-3, 10.0, "the force of the times")));
  EXPECT_DOUBLE_EQ(result("figure6.minimum.amplitude").reference * result("force_max.25").reference, 0.15);
}

STICKSLIP_VERIFIES(SolutionVerification, "X16");
// One test, for every test is a process of its own and the study takes seconds.
TEST(SolutionVerification, CoversTheTrueErrors) {
  uncertainties_cover_the_true_errors();
  frequencies_and_their_lengths_are_asymptotic_of_order_four();
  the_value_of_a_force_and_its_uncertainty_hold_the_enclosed_one();
  printed_results_are_those_of_the_paper();
  references_are_those_of_their_figures();
}

}  // namespace
}  // namespace stickslip::testing
