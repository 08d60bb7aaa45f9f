// SPDX-License-Identifier: MIT
/// Modes, critical loads and static shape of both states.

#include "analytic/gsl.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/order.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

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

// --- Stick

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
// Of the norms: a wrong root has a wrong shape at the clamp, below.
TEST(StickModes, NormsGiveTheFrequencyByRayleighsQuotient) {
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
      EXPECT_TRUE(holds(std::string(error.what()), "beam.axial_force"));
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
