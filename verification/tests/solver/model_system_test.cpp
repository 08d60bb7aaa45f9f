// SPDX-License-Identifier: MIT
// A structure given by its matrices, in time steps.

#include "stickslip/solver/model_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/decompositions.hpp"
#include "support/structures.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

data::Case mass_case(const data::ModelProperties& mass, const std::vector<data::Override>& overrides) {
  data::Case problem = data::load_case("hong-liu-1", overrides);
  problem.structure = data::Model(mass);
  return problem;
}

// The same matrices, assembled twice, in other orders: rounding grows with the steps.
STICKSLIP_VERIFIES(ModelSystem, "F13");
TEST(ModelSystem, OfABeamsMatricesIsTheBeam) {
  const data::Case beam = data::load_case("paper", {{"beam.axial_direction", "1"},
                                                    {"beam.axial_force", "100"},
                                                    {"damping.kelvin_voigt", "2e-4"},
                                                    {"damping.mass_proportional", "3"},
                                                    {"numerics.elements", "8"},
                                                    {"numerics.time_step", "5e-4"}});
  const data::Case model = with_matrices(with(beam, data::Damping({.mass_proportional = 3.0})),
                                         beam_matrices(beam.beam(), 8, 2e-4));
  solver::BeamSimulation one(beam), other(model);
  double largest = 0.0, difference = 0.0;
  for (int n = 0; n < 1000; ++n) {
    one.integrator().step();
    other.integrator().step();
    largest = std::max(largest, std::abs(one.friction_force()));
    difference = std::max(difference, std::abs(one.friction_force() - other.friction_force()));
  }
  EXPECT_GT(one.integrator().events().size(), 4U);
  EXPECT_EQ(one.integrator().events().size(), other.integrator().events().size());
  EXPECT_TRUE(within(difference / largest, 0.0, round_off(1000.0, 1e6, 1.0)));
}

// f = k h + c h_t while the mass is held.
TEST(ModelSystem, HoldsOneMassBySpringAndDamper) {
  const data::Case problem =
      mass_case({.mass = 2.0, .stiffness = 30.0, .damping = 4.0, .normal_force = 100.0},
                {{"excitation.amplitude", "0.1"}, {"numerics.time_step", "1e-3"}});
  solver::BeamSimulation run(problem);
  const solver::PrescribedMotion base = solver::base_motion(problem.motion);
  for (int n = 0; n < 200; ++n) {
    run.integrator().step();
    const double t = run.integrator().time(), f = 30.0 * base.displacement(t) + 4.0 * base.velocity(t);
    ASSERT_TRUE(within(run.friction_force(), f, round_off(200.0, 1.0, 10.0))) << t;
    ASSERT_EQ(run.tip_displacement(), 0.0);
  }
}

// A mass alone stops after v0/(mu N/m), v0^2/(2 mu N/m) further on; constant force and speed of the wall shift both.
TEST(ModelSystem, StopsASlidingMassWhereItDoes) {
  data::Case problem = mass_case({.mass = 2.0, .stiffness = 0.0, .damping = 0.0, .normal_force = 6.0},
                                 {{"excitation.amplitude", "0"}, {"numerics.time_step", "1e-3"}});
  problem.initial = {.position = 0.25, .velocity = 1.3};
  problem.constant_force = 1.0;
  const double deceleration = (0.5 * 6.0 - 1.0) / 2.0;
  solver::BeamSimulation run(problem);
  for (int n = 0; n < 2000; ++n) run.integrator().step();
  ASSERT_EQ(run.integrator().events().size(), 1U);
  EXPECT_TRUE(
      within(run.integrator().events().front().time, 1.3 / deceleration, round_off(2000.0, 1.0, 2.0)));
  EXPECT_TRUE(
      within(run.tip_displacement(), 0.25 + 1.3 * 1.3 / (2.0 * deceleration), round_off(2000.0, 1.0, 2.0)));
}

// |f| per metre of the base with the contact held at rest, in the rows as they are given and with f_d as the multiplier of w . y = 0.
double constrained_reaction(const data::StructureMatrices& of, double omega) {
  Eigen::MatrixXcd system = Eigen::MatrixXcd::Zero(of.rows + 1, of.rows + 1);
  for (const auto& [row, column, value] : of.mass) system(row, column) -= omega * omega * value;
  for (const auto& [row, column, value] : of.stiffness) system(row, column) += value;
  for (const auto& [row, column, value] : of.damping)
    system(row, column) += std::complex<double>(0.0, omega * value);
  for (const auto& [row, weight] : of.contact) system(of.rows, row) = system(row, of.rows) = weight;
  Eigen::VectorXcd right = Eigen::VectorXcd::Zero(of.rows + 1);
  for (const auto& [held, value] : {std::pair{of.base, 1.0}, {of.fixed, 0.0}})
    for (const int row : held) {
      system.row(row).setZero();
      system(row, row) = 1.0;
      right[row] = value;
    }
  const Eigen::PartialPivLU<Eigen::MatrixXcd> solved(system);
  return std::abs(solved.solve(right)[of.rows]);
}

TEST(ModelSystem, HasTheReactionOfItsMatrices) {
  on_random_structures(40, {.damping = 1.0}, [](const auto& matrices, RandomNumbers& numbers) {
    const double hz = numbers.log_uniform(0.5, 60.0);
    const data::Case problem = with_matrices(
        data::load_case("paper", {{"excitation.frequency_hz", data::shortest_text(hz)}}), matrices);
    const double expected = constrained_reaction(matrices, 2.0 * std::numbers::pi * hz);
    EXPECT_TRUE(within(solver::steady_reaction_of(problem), expected, round_off(1e3, 1e3, expected)));
  });
}

// The force of the held contact, run long enough for its free vibrations to decay, against the complex solution. Order 2; a maximum
// of samples misses up to (π/steps)²/2 of it.
TEST(ModelSystem, ReachesItsSteadyReaction) {
  on_random_structures(
      12, {.most_rows = 20, .damping = 5.0}, [](const auto& matrices, RandomNumbers& numbers) {
        data::Case problem = with_matrices(
            data::load_case("paper",
                            {{"excitation.frequency_hz", data::shortest_text(numbers.uniform(2.0, 10.0))},
                             {"numerics.spectral_radius", "0.8"}}),
            matrices);
        const double period = 1.0 / problem.excitation().frequency_hz();
        const double expected = problem.excitation().amplitude() * solver::steady_reaction_of(problem);
        const auto error_at = [&](double steps) {
          solver::BeamSimulation run(with_value(problem, "numerics.time_step", period / steps),
                                     {.is_bonded = true});
          double largest = 0.0;
          for (int n = 0; n < static_cast<int>(42.0 * steps); ++n) {
            run.integrator().step();
            if (n >= static_cast<int>(40.0 * steps))
              largest = std::max(largest, std::abs(run.friction_force()));
          }
          return largest / expected - 1.0;
        };
        const double coarse = std::abs(error_at(250)), fine = std::abs(error_at(500));
        EXPECT_LT(fine, 2e-3);
        EXPECT_LT(fine, 0.5 * coarse + 0.5 * std::pow(std::numbers::pi / 500.0, 2));
      });
}

TEST(ModelSystem, RefusesAStructureThatIsNotHeld) {
  data::StructureMatrices loose = beam_matrices(data::load_case("paper").beam(), 4);
  loose.fixed.clear();
  loose.base.clear();
  EXPECT_THROW((void)solver::model_matrices(*with_matrices(data::load_case("paper"), loose).model()),
               data::FieldError);
}

}  // namespace
}  // namespace stickslip::testing
