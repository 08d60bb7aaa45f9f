// SPDX-License-Identifier: MIT
/// The largest friction force over a band of excitation frequencies.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::BandMaximum;
using analytic::Bounds;
using analytic::FrequencyBand;
using std::numbers::pi;

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

TEST(BandMaximum, FindsAResonanceFarNarrowerThanTheBand) {
  // Over 30 s the resonance is some 0.03 Hz wide.
  constexpr double duration = 30.0;
  const double natural = analytic::stick_modes(paper_beam(), 1).front().frequency_hz();
  BandMaximum search(paper_beam(), {1.0, 60.0}, duration);
  const Bounds bounds = search.refined_to(1e-4);
  EXPECT_GE(bounds.lower, (1.0 - 1e-4) * force_at(natural, duration).lower);
  EXPECT_TRUE(within(search.frequency_hz(), natural,
                     discretisation(1.0 / duration, 1.0, "width of a resonance over the duration")));
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
