// SPDX-License-Identifier: MIT
/// Histories of the beam by boundary integral, free modes, events and time steps, against each other and against closed forms.

#include <Eigen/Dense>

#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/reference.hpp"
#include "studies/common/convergence.hpp"
#include "studies/history/history_convergence.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/finite_element_contact_model.hpp"
#include "support/contact_models.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::BeamBoundaryIntegral;
using analytic::TimeGrid;

STICKSLIP_VERIFIES(BeamBoundaryIntegral, "D4");
TEST(BeamBoundaryIntegral, HoldsTheTipInResonance) {
  // Means over steps are f at their middles times 1 - (Omega h)^2/24, and (omega_n h)^2/24 for the n-th mode.
  const double first = analytic::stick_modes(paper_beam(), 1).front().frequency_hz();
  const TimeGrid grid{1e-5, 5000};
  for (const double hz : {first, first * (1.0 + 1e-10), first * 1.0005, 25.0, 35.0}) {
    const analytic::StickResponse response(paper_beam(), excitation(hz, 1e-3), 200,
                                           analytic::SteadyPart::exact);
    const auto held = analytic::holding_force(paper_beam(), excitation(hz, 1e-3), {}, grid);
    double step = 0.0;  // sum of |a_n| (omega_n h)^2/24
    for (const auto& [amplitude, omega] : response.transient_force())
      if (omega > 1.001 * 2.0 * 3.14159 * hz || omega < 0.999 * 2.0 * 3.14159 * hz)
        step += std::abs(amplitude) * std::pow(omega * grid.time_step, 2) / 24.0;
    const double scale = largest(held);
    step += scale * std::pow(2.0 * 3.14159 * hz * grid.time_step, 2) / 24.0;
    for (std::size_t n = 0; n < held.size(); n += 37)
      ASSERT_TRUE(within(held[n], -response.friction_force((static_cast<double>(n) + 0.5) * grid.time_step),
                         discretisation(step + 1e-12 * scale, 1.0, "mean over a step, and round-off")))
          << hz << ", " << n;
  }
}

TEST(BeamBoundaryIntegral, TipIsTheSumOfSliding) {
  // The motion of the beam at x by the transfer mobility; at the tip it is the integral of the sliding
  // velocities, to the accuracy of the weights times the number of steps.
  const BeamBoundaryIntegral beam(paper_problem(25.0, 1e-3), {2.5e-6, 40000});
  const auto tip = beam.tip_displacement(400);
  EXPECT_TRUE(within(studies::largest_difference(tip, beam.displacement(2.0, 400)), 0.0,
                     reference(1e-7 * largest(tip), "weights, summed")));
}

TEST(BeamBoundaryIntegral, RefusesTension) {
  const auto run = [](const data::Beam& beam, const data::Damping& damping, const TimeGrid& grid) {
    return BeamBoundaryIntegral(with(paper_problem(25.0, 1e-3), beam, damping), grid);
  };
  const data::Damping modal({.ratio = 0.01});
  EXPECT_THROW(run(paper_beam_with_axial_force(-500.0), {}, {1e-5, 10}), data::InputError);
  EXPECT_THROW(run(paper_beam(), modal, {1e-5, 10}), std::invalid_argument);
  for (const TimeGrid grid : {TimeGrid{1e-5, 0}, {0.0, 10}})
    EXPECT_THROW(run(paper_beam(), {}, grid), std::invalid_argument);
  EXPECT_THROW((void)analytic::holding_force(paper_beam(), excitation(25.0, 1e-3), modal, {1e-5, 10}),
               data::FieldError);
  EXPECT_THROW(
      (void)analytic::held_displacement(paper_beam(), excitation(25.0, 1e-3), modal, {1e-5, 10}, 1.0, 1),
      data::FieldError);
}

STICKSLIP_VERIFIES(ConvergedHistory, "D4");
TEST(ConvergedHistory, CoversFinerSteps) {
  // 0.1 s at 25 Hz, 1 mm. A run on a quarter of the step must lie within the half-widths, tip and midspan,
  // and so must the sticks that both find; each level halves the step.
  const data::Case problem = paper_problem(25.0, 1e-3);
  const auto history_with = [&](int steps_per_sample, int levels) {
    return studies::converged_history(
        problem, {.duration = 0.1, .samples = 100, .steps_per_sample = steps_per_sample, .levels = levels});
  };
  const auto history = history_with(128, 4), finer = history_with(512, 2);
  ASSERT_EQ(history.tip.size(), 101u);
  const auto expect_covered = [&](auto values, auto widths) {
    const std::vector<double>&width = history.*widths, &value = history.*values;
    for (std::size_t i = 0; i < value.size(); ++i)
      ASSERT_TRUE(within(value[i], (finer.*values)[i], reference(width[i], "half-width"))) << i;
    EXPECT_TRUE(std::ranges::is_sorted(width));
    EXPECT_LT((finer.*widths).back(), 0.5 * width.back());
  };
  using studies::ConvergedHistory;
  expect_covered(&ConvergedHistory::tip, &ConvergedHistory::tip_half_width);
  expect_covered(&ConvergedHistory::midspan, &ConvergedHistory::midspan_half_width);
  ASSERT_EQ(history.levels.size(), 8u);
  EXPECT_DOUBLE_EQ(history.levels[0].time_step, 1e-3 / 128.0);
  EXPECT_EQ(history.levels[4].time_step, history.levels[1].time_step);
  for (std::size_t level = 1; level < 8; ++level) {
    const auto& each = history.levels[level];
    EXPECT_EQ(each.method, level < 4 ? "boundary integral" : "free modes");
    EXPECT_EQ(each.modes, level < 4 ? 0 : studies::free_modes_for(problem.beam(), each.time_step));
    if (level == 4) continue;
    EXPECT_EQ(each.time_step, 2.0 * history.levels[level - 1].time_step);
    EXPECT_TRUE(level % 4 < 3 || each.error > history.levels[level - 2].error);
  }
  EXPECT_DOUBLE_EQ(history.largest_half_width(),
                   2.0 * std::max(history.levels[1].error, history.levels[4].error));
  EXPECT_EQ(history.first_stick.begin_half_width, history.levels[0].time_step);
  EXPECT_TRUE(within(history.first_stick.end, finer.first_stick.end,
                     reference(history.first_stick.end_half_width, "half-width")));
  ASSERT_GE(history.sticks.size(), 2u);
  EXPECT_GE(history.levels[0].changes, 1 + 2 * static_cast<int>(history.sticks.size()));
  for (const auto& stick : history.sticks) {
    EXPECT_GE(stick.end - stick.begin, 1e-3);
    EXPECT_GE(std::min(stick.begin_half_width, stick.end_half_width), history.levels[0].time_step);
    const auto same = std::ranges::find_if(finer.sticks, [&](const auto& other) {
      return other.begin < 0.5 * (stick.begin + stick.end) && other.end > 0.5 * (stick.begin + stick.end);
    });
    ASSERT_NE(same, finer.sticks.end()) << stick.begin;
    EXPECT_TRUE(within(stick.begin, same->begin, reference(stick.begin_half_width, "half-width")));
    EXPECT_TRUE(within(stick.end, same->end, reference(stick.end_half_width, "half-width")));
    EXPECT_TRUE(within(stick.position, same->position, reference(stick.position_half_width, "half-width")));
  }
}

TEST(ConvergedHistory, OfAHeldTipIsOneStick) {
  const auto history = studies::converged_history(
      paper_problem(25.0, 1e-5), {.duration = 0.01, .samples = 10, .steps_per_sample = 32, .levels = 2});
  EXPECT_EQ(history.first_stick.begin, 0.0);
  EXPECT_DOUBLE_EQ(history.first_stick.end, 0.01);
  EXPECT_NEAR(history.first_stick.end_half_width, 0.01 / 320.0, 1e-16);
  EXPECT_TRUE(history.sticks.empty());
  EXPECT_EQ(history.levels.size(), 4u);  // two of each method
  for (const auto& level : history.levels) EXPECT_EQ(level.changes, 0);
}

TEST(ConvergedHistory, TakesModesOfAStep) {
  for (const auto& [step, least, most] : {std::tuple{1.0, 20, 20}, {2e-5, 100, 103}, {1e-12, 1000, 1000}}) {
    const int modes = studies::free_modes_for(paper_beam(), step);
    EXPECT_GE(modes, least);
    EXPECT_LE(modes, most);
  }
}

TEST(ConvergedHistory, RefusesADampedBeam) {
  EXPECT_THROW((void)studies::converged_history(damped_problem(25.0)), std::invalid_argument);
}

TEST(ConvergedHistory, IsMetByBothMethods) {
  const auto history = studies::published_history(paper_problem(35.0, 1e-3), "undamped-history-35",
                                                  {.steps_per_sample = 64, .levels = 2});
  const auto table = data::read_table(data::load_reference(), "undamped-history-35");
  EXPECT_EQ(history.time, table.column("time").values);
  EXPECT_EQ(history.tip, table.column("tip_displacement").values);
  EXPECT_EQ(history.tip_half_width, table.radius_of("tip_displacement"));
  ASSERT_EQ(history.levels.size(), 4u);
  // The error falls with the step: of the finer run of each method it is below that of the other one.
  for (const std::size_t finer : {0u, 2u}) {
    EXPECT_EQ(history.levels[finer + 1].time_step, 2.0 * history.levels[finer].time_step);
    EXPECT_LT(history.levels[finer].error, history.levels[finer + 1].error);
  }
}

// --- From event to event, on a mesh and in the modes of the continuous beam

using studies::FiniteElementContactModel;

STICKSLIP_VERIFIES(FiniteElementContactModel, "X9");
// contact_model_test.cpp compares what it makes of beams with the closed form.
TEST(FiniteElementContactModel, GivesBackWhatIsIn) {
  const ForcedPair pair;
  const FiniteElementContactModel two(contact_system(pair), pair.omega);
  const Eigen::Vector2d q(0.3, -0.7);
  EXPECT_TRUE(within((two.full(two.amplitudes(q), q[1]) - q).norm(), 0.0, round_off(10, 10, 1.0)));
  const FiniteElementContactModel one(contact_system({.mass = 2.0, .stiffness = 3.0, .normal_force = 1.0}),
                                      1.0);
  EXPECT_EQ(one.model().modes(), 0u);
  EXPECT_EQ(one.model().contact_mass, 2.0);
  EXPECT_EQ(one.model().contact_stiffness, 3.0);
  EXPECT_EQ(one.full(one.amplitudes(scalar(0.7)), 0.7), scalar(0.7));
}

TEST(FiniteElementContactModel, NeedsHeldModes) {
  const auto reduce = [](const ForcedPair& pair) { FiniteElementContactModel(contact_system(pair), 1.0); };
  ForcedPair pair;
  EXPECT_NO_THROW(reduce(pair));
  pair.slip_stiffness(0, 0) += 1.0;
  EXPECT_THROW(reduce(pair), std::invalid_argument);
  pair = {};
  pair.stick_stiffness(0, 0) = pair.slip_stiffness(0, 0) = -1.0;
  EXPECT_THROW(reduce(pair), std::invalid_argument);
  pair = {};
  pair.mass(0, 0) = -1.0;
  EXPECT_THROW(reduce(pair), std::invalid_argument);
  EXPECT_THROW(FiniteElementContactModel(contact_system(ForcedPair{}), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
