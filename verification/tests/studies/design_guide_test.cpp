// SPDX-License-Identifier: MIT
/// The margin to slipping over a band of frequencies, and the lengths and axial forces that keep it.

#include "studies/analyses/design_guide.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/problem_parameter.hpp"
#include "support/random_cases.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::FrequencyBand;
using studies::design_scan;
using studies::DesignInterval;
using studies::DesignScan;

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

// The margin of the case with one number changed, by the criterion at each of a few frequencies of the band.
double margin_on_a_grid(const data::Case& problem, const FrequencyBand& band) {
  double least = std::numeric_limits<double>::infinity();
  const int count = band.from_hz < band.to_hz ? 11 : 1;
  for (int i = 0; i < count; ++i) {
    const double hz = std::lerp(band.from_hz, band.to_hz, i / std::max(1.0, count - 1.0));
    const auto criterion = analytic::evaluate_criterion(with_value(problem, "excitation.frequency_hz", hz));
    least = std::min(least, criterion.friction_limit / criterion.force_max.midpoint());
  }
  return least;
}

STICKSLIP_VERIFIES(BandMargin, "X15");
TEST(BandMargin, HasTheNaturalFrequenciesOfTheBand) {
  const data::Case problem = flat_case();
  const auto modes = analytic::stick_modes(problem.beam(), 3);
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

// Bounds of the margin of a band that are as narrow as its decisions.
analytic::Bounds margin_over(const data::Case& problem, const FrequencyBand& band) {
  return studies::band_margin(problem, band, 1e-6).margin;
}

// The criterion sticks in what sticks and, somewhere in the band, slips in what slips; between the two it sticks at the end itself and
// slips within the accuracy behind it. Forces within 1e-6 of the limit count as slipping.
void expect_scan(const data::Case& problem, const DesignScan& scan, const FrequencyBand& band) {
  const auto at = [&](double value) { return with_value(problem, scan.parameter, value); };
  for (std::size_t i = 0; i < scan.intervals.size(); ++i) {
    const DesignInterval& interval = scan.intervals[i];
    SCOPED_TRACE(fmt::format("{} ... {}", interval.from, interval.to));
    if (interval.buckled) continue;
    for (int k = 0; k < 8; ++k) {
      const double value = std::lerp(interval.from, interval.to, (k + 0.5) / 8.0);
      if (interval.sticks)
        EXPECT_GE(margin_on_a_grid(at(value), band), 1.0 - 1e-9) << value;
      else
        EXPECT_LT(margin_over(at(value), band).lower, 1.0 + 2e-6) << value;
    }
    if (i == 0 || interval.sticks == scan.intervals[i - 1].sticks) continue;
    const double inwards = interval.sticks ? 1.0 : -1.0;
    EXPECT_GE(margin_over(at(interval.from), band).upper, 1.0);
    EXPECT_LT(margin_over(at(interval.from - inwards * scan.accuracy), band).lower, 1.0 + 2e-6);
  }
}

STICKSLIP_VERIFIES(DesignScan, "X15");
TEST(DesignScan, HoldsWhatTheCriterionSays) {
  int ends = 0;
  const CaseDomain domain{.lowest_load = 0.5,
                          .shortest = 1.0,
                          .longest = 10.0,
                          .lowest_frequency = 0.5,
                          .highest_frequency = 2.0,
                          .kelvin_voigt = 0.2,
                          .ratio = 0.2,
                          .resonant = 0.2};
  on_random_cases(10, domain, [&](const CaseText& text, RandomNumbers& numbers) {
    const data::Case drawn = with_value(text.problem(), "numerics.modes", numbers.whole(2, 10));
    const auto key_of_amplitude = data::amplitude_keys.at(static_cast<std::size_t>(numbers.whole(0, 2)));
    const double hz = numbers.uniform(0.9, 1.0) * drawn.excitation().frequency_hz(),
                 amplitude = value_of(drawn, key_of_amplitude);
    const FrequencyBand band{hz, numbers.whole(0, 1) == 0 ? hz : hz * numbers.uniform(1.001, 1.1)};
    const double margin = margin_over(with_value(drawn, key_of_amplitude, amplitude), band).upper;
    const data::Case problem =
        with_value(drawn, key_of_amplitude, amplitude * margin * numbers.uniform(0.8, 1.25));
    for (const auto key : {"beam.length", "beam.axial_force"}) {
      const double value = value_of(problem, key);
      const auto scan = design_scan(problem, key, {0.9 * value, 1.1 * value}, band);
      SCOPED_TRACE(fmt::format("{} {} ... {} Hz", key, band.from_hz, band.to_hz));
      expect_to_tile(scan, 0.9 * value, 1.1 * value);
      EXPECT_DOUBLE_EQ(scan.accuracy, 1.1e-5 * value);
      expect_scan(problem, scan, band);
      ends += static_cast<int>(scan.intervals.size()) - 1;
    }
  });
  EXPECT_GT(ends, 10);
}

TEST(DesignScan, AvoidsTheTwoLengthsOfFigure14) {
  const data::Case problem = flat_case();
  const auto scan = design_scan(problem, "beam.length", {0.4, 2.0}, {25.0, 25.0});
  expect_to_tile(scan, 0.4, 2.0);
  EXPECT_DOUBLE_EQ(scan.accuracy, 2e-5);
  ASSERT_EQ(scan.intervals.size(), 5u);
  for (const int mode : {1, 2}) {
    const double resonance = *studies::resonance_length(problem.beam(), mode, 25.0);
    EXPECT_TRUE(within(resonance, mode == 1 ? 0.879 : 1.578, reference(5e-4, "three digits as printed")));
    const DesignInterval& avoided = interval_at(scan, resonance);
    EXPECT_FALSE(avoided.sticks);
    EXPECT_EQ(avoided.resonances, std::vector<int>{mode});
    EXPECT_LT(avoided.to - avoided.from, 0.06);
  }
  expect_scan(problem, scan, {25.0, 25.0});
}

// The largest force over the band changes by 3e-4 for each newton of P, so that little of it moves the end far.
TEST(DesignScan, EndsOfABandAreAsAccurateAsStated) {
  const data::Case problem = data::load_case("paper");
  const FrequencyBand band{26.0, 40.0};
  const auto scan = design_scan(problem, "beam.axial_force", {1600.0, 1800.0}, band);
  ASSERT_EQ(scan.intervals.size(), 2u);
  const double end = scan.intervals.back().from;
  const auto margin = [&](double force) {
    return studies::band_margin(with_value(problem, "beam.axial_force", force), band, 1e-7).margin;
  };
  EXPECT_GE(margin(end).lower, 1.0) << end;
  EXPECT_LT(margin(end - scan.accuracy).upper, 1.0) << end;
}

// Over a few periods a peak is wide and stands beside the resonance, over many it is far narrower than the spacing of the values. An
// amplitude of 0.05 % over what the peak takes leaves a part of its width only.
TEST(DesignScan, FindsAPeakBetweenItsValues) {
  const CaseDomain domain{.lowest_force = 0.05,
                          .highest_force = 0.5,
                          .shortest = 3.0,
                          .longest = 200.0,
                          .lowest_frequency = 1.0,
                          .highest_frequency = 1.5,
                          .kelvin_voigt = 0.15,
                          .ratio = 0.15};
  on_random_cases(16, domain, [](const CaseText& text, RandomNumbers&) {
    // In units in which times are large.
    const data::Case problem =
        in_units(Units{.time = 1024.0}, with_value(text.problem(), "numerics.modes", 4));
    const double hz = problem.excitation().frequency_hz(),
                 resonance = studies::resonance_length(problem.beam(), 1, hz).value(),
                 amplitude = problem.excitation().amplitude();
    double least = std::numeric_limits<double>::infinity(), worst = 0.0;
    for (int i = 0; i <= 400; ++i) {
      const double length = resonance * std::lerp(0.9, 1.1, i / 400.0),
                   margin = margin_on_a_grid(with_value(problem, "beam.length", length), {hz, hz});
      if (margin < least) std::tie(least, worst) = std::pair(margin, length);
    }
    const data::Case shaken = with_value(problem, "excitation.amplitude", 1.0005 * least * amplitude);
    const auto scan = design_scan(shaken, "beam.length", {0.9 * resonance, 1.1 * resonance}, {hz, hz});
    EXPECT_FALSE(interval_at(scan, worst).sticks) << worst;
  });
}

// Once the free vibrations have gone, however long it is after that.
TEST(DesignScan, OfADampedBeamSettles) {
  const auto scan_of = [](double duration) {
    return design_scan(with_values(flat_case(), {{"damping.ratio", 0.01}, {"excitation.duration", duration}}),
                       "beam.length", {0.7, 1.2}, {25.0, 25.0});
  };
  const auto soon = scan_of(40.0), late = scan_of(4e4);
  ASSERT_EQ(soon.intervals.size(), 3u);
  ASSERT_EQ(late.intervals.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(late.intervals[i].sticks, soon.intervals[i].sticks);
    EXPECT_TRUE(within(late.intervals[i].to, soon.intervals[i].to, reference(soon.accuracy, "the ends")));
  }
}

// The tip slips before a natural frequency enters the band, and the label begins where it does.
TEST(DesignScan, NamesFrequenciesOfTheBandOnly) {
  const FrequencyBand band{25.0, 28.0};
  const auto scan = design_scan(flat_case(), "beam.length", {0.6, 1.1}, band);
  int named = 0;
  for (const DesignInterval& interval : scan.intervals) {
    const double middle = 0.5 * (interval.from + interval.to);
    const double hz = analytic::stick_modes(with_value(flat_case(), "beam.length", middle).beam(), 1)
                          .front()
                          .frequency_hz();
    const bool inside = band.from_hz < hz && hz < band.to_hz;
    if (!interval.sticks) {
      EXPECT_EQ(interval.resonances, inside ? std::vector<int>{1} : std::vector<int>{}) << middle;
    }
    named += inside ? 1 : 0;
  }
  EXPECT_EQ(named, 1);
  EXPECT_EQ(scan.intervals.size(), 5u);  // sticks, slips, slips in resonance, slips, sticks
}

TEST(DesignScan, OfALengthOverBucklingSaysSo) {
  const data::Case problem = flat_case();
  const double longest = studies::buckling_value(problem, "beam.length");
  EXPECT_TRUE(within(analytic::stick_buckling_load(flat_beam(longest, 0.0)), 500.0, round_off(10, 2, 500.0)));
  const auto scan = design_scan(problem, "beam.length", {longest, 2.0 * longest}, {25.0, 25.0});
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

TEST(DesignScan, RefusesAFallingRange) {
  const data::Case problem = flat_case();
  EXPECT_THROW((void)design_scan(problem, "excitation.frequency_hz", {1.0, 2.0}, {25.0, 25.0}),
               std::invalid_argument);
  for (const auto& range : {analytic::Bounds{2.0, 1.0}, {1.0, 1.0}, {0.0, 1.0}})
    EXPECT_TRUE(error_message_of<data::FieldError>([&] {
                  (void)design_scan(problem, "beam.length", range, {25.0, 25.0});
                }).ends_with("from a number above 0 to a larger one"));
}

}  // namespace
}  // namespace stickslip::testing
