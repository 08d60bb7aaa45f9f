// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analytic/gsl.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/order.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::QuasiStaticShape;
using analytic::stick_buckling_load;
using analytic::stick_modes;
using analytic::StickMode;
using std::numbers::pi;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// From strong tension to just under buckling.
const std::vector<double> kLoadFactors{-1e4, -0.9 * buckling_factor, -0.1 * buckling_factor,
                                       0.0,  1e-9 * buckling_factor, 0.5 * buckling_factor,
                                       15.0, 0.99 * buckling_factor};

/// k = rho A omega^2/EI.
double stiffness_ratio(const data::Beam& beam, const StickMode& mode) {
  return beam.density() * beam.area() * std::pow(mode.angular_frequency(), 2) / rigidity(beam);
}

::testing::AssertionResult has_derivative(const RealFunction& function, double x, double h, double expected) {
  const Estimate slope = derivative(function, x, h);
  return within(slope.value, expected, discretisation(slope.error, 2.0, "GSL's estimate"));
}

STICKSLIP_VERIFIES(StickModes, "A2");
TEST(StickModes, AreClampedPinnedWithoutAxialForce) {
  const std::array classical{3.926602312047919, 7.068582745628732, 10.210176122813031};
  const auto modes = stick_modes(paper_beam_with_axial_force(0.0), 3);
  for (std::size_t i = 0; i < classical.size(); ++i) {
    const Tolerance tolerance = round_off(5, 1, classical[i]);
    ASSERT_LT(tolerance.value, 1e-12);
    EXPECT_TRUE(within(modes[i].trigonometric_wave_number() * 2.0, classical[i], tolerance));
    EXPECT_TRUE(within(modes[i].hyperbolic_wave_number() * 2.0, classical[i], tolerance));
  }
}

TEST(StickModes, AgreeWithThirtyDigitArithmetic) {
  // Roots of the characteristic equation by Newton's method with 30 digits, paper's beam.
  const std::array<std::pair<std::size_t, double>, 5> expected{{{1, 24.971958092670671711},
                                                                {2, 81.07762173379387142},
                                                                {3, 169.24871773414571784},
                                                                {10, 1684.2542060420505723},
                                                                {200, 642879.00705350378616}}};
  const auto modes = stick_modes(paper_beam(), 200);
  for (const auto& [number, frequency] : expected) {
    const StickMode& mode = modes[number - 1];
    EXPECT_TRUE(within(mode.frequency_hz(), frequency, round_off(4, mode.condition_number(), frequency)));
  }
}

// Eq. (23) has one root in each bracket (CertifiedStickModes.LieOneInEachAsymptoticInterval).
TEST(StickModes, LieOneInEachBracket) {
  for (const double factor : kLoadFactors) {
    SCOPED_TRACE(factor);
    const auto modes = stick_modes(paper_beam_with_load_factor(factor), 20);
    for (int n = 1; n <= 20; ++n) {
      const StickMode& mode = modes[static_cast<std::size_t>(n) - 1];
      EXPECT_EQ(mode.number(), n);
      EXPECT_GT(mode.trigonometric_wave_number() * 2.0, n * pi);
      EXPECT_LT(mode.trigonometric_wave_number() * 2.0, (n + 0.5) * pi);
    }
  }
}

TEST(StickModes, WaveNumbersSatisfyTheDispersionRelation) {
  for (const double factor : kLoadFactors) {
    SCOPED_TRACE(factor);
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const double p = beam.axial_force() / rigidity(beam);
    for (const StickMode& mode : stick_modes(beam, 5)) {
      const double b2 = std::pow(mode.hyperbolic_wave_number(), 2);
      const double bb2 = std::pow(mode.trigonometric_wave_number(), 2);
      const double k = stiffness_ratio(beam, mode);
      EXPECT_TRUE(within(b2 * (b2 + p), k, round_off(10, 1, b2 * (b2 + std::abs(p)))));
      EXPECT_TRUE(within(bb2 * (bb2 - p), k, round_off(10, 1, bb2 * (bb2 + std::abs(p)))));
    }
  }
}

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

TEST(StickModes, ConditionNumberIsTheSensitivityToTheAxialForce) {
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

TEST(StickModes, VibrateLikeAStringUnderStrongTension) {
  // s = sqrt(-P L^2/EI) >> 1. The clamp shortens the string by L/s: omega = n pi/L sqrt(-P/rho A) (1 + 1/s +
  // r), r = (1 + (n pi)^2/2)/s^2 + O(s^-3), from tan(bb) = bb/b, b^2 = bb^2 + s^2.
  for (const double s : {100.0, 1000.0}) {
    const data::Beam beam = paper_beam_with_load_factor(-s * s);
    for (const StickMode& mode : stick_modes(beam, 3)) {
      const double order = mode.number() * pi;
      const double string =
          order / beam.length() * std::sqrt(-beam.axial_force() / (beam.density() * beam.area()));
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
        integral([&](double x) { return std::pow(1.0 + shape.value(x), 2); }, 0.0, 2.0, 2.0);
    for (const int count : {10, 100, 1000}) {
      double sum = 0.0;
      for (const StickMode& mode : stick_modes(beam, count))
        sum += std::pow(mode.participation(), 2) * mode.norm_squared();
      const double tail = 4.0 * beam.length() / (pi * pi * (count + 0.75));
      const double next = tail * (1.0 / 12.0 + std::abs(factor) / (pi * pi)) / (count * count);
      EXPECT_TRUE(within(sum + tail, whole.value,
                         discretisation(next + whole.error + round_off(count, 1, 1.0).value, 2.0,
                                        "next terms of the tail, quadrature, round-off")))
          << count << " modes at P L^2/EI = " << factor;
    }
  }
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

TEST(StickModes, DerivativesSatisfyTheEquation) {
  for (const double factor : kLoadFactors) {
    SCOPED_TRACE(factor);
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const double p = beam.axial_force() / rigidity(beam);
    for (const StickMode& mode : stick_modes(beam, 4)) {
      const double k = stiffness_ratio(beam, mode);
      const double h = 0.02 / (mode.hyperbolic_wave_number() + mode.trigonometric_wave_number());
      for (const double x : {0.1, 0.777, 1.3, 1.9}) {
        EXPECT_TRUE(has_derivative([&](double s) { return mode.shape(s); }, x, h, mode.slope(x)));
        EXPECT_TRUE(has_derivative([&](double s) { return mode.slope(s); }, x, h, mode.curvature(x)));
        EXPECT_TRUE(
            has_derivative([&](double s) { return mode.curvature(s); }, x, h, mode.third_derivative(x)));
        EXPECT_TRUE(has_derivative([&](double s) { return mode.third_derivative(s); }, x, h,
                                   k * mode.shape(x) - p * mode.curvature(x)));
      }
    }
  }
}

TEST(StickModes, AreOrthogonal) {
  const std::array<std::pair<std::size_t, std::size_t>, 6> pairs{
      {{1, 2}, {1, 3}, {1, 10}, {9, 10}, {49, 50}, {199, 200}}};
  for (const double factor : {-1e4, 0.0, 15.0}) {
    const auto modes = stick_modes(paper_beam_with_load_factor(factor), 200);
    for (const auto& [m, n] : pairs) {
      const StickMode &first = modes[m - 1], &second = modes[n - 1];
      const double scale = std::sqrt(first.norm_squared() * second.norm_squared());
      const Estimate product =
          integral([&](double x) { return first.shape(x) * second.shape(x); }, 0.0, 2.0, scale);
      // What bb carries in round-off shifts the argument of the sine by bb eps.
      const double bb = second.trigonometric_wave_number() * 2.0;
      EXPECT_TRUE(within(
          product.value / scale, 0.0,
          discretisation(product.error / scale + round_off(1, bb, 1).value, 1.0, "quadrature and round-off")))
          << m << ", " << n << " at P L^2/EI = " << factor;
    }
  }
}

TEST(StickModes, ClosedFormIntegralsAgreeWithQuadrature) {
  for (const double factor : kLoadFactors) {
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const QuasiStaticShape quasi_static(beam);
    const double load_square =
        integral([&](double x) { return std::pow(1.0 + quasi_static.value(x), 2); }, 0.0, 2.0, 1.0).value;
    for (const StickMode& mode : stick_modes(beam, 12)) {
      const auto square = [&](double x) { return std::pow(mode.shape(x), 2); };
      const auto load = [&](double x) { return mode.shape(x) * (1.0 + quasi_static.value(x)); };
      // Cauchy-Schwarz bounds what cancels inside the integral.
      const double load_scale = std::sqrt(mode.norm_squared() * load_square);
      const Estimate norm = integral(square, 0.0, 2.0, mode.norm_squared());
      const Estimate load_integral = integral(load, 0.0, 2.0, load_scale);
      const double condition = mode.condition_number() * mode.trigonometric_wave_number() * 2.0;
      EXPECT_TRUE(within(mode.norm_squared(), norm.value,
                         discretisation(norm.error + round_off(2, condition, norm.value).value, 1.0,
                                        "quadrature, round-off")));
      EXPECT_TRUE(within(mode.load_integral(), load_integral.value,
                         discretisation(load_integral.error + round_off(2, condition, load_scale).value, 1.0,
                                        "quadrature, round-off")))
          << "P L^2/EI = " << factor << ", mode " << mode.number();
      EXPECT_DOUBLE_EQ(mode.participation(), -mode.load_integral() / mode.norm_squared());
    }
  }
}

STICKSLIP_VERIFIES(QuasiStaticShape, "A1");
TEST(QuasiStaticShape, MeetsItsBoundaryConditions) {
  for (const double factor : kLoadFactors) {
    const QuasiStaticShape shape(paper_beam_with_load_factor(factor));
    const double condition = std::abs(buckling_factor / (buckling_factor - std::max(0.0, factor)));
    EXPECT_TRUE(within(shape.value(0.0), 0.0, round_off(4, condition, 1.0)));
    EXPECT_TRUE(within(shape.slope(0.0), 0.0, round_off(4, condition, 1.0)));
    EXPECT_TRUE(within(shape.value(2.0), -1.0, round_off(4, condition, 1.0)));
    EXPECT_EQ(shape.curvature(2.0), 0.0);
  }
}

TEST(QuasiStaticShape, DerivativesSatisfyTheEquation) {
  for (const double factor : kLoadFactors) {
    SCOPED_TRACE(factor);
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const double p = beam.axial_force() / rigidity(beam);
    const QuasiStaticShape shape(beam);
    const double h = 0.05 / (1.0 + std::sqrt(std::abs(p)));
    for (const double x : {0.1, 0.777, 1.3, 1.9}) {
      EXPECT_TRUE(has_derivative([&](double s) { return shape.value(s); }, x, h, shape.slope(x)));
      EXPECT_TRUE(has_derivative([&](double s) { return shape.slope(s); }, x, h, shape.curvature(x)));
      EXPECT_TRUE(
          has_derivative([&](double s) { return shape.curvature(s); }, x, h, shape.third_derivative(x)));
      EXPECT_TRUE(
          has_derivative([&](double s) { return shape.third_derivative(s); }, x, h, -p * shape.curvature(x)));
    }
  }
}

TEST(QuasiStaticShape, PassesSmoothlyThroughZeroAxialForce) {
  // S = S_0 + z S_1 + ..., S_1'''' = -S_0'' (derivatives to xi): S_1 = xi^2/10 - xi^3/5 + xi^4/8 - xi^5/40.
  // Each power of z brings the factor 1/20.19 of the buckling load to the first buckling shape, and less to
  // the others.
  const double x = 0.9, xi = 0.45;
  const double cubic = -(3.0 * xi * xi - xi * xi * xi) / 2.0;
  EXPECT_TRUE(
      within(QuasiStaticShape(paper_beam_with_load_factor(0.0)).value(x), cubic, round_off(4, 1, 1.0)));
  for (const double sign : {-1.0, 1.0}) {
    std::vector<double> factors, differences;
    for (double factor = 1e-1; factor > 1e-8; factor *= 0.1) {
      factors.push_back(factor);
      differences.push_back(
          std::abs(QuasiStaticShape(paper_beam_with_load_factor(sign * factor)).value(x) - cubic));
    }
    const double first =
        std::pow(xi, 2) / 10.0 - std::pow(xi, 3) / 5.0 + std::pow(xi, 4) / 8.0 - std::pow(xi, 5) / 40.0;
    EXPECT_TRUE(order_is(
        order_levels(
            factors, differences, [](double z) { return z / (20.19 - z); }, round_off(1, 1, cubic).value),
        1.0, first))
        << "a smooth function leaves linearly";
  }
}

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
