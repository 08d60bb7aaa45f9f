// SPDX-License-Identifier: MIT
/// The mobility of the tip, from the clamp to the tip, against the boundary value problem that it solves.
/// cross_certified_test.cpp has it at the tip, with its limits.

#include "stickslip/analytic/tip_mobility.hpp"
#include "support/testing.hpp"
#include "support/waves.hpp"

namespace stickslip::testing {
namespace {

using analytic::TipMobility;
using Complex = std::complex<double>;

/// s u(xi) of a unit force at the tip.
Complex velocity(const BeamProblem& problem, const BeamWaves& waves, double xi) {
  return problem.s * std::pow(problem.beam.length(), 3) / problem.rigidity() * waves(0, xi);
}

BeamWaves pushed(const BeamProblem& problem) {
  return problem.motion(false, BeamProblem::Given::force_at_tip);
}

STICKSLIP_VERIFIES(TipMobility, "A9");
TEST(TipMobility, SolvesTheBoundaryValueProblem) {
  for (const double z : {-14.4, 0.0, 0.12, 12.0})
    for (const double chi : {0.0, 0.3, 1.0})
      for (const double eta : {0.0, 6.4e-5, 5e-3})
        for (const Complex k :
             {Complex(0.2, 0.7), Complex(0.0, 9.0), Complex(5.0, 40.0), Complex(0.3, -300.0), Complex(2000.0),
              Complex(100.0, 20000.0), Complex(-2.0, 30.0), Complex(-1e6, 1e5)}) {
          if (k.real() < 0.0 && eta > 0.0) continue;  // among the poles
          const data::Beam beam = loaded_paper_beam(z, chi);
          const BeamProblem problem{beam, k * frequency_unit(beam), eta};
          SCOPED_TRACE(
              fmt::format("z = {}, chi = {}, eta = {}, k = {} + {} i", z, chi, eta, k.real(), k.imag()));
          const TipMobility mobility(beam, kelvin_voigt(eta));
          const BeamWaves waves = pushed(problem);
          const double size =
              std::max(std::abs(velocity(problem, waves, 1.0)), std::abs(velocity(problem, waves, 0.6)));
          const Tolerance tolerance = round_off(10, waves.condition + waves.largest_exponent(), size);
          for (const double share : {0.0, 0.03, 0.3, 0.6, 0.95, 1.0})
            EXPECT_TRUE(within(mobility.transfer(share * beam.length(), problem.s),
                               velocity(problem, waves, share), tolerance))
                << share;
          EXPECT_TRUE(within(mobility(problem.s), velocity(problem, waves, 1.0), tolerance));
        }
}

TEST(TipMobility, LosesNoDigitsAtEqualRoots) {
  // At k = z/2 the waves are two, not four. A function without poles in a circle is the mean over it: of 16
  // points, up to (0.5/3)^16 = 4e-13 for the poles, 3 or more away.
  constexpr int points = 16;
  for (const double z : {-6.0, -0.12, 0.12, 6.0}) {
    const data::Beam beam = paper_beam_with_load_factor(z);
    const TipMobility mobility(beam);
    const double unit = frequency_unit(beam);
    for (const double share : {0.1, 0.5, 0.9, 1.0}) {
      Complex mean = 0.0;
      double size = 0.0, condition = 0.0;
      for (int i = 0; i < points; ++i) {
        const Complex on_circle = std::polar(0.5 * unit, 2.0 * std::numbers::pi * (i + 0.5) / points);
        const BeamProblem problem{beam, 0.5 * z * unit + on_circle};
        const BeamWaves waves = pushed(problem);
        mean += velocity(problem, waves, share) / static_cast<double>(points);
        size = std::max(size, std::abs(velocity(problem, waves, share)));
        condition = std::max(condition, waves.condition);
      }
      EXPECT_TRUE(within(mobility.transfer(share * beam.length(), 0.5 * z * unit), mean,
                         discretisation(4e-13 * size + round_off(1, condition, size).value, 1.0,
                                        "the poles, and the round-off of the waves")))
          << z << ", " << share;
    }
  }
}

TEST(TipMobility, RefusesAModalDampingRatio) {
  EXPECT_THROW(TipMobility(paper_beam(), data::Damping({.ratio = 0.01})), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
