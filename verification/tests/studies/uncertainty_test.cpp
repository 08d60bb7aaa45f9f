// SPDX-License-Identifier: MIT
/// Samples, intervals and indices against closed forms, and the probability of slip where it has a closed form.

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <span>

#include "stickslip/analytic/stick_reaction.hpp"
#include "studies/analyses/design_guide.hpp"
#include "studies/analyses/slip_probability.hpp"
#include "studies/common/parallel.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::Distribution;
using data::DistributionKind;
using studies::Estimate;

Distribution normal(double mean, double deviation) {
  return {.kind = DistributionKind::normal, .mean = mean, .standard_deviation = deviation};
}
Distribution lognormal(double mean, double deviation) {
  return {.kind = DistributionKind::lognormal, .mean = mean, .standard_deviation = deviation};
}
Distribution uniform(double lower, double upper) {
  return {.kind = DistributionKind::uniform, .lower = lower, .upper = upper};
}

data::Uncertainty independent(std::vector<std::pair<std::string, Distribution>> keys) {
  data::Uncertainty result;
  for (const auto& [key, distribution] : keys) result.keys.push_back({key, distribution, ""});
  for (std::size_t i = 0; i < keys.size() * keys.size(); ++i)
    result.correlation.push_back(i % (keys.size() + 1) == 0 ? 1.0 : 0.0);
  return result;
}

// Four standard deviations of a share of n independent samples: one in 16000 is outside.
Tolerance sampling(double share, std::size_t count) {
  return {4.0 * std::sqrt(share * (1.0 - share) / static_cast<double>(count)), "discretisation",
          "four standard deviations of the binomial distribution"};
}

// The midpoint rule in p leaves out about z^2/n of the variance beyond its last point, z = 4.4.
STICKSLIP_VERIFIES(Quantiles, "Q1");
TEST(Quantiles, HaveTheMomentsOfTheirDistribution) {
  constexpr int count = 100000;
  const Distribution triangular{
      .kind = DistributionKind::triangular, .lower = 1.0, .mode = 1.5, .upper = 4.0};
  const Distribution samples{.kind = DistributionKind::samples, .samples = {1.0, 2.0, 4.0, 5.0}};
  for (const auto& [distribution, variance] : {std::pair{normal(3.0, 0.5), 0.25},
                                               {lognormal(3.0, 0.5), 0.25},
                                               {uniform(1.0, 4.0), 0.75},
                                               {triangular, (1.0 + 2.25 + 16.0 - 1.5 - 4.0 - 6.0) / 18.0},
                                               {samples, 2.5}}) {
    double mean = 0.0, square = 0.0;
    for (int i = 0; i < count; ++i) {
      const double x = studies::quantile(distribution, (i + 0.5) / count) - distribution.mean_value();
      mean += x / count;
      square += x * x / count;
    }
    const Tolerance tolerance{5e-4 * variance, "discretisation", "z^2/n of the tails"};
    EXPECT_TRUE(within(mean, 0.0, tolerance));
    EXPECT_TRUE(within(square, variance, tolerance));
  }
  EXPECT_EQ(studies::quantile(samples, 0.49), 2.0);
  EXPECT_EQ(studies::quantile(samples, 0.51), 4.0);
  EXPECT_EQ(studies::quantile(samples, 1.0), 5.0);
}

// The probability that the interval holds the truth, summed over all counts.
double coverage(double p, unsigned count) {
  double sum = 0.0;
  for (unsigned k = 0; k <= count; ++k) {
    const Estimate interval = studies::probability_of(k, count);
    if (interval.lower <= p && p <= interval.upper) sum += gsl_ran_binomial_pdf(k, p, count);
  }
  return sum;
}

STICKSLIP_VERIFIES(ConfidenceIntervals, "Q1");
TEST(ConfidenceIntervals, OfAProbabilityHoldIt) {
  for (const unsigned count : {1U, 10U, 200U})
    for (const double p : {1e-4, 0.003, 0.05, 0.5, 0.77, 0.999}) EXPECT_GE(coverage(p, count), 0.95) << p;
  EXPECT_LT(coverage(0.5, 200), 0.97);  // and not by being wide
  const Estimate none = studies::probability_of(0, 100);
  EXPECT_EQ(none.lower, 0.0);
  EXPECT_NEAR(none.upper, 1.0 - std::pow(0.025, 0.01), 1e-14);
  // One of a hundred: above 1 - (1 - p)^100 = 0.025. All but one: the mirror image.
  EXPECT_NEAR(studies::probability_of(1, 100).lower, 1.0 - std::pow(0.975, 0.01), 1e-14);
  EXPECT_NEAR(studies::probability_of(99, 100).upper, std::pow(0.975, 0.01), 1e-14);
  EXPECT_NEAR(studies::probability_of(100, 100).lower, std::pow(0.025, 0.01), 1e-14);
  EXPECT_EQ(studies::probability_of(100, 100).upper, 1.0);
}

// Of ranks: with x_i = i the interval says between which ranks the quantile lies.
TEST(ConfidenceIntervals, OfAQuantileHoldIt) {
  for (const unsigned count : {1U, 7U, 20U, 500U})  // 7 is below a power of two, where the search begins
    for (const double p : {0.05, 0.5, 0.95}) {
      std::vector<double> ranks(count);
      std::iota(ranks.begin(), ranks.end(), 1.0);
      const Estimate interval = studies::quantile_of(ranks, p);
      EXPECT_EQ(interval.value, std::floor(p * count) + 1.0);
      const auto missed = [&](double least, double most) {  // B < least or B >= most
        double sum = 0.0;
        for (unsigned b = 0; b <= count; ++b)
          if (b < least || b >= most) sum += gsl_ran_binomial_pdf(b, p, count);
        return sum;
      };
      EXPECT_LE(missed(interval.lower, interval.upper), 0.05) << count << ' ' << p;
      // One rank less on either side would miss more than 2.5 % there.
      EXPECT_TRUE(interval.lower == count ||
                  missed(std::max(interval.lower, 0.0) + 1.0, count + 1.0) > 0.025);
      EXPECT_TRUE(interval.upper < 2.0 ||
                  missed(0.0, std::min<double>(interval.upper, count + 1.0) - 1.0) > 0.025);
    }
}

// One point in each of n equal parts of every axis, whatever the scrambling, and in each quarter of a plane n/4.
STICKSLIP_VERIFIES(SobolPoints, "Q1");
TEST(SobolPoints, AreEvenlySpreadAndScrambledBySeed) {
  constexpr std::size_t dimensions = 40, count = 256;
  const auto points = studies::scrambled_sobol_points(dimensions, count, 7);
  for (std::size_t i = 0; i < dimensions; ++i) {
    std::vector<int> hits(count);
    for (std::size_t j = 0; j < count; ++j)
      ++hits[static_cast<std::size_t>(points[j * dimensions + i] * static_cast<double>(count))];
    EXPECT_TRUE(std::ranges::all_of(hits, [](int n) { return n == 1; })) << i;
  }
  int quarter = 0;
  for (std::size_t j = 0; j < count; ++j)
    quarter += points[j * dimensions] < 0.5 && points[j * dimensions + 1] < 0.5 ? 1 : 0;
  EXPECT_EQ(quarter, count / 4);
  EXPECT_EQ(points, studies::scrambled_sobol_points(dimensions, count, 7));
  const auto others = studies::scrambled_sobol_points(dimensions, count, 8);
  const auto digits = [](double x) { return static_cast<unsigned>(std::ldexp(x, 30)); };
  // A shift alone would leave the digits in which two points differ, no shift the origin as the first point.
  EXPECT_NE(digits(points[0]) ^ digits(points[dimensions]), digits(others[0]) ^ digits(others[dimensions]));
  EXPECT_GT(*std::max_element(points.begin(), points.begin() + dimensions), 0.5);
  EXPECT_TRUE(std::ranges::all_of(points, [](double x) { return std::fmod(std::ldexp(x, 31), 2.0) == 1.0; }));
  EXPECT_THROW((void)studies::scrambled_sobol_points(41, 2, 0), std::invalid_argument);
  EXPECT_THROW((void)studies::scrambled_sobol_points(2, 3, 0), std::invalid_argument);
  EXPECT_THROW((void)studies::scrambled_sobol_points(0, 2, 0), std::invalid_argument);
  EXPECT_THROW((void)studies::scrambled_sobol_points(1, 1U << 21U, 0), std::invalid_argument);
  EXPECT_EQ(studies::scrambled_sobol_points(1, 1U << 20U, 0).size(), 1U << 20U);
}

// Within 2.5 half-widths of the interval, which are 5.3 standard errors: one in 10000 with 15 degrees of freedom.
void expect_index(const Estimate& index, double expected) {
  EXPECT_TRUE(within(
      index.value, expected,
      {2.5 * (index.upper - index.value) + 1e-12, "discretisation", "Student's t of 16 replications"}));
  EXPECT_LT(index.upper - index.value, 0.03);
}

// Ishigami and Homma (1990), a = 7, b = 0.1.
STICKSLIP_VERIFIES(SobolIndices, "Q1");
TEST(SobolIndices, OfIshigamisFunctionAreExact) {
  constexpr double a = 7.0, b = 0.1;
  const auto model = [](std::span<const double> u) -> std::optional<double> {
    const auto x = [&](std::size_t i) { return std::numbers::pi * (2.0 * u[i] - 1.0); };
    return std::sin(x(0)) + a * std::pow(std::sin(x(1)), 2) + b * std::pow(x(2), 4) * std::sin(x(0));
  };
  const double pi4 = std::pow(std::numbers::pi, 4);
  const double first = 0.5 * std::pow(1.0 + b * pi4 / 5.0, 2), second = a * a / 8.0,
               both = 8.0 * b * b * pi4 * pi4 / 225.0, variance = first + second + both;
  const auto result = studies::sobol_indices(model, 3, 4096, 3);
  EXPECT_EQ(result.evaluations, 5u * 4096u);
  EXPECT_EQ(result.dropped, 0u);
  expect_index(result.indices[0].first, first / variance);
  expect_index(result.indices[0].total, (first + both) / variance);
  expect_index(result.indices[1].first, second / variance);
  expect_index(result.indices[1].total, second / variance);
  expect_index(result.indices[2].first, 0.0);
  expect_index(result.indices[2].total, both / variance);
  const studies::ScopedThreadCount three(3);
  const auto again = studies::sobol_indices(model, 3, 4096, 3);
  EXPECT_EQ(result.indices[1].first.value, again.indices[1].first.value);
  EXPECT_EQ(result.indices[1].total.upper, again.indices[1].total.upper);
}

// Of x_1 + 2 x_2 they are 1/5 and 4/5, of first order and in total.
TEST(SobolIndices, HaveIntervalsThatHoldThem) {
  const auto model = [](std::span<const double> u) { return std::optional(u[0] + 2.0 * u[1]); };
  constexpr std::size_t runs = 400;
  std::array<double, 4> held{};
  for (std::size_t seed = 1; seed <= runs; ++seed) {
    const auto result = studies::sobol_indices(model, 2, 16 * 32, seed);
    EXPECT_EQ(result.evaluations, 16u * 32u * 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& index = result.indices[i % 2];
      const Estimate& estimate = i < 2 ? index.first : index.total;
      const double exact = i % 2 == 0 ? 0.2 : 0.8;
      held[i] += estimate.lower <= exact && exact <= estimate.upper ? 1.0 : 0.0;
    }
  }
  for (const double times : held) EXPECT_TRUE(within(times / runs, 0.95, sampling(0.95, runs)));
}

TEST(SobolIndices, CountTheRowsThatHaveNoValue) {
  const auto model = [](std::span<const double> u) {
    return u[0] < 0.25 ? std::nullopt : std::optional(1.0);
  };
  const auto result = studies::sobol_indices(model, 1, 1024, 1);
  EXPECT_TRUE(within(static_cast<double>(result.dropped) / 1024.0, 1.0 - 0.75 * 0.75, sampling(0.44, 1024)));
  const auto undefined = [&](std::span<const double> u) { return std::optional(model(u).value_or(NAN)); };
  EXPECT_EQ(studies::sobol_indices(undefined, 1, 1024, 1).dropped, result.dropped);
  EXPECT_EQ(result.indices[0].total.value, 0.0);                                   // constant
  EXPECT_EQ(studies::sobol_indices(model, 20, 1, 1).evaluations, 16u * 4u * 22u);  // the fewest rows are four
  EXPECT_THROW((void)studies::sobol_indices(model, 21, 1024, 1), std::invalid_argument);
}

// x_1 - x_2 has the variance s_1^2 + s_2^2 - 2 rho s_1 s_2, whose estimate varies by sqrt(2/n).
STICKSLIP_VERIFIES(JointDistribution, "Q1");
TEST(JointDistribution, HasTheStatedCorrelation) {
  constexpr std::size_t count = 20000;
  auto uncertainty = independent({{"a", normal(1.0, 2.0)}, {"b", normal(3.0, 1.0)}});
  uncertainty.correlation = {1.0, 0.7, 0.7, 1.0};
  const studies::JointDistribution joint(uncertainty);
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = joint.at(studies::independent_point(5, i, 2));
    squares += std::pow(x[0] - x[1] + 2.0, 2) / count;
  }
  const double expected = 4.0 + 1.0 - 2.0 * 0.7 * 2.0;
  EXPECT_TRUE(
      within(squares, expected,
             {4.0 * expected * std::sqrt(2.0 / count), "discretisation", "four standard deviations"}));
  EXPECT_EQ(joint.at(std::vector{0.5, 0.5}), (std::vector{1.0, 3.0}));
  // By a separate program for SplitMix64, of which it gives the published numbers for the state 1234567.
  EXPECT_EQ(studies::independent_point(1, 6, 2), (std::vector{0x1.46251c43c5a90p-6, 0x1.6c19e9e91a144p-1}));
}

data::Case problem(double hz = 35.0) { return paper_problem(hz, 0.5e-3, 10.0); }

double force_per_metre(const data::Case& of) { return analytic::StickReaction(of).largest().midpoint(); }

// mu_c: the tip slips if the static coefficient is smaller.
double critical_coefficient(const data::Case& of) { return 0.5e-3 * force_per_metre(of) / 500.0; }

// A static coefficient with mean 0.55 and deviation 0.05, and the probability that the tip slips with it.
data::Uncertainty uncertain_coefficient() {
  return independent({{"friction.static_coefficient", normal(0.55, 0.05)}});
}
double probability_below(double coefficient, double deviation = 0.05) {
  return gsl_cdf_ugaussian_P((coefficient - 0.55) / deviation);
}

std::string refused_because(const data::Uncertainty& uncertainty,
                            const std::optional<analytic::FrequencyBand>& band = {}) {
  return error_message_of<data::InputError>(
      [&] { (void)studies::slip_uncertainty(problem(), uncertainty, {.samples = 100, .band = band}); });
}

// mu_s alone: A_c is proportional to it, and the tip slips below mu_c = A_0 |f_max|/(A_0 P).
STICKSLIP_VERIFIES(SlipProbability, "Q2");
TEST(SlipProbability, OfACoefficientIsExact) {
  data::Case of = problem();
  for (const data::Damping& damping : {data::Damping(), data::Damping({.kelvin_voigt = 6.4e-5})}) {
    of.damping = damping;
    const double critical = critical_coefficient(of), expected = probability_below(critical);
    const auto result = studies::slip_uncertainty(of, uncertain_coefficient(), {.samples = 20000, .seed = 2});
    EXPECT_TRUE(within(result.probability_of_slip.value, expected, sampling(expected, 20000)));
    EXPECT_EQ(result.valid, 20000u);
    EXPECT_TRUE(result.invalid.empty());
    EXPECT_NEAR(result.nominal_margin, 0.6 / critical, 1e-7);
    std::vector<double> probabilities;
    for (const auto& quantile : result.quantiles) probabilities.push_back(quantile.probability);
    EXPECT_EQ(probabilities, (std::vector{0.05, 0.25, 0.5, 0.75, 0.95}));
    for (const auto& [p, amplitude, margin] : result.quantiles) {
      const double share_below = probability_below(amplitude.value / 0.5e-3 * critical);
      EXPECT_TRUE(within(share_below, p, sampling(p, 20000)));
      EXPECT_LT(amplitude.lower, amplitude.value);
      EXPECT_LT(amplitude.value, amplitude.upper);
      EXPECT_NEAR(margin.value, amplitude.value / 0.5e-3, 1e-12);
    }
    const double off = 1.6448536269514722 * 0.05;
    EXPECT_NEAR(result.tornado[0].low, 0.55 - off, 1e-9);
    EXPECT_NEAR(result.tornado[0].high, 0.55 + off, 1e-9);
    EXPECT_NEAR(result.tornado[0].margin_low.value(), (0.55 - off) / critical, 1e-7);
    EXPECT_NEAR(result.tornado[0].margin_high.value(), (0.55 + off) / critical, 1e-7);
    EXPECT_EQ(result.sensitivity->evaluations, 4096u * 3u);
    expect_index(result.sensitivity->indices[0].total, 1.0);
    const double halved = probability_below(critical, 0.025);
    EXPECT_TRUE(within(result.probability_with_half_spread.value, halved, sampling(halved, 20000)));
  }
}

// Samples slip whose mu_s, per amplitude, is below that of all modes, which is another than that of ten modes. A Young's modulus
// that is uncertain by 1e-12 moves no verdict, but each sample has a force of its own then.
TEST(SlipProbability, OfAllModesHasFewSamples) {
  const auto with_amplitude = independent(
      {{"friction.static_coefficient", normal(0.55, 0.05)}, {"excitation.amplitude", uniform(4e-4, 6e-4)}});
  const auto with_a_force_each = independent({{"friction.static_coefficient", normal(0.55, 0.05)},
                                              {"excitation.amplitude", uniform(4e-4, 6e-4)},
                                              {"beam.youngs_modulus", normal(2e9, 0.002)}});
  struct Run {
    data::Damping damping;
    data::Uncertainty uncertainty;
  };
  for (const auto& [damping, uncertainty] : {Run{{}, uncertain_coefficient()},
                                             {data::Damping({.kelvin_voigt = 6.4e-5}), with_amplitude},
                                             {{}, with_a_force_each}}) {
    data::Case of = problem();
    of.damping = damping;
    const studies::JointDistribution joint(uncertainty);
    const double all_modes = studies::criterion_answer(of).all_modes.force_max.midpoint() / 500.0;
    const double ten_modes = critical_coefficient(of);
    std::size_t slips = 0, truncated = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
      const auto sample = joint.at(studies::independent_point(2, i, joint.size()));
      const double ratio = joint.size() > 1 ? sample[1] / of.excitation().amplitude() : 1.0;
      if (sample[0] < ratio * all_modes) ++slips;
      if (sample[0] < ratio * ten_modes) ++truncated;
    }
    const auto result = studies::slip_uncertainty(of, uncertainty, {.samples = 2000, .seed = 2});
    ASSERT_TRUE(result.all_modes);
    EXPECT_EQ(result.all_modes->valid, 1000u);
    EXPECT_EQ(result.all_modes->slips, slips);
    EXPECT_EQ(result.all_modes->slips_truncated, truncated);
    EXPECT_NE(slips, truncated);
    EXPECT_EQ(result.all_modes->probability_of_slip.value, static_cast<double>(slips) / 1000.0);
    EXPECT_EQ(result.margins.size(), 2000u);
  }
}

// log(margin) is normal: that of mu_s less that of the amplitude, and its variance is known with their correlation.
TEST(SlipProbability, OfCorrelatedKeysIsExact) {
  auto uncertainty = independent({{"friction.static_coefficient", lognormal(0.6, 0.06)},
                                  {"excitation.amplitude", lognormal(0.55e-3, 0.11e-3)}});
  const double s = std::sqrt(std::log1p(0.01)), t = std::sqrt(std::log1p(0.04));
  for (const double rho : {0.0, 0.8, -0.5}) {
    uncertainty.correlation = {1.0, rho, rho, 1.0};
    const auto result = studies::slip_uncertainty(problem(), uncertainty, {.samples = 20000});
    const double mean =
        std::log(0.6 * 500.0 / (0.55e-3 * force_per_metre(problem()))) - 0.5 * s * s + 0.5 * t * t;
    const double expected = gsl_cdf_ugaussian_P(-mean / std::sqrt(s * s + t * t - 2.0 * rho * s * t));
    EXPECT_TRUE(within(result.probability_of_slip.value, expected, sampling(expected, 20000))) << rho;
    const double halved = gsl_cdf_ugaussian_P(-mean / std::sqrt(s * s + 0.25 * t * t - rho * s * t));
    EXPECT_TRUE(within(result.probability_with_half_spread.value, halved, sampling(halved, 20000))) << rho;
    EXPECT_EQ(result.sensitivity.has_value(), rho == 0.0);
    EXPECT_EQ(uncertainty.keys[result.decisive].key, "excitation.amplitude");
    if (rho == 0.0) expect_index(result.sensitivity->indices[0].first, s * s / (s * s + t * t));
  }
}

// Of the quotient of two lognormal keys, which is lognormal: the critical amplitude, and one that is off by the error of a model.
TEST(SlipProbability, OfLognormalKeysIsExact) {
  const data::Case of = problem();
  const double critical = critical_coefficient(of), coefficient = 0.6, deviation = 0.06, amplitude = 0.5e-3,
               error = 0.1e-3;
  const auto keys = independent({{"friction.static_coefficient", lognormal(coefficient, deviation)},
                                 {"excitation.amplitude", lognormal(amplitude, error)}});
  const double a = std::log1p(std::pow(deviation / coefficient, 2)),
               b = std::log1p(std::pow(error / amplitude, 2)),
               z = (std::log(critical / coefficient) + 0.5 * (a - b)) / std::sqrt(a + b);
  const double expected = gsl_cdf_ugaussian_P(z);
  const auto result = studies::slip_uncertainty(of, keys, {.samples = 20000});
  EXPECT_TRUE(within(result.probability_of_slip.value, expected, sampling(expected, 20000)));
}

// A verdict comes from another search than the margin of the same sample. Damping makes the force much smaller.
TEST(SlipProbability, CountsMarginsBelowOne) {
  data::Case of = problem();
  const double modulus = of.beam().youngs_modulus();
  for (const data::Damping& damping : {data::Damping(), data::Damping({.ratio = 0.2})}) {
    of.damping = damping;
    const double critical = 300.0 / force_per_metre(of);
    auto keys = independent({{"beam.youngs_modulus", uniform(0.99 * modulus, 1.01 * modulus)},
                             {"excitation.amplitude", uniform(0.9 * critical, 1.1 * critical)}});
    keys.correlation[1] = keys.correlation[2] = 0.1;  // no indices, which would take long
    const auto result = studies::slip_uncertainty(of, keys, {.samples = 20});
    for (const auto& [p, amplitude, margin] : result.quantiles)
      EXPECT_EQ(margin.value < 1.0, std::floor(20.0 * p) < static_cast<double>(result.slips)) << p;
    EXPECT_LT(result.quantiles[0].critical_load.value, result.quantiles[4].critical_load.value);
  }
}

// One sine as a sum of sines has its scale in place of the amplitude. Its force is known to 1e-7, with the inertia of the modes left out,
// which a sine has where the wall moves with the base.
TEST(SlipProbability, OfOneSineAsAMotionIsThatSine) {
  data::Case sine = problem();
  sine.contact.wall = data::Wall({.with_base = true});
  const double amplitude = 300.0 / force_per_metre(sine);
  sine = with_value(sine, "excitation.amplitude", amplitude);
  data::Case motion = sine;
  motion.motion = data::GeneralMotion(std::vector<data::Sine>{{sine.excitation().frequency_hz(), amplitude,
                                                               data::AmplitudeOf::displacement, 0.0}},
                                      sine.numerics.duration());
  for (const char* other : {"friction.static_coefficient", "beam.density"}) {
    const auto spread = uniform(0.98 * value_of(sine, other), 1.02 * value_of(sine, other));
    const auto of = [&](const data::Case& problem, const std::string& load, double mean) {
      return studies::slip_uncertainty(
          problem, independent({{load, uniform(0.5 * mean, 2.0 * mean)}, {other, spread}}),
          {.samples = 100, .is_short = true});
    };
    const auto expected = of(sine, "excitation.amplitude", amplitude),
               found = of(motion, "excitation.scale", 1.0);
    EXPECT_EQ(found.slips, expected.slips);
    EXPECT_GT(std::min(found.slips, found.valid - found.slips), 10U);
    for (std::size_t i = 0; i < expected.quantiles.size(); ++i) {
      const double margin = expected.quantiles[i].margin.value,
                   scale = expected.quantiles[i].critical_load.value / amplitude;
      EXPECT_TRUE(within(found.quantiles[i].margin.value, margin, reference(1e-6 * margin, "ten times that")))
          << i;
      EXPECT_TRUE(
          within(found.quantiles[i].critical_load.value, scale, reference(1e-6 * scale, "ten times that")))
          << i;
    }
  }
}

// Where the tip sticks in the mean, less spread makes slip rarer; where it slips in the mean, surer.
TEST(SlipProbability, AdvisesOnlyWhatHelps) {
  for (const double amplitude : {0.5e-3, 0.8e-3}) {
    const data::Case of = with_value(problem(), "excitation.amplitude", amplitude);
    const auto result = studies::slip_uncertainty(of, uncertain_coefficient(), {.samples = 2000});
    const bool sticks = result.nominal_margin > 1.0;
    EXPECT_EQ(sticks, amplitude == 0.5e-3);
    EXPECT_EQ(result.tightening_helps, sticks);
    EXPECT_EQ(result.probability_with_half_spread.value < result.probability_of_slip.value, sticks);
    EXPECT_EQ(result.best_change.has_value(), !sticks);
    if (sticks) continue;
    const auto best = studies::criterion_answer(of).best_change;
    EXPECT_EQ(result.best_change->key, best->key);
    EXPECT_EQ(result.best_change->factor, best->factor);
    EXPECT_NEAR(result.best_change->margin, best->margin, 1e-7 * best->margin);
  }
}

TEST(SlipProbability, CountsWhatIsNoBeam) {
  const auto result = studies::slip_uncertainty(
      problem(),
      independent({{"beam.axial_force", uniform(-100.0, 900.0)}, {"beam.length", uniform(-1.0, 3.0)}}),
      {.samples = 2000});
  ASSERT_EQ(result.invalid.size(), 2u);
  const auto lost = [&](const std::string& key) {
    return static_cast<double>(result.invalid.at(key)) / 2000.0;
  };
  EXPECT_TRUE(within(lost("beam.length"), 0.25, sampling(0.25, 2000)));
  EXPECT_TRUE(within(lost("beam.axial_force"), 0.075, sampling(0.075, 2000)));
  EXPECT_EQ(result.valid, 2000u - result.invalid.at("beam.length") - result.invalid.at("beam.axial_force"));
  EXPECT_GT(result.sensitivity->dropped, 0u);
  EXPECT_EQ(refused_because(independent(
                {{"beam.axial_force", uniform(-9.0, -1.0)}, {"beam.length", uniform(-9.0, 3.0)}})),
            "no sample is a beam with a verdict, but one or more must be; most have no valid beam.length");
  EXPECT_EQ(refused_because(independent({{"beam.density", uniform(1e200, 2e200)}})),
            "no sample is a beam with a verdict, but one or more must be; most have no valid beam.density");
}

// A key with a value that no beam has is the decisive one, beside one that changes the margin fourfold.
TEST(SlipProbability, HasTheKeyOfInvalidBeams) {
  auto uncertainty =
      independent({{"friction.static_coefficient", uniform(0.1, 0.5)}, {"beam.length", uniform(-1.0, 2.0)}});
  uncertainty.correlation[1] = uncertainty.correlation[2] = 0.1;
  const auto result = studies::slip_uncertainty(problem(), uncertainty, {.samples = 20});
  EXPECT_FALSE(result.tornado[1].margin_low);
  EXPECT_TRUE(result.tornado[1].margin_high);
  EXPECT_EQ(result.decisive, 1u);
}

// The kinetic coefficient of the case is 0.3: it follows a smaller static one unless it is uncertain itself.
TEST(SlipProbability, KineticCoefficientFollows) {
  const std::pair<std::string, Distribution> coefficient{"friction.static_coefficient", uniform(0.1, 0.5)};
  EXPECT_EQ(studies::slip_uncertainty(problem(), independent({coefficient}), {.samples = 1000}).valid, 1000u);
  const auto both = studies::slip_uncertainty(
      problem(), independent({coefficient, {"friction.kinetic_coefficient", uniform(0.2999, 0.3001)}}),
      {.samples = 1000});
  EXPECT_TRUE(within(static_cast<double>(both.valid) / 1000.0, 0.5, sampling(0.5, 1000)));
}

TEST(SlipProbability, HasIndicesOfUpToTwentyKeys) {
  for (const std::size_t count : {20u, 21u}) {
    const std::vector<std::pair<std::string, Distribution>> keys(
        count, {"friction.static_coefficient", uniform(0.4, 0.5)});
    double last = 0.0;
    const auto result =
        studies::slip_uncertainty(problem(), independent(keys), {.samples = 20}, [&](double share) {
          EXPECT_GE(share, last);
          last = share;
        });
    EXPECT_NEAR(last, 1.0, 1e-14);
    EXPECT_EQ(result.sensitivity.has_value(), count == 20u);
  }
}

TEST(SlipProbability, OverABandIsOfTheWorst) {
  const analytic::FrequencyBand band{30.0, 32.0};
  const double critical = 0.6 / studies::band_margin(problem(), band).margin.midpoint();
  const auto coefficient =
      independent({{"friction.static_coefficient", normal(1.1 * critical, 0.1 * critical)}});
  const auto result = studies::slip_uncertainty(problem(), coefficient, {.samples = 5000, .band = band});
  const double expected = gsl_cdf_ugaussian_P(-1.0);
  EXPECT_TRUE(within(result.probability_of_slip.value, expected, sampling(expected, 5000)));
  EXPECT_NEAR(result.nominal_margin * critical, 0.6, 1e-6);  // the forces are known to 1e-6
  // A point of the band where the verdict is another.
  EXPECT_LT(
      studies::slip_uncertainty(problem(35.0), coefficient, {.samples = 5000}).probability_of_slip.upper,
      expected);
  data::Case damped = problem();
  damped.damping = data::Damping({.ratio = 0.01});
  EXPECT_THROW((void)studies::slip_uncertainty(damped, coefficient, {.samples = 10, .band = band}),
               data::InputError);
  for (const std::string key : {"excitation.frequency_hz", "damping.ratio"})
    EXPECT_EQ(refused_because(independent({{key, uniform(0.1, 0.2)}}), band),
              ": " + key + " is uncertain, but must be certain with a band");
  EXPECT_EQ(result.sensitivity->evaluations, 256u * 3u);  // a sixteenth of the rows without a band
}

TEST(SlipProbability, LeavesOutKeysThatAreGiven) {
  auto uncertainty = independent({{"a", uniform(0, 1)}, {"b", uniform(0, 1)}, {"c", uniform(0, 1)}});
  uncertainty.correlation = {1.0, 0.1, 0.2, 0.1, 1.0, 0.3, 0.2, 0.3, 1.0};
  const auto left = studies::without(uncertainty, {{"b", "", ""}, {"d", "", ""}});
  ASSERT_EQ(left.keys.size(), 2u);
  EXPECT_EQ(left.keys[1].key, "c");
  EXPECT_EQ(left.correlation, (std::vector{1.0, 0.2, 0.2, 1.0}));
}

}  // namespace
}  // namespace stickslip::testing
