// SPDX-License-Identifier: MIT
/// Modes, critical loads and static shape of both states.

#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/testing.hpp"
#include "support/waves.hpp"

namespace stickslip::testing {
namespace {

using analytic::slip_characteristic;
using analytic::slip_critical_load;
using analytic::slip_modes;
using analytic::SlipMode;

// d(characteristic)/d(bb) = 0 and characteristic = 0 solved by Newton's method with 30 digits. Beck: 20.05.
constexpr double kFlutterFactor = 20.0509536189737612;

STICKSLIP_VERIFIES(SlipModes, "A3");
TEST(SlipModes, AreAllSignChanges) {
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
    const data::Beam beam = loaded_paper_beam(factor, chi);
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

// P L^2/EI and chi.
constexpr std::pair<double, double> loads[] = {{-1e3, 1.0}, {-50.0, 0.4}, {-10.0, 0.0}, {0.0, 0.0},
                                               {0.12, 0.0}, {5.0, 0.0},   {10.0, 0.4},  {12.0, 0.3},
                                               {19.0, 0.0}, {4.0, 0.6},   {2.0, 1.0},   {2.4, 1.0}};

// Shapes, curvatures and the modes of the transposed problem, all 1 at the tip, of the frequency that the mode has.
TEST(SlipModes, SolveBothBoundaryProblems) {
  for (const auto& [factor, chi] : loads) {
    const data::Beam beam = loaded_paper_beam(factor, chi);
    for (const SlipMode& mode : slip_modes(beam, 6)) {
      SCOPED_TRACE(fmt::format("P L^2/EI = {}, chi = {}, mode {}", factor, chi, mode.number()));
      const BeamProblem problem{beam, {0.0, mode.angular_frequency()}};
      const auto direct = problem.motion(false, BeamProblem::Given::curvature_at_clamp),
                 transposed = problem.motion(true, BeamProblem::Given::curvature_at_clamp);
      const double square = std::pow(direct.largest_exponent(), 2);
      for (const double xi : {0.0, 0.15, 0.45, 0.85, 1.0}) {
        const double x = xi * beam.length();
        const auto same = [](double computed, const BeamWaves& waves, std::complex<double> expected,
                             double size) {
          return within(computed, expected / waves(0, 1.0), round_off(10, waves.condition, size));
        };
        const double size = 1.0 + std::abs(direct(0, 0.5) / direct(0, 1.0)),
                     adjoint_size = 1.0 + std::abs(transposed(0, 0.5) / transposed(0, 1.0));
        EXPECT_TRUE(same(mode.shape(x), direct, direct(0, xi), size)) << xi;
        EXPECT_TRUE(
            same(mode.curvature(x) * std::pow(beam.length(), 2), direct, direct(2, xi), square * size))
            << xi;
        EXPECT_TRUE(same(mode.adjoint_shape(x), transposed, transposed(0, xi), adjoint_size)) << xi;
      }
    }
  }
}

STICKSLIP_VERIFIES(FlutterLoad, "A3");
TEST(FlutterLoad, GivesWayToABucklingLoad) {
  for (const double factor : {2.468, 30.0}) {
    SCOPED_TRACE(factor);
    expect_error_message<data::FieldError>(
        [&] { (void)slip_modes(loaded_paper_beam(factor, 1.0), 1); },
        {"beam.axial_force is ", "below the buckling load of the slip state, 10280.8"});
  }
}

TEST(FlutterLoad, DoesNotDependOnThePresentForce) {
  EXPECT_EQ(slip_critical_load(paper_beam_with_axial_force(-1e4)), slip_critical_load(paper_beam()));
}

TEST(FlutterLoad, IsRefusedBySlipModesWhichSayWhy) {
  for (const double factor : {1.000001 * kFlutterFactor, 30.0, 100.0, 1e6, -1.1e5}) {
    SCOPED_TRACE(factor);
    expect_error_message<data::InputError>(
        [&] { (void)slip_modes(paper_beam_with_load_factor(factor), 1); },
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
TEST(StickModes, HaveRayleighsQuotient) {
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

TEST(StickModes, HaveTheConditionOfTheirForce) {
  for (const double share : {-15.0, -0.9, 0.1, 0.5, 0.9})
    for (std::size_t n = 0; n < 3; ++n) {
      const double force = share * stick_buckling_load(paper_beam());
      const auto frequency = [n](double axial_force) {
        return stick_modes(paper_beam_with_axial_force(axial_force), 3)[n].angular_frequency();
      };
      const StickMode mode = stick_modes(paper_beam_with_axial_force(force), 3)[n];
      // h^4, of central differences without their h^2; and eps omega/h of the frequencies.
      const auto slope = [&](double h) { return (frequency(force + h) - frequency(force - h)) / (2.0 * h); };
      const auto sharper = [&](double h) { return (4.0 * slope(0.5 * h) - slope(h)) / 3.0; };
      const double h = 0.01 * std::abs(force), scale = force / mode.angular_frequency();
      const double error =
          std::abs(scale * (sharper(2.0 * h) - sharper(h))) / 15.0 + round_off(100, 1, 1).value;
      EXPECT_TRUE(within(1.0 + std::abs(scale * sharper(h)), mode.condition_number(),
                         discretisation(error, 2.0, "h^4 and round-off")))
          << "P/P_cr = " << share << ", mode " << n + 1;
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

TEST(StickModes, AreRefusedAtTheBucklingLoad) {
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

TEST(StickModes, MeetTheirBoundaryConditions) {
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
TEST(QuasiStaticShape, BecomesATautString) {
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
