// SPDX-License-Identifier: MIT
/// A wall that moves, and periodic motions with their Floquet multipliers, where they are known in closed form: one mass.

#include "stickslip/analytic/periodic_motion.hpp"
#include "stickslip/analytic/steady_sliding.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

// A mass of 2 kg on a spring of 50 N/m, pressed with 10 N on a belt of 0.3 m/s. Without damping.
struct Belt {
  double mass = 2.0, stiffness = 50.0, normal_force = 10.0, speed = 0.3, static_coefficient = 0.6,
         kinetic_coefficient = 0.4;

  [[nodiscard]] double omega() const { return std::sqrt(stiffness / mass); }
  // How far the spring is stretched beyond the equilibrium of sliding when the slip begins, m.
  [[nodiscard]] double excess() const {
    return (static_coefficient - kinetic_coefficient) * normal_force / stiffness;
  }
  // The mass slides on the arc of a circle in (x, v/omega) and comes back to the speed of the belt by symmetry.
  [[nodiscard]] double slip_time() const {
    return 2.0 / omega() * (pi - std::atan(omega() * excess() / speed));
  }
  [[nodiscard]] double stick_time() const { return 2.0 * excess() / speed; }
};

analytic::ContactModel jumping_belt(const Belt& belt) {
  analytic::ContactModel model =
      contact_model({.mass = belt.mass,
                     .stiffness = belt.stiffness,
                     .normal_force = belt.normal_force,
                     .friction = {.static_coefficient = belt.static_coefficient,
                                  .kinetic_coefficient = belt.kinetic_coefficient,
                                  .decay = std::numeric_limits<double>::infinity()}});
  model.wall_speed = belt.speed;
  return model;
}

STICKSLIP_VERIFIES(MovingWall, "W1");
TEST(MovingWall, KeepsTheEnergyBalance) {
  const Belt belt;
  analytic::EventDriven run(jumping_belt(belt), {.keep_energy_balance = true});
  run.advance_to(5.0);
  const auto energy = run.energy_balance();
  const double change = energy.kinetic + energy.potential - 0.5 * belt.mass * belt.speed * belt.speed;
  EXPECT_GT(energy.base_work, 1.0);
  EXPECT_TRUE(within(change, energy.base_work - energy.friction_loss,
                     discretisation(1e-9 * energy.base_work, 1.0, "1e-12 a step")));
}

// --- Multipliers

void expect_multipliers(const std::vector<Complex>& computed, const std::vector<Complex>& expected,
                        const Tolerance& tolerance) {
  ASSERT_EQ(computed.size(), expected.size());
  for (const Complex value : expected) {
    const auto nearest =
        *std::ranges::min_element(computed, {}, [&](Complex z) { return std::abs(z - value); });
    EXPECT_TRUE(within(nearest, value, tolerance));
  }
}

STICKSLIP_VERIFIES(PeriodicMotion, "W3");
TEST(PeriodicMotion, OfABeltHasTheExactPeriod) {
  const Belt belt;
  const auto [motion, reason] = analytic::self_excited_motion(jumping_belt(belt), 20.0, 0.01);
  ASSERT_TRUE(motion);
  EXPECT_TRUE(within(motion->period, belt.slip_time() + belt.stick_time(),
                     discretisation(1e-10, 1.0, "1e-12 a step")));
  EXPECT_EQ(motion->events.size(), 2u);
  // A shift in time stays, and a stop forgets everything else.
  expect_multipliers(motion->multipliers, {1.0, 0.0}, discretisation(1e-10, 1.0, "1e-12 a step"));
}

// A mass with a damper that slides with falling friction is linear but for the change of the slope.
TEST(PeriodicMotion, OfSlidingHasItsMultipliers) {
  const double mass = 2.0, stiffness = 50.0, damping = 0.7, speed = 0.4;
  analytic::ContactModel model =
      contact_model({.mass = mass,
                     .stiffness = stiffness,
                     .normal_force = 10.0,
                     .friction = {.static_coefficient = 0.6, .kinetic_coefficient = 0.4, .decay = 2.0}});
  model.wall_speed = speed;
  model.damping = analytic::Matrix(1, 1);
  model.damping(0, 0) = damping;
  const double mu = 0.4 + 0.2 * std::exp(-2.0 * speed), slope = 10.0 * 0.4 * std::exp(-2.0 * speed);
  EXPECT_TRUE(within(analytic::falling_slope(model.friction, 10.0, speed), slope, round_off(5, 1, slope)));
  const analytic::ContactStart start{{{}, {}, mu * 10.0 / stiffness, 0.0}, data::ContactState::slip};
  const double duration = 0.8, decay = 0.5 * (damping - slope) / mass;
  const Complex root(-decay, std::sqrt(stiffness / mass - decay * decay));
  const auto image = analytic::poincare_map(model, start, duration);
  expect_multipliers(analytic::eigenvalues(image.derivative),
                     {std::exp(root * duration), std::exp(std::conj(root) * duration)},
                     discretisation(1e-11, 1.0, "1e-13 a step"));
}

// Den Hartog (1931): a mass between two stops of velocity, m = k = 1, force F sin(beta t), friction f, no halt. With
// theta = pi/beta: x0 is the amplitude, r the ratio of the accelerations after and before a reversal, and half a period,
// mirrored, is diag(1, r) times the rotation by theta.
TEST(PeriodicMotion, OfDenHartogIsExact) {
  for (const double beta : {0.7, 0.85, 1.3}) {
    SCOPED_TRACE(beta);
    const double force = 1.0, friction = 0.1, theta = pi / beta;
    const double gain = force / (1.0 - beta * beta),
                 loss = std::sin(theta) / (beta * (1.0 + std::cos(theta)));
    const double amplitude = std::sqrt(gain * gain - std::pow(friction * loss, 2));
    const double inertia = beta * beta * amplitude, ratio = (inertia - friction) / (inertia + friction);
    const Complex half = 0.5 * (1.0 + ratio) * std::cos(theta);
    const Complex root = std::sqrt(half * half - ratio);
    analytic::ContactModel model = contact_model(
        {.mass = 1.0,
         .stiffness = 1.0,
         .normal_force = 1.0,
         .friction = {.static_coefficient = friction, .kinetic_coefficient = friction, .decay = 0.0},
         .omega = beta});
    model.load = {force};
    const auto [motion, reason] = analytic::forced_motion(model, 1, 60);
    ASSERT_TRUE(motion);
    ASSERT_EQ(motion->events.size(), 2u);
    EXPECT_EQ(motion->events.front().change, data::ContactChange::reversal);
    EXPECT_TRUE(within(std::abs(motion->events.front().position), amplitude,
                       discretisation(1e-10, 1.0, "1e-12 a step")));
    expect_multipliers(motion->multipliers, {std::pow(half + root, 2), std::pow(half - root, 2)},
                       discretisation(1e-9, 1.0, "1e-12 a step"));
  }
}

// --- Two modes against finite differences

struct Flow {
  analytic::ContactModel model;
  double duration{};

  [[nodiscard]] std::vector<double> operator()(const analytic::ContactStart& start) const {
    analytic::EventDriven run(model, {.tolerance = 1e-14});
    analytic::start(run, model, start);
    run.advance_to(duration);
    return {run.amplitudes()[0], run.contact_displacement(), run.rates()[0], run.contact_velocity()};
  }
};

double& coordinate(analytic::ContactStart& start, std::size_t i) {
  analytic::ContactKinematics& state = start.kinematics;
  return i == 0   ? state.amplitudes[0]
         : i == 1 ? state.displacement
         : i == 2 ? state.rates[0]
                  : state.velocity;
}

void expect_derivative_of_differences(const analytic::ContactModel& model,
                                      const analytic::ContactStart& start, double duration) {
  const auto image = analytic::poincare_map(model, start, duration);
  const Flow flow{model, duration};
  constexpr double step = 1e-5;
  for (std::size_t j = 0; j < 4; ++j) {
    if (j == 3 && start.phase == data::ContactState::stick) {  // no coordinate there
      for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(image.derivative(i, j), 0.0);
      continue;
    }
    analytic::ContactStart ahead = start, behind = start;
    coordinate(ahead, j) += step;
    coordinate(behind, j) -= step;
    const auto after = flow(ahead), before = flow(behind);
    // A central difference: rounding 1e-12/step, and the third derivative times step^2/6, about 1 here.
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_TRUE(within(image.derivative(i, j), (after[i] - before[i]) / (2.0 * step),
                         discretisation(1e-12 / step + step * step, 10.0, "rounding and step^2")))
          << i << j;
  }
}

// The pair of masses on a moving wall with a falling law: stops, onsets and reversals.
TEST(PeriodicMotion, HasTheDerivativeOfDifferences) {
  analytic::ContactModel model = contact_model(ForcedPair());
  for (const double decay : {1.5, std::numeric_limits<double>::infinity()}) {
    model.friction =
        data::FrictionLaw({.static_coefficient = 0.2, .kinetic_coefficient = 0.12, .decay = decay});
    model.wall_speed = 0.05;
    std::set<data::ContactChange> seen;
    for (const auto& [phase, velocity] :
         {std::pair{data::ContactState::slip, 0.9}, {data::ContactState::stick, 0.0}}) {
      const analytic::ContactStart start{{{0.1}, {-0.2}, 0.05, velocity}, phase};
      for (const double duration : {0.7, 2.1, 4.2}) {
        SCOPED_TRACE(duration);
        expect_derivative_of_differences(model, start, duration);
        for (const auto& event : analytic::poincare_map(model, start, duration).events)
          seen.insert(event.change);
      }
    }
    EXPECT_EQ(seen.size(), 3u);
  }
}

TEST(PeriodicMotion, OfAForcedPairReturns) {
  analytic::ContactModel model = contact_model(ForcedPair());
  const auto [motion, reason] = analytic::forced_motion(model, 1, 20);
  ASSERT_TRUE(motion);
  const Flow flow{model, motion->period};
  auto start = motion->start;
  const auto end = flow(start);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_TRUE(within(end[i], coordinate(start, i), discretisation(1e-10, 1.0, "1e-12 a step")));
  EXPECT_LT(std::abs(motion->multipliers.front()), 1.0);
  EXPECT_TRUE(within(motion->multipliers.back(), 0.0, discretisation(1e-12, 1.0, "1e-13 a step")));
}

TEST(PeriodicMotion, IsNotFoundWithoutSlip) {
  analytic::ContactModel model = contact_model(ForcedPair());
  model.normal_force = 1e3;
  EXPECT_EQ(analytic::forced_motion(model, 1, 5).reason, analytic::NoMotion::sticks);
  EXPECT_THROW((void)analytic::forced_motion(model, 0, 5), data::FieldError);
}

// Without a spring the wall drags a mass with a damper c to the velocity mu_m N/c, here 0.015 and 0.005 of the wall's 2 m/s:
// steady is what stays below a hundredth. On a spring it rings down to as much in the time that the run settles.
TEST(PeriodicMotion, ExceedsAHundredthOfTheWall) {
  const auto reason = [](double stiffness, double damping, const data::FrictionCoefficients& friction,
                         double settle) {
    analytic::ContactModel model =
        contact_model({.stiffness = stiffness, .normal_force = 1.0, .friction = friction});
    model.wall_speed = 2.0;
    model.damping = analytic::Matrix(1, 1);
    model.damping(0, 0) = damping;
    const auto search = analytic::self_excited_motion(model, settle, 0.01);
    EXPECT_FALSE(search.motion);
    return search.reason;
  };
  for (const double share : {0.015, 0.005}) {
    const auto expected = share < 0.01 ? analytic::NoMotion::steady : analytic::NoMotion::unsettled;
    EXPECT_EQ(reason(0.0, 1.0, {0.9, 2.0 * share, std::numeric_limits<double>::infinity()}, 30.0), expected);
    EXPECT_EQ(reason(1.0, -2.0 * std::log(share) / 100.0, {0.1, 0.1}, 100.0), expected);
  }
  EXPECT_EQ(reason(1.0, 0.0, {100.0, 100.0}, 1.0), analytic::NoMotion::sticks);
}

TEST(PeriodicMotion, NeedsAMovingWallWithoutLoad) {
  const auto search = [](const analytic::ContactModel& model) {
    (void)analytic::self_excited_motion(model, 1.0, 0.01);
  };
  analytic::ContactModel pair = contact_model(ForcedPair());
  pair.wall_speed = 0.3;
  pair.wall_amplitude = 0.0;
  for (const std::vector<double>& load : {std::vector{1.0, 0.0}, {0.0, 1.0}}) {
    pair.load = load;
    EXPECT_THROW(search(pair), std::invalid_argument);
  }
  pair.load = {0.0, 0.0};
  EXPECT_NO_THROW(search(pair));
  pair.wall_amplitude = 0.1;
  EXPECT_THROW(search(pair), std::invalid_argument);
  pair.wall_amplitude = pair.wall_speed = 0.0;
  EXPECT_THROW(search(pair), std::invalid_argument);
}

// The change at t = 0 belongs to the start: the flow is that of a start in slip.
TEST(PeriodicMotion, FollowsAStartThatCannotStick) {
  const analytic::ContactModel model =
      contact_model({.stiffness = 2.0,
                     .normal_force = 10.0,
                     .friction = {.static_coefficient = 0.1, .kinetic_coefficient = 0.1, .decay = 0.0}});
  const auto image = [&](data::ContactState phase) {
    return analytic::poincare_map(model, {{{}, {}, 0.6, 0.0}, phase}, 0.5);
  };
  const auto held = image(data::ContactState::stick), slipping = image(data::ContactState::slip);
  EXPECT_TRUE(held.events.empty());
  EXPECT_EQ(held.derivative.values(), slipping.derivative.values());
}

}  // namespace
}  // namespace stickslip::testing
