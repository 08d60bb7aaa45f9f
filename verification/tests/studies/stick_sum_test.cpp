// SPDX-License-Identifier: MIT
/// The modal sum of the stick state against its equation of motion, integrated here by other means.

#include "studies/verification/stick_sum.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Sinusoid;
using studies::StickReading;
using studies::StickSum;

using std::numbers::pi;

// One mode, every factor another number.
StickSum one_mode() {
  StickSum sum{.force = 3.0, .force_per_acceleration = 0.2, .displacement = 0.4, .modes = {}};
  sum.modes.push_back({.natural_frequency = 5.0,
                       .oscillator_frequency = 5.0,
                       .participation = 0.7,
                       .initial_rate = 0.3,
                       .force = 11.0,
                       .displacement = 0.9});
  return sum;
}

const data::HarmonicExcitation& base_motion() {
  static const data::HarmonicExcitation excitation({.frequency_hz = 0.5, .amplitude = 2e-3});
  return excitation;
}

// Of T'' + d T' + w^2 T = C h'' at the time, from T = 0, T' = V h'(0), by the fourth-order method of Runge
// and Kutta.
double coordinate_at(double time, const StickSum::Mode& mode, double damping = 0.0) {
  const double omega = pi, amplitude = 2e-3;
  const auto acceleration = [&](double t, double q, double v) {
    return -mode.participation * amplitude * omega * omega * std::sin(omega * t) - damping * v -
           mode.oscillator_frequency * mode.oscillator_frequency * q;
  };
  const int steps = 4000;
  const double h = time / steps;
  double q = 0.0, v = mode.initial_rate * amplitude * omega;
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    const double k1 = v, l1 = acceleration(t, q, v);
    const double k2 = v + 0.5 * h * l1, l2 = acceleration(t + 0.5 * h, q + 0.5 * h * k1, v + 0.5 * h * l1);
    const double k3 = v + 0.5 * h * l2, l3 = acceleration(t + 0.5 * h, q + 0.5 * h * k2, v + 0.5 * h * l2);
    const double k4 = v + h * l3, l4 = acceleration(t + h, q + h * k3, v + h * l3);
    q += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    v += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
  }
  return q;
}

STICKSLIP_VERIFIES(StickSums, "X17");
TEST(StickSums, SolveTheEquationOfTheMode) {
  const StickSum sum = one_mode();
  for (const double t : {0.1, 0.37, 1.0, 2.6}) {
    const double q = coordinate_at(t, sum.modes[0]), h = 2e-3 * std::sin(pi * t), h_tt = -pi * pi * h;
    // Runge-Kutta: (w h)^4/120 of the motion at 4000 steps, below 1e-11.
    EXPECT_NEAR(studies::value_at(sinusoids(sum, base_motion(), StickReading::force), t),
                3.0 * h + 0.2 * h_tt + 11.0 * q, 1e-12);
    EXPECT_NEAR(studies::value_at(sinusoids(sum, base_motion(), StickReading::displacement), t),
                0.4 * h + 0.9 * q, 1e-13);
  }
}

TEST(StickSums, WithoutStartAreInPhase) {
  StickSum sum = one_mode();
  sum.free_vibrations = false;
  const auto terms = sinusoids(sum, base_motion(), StickReading::displacement);
  ASSERT_EQ(terms.size(), 1u);
  EXPECT_DOUBLE_EQ(terms[0].angular_frequency, pi);
  EXPECT_NEAR(terms[0].amplitude, 2e-3 * (0.4 + 0.9 * 0.7 * pi * pi / (pi * pi - 25.0)), 1e-17);
  // T(0) = 0 of a cosine: the free vibration begins as the opposite of the steady one.
  sum.free_vibrations = sum.cosine = true;
  EXPECT_NEAR(sinusoids(sum, base_motion(), StickReading::displacement)[1].amplitude,
              -2e-3 * 0.9 * 0.7 * pi * pi / (pi * pi - 25.0), 1e-17);
}

TEST(StickSums, GrowLinearlyAtResonance) {
  StickSum sum = one_mode();
  sum.modes[0].oscillator_frequency = pi;
  const double t = 2.5;
  const double q = coordinate_at(t, sum.modes[0]);
  EXPECT_NEAR(studies::value_at(sinusoids(sum, base_motion(), StickReading::displacement), t),
              0.8e-3 * std::sin(pi * t) + 0.9 * q,
              1e-8 * pi * t * (0.9 * 0.5 * 0.7 * 2e-3 * pi * t));  // of the growing part
}

TEST(StickSums, HaveTheirLargestValue) {
  const std::vector<Sinusoid> one{{2.0, 3.0}};
  // The parabola through three samples leaves (w h)^4/128 of the amplitude at most.
  for (const double step : {0.05, 0.031})
    EXPECT_NEAR(studies::max_abs(one, 5.0, step), 2.0, 2.0 * std::pow(3.0 * step, 4) / 128.0);
  EXPECT_NEAR(studies::max_abs(one, 0.3, 0.1), 2.0 * std::sin(0.9), 1e-14);   // before the first peak
  EXPECT_NEAR(studies::max_abs(one, 0.32, 0.1), 2.0 * std::sin(0.9), 1e-14);  // samples up to the nearest
  const std::vector<Sinusoid> two{{2.0, 3.0}, {-1.5, 7.0}};
  double largest = 0.0;
  for (int i = 0; i <= 400'000; ++i) largest = std::max(largest, std::abs(studies::value_at(two, i * 1e-5)));
  // The third derivative times h^3/(9 sqrt(3)), what a parabola leaves between its points.
  EXPECT_NEAR(studies::max_abs(two, 4.0, 0.01), largest,
              (2.0 * 27.0 + 1.5 * 343.0) * 1e-6 / (9.0 * std::sqrt(3.0)));
}

TEST(StickSums, AreSteppedAsTheBalanceSays) {
  const StickSum sum = one_mode();
  const StickSum::Mode& mode = sum.modes[0];
  const studies::ModalScheme scheme{.step = 0.02,
                                    .alpha_m = 0.3,
                                    .alpha_f = 0.4,
                                    .beta = 0.31,
                                    .gamma = 0.62,
                                    .load_delay = 0.013,
                                    .damping_ratio = 0.05};
  const auto history = stepped(sum, scheme, base_motion(), StickReading::displacement, 60);
  const auto force = stepped(sum, scheme, base_motion(), StickReading::force, 60);
  ASSERT_EQ(history.size(), 61u);
  const double w = mode.oscillator_frequency, d = 2.0 * 0.05 * w, h = 0.02, base = 2e-3 * pi * pi;
  double q = 0.0, v = 0.3 * 2e-3 * pi, a = -d * v;
  for (std::size_t n = 0; n <= 60; ++n) {
    const double t = static_cast<double>(n) * h;
    EXPECT_NEAR(history[n], 0.8e-3 * std::sin(pi * t) + 0.9 * q, 1e-15);
    EXPECT_NEAR(force[n], (3.0 - 0.2 * pi * pi) * 2e-3 * std::sin(pi * t) + 11.0 * q, 1e-14);
    // What the balance at the weighted instants leaves, for a new acceleration; it is linear in that.
    const auto left = [&](double next) {
      const double new_q = q + h * v + h * h * ((0.5 - 0.31) * a + 0.31 * next),
                   new_v = v + h * ((1.0 - 0.62) * a + 0.62 * next);
      return 0.7 * next + 0.3 * a + d * (0.6 * new_v + 0.4 * v) + w * w * (0.6 * new_q + 0.4 * q) +
             0.7 * base * std::sin(pi * (t + 0.013));
    };
    const double next = -left(0.0) / (left(1.0) - left(0.0));
    q += h * v + h * h * ((0.5 - 0.31) * a + 0.31 * next);
    v += h * ((1.0 - 0.62) * a + 0.62 * next);
    a = next;
  }
}

}  // namespace
}  // namespace stickslip::testing
