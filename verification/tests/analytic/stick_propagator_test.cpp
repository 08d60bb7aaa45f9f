// SPDX-License-Identifier: MIT
/// A stick phase between its samples: what the search for the onset rests on.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/analytic/stick_propagator.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using analytic::ContactDynamics;
using analytic::ContactModel;
using analytic::StickPropagator;

// Three modes under a load in the middle of them, with every coupling that a model can have.
ContactModel three_modes(bool damped) {
  ContactModel model{.angular_frequency = {2.0, 5.0, 11.0},
                     .mass_coupling = {0.4, -0.3, 0.2},
                     .contact_mass = 1.5,
                     .contact_stiffness = 20.0,
                     .follower = {0.9, -0.7, 0.5},
                     .contact_follower = -0.6,
                     .damping = {},
                     .load = {0.7, 0.4, -0.3, -0.2},
                     .load_angular_frequency = 3.0,
                     .wall_amplitude = 0.3,
                     .normal_force = 1e6,
                     .friction = data::FrictionLaw({})};
  if (!damped) return model;
  model.damping = analytic::Matrix(4, 4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      model.damping(i, j) = (i == j ? 0.4 : 0.1) + 0.05 * static_cast<double>(i + j);
  return model;
}

class StickPropagatorOf : public ::testing::TestWithParam<bool> {
 protected:
  StickPropagatorOf() : dynamics_(three_modes(GetParam())), phase_(dynamics_) {
    phase_.begin(start, {{0.3, -0.2, 0.1},
                         {-0.5, 0.4, 1.0},
                         0.1 + dynamics_.wall_displacement(start),
                         dynamics_.wall_velocity(start)});
  }
  static constexpr double start = 0.7;
  ContactDynamics dynamics_;
  StickPropagator phase_;
};

STICKSLIP_VERIFIES(StickPropagatorOf, "D1");
TEST_P(StickPropagatorOf, ThreeModesHasTheRateOfItsForce) {
  // Central differences: h^2/6 of the third derivative, (11/s)^3 of a force of 30 N, and eps of it over h.
  const double h = 1e-4, scale = 30.0;
  for (int k = 1; k <= 40; ++k) {
    const double t = start + 0.13 * k;
    const double slope = (phase_.force(t + h) - phase_.force(t - h)) / (2.0 * h);
    EXPECT_TRUE(within(phase_.force_rate(t), slope,
                       discretisation(h * h / 6.0 * std::pow(11.0, 3) * scale, 1.0, "h^2/6 f_ttt")))
        << t;
  }
}

TEST_P(StickPropagatorOf, ThreeModesBoundsTheForceCurvatureClosely) {
  // Moduli are added for the parts of f, which do not peak together: some times too much, but no decade.
  const double h = 1e-3;
  for (int k = 1; k <= 40; ++k)
    for (const double length : {0.01, 0.2}) {
      const double t = start + 0.13 * k;
      double largest = 0.0;
      for (int i = 0; i <= 20; ++i) {
        const double at = t + length * i / 20.0;
        largest =
            std::max(largest, std::abs(phase_.force(at + h) - 2.0 * phase_.force(at) + phase_.force(at - h)) /
                                  (h * h));
      }
      EXPECT_GE(phase_.curvature_bound(t, length), largest * (1.0 - 1e-4)) << t;
    }
  double sum_of_bounds = 0.0, sum_of_bends = 0.0;
  for (int k = 1; k <= 400; ++k) {
    const double t = start + 0.013 * k;
    sum_of_bounds += phase_.curvature_bound(t, 0.0);
    sum_of_bends += std::abs(phase_.force(t + h) - 2.0 * phase_.force(t) + phase_.force(t - h)) / (h * h);
  }
  EXPECT_LT(sum_of_bounds, 8.0 * sum_of_bends);
}

INSTANTIATE_TEST_SUITE_P(Damped, StickPropagatorOf, ::testing::Bool());

}  // namespace
}  // namespace stickslip::testing
