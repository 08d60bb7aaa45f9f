// SPDX-License-Identifier: MIT
/// The fast search for |f_max| against the plain one, samples and itself, the table of modes against the modes, and the
/// criterion that compares |f_max| with the friction limit.

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::evaluate_criterion;
using analytic::ForceMaximum;
using analytic::ModalReactionTable;
using analytic::SteadyPart;
using analytic::StickResponse;
using std::numbers::pi;

ForceMaximum search_at(double hz, double duration) {
  const StickResponse response(paper_beam(), shaking(hz, 1.0), 10);
  return ForceMaximum(response.reaction(), 2.0 * pi * hz, duration);
}

// Off resonance, in it to the last bit, and so near that the beat is as long as the run or a thousandth of
// it.
std::vector<double> telling_frequencies() {
  const double resonance = analytic::stick_modes(paper_beam(), 1).front().frequency_hz();
  std::vector<double> all{0.3, 7.0, 35.0, 90.0, 400.0};
  for (const double detuning : {0.0, 1e-9, 1e-4, 0.031, 0.032, 0.05, 0.5, -0.0315})
    all.push_back(resonance + detuning);
  return all;
}

// Of samples 40 us apart, and at each of their peaks that may be the highest a ternary search, in steps of (2/3)^60 h.
// Between samples |f| exceeds them by at most (w h)^2/8 = 0.13 % at 400 Hz.
double largest_of_samples(const ForceMaximum& search, double duration) {
  const auto count = static_cast<std::size_t>(std::llround(duration / 40e-6));
  const auto size_at = [&](double t) { return std::abs(search.value(t)); };
  const double h = duration / static_cast<double>(count);
  std::vector<double> sizes;
  double largest = 0.0;
  for (std::size_t i = 0; i <= count; ++i)
    largest = largest_or_nan({largest, sizes.emplace_back(size_at(h * static_cast<double>(i)))});
  const double candidate = 0.99 * largest;
  for (std::size_t i = 1; i < count; ++i) {
    if (sizes[i] < std::max({candidate, sizes[i - 1], sizes[i + 1]})) continue;
    double from = h * static_cast<double>(i - 1), to = h * static_cast<double>(i + 1);
    for (int step = 0; step < 60; ++step) {
      const double third = (to - from) / 3.0;
      const bool rises = size_at(from + third) < size_at(to - third);
      (rises ? from : to) += rises ? third : -third;
    }
    largest = std::max(largest, size_at(0.5 * (from + to)));
  }
  return largest;
}

STICKSLIP_VERIFIES(ForceMaximum, "A5");
TEST(ForceMaximum, EnclosesTheMaximumOfSamplesAndNoMore) {
  for (const double hz : telling_frequencies()) {
    const double duration =
        hz == 35.0 || hz == 90.0 ? 8.0 : 0.8;  // with many blocks of the grid, and with few
    const ForceMaximum search = search_at(hz, duration);
    const double largest = largest_of_samples(search, duration);
    for (const double width : {0.5, 1e-2, 1e-10, 1e-13}) {
      const Bounds bounds = search.refined_to(width);
      EXPECT_LE(bounds.upper - bounds.lower, width * bounds.lower + 3.0 * search.rounding());
      EXPECT_LE(largest, bounds.upper + search.rounding()) << hz << " Hz, " << width;
      EXPECT_LE(bounds.lower, largest + 3.0 * search.rounding()) << hz << " Hz, " << width;
    }
  }
}

TEST(ForceMaximum, ExceedsALimitExactlyIfItsLowerBoundDoes) {
  for (const double hz : telling_frequencies()) {
    const ForceMaximum search = search_at(hz, 2.0);
    const Bounds bounds = search.refined_to();
    for (const double share : {1e-3, 0.3, 0.9, 0.999, 1.0 - 1e-7, 1.0 - 1e-9})
      EXPECT_TRUE(search.exceeds(share * bounds.lower)) << hz << " Hz, " << share;
    for (const double share : {1.0 + 1e-9, 1.0 + 1e-7, 1.001, 1.1, 3.0, 1e6})
      EXPECT_FALSE(search.exceeds(share * bounds.upper)) << hz << " Hz, " << share;
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

STICKSLIP_VERIFIES(Criterion, "A6");
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

// --- The largest force over a band of frequencies

using analytic::BandMaximum;
using analytic::FrequencyBand;

Bounds force_at(double hz, double duration) {
  const data::HarmonicExcitation unit({.frequency_hz = hz, .amplitude = 1.0});
  return analytic::StickResponse(paper_beam(), unit).max_abs_friction_force(duration);
}

// A bound of |d^2 f/dOmega^2| over 0 ... duration and up to `hz`, by Duhamel's integral for every mode.
double curvature_bound(double hz, double duration) {
  const double omega = 2.0 * pi * hz, t = duration;
  const double stiffness = 2e9 * 1e-4 / 12.0;
  double bound = stiffness * std::abs(analytic::QuasiStaticShape(paper_beam()).third_derivative(2.0)) * t * t;
  for (const auto& mode : analytic::stick_modes(paper_beam(), 10))
    bound += stiffness * std::abs(mode.third_derivative(2.0) * mode.participation()) *
             (2.0 * t + 2.0 * omega * t * t + omega * omega * t * t * t / 3.0) / mode.angular_frequency();
  return bound;
}

STICKSLIP_VERIFIES(BandMaximum, "X15");
TEST(BandMaximum, EnclosesTheMaximumOfAFineGrid) {
  constexpr double duration = 0.5, grid_error = 0.02;
  for (const FrequencyBand band :
       {FrequencyBand{20.0, 30.0}, {30.0, 40.0}, {24.9, 25.1}, {60.0, 75.0}, {3.0, 9.0}}) {
    BandMaximum search(paper_beam(), band, duration);
    const Bounds bounds = search.refined_to(1e-6);
    EXPECT_LE(bounds.lower, bounds.upper);
    EXPECT_LE(bounds.upper - bounds.lower, 1e-6 * bounds.lower);

    const double curvature = curvature_bound(band.to_hz, duration);
    const double finest = std::sqrt(8.0 * grid_error * bounds.lower / curvature) / (2.0 * pi);
    const int steps = static_cast<int>(std::ceil((band.to_hz - band.from_hz) / finest));
    double largest = 0.0;
    for (int i = 0; i <= steps; ++i)
      largest =
          std::max(largest, force_at(std::lerp(band.from_hz, band.to_hz, double(i) / steps), duration).lower);
    const double where = force_at(search.frequency_hz(), duration).midpoint();
    EXPECT_TRUE(within(where, bounds.lower, reference(1e-8 * where, "bounds of |f_max|")));
    EXPECT_GE(bounds.upper, largest) << band.from_hz;
    EXPECT_LE(bounds.lower, largest + grid_error * bounds.lower) << band.from_hz;
  }
}

TEST(BandMaximum, UpperBoundHoldsBetweenTheFrequenciesEvaluated) {
  // Bounds as wide as these come of few frequencies and rest on what is derived of the force between them.
  for (const double duration : {1.0, 10.0})
    for (const double middle : {5.0, 20.0, 24.7, 24.972, 25.1, 38.0, 80.9, 81.2, 110.0})
      for (const double width : {0.3 / duration, 1.0 / duration}) {
        const FrequencyBand band{middle - 0.5 * width, middle + 0.5 * width};
        const Bounds bounds = BandMaximum(paper_beam(), band, duration).refined_to(0.9);
        for (int i = 0; i <= 20; ++i) {
          const double hz = std::lerp(band.from_hz, band.to_hz, i / 20.0);
          EXPECT_LE(force_at(hz, duration).lower, bounds.upper) << hz << " Hz, " << duration << " s";
        }
      }
}

TEST(BandMaximum, LooksNoFurtherThanALimitAsks) {
  BandMaximum full(paper_beam(), {26.0, 60.0}, 10.0);
  const double largest = full.refined_to(1e-6).midpoint();
  for (const double share : {0.5, 0.9, 1.1, 2.0}) {
    BandMaximum search(paper_beam(), {26.0, 60.0}, 10.0);
    const Bounds bounds = search.refined_against(share * largest, 1e-6);
    if (share < 1.0)
      EXPECT_GT(bounds.lower, share * largest);
    else
      EXPECT_LE(bounds.upper, share * largest);
    EXPECT_LT(search.evaluations(), full.evaluations()) << share;
    EXPECT_TRUE(within(search.refined_to(1e-6).midpoint(), largest,
                       reference(1e-6 * largest, "half of the relative widths of two bounds")));
  }
}

// On both sides of the largest force, which is at an end (30 to 32 Hz), at a natural frequency (24 to 26 Hz) or, 0.9 %
// above all of these, between them (49.8 to 50.1 Hz). exceeds() may err by 1e-4 and the largest force by 1e-5.
TEST(BandMaximum, DecidesAsItsBoundsDo) {
  for (const FrequencyBand& band : {FrequencyBand{30.0, 32.0}, FrequencyBand{24.0, 26.0},
                                    FrequencyBand{49.8, 50.1}, FrequencyBand{60.0, 60.0}}) {
    BandMaximum search(paper_beam(), band, 10.0);
    const double largest = search.refined_to(1e-5).midpoint();
    for (const double share : {0.3, 0.9, 0.99, 0.9998, 1.0002, 1.01, 1.03, 1.1, 2.0})
      EXPECT_EQ(BandMaximum(paper_beam(), band, 10.0).exceeds(share * largest), share < 1.0) << share;
  }
}

TEST(BandMaximum, BoundsOfOneModeAreSumsOfSuprema) {
  // f = A sin(Omega t) - B sin(omega_1 t) with A = F + c p and B = c p Omega/omega_1, p = Omega^2/(Omega^2 -
  // omega_1^2): |f| <= |A| + |B| and |f_OmegaOmega| <= T^2 |A| + 2 T |A'| + |A''| + |B''|. Derivatives by
  // central differences, off by (h/(Omega - omega_1))^2 and by round-off eps/h^2.
  const analytic::ModalForce mode = analytic::modal_forces(paper_beam(), 1).front();
  const double base = paper_beam().youngs_modulus() * paper_beam().second_moment_of_area() *
                      analytic::QuasiStaticShape(paper_beam()).third_derivative(paper_beam().length());
  const double natural = mode.angular_frequency, c = mode.coefficient;
  const auto share = [&](double omega) { return omega * omega / ((omega - natural) * (omega + natural)); };
  const auto steady = [&](double omega) { return base + c * share(omega); };
  const auto free = [&](double omega) { return c * share(omega) * omega / natural; };
  for (const double ratio : {0.3, 0.8, 1.5, 3.0})
    for (const double periods : {4.0, 10.0}) {  // so long that no bound of a mode in the interval is nearer
      const double omega = ratio * natural, duration = periods * 2.0 * pi / natural;
      const double h = 1e-3 * std::abs(omega - natural);
      const auto slope = [h, omega](auto f) { return (f(omega + h) - f(omega - h)) / (2.0 * h); };
      const auto bend = [h, omega](auto f) {
        return (f(omega + h) - 2.0 * f(omega) + f(omega - h)) / (h * h);
      };
      const BandMaximum search(paper_beam(), {omega / (2.0 * pi), omega / (2.0 * pi)}, duration, 1);
      const auto suprema = search.between(omega, omega);
      const double force = std::abs(steady(omega)) + std::abs(free(omega));
      const double curvature = duration * duration * std::abs(steady(omega)) +
                               2.0 * duration * std::abs(slope(steady)) + std::abs(bend(steady)) +
                               std::abs(bend(free));
      EXPECT_TRUE(within(suprema.force, force, round_off(20, 1.0 / std::abs(1.0 - ratio), force)));
      EXPECT_TRUE(within(suprema.curvature, curvature,
                         discretisation(1e-6 * curvature, 2.0, "(h/(Omega - omega_1))^2")))
          << ratio << ", " << periods;
    }
}

TEST(BandMaximum, RefusesWhatIsNoBand) {
  EXPECT_THROW(BandMaximum(paper_beam(), {0.0, 1.0}, 1.0), std::invalid_argument);
  EXPECT_THROW(BandMaximum(paper_beam(), {2.0, 1.0}, 1.0), std::invalid_argument);
  EXPECT_THROW(BandMaximum(paper_beam(), {1.0, 2.0}, 0.0), std::invalid_argument);
  for (const double width : {0.0, 0.99e-7, 1.0})
    EXPECT_THROW((void)BandMaximum(paper_beam(), {1.0, 1.0}, 1.0).refined_to(width), std::invalid_argument);
  EXPECT_NO_THROW((void)BandMaximum(paper_beam(), {1.0, 1.0}, 1.0).refined_to(1e-7));
  EXPECT_THROW(BandMaximum(paper_beam_with_axial_force(1e6), {1.0, 2.0}, 1.0), data::InputError);
}

}  // namespace
}  // namespace stickslip::testing
