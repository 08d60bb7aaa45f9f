// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/gsl.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::QuasiStaticShape;
using analytic::stick_buckling_load;
using analytic::stick_modes;
using analytic::StickMode;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// From strong tension to just under buckling.
const std::vector<double> kLoadFactors{-1e4, -0.9 * buckling_factor, -0.1 * buckling_factor,
                                       0.0,  1e-9 * buckling_factor, 0.5 * buckling_factor,
                                       15.0, 0.99 * buckling_factor};

STICKSLIP_VERIFIES(StickModes, "A2");
TEST(StickModes, RayleighQuotientReturnsTheRoot) {
  for (const double factor : kLoadFactors)
    for (const data::Beam beam = paper_beam_with_load_factor(factor);
         const StickMode& mode : stick_modes(beam, 50)) {
      const double stiffness_of_mode =
          rigidity(beam) * mode.curvature_norm_squared() - beam.axial_force() * mode.slope_norm_squared();
      const double rayleigh =
          std::sqrt(stiffness_of_mode / (beam.density() * beam.area() * mode.norm_squared()));
      EXPECT_TRUE(
          within(rayleigh, mode.angular_frequency(), round_off(10, mode.condition_number(), rayleigh)))
          << "P L^2/EI = " << factor << ", mode " << mode.number();
    }
}

TEST(StickModes, ConditionNumberIsTheSensitivityToForce) {
  for (const double share : {-15.0, -0.9, 0.1, 0.5, 0.9})
    for (std::size_t n = 0; n < 3; ++n) {
      const double force = share * stick_buckling_load(paper_beam());
      const auto frequency = [n](double axial_force) {
        return stick_modes(paper_beam_with_axial_force(axial_force), 3)[n].angular_frequency();
      };
      const StickMode mode = stick_modes(paper_beam_with_axial_force(force), 3)[n];
      const Estimate slope = derivative(frequency, force, 0.01 * std::abs(force));
      const double scale = force / mode.angular_frequency();
      EXPECT_TRUE(within(1.0 + std::abs(scale * slope.value), mode.condition_number(),
                         discretisation(scale * slope.error, 1.0, "GSL's estimate of the derivative")))
          << "P/P_cr = " << share << ", mode " << n + 1;
    }
}

TEST(StickModes, FirstFrequencyVanishesAtTheBucklingLoad) {
  // First-order perturbation with the buckling shape: omega^2 = 0.6 z_cr (P_cr - P)/(rho A L^2), since
  // int U'^2 = y^2/(2 L) and int U^2 = 5 L/6 there. The relative remainder is of first order in 1 - P/P_cr.
  const double buckling_load = stick_buckling_load(paper_beam());
  std::vector<double> distances, errors;
  for (double distance = 1e-1; distance > 1e-6; distance *= 0.1) {
    const data::Beam beam = paper_beam_with_axial_force(buckling_load * (1.0 - distance));
    const double gap = buckling_load - beam.axial_force();
    const double predicted = 0.6 * buckling_factor * gap / (beam.density() * beam.area() * 4.0);
    const double omega = stick_modes(beam, 1).front().angular_frequency();
    distances.push_back(distance);
    errors.push_back(std::abs(omega * omega / predicted - 1.0));
  }
  EXPECT_LT(errors.back(), 1e-5);
  const double order = observed_order(distances, errors);
  EXPECT_GT(order, 0.9);
  EXPECT_LT(order, 1.1);
}

TEST(StickModes, RefuseTheBucklingLoadAndSayWhy) {
  const double load = stick_buckling_load(paper_beam());
  for (const double force : {load, 1.5 * load, 100.0 * load}) {
    const data::Beam beam = paper_beam_with_axial_force(force);
    expect_error_message<data::InputError>([&] { (void)stick_modes(beam, 1); },
                                           {"beam.axial_force is ", "buckling load", "84128.0"});
    EXPECT_THROW(QuasiStaticShape{beam}, data::InputError);
  }
}

TEST(StickModes, ArePositiveOrRefusedAtTheBucklingLoad) {
  const double load = stick_buckling_load(paper_beam());
  for (int ulps = 1; ulps <= 64; ulps *= 2) {
    const data::Beam beam = paper_beam_with_axial_force(load * (1.0 - ulps * 0.5 * kEpsilon));
    try {
      EXPECT_GT(stick_modes(beam, 1).front().angular_frequency(), 0.0);
    } catch (const data::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("beam.axial_force"), std::string::npos);
    }
  }
}

TEST(StickModes, RefuseACountOutOfRangeAndSayWhy) {
  for (const int count : {-1, 0, 1001})
    EXPECT_EQ(error_message_of<std::invalid_argument>([&] { (void)stick_modes(paper_beam(), count); }),
              "numerics.modes is " + std::to_string(count) + ", but must be 1 ... 1000");
}

TEST(StickModes, AThousandMeetTheirBoundaryConditions) {
  for (const double factor : {-1e4, 0.0, 15.0}) {
    for (const StickMode& mode : stick_modes(paper_beam_with_load_factor(factor), 1000)) {
      const double bb = mode.trigonometric_wave_number() * 2.0, b = mode.hyperbolic_wave_number() * 2.0;
      // The argument bb carries an error of bb eps, which the amplitude 1/sin(bb) of the trigonometric part
      // magnifies; sin(bb) >= tan/sqrt(1 + tan^2) with tan(bb) = bb tanh(b)/b.
      const double tangent = bb * std::tanh(b) / b;
      const double amplitude = std::hypot(1.0, 1.0 / tangent);
      EXPECT_TRUE(within(mode.shape(0.0), 0.0, round_off(2, bb, amplitude)));
      EXPECT_TRUE(within(mode.slope(0.0) * 2.0, 0.0, round_off(2, b + bb, (b + bb) * amplitude)));
      EXPECT_EQ(mode.shape(2.0), 0.0);
      EXPECT_EQ(mode.curvature(2.0), 0.0);
      EXPECT_TRUE(within(mode.curvature(0.0) * 4.0, b * b + bb * bb,
                         round_off(2, bb, (b * b + bb * bb) * amplitude)));
      ASSERT_TRUE(std::isfinite(mode.third_derivative(2.0)) && std::isfinite(mode.participation()));
    }
  }
}

STICKSLIP_VERIFIES(QuasiStaticShape, "A1");
TEST(QuasiStaticShape, BecomesATautStringUnderStrongTension) {
  // With s = sqrt(-z) and exp(-s) below round-off: S = -[xi - (1 - exp(-s xi))/s]/(1 - 1/s).
  for (const double factor : {-1e4, -1e6, -1e10}) {
    const QuasiStaticShape shape(paper_beam_with_load_factor(factor));
    const double s = std::sqrt(-factor);
    for (const double xi : {0.0, 0.001, 0.1, 0.5, 0.9})
      EXPECT_TRUE(within(shape.value(2.0 * xi), -(xi + std::expm1(-s * xi) / s) / (1.0 - 1.0 / s),
                         round_off(4, 1, 1.0)));
  }
}

}  // namespace
}  // namespace stickslip::testing
