// SPDX-License-Identifier: MIT
/// The damped steady vibration in closed form: it solves its equation and its boundary conditions, dissipates
/// what is put in, tends to the undamped one, and is the sum over the modes where those decouple.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

using analytic::DampedSteadyState;
using analytic::TipSupport;
using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double amplitude = Vibration::amplitude;  // A0, m
constexpr double length = 2.0;                      // L, m
constexpr double mass_per_length = 10.0;            // rho A, kg/m
constexpr double rigidity = 2e9 * 1e-4 / 12.0;      // E I, N m^2

Complex complex_rigidity(const Vibration& v) {
  return rigidity * Complex(1.0, v.omega() * v.damping.kelvin_voigt());
}

Vibration vibration(double axial_force, double hz, double eta, TipSupport tip) {
  return {hz, data::Damping({.kelvin_voigt = eta}), tip, axial_force};
}

// All axial forces keep away from buckling (84.1 kN); frequencies from quasi-static to far beyond the modes
// that matter. At eta = 5e-3 s and 3 kHz the rigidity has an argument of 89.4 degrees.
std::vector<Vibration> vibrations() {
  std::vector<Vibration> all;
  for (const double axial_force : {-3e4, 0.0, 500.0, 4e4})
    for (const double hz : {5.0, 25.0, 70.0, 400.0, 3000.0})
      for (const double eta : {0.0, 6.4e-5, 5e-3})
        for (const TipSupport tip : {TipSupport::held, TipSupport::free})
          all.push_back(vibration(axial_force, hz, eta, tip));
  return all;
}

// max |d^order Y/dx^order| over the beam.
double largest_derivative(const DampedSteadyState& solution, int order) {
  double largest = 0.0;
  for (int i = 0; i <= 200; ++i)
    largest = std::max(largest, std::abs(solution.derivative(order, length * i / 200.0)));
  return largest;
}

// The weights are known to about 50 eps of the largest one; where the exponents are large, exp(-r) costs |r|
// eps, and |r| stays below 45.
Tolerance rounding(double scale) { return round_off(50, 45, scale); }

STICKSLIP_VERIFIES(DampedSteadyState, "A7");
TEST(DampedSteadyState, SolvesTheEquationOfMotion) {
  for (const Vibration& v : vibrations()) {
    const DampedSteadyState solution = v.solution();
    const double inertia = mass_per_length * v.omega() * v.omega();
    const double scale = inertia * largest_derivative(solution, 0) +
                         std::abs(complex_rigidity(v)) * largest_derivative(solution, 4);
    for (const double x : {0.0, 0.31, 1.0, 1.77, 2.0})
      EXPECT_TRUE(within(complex_rigidity(v) * solution.derivative(4, x) +
                             v.axial_force * solution.derivative(2, x) - inertia * solution.displacement(x),
                         0.0, rounding(scale)))
          << v.name() << ", x = " << x;
  }
}

TEST(DampedSteadyState, IsClampedInTheBaseAndHeldOrFreeAtTheTip) {
  for (const Vibration& v : vibrations()) {
    const DampedSteadyState solution = v.solution();
    const auto expect_zero = [&](int order, double x) {
      EXPECT_TRUE(within(solution.derivative(order, x), 0.0, rounding(largest_derivative(solution, order))))
          << v.name() << ", derivative " << order << " at " << x;
    };
    EXPECT_TRUE(within(solution.displacement(0.0), amplitude, rounding(largest_derivative(solution, 0))))
        << v.name();
    expect_zero(1, 0.0);
    expect_zero(2, length);
    expect_zero(v.tip == TipSupport::held ? 0 : 3, length);
  }
}

TEST(DampedSteadyState, DerivativesAreThoseOfTheDisplacement) {
  // Central differences of eighth order: the error is d^8/630 of the ninth derivative, and eps/d of the
  // function.
  const Vibration v = vibration(500.0, 70.0, 5e-4, TipSupport::held);
  const DampedSteadyState solution = v.solution();
  constexpr double d = 0.01;
  const double weights[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  for (int order = 0; order < 4; ++order)
    for (const double x : {0.3, 1.1, 1.9}) {
      Complex difference = 0.0;
      for (int k = 1; k <= 4; ++k)
        difference += weights[k - 1] / d *
                      (solution.derivative(order, x + k * d) - solution.derivative(order, x - k * d));
      const double truncation = std::pow(d, 8) / 630.0 * largest_derivative(solution, order + 9);
      EXPECT_TRUE(within(difference, solution.derivative(order + 1, x),
                         discretisation(truncation + rounding(largest_derivative(solution, order) / d).value,
                                        1.0, "d^8/630 of the ninth derivative, eps/d of the function")));
    }
}

TEST(DampedSteadyState, IsTheUndampedSteadyPartWithoutDamping) {
  for (const double axial_force : {-3e4, 0.0, 500.0, 4e4})
    for (const double hz : {5.0, 15.0, 35.0, 70.0}) {
      const Vibration v = vibration(axial_force, hz, 0.0, TipSupport::held);
      const DampedSteadyState solution = v.solution();
      const analytic::StickResponse response(paper_beam_with_axial_force(axial_force),
                                             data::HarmonicExcitation({hz, amplitude}), 10,
                                             analytic::SteadyPart::exact);
      // The nearest natural frequency is 10 % off at least: a condition of 10.
      const double force = response.steady_force_amplitude();
      EXPECT_TRUE(within(solution.friction_force(), force, round_off(100, 100, force))) << v.name();
      for (const double x : {0.4, 1.0, 1.7}) {
        const double relative = response.steady_displacement_amplitude(x);
        EXPECT_TRUE(within(solution.displacement(x), amplitude + relative,
                           round_off(100, 100, amplitude + std::abs(relative))))
            << v.name() << ", x = " << x;
      }
      EXPECT_EQ(solution.dissipated_energy(), 0.0);
    }
}

// Simpson's rule for complex functions; n even.
template <class Function>
Complex integral(const Function& function, int n) {
  Complex sum = 0.0;
  for (int i = 0; i <= n; ++i) sum += simpson_weight(i, n) * function(length * i / n);
  return sum * length / (3.0 * n);
}

TEST(DampedSteadyState, DissipatesWhatTheBaseAndTheFollowerForcePutIn) {
  for (const Vibration& v : vibrations()) {
    const DampedSteadyState solution = v.solution();
    const Complex base = amplitude * complex_rigidity(v) * solution.derivative(3, 0.0);
    const Complex follower =
        v.axial_force * solution.derivative(1, length) * std::conj(solution.displacement(length));
    const double scale = pi * (std::abs(base) + std::abs(v.axial_force) * largest_derivative(solution, 1) *
                                                    largest_derivative(solution, 0));
    EXPECT_TRUE(within(solution.dissipated_energy(), pi * (base - follower).imag(), rounding(scale)))
        << v.name();
    EXPECT_EQ(solution.dissipated_energy() > 0.0, v.damping.kelvin_voigt() > 0.0) << v.name();
  }
}

TEST(DampedSteadyState, DissipatesTheSquaredCurvatureRate) {
  // Simpson's rule on n intervals, its error estimated by halving them; the integrand oscillates at most with
  // 2 |r|.
  // Besides, so little damping that the waves of a pair hardly differ, and so many waves that sinh overflows.
  std::vector<Vibration> all = vibrations();
  for (const TipSupport tip : {TipSupport::held, TipSupport::free}) {
    all.push_back(vibration(500.0, 15.0, 1e-13, tip));
    all.push_back(vibration(500.0, 2e6, 1e-9, tip));
  }
  for (const Vibration& v : all) {
    const int intervals = v.hz < 1e6 ? 4000 : 32000;
    const DampedSteadyState solution = v.solution();
    const auto density = [&](double x) { return Complex(std::norm(solution.derivative(2, x))); };
    const double factor = pi * v.omega() * v.damping.kelvin_voigt() * rigidity;
    const double fine = factor * integral(density, intervals).real(),
                 coarse = factor * integral(density, intervals / 2).real();
    EXPECT_TRUE(
        within(solution.dissipated_energy(), fine,
               discretisation(std::abs(fine - coarse) + rounding(fine).value, 1.0, "Simpson's rule, halved")))
        << v.name();
  }
}

TEST(DampedSteadyState, FrictionForceBalancesTheInertiaOfTheBeam) {
  // P = 0. With G = (3 xi^2 - xi^3)/2, which has G'''' = 0 and moves the tip by 1: f = rho A Omega^2 int G Y
  // dx + 3 D A0/L^3.
  for (const double hz : {5.0, 25.0, 70.0, 400.0})
    for (const double eta : {6.4e-5, 5e-3}) {
      const Vibration v = vibration(0.0, hz, eta, TipSupport::held);
      const DampedSteadyState solution = v.solution();
      const auto weighted = [&](double x) {
        const double xi = x / length;
        return 0.5 * xi * xi * (3.0 - xi) * solution.displacement(x);
      };
      const double inertia = mass_per_length * v.omega() * v.omega();
      const Complex fine = inertia * integral(weighted, 4000), coarse = inertia * integral(weighted, 2000);
      const Complex static_force = 3.0 * complex_rigidity(v) * amplitude / (length * length * length);
      EXPECT_TRUE(within(
          solution.friction_force(), fine + static_force,
          discretisation(std::abs(fine - coarse) + rounding(std::abs(fine) + std::abs(static_force)).value,
                         1.0, "Simpson's rule, halved")))
          << v.name();
    }
}

// Against amplitude * (rigid + sum of modes), each with participation(mode) = int W (1 + S) dx/int W^2 dx.
// Terms fall as n^-5, so that what is left out behind N is about N/4 of the last one.
template <class Mode, class Participation>
void expect_sum_over_modes(const Vibration& v, double x, double rigid, const std::vector<Mode>& modes,
                           const Participation& participation) {
  const DampedSteadyState solution = v.solution();
  const double square = v.omega() * v.omega();
  const int count = static_cast<int>(modes.size());
  Complex sum = rigid;
  double largest_late_term = 0.0;
  for (const Mode& mode : modes) {
    const double natural = mode.angular_frequency();
    const Complex term = mode.shape(x) * square * participation(mode) /
                         (natural * natural * Complex(1.0, v.omega() * v.damping.kelvin_voigt()) - square);
    sum += term;
    if (mode.number() > count - 3) largest_late_term = std::max(largest_late_term, std::abs(term));
  }
  EXPECT_TRUE(within(solution.displacement(x), amplitude * sum,
                     discretisation(amplitude * largest_late_term * count / 4.0 +
                                        rounding(largest_derivative(solution, 0)).value,
                                    1.0, "modes left out, n^-5")))
      << v.name() << ", x = " << x;
}

TEST(DampedSteadyState, WithoutAxialForceIsTheSumOverTheStickModes) {
  const data::Beam beam = paper_beam_with_axial_force(0.0);
  const auto modes = analytic::stick_modes(beam, 60);
  const analytic::QuasiStaticShape shape(beam);
  const auto participation = [](const analytic::StickMode& mode) {
    return mode.load_integral() / mode.norm_squared();
  };
  for (const double hz : {15.0, 25.0, 81.0})
    for (const double eta : {6.4e-5, 5e-3})
      for (const double x : {0.4, 1.0, 1.7})
        expect_sum_over_modes(vibration(0.0, hz, eta, TipSupport::held), x, 1.0 + shape.value(x), modes,
                              participation);
}

TEST(DampedSteadyState, WithoutAxialForceIsTheSumOverTheFreeModes) {
  // Modes of unit tip deflection have int W^2 dx = L/4 and int W dx = (-1)^(n+1) sigma/beta with
  // sigma = (cosh b + cos b)/(sinh b + sin b), b = beta L.
  const auto modes = analytic::slip_modes(paper_beam_with_axial_force(0.0), 60);
  const auto participation = [](const analytic::SlipMode& mode) {
    const double b = mode.trigonometric_wave_number() * length;
    const double sigma = (1.0 + std::cos(b) / std::cosh(b)) / (std::tanh(b) + std::sin(b) / std::cosh(b));
    return (mode.number() % 2 == 1 ? 4.0 : -4.0) * sigma / b;
  };
  for (const double hz : {5.0, 25.0, 81.0})
    for (const double eta : {6.4e-5, 5e-3})
      for (const double x : {0.4, 1.0, 2.0})
        expect_sum_over_modes(vibration(0.0, hz, eta, TipSupport::free), x, 1.0, modes, participation);
}

TEST(DampedSteadyState, LagsBehindTheBaseByAQuarterPeriodAtResonance) {
  // Free tip, P = 0, at its lowest frequency: the tip is -i C/(2 zeta) of the base, with 2 zeta = eta omega
  // and C = 1.566 the participation of the mode; the other modes add O(1).
  const double omega = analytic::slip_modes(paper_beam_with_axial_force(0.0), 1).front().angular_frequency();
  const Vibration v = vibration(0.0, omega / (2.0 * pi), 1e-5, TipSupport::free);
  const Complex tip = v.solution().displacement(length) / amplitude;
  EXPECT_TRUE(within(tip * omega * 1e-5, Complex(0.0, -1.566),
                     discretisation(2.0 * omega * 1e-5, 1.0, "the other modes")));
}

TEST(DampedSteadyState, SlowShakingBendsTheBeamIntoTheMasslessShape) {
  // Y = A0 (1 + S) up to (Omega/omega_1)^2, whatever the damping, with the tip held.
  for (const double factor : {-20.0, 0.12, 15.0}) {
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const analytic::QuasiStaticShape shape(beam);
    const double natural = analytic::stick_modes(beam, 1).front().angular_frequency(), hz = 0.1;
    const DampedSteadyState steady(beam, data::HarmonicExcitation({hz, amplitude}),
                                   data::Damping({.kelvin_voigt = 6.4e-5}), TipSupport::held);
    const double first =
        std::pow(2.0 * pi * hz / natural, 2) + 2.0 * pi * hz * 6.4e-5 * std::abs(factor) / 20.0;
    for (const double x : {0.4, 1.0, 1.7})
      EXPECT_TRUE(within(steady.displacement(x) / amplitude, 1.0 + shape.value(x),
                         discretisation(first, 2.0, "(Omega/omega_1)^2, and the loss angle times z/z_cr")))
          << factor;
  }
}

TEST(DampedSteadyState, RefusesModalDamping) {
  expect_error_message<std::invalid_argument>(
      [] {
        (void)DampedSteadyState(paper_beam(), data::HarmonicExcitation({25.0, 1e-3}),
                                data::Damping({.ratio = 0.01}), TipSupport::held);
      },
      {"damping.ratio is 0.01, but must be 0"});
}

}  // namespace
}  // namespace stickslip::testing
