// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/data/paper.hpp"
#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::Criterion;
using analytic::evaluate_criterion;
using analytic::SteadyPart;
using analytic::StickResponse;
using analytic::Verdict;

data::HarmonicExcitation shaking(double frequency_hz, double amplitude) {
  return data::HarmonicExcitation({.frequency_hz = frequency_hz, .amplitude = amplitude});
}

Criterion criterion_of(double frequency_hz, double amplitude, SteadyPart steady = SteadyPart::modal_sum) {
  return evaluate_criterion(paper_beam(), paper_friction(), shaking(frequency_hz, amplitude), 10.0, 10,
                            steady);
}

STICKSLIP_VERIFIES(Criterion, "A6");
TEST(Criterion, GivesThePapersEightVerdicts) {
  for (const SteadyPart steady : {SteadyPart::modal_sum, SteadyPart::exact})
    for (const data::PrintedVerdict& printed : data::printed_verdicts())
      EXPECT_EQ(to_string(criterion_of(printed.frequency_hz, printed.amplitude, steady).verdict),
                printed.verdict)
          << "Fig. " << printed.figure;
}

TEST(Criterion, LimitIsTheStaticCoefficientTimesTheAxialForce) {
  EXPECT_DOUBLE_EQ(criterion_of(15.0, 1e-3).friction_limit, 300.0);
}

TEST(Criterion, ForceIsThatOfTheStickResponse) {
  const auto bounds = StickResponse(paper_beam(), shaking(35.0, 0.7e-3)).max_abs_friction_force(10.0);
  const Criterion criterion = criterion_of(35.0, 0.7e-3);
  EXPECT_TRUE(within(criterion.force_max.lower, bounds.lower, round_off(1, 1, bounds.lower)));
  EXPECT_TRUE(within(criterion.force_max.upper, bounds.upper, round_off(1, 1, bounds.upper)));
}

TEST(Criterion, CriticalAmplitudeIgnoresTheAmplitude) {
  const Criterion none = criterion_of(35.0, 0.0), some = criterion_of(35.0, 1e-3);
  EXPECT_EQ(none.critical_amplitude.lower, some.critical_amplitude.lower);
  EXPECT_EQ(none.critical_amplitude.upper, some.critical_amplitude.upper);
  EXPECT_GT(none.critical_amplitude.lower, 0.0);
  EXPECT_EQ(none.force_max.upper, 0.0);
  EXPECT_EQ(none.verdict, Verdict::stick);
}

TEST(Criterion, CriticalAmplitudeBoundsInvertTheForceBounds) {
  const auto enclosed = [](double width) {
    return evaluate_criterion(paper_beam(), paper_friction(), shaking(35.0, 1e-3), 1.0, 10,
                              SteadyPart::modal_sum, width)
        .critical_amplitude;
  };
  const double critical = enclosed(1e-10).midpoint();
  for (const double width : {0.3, 0.03}) {
    const analytic::Bounds bounds = enclosed(width);
    EXPECT_LT(bounds.lower, critical) << width;
    EXPECT_GT(bounds.upper, critical) << width;
    EXPECT_GT(bounds.upper, bounds.lower * (1.0 + 1e-6)) << "no bounds, but a value";
  }
}

TEST(Criterion, RefusesABeamWithoutContactOrBuckledAndSaysWhy) {
  const double buckling = analytic::stick_buckling_load(paper_beam());
  for (const double force : {-500.0, 0.0, buckling, 2.0 * buckling}) {
    SCOPED_TRACE(force);
    const data::Beam beam = paper_beam_with_axial_force(force);
    expect_error_message<data::InputError>(
        [&] { (void)evaluate_criterion(beam, paper_friction(), shaking(15.0, 1e-3), 10.0); },
        {"beam.axial_force is ", "positive"});
  }
}

TEST(Criterion, RefusesABadDuration) {
  EXPECT_THROW((void)evaluate_criterion(paper_beam(), paper_friction(), shaking(15.0, 1e-3), 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
