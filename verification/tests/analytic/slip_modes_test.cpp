// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analytic/gsl.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/order.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::slip_characteristic;
using analytic::slip_critical_load;
using analytic::slip_modes;
using analytic::SlipMode;

// d(characteristic)/d(bb) = 0 and characteristic = 0 solved by Newton's method with 30 digits. Beck: 20.05.
constexpr double kFlutterFactor = 20.0509536189737612;

data::Beam beam_with_load_factor(double factor, double axial_direction = 0.0) {
  data::BeamProperties properties = paper_beam_with_load_factor(factor).properties();
  properties.axial_direction = axial_direction;
  return data::Beam(properties);
}

STICKSLIP_VERIFIES(SlipModes, "A3");
TEST(SlipModes, AreAllSignChangesOfTheCharacteristicFunction) {
  for (const auto& [factor, chi] : {std::pair{-100.0, 0.0},
                                    {0.0, 0.0},
                                    {0.12, 0.0},
                                    {10.0, 0.0},
                                    {19.0, 0.0},
                                    {-100.0, 0.3},
                                    {15.0, 0.49},
                                    {9.3, 0.501},
                                    {-1e4, 1.0},
                                    {2.46, 1.0}}) {
    const data::Beam beam = beam_with_load_factor(factor, chi);
    const auto modes = slip_modes(beam, 9);
    const double highest = modes.back().angular_frequency() * 1.01;
    constexpr int kSteps = 20000;
    int changes = 0;
    for (int i = 1; i < kSteps; ++i)
      changes += slip_characteristic(beam, highest * i / kSteps) *
                     slip_characteristic(beam, highest * (i + 1) / kSteps) <
                 0.0;
    EXPECT_EQ(changes, 9) << "P L^2/EI = " << factor << ", chi = " << chi;
    for (const SlipMode& mode : modes) {
      const double omega = mode.angular_frequency();
      EXPECT_LT(slip_characteristic(beam, omega * (1 - 1e-9)) * slip_characteristic(beam, omega * (1 + 1e-9)),
                0.0);
    }
  }
}

TEST(SlipModes, ComeInAscendingOrderAndAskedNumber) {
  for (const int count : {1, 2, 7, 1000}) {
    const auto modes = slip_modes(paper_beam(), count);
    ASSERT_EQ(modes.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < modes.size(); ++i) {
      EXPECT_EQ(modes[i].number(), static_cast<int>(i) + 1);
      EXPECT_TRUE(std::isfinite(modes[i].shape(1.0)));
      const double below = i > 0 ? modes[i - 1].angular_frequency() : 0.0;
      EXPECT_GT(modes[i].angular_frequency(), below);
    }
  }
}

/// Central differences of W at x: first to fourth derivative, each with an error of second order.
struct Derivatives {
  double first, second, third, fourth;
};

template <class Shape>
Derivatives derivatives(const Shape& shape, double x, double h) {
  const auto w = [&](int i) { return shape(x + i * h); };
  return {(w(1) - w(-1)) / (2 * h), (w(1) - 2 * w(0) + w(-1)) / (h * h),
          (w(2) - 2 * w(1) + 2 * w(-1) - w(-2)) / (2 * h * h * h),
          (w(2) - 4 * w(1) + 6 * w(0) - 4 * w(-1) + w(-2)) / (h * h * h * h)};
}

template <class Shape>
double largest_magnitude(const Shape& shape) {
  double size = 0.0;
  for (int i = 0; i <= 100; ++i) size = std::max(size, std::abs(shape(0.02 * i)));
  return size;
}

TEST(SlipModes, ShapesMeetTheBoundaryConditionsAndTheEquation) {
  for (const auto& [factor, chi] : {std::pair{-10.0, 0.0},
                                    {0.0, 0.0},
                                    {10.0, 0.0},
                                    {19.0, 0.0},
                                    {10.0, 0.4},
                                    {-50.0, 0.4},
                                    {2.4, 1.0},
                                    {-50.0, 1.0},
                                    {-1e3, 1.0}}) {
    const data::Beam beam = beam_with_load_factor(factor, chi);
    const double p = beam.axial_force() / rigidity(beam);
    for (const SlipMode& mode : slip_modes(beam, 4)) {
      const double steepest = std::max(mode.hyperbolic_wave_number(), mode.trigonometric_wave_number());
      const auto shape = [&](double x) { return mode.shape(x); };
      const double size = largest_magnitude(shape), h = 0.01 / steepest;
      // The leading errors h^2 W^(m+2)/12 ... h^2 W^(m+2)/4 of the m-th derivative; W^(m) <= 2 steepest^m
      // size.
      const auto tolerance = [&](int order) {
        return discretisation(0.5 * size * std::pow(steepest, order) * 1e-4, 2.0, "h^2 W^(m+2)/4");
      };
      EXPECT_TRUE(within(mode.shape(0.0), 0.0, round_off(6, 1, size)));
      EXPECT_TRUE(within(mode.shape(2.0), 1.0, round_off(6, 1, size)));
      EXPECT_TRUE(within(derivatives(shape, 0.0, h).first, 0.0, tolerance(1)));
      EXPECT_TRUE(within(derivatives(shape, 2.0, h).second, 0.0, tolerance(2)));
      const Derivatives tip = derivatives(shape, 2.0, h);
      EXPECT_TRUE(within(tip.third + chi * p * tip.first, 0.0, tolerance(3)));
      const double k = beam.density() * beam.area() * std::pow(mode.angular_frequency(), 2) / rigidity(beam);
      const Derivatives inside = derivatives(shape, 0.83, h);
      EXPECT_TRUE(within(inside.fourth + p * inside.second, k * mode.shape(0.83), tolerance(4)));
    }
  }
}

// P L^2/EI and chi.
constexpr std::pair<double, double> adjoint_loads[] = {{0.12, 0.0}, {5.0, 0.0}, {18.0, 0.0},
                                                       {12.0, 0.3}, {4.0, 0.6}, {2.0, 1.0}};

STICKSLIP_VERIFIES(AdjointSlipModes, "A3");
TEST(AdjointSlipModes, AreBiorthogonalToTheModes) {
  // Shapes of magnitude 1 on 2 m; the quadrature is good to 1e-11 of its scale.
  for (const auto& [factor, chi] : adjoint_loads) {
    const double length = paper_beam().length();
    const auto modes = slip_modes(beam_with_load_factor(factor, chi), 6);
    for (const SlipMode& adjoint : modes)
      for (const SlipMode& mode : modes) {
        SCOPED_TRACE(fmt::format("{}, {}: {}, {}", factor, chi, adjoint.number(), mode.number()));
        const auto product = [&](double x) { return adjoint.adjoint_shape(x) * mode.shape(x); };
        const double overlap = integral(product, 0.0, length, length).value;
        if (adjoint.number() == mode.number())
          EXPECT_GT(std::abs(overlap), 1e-3);
        else
          EXPECT_TRUE(within(overlap, 0.0, reference(1e-10 * length, "the quadrature")));
      }
  }
}

TEST(AdjointSlipModes, MeetTheAdjointBoundaryConditions) {
  for (const auto& [factor, chi] : adjoint_loads) {
    SCOPED_TRACE(fmt::format("{}, {}", factor, chi));
    const data::Beam beam = beam_with_load_factor(factor, chi);
    const double p = beam.axial_force() / rigidity(beam);
    for (const SlipMode& mode : slip_modes(beam, 4)) {
      const double steepest = std::max(mode.hyperbolic_wave_number(), mode.trigonometric_wave_number());
      const auto shape = [&](double x) { return mode.shape(x); };
      const auto adjoint = [&](double x) { return mode.adjoint_shape(x); };
      const double size = std::max(largest_magnitude(shape), largest_magnitude(adjoint));
      const double h = 0.01 / steepest;
      // As for the modes; their p-terms add p/steepest^2 of the same.
      const auto tolerance = [&](int order) {
        const double derivative = std::pow(steepest, order) + p * std::pow(steepest, order - 2);
        return discretisation(0.5 * size * derivative * 1e-4, 2.0, "h^2 W^(m+2)/4");
      };
      const Derivatives root = derivatives(adjoint, 0.0, h), tip = derivatives(adjoint, 2.0, h);
      EXPECT_TRUE(within(adjoint(0.0), 0.0, round_off(6, 1, size)));
      EXPECT_TRUE(within(root.first, 0.0, tolerance(1)));
      EXPECT_TRUE(within(adjoint(2.0), 1.0, round_off(6, 1, size)));
      EXPECT_TRUE(within(tip.second + (1.0 - chi) * p, 0.0, tolerance(2)));
      EXPECT_TRUE(within(tip.third + p * tip.first, 0.0, tolerance(3)));
      for (const double x : {0.3, 0.9, 1.7})
        EXPECT_TRUE(within(mode.curvature(x), derivatives(shape, x, h).second, tolerance(2)));
    }
  }
}

TEST(SlipModes, AreSelfAdjointUnderADeadLoad) {
  for (const SlipMode& mode : slip_modes(beam_with_load_factor(2.0, 1.0), 4))
    for (const double x : {0.3, 0.9, 1.7})
      EXPECT_TRUE(within(mode.adjoint_shape(x), mode.shape(x), round_off(20, 5, 1.0))) << mode.number();
}

STICKSLIP_VERIFIES(FlutterLoad, "A3");
TEST(FlutterLoad, GivesWayToABucklingLoadWhichIsRefusedAsSuch) {
  for (const double factor : {2.468, 30.0}) {
    SCOPED_TRACE(factor);
    expect_error_message<data::FieldError>(
        [&] { (void)slip_modes(beam_with_load_factor(factor, 1.0), 1); },
        {"beam.axial_force is ", "below the buckling load of the slip state, 10280.8"});
  }
}

TEST(FlutterLoad, DoesNotDependOnTheBeamsOwnAxialForce) {
  EXPECT_EQ(slip_critical_load(paper_beam_with_axial_force(-1e4)), slip_critical_load(paper_beam()));
}

TEST(FlutterLoad, IsTheSquareRootCoalescenceOfFrequencies) {
  // The next term: without a load, at the distance 1, the gap is 5 % less than the square root leads to. The
  // flutter load is known to 1e-12.
  std::vector<OrderLevel> levels;
  for (double distance = 1e-3; distance > 1e-9; distance *= 0.1) {
    const auto modes = slip_modes(beam_with_load_factor(kFlutterFactor * (1.0 - distance)), 2);
    const double gap = modes[1].angular_frequency() - modes[0].angular_frequency();
    levels.push_back(
        {.step = distance, .error = gap, .next_term = 0.1 * distance, .floor = gap * 0.5e-12 / distance});
  }
  EXPECT_TRUE(order_is(levels, 0.5));
}

TEST(FlutterLoad, IsRefusedBySlipModesWhichSayWhy) {
  for (const double factor : {1.000001 * kFlutterFactor, 30.0, 100.0, 1e6, -1.1e5}) {
    SCOPED_TRACE(factor);
    expect_error_message<data::InputError>(
        [&] { (void)slip_modes(beam_with_load_factor(factor), 1); },
        {"beam.axial_force is ", "flutter load of the slip state, 83545.6"});
  }
}

TEST(SlipModes, RefuseACountOutOfRange) {
  EXPECT_THROW((void)slip_modes(paper_beam(), 0), std::invalid_argument);
  EXPECT_THROW((void)slip_modes(paper_beam(), 1001), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
