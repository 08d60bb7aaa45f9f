// SPDX-License-Identifier: MIT
/// Enclosures hold the exact value, however coarse the search that gave them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::StickResponse;
using std::numbers::pi;

StickResponse response_at(double hz, int modes = 10) {
  return StickResponse(paper_beam(), data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1e-3}),
                       modes);
}

double densely_sampled(const StickResponse& response, double duration) {
  double largest = 0.0;
  for (int i = 0; i <= 20000; ++i)
    largest = std::max(largest, std::abs(response.friction_force(duration * i / 2e4)));
  return largest;
}

STICKSLIP_VERIFIES(SampledMaximum, "A5");
TEST(SampledMaximum, HoldsTheSampleAtTheEnd) {
  // The force rises from zero through the whole of 3 ms; the last sample on the grid is at 2 ms.
  const StickResponse response = response_at(5.0);
  const double before = std::abs(response.friction_force(2e-3)),
               end = std::abs(response.friction_force(3e-3));
  ASSERT_GT(end, 1.1 * before);
  EXPECT_TRUE(within(response.sampled_max_abs_friction_force(3e-3, 2e-3).lower, end, round_off(10, 1, end)));
}

TEST(SampledMaximum, HoldsTheLastSampleOfTheGridBeforeAShorterStep) {
  // The largest value of one second is the fifth sample; the sixth would lie behind the end.
  const StickResponse response = response_at(35.0);
  double peak = 0.0;
  for (int i = 1; i <= 20000; ++i)
    if (std::abs(response.friction_force(i / 2e4)) > std::abs(response.friction_force(peak))) peak = i / 2e4;
  const double step = 0.25 * peak, largest = std::abs(response.friction_force(peak));
  ASSERT_LT(std::abs(response.friction_force(peak + 0.9 * step)), 0.9 * largest);
  EXPECT_TRUE(within(response.sampled_max_abs_friction_force(peak + 0.9 * step, step).lower, largest,
                     round_off(10, 1, largest)));
}

TEST(SampledMaximum, UpperBoundHoldsBetweenSamplesFarApart) {
  for (const double hz : {3.0, 40.0, 300.0})
    for (const int modes : {1, 3}) {
      const StickResponse response = response_at(hz, modes);
      const double duration = 7.3 / hz, largest = densely_sampled(response, duration);
      for (const double share : {0.13, 0.29, 0.41}) {
        const Bounds bounds = response.sampled_max_abs_friction_force(duration, share / hz);
        EXPECT_LE(bounds.lower, largest * (1.0 + 1e-12)) << hz << " Hz, " << share;
        EXPECT_GE(bounds.upper, largest) << hz << " Hz, " << share;
      }
    }
}

TEST(SampledMaximum, ExcessIsAnEighthOfTheSecondDerivativeTimesTheSquareOfTheStep) {
  // Far from resonance the bound of |f''| is the sum over the sinusoids, that at Omega taken as one.
  const StickResponse response = response_at(35.0, 4);
  const double omega = 2.0 * pi * 35.0, step = 1e-4;
  double bend = std::abs(response.steady_force_amplitude()) * omega * omega;
  for (const auto& term : response.transient_force())
    bend += std::abs(term.amplitude) * term.angular_frequency * term.angular_frequency;
  const Bounds bounds = response.sampled_max_abs_friction_force(1.0, step);
  const double excess = bend * step * step / 8.0;
  EXPECT_TRUE(within(bounds.upper - bounds.lower, excess, round_off(100, bounds.upper / excess, excess)));
}

STICKSLIP_VERIFIES(StickResponse, "A4");
TEST(StickResponse, ClosestToResonanceLosesNoDigits) {
  // In the first mode g grows as t cos(omega t)/2, and a relative shift d of Omega turns its phase by d omega
  // t/2.
  const double natural = analytic::stick_modes(paper_beam(), 1).front().frequency_hz(), t = 1.3;
  const double phase = 2.0 * pi * natural * t;
  const double at = response_at(natural).friction_force(t);
  const double peak = densely_sampled(response_at(natural), t);
  for (const double distance : {1e-8, 1e-10, 1e-12, 1e-14}) {
    const double beside = response_at(natural * (1.0 + distance)).friction_force(t);
    EXPECT_TRUE(
        within(beside, at,
               {(0.5 * phase * distance + 4.0 * phase * std::numeric_limits<double>::epsilon()) * peak,
                "round-off", "phase omega t/2 turned by the distance, and its rounding"}))
        << distance;
  }
}

STICKSLIP_VERIFIES(Criterion, "A6");
TEST(Criterion, CriticalAmplitudesAreExchangedWithTheBoundsOfTheForce) {
  const data::HarmonicExcitation excitation({.frequency_hz = 35.0, .amplitude = 1e-3});
  const auto enclosed = [&](double width) {
    return analytic::evaluate_criterion(paper_beam(), paper_friction(), excitation, 1.0, 10,
                                        analytic::SteadyPart::modal_sum, width)
        .critical_amplitude;
  };
  const double critical = enclosed(1e-10).midpoint();
  for (const double width : {0.3, 0.03}) {
    const Bounds bounds = enclosed(width);
    EXPECT_LT(bounds.lower, critical) << width;
    EXPECT_GT(bounds.upper, critical) << width;
    EXPECT_GT(bounds.upper, bounds.lower * (1.0 + 1e-6)) << "no bounds, but a value";
  }
}

// f per unit amplitude of the modes, at its worst over 0 ... duration, and its second derivative to Omega by
// differences.
double bend_over_frequency(double hz, double duration, double step_hz) {
  const auto force = [&](double frequency_hz, double t) {
    const data::HarmonicExcitation unit({.frequency_hz = frequency_hz, .amplitude = 1.0});
    return StickResponse(paper_beam(), unit, 2).friction_force(t);
  };
  double largest = 0.0;
  for (int i = 1; i <= 400; ++i) {
    const double t = duration * i / 400.0, step = 2.0 * pi * step_hz;
    const double bend =
        (force(hz + step_hz, t) - 2.0 * force(hz, t) + force(hz - step_hz, t)) / (step * step);
    largest = std::max(largest, std::abs(bend));
  }
  return largest;
}

STICKSLIP_VERIFIES(BandMaximum, "X15");
TEST(BandMaximum, BoundsTheBendOfTheForceOverFrequencyFromAboveAndNotFarAbove) {
  // Next to a resonance, between two, and above; durations on both sides of one second. Triangle inequalities
  // cost a factor of two for each sinusoid that is taken for one (the mean of sin^2) and one for each mode.
  for (const double duration : {0.3, 3.0, 30.0})
    for (const double hz : {24.9, 25.2, 50.0, 81.0, 110.0}) {
      const double width = 1e-3 / duration;
      const analytic::BandMaximum search(paper_beam(), {hz - width, hz + width}, duration, 2);
      const double bound = search.between(2.0 * pi * (hz - width), 2.0 * pi * (hz + width)).curvature;
      const double bend = bend_over_frequency(hz, duration, 1e-3 / duration);
      EXPECT_GE(bound, bend * (1.0 - 1e-4)) << hz << " Hz, " << duration << " s";
      EXPECT_LE(bound, 12.0 * bend) << hz << " Hz, " << duration << " s";
    }
}

TEST(BandMaximum, BoundsTheForceOfAnIntervalFromAboveAndNotFarAbove) {
  for (const double duration : {0.3, 3.0, 30.0})
    for (const double hz : {10.0, 24.9, 25.2, 50.0, 81.0, 110.0}) {
      const double width = 1e-3 / duration;
      const analytic::BandMaximum search(paper_beam(), {hz - width, hz + width}, duration, 2);
      const double bound = search.between(2.0 * pi * (hz - width), 2.0 * pi * (hz + width)).force;
      const data::HarmonicExcitation unit({.frequency_hz = hz, .amplitude = 1.0});
      const double force = densely_sampled(StickResponse(paper_beam(), unit, 2), duration);
      EXPECT_GE(bound, force) << hz << " Hz, " << duration << " s";
      EXPECT_LE(bound, 4.0 * force) << hz << " Hz, " << duration << " s";
    }
}

TEST(BandMaximum, BoundsAtOneFrequencyAndOneModeAreSumsOfExactSuprema) {
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
      const analytic::BandMaximum search(paper_beam(), {omega / (2.0 * pi), omega / (2.0 * pi)}, duration, 1);
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

}  // namespace
}  // namespace stickslip::testing
