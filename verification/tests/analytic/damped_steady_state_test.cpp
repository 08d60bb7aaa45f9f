// SPDX-License-Identifier: MIT
/// The damped steady vibration in closed form: its equation and boundary conditions, and its dissipation.

#include "stickslip/analytic/damped_steady_state.hpp"
#include "support/integral.hpp"
#include "support/testing.hpp"
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

TEST(DampedSteadyState, MeetsItsBoundaryConditions) {
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

TEST(DampedSteadyState, DissipatesByCurvatureRate) {
  // The error of the quadrature is estimated by half as many pieces; the integrand oscillates at most with 2 |r|.
  // Besides, so little damping that the waves of a pair hardly differ, and so many waves that sinh overflows.
  std::vector<Vibration> all = vibrations();
  for (const TipSupport tip : {TipSupport::held, TipSupport::free}) {
    all.push_back(vibration(500.0, 15.0, 1e-13, tip));
    all.push_back(vibration(500.0, 2e6, 1e-9, tip));
  }
  for (const Vibration& v : all) {
    const int pieces = v.hz < 1e6 ? 1000 : 8000;
    const DampedSteadyState solution = v.solution();
    const auto density = [&](double x) { return std::norm(solution.derivative(2, x)); };
    const double factor = pi * v.omega() * v.damping.kelvin_voigt() * rigidity;
    const double fine = factor * integral(density, 0.0, length, pieces),
                 coarse = factor * integral(density, 0.0, length, pieces / 2);
    EXPECT_TRUE(
        within(solution.dissipated_energy(), fine,
               discretisation(std::abs(fine - coarse) + rounding(fine).value, 1.0, "the quadrature, halved")))
        << v.name();
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
