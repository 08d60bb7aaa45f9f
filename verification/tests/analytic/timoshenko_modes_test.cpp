// SPDX-License-Identifier: MIT
/// The frequencies of the Timoshenko beam against a spectral discretisation that shares nothing with them.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "support/beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::ShearProperties;
using analytic::TipSupport;
using Values = std::vector<double>;

data::Beam beam_of(double length, double area, double second_moment, double axial_force = 0.0) {
  return data::Beam({.length = length,
                     .area = area,
                     .second_moment_of_area = second_moment,
                     .density = 1000.0,
                     .youngs_modulus = 2e9,
                     .axial_force = axial_force});
}

// A square section, slender and stout: L = 2 m and 0.5 m with a depth of 0.1 m.
const data::Beam slender = beam_of(2.0, 0.01, 1e-4 / 12.0), stout = beam_of(0.5, 0.01, 1e-4 / 12.0);

// Legendre's polynomials P_0 ... and their derivatives at x in (-1, 1).
struct Legendre {
  Values value{1.0}, slope{0.0};
  Legendre(int count, double x) {
    for (int k = 1; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      value.push_back(k == 1 ? x : ((2.0 * k - 1.0) * x * value[i - 1] - (k - 1.0) * value[i - 2]) / k);
      slope.push_back((k == 1 ? 0.0 : slope[i - 2]) + (2.0 * k - 1.0) * value[i - 1]);
    }
  }
};

// Rayleigh and Ritz: w = xi (1 - xi)^held sum w_k P_k, phi = xi sum phi_k P_k with `count` terms each, the energies
// int EI phi'^2 + k G A (w' - phi)^2 and int rho A w^2 + rho I phi^2 by Gauss's rule of 2 count points. Upper bounds.
Values ritz_frequencies(const data::Beam& beam, const ShearProperties& shear, TipSupport tip, int count) {
  const int points = 2 * count;
  Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(points, points);  // its eigenvalues are Gauss's points
  for (int k = 1; k < points; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gauss(jacobi);
  const double length = beam.length(), bending = beam.youngs_modulus() * beam.second_moment_of_area();
  const double shearing =
      shear.shear_coefficient * beam.youngs_modulus() * beam.area() / (2.0 + 2.0 * shear.poisson_ratio);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * count, 2 * count), mass = stiffness;
  for (int i = 0; i < points; ++i) {
    const double x = gauss.eigenvalues()[i], xi = 0.5 * (1.0 + x);
    const double weight = length * std::pow(gauss.eigenvectors()(0, i), 2);
    const Legendre legendre(count, x);
    Eigen::VectorXd w = Eigen::VectorXd::Zero(2 * count), dw = w, phi = w, dphi = w;
    const double factor = tip == TipSupport::held ? xi * (1.0 - xi) : xi;
    const double slope = tip == TipSupport::held ? 1.0 - 2.0 * xi : 1.0;
    for (int k = 0; k < count; ++k) {
      const double value = legendre.value[static_cast<std::size_t>(k)];
      const double derivative = 2.0 * legendre.slope[static_cast<std::size_t>(k)];
      w[k] = factor * value;
      dw[k] = (slope * value + factor * derivative) / length;
      phi[count + k] = xi * value;
      dphi[count + k] = (value + xi * derivative) / length;
    }
    stiffness +=
        weight * (bending * dphi * dphi.transpose() + shearing * (dw - phi) * (dw - phi).transpose());
    mass += weight * beam.density() *
            (beam.area() * w * w.transpose() + beam.second_moment_of_area() * phi * phi.transpose());
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(stiffness, mass,
                                                                        Eigen::EigenvaluesOnly);
  Values frequencies;
  for (const double value : eigen.eigenvalues()) frequencies.push_back(std::sqrt(value));
  return frequencies;
}

STICKSLIP_VERIFIES(TimoshenkoModes, "A11");
TEST(TimoshenkoModes, AreAllThoseOfASpectralDiscretisationBelowTheCutOff) {
  constexpr ShearProperties shear{};
  for (const data::Beam& beam : {slender, stout})
    for (const TipSupport tip : {TipSupport::held, TipSupport::free}) {
      const Values ritz = ritz_frequencies(beam, shear, tip, 60),
                   fewer = ritz_frequencies(beam, shear, tip, 56);
      const double cutoff = analytic::timoshenko_cutoff(beam, shear);
      int count = 0;
      while (ritz[static_cast<std::size_t>(count)] < cutoff) ++count;
      ASSERT_GE(count, 3);
      const Values exact = analytic::timoshenko_frequencies(beam, shear, tip, count);
      for (std::size_t n = 0; n < exact.size(); ++n) {
        // Round-off of the eigenvalue problem is relative to its largest eigenvalue: half of it in the frequency. What
        // four more terms change is many times what is left.
        const double rounding = 1e-16 * 120.0 * 0.5 * std::pow(ritz.back() / exact[n], 2);
        EXPECT_TRUE(within(exact[n], ritz[n],
                           discretisation((rounding + std::abs(fewer[n] / ritz[n] - 1.0)) * exact[n], 1.0,
                                          "round-off and the difference to fewer terms")))
            << n + 1;
      }
      EXPECT_THROW((void)analytic::timoshenko_frequencies(beam, shear, tip, count + 1), data::FieldError);
    }
}

TEST(TimoshenkoModes, GoToThoseOfEulerAndBernoulliWithTheSizeOfTheSection) {
  // The same EI and rho A, and r^2 and s^2 a millionth. First order by Rayleigh: -(r^2 + s^2) n^2/2 in the middle of
  // the beam; twice that holds for all ends.
  const data::Beam thin({.length = 2.0,
                         .area = 1e4,
                         .second_moment_of_area = 1e-4 / 12.0,
                         .density = 1e-3,
                         .youngs_modulus = 2e9,
                         .axial_force = 0.0});
  constexpr ShearProperties shear{};
  const double sum = 1e-4 / 12.0 / (1e4 * 4.0) + analytic::shear_flexibility(thin, shear);
  const Values held = analytic::timoshenko_frequencies(thin, shear, TipSupport::held, 8),
               free = analytic::timoshenko_frequencies(thin, shear, TipSupport::free, 8);
  const auto stick = analytic::stick_modes(thin, 8);
  const auto slip = analytic::slip_modes(thin, 8);
  for (std::size_t n = 0; n < 8; ++n) {
    const double wave_number = (static_cast<double>(n) + 1.25) * std::numbers::pi;
    for (const auto& [timoshenko, classical] :
         {std::pair{held[n], stick[n].angular_frequency()}, {free[n], slip[n].angular_frequency()}})
      EXPECT_TRUE(within(
          timoshenko, classical,
          discretisation(classical * (sum * wave_number * wave_number + 1e-14), 1.0, "(r^2 + s^2) n^2")));
  }
}

TEST(TimoshenkoModes, AreLowerByHalfTheSquaresOfRotaryInertiaAndShearInTheMiddle) {
  // Mode 6 of the slender beam: the wave number of the middle is (6 + 1/4) pi; the ends change the share by less than
  // a tenth, the next order by (r^2 + s^2) n^2 of itself.
  constexpr ShearProperties shear{};
  const double r2 = 1e-4 / 12.0 / (0.01 * 4.0), s2 = analytic::shear_flexibility(slender, shear);
  EXPECT_TRUE(within(s2, 3.12 * r2, round_off(4, 1, s2)));
  const data::Beam unloaded = slender;
  const double classical = analytic::stick_modes(unloaded, 6).back().angular_frequency();
  const double loss =
      1.0 - analytic::timoshenko_frequencies(slender, shear, TipSupport::held, 6).back() / classical;
  const double n2 = std::pow(6.25 * std::numbers::pi, 2), first = 0.5 * (r2 + s2) * n2;
  EXPECT_TRUE(
      within(loss, first, discretisation(first * (0.1 + (r2 + s2) * n2), 1.0, "ends and the next order")));
}

TEST(TimoshenkoModes, RefuseWhatHasNoSuchForm) {
  const auto refuses = [](const data::Beam& beam, const ShearProperties& shear, int count) {
    EXPECT_THROW((void)analytic::timoshenko_frequencies(beam, shear, TipSupport::held, count),
                 data::FieldError);
  };
  refuses(beam_of(2.0, 0.01, 1e-4 / 12.0, 500.0), {}, 1);
  refuses(slender, {.shear_coefficient = 0.0}, 1);
  refuses(slender, {.poisson_ratio = 0.5}, 1);
  refuses(slender, {.poisson_ratio = -1.0}, 1);
  refuses(slender, {}, 0);
  refuses(slender, {}, 1000);
}

}  // namespace
}  // namespace stickslip::testing
