// SPDX-License-Identifier: MIT
/// The criterion over beam length and axial force, Fig. 14.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/convergence/discretisation.hpp"
#include "studies/criterion/length_force_map.hpp"
#include "support/beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

// tanh(beta L) / (beta L) - tan(betabar L) / (betabar L) at 25 Hz, written out once more.
double characteristic(double length, double axial_force) {
  const data::BeamProperties beam = flat_properties(length, axial_force);
  const double stiffness = beam.youngs_modulus * beam.second_moment_of_area;
  const double omega = 2.0 * std::numbers::pi * 25.0;
  const double root = std::sqrt(std::pow(axial_force / (2.0 * stiffness), 2) +
                                beam.density * beam.area * omega * omega / stiffness);
  const double b = length * std::sqrt(root - axial_force / (2.0 * stiffness));
  const double bb = length * std::sqrt(root + axial_force / (2.0 * stiffness));
  return std::tanh(b) / b - std::tan(bb) / bb;
}

STICKSLIP_VERIFIES(ResonanceLength, "X7");
TEST(ResonanceLength, SolvesTheCharacteristicEquation) {
  for (const int mode : {1, 2})
    for (const double force : {0.0, 5.0, 500.0, 1500.0}) {
      const auto length = studies::resonance_length(flat_beam(1.0, force), mode, 25.0);
      ASSERT_TRUE(length) << mode << ", " << force;
      // The function falls through its root; 1e-9 m is far over what the bisection leaves.
      EXPECT_GT(characteristic(*length - 1e-9, force), 0.0) << mode << ", " << force;
      EXPECT_LT(characteristic(*length + 1e-9, force), 0.0) << mode << ", " << force;
    }
}

TEST(ResonanceLength, IsNoneWhereTheBeamBucklesBefore) {
  // Mode 2 meets 25 Hz at about 1.5 m, where the section buckles at 20.19 EI/L^2 = 2.4 kN; mode 1 vibrates at
  // any frequency before it buckles.
  EXPECT_FALSE(studies::resonance_length(flat_beam(1.0, 4000.0), 2, 25.0));
  EXPECT_TRUE(studies::resonance_length(flat_beam(1.0, 4000.0), 1, 25.0));
}

STICKSLIP_VERIFIES(LengthForceMap, "X7");
TEST(LengthForceMap, HoldsTheCriterionOfEachPoint) {
  const data::Case problem = flat_case();
  const auto map = studies::length_force_map(problem, 0.4, 2.0, {50.0, 4000.0});
  ASSERT_EQ(map.lines.size(), 2u);
  for (const auto& line : map.lines) {
    EXPECT_EQ(line.length.size(), map.lines.front().length.size());
    EXPECT_EQ(line.length.front(), 0.4);
    EXPECT_TRUE(std::ranges::is_sorted(line.length));
    // Next to a resonance lengths are a tenth and less as far apart as on the average.
    for (const auto& resonance : {line.resonance_1, line.resonance_2}) {
      if (!resonance) continue;
      const auto at = std::ranges::find(line.length, *resonance);
      ASSERT_NE(at, line.length.end());
      EXPECT_LT(*(at + 1) - *(at - 1), 0.2 * 1.6 / 131.0);
    }
    // 40, 60 and 30 steps, which grow as the square of their number from a resonance on.
    const auto& lengths = line.length;
    ASSERT_EQ(lengths.size(), 131u);
    EXPECT_EQ(lengths[40], line.resonance_1.value_or(lengths[130]));
    EXPECT_EQ(lengths[100], line.resonance_2.value_or(lengths[130]));
    EXPECT_DOUBLE_EQ(lengths[20], std::lerp(lengths[40], lengths[0], 0.25));
    EXPECT_DOUBLE_EQ(lengths[55], std::lerp(lengths[40], lengths[100], 0.125));
    EXPECT_DOUBLE_EQ(lengths[85], std::lerp(lengths[100], lengths[40], 0.125));
    EXPECT_DOUBLE_EQ(lengths[115], std::lerp(lengths[100], lengths[130], 0.25));
    for (std::size_t i = 0; i < line.length.size(); i += 13) {
      const auto criterion =
          analytic::evaluate_criterion(flat_beam(line.length[i], line.axial_force), problem.friction,
                                       problem.excitation, problem.numerics.duration());
      const double ratio = criterion.force_max.midpoint() / criterion.friction_limit;
      EXPECT_TRUE(within(line.force_ratio[i], ratio, reference(1e-3 * ratio, "the stated 0.1 %")))
          << line.length[i] << " m, " << line.axial_force << " N";
    }
  }
  EXPECT_EQ(map.lines[0].length.back(), 2.0);
  const double buckling = map.lines[1].buckling_length;
  EXPECT_DOUBLE_EQ(map.lines[1].length.back(), 0.999 * buckling);
  EXPECT_TRUE(
      within(analytic::stick_buckling_load(flat_beam(buckling, 0.0)), 4000.0, round_off(10, 2, 4000.0)));
}

TEST(LengthForceMap, GivesTheForceAndTheVerdictOfFiniteElements) {
  const data::Case problem = flat_case();
  const double force = 200.0;
  const auto line = studies::length_force_map(problem, 0.4, 2.0, {force}).lines.front();
  bool stuck = false, slipped = false;
  for (const std::size_t i : {20u, 70u, 110u}) {
    const data::Beam beam = flat_beam(line.length[i], force);
    const double limit = problem.friction.static_coefficient() * force;
    const double duration = problem.numerics.duration();
    const analytic::StickResponse response(beam, problem.excitation, 60, analytic::SteadyPart::exact);
    const double converged = response.max_abs_friction_force(duration, 1e-8).midpoint();
    // Adds magnitudes; the amplitude errors it leaves out are 12/(omega T) of a phase error, 3 % in mode 1.
    const double drift =
        studies::drift_bound(beam, response.modes(), response.transient_force(), problem.numerics, duration);
    EXPECT_TRUE(within(solver::max_abs_friction_force(beam, problem.excitation, problem.numerics), converged,
                       discretisation(drift, 1.1, "phase drift of each mode")))
        << line.length[i] << " m";
    // Farther from the limit than finite elements and the ten modes of the map are from the reference.
    const bool slips = line.force_ratio[i] > 1.0;
    const double truncation = std::abs(line.force_ratio[i] * limit - converged);
    ASSERT_GT(std::abs(line.force_ratio[i] - 1.0) * limit, 1.1 * drift + truncation)
        << line.length[i] << " m";
    EXPECT_EQ(solver::first_slip(beam, problem.friction, problem.excitation, problem.numerics).has_value(),
              slips)
        << line.length[i] << " m";
    (slips ? slipped : stuck) = true;
  }
  EXPECT_TRUE(stuck && slipped);
}

}  // namespace
}  // namespace stickslip::testing
