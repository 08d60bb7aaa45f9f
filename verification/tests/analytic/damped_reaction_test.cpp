// SPDX-License-Identifier: MIT
/// The stick-state reaction with damping: without damping it is Eq. (28), it tends to the steady vibration in closed
/// form, and its largest value lies between the bounds.

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::DampedForce;
using analytic::SteadyPart;
using std::numbers::pi;

constexpr double width = 1e-10;  // of the bounds, relative

data::Damping by_ratio(double zeta) { return data::Damping({.ratio = zeta}); }

data::HarmonicExcitation at(double hz) { return data::HarmonicExcitation({hz, 1.0}); }

DampedForce force(const data::Damping& damping, double hz, double duration, int modes = 10,
                  SteadyPart part = SteadyPart::modal_sum) {
  return {analytic::damped_reaction(paper_beam(), damping, modes, part), 2.0 * pi * hz, duration};
}

Bounds undamped(double hz, double duration) {
  return analytic::StickResponse(paper_beam(), at(hz)).max_abs_friction_force(duration, width);
}

// The natural frequency, where the closed form is 0/0, among them.
std::vector<double> frequencies() {
  return {5.0, 15.0, 25.0, 35.0, 70.0, analytic::stick_modes(paper_beam(), 1).front().frequency_hz()};
}

STICKSLIP_VERIFIES(DampedReaction, "A10");
TEST(DampedReaction, WithoutDampingIsEquation28) {
  for (const double hz : frequencies()) {
    const DampedForce computed = force({}, hz, 10.0);
    const analytic::StickResponse response(paper_beam(), at(hz));
    const Bounds bounds = computed.refined_to(width), expected = undamped(hz, 10.0);
    for (const double t : {0.0, 0.01, 0.7, 9.9})
      EXPECT_NEAR(computed.value(t), response.friction_force(t), 10.0 * computed.rounding()) << hz;
    // The integrals of the model are good to some 100 eps.
    EXPECT_TRUE(within(bounds.midpoint(), expected.midpoint(),
                       {2.0 * width * expected.upper, "arithmetic", "both bounds are 1e-10 apart"}))
        << hz;
  }
}

// The eigenvalues are known to eps times the largest. That counts over the distance of i Omega from the nearest.
double rounding_of_eigenvalues(const data::Damping& damping, double hz, int modes) {
  double largest = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (const auto& share : analytic::damped_reaction(paper_beam(), damping, modes).shares) {
    largest = std::max(largest, std::abs(share.eigenvalue));
    nearest = std::min(nearest, std::abs(share.eigenvalue - std::complex<double>(0.0, 2.0 * pi * hz)));
  }
  return round_off(4, largest / nearest, 1.0).value;
}

// At times at which nothing of the start is left. The terms at Omega fall as P n^-4 + n^-6, so that twice the
// modes leave at most an eighth of the error.
TEST(DampedReaction, BecomesTheSteadyVibrationInAmplitudeAndPhase) {
  for (const double hz : frequencies())
    for (const double eta : {6.4e-5, 2e-3}) {
      const analytic::DampedSteadyState steady(paper_beam(), at(hz), kelvin_voigt(eta),
                                               analytic::TipSupport::held);
      const DampedForce fine = force(kelvin_voigt(eta), hz, 100.0, 40, SteadyPart::exact);
      const DampedForce coarse = force(kelvin_voigt(eta), hz, 100.0, 20, SteadyPart::exact);
      const double scale = std::abs(steady.friction_force());
      const double rounding = rounding_of_eigenvalues(kelvin_voigt(eta), hz, 40) * scale;
      for (const double t : {60.0, 60.003, 99.123}) {
        const double expected =
            (steady.friction_force() * std::exp(std::complex<double>(0.0, 2.0 * pi * hz * t))).imag();
        const double predicted = std::abs(fine.value(t) - coarse.value(t)) / 7.0;
        const double phase = round_off(1, 2.0 * pi * hz * t, scale).value;
        EXPECT_TRUE(
            within(fine.value(t), expected,
                   discretisation(predicted + phase + rounding, 1.5, "N^-3, the phase and the eigenvalues")))
            << hz << ' ' << eta << ' ' << t;
      }
      EXPECT_NEAR(fine.steady_amplitude(), scale,
                  2.0 * std::abs(fine.steady_amplitude() - coarse.steady_amplitude()) + 1e-10 * scale);
    }
}

// Samples 2e-5 s apart or less miss a peak by (omega h)^2/8 of what vibrates there, below 1 %: the best 1 % of them
// are looked at more closely, twice a hundred times, which leaves 1e-9.
TEST(DampedReaction, HasItsLargestValueBetweenTheBounds) {
  const data::Damping both({.kelvin_voigt = 1e-3, .ratio = 0.3});
  for (const double hz : {5.0, 25.0, 70.0, 300.0})
    for (const data::Damping& damping : {kelvin_voigt(6.4e-5), by_ratio(0.005), by_ratio(0.9), both})
      for (const double duration : {0.013, 0.4, 1.0}) {
        const DampedForce computed = force(damping, hz, duration);
        const Bounds bounds = computed.refined_to(width);
        const double step = std::min(duration, 0.4) / 20000.0;
        const auto value = [&](double t) { return std::abs(computed.value(std::clamp(t, 0.0, duration))); };
        const auto best_near = [&](double t, double fine) {
          double best = t;
          for (int i = -100; i <= 100; ++i)
            if (value(t + i * fine) > value(best)) best = t + i * fine;
          return best;
        };
        std::vector<double> samples;
        for (double t = 0.0; t < duration + step; t += step) samples.push_back(value(t));
        const double threshold = 0.99 * *std::ranges::max_element(samples);
        double largest = 0.0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
          const bool is_peak = samples[i] >= samples[i == 0 ? 0 : i - 1] &&
                               samples[i] >= samples[std::min(i + 1, samples.size() - 1)];
          if (samples[i] < threshold || !is_peak) continue;
          const double near = best_near(static_cast<double>(i) * step, 0.01 * step);
          largest = std::max(largest, value(best_near(near, 1e-4 * step)));
        }
        EXPECT_LE(largest, bounds.upper);
        EXPECT_GE(largest * (1.0 + 2e-9), bounds.lower) << hz << ' ' << duration;
        EXPECT_LE(bounds.upper - bounds.lower, width * bounds.lower + 3.0 * computed.rounding());
        const Bounds wide = computed.refined_to(1e-3);
        EXPECT_TRUE(wide.lower <= bounds.upper && bounds.lower <= wide.upper);
      }
}

// Beyond that the steady vibration bounds it, at the cost of none.
TEST(DampedReaction, IsSettledAfterItsFreeVibrations) {
  const Bounds ten = force(kelvin_voigt(2e-3), 25.0, 10.0).refined_to(width);
  const Bounds million = force(kelvin_voigt(2e-3), 25.0, 1e6).refined_to(width);
  EXPECT_NEAR(million.midpoint(), ten.midpoint(), width * ten.upper);
}

TEST(DampedReaction, MakesACriterionThatIsLinearInTheAmplitude) {
  const auto criterion = [](double amplitude) {
    return analytic::evaluate_criterion(paper_beam(), paper_friction(),
                                        data::HarmonicExcitation({35.0, amplitude}), 10.0, 10,
                                        SteadyPart::modal_sum, width, by_ratio(0.01));
  };
  const auto one = criterion(1e-3), two = criterion(2e-3);
  EXPECT_EQ(one.critical_amplitude.lower, two.critical_amplitude.lower);
  EXPECT_EQ(2.0 * one.force_max.lower, two.force_max.lower);
  const double critical = one.critical_amplitude.midpoint();
  EXPECT_EQ(criterion(0.999999 * critical).verdict, analytic::Verdict::stick);
  EXPECT_EQ(criterion(1.000001 * critical).verdict, analytic::Verdict::stick_slip);
}

// Nearly without P the modes do not couple, and eta = 2/omega_1 damps the first one critically. A millionth more
// changes the force by about as much.
TEST(DampedReaction, IsContinuousAtCriticalDamping) {
  const data::Beam beam = paper_beam_with_axial_force(1e-6);
  const double critical = 2.0 / analytic::stick_modes(beam, 1).front().angular_frequency();
  const auto largest = [&](double eta) {
    return DampedForce(analytic::damped_reaction(beam, kelvin_voigt(eta), 10), 2.0 * pi * 30.0, 10.0)
        .refined_to();
  };
  const Bounds at = largest(critical), beside = largest(1.000001 * critical);
  EXPECT_NEAR(at.midpoint(), beside.midpoint(), 2e-6 * beside.midpoint());
  EXPECT_LT(at.upper - at.lower, 1e-5 * at.lower);
}

TEST(DampedReaction, RefusesWhatItCannotDo) {
  for (const double narrowest : {0.99e-13, 1.0})
    EXPECT_THROW((void)force({}, 25.0, 1.0).refined_to(narrowest), std::invalid_argument);
  EXPECT_NO_THROW((void)force({}, 25.0, 1.0).refined_to(1e-13));
  EXPECT_THROW((void)force({}, 0.0, 1.0), data::FieldError);
  EXPECT_THROW((void)force({}, 25.0, 0.0), data::FieldError);
  EXPECT_THROW((void)force({}, 25.0, 1e9).refined_to(), data::FieldError);
}

}  // namespace
}  // namespace stickslip::testing
