// SPDX-License-Identifier: MIT
/// The margin to slipping over a band of frequencies, and the lengths and axial forces that keep it.

#include "studies/analyses/design_guide.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/problem_parameter.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::FrequencyBand;
using studies::DesignInterval;
using studies::DesignScan;

// Whether the criterion says stick at every one of `count` frequencies of the band.
bool sticks_on_a_grid(const data::Case& problem, const FrequencyBand& band, int count) {
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
    const data::Case at_hz =
        with_value(problem, "excitation.frequency_hz", std::lerp(band.from_hz, band.to_hz, share));
    if (studies::criterion_of(at_hz).verdict == analytic::Verdict::stick_slip) return false;
  }
  return true;
}

void expect_to_tile(const DesignScan& scan, double from, double to) {
  ASSERT_FALSE(scan.intervals.empty());
  EXPECT_EQ(scan.intervals.front().from, from);
  EXPECT_EQ(scan.intervals.back().to, to);
  for (std::size_t i = 1; i < scan.intervals.size(); ++i)
    EXPECT_EQ(scan.intervals[i].from, scan.intervals[i - 1].to);
}

const DesignInterval& interval_at(const DesignScan& scan, double value) {
  return *std::ranges::find_if(scan.intervals,
                               [&](const auto& i) { return i.from <= value && value <= i.to; });
}

// At equal steps of the length, with an excitation of one frequency.
void expect_verdicts_of_the_criterion(const data::Case& problem, const DesignScan& scan, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double length = std::lerp(scan.intervals.front().from, scan.intervals.back().to, 1.0 * i / steps);
    EXPECT_EQ(sticks_on_a_grid(with_value(problem, "beam.length", length), {25.0, 25.0}, 1),
              interval_at(scan, length).sticks)
        << length;
  }
}

// Between stick and slip, the criterion sticks at the end itself and slips within the accuracy behind it.
void expect_ends_of_the_criterion(const data::Case& problem, const DesignScan& scan, double hz) {
  const FrequencyBand band{hz, hz};
  for (std::size_t i = 1; i < scan.intervals.size(); ++i) {
    const DesignInterval &left = scan.intervals[i - 1], &right = scan.intervals[i];
    if (right.buckled) continue;
    const double end = right.from, inwards = left.sticks ? -1.0 : 1.0;
    EXPECT_TRUE(sticks_on_a_grid(with_value(problem, scan.parameter, end), band, 1)) << end;
    EXPECT_FALSE(
        sticks_on_a_grid(with_value(problem, scan.parameter, end - inwards * scan.accuracy), band, 1))
        << end;
  }
}

STICKSLIP_VERIFIES(BandMargin, "X15");
TEST(BandMargin, OfOneFrequencyIsThatOfTheCriterion) {
  const data::Case problem = flat_case();
  const auto margin = studies::band_margin(problem, {25.0, 25.0});
  const auto criterion =
      analytic::evaluate_criterion(problem.beam, problem.friction, problem.excitation, 10.0);
  const double expected = criterion.critical_amplitude.midpoint() / 1e-3;
  EXPECT_TRUE(within(margin.margin.midpoint(), expected, reference(2e-9 * expected, "bounds of |f_max|")));
  EXPECT_TRUE(within(margin.force_max.midpoint(), criterion.force_max.midpoint(),
                     reference(2e-9 * criterion.force_max.midpoint(), "bounds of |f_max|")));
  EXPECT_EQ(margin.friction_limit, criterion.friction_limit);
  EXPECT_DOUBLE_EQ(margin.margin.lower * margin.force_max.upper, margin.friction_limit);
  EXPECT_DOUBLE_EQ(margin.margin.upper * margin.force_max.lower, margin.friction_limit);
  EXPECT_EQ(margin.evaluations, 1);
  EXPECT_EQ(margin.frequency_hz, 25.0);
  EXPECT_TRUE(margin.resonances.empty());
}

TEST(BandMargin, HasTheNaturalFrequenciesOfTheBand) {
  const data::Case problem = flat_case();
  const auto modes = analytic::stick_modes(problem.beam, 3);
  const auto margin = studies::band_margin(problem, {1.0, 40.0});
  ASSERT_EQ(margin.resonances.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(margin.resonances[i].mode, static_cast<int>(i) + 1);
    EXPECT_EQ(margin.resonances[i].frequency_hz, modes[i].frequency_hz());
    const auto here = studies::band_margin(problem, {modes[i].frequency_hz(), modes[i].frequency_hz()});
    EXPECT_LE(margin.margin.lower, here.margin.upper);
    EXPECT_EQ(here.resonances.size(), 1u);
  }
  const auto nearest = std::ranges::min(margin.resonances, {}, [&](const auto& resonance) {
    return std::abs(resonance.frequency_hz - margin.frequency_hz);
  });
  EXPECT_TRUE(within(margin.frequency_hz, nearest.frequency_hz,
                     discretisation(1.0 / 10.0, 1.0, "width of a resonance, one over the duration")));
}

TEST(BandMargin, RefusesWhatHasNone) {
  const data::Case problem = flat_case();
  const FrequencyBand band{20.0, 30.0};
  EXPECT_THROW((void)studies::band_margin(with_value(problem, "excitation.amplitude", 0.0), band),
               data::FieldError);
  EXPECT_THROW((void)studies::band_margin(with_value(problem, "friction.static_coefficient", 0.0), band),
               data::FieldError);
  EXPECT_THROW((void)studies::band_margin(with_value(problem, "beam.axial_force", 0.0), band),
               data::InputError);
  EXPECT_THROW((void)studies::band_margin(problem, {30.0, 20.0}), std::invalid_argument);
}

STICKSLIP_VERIFIES(DesignScan, "X15");
TEST(DesignScan, AvoidsTheTwoLengthsOfFigure14) {
  const data::Case problem = flat_case();
  const auto scan = studies::design_scan(problem, "beam.length", {0.4, 2.0}, {25.0, 25.0});
  expect_to_tile(scan, 0.4, 2.0);
  EXPECT_DOUBLE_EQ(scan.accuracy, 2e-5);
  ASSERT_EQ(scan.intervals.size(), 5u);
  for (const int mode : {1, 2}) {
    const double resonance = *studies::resonance_length(problem.beam, mode, 25.0);
    EXPECT_TRUE(within(resonance, mode == 1 ? 0.879 : 1.578, reference(5e-4, "three digits as printed")));
    const DesignInterval& avoided = interval_at(scan, resonance);
    EXPECT_FALSE(avoided.sticks);
    EXPECT_EQ(avoided.resonances, std::vector<int>{mode});
    EXPECT_LT(avoided.to - avoided.from, 0.06);
  }
  expect_ends_of_the_criterion(problem, scan, 25.0);
  expect_verdicts_of_the_criterion(problem, scan, 400);
}

TEST(DesignScan, FindsTheEndsOfAxialForcesAndTheBucklingLoad) {
  const data::Case problem = flat_case();
  const auto scan = studies::design_scan(problem, "beam.axial_force", {20.0, 3000.0}, {25.0, 25.0});
  expect_to_tile(scan, 20.0, 3000.0);
  EXPECT_FALSE(scan.intervals.front().sticks);
  EXPECT_TRUE(scan.intervals.back().buckled);
  const double load = studies::buckling_value(problem, "beam.axial_force");
  EXPECT_EQ(load, analytic::stick_buckling_load(problem.beam));
  EXPECT_TRUE(within(scan.intervals.back().from, load, reference(2e-6 * load, "resolution of the scan")));
  expect_ends_of_the_criterion(problem, scan, 25.0);
}

// The largest force over the band changes by 3e-4 for each newton of P, so that little of it moves the end far.
TEST(DesignScan, EndsOfABandAreAsAccurateAsStated) {
  const data::Case problem = data::load_case("paper");
  const FrequencyBand band{26.0, 40.0};
  const auto scan = studies::design_scan(problem, "beam.axial_force", {1600.0, 1800.0}, band);
  ASSERT_EQ(scan.intervals.size(), 2u);
  const double end = scan.intervals.back().from;
  const auto margin = [&](double force) {
    return studies::band_margin(with_value(problem, "beam.axial_force", force), band, 1e-7).margin;
  };
  EXPECT_GE(margin(end).lower, 1.0) << end;
  EXPECT_LT(margin(end - scan.accuracy).upper, 1.0) << end;
}

TEST(DesignScan, FindsAResonanceFarNarrowerThanItsSpacing) {
  // At 30 um the tip slips only next to resonance, over less than 1 % of the length.
  const data::Case problem = with_value(flat_case(), "excitation.amplitude", 3e-5);
  const auto scan = studies::design_scan(problem, "beam.length", {0.4, 1.3}, {25.0, 25.0});
  ASSERT_EQ(scan.intervals.size(), 3u);
  const DesignInterval& avoided = scan.intervals[1];
  const double resonance = *studies::resonance_length(problem.beam, 1, 25.0);
  EXPECT_LT(avoided.from, resonance);
  EXPECT_GT(avoided.to, resonance);
  EXPECT_LT(avoided.to - avoided.from, 0.005 * resonance);
  expect_ends_of_the_criterion(problem, scan, 25.0);
}

TEST(DesignScan, FindsAPeakBetweenTheValuesOfItsGrid) {
  // Over a few periods the peak is wide and stands beside the resonance; an amplitude of 0.05 % over what it
  // takes leaves a part of that width only.
  for (const double duration : {0.15, 0.2, 0.25, 0.3, 0.4}) {
    const data::Case problem = with_value(flat_case(), "excitation.duration", duration);
    const auto critical_amplitude = [&](double length) {
      const data::Case there = with_value(problem, "beam.length", length);
      return 1e-3 * studies::band_margin(there, {25.0, 25.0}).margin.upper;
    };
    double least = critical_amplitude(0.8), worst = 0.8;
    for (double length = 0.8; length < 1.0; length += 1e-4)
      if (const double critical = critical_amplitude(length); critical < least)
        std::tie(least, worst) = std::pair(critical, length);
    const auto scan = studies::design_scan(with_value(problem, "excitation.amplitude", 1.0005 * least),
                                           "beam.length", {0.8, 1.0}, {25.0, 25.0});
    EXPECT_FALSE(interval_at(scan, worst).sticks) << duration;
  }
}

TEST(DesignScan, HoldsThroughoutABand) {
  const data::Case problem = with_value(flat_case(), "excitation.duration", 3.0);
  const FrequencyBand band{22.0, 27.0};
  const auto scan = studies::design_scan(problem, "beam.length", {0.7, 1.7}, band);
  expect_to_tile(scan, 0.7, 1.7);
  for (const int mode : {1, 2})
    for (const double hz : {22.1, 24.0, 26.9}) {
      const DesignInterval& avoided = interval_at(scan, *studies::resonance_length(problem.beam, mode, hz));
      EXPECT_FALSE(avoided.sticks);
      EXPECT_EQ(avoided.resonances, std::vector<int>{mode});
    }
  for (const DesignInterval& interval : scan.intervals)
    for (int i = 0; i <= 10; ++i) {
      const double length = std::lerp(interval.from, interval.to, i / 10.0);
      const data::Case there = with_value(problem, "beam.length", length);
      if (interval.sticks) {
        EXPECT_TRUE(sticks_on_a_grid(there, band, 51)) << length;
      } else if (0 < i && i < 10) {
        EXPECT_LT(studies::band_margin(there, band, 1e-3).margin.lower, 1.0) << length;
      }
    }
}

// The tip slips before a natural frequency enters the band, and the label begins where it does.
TEST(DesignScan, NamesANaturalFrequencyOnlyWhereItIsInTheBand) {
  const FrequencyBand band{25.0, 28.0};
  const auto scan = studies::design_scan(flat_case(), "beam.length", {0.6, 1.1}, band);
  int named = 0;
  for (const DesignInterval& interval : scan.intervals) {
    const double middle = 0.5 * (interval.from + interval.to);
    const double hz =
        analytic::stick_modes(with_value(flat_case(), "beam.length", middle).beam, 1).front().frequency_hz();
    const bool inside = band.from_hz < hz && hz < band.to_hz;
    if (!interval.sticks) {
      EXPECT_EQ(interval.resonances, inside ? std::vector<int>{1} : std::vector<int>{}) << middle;
    }
    named += inside ? 1 : 0;
  }
  EXPECT_EQ(named, 1);
  EXPECT_EQ(scan.intervals.size(), 5u);  // sticks, slips, slips in resonance, slips, sticks
}

// With damping a beam may stick at its natural frequencies. The margins are those of the criterion and of the steady force.
TEST(DesignScan, OfADampedBeamHasBothMargins) {
  data::Case problem = with_value(flat_case(), "excitation.amplitude", 2e-5);
  const FrequencyBand band{15.0, 40.0};
  for (const data::Damping& damping :
       {data::Damping({.ratio = 0.03}), data::Damping({.kelvin_voigt = 3e-4})}) {
    problem.damping = damping;
    const auto margin = studies::band_margin(problem, band);
    EXPECT_FALSE(margin.resonances.empty());
    for (const analytic::Bounds& bounds : {margin.margin, margin.steady_margin}) {
      EXPECT_GE(bounds.upper, bounds.lower);
      EXPECT_LE(bounds.upper / bounds.lower, 1.0 + 2e-6);
    }
    double least = margin.margin.upper, least_steady = margin.steady_margin.upper;
    const auto reaction = analytic::damped_reaction(problem.beam, damping, 10);
    for (int i = 0; i <= 2500; ++i) {
      const double omega = 2.0 * std::numbers::pi * std::lerp(band.from_hz, band.to_hz, i / 2500.0);
      const analytic::DampedForce force(reaction, omega, 10.0);
      least = std::min(least, 300.0 / (2e-5 * force.refined_to(1e-6).lower));
      least_steady = std::min(least_steady, 300.0 / (2e-5 * force.steady_amplitude()));
    }
    EXPECT_GE(least, margin.margin.lower);
    EXPECT_GE(least_steady, margin.steady_margin.lower);
    const auto at_worst = with_value(problem, "excitation.frequency_hz", margin.frequency_hz);
    const auto criterion = studies::criterion_of(at_worst, 1e-9);
    EXPECT_NEAR(margin.margin.upper * criterion.force_max.midpoint(), 300.0, 300.0 * 1e-6);
    // 0.02 Hz beside the worst of a resonance that is 1 Hz wide.
    EXPECT_NEAR(least_steady, margin.steady_margin.lower, 1e-3 * least_steady);
    EXPECT_GT(margin.steady_margin.lower, margin.margin.lower);
  }
}

TEST(DesignScan, OfADampedBeamIsThatOfTheCriterion) {
  data::Case problem = with_value(flat_case(), "excitation.amplitude", 1e-3);
  problem.damping = data::Damping({.ratio = 0.02});
  const auto scan = studies::design_scan(problem, "beam.length", {0.7, 1.2}, {25.0, 25.0});
  expect_to_tile(scan, 0.7, 1.2);
  ASSERT_GE(scan.intervals.size(), 3u);
  expect_verdicts_of_the_criterion(problem, scan, 200);
}

TEST(DesignScan, OfALengthOverBucklingSaysSo) {
  const data::Case problem = flat_case();
  const double longest = studies::buckling_value(problem, "beam.length");
  EXPECT_TRUE(within(analytic::stick_buckling_load(flat_beam(longest, 0.0)), 500.0, round_off(10, 2, 500.0)));
  const auto scan = studies::design_scan(problem, "beam.length", {longest, 2.0 * longest}, {25.0, 25.0});
  ASSERT_EQ(scan.intervals.size(), 1u);
  expect_to_tile(scan, longest, 2.0 * longest);
  EXPECT_TRUE(scan.intervals.front().buckled);
  EXPECT_FALSE(scan.intervals.front().sticks);
  const auto range = [&](double to) {
    return studies::range_below_buckling(problem, "beam.length", 0.4, to);
  };
  EXPECT_EQ(range(2.0 * longest).lower, 0.4);
  EXPECT_DOUBLE_EQ(range(2.0 * longest).upper, 0.999 * longest);
  EXPECT_EQ(range(0.9 * longest).upper, 0.9 * longest);
  EXPECT_THROW((void)studies::buckling_value(with_value(problem, "beam.axial_force", 0.0), "beam.length"),
               data::InputError);
}

TEST(DesignScan, RefusesAnotherParameterAndARangeThatFalls) {
  const data::Case problem = flat_case();
  EXPECT_THROW((void)studies::design_scan(problem, "excitation.frequency_hz", {1.0, 2.0}, {25.0, 25.0}),
               std::invalid_argument);
  for (const auto& range : {analytic::Bounds{2.0, 1.0}, {1.0, 1.0}, {0.0, 1.0}})
    EXPECT_TRUE(error_message_of<data::FieldError>([&] {
                  (void)studies::design_scan(problem, "beam.length", range, {25.0, 25.0});
                }).ends_with("from a number above 0 to a larger one"));
}

}  // namespace
}  // namespace stickslip::testing
