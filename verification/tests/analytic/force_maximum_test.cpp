// SPDX-License-Identifier: MIT
/// The fast search for |f_max| against the plain one, samples and itself, the table of modes against the modes, and the
/// criterion that compares |f_max| with the friction limit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/paper.hpp"
#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::Criterion;
using analytic::evaluate_criterion;
using analytic::ForceMaximum;
using analytic::ModalReactionTable;
using analytic::SteadyPart;
using analytic::StickResponse;
using analytic::Verdict;
using std::numbers::pi;

StickResponse response_at(const data::Beam& beam, double hz, int modes) {
  return StickResponse(beam, data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1.0}), modes);
}

ForceMaximum search_at(const data::Beam& beam, double hz, double duration, int modes = 10) {
  return ForceMaximum(response_at(beam, hz, modes).reaction(), 2.0 * pi * hz, duration);
}

double first_frequency(const data::Beam& beam) { return analytic::stick_modes(beam, 1)[0].frequency_hz(); }

// Off resonance, in it to the last bit, and so near that the beat is as long as the run or a thousandth of
// it.
std::vector<double> telling_frequencies(const data::Beam& beam) {
  const double resonance = first_frequency(beam);
  std::vector<double> all{0.3, 7.0, 35.0, 90.0, 400.0};
  for (const double detuning : {0.0, 1e-9, 1e-4, 0.031, 0.032, 0.05, 0.5, -0.0315})
    all.push_back(resonance + detuning);
  return all;
}

STICKSLIP_VERIFIES(ForceMaximum, "A5");
TEST(ForceMaximum, EnclosesEverySampleAndIsAttained) {
  for (const double hz : telling_frequencies(paper_beam())) {
    constexpr double duration = 0.8;
    const ForceMaximum search = search_at(paper_beam(), hz, duration);
    for (const double width : {0.5, 1e-2, 1e-10, 1e-13}) {
      const Bounds bounds = search.refined_to(width);
      EXPECT_LE(bounds.upper - bounds.lower, width * bounds.lower + 3.0 * search.rounding());
      double largest = 0.0;
      for (int i = 0; i <= 20000; ++i)
        largest = largest_or_nan({largest, std::abs(search.value(duration * i / 2e4))});
      EXPECT_LE(largest, bounds.upper + search.rounding()) << hz;
      // Between samples a sinusoid of frequency w exceeds them by at most (w h)^2/8 of itself; the tenth mode
      // has 1e4 rad/s, but less than a thousandth of the amplitude.
      EXPECT_LE(bounds.lower,
                largest * (1.0 + 1e-3 + std::pow(2.0 * pi * std::max(hz, 25.0) * 4e-5, 2) / 8.0))
          << hz;
    }
  }
}

TEST(ForceMaximum, ExceedsALimitExactlyIfItsLowerBoundDoes) {
  for (const double hz : telling_frequencies(paper_beam())) {
    const ForceMaximum search = search_at(paper_beam(), hz, 2.0);
    const Bounds bounds = search.refined_to();
    for (const double share : {1e-3, 0.3, 0.9, 0.999, 1.0 - 1e-7, 1.0 - 1e-9})
      EXPECT_TRUE(search.exceeds(share * bounds.lower)) << hz << " Hz, " << share;
    for (const double share : {1.0 + 1e-9, 1.0 + 1e-7, 1.001, 1.1, 3.0, 1e6})
      EXPECT_FALSE(search.exceeds(share * bounds.upper)) << hz << " Hz, " << share;
  }
}

TEST(ForceMaximum, EvaluatesTheReactionOfTheResponse) {
  for (const double hz : telling_frequencies(paper_beam())) {
    const StickResponse response = response_at(paper_beam(), hz, 10);
    const ForceMaximum search = search_at(paper_beam(), hz, 10.0);
    for (const double t : {0.0, 1e-7, 0.0123, 1.7, 9.999})
      EXPECT_TRUE(within(search.value(t), response.friction_force(t),
                         reference(2.0 * search.rounding(), "two evaluations, each to its rounding")))
          << hz << " Hz, t = " << t;
  }
}

TEST(ForceMaximum, RoundingBoundsTheDistanceToExtendedPrecision) {
  // One mode far from resonance, so that the sum has two terms.
  const analytic::ModalReaction reaction{.quasi_static = 3.7, .modes = {{157.3, -2.2}}};
  const double omega = 411.7;
  const ForceMaximum search(reaction, omega, 10.0);
  const long double o = omega, w = reaction.modes[0].angular_frequency;
  const long double c = reaction.modes[0].coefficient;
  const long double steady =
      static_cast<long double>(reaction.quasi_static) + c * o * o / ((o - w) * (o + w));
  const long double free = -c * o * o * o / ((o - w) * (o + w) * w);
  double worst = 0.0;
  for (int i = 0; i <= 5000; ++i) {
    const double t = 10.0 * i / 5000.0;
    const long double exact =
        steady * std::sin(o * static_cast<long double>(t)) + free * std::sin(w * static_cast<long double>(t));
    worst = largest_or_nan({worst, std::abs(static_cast<double>(search.value(t) - exact))});
  }
  EXPECT_LE(worst, search.rounding());
  EXPECT_GE(worst, 1e-3 * search.rounding());  // and the bound is not out of all proportion
}

TEST(ForceMaximum, FindsTheMaximumOfASinusoidAlone) {
  // Without modes |f| = s |sin(Omega t)|: s after a quarter of a period, before that the value at the end.
  const analytic::ModalReaction reaction{.quasi_static = -7.0, .modes = {}};
  const Bounds whole = ForceMaximum(reaction, 2.0, 5.0).refined_to(1e-13);
  EXPECT_TRUE(within(whole.midpoint(), 7.0, round_off(40, 1, 7.0)));
  const Bounds part = ForceMaximum(reaction, 2.0, 0.3).refined_to(1e-13);
  EXPECT_TRUE(within(part.midpoint(), 7.0 * std::sin(0.6), round_off(20, 1, 7.0)));
}

TEST(ForceMaximum, RefusesWhatCannotBeSearched) {
  const analytic::ModalReaction reaction{.quasi_static = 1.0, .modes = {}};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(ForceMaximum(reaction, bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(ForceMaximum(reaction, 1.0, bad), std::invalid_argument) << bad;
  }
  for (const double width : {0.0, 1e-14, 1.0, nan})
    EXPECT_THROW((void)ForceMaximum(reaction, 1.0, 1.0).refined_to(width), std::invalid_argument) << width;
  EXPECT_THROW((void)ForceMaximum(reaction, 1e6, 1e9).refined_to(), std::invalid_argument);
}

STICKSLIP_VERIFIES(ModalReaction, "A5");
TEST(ModalReaction, IsTheForceOfTheResponseWithoutItsExcitation) {
  const StickResponse response = response_at(paper_beam(), 35.0, 6);
  const analytic::ModalReaction of_beam = analytic::modal_reaction(paper_beam(), 6);
  const analytic::ModalReaction of_response = response.reaction();
  EXPECT_EQ(of_response.quasi_static, of_beam.quasi_static);
  ASSERT_EQ(of_response.modes.size(), 6u);
  for (std::size_t n = 0; n < 6; ++n) {
    EXPECT_EQ(of_response.modes[n].angular_frequency, of_beam.modes[n].angular_frequency);
    EXPECT_TRUE(within(of_response.modes[n].coefficient, of_beam.modes[n].coefficient,
                       round_off(4, 1, of_beam.modes[n].coefficient)));
  }
}

double load_factor(const data::Beam& beam) {
  return beam.axial_force() * beam.length() * beam.length() /
         (beam.youngs_modulus() * beam.second_moment_of_area());
}

STICKSLIP_VERIFIES(ModalReactionTable, "A5");
TEST(ModalReactionTable, HoldsTheModesOfEveryLoadFactorInItsRange) {
  for (const double highest : {0.5, 3.0, 20.15})
    for (int i = 0; i <= 60; ++i) {
      const ModalReactionTable table(0.0, highest, 12);
      const double length = i % 2 == 0 ? 0.4 : 2.0;
      auto properties = paper_beam_properties();
      properties.length = length;
      properties.axial_force = 0.999 * highest * i / 60.0 * properties.youngs_modulus *
                               properties.second_moment_of_area / (length * length);
      const data::Beam beam(properties);
      ASSERT_LE(load_factor(beam), highest);
      const analytic::ModalReaction read = table.at(beam), exact = analytic::modal_reaction(beam, 12);
      const double condition = analytic::stick_modes(beam, 1)[0].condition_number();
      EXPECT_TRUE(
          within(read.quasi_static, exact.quasi_static, round_off(20, condition, exact.quasi_static)));
      ASSERT_EQ(read.modes.size(), 12u);
      for (std::size_t n = 0; n < 12; ++n) {
        const double kappa = n == 0 ? condition : 1.0;
        const auto& [frequency, coefficient] = exact.modes[n];
        EXPECT_TRUE(within(read.modes[n].angular_frequency, frequency, round_off(10, kappa, frequency)));
        EXPECT_TRUE(within(read.modes[n].coefficient, coefficient, round_off(20, kappa, coefficient)));
      }
    }
}

TEST(ModalReactionTable, RefusesFrequenciesOutsideItsRange) {
  const double z = load_factor(paper_beam());
  EXPECT_THROW((void)ModalReactionTable(2.0 * z, 3.0 * z, 3).at(paper_beam()), std::invalid_argument);
  EXPECT_THROW((void)ModalReactionTable(0.0, 0.5 * z, 3).at(paper_beam()), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(2.0, 1.0, 3), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(-1.0, 1.0, 3), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(std::nan(""), 1.0, 3), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(0.0, 21.0, 3), data::InputError);  // over the buckling load
}

data::HarmonicExcitation shaking(double frequency_hz, double amplitude) {
  return data::HarmonicExcitation({.frequency_hz = frequency_hz, .amplitude = amplitude});
}

Criterion criterion_of(double frequency_hz, double amplitude, SteadyPart steady = SteadyPart::modal_sum) {
  return evaluate_criterion(paper_beam(), paper_friction(), shaking(frequency_hz, amplitude), 10.0, 10,
                            steady);
}

STICKSLIP_VERIFIES(Criterion, "A6");
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
