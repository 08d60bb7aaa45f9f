// SPDX-License-Identifier: MIT
/// The mobility of the tip, from the clamp to the tip, against the boundary value problem that it solves.
/// cross_certified_test.cpp has it at the tip, with its limits.

#include <Eigen/LU>

#include "stickslip/analytic/tip_mobility.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::TipMobility;
using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double length = 2.0;                     // L, m
constexpr double mass_per_length = 10.0;           // rho A, kg/m
constexpr double stiffness = 2e9 * 1e-4 / 12.0;    // EI, N m^2
const double unit = frequency_unit(paper_beam());  // s = k * unit, 1/s

/// s u(xi) of a unit force at the tip from the four boundary conditions, as a linear system for four waves.
struct Waves {
  Eigen::Vector4cd exponents, weights;  // weight exp(exponent (xi - origin)), with the origin where it is 1
  double condition{};
  Complex s;

  [[nodiscard]] Complex velocity(double xi) const {
    Complex sum = 0.0;
    for (int j = 0; j < 4; ++j) sum += weights[j] * std::exp(exponents[j] * (xi - (j % 2 == 0 ? 1.0 : 0.0)));
    return s * sum;
  }
};

Waves waves(double z, double eta, Complex s) {
  const Complex rigidity = stiffness * (1.0 + eta * s), half = 0.5 * z * stiffness / rigidity;
  const Complex root = std::sqrt(half * half - mass_per_length * std::pow(length, 4) * s * s / rigidity);
  const Complex first = std::sqrt(root - half), second = std::sqrt(-root - half);
  Waves result;
  result.s = s;
  result.exponents << first, -first, second, -second;
  Eigen::Matrix4cd matrix;
  for (int j = 0; j < 4; ++j) {
    const Complex r = result.exponents[j] / std::abs(first),
                  far = std::exp(-(j % 2 == 0 ? 1.0 : -1.0) * result.exponents[j]);
    const Complex at_clamp = j % 2 == 0 ? far : 1.0, at_tip = j % 2 == 0 ? 1.0 : far;
    matrix.col(j) << at_clamp, r * at_clamp, r * r * at_tip, r * r * r * at_tip;
  }
  const Eigen::PartialPivLU<Eigen::Matrix4cd> factors(matrix);
  result.condition = 1.0 / factors.rcond();
  result.weights =
      factors.solve(Eigen::Vector4cd(0.0, 0.0, 0.0, -std::pow(length / std::abs(first), 3) / rigidity));
  return result;
}

STICKSLIP_VERIFIES(TipMobility, "A9");
TEST(TipMobility, SolvesTheBoundaryValueProblem) {
  for (const double z : {-14.4, 0.0, 0.12, 12.0})
    for (const double eta : {0.0, 6.4e-5, 5e-3})
      for (const Complex k :
           {Complex(0.2, 0.7), Complex(0.0, 9.0), Complex(5.0, 40.0), Complex(0.3, -300.0), Complex(2000.0),
            Complex(100.0, 20000.0), Complex(-2.0, 30.0), Complex(-1e6, 1e5)}) {
        if (k.real() < 0.0 && eta > 0.0) continue;  // among the poles
        const Complex s = k * unit;
        const TipMobility mobility(paper_beam_with_load_factor(z), kelvin_voigt(eta));
        const Waves expected = waves(z, eta, s);
        const double size = std::max(std::abs(expected.velocity(1.0)), std::abs(expected.velocity(0.6)));
        const double phase = expected.exponents.cwiseAbs().maxCoeff();
        for (const double share : {0.0, 0.03, 0.3, 0.6, 0.95, 1.0})
          EXPECT_TRUE(within(mobility.transfer(share * length, s), expected.velocity(share),
                             round_off(10, expected.condition + phase, size)))
              << "z = " << z << ", eta = " << eta << ", k = " << k << ", x/L = " << share;
        EXPECT_TRUE(
            within(mobility(s), expected.velocity(1.0), round_off(10, expected.condition + phase, size)))
            << "z = " << z << ", eta = " << eta << ", k = " << k;
      }
}

TEST(TipMobility, LosesNoDigitsWhereTheExponentsMeet) {
  // At k = z/2 the waves are two, not four. A function without poles in a circle is the mean over it: of 16
  // points, up to (0.5/3)^16 = 4e-13 for the poles, 3 or more away.
  constexpr int points = 16;
  for (const double z : {-6.0, -0.12, 0.12, 6.0}) {
    const TipMobility mobility(paper_beam_with_load_factor(z));
    const Complex s = 0.5 * z * unit;
    for (const double share : {0.1, 0.5, 0.9, 1.0}) {
      Complex mean = 0.0;
      double size = 0.0, condition = 0.0;
      for (int i = 0; i < points; ++i) {
        const Waves at = waves(z, 0.0, s + std::polar(0.5 * unit, 2.0 * pi * (i + 0.5) / points));
        mean += at.velocity(share) / static_cast<double>(points);
        size = std::max(size, std::abs(at.velocity(share)));
        condition = std::max(condition, at.condition);
      }
      EXPECT_TRUE(within(mobility.transfer(share * length, s), mean,
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
