// SPDX-License-Identifier: MIT
/// What theory says of the closed forms: limits of strong tension and slow shaking, sums over all modes, the change of
/// the slip frequencies with the axial force, and the moment at the tip.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "analytic/gsl.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/beams.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::QuasiStaticShape;
using analytic::slip_modes;
using analytic::SlipMode;
using analytic::SteadyPart;
using analytic::stick_modes;
using analytic::StickMode;
using analytic::StickResponse;
using std::numbers::pi;

constexpr double length = 2.0;
constexpr double amplitude = 0.5e-3;

double mass(const data::Beam& beam) { return beam.density() * beam.area(); }

double axial_force_of(double load_factor) { return load_factor * rigidity(paper_beam()) / (length * length); }

data::HarmonicExcitation shaking(double hz) { return data::HarmonicExcitation({hz, amplitude}); }

STICKSLIP_VERIFIES(StickModes, "A2");
TEST(StickModes, VibrateLikeAStringUnderStrongTension) {
  // s = sqrt(-P L^2/EI) >> 1. The clamp shortens the string by L/s: omega = n pi/L sqrt(-P/rho A) (1 + 1/s +
  // r), r = (1 + (n pi)^2/2)/s^2 + O(s^-3), from tan(bb) = bb/b, b^2 = bb^2 + s^2.
  for (const double s : {100.0, 1000.0}) {
    const data::Beam beam = paper_beam_with_load_factor(-s * s);
    for (const StickMode& mode : stick_modes(beam, 3)) {
      const double order = mode.number() * pi;
      const double string = order / length * std::sqrt(-beam.axial_force() / mass(beam));
      const double second = (1.0 + 0.5 * order * order) / (s * s);
      EXPECT_TRUE(within(mode.angular_frequency() / string, 1.0 + 1.0 / s + second,
                         discretisation(order * order * order / (s * s * s), 1.0, "s^-3")));
    }
  }
}

TEST(StickModes, ParticipationsAddUpToTheWholeLoad) {
  // Parseval: sum C_n^2 int U_n^2 = int (1 + S)^2. Behind N the terms are 4 L/((n + 1/4) pi)^2, exactly so at
  // P = 0 but for exponentials; that tail is 4 L/(pi^2 (N + 3/4)) to within 1/(12 N^2) of itself, and P adds
  // z/(N pi)^2.
  for (const double factor : {-20.0, 0.0, 15.0}) {
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const QuasiStaticShape shape(beam);
    const Estimate whole =
        integral([&](double x) { return std::pow(1.0 + shape.value(x), 2); }, 0.0, length, length);
    for (const int count : {10, 100, 1000}) {
      double sum = 0.0;
      for (const StickMode& mode : stick_modes(beam, count))
        sum += std::pow(mode.participation(), 2) * mode.norm_squared();
      const double tail = 4.0 * length / (pi * pi * (count + 0.75));
      const double next = tail * (1.0 / 12.0 + std::abs(factor) / (pi * pi)) / (count * count);
      EXPECT_TRUE(within(sum + tail, whole.value,
                         discretisation(next + whole.error + round_off(count, 1, 1.0).value, 2.0,
                                        "next terms of the tail, quadrature, round-off")))
          << count << " modes at P L^2/EI = " << factor;
    }
  }
}

STICKSLIP_VERIFIES(StickResponse, "A4");
TEST(StickResponse, HasNoBendingMomentAtTheTip) {
  // One-sided differences: u'' - 11/12 h^2 u + h^3 u^(5). At the tip u is zero too, since it does not
  // accelerate. Each part of u has the fifth power of its own wave number in u^(5).
  const data::Beam beam = paper_beam();
  for (const SteadyPart steady : {SteadyPart::modal_sum, SteadyPart::exact}) {
    const StickResponse response(beam, shaking(15.0), 4, steady);
    const double h = 0.01 / response.modes().back().trigonometric_wave_number();
    const double steady_wave = std::sqrt(2.0 * pi * 15.0 * std::sqrt(mass(beam) / rigidity(beam)));
    double fifth = std::abs(response.steady_displacement_amplitude(1.0)) * std::pow(steady_wave, 5);
    const auto transient = response.transient_displacement(1.0);
    for (std::size_t n = 0; n < transient.size(); ++n)
      fifth +=
          std::abs(transient[n].amplitude) * std::pow(response.modes()[n].trigonometric_wave_number(), 5);
    for (const double t : {0.017, 0.05, 0.31}) {
      const auto u = [&](int steps) { return response.relative_displacement(length - steps * h, t); };
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
    const double inertia = mass(beam) * length * omega * omega * 39.0 / 280.0;
    const double at_rest = 3.0 * rigidity(beam) / std::pow(length, 3);
    const double force = StickResponse(beam, shaking(hz), 10, SteadyPart::exact).steady_force_amplitude();
    const double next = inertia * std::pow(omega / natural, 2);
    EXPECT_TRUE(within(force / amplitude - at_rest, inertia,
                       discretisation(next + round_off(30, 1, at_rest).value, 3.0, "(Omega/omega_1)^2")))
        << hz << " Hz";
  }
}

STICKSLIP_VERIFIES(DampedSteadyState, "A7");
TEST(DampedSteadyState, SlowShakingBendsTheBeamIntoTheMasslessShape) {
  // Y = A0 (1 + S) up to (Omega/omega_1)^2, whatever the damping, with the tip held.
  for (const double factor : {-20.0, 0.12, 15.0}) {
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const QuasiStaticShape shape(beam);
    const double natural = stick_modes(beam, 1).front().angular_frequency(), hz = 0.1;
    const analytic::DampedSteadyState steady(beam, shaking(hz), data::Damping({.kelvin_voigt = 6.4e-5}),
                                             analytic::TipSupport::held);
    const double first =
        std::pow(2.0 * pi * hz / natural, 2) + 2.0 * pi * hz * 6.4e-5 * std::abs(factor) / 20.0;
    for (const double x : {0.4, 1.0, 1.7})
      EXPECT_TRUE(within(std::abs(steady.displacement(x) / amplitude - (1.0 + shape.value(x))), 0.0,
                         discretisation(first, 2.0, "(Omega/omega_1)^2, and the loss angle times z/z_cr")))
          << factor;
  }
}

STICKSLIP_VERIFIES(SlipModes, "A3");
TEST(SlipModes, FrequencySquaredFollowsTheAxialForceByBothModes) {
  // d(omega^2)/dP = int psi* psi'' / (rho A int psi* psi), with the adjoint mode psi*: the boundary
  // conditions of psi do not hold P.
  for (const double factor : {-20.0, 0.0, 5.0, 15.0})
    for (std::size_t n = 0; n < 3; ++n) {
      const auto square = [n](double axial_force) {
        return std::pow(slip_modes(paper_beam_with_axial_force(axial_force), 3)[n].angular_frequency(), 2);
      };
      const SlipMode mode = slip_modes(paper_beam_with_load_factor(factor), 3)[n];
      const Estimate work = integral([&](double x) { return mode.adjoint_shape(x) * mode.curvature(x); }, 0.0,
                                     length, length * std::pow(mode.trigonometric_wave_number(), 2));
      const Estimate overlap =
          integral([&](double x) { return mode.adjoint_shape(x) * mode.shape(x); }, 0.0, length, length);
      const Estimate computed = derivative(square, axial_force_of(factor), axial_force_of(0.5));
      const double expected = work.value / (mass(paper_beam()) * overlap.value);
      EXPECT_TRUE(within(computed.value, expected, discretisation(computed.error, 2.0, "GSL's estimate")))
          << "mode " << n + 1 << " at P L^2/EI = " << factor;
    }
}

}  // namespace
}  // namespace stickslip::testing
