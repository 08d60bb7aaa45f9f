// SPDX-License-Identifier: MIT
/// The generalised-alpha weights, and the amplification that they imply.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "stickslip/solver/generalized_alpha.hpp"
#include "studies/common/discretisation.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using solver::GeneralizedAlpha;
using solver::Kinematics;

STICKSLIP_VERIFIES(GeneralizedAlpha, "F5");
TEST(GeneralizedAlpha, WeightsOfTheLimitsAreTheKnownMethods) {
  const GeneralizedAlpha trapezoidal(1.0);  // mid-point form of the average acceleration method
  EXPECT_DOUBLE_EQ(trapezoidal.alpha_m(), 0.5);
  EXPECT_DOUBLE_EQ(trapezoidal.alpha_f(), 0.5);
  EXPECT_DOUBLE_EQ(trapezoidal.beta(), 0.25);
  EXPECT_DOUBLE_EQ(trapezoidal.gamma(), 0.5);
  const GeneralizedAlpha annihilating(0.0);  // asymptotic annihilation
  EXPECT_DOUBLE_EQ(annihilating.alpha_m(), -1.0);
  EXPECT_DOUBLE_EQ(annihilating.alpha_f(), 0.0);
  EXPECT_DOUBLE_EQ(annihilating.beta(), 1.0);
  EXPECT_DOUBLE_EQ(annihilating.gamma(), 1.5);
}

TEST(GeneralizedAlpha, RefusesASpectralRadiusOutsideZeroToOne) {
  for (const double radius : {-0.1, 1.1, std::nan("")})
    EXPECT_THROW(GeneralizedAlpha{radius}, std::invalid_argument);
}

// One step of the free oscillator q_tt + k q = 0, h = 1, through the class itself.
Eigen::Vector3d stepped(const GeneralizedAlpha& method, double k, const Eigen::Vector3d& state) {
  const auto vector = [](double value) { return Eigen::VectorXd(Eigen::VectorXd::Constant(1, value)); };
  Kinematics now{vector(state[0]), vector(state[1]), vector(state[2])};
  Kinematics alpha_level = now;
  method.predict(now, 1.0, alpha_level);
  const double new_acceleration = -(alpha_level.acceleration[0] + k * alpha_level.displacement[0]) /
                                  (method.mass_factor() + method.stiffness_factor(1.0) * k);
  method.update(now, 1.0, vector(new_acceleration));
  return {now.displacement[0], now.velocity[0], now.acceleration[0]};
}

std::vector<double> moduli(double radius, double omega) {
  const GeneralizedAlpha method(radius);
  Eigen::Matrix3d map;
  for (Eigen::Index j = 0; j < 3; ++j) map.col(j) = stepped(method, omega * omega, Eigen::Vector3d::Unit(j));
  const Eigen::Vector3d values = map.eigenvalues().cwiseAbs();
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.rbegin(), sorted.rend());
  return sorted;
}

TEST(GeneralizedAlpha, AmplificationIsThatOfThePublishedEquations) {
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    for (const double omega : {0.1, 1.0, 7.0}) {
      const std::vector<double> computed = moduli(radius, omega);
      const std::vector<double> published = studies::amplification_moduli(radius, omega);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(within(computed[i], published[i], round_off(30, 100, 1.0))) << radius << " " << omega;
    }
}

TEST(GeneralizedAlpha, SpectralRadiusAtInfinityIsAsAsked) {
  // All three eigenvalues meet there, so that an error e of the matrix moves them by e^(1/3); at omega h =
  // 1e4 the matrix is 1/(omega h)^2 from its limit.
  for (const double radius : {0.0, 0.3, 0.5, 0.9, 1.0})
    EXPECT_TRUE(within(moduli(radius, 1e4).front(), radius,
                       discretisation(std::cbrt(1e-8), 4.0, "(omega h)^(-2/3)")));
}

TEST(GeneralizedAlpha, TakesTheLoadAtTheAlphaLevel) {
  EXPECT_DOUBLE_EQ(GeneralizedAlpha(1.0).load_time(2.0, 0.1), 2.05);
  EXPECT_DOUBLE_EQ(GeneralizedAlpha(0.0).load_time(2.0, 0.1), 2.1);
  EXPECT_DOUBLE_EQ(GeneralizedAlpha(0.5).load_time(0.0, 0.3), 0.2);
}

}  // namespace
}  // namespace stickslip::testing
