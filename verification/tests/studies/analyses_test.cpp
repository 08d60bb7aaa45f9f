// SPDX-License-Identifier: MIT
/// What users ask of a case: the criterion with its outlook.

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/natural_frequencies.hpp"
#include "support/random_cases.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Verdict;

data::Case paper_at(const std::string& hz, const std::string& amplitude) {
  return data::load_case("paper", {{"excitation.frequency_hz", hz, "the test"},
                                   {"excitation.amplitude", amplitude, "the test"}});
}

STICKSLIP_VERIFIES(CriterionVerdict, "U1");
TEST(CriterionVerdict, SlipIsCertainlyAboveTheLimit) {
  EXPECT_EQ(analytic::verdict_of({2.0, 3.0}, 1.0), Verdict::stick_slip);
  EXPECT_EQ(analytic::verdict_of({0.5, 3.0}, 1.0), Verdict::undecided);  // the bounds hold the limit
  EXPECT_EQ(analytic::verdict_of({1.0, 1.0}, 1.0), Verdict::stick);  // the limit is reached and not passed
}

STICKSLIP_VERIFIES(MeshFrequencies, "F3");
// The next terms of three modes: (beta l)^2/40, four times that at a free tip, and the share of shear in the energy. Where the
// leading terms cancel, in slip, the estimate is above the error.
TEST(MeshFrequencies, ErrorIsThatOfTheEstimate) {
  for (const auto tip : {analytic::TipSupport::held, analytic::TipSupport::free})
    for (const bool sheared : {false, true}) {
      const bool slips = tip == analytic::TipSupport::free;
      if (slips && sheared) continue;  // no closed form
      const ForceRange force = slips ? ForceRange{-1.0, 0.8} : ForceRange{-3.0, 0.99};
      on_random_beams(20, force, [&](const data::Beam& slender, RandomNumbers& numbers) {
        const data::Beam beam = sheared ? studies::with_shear(slender) : slender;
        const data::Case problem =
            with_value(with(paper_at("35", "1e-3"), beam), "numerics.elements", numbers.whole(16, 40));
        const auto mesh = studies::mesh_frequencies(problem, tip, 3);
        const auto exact = studies::closed_form_frequencies(beam, tip, 3);
        for (std::size_t n = 0; n < 3; ++n) {
          const double error = std::abs(mesh[n].hz / exact[n].hz - 1.0), estimate = mesh[n].relative_error;
          EXPECT_LE(error, 1.1 * estimate) << n;
          if (!slips) {
            EXPECT_GE(error, 0.9 * estimate - 1e-9) << n;
          }
        }
      });
    }
}

STICKSLIP_VERIFIES(CriterionAnswer, "U1");
TEST(CriterionAnswer, ChangesAtCriticalAmplitudes) {
  const auto answer = studies::criterion_answer(paper_at("35", "1e-3"));
  const auto at = [&](double amplitude) {
    return studies::criterion_answer(paper_at("35", data::shortest_text(amplitude)));
  };
  ASSERT_TRUE(answer.steady);
  const auto above = [](double amplitude) { return amplitude * (1.0 + 1e-9); };
  const auto below = [](double amplitude) { return amplitude * (1.0 - 1e-9); };
  EXPECT_EQ(at(above(answer.truncated.critical_amplitude.upper)).truncated.verdict, Verdict::stick_slip);
  EXPECT_EQ(at(below(answer.truncated.critical_amplitude.lower)).truncated.verdict, Verdict::stick);
  EXPECT_EQ(at(above(answer.all_modes.critical_amplitude.upper)).all_modes.verdict, Verdict::stick_slip);
  EXPECT_EQ(at(below(answer.all_modes.critical_amplitude.lower)).all_modes.verdict, Verdict::stick);
  EXPECT_EQ(at(above(answer.steady->critical_amplitude.upper)).steady->verdict, Verdict::stick_slip);
  EXPECT_EQ(at(below(answer.steady->critical_amplitude.lower)).steady->verdict, Verdict::stick);
}

TEST(CriterionAnswer, NearestIsBelowOrAbove) {
  const auto modes = analytic::stick_modes(paper_at("35", "1e-3").beam(), 2);  // 24.97 and 81.08 Hz
  for (const auto& [hz, mode] :
       {std::pair<double, int>{5.0, 1}, {27.0, 1}, {53.0, 1}, {53.1, 2}, {90.0, 2}}) {
    const auto nearest = studies::criterion_answer(paper_at(data::shortest_text(hz), "1e-3")).nearest.value();
    EXPECT_EQ(nearest.mode, mode) << hz;
    EXPECT_DOUBLE_EQ(nearest.hz, modes.at(static_cast<std::size_t>(mode) - 1).frequency_hz());
    EXPECT_DOUBLE_EQ(nearest.distance, nearest.hz / hz - 1.0);
  }
}

// From a quarter of the frequency of the case to four times it and beyond the first natural frequency.
TEST(CriterionAnswer, CurveHasTheResonances) {
  on_random_cases(
      4, {.lowest_frequency = 0.05, .highest_frequency = 2.0, .kelvin_voigt = 0.3},
      [](const CaseText& text, RandomNumbers& numbers) {
        const data::Case problem = with_value(text.problem(), "numerics.modes", 4);
        const auto curve = studies::critical_amplitude_curve(problem);
        const double hz = problem.excitation().frequency_hz(), first = 0.25 * hz,
                     last = std::max(4.0 * hz,
                                     1.25 * analytic::stick_modes(problem.beam(), 1).front().frequency_hz());
        ASSERT_EQ(curve.natural_hz.size(), 4u);
        EXPECT_DOUBLE_EQ(curve.points.front().frequency_hz, first);
        EXPECT_TRUE(within(curve.points.back().frequency_hz, last, round_off(10, 1, last)));
        for (std::size_t i = 1; i < curve.points.size(); ++i) {
          const double ratio = curve.points[i].frequency_hz / curve.points[i - 1].frequency_hz;
          EXPECT_TRUE(1.0 < ratio && ratio < std::pow(last / first, 1.0001 / 240.0)) << ratio;
        }
        for (const auto& mode : analytic::stick_modes(problem.beam(), 4)) {
          const double natural = curve.natural_hz[static_cast<std::size_t>(mode.number() - 1)];
          EXPECT_TRUE(within(natural, mode.frequency_hz(), round_off(4, 1, natural)));
          const bool is_a_point =
              std::ranges::find(curve.points, natural, &studies::CriticalAmplitudePoint::frequency_hz) !=
              curve.points.end();
          EXPECT_EQ(is_a_point, first < natural && natural < last);
        }
        const auto& point = curve.points.at(static_cast<std::size_t>(numbers.whole(0, 240)));
        const auto [lower, upper] =
            analytic::evaluate_criterion(with_value(problem, "excitation.frequency_hz", point.frequency_hz))
                .critical_amplitude;
        EXPECT_TRUE(
            within(point.critical_amplitude, 0.5 * (lower + upper), reference(1e-3 * upper, "its bounds")));
      });
}

TEST(CriterionAnswer, ResonanceHasNoSteadyForce) {
  const double natural = analytic::stick_modes(paper_at("25", "1e-3").beam(), 1).front().frequency_hz();
  const auto steady_at = [](double hz) {
    return studies::criterion_answer(paper_at(data::shortest_text(hz), "1e-3")).steady;
  };
  EXPECT_FALSE(steady_at(natural));
  ASSERT_TRUE(steady_at(natural * (1.0 + 1e-9)));
  // The force of one mode over its distance.
  EXPECT_NEAR(steady_at(natural * (1.0 + 1e-9))->force.midpoint() /
                  steady_at(natural * (1.0 + 1e-8))->force.midpoint(),
              10.0, 1e-4);
}

}  // namespace
}  // namespace stickslip::testing
