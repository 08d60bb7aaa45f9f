// SPDX-License-Identifier: MIT
/// The beam with contact: classification, first slip, histories.

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/verification/classification.hpp"
#include "studies/verification/contact_histories.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(Figure12, "X3");
TEST(Figure12, ClassifiesAlikeOutsideTheGuardBand) {
  const auto study = studies::classification_study(
      paper_problem(25.0, 1e-3, 10.0), studies::figure12_frequencies(), studies::figure12_amplitudes());
  ASSERT_EQ(study.points.size(), 480u);
  int agreeing = 0, in_guard_band = 0;
  for (std::size_t n = 0; n < study.points.size(); ++n) {
    const auto& point = study.points[n];
    const auto& frequency = study.frequencies[n / 20];
    EXPECT_DOUBLE_EQ(point.frequency_hz, 5.0 * static_cast<double>(n / 20 + 1));
    EXPECT_DOUBLE_EQ(point.amplitude, 0.05e-3 * static_cast<double>(n % 20 + 1));
    EXPECT_EQ(point.closed_form_slips, point.amplitude > frequency.critical_amplitude);
    const double ratio = point.amplitude / frequency.critical_amplitude;  // known to rounding
    EXPECT_NEAR(point.distance, ratio - 1.0, round_off(1, 1, 1.0 + ratio).value);
    EXPECT_EQ(point.relative_guard, frequency.relative_guard());
    EXPECT_EQ(point.in_guard_band, std::abs(point.distance) <= point.relative_guard);
    EXPECT_STREQ(point.closed_form(), point.distance > 0.0 ? "stick-slip" : "stick");
    EXPECT_STREQ(point.finite_element(), point.finite_element_slips ? "stick-slip" : "stick");
    const bool agree = point.closed_form_slips == point.finite_element_slips;
    EXPECT_TRUE(point.in_guard_band || agree) << point.frequency_hz << " Hz, " << point.amplitude << " m";
    agreeing += agree ? 1 : 0;
    in_guard_band += point.in_guard_band ? 1 : 0;
  }
  EXPECT_EQ(study.agreeing, agreeing);
  EXPECT_EQ(study.in_guard_band, in_guard_band);
  EXPECT_EQ(study.disagreeing_outside, 0);
  // A wide band would prove nothing: it is below 6 % everywhere and holds few points.
  for (const auto& frequency : study.frequencies)
    EXPECT_LT(frequency.relative_guard(), 0.06) << frequency.frequency_hz;
  EXPECT_EQ(study.frequencies[0].relative_guard(), study.frequencies[0].relative_truncation_error +
                                                       study.frequencies[0].relative_discretisation_error);
  // The errors of the first frequency, from its critical amplitude.
  const data::HarmonicExcitation first({5.0, 1e-3});
  const double converged = analytic::StickResponse(paper_beam(), first, 60, analytic::SteadyPart::exact)
                               .max_abs_friction_force(10.0, 1e-8)
                               .midpoint();
  const double truncated = 1e-3 * 300.0 / study.frequencies[0].critical_amplitude;
  EXPECT_TRUE(within(study.frequencies[0].relative_truncation_error, std::abs(truncated / converged - 1.0),
                     reference(1e-8, "the width of the bounds")));
  EXPECT_GE(study.frequencies[0].relative_discretisation_error,
            studies::PredictedForce(paper_problem(5.0, 1e-3, 10.0)).uncertainty() / converged);
  EXPECT_LE(study.in_guard_band, 10);
  EXPECT_GT(study.agreeing, 470);
  RecordProperty("points_in_guard_band", study.in_guard_band);
  RecordProperty("points_agreeing", study.agreeing);
}

TEST(Figure12, CountsDisagreeingPointsOutsideTheGuardBand) {
  studies::ClassificationStudy study;
  for (const auto& [closed_form, finite_elements, guarded] : {std::tuple{true, true, false},
                                                              {true, false, false},
                                                              {false, true, false},
                                                              {false, true, true},
                                                              {false, false, true}})
    study.points.push_back({.closed_form_slips = closed_form,
                            .finite_element_slips = finite_elements,
                            .in_guard_band = guarded});
  study.count_points();
  EXPECT_EQ(study.agreeing, 2);
  EXPECT_EQ(study.in_guard_band, 2);
  EXPECT_EQ(study.disagreeing_outside, 2);
}

STICKSLIP_VERIFIES(FirstSlip, "X5");
// The instant moves by the force error over the force's slope there.
TEST(FirstSlip, HappensWhenTheClosedFormSaysSo) {
  const data::NumericalSettings numerics(paper_choices(1.0));
  for (const auto& [hz, amplitude] :
       {std::pair{25.0, 0.5e-3}, {70.0, 0.5e-3}, {25.0, 1e-3}, {35.0, 1e-3}, {70.0, 1e-3}}) {
    SCOPED_TRACE(::testing::Message() << hz << " Hz, " << amplitude << " m");
    const data::HarmonicExcitation excitation({hz, amplitude});
    const auto exact = studies::closed_form_first_slip(paper_problem(hz, amplitude));
    ASSERT_TRUE(exact);
    const analytic::StickResponse response(paper_beam(), excitation, 60, analytic::SteadyPart::exact);
    // 1/20000 of a step of 1/2000 of the shorter period; that of mode 1 is 0.04004 s.
    const double resolution = std::min(1.0 / hz, 0.0401) / 2000.0 / 20000.0;
    EXPECT_GT(std::abs(response.friction_force(*exact)), 300.0);
    EXPECT_LE(std::abs(response.friction_force(*exact - resolution)), 300.0);
    const double force_error =
        studies::drift_bound(paper_beam(), response.modes(), response.transient_force(), numerics, *exact);
    const double slope =
        (response.friction_force(*exact + 1e-6) - response.friction_force(*exact - 1e-6)) / 2e-6;
    for (const auto coordinates : {solver::Coordinates::nodal, solver::Coordinates::modal}) {
      const auto computed = solver::first_slip(paper_problem(hz, amplitude), coordinates);
      ASSERT_TRUE(computed);
      EXPECT_TRUE(within(
          *computed, *exact,
          discretisation(force_error / std::abs(slope), 1.5, "force error over the slope of the force")));
    }
  }
}

STICKSLIP_VERIFIES(ContactHistory, "X5");
TEST(ContactHistory, BoundaryIntegralHasTheClosedFormFirstSlip) {
  const data::Case problem = paper_problem(25.0, 1e-3);
  const auto history = studies::contact_history(problem, 0.07);
  EXPECT_EQ(history.frequency_hz, 25.0);
  EXPECT_EQ(history.amplitude, 1e-3);
  EXPECT_TRUE(history.criterion_slips);
  ASSERT_TRUE(history.converged && history.closed_form_slip && history.finite_element_slip);
  const studies::ConvergedHistory& converged = *history.converged;
  ASSERT_EQ(converged.time.size(), 351U);  // 0, 0.2 ms ... 70 ms
  EXPECT_DOUBLE_EQ(converged.time[1], 2e-4);
  EXPECT_TRUE(converged.midspan.empty());
  EXPECT_DOUBLE_EQ(converged.time.back(), 0.07);
  EXPECT_DOUBLE_EQ(converged.levels.at(0).time_step, 2e-4 / 512.0);
  EXPECT_TRUE(within(converged.first_stick.end, *history.closed_form_slip,
                     discretisation(converged.first_stick.end_half_width, 1.0, "half-width of the history")));
  EXPECT_EQ(history.finite_element_slip, solver::first_slip(problem));
}

TEST(ContactHistory, IsEmptyWhereTheCriterionSticks) {
  const auto history = studies::contact_history(paper_problem(15.0, 0.5e-3), 0.07);
  EXPECT_FALSE(history.criterion_slips);
  EXPECT_FALSE(history.converged || history.closed_form_slip || history.finite_element_slip);
}

STICKSLIP_VERIFIES(PracticeRuns, "X12");
TEST(PracticeRuns, AreComparedWithTheConvergedHistory) {
  const data::Case problem = paper_problem(25.0, 1e-3);
  const auto converged = studies::contact_history(problem, 0.1).converged.value();
  const auto runs = studies::usual_practice(problem, converged);
  const std::vector<std::tuple<std::string, int, double, double>> settings{
      {"letter of the paper", 20, 1e-4, 0.9}, {"located in the step", 20, 1e-4, 0.5},
      {"located in the step", 20, 1e-4, 0.9}, {"located in the step", 20, 1e-4, 1.0},
      {"event-driven", 10, 0.0, 0.0},         {"event-driven", 20, 0.0, 0.0}};
  ASSERT_EQ(runs.size(), settings.size());
  for (std::size_t run = 0; run < runs.size(); ++run) {
    EXPECT_EQ(
        std::tuple(runs[run].method, runs[run].elements, runs[run].time_step, runs[run].spectral_radius),
        settings[run]);
    ASSERT_EQ(runs[run].tip_displacement.size(), converged.tip.size());
    EXPECT_DOUBLE_EQ(runs[run].error, studies::largest_difference(runs[run].tip_displacement, converged.tip) /
                                          converged.tip_range);
  }
  // Empirical: the scheme of the paper captures a tip that still moves, 71 times in 0.1 s; its error is 12 % of
  // the range. The changes that are located in the step are 9 to 11, and the error is below 0.5 %.
  for (std::size_t located = 1; located <= 3; ++located) {
    EXPECT_GT(runs[0].changes, 3 * runs[located].changes);
    EXPECT_GT(runs[0].error, 10.0 * runs[located].error);
  }
}

STICKSLIP_VERIFIES(StickSlipBeam, "X10");
TEST(StickSlipBeam, StaysBoundedOnAnyMeshAndStep) {
  // Where the tip velocity is overwritten at capture, undamped runs grow from 2 mm to 30 mm.
  for (const double radius : {0.5, 1.0})
    for (const int elements : {5, 40})
      for (const double hz : {25.0, 70.0}) {
        data::NumericalChoices c = paper_choices(0.5);
        c.elements = elements;
        c.spectral_radius = radius;
        solver::BeamSimulation s(with(paper_problem(hz, 1e-3), data::NumericalSettings(c)));
        for (int n = 0; n < 5000; ++n) {
          s.step();
          ASSERT_LT(std::abs(s.tip_displacement()), 7e-3)
              << radius << " " << elements << " " << hz << " " << s.time();
        }
      }
}

STICKSLIP_VERIFIES(CriticalAmplitude, "X4");
TEST(CriticalAmplitude, BySearchIsTheFirstStepAboveTheOneOfALinearRun) {
  // Five steps each: found at 80 and 85 Hz within them, not at 40 Hz.
  const data::Case problem = paper_problem(25.0, 1e-3);
  const auto searches = studies::critical_amplitude_searches(problem, {40.0, 80.0, 85.0}, 0.02e-3, 0.1e-3);
  ASSERT_EQ(searches.size(), 3u);
  for (const auto& search : searches) EXPECT_TRUE(search.agree()) << search.frequency_hz;
  EXPECT_EQ(searches[1].frequency_hz, 80.0);
  const auto published = studies::figure6_frequencies();
  ASSERT_EQ(published.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(published[i], 5.0 * static_cast<double>(i + 1));
  EXPECT_FALSE(searches[0].searched.has_value());
  EXPECT_EQ(searches[0].runs, 5);
  for (const std::size_t i : {1u, 2u}) {
    ASSERT_TRUE(searches[i].searched.has_value());
    EXPECT_GT(*searches[i].searched, searches[i].linear);
    EXPECT_LE(*searches[i].searched - 0.02e-3, searches[i].linear);
  }
  // The cap itself is tried.
  const auto last =
      studies::critical_amplitude_searches(problem, {85.0}, 0.02e-3, *searches[2].searched).front();
  EXPECT_TRUE(last.searched && last.agree());
}

}  // namespace
}  // namespace stickslip::testing
