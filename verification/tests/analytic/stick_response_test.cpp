// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "analytic/gsl.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/order.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::ForceMaximum;
using analytic::Sinusoid;
using analytic::SteadyPart;
using analytic::stick_modes;
using analytic::StickMode;
using analytic::StickResponse;
using std::numbers::pi;

constexpr std::array kBothSums{SteadyPart::modal_sum, SteadyPart::exact};

data::HarmonicExcitation shaking(double frequency_hz, double amplitude = 0.5e-3) {
  return data::HarmonicExcitation({.frequency_hz = frequency_hz, .amplitude = amplitude});
}

double mass(const data::Beam& beam) { return beam.density() * beam.area(); }

/// A sum of sinusoids bounds the size of the m-th derivative of what it represents.
double derivative_size(double steady, double omega, const std::vector<Sinusoid>& transient, int order) {
  double size = std::abs(steady) * std::pow(omega, order);
  for (const Sinusoid& s : transient) size += std::abs(s.amplitude) * std::pow(s.angular_frequency, order);
  return size;
}

double second_difference(const RealFunction& f, double x, double h) {
  return (f(x + h) - 2.0 * f(x) + f(x - h)) / (h * h);
}

double fourth_difference(const RealFunction& f, double x, double h) {
  return (f(x + 2 * h) - 4.0 * f(x + h) + 6.0 * f(x) - 4.0 * f(x - h) + f(x - 2 * h)) / (h * h * h * h);
}

/// One-sided, towards smaller x; leading error 7/4 h^2 f^(5).
double backward_third_difference(const RealFunction& f, double x, double h) {
  return (5.0 * f(x) - 18.0 * f(x - h) + 24.0 * f(x - 2 * h) - 14.0 * f(x - 3 * h) + 3.0 * f(x - 4 * h)) /
         (2.0 * h * h * h);
}

STICKSLIP_VERIFIES(StickResponse, "A4");
TEST(StickResponse, KeepsTheClampAndTheTipAtTheWall) {
  for (const SteadyPart steady : kBothSums) {
    const StickResponse response(paper_beam(), shaking(25.0), 10, steady);
    for (const double t : {0.013, 0.4, 3.3}) {
      const double size = 0.1;  // m, the deflection at resonance
      EXPECT_TRUE(within(response.relative_displacement(0.0, t), 0.0, round_off(20, 10, size)));
      EXPECT_TRUE(within(response.absolute_displacement(2.0, t), 0.0, round_off(20, 1, size)));
      // u' = 0 at x = 0: what is left of u(h)/h is u'' h/2 with u'' <= beta_1^2 size.
      const double h = 1e-6;
      EXPECT_TRUE(within(response.relative_displacement(h, t) / h, 0.0,
                         discretisation(2.0 * std::pow(3.93 / 2.0, 2) * size * h / 2.0, 4.0, "h u''/2")));
    }
  }
}

TEST(StickResponse, SatisfiesTheEquationOfMotionAtRandomPoints) {
  // Exact steady part and three free vibrations: each term satisfies Eq. (1), so the sum does.
  const data::Beam beam = paper_beam();
  const double drive = 2.0 * pi * 15.0;
  const StickResponse response(beam, shaking(15.0), 3, SteadyPart::exact);
  const StickMode& last = response.modes().back();
  const double wave = last.trigonometric_wave_number();
  double size = 0.0, time_fourth = 0.0;
  for (int i = 0; i <= 50; ++i) {
    const double steady = response.steady_displacement_amplitude(0.04 * i);
    const auto transient = response.transient_displacement(0.04 * i);
    size = std::max(size, derivative_size(steady, drive, transient, 0));
    time_fourth = std::max(time_fourth, derivative_size(steady, drive, transient, 4));
  }
  const double h = 0.02 / wave, dt = 0.02 / last.angular_frequency();
  const double error =
      rigidity(beam) * h * h * std::pow(wave, 6) * size / 6.0 + mass(beam) * dt * dt * time_fourth / 12.0;
  std::mt19937 generator(2018);
  std::uniform_real_distribution<double> place(0.1, 1.9), time(0.01, 1.0);
  for (int i = 0; i < 50; ++i) {
    const double x = place(generator), t = time(generator);
    const auto along = [&](double s) { return response.relative_displacement(s, t); };
    const auto during = [&](double s) { return response.relative_displacement(x, s); };
    const double sum = mass(beam) * second_difference(during, t, dt) +
                       rigidity(beam) * fourth_difference(along, x, h) +
                       beam.axial_force() * second_difference(along, x, h);
    const double load = mass(beam) * drive * drive * response.base_displacement(t);
    EXPECT_TRUE(within(sum, load, discretisation(error, 1.1, "second-order differences")));
  }
}

TEST(StickResponse, ForceIsTheThirdDerivativeAtTheTip) {
  for (const SteadyPart steady : kBothSums) {
    const StickResponse response(paper_beam(), shaking(15.0), 4, steady);
    const double wave = response.modes().back().trigonometric_wave_number();
    const double size = derivative_size(response.steady_displacement_amplitude(1.0), 1.0,
                                        response.transient_displacement(1.0), 0);
    const double h = 0.01 / wave;
    for (const double t : {0.017, 0.05, 0.31}) {
      const auto along = [&](double x) { return response.relative_displacement(x, t); };
      EXPECT_TRUE(within(response.friction_force(t),
                         rigidity(paper_beam()) * backward_third_difference(along, 2.0, h),
                         discretisation(rigidity(paper_beam()) * 1.75 * h * h * std::pow(wave, 5) * size, 2.0,
                                        "7/4 h^2 u^(5)")));
    }
  }
}

TEST(StickResponse, HasNoBendingMomentAtTheTip) {
  // One-sided differences: u'' - 11/12 h^2 u + h^3 u^(5). At the tip u is zero too, since it does not
  // accelerate. Each part of u has the fifth power of its own wave number in u^(5).
  const data::Beam beam = paper_beam();
  for (const SteadyPart steady : kBothSums) {
    const StickResponse response(beam, shaking(15.0), 4, steady);
    const double h = 0.01 / response.modes().back().trigonometric_wave_number();
    const double steady_wave = std::sqrt(2.0 * pi * 15.0 * std::sqrt(mass(beam) / rigidity(beam)));
    double fifth = std::abs(response.steady_displacement_amplitude(1.0)) * std::pow(steady_wave, 5);
    const auto transient = response.transient_displacement(1.0);
    for (std::size_t n = 0; n < transient.size(); ++n)
      fifth +=
          std::abs(transient[n].amplitude) * std::pow(response.modes()[n].trigonometric_wave_number(), 5);
    for (const double t : {0.017, 0.05, 0.31}) {
      const auto u = [&](int steps) { return response.relative_displacement(2.0 - steps * h, t); };
      const double curvature = (2.0 * u(0) - 5.0 * u(1) + 4.0 * u(2) - u(3)) / (h * h);
      EXPECT_TRUE(within(curvature, 0.0, discretisation(h * h * h * fifth, 4.0, "h^3 u^(5)")));
    }
  }
}

TEST(StickResponse, SlowShakingAddsTheInertiaOfTheMasslessShape) {
  // P = 0. f/A0 = 3 EI/L^3 + rho A L Omega^2 39/280 + O(Omega^4), with int (1 + S) S dx = -39/280 L; the next
  // term is (Omega/omega_1)^2 of the second.
  const data::Beam beam = paper_beam_with_load_factor(0.0);
  const double natural = stick_modes(beam, 1).front().angular_frequency();
  for (const double hz : {0.1, 1.0}) {
    const double omega = 2.0 * pi * hz;
    const double inertia = mass(beam) * beam.length() * omega * omega * 39.0 / 280.0;
    const double at_rest = 3.0 * rigidity(beam) / std::pow(beam.length(), 3);
    const double force = StickResponse(beam, shaking(hz), 10, SteadyPart::exact).steady_force_amplitude();
    const double next = inertia * std::pow(omega / natural, 2);
    EXPECT_TRUE(within(force / 0.5e-3 - at_rest, inertia,
                       discretisation(next + round_off(30, 1, at_rest).value, 3.0, "(Omega/omega_1)^2")))
        << hz << " Hz";
  }
}

TEST(StickResponse, IsTheSumOfItsSinusoids) {
  for (const SteadyPart steady : kBothSums) {
    const StickResponse response(paper_beam(), shaking(70.0), 10, steady);
    const auto transient = response.transient_force();
    const double size = derivative_size(response.steady_force_amplitude(), 1.0, transient, 0);
    for (const double t : {0.0, 0.011, 0.5, 9.9}) {
      double sum = response.steady_force_amplitude() * std::sin(2.0 * pi * 70.0 * t);
      for (const Sinusoid& s : transient) sum += s.amplitude * std::sin(s.angular_frequency * t);
      // Round-off of the phases up to omega_10 t, besides that of the sum.
      const double phase = 1.0 + transient.back().angular_frequency * t;
      EXPECT_TRUE(within(response.friction_force(t), sum, round_off(10, phase, size)));
    }
  }
}

TEST(StickResponse, SteadyAmplitudesAgreeWithFortyDigitArithmetic) {
  struct Steady {
    double load_factor, frequency_hz, force, displacement;  // f per A0 in N/m, u(0.7 m)/A0
  };
  const std::array<Steady, 12> table{{{-1e4, 24.9, 49.638649902668527, -0.34199821546476244},
                                      {-1e4, 70.0, 402.89647209788633, -0.33190986879179057},
                                      {-10.0, 1e-3, 2570.5274191817687, -0.20083958225026842},
                                      {-10.0, 24.9, 143184.3984755679, 0.86542844007252454},
                                      {-10.0, 70.0, -509359.04909284069, -0.12617986571299714},
                                      {0.0, 1e-9, 6250.0, -0.1623125},
                                      {0.0, 1.0, 6360.194531674385, -0.16140264051190315},
                                      {0.0, 24.9, 7562666.6066694793, 45.22400597300546},
                                      {0.0, 70.0, -865266.78162489029, 0.46266440304473075},
                                      {1e-9, 1e-3, 6250.0001106005924, -0.16231249908607766},
                                      {15.0, 24.9, -188670.2376281065, -0.84625257114217131},
                                      {15.0, 70.0, 137723299.97258069, -197.16899104039809}}};
  for (const auto& [load_factor, frequency_hz, force, displacement] : table) {
    const data::Beam beam = paper_beam_with_load_factor(load_factor);
    const StickResponse response(beam, shaking(frequency_hz, 1.0), 12, SteadyPart::exact);
    double condition = 1.0;
    for (const StickMode& mode : response.modes())
      condition = std::max(condition, mode.frequency_hz() / std::abs(mode.frequency_hz() - frequency_hz));
    // The forces at rest and in motion, between which the sum may cancel, set the scale.
    const double force_scale = std::abs(force) + 4.0 * rigidity(beam) / 8.0;
    EXPECT_TRUE(within(response.steady_force_amplitude(), force, round_off(30, condition, force_scale)));
    EXPECT_TRUE(within(response.steady_displacement_amplitude(0.7), displacement,
                       round_off(30, condition, 1.0 + std::abs(displacement))))
        << load_factor << ", " << frequency_hz;
  }
}

TEST(StickResponse, ExactSteadyPartDoesNotDependOnTheModesKept) {
  // Between 10 and 40 modes only the free vibrations 11 ... 40 differ, at and beside resonance as elsewhere.
  const auto modes = stick_modes(paper_beam(), 2);
  for (const double hz : {1e-3, 15.0, modes[0].frequency_hz(), modes[0].frequency_hz() * (1.0 + 1e-9),
                          modes[0].frequency_hz() * 1.01, 53.0, modes[1].frequency_hz() * (1.0 - 1e-12)}) {
    const StickResponse ten(paper_beam(), shaking(hz), 10, SteadyPart::exact);
    const StickResponse forty(paper_beam(), shaking(hz), 40, SteadyPart::exact);
    const auto transient = forty.transient_force();
    for (const double t : {0.02, 0.7, 3.0}) {
      double beyond_ten = 0.0, phase_error = 0.0;
      for (std::size_t n = 10; n < 40; ++n) {
        const auto [amplitude, frequency] = transient[n];
        beyond_ten += amplitude * std::sin(frequency * t);
        phase_error += round_off(1, 1.0 + frequency * t, amplitude).value;
      }
      // Each of forty terms is as large as the terms at rest or the force, which reaches 4e4 N at resonance.
      const double force = std::max(50.0, std::abs(ten.friction_force(t)));
      EXPECT_TRUE(within(forty.friction_force(t), ten.friction_force(t) + beyond_ten,
                         discretisation(round_off(40, 1, force).value + phase_error, 1.0,
                                        "round-off of the sums and the phases")))
          << hz;
    }
  }
}

TEST(StickResponse, ExactSteadyPartNeedsFewModes) {
  // Half way up to the highest mode kept, as far as is allowed, against forty modes more.
  for (const int count : {1, 2, 3, 8, 20, 60}) {
    const auto modes = stick_modes(paper_beam(), count);
    for (const double share : {0.49999, 0.47, 0.44}) {
      const double hz = share * modes.back().frequency_hz();
      const StickResponse least(paper_beam(), shaking(hz, 1.0), count, SteadyPart::exact);
      const StickResponse many(paper_beam(), shaking(hz, 1.0), count + 40, SteadyPart::exact);
      double condition = 1.0;
      for (const StickMode& mode : modes)
        condition = std::max(condition, hz / std::abs(hz - mode.frequency_hz()));
      // E I |Y'''(L)| is of the order E I k^(3/4) between resonances, k = rho A Omega^2/EI.
      const double k = mass(paper_beam()) * std::pow(2.0 * pi * hz, 2) / rigidity(paper_beam());
      const double scale = rigidity(paper_beam()) * (1.0 + std::pow(k, 0.75));
      EXPECT_TRUE(within(least.steady_force_amplitude(), many.steady_force_amplitude(),
                         round_off(count + 40, condition, scale)))
          << count << " modes, " << hz << " Hz";
    }
  }
}

TEST(StickResponse, PassesThroughResonanceContinuously) {
  // With phi = omega t the resonant mode is proportional to [sin(phi (1 + d)) - sin(phi)]/d = phi cos(phi) -
  // phi^2 d/2 sin(phi) - phi^3 d^2/6 cos(phi) ... at the distance d: it leaves linearly, and the next term is
  // phi d/3 cot(phi) of that. What else depends on d is less by 1/phi, and so 2/(phi sin(phi)) of it.
  const double natural = stick_modes(paper_beam(), 1).front().frequency_hz();
  const double t = 1.3, phase = 2.0 * pi * natural * t;
  const auto next_term = [phase](double d) {
    return phase * d / 3.0 *
           (std::abs(1.0 / std::tan(phase)) + 2.0 / (phase * std::abs(std::sin(phase))) * 3.0);
  };
  for (const SteadyPart steady : kBothSums) {
    const StickResponse at(paper_beam(), shaking(natural), 10, steady);
    std::vector<double> distances, differences;
    for (double distance = 1e-3; distance > 1e-9; distance *= 0.1) {
      const StickResponse beside(paper_beam(), shaking(natural * (1.0 + distance)), 10, steady);
      distances.push_back(distance);
      differences.push_back(std::abs(beside.friction_force(t) - at.friction_force(t)));
    }
    const double floor = round_off(10, 1.0 + phase, at.friction_force(t)).value;
    EXPECT_TRUE(order_is(order_levels(distances, differences, next_term, floor), 1.0));
  }
}

StickResponse response_at(double hz, int modes = 10) {
  return StickResponse(paper_beam(), shaking(hz, 1e-3), modes);
}

double densely_sampled(const StickResponse& response, double duration) {
  double largest = 0.0;
  for (int i = 0; i <= 20000; ++i)
    largest = std::max(largest, std::abs(response.friction_force(duration * i / 2e4)));
  return largest;
}

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

TEST(StickResponse, ResonantModeGrowsAsLHospitalSays) {
  // lim g = (omega t cos(omega t) - sin(omega t))/(2 omega^2) as Omega -> omega.
  const data::Beam beam = paper_beam();
  const StickMode mode = stick_modes(beam, 1).front();
  const StickResponse response(beam, shaking(mode.frequency_hz()), 1);
  const analytic::QuasiStaticShape quasi_static(beam);
  const double omega = mode.angular_frequency(), x = 1.2;
  for (const double t : {0.01, 0.5, 10.0}) {
    const double phase = omega * t;
    const double modal =
        0.5e-3 * mode.shape(x) * mode.participation() * 0.5 * (phase * std::cos(phase) - std::sin(phase));
    const double expected = quasi_static.value(x) * response.base_displacement(t) + modal;
    EXPECT_TRUE(within(response.relative_displacement(x, t), expected,
                       round_off(4, 1.0 + phase, 0.5e-3 * (1.0 + phase))));
  }
}

TEST(StickResponse, SteadyAmplitudeIsUnboundedAtResonance) {
  const double natural = stick_modes(paper_beam(), 1).front().frequency_hz();
  EXPECT_GT(std::abs(StickResponse(paper_beam(), shaking(natural)).steady_force_amplitude()), 1e12);
  EXPECT_EQ(StickResponse(paper_beam(), shaking(natural, 0.0)).steady_force_amplitude(), 0.0);
}

// What the modes add to f at Omega and as free vibrations, for large n and P = 0: with bb = b = (n + 1/4) pi,
// sin(bb) = (-1)^n/sqrt(2) and tan(bb) = 1, U_n'''(L) = -(-1)^n sqrt(2) b^3/L^3, int U_n^2 dx = L and C_n =
// -2/b, so that the terms of Eq. (28) are
//
//     at Omega:    (-1)^n A/b^2,                    A = 2 sqrt(2) rho A L Omega^2 A0,
//     at omega_n:  (-1)^n A/b^2 Omega/omega_n,      omega_n = sqrt(EI/rho A) b^2/L^2.
//
// An axial force moves them by z/b^2, z = P L^2/EI = 0.12, a few times, and the excitation by
// (Omega/omega_n)^2.
struct TermsOfTheForce {
  double omega = 2.0 * pi * 35.0;
  double scale = 2.0 * std::sqrt(2.0) * 10.0 * 2.0 * omega * omega * 0.5e-3;
  double natural = std::sqrt(16666.666666666668 / 10.0) / 4.0;  // omega_n = natural b^2

  [[nodiscard]] double next_term(double b) const {
    return 3.0 * 0.12 / (b * b) + std::pow(omega / (natural * b * b), 2);
  }
};

TEST(StickResponse, ModalSumConvergesWithOrderTwoAlternating) {
  // The terms a(n) alternate, and the sum misses half of what lies half a term further, a(N + 1/2)/2 but for
  // a''/(8 a) = 3/(4 N^2) of it: for b = (n + 1/4) pi that is A/(2 pi^2) (N + 3/4)^-2.
  const TermsOfTheForce terms;
  const double exact =
      StickResponse(paper_beam(), shaking(35.0), 10, SteadyPart::exact).steady_force_amplitude();
  const auto missed = [exact](int count) {
    return StickResponse(paper_beam(), shaking(35.0), count).steady_force_amplitude() - exact;
  };
  std::vector<OrderLevel> of_sum, of_terms;
  for (const int count : {25, 50, 100, 200, 400, 1000}) {
    const double sum = missed(count), before = missed(count - 1);
    EXPECT_LT(sum * before, 0.0);
    const double b = (count + 0.25) * pi;
    const double floor = round_off(std::sqrt(count), 1, exact).value;
    of_sum.push_back({.step = 1.0 / (count + 0.75),
                      .error = std::abs(sum),
                      .next_term = 1.0 / std::pow(count, 2) + terms.next_term(b),
                      .floor = floor});
    of_terms.push_back(
        {.step = 1.0 / b, .error = std::abs(sum - before), .next_term = terms.next_term(b), .floor = floor});
  }
  EXPECT_TRUE(order_is(of_sum, 2.0, terms.scale / (2.0 * pi * pi)));
  EXPECT_TRUE(order_is(of_terms, 2.0, terms.scale));
}

TEST(StickResponse, FreeVibrationsFallWithTheFourthPower) {
  const TermsOfTheForce terms;
  const auto transient = StickResponse(paper_beam(), shaking(35.0), 200).transient_force();
  std::vector<OrderLevel> levels;
  for (std::size_t n = 20; n <= 200; n += 20) {
    const double b = (static_cast<double>(n) + 0.25) * pi;
    levels.push_back({.step = 1.0 / b,
                      .error = std::abs(transient[n - 1].amplitude),
                      .next_term = terms.next_term(b),
                      .floor = round_off(10, 1, transient[n - 1].amplitude).value});
  }
  EXPECT_TRUE(order_is(levels, 4.0, terms.scale * terms.omega / terms.natural));
}

TEST(StickResponse, OmittedTransientBoundHoldsWhereTheLawIsReached) {
  for (const double factor : {-1e4, -300.0, -5.0, 0.12, 19.0}) {
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const auto all = StickResponse(beam, shaking(12.0), 1000).transient_force();
    for (const int count : {1, 2, 5, 10, 40, 100}) {
      double omitted = 0.0;
      for (auto n = static_cast<std::size_t>(count); n < all.size(); ++n)
        omitted += std::abs(all[n].amplitude);
      const double bound = StickResponse(beam, shaking(12.0), count).omitted_transient_bound();
      EXPECT_GE(bound, omitted) << factor << ", " << count;
    }
  }
  EXPECT_LT(StickResponse(paper_beam(), shaking(35.0), 10).omitted_transient_bound(), 0.2);
  EXPECT_TRUE(std::isinf(StickResponse(paper_beam(), shaking(35.0), 1).omitted_transient_bound()));
  EXPECT_TRUE(std::isinf(
      StickResponse(paper_beam_with_load_factor(-1e4), shaking(35.0), 10).omitted_transient_bound()));
}

TEST(StickResponse, RefusesExactSteadyPartAboveItsModes) {
  expect_error_message<std::invalid_argument>(
      [] { StickResponse(paper_beam(), shaking(50.0), 2, SteadyPart::exact); },
      {"numerics.modes is 2, but must be so large"});
  EXPECT_NO_THROW(StickResponse(paper_beam(), shaking(50.0), 3, SteadyPart::exact));
  EXPECT_NO_THROW(StickResponse(paper_beam(), shaking(50.0), 2, SteadyPart::modal_sum));
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

TEST(SampledMaximum, ExcessIsTheInterpolationErrorOfTheStep) {
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

STICKSLIP_VERIFIES(MaximumForce, "A5");
TEST(MaximumForce, IsWithinOnePercentOfThePrintedValues) {
  // A0 = 0.5 mm over 10 s: ten modes and the limit of many modes, both sampled every 1e-4 s, and the latter's
  // true maximum.
  struct Maximum {
    double frequency_hz, ten_modes, accuracy, limit, limit_accuracy, between_samples, printed;
  };
  const std::array<Maximum, 4> table{{{15.0, 40.463, 0.5e-3, 40.57, 0.5e-2, 40.58, 40.38},
                                      {25.0, 30465.5, 0.05, 30465.3, 0.05, 30465.3, 3.03e4},
                                      {35.0, 255.165, 0.5e-3, 254.6, 0.05, 254.6, 254.87},
                                      {70.0, 977.86, 0.5e-2, 975.6, 0.05, 975.7, 977.54}}};
  for (const auto& row : table) {
    const StickResponse ten(paper_beam(), shaking(row.frequency_hz));
    const StickResponse forty(paper_beam(), shaking(row.frequency_hz), 40, SteadyPart::exact);
    const double of_ten = ten.sampled_max_abs_friction_force(10.0, 1e-4).lower;
    const double of_forty = forty.sampled_max_abs_friction_force(10.0, 1e-4).lower;
    const double true_maximum = forty.max_abs_friction_force(10.0, 1e-7).midpoint();
    EXPECT_TRUE(within(of_ten, row.ten_modes, reference(row.accuracy, "the digits given")));
    EXPECT_TRUE(within(of_forty, row.limit, reference(row.limit_accuracy, "the digits given")));
    EXPECT_TRUE(within(true_maximum, row.between_samples, reference(row.limit_accuracy, "the digits given")));
    for (const double maximum : {of_ten, of_forty, true_maximum})
      EXPECT_TRUE(within(maximum, row.printed, reference(0.01 * row.printed, "the paper, to 1 %")));
  }
}

TEST(MaximumForce, IsFoundAtExactResonance) {
  // The envelope of the resonant mode is EI A0 |U'''(L) C| (Omega t)/2; the others add at most their
  // amplitudes.
  const data::Beam beam = paper_beam();
  const StickMode mode = stick_modes(beam, 1).front();
  const StickResponse response(beam, shaking(mode.frequency_hz()), 10, SteadyPart::exact);
  const double per_radian =
      rigidity(beam) * 0.5e-3 * std::abs(mode.third_derivative(2.0) * mode.participation()) / 2.0;
  const double envelope = per_radian * mode.angular_frequency() * 10.0;
  const Bounds bounds = response.max_abs_friction_force(10.0, 1e-13);
  const double rounding =
      0.5e-3 * ForceMaximum(response.reaction(), mode.angular_frequency(), 10.0).rounding();
  EXPECT_LE(bounds.upper - bounds.lower, 1e-13 * bounds.lower + 3.0 * rounding);
  EXPECT_LE(rounding, 1e-12 * bounds.lower);
  EXPECT_TRUE(within(bounds.midpoint(), envelope,
                     discretisation(per_radian * (2.0 * pi + 1.0) + 10.0, 1.0,
                                    "the last crest, a period at most before the end, and the other modes")));
}

TEST(MaximumForce, SurvivesExtremeAmplitudesAndDurations) {
  for (const double amplitude : {1e-300, 1e250}) {
    const StickResponse response(paper_beam(), shaking(15.0, amplitude));
    const Bounds bounds = response.max_abs_friction_force(1.0);
    EXPECT_GT(bounds.lower, 0.0);
    EXPECT_TRUE(std::isfinite(bounds.upper));
  }
  const StickResponse at_rest(paper_beam(), shaking(25.0, 0.0));
  EXPECT_EQ(at_rest.max_abs_friction_force(10.0).upper, 0.0);
  EXPECT_EQ(at_rest.sampled_max_abs_friction_force(10.0, 1e-3).upper, 0.0);
  // While f still rises, its largest value is the last: f = EI A0 S'''(L) Omega t to leading order.
  const StickResponse response(paper_beam(), shaking(15.0));
  const Bounds bounds = response.max_abs_friction_force(1e-9);
  const double last = std::abs(response.friction_force(1e-9));
  EXPECT_TRUE(within(bounds.lower, last, reference(1e-10 * last, "relative width of the bounds")));
}

TEST(MaximumForce, RefusesBadArgumentsAndSaysWhich) {
  const StickResponse response(paper_beam(), shaking(15.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double duration : {0.0, -1.0, nan}) {
    EXPECT_THROW((void)response.max_abs_friction_force(duration), std::invalid_argument);
    EXPECT_THROW((void)response.max_abs_friction_force_by_halving(duration, 1e-3), data::FieldError);
    EXPECT_THROW((void)response.sampled_max_abs_friction_force(duration, 1e-3), std::invalid_argument);
  }
  for (const double width : {0.0, 1e-14, 0.99e-13, 1.0, nan}) {
    EXPECT_THROW((void)response.max_abs_friction_force(1.0, width), std::invalid_argument);
    EXPECT_THROW((void)response.max_abs_friction_force_by_halving(1e-9, width), std::invalid_argument);
  }
  EXPECT_NO_THROW((void)response.max_abs_friction_force_by_halving(1e-9, 1e-13));
  EXPECT_THROW((void)response.sampled_max_abs_friction_force(1.0, 0.0), std::invalid_argument);
  EXPECT_THROW((void)response.sampled_max_abs_friction_force(1.0, 1e-300), std::invalid_argument);
  EXPECT_THROW((void)response.max_abs_friction_force(1e300), std::invalid_argument);
  EXPECT_EQ(error_message_of<std::invalid_argument>([&] { (void)response.max_abs_friction_force(-1.0); }),
            "excitation.duration is -1, but must be positive and finite");
}

}  // namespace
}  // namespace stickslip::testing
