// SPDX-License-Identifier: MIT
/// The motion of the whole beam by finite elements against the continuous beam (Fig. 3).

#include "studies/verification/contact_histories.hpp"

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/history/method.hpp"
#include "support/beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

class BeamMotionAt : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(BeamMotionAt, "X6");
TEST_P(BeamMotionAt, AgreesWithinThePredictionWhileTheTipSticks) {
  const auto study = studies::beam_motion_study(paper_problem(GetParam(), 0.5e-3), 17, 41);
  EXPECT_EQ(study.first_slip.has_value(), GetParam() == 25.0 || GetParam() == 70.0);
  EXPECT_TRUE(
      within(study.stick_difference, 0.0,
             discretisation(study.predicted_stick_difference, 1.1, "response of every discrete mode")));
  // The prediction adds magnitudes that do not peak together, but it is not ten times too large.
  EXPECT_GT(study.stick_difference, 0.1 * study.predicted_stick_difference);
  // One period, from a quarter of it before the first slip on, and the reference sticks up to there.
  const double period = 1.0 / GetParam();
  const double start = study.first_slip ? *study.first_slip - 0.25 * period : 0.0;
  EXPECT_NEAR(study.reference.rows.front().time, start, 0.5001e-4);
  EXPECT_NEAR(study.reference.rows.back().time, start + period, 0.5001e-4);
  // The free modes say means over steps of 1e-4/128 s: off by less than half a step times the largest slope.
  const data::Case at = paper_problem(GetParam(), 0.5e-3);
  const analytic::StickResponse response(at.beam, at.excitation, 60, analytic::SteadyPart::exact);
  double slope = 2.0 * std::numbers::pi * GetParam() * std::abs(response.steady_force_amplitude());
  for (const auto& [amplitude, omega] : response.transient_force()) slope += std::abs(amplitude) * omega;
  const double force_error = response.omitted_transient_bound() + 0.5 * 1e-4 / 128.0 * slope;
  for (const auto& row : study.reference.rows) {
    if (study.first_slip && row.time > *study.first_slip) break;
    EXPECT_EQ(row.state, data::ContactState::stick);
    EXPECT_TRUE(within(row.friction_force, response.friction_force(row.time),
                       discretisation(force_error, 1.01, "mean over a step")));
  }
  // The clamped end moves with the base. Its phase is below 20, so that its sine is known to 20 eps.
  const double rounding = 20.0 * std::numeric_limits<double>::epsilon() * study.amplitude;
  for (const auto* motion : {&study.finite_element, &study.reference})
    for (const auto& row : motion->rows)
      EXPECT_NEAR(row.displacement.front(),
                  study.amplitude * std::sin(2.0 * std::numbers::pi * GetParam() * row.time), rounding);
  constexpr double always = std::numeric_limits<double>::infinity();
  EXPECT_EQ(study.difference, studies::largest_difference(study.reference, study.finite_element, always));
  EXPECT_EQ(study.half_width > 0.0, study.first_slip.has_value());
  EXPECT_LT(study.half_width, 0.01 * study.peak);
}

INSTANTIATE_TEST_SUITE_P(Hertz, BeamMotionAt, ::testing::Values(15.0, 25.0, 35.0, 70.0), NameOfDouble());

STICKSLIP_VERIFIES(BeamMotion, "X6");
// What its documentation says, with Eq. (26) as it is printed.
TEST(BeamMotion, PredictionIsTheSumOverTheModes) {
  const data::Case at = paper_problem(35.0, 0.5e-3);
  const analytic::StickResponse response(at.beam, at.excitation, 60, analytic::SteadyPart::exact);
  const double omega = 70.0 * std::numbers::pi, h = 1e-4;
  double largest = 0.0, motion = 0.0;
  for (const long n : {100L, 200L, 300L, 400L})
    for (const double x : {0.0, 1.0}) {
      const double t = static_cast<double>(n) * h;
      double sum = 0.0;
      for (const auto& mode : response.modes()) {
        const double w = mode.angular_frequency(), on_mesh = studies::frequency_on_mesh(at.beam, mode, 20);
        const double g = (w * std::sin(omega * t) - omega * std::sin(w * t)) / (omega * omega - w * w) / w;
        sum += std::abs(mode.shape(x) * omega * omega * mode.participation() *
                        (studies::stepped_from_rest(0.9, on_mesh, omega, h).at(n, omega * h) - g));
      }
      largest = std::max(largest, 0.5e-3 * sum);
      motion = std::max(motion, std::abs(response.absolute_displacement(x, t)));
    }
  const double expected = largest + 0.25 * std::pow(omega * h, 2) * motion;
  // Angles up to 365000 rad/s for 0.04 s are rounded by 2e-12, against a difference of 1e-4 and more of g.
  EXPECT_NEAR(studies::predicted_stick_difference(at, studies::snapshots_of(at, 0.0, 0.05, 6, 3), 0.045),
              expected, 1e-7 * expected);
}

TEST(BeamMotion, EventDrivenIsTheClosedFormUntilTheFirstSlip) {
  const data::Case at = paper_problem(25.0, 0.5e-3);
  const auto grid = studies::snapshots_of(at, 0.0, 0.0969, 31, 21);  // the first slip is at 0.09692 s
  const auto events = studies::event_driven_history(at, grid);
  const auto closed_form = studies::closed_form_history(at, grid, analytic::SteadyPart::exact);
  // They differ in the steady part of the modes n > 10: A0 (Omega/omega_n)^2 |U_n C_n|, which falls as n^-5,
  // so that its tail is n/4 times its first term. |U_n| <= 1.6.
  const auto next = analytic::stick_modes(at.beam, at.numerics.modes() + 1).back();
  const double ratio = 2.0 * std::numbers::pi * 25.0 / next.angular_frequency();
  const double first_term = 0.5e-3 * ratio * ratio * 1.6 * std::abs(next.participation());
  EXPECT_TRUE(within(studies::largest_difference(events, closed_form, 0.0969), 0.0,
                     discretisation(first_term * next.number() / 4.0, 1.0, "tail of the steady part")));
}

// Stick, the first slip at 0.0552 s, and the plateau after it; three points in each of 20 elements.
TEST(BeamMotion, EndsInTheTipOfTheSimulations) {
  const data::Case at = paper_problem(25.0, 1e-3);
  const auto grid = studies::snapshots_of(at, 0.0, 0.08, 9, 61);
  const auto by_elements = studies::finite_element_history(at, grid);
  const auto by_events = studies::event_driven_history(at, grid);
  const analytic::BeamContactModel beam(at.beam, at.friction, at.excitation, at.damping, at.numerics.modes());
  const auto history = studies::event_driven_history(beam.model(), studies::sample_times(0.08, 0.01));
  solver::BeamSimulation simulation(at.beam, at.friction, at.excitation, at.numerics,
                                    {.coordinates = solver::Coordinates::fastest});
  analytic::EventDriven run(beam.model());
  int slips = 0;
  for (std::size_t i = 0; i < by_elements.rows.size(); ++i) {
    for (int n = 0; i > 0 && n < 100; ++n) simulation.step();
    const auto& snapshot = by_elements.rows[i];
    EXPECT_EQ(snapshot.time, simulation.time());
    EXPECT_EQ(snapshot.friction_force, simulation.friction_force());
    EXPECT_EQ(snapshot.state, simulation.state());
    EXPECT_TRUE(within(snapshot.displacement.back(), simulation.tip_displacement(), round_off(4, 1, 1e-3)));
    // U_n(L) is zero but for round-off, in each of ten modes.
    EXPECT_TRUE(within(by_events.rows[i].displacement.back(), history.rows[i].tip_displacement,
                       round_off(40, 1, studies::peak(by_events))));
    run.advance_to(by_events.rows[i].time);
    EXPECT_EQ(by_events.rows[i].state, run.state());
    EXPECT_EQ(by_events.rows[i].friction_force, -run.friction_force());  // f = -f_d
    if (snapshot.state == data::ContactState::slip) ++slips;
  }
  EXPECT_GT(slips, 0);
}

TEST(BeamMotion, RefusesAGridThatCannotBeSampled) {
  const data::Case at = paper_problem(25.0, 0.5e-3);
  for (const auto& [start, end, times, points] :
       {std::tuple{-1.0, 0.1, 9, 9}, {0.0, 0.1, 1, 9}, {0.0, 0.1, 9, 1}, {0.0, 1e-3, 12, 9}})
    EXPECT_THROW((void)studies::snapshots_of(at, start, end, times, points), data::FieldError) << times;
  EXPECT_EQ(studies::snapshots_of(at, 0.0, 1e-3, 11, 9).times.size(), 11U);
  EXPECT_EQ(studies::snapshots_of(at, 0.0, 1e-3, 2, 2).positions.size(), 2U);
}

}  // namespace
}  // namespace stickslip::testing
