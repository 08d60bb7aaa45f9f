// SPDX-License-Identifier: MIT
/// The mobility of the tip: its limits at low and at high frequency, its poles and zeros, its sum over the
/// modes, and the boundary value problem that it solves.

#include "stickslip/analytic/tip_mobility.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "analytic/gsl.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/beams.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::TipMobility;
using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double length = 2.0;                     // L, m
constexpr double mass_per_length = 10.0;           // rho A, kg/m
constexpr double stiffness = 2e9 * 1e-4 / 12.0;    // EI, N m^2
const double unit = frequency_unit(paper_beam());  // s = k * unit, 1/s

data::Damping kelvin_voigt(double eta) { return data::Damping({.kelvin_voigt = eta}); }

STICKSLIP_VERIFIES(TipMobility, "A9");
TEST(TipMobility, TendsToTheStaticFlexibility) {
  // EI u'' = F (L - x) sinc(sigma (L - x)), sigma^2 = P/EI, integrated twice; the next term is of order k^2.
  const Complex s = 1e-10 * unit;
  for (const double z : {-50.0, -5.0, -1e-6, 0.0, 1e-6, 0.12, 5.0, 19.0}) {
    const TipMobility mobility(paper_beam_with_load_factor(z));
    const auto flexibility = [](double load, double share) {
      const double y = std::sqrt(std::abs(load));
      const auto moment = [&](double xi) {
        const double distance = 1.0 - xi, phase = y * distance;
        const double sine = load > 0.0 ? std::sin(phase) : std::sinh(phase);
        return (share - xi) * (phase > 0.0 ? distance * sine / phase : distance);
      };
      return integral(moment, 0.0, share, 1.0).value * std::pow(length, 3) / stiffness;
    };
    for (const double share : {0.1, 0.5, 0.9, 1.0}) {
      const double expected = flexibility(z, share);
      const double sensitivity = (flexibility(1.001 * z, share) - expected) / 0.001;
      const Tolerance rounding = round_off(30, 1.0 + std::abs(sensitivity / expected), expected);
      EXPECT_TRUE(within(mobility.transfer(share * length, s) / s, expected, rounding)) << z << ", " << share;
      if (share < 1.0) continue;
      EXPECT_TRUE(within(mobility(s) / s, expected, rounding)) << z;
    }
  }
}

TEST(TipMobility, HasItsPolesAtTheSlipFrequencies) {
  // How far the root of 1/Y near i omega is from there, relative to omega: one step by the secant.
  constexpr double step = 1e-6;
  for (const double z : {-14.4, 0.0, 0.12, 10.0, 19.0}) {
    const TipMobility mobility(paper_beam_with_load_factor(z));
    const auto modes = analytic::slip_modes(paper_beam_with_load_factor(z), 40);
    const auto beside = analytic::slip_modes(paper_beam_with_load_factor(z * (1.0 - step)), 40);
    for (const std::size_t n : {0U, 1U, 2U, 4U, 9U, 39U}) {
      const double omega = modes[n].angular_frequency();
      const double sensitivity = std::abs(beside[n].angular_frequency() / omega - 1.0) / step;
      const auto inverse = [&](double share) { return 1.0 / mobility(Complex(0.0, omega * share)); };
      const Complex distance = 2.0 * step * inverse(1.0) / (inverse(1.0 + step) - inverse(1.0 - step));
      EXPECT_TRUE(within(distance, 0.0, round_off(10, 1.0 + sensitivity, 1.0))) << z << ", mode " << n + 1;
    }
  }
}

TEST(TipMobility, IsTheSumOverTheSlipModesWhereTheExponentsMeetToo) {
  // Y(x, s) = sum psi_k(x) g_k s/(s^2 + omega_k^2), g_k = 1/(rho A int psi*_k psi_k dx). By Betti it is the
  // velocity of the tip per force at x as well where psi* = psi, at P = 0. Of the modes left out, g_k is
  // about 4/(rho A L), |psi_k| at most 1, omega_k about (k - 1/2)^2 pi^2 units.
  constexpr int count = 100;
  for (const double z : {-5.0, 0.0, 0.12, 5.0, 15.0}) {
    const data::Beam beam = paper_beam_with_load_factor(z);
    const TipMobility mobility(beam);
    const auto modes = analytic::slip_modes(beam, count);
    std::vector<double> participations;
    for (const auto& mode : modes) {
      const auto product = [&](double x) { return mode.adjoint_shape(x) * mode.shape(x); };
      participations.push_back(1.0 / (mass_per_length * integral(product, 0.0, length, length).value));
      if (z == 0.0) {
        EXPECT_TRUE(within(participations.back(), 4.0 / (mass_per_length * length),
                           round_off(20, mode.number(), participations.back())));
      }
    }
    for (const Complex k : {Complex(0.5 * z), Complex(0.5 * z, 1e-5), Complex(1e-3), Complex(0.0, 12.0),
                            Complex(3.0, 20.0), Complex(30.0, -5.0)}) {
      if (k == 0.0) continue;
      const Complex s = k * unit;
      const double rest = 1.1 * std::abs(s) * 4.0 / (mass_per_length * length) /
                          (unit * unit * std::pow(pi, 4) * 3.0 * std::pow(count, 3));
      for (const double share : {0.05, 0.4, 0.75, 1.0}) {
        Complex sum = 0.0;
        double size = 0.0;
        for (std::size_t n = 0; n < modes.size(); ++n) {
          const Complex term = modes[n].shape(share * length) * participations[n] * s /
                               (s * s + std::pow(modes[n].angular_frequency(), 2));
          sum += term;
          size += std::abs(term);
        }
        EXPECT_TRUE(within(mobility.transfer(share * length, s), sum,
                           discretisation(rest + round_off(40, 1.0, size).value + 1e-11 * size, 1.0,
                                          "the modes left out, and the quadrature's 1e-11")))
            << "z = " << z << ", k = " << k << ", x/L = " << share;
      }
    }
  }
}

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

TEST(TipMobility, SolvesTheBoundaryValueProblem) {
  for (const double z : {-14.4, 0.0, 0.12, 12.0})
    for (const double eta : {0.0, 6.4e-5, 5e-3})
      for (const Complex k : {Complex(0.2, 0.7), Complex(0.0, 9.0), Complex(5.0, 40.0), Complex(0.3, -300.0),
                              Complex(2000.0), Complex(100.0, 20000.0)}) {
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

TEST(TipMobility, IsThatOfTheHalfInfiniteBeamAtHighFrequency) {
  // Without the waves that come back from the clamp, exp(-2 l L) of the others, Y = sqrt(2 s sqrt(rho A/D) -
  // P/D)/(rho A s): sqrt 2 (EI)^(-1/4) (rho A)^(-3/4) s^(-1/2) (1 - e), e = P/[4 s sqrt(rho A EI)], up to
  // e^2/2.
  const double constant = std::sqrt(2.0) * std::pow(stiffness, -0.25) * std::pow(mass_per_length, -0.75);
  for (const double z : {-50.0, 0.0, 0.12, 19.0}) {
    const data::Beam beam = paper_beam_with_load_factor(z);
    const TipMobility mobility(beam);
    for (const double size : {1e4, 1e6, 1e8, 1e12})
      for (const double angle : {-1.57, -1.5, -1.0, 0.0, 0.3, 1.2, 1.5, 1.57}) {
        const Complex s = std::polar(size, angle), k = s / unit;
        const Complex next = 0.25 * z / k, leading = constant / std::sqrt(s);
        const double returning = 10.0 * std::exp(-2.0 * std::min(std::sqrt(Complex(0, 1) * k).real(),
                                                                 std::sqrt(Complex(0, -1) * k).real()));
        if (returning > 0.1) continue;
        const double allowed = 2.0 * std::norm(next) + returning + round_off(20, 1.0, 1.0).value;
        EXPECT_TRUE(within(mobility(s) / leading, 1.0 - next,
                           discretisation(allowed, 1.0, "e^2/2, the returning waves and round-off")))
            << "z = " << z << ", s = " << s;
      }
  }
}

TEST(TipMobility, IsAccurateOnTheImaginaryAxis) {
  // Of l_1 = alpha only what decays is left, l_2 = i beta: with t = tan(beta L),
  // Y = i omega (alpha^2 + beta^2) (t/beta - 1/alpha)/{EI alpha beta [2 alpha beta - (alpha^2 - beta^2) t]}.
  for (const double z : {-14.4, 0.0, 15.0})
    for (const double decade : {1e5, 1e8, 1e12})
      for (int i = 0; i < 40; ++i) {
        const double omega = decade * (1.0 + 0.013 * i), p = z / (length * length);
        const double root = std::hypot(p, 2.0 * omega * std::sqrt(mass_per_length / stiffness));
        const double alpha = std::sqrt(0.5 * (root - p)), beta = std::sqrt(0.5 * (root + p));
        const double t = std::tan(beta * length);
        const double denominator = 2.0 * alpha * beta - (alpha * alpha - beta * beta) * t;
        const Complex expected(0.0, omega * (alpha * alpha + beta * beta) * (t / beta - 1.0 / alpha) /
                                        (stiffness * alpha * beta * denominator));
        // Phases are off by beta L eps, of which 1 + t^2 comes through to t.
        const double scale =
            std::sqrt(2.0 / omega) * std::pow(stiffness, -0.25) * std::pow(mass_per_length, -0.75);
        EXPECT_TRUE(within(TipMobility(paper_beam_with_load_factor(z))(Complex(0.0, omega)), expected,
                           round_off(4, beta * length * (1.0 + t * t), scale)))
            << z << ", " << omega;
      }
}

/// The least Re Y(sigma + i omega)/|Y| over sigma and omega from 1e-3 to 1e6 units.
double least_passivity(double z, double eta) {
  const TipMobility mobility(paper_beam_with_load_factor(z), kelvin_voigt(eta));
  double least = 1.0;
  for (const double sigma : {1e-3, 0.03, 1.0, 30.0, 1e3})
    for (double omega = 1e-3; omega < 1e6; omega *= 1.02) {
      const Complex y = mobility(Complex(sigma, omega) * unit);
      least = std::min(least, y.real() / std::abs(y));
    }
  return least;
}

TEST(TipMobility, IsPassiveWhileSlipFrequencyIsBelowStick) {
  // Undamped, Re Y > 0 for Re s > 0 if and only if poles and zeros alternate, g_k > 0. The follower force
  // ends that before flutter: between P L^2/EI = 16 and 16.1 the first zero passes the first pole.
  for (const double z : {-14.4, -5.0, 0.0, 0.12, 10.0, 16.0, 16.1, 19.0}) {
    const data::Beam beam = paper_beam_with_load_factor(z);
    const bool alternate = analytic::slip_modes(beam, 1).front().angular_frequency() <
                           analytic::stick_modes(beam, 1).front().angular_frequency();
    EXPECT_EQ(alternate, z < 16.05) << z;
    if (z > 10.0 && z < 19.0) continue;  // the first mode's part of Y is too narrow for the frequencies asked
    EXPECT_EQ(least_passivity(z, 0.0) > 0.0, alternate) << z;
  }
}

TEST(TipMobility, IsPassiveWithDampingUnderModerateForce) {
  for (const double z : {-5.0, 0.0, 0.12, 5.0})
    for (const double eta : {6.4e-5, 5e-3}) EXPECT_GT(least_passivity(z, eta), 0.0) << z << ", " << eta;
  // Damping destabilises a column under a follower force well below its undamped flutter load (Ziegler 1952).
  for (const double eta : {6.4e-5, 5e-3}) EXPECT_LT(least_passivity(12.0, eta), 0.0) << eta;
}

TEST(TipMobility, IsConjugateSymmetric) {
  for (const double eta : {0.0, 6.4e-5})
    for (const Complex k : {Complex(0.1, 0.2), Complex(2.0, 30.0), Complex(1e3, 1e6), Complex(1e10, 1e9)}) {
      const TipMobility mobility(paper_beam(), kelvin_voigt(eta));
      const Complex s = k * unit;
      for (const double share : {0.5, 1.0}) {
        const auto at = [&](Complex frequency) { return mobility.transfer(share * length, frequency); };
        const Tolerance rounding = round_off(10, 1.0, std::abs(at(s)));
        EXPECT_TRUE(within(at(std::conj(s)), std::conj(at(s)), rounding)) << k;
        if (eta > 0.0) continue;
        EXPECT_TRUE(within(at(-s), -at(s), rounding)) << k;
        EXPECT_TRUE(within(mobility(-s), -mobility(s), round_off(10, 1.0, std::abs(mobility(s))))) << k;
      }
    }
}

TEST(TipMobility, RefusesAModalDampingRatio) {
  EXPECT_THROW(TipMobility(paper_beam(), data::Damping({.ratio = 0.01})), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
