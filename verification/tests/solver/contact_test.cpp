// SPDX-License-Identifier: MIT
/// The time stepper: contact changes of one and two masses beyond the histories of contact_battery_test.cpp, its energy balance, its
/// weights.

#include <Eigen/Dense>

#include "stickslip/solver/energy_balance.hpp"
#include "stickslip/solver/generalized_alpha.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"
#include "studies/common/discretisation.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::ContactEvent;
using data::ContactState;
using solver::ContactScheme;
using solver::IntegratorSettings;
using solver::StickSlipIntegrator;

// The pair without damping, load and follower term, on a wall at rest.
solver::ContactSystem pair_at_rest(double normal_force) {
  ForcedPair pair;
  pair.damping.setZero();
  pair.slip_stiffness = pair.stick_stiffness;
  pair.load.setZero();
  pair.wall_amplitude = 0.0;
  pair.normal_force = normal_force;
  pair.friction_coefficient = 0.1;
  return contact_system(pair);
}

STICKSLIP_VERIFIES(StickSlipIntegrator, "F6");
TEST(StickSlipIntegrator, MeetsBalanceAndLaw) {
  // The first row of M q_tt + C v + K q = s(t) p gives the acceleration of the first mass, the second one the force on
  // the contact, which in stick has the acceleration of the wall. The largest term is K q, about 30 N.
  const ForcedPair pair;
  StickSlipIntegrator integrator(contact_system(pair), {.time_step = 1e-2, .spectral_radius = 0.9});
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  const auto& system = integrator.system();
  int stuck = 0;
  while (integrator.steps() < 400) {
    integrator.step();
    if (integrator.state() == ContactState::slip) {
      const double limit = pair.friction_limit();
      ASSERT_TRUE(within(integrator.friction_force(), -std::copysign(limit, integrator.sliding_velocity()),
                         round_off(2, 1, limit)));
      continue;
    }
    ++stuck;
    const double t = integrator.time(), of_wall = system.wall.acceleration(t);
    const Eigen::Vector2d rest = pair.damping * integrator.velocity() +
                                 pair.slip_stiffness * integrator.displacement() -
                                 system.load_history(t) * pair.load;
    const double of_first = -(rest[0] + pair.mass(0, 1) * of_wall) / pair.mass(0, 0);
    ASSERT_TRUE(within(integrator.friction_force(),
                       pair.mass(1, 0) * of_first + pair.mass(1, 1) * of_wall + rest[1],
                       round_off(20, 2, 30.0)));
  }
  EXPECT_GT(stuck, 20);
  EXPECT_LT(stuck, 380);
}

TEST(StickSlipIntegrator, CapturesAtTheThreshold) {
  // Nothing acts on the mass, so that its velocity stays 2^-10 m/s to the last bit.
  const double velocity = 0x1p-10;
  for (const double threshold : {velocity, std::nextafter(velocity, 0.0)}) {
    StickSlipIntegrator glider(
        contact_system({.mass = 2.0, .normal_force = 30.0}),
        {.time_step = 0x1p-6, .spectral_radius = 0.9, .velocity_threshold = threshold});
    glider.start_slipping(scalar(0.0), scalar(velocity));
    glider.step();
    EXPECT_EQ(glider.events().size(), threshold < velocity ? 0u : 1u);
  }
}

TEST(StickSlipIntegrator, SlidesOnIfNotHeld) {
  // Turning points at 1.04 - 0.2 i beyond the dead zone of 0.1: a threshold affects the last one alone.
  const auto events = [](double threshold) {
    return run_from_slip(oscillating_mass,
                         {.time_step = 1e-2, .spectral_radius = 1.0, .velocity_threshold = threshold}, 1.04,
                         0.0, 12.0)
        ->events();
  };
  const auto without = events(0.0), with = events(0.05);
  ASSERT_EQ(without.size(), 5u);
  ASSERT_EQ(with.size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(with[i].change, data::ContactChange::reversal);
    EXPECT_EQ(with[i].time, without[i].time);
  }
  EXPECT_EQ(with[4].change, data::ContactChange::capture);
  EXPECT_LT(with[4].time, without[4].time);
}

TEST(StickSlipIntegrator, StartsAsOftenAsAsked) {
  // Each start lets go at once; only what happens within a step is chatter.
  StickSlipIntegrator oscillator(contact_system(oscillating_mass),
                                 {.time_step = 1e-2, .spectral_radius = 0.9});
  for (int i = 0; i < 2000; ++i) ASSERT_NO_THROW(oscillator.start_stuck(scalar(1.04), scalar(0.0)));
  EXPECT_EQ(oscillator.events().size(), 1u);
}

constexpr IntegratorSettings usable_settings{.time_step = 1e-3, .spectral_radius = 1.0};

TEST(StickSlipIntegrator, RefusesTheUnusable) {
  const auto refuses = [](const std::string& what,
                          const std::function<void(solver::ContactSystem&, IntegratorSettings&)>& spoil) {
    solver::ContactSystem system = pair_at_rest(1.0);
    IntegratorSettings settings = usable_settings;
    EXPECT_NO_THROW(StickSlipIntegrator(system, settings));
    spoil(system, settings);
    EXPECT_THROW(StickSlipIntegrator(system, settings), std::invalid_argument) << what;
  };
  for (const double step : {0.0, -1.0, std::nan("")})
    refuses("time step", [=](auto&, auto& settings) { settings.time_step = step; });
  refuses("radius", [](auto&, auto& settings) { settings.spectral_radius = 1.1; });
  refuses("threshold", [](auto&, auto& settings) { settings.velocity_threshold = -1.0; });
  refuses("no threshold", [](auto&, auto& settings) { settings.scheme = ContactScheme::paper; });
  refuses("negative mass", [](auto& system, auto&) { system.mass.coeffRef(0, 0) = -1.0; });
  refuses("three loads", [](auto& system, auto&) { system.load_shape = Eigen::VectorXd::Zero(3); });
  for (const double force : {-1.0, std::nan("")})
    refuses("normal force", [=](auto& system, auto&) { system.normal_force = force; });
  for (const Eigen::Index contact : {-1, 2})
    refuses("contact", [=](auto& system, auto&) { system.contact = contact; });
  for (const double stiffness : {std::nan(""), std::numeric_limits<double>::infinity()})
    refuses("stiffness", [=](auto& system, auto&) { system.stick_stiffness.coeffRef(0, 0) = stiffness; });
  for (const auto matrix : {&solver::ContactSystem::mass, &solver::ContactSystem::damping,
                            &solver::ContactSystem::stick_stiffness, &solver::ContactSystem::slip_stiffness})
    for (const int rows : {2, 3})
      refuses("size of a matrix",
              [=](auto& system, auto&) { (system.*matrix).conservativeResize(rows, 5 - rows); });
  StickSlipIntegrator run(pair_at_rest(1.0), usable_settings);
  const Eigen::VectorXd one = scalar(0.0), two = Eigen::VectorXd::Zero(2);
  for (const auto& [displacement, velocity] : {std::pair{one, two}, {two, one}}) {
    EXPECT_THROW(run.start_stuck(displacement, velocity), std::invalid_argument);
    EXPECT_THROW(run.start_slipping(displacement, velocity), std::invalid_argument);
  }
}

TEST(StickSlipIntegrator, ShowsTheForceOfTheStep) {
  // The force of a contact on a spring follows from the step.
  solver::ContactSystem system = contact_system(oscillating_mass);
  system.tangential = data::TangentialContact({.tangential_stiffness = 400.0});
  StickSlipIntegrator oscillator(system, {.time_step = 1e-2, .spectral_radius = 1.0});
  oscillator.start_slipping(scalar(1.04), scalar(0.0));
  double force = 0.0;
  oscillator.observe([&force](const StickSlipIntegrator& now) { force = now.friction_force(); });
  while (oscillator.time() < 4.0) {
    oscillator.step();
    ASSERT_EQ(force, oscillator.friction_force()) << oscillator.time() << " s";
  }
  EXPECT_GE(oscillator.events().size(), 5u);
}

TEST(StickSlipIntegrator, HasAnUnyieldingSpring) {
  // A step solves for the force of the contact's spring with the motion, so that both take the same steps.
  const double h = 0.02, spring = 400.0;
  for (const double radius : {0.0, 0.5, 1.0}) {
    const solver::IntegratorSettings settings{.time_step = h, .spectral_radius = radius};
    solver::ContactSystem system =
        contact_system({.stiffness = 100.0, .normal_force = 1000.0, .friction = coulomb});
    system.tangential = data::TangentialContact({.tangential_stiffness = spring});
    StickSlipIntegrator held(system, settings);
    StickSlipIntegrator free(contact_system({.stiffness = 100.0 + spring, .friction = coulomb}), settings);
    for (StickSlipIntegrator* run : {&held, &free}) {
      run->start_slipping(scalar(0.0), scalar(1.0));
      for (int step = 0; step < 3; ++step) run->step();
    }
    // The force is found to 1e-15 of the largest one, and moves the mass h^2/2 times as much in each step.
    EXPECT_NEAR(held.displacement()[0], free.displacement()[0], 3.0 * 1e-15 * 100.0 * h * h) << radius;
    EXPECT_GT(free.velocity()[0], 0.0);
  }
}

TEST(StickSlipIntegrator, HasALongestStep) {
  // At spectral radius 0 the balance holds at the end of the step: m (2 a_1 - a_0) = -mu(v_1) N with
  // v_1 = v_0 + h (3 a_1 - a_0)/2. The step is 99 % of the longest one, 4 m/(3 N (mu_s - mu_m) alpha).
  const data::FrictionCoefficients weakening{
      .static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.5};
  const data::FrictionLaw law(weakening);
  const double normal_force = 10.0, h = 0.99 * 4.0 / (3.0 * normal_force * 0.3 * 1.5);
  for (const double v0 : {1.57, 1.6, 1.7, 2.0, 3.0}) {
    StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = weakening}),
                               {.time_step = h, .spectral_radius = 0.0});
    slider.start_slipping(scalar(0.0), scalar(v0));
    const double a0 = -solver::friction_coefficient(law, v0) * normal_force;
    slider.step();
    ASSERT_TRUE(slider.events().empty()) << v0;
    const double v1 = slider.velocity()[0];
    const double a1 = ((v1 - v0) / (0.5 * h) + a0) / 3.0;
    EXPECT_TRUE(within(2.0 * a1 - a0, -solver::friction_coefficient(law, v1) * normal_force,
                       round_off(20, 1, normal_force)))
        << "v_0 = " << v0 << ", v_1 = " << v1;
  }
  StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = weakening}),
                             {.time_step = 1.02 * h, .spectral_radius = 0.0});
  slider.start_slipping(scalar(0.0), scalar(2.0));
  expect_error_message<std::runtime_error>([&] { slider.step(); },
                                           {"time_step = 0.2992 s", "about 0.296296 s"});
}

TEST(StickSlipIntegrator, StopsWhenNotFinite) {
  StickSlipIntegrator slider(contact_system({.normal_force = 10.0, .friction = coulomb}),
                             {.time_step = 0.5, .spectral_radius = 1.0});
  slider.start_slipping(scalar(1.79e308), scalar(1e308));
  EXPECT_THROW(slider.step(), std::runtime_error);
}

TEST(StickSlipIntegrator, RefusesSingularMatrices) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2);
  solver::ContactSystem overflown = pair_at_rest(1.0);
  overflown.slip_stiffness.coeffRef(0, 0) = std::nan("");
  StickSlipIntegrator sliding(overflown, usable_settings);
  for (int attempt = 0; attempt < 2; ++attempt)
    EXPECT_THROW(sliding.start_slipping(zero, zero), std::runtime_error);

  // In a step of 1 s, M/2 + C/4 + K/8 = 0 for the first mass.
  solver::ContactSystem cancelling = pair_at_rest(1.0);
  cancelling.damping.coeffRef(0, 0) = -19.0;
  StickSlipIntegrator stuck(cancelling, {.time_step = 1.0, .spectral_radius = 1.0});
  for (int attempt = 0; attempt < 2; ++attempt)
    EXPECT_THROW(stuck.start_stuck(zero, zero), std::runtime_error);
}

STICKSLIP_VERIFIES(ContactScheme, "F6");
TEST(ContactScheme, OfThePaperMissesItsThreshold) {
  // v = 1.3 - 1.5 t in steps of 0.07 s: v falls by 0.105 m/s a step, from 0.04 to -0.065 m/s. A threshold of
  // 0.05 m/s is met at 0.04 m/s; one of 0.03 m/s is not, and friction flips for ever.
  const auto run = [](double threshold) {
    return run_from_slip(sliding_mass,
                         {.time_step = 0.07,
                          .spectral_radius = 1.0,
                          .velocity_threshold = threshold,
                          .scheme = ContactScheme::paper},
                         0.0, 1.3, 2.07)
        ->events();
  };
  const auto held = run(0.05), missed = run(0.03);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].change, data::ContactChange::capture);
  EXPECT_DOUBLE_EQ(held[0].time, 12 * 0.07);
  EXPECT_TRUE(within(held[0].residual_velocity, 0.04, round_off(12, 1, 1.3)));
  ASSERT_EQ(missed.size(), 17u);  // at the start of every step from the 14th to the 30th
  for (const auto& event : missed) EXPECT_EQ(event.change, data::ContactChange::reversal);
}

TEST(ContactScheme, AtTheEndOfStepIsLate) {
  const IntegratorSettings settings{
      .time_step = 0.07, .spectral_radius = 0.9, .scheme = ContactScheme::end_of_step};
  const auto slider = run_from_slip(sliding_mass, settings, 0.0, 1.3, 2.07);
  ASSERT_EQ(slider->events().size(), 1u);
  const ContactEvent& stop = slider->events().front();
  EXPECT_EQ(stop.change, data::ContactChange::capture);
  EXPECT_DOUBLE_EQ(stop.time, 13 * 0.07);
  EXPECT_TRUE(within(stop.residual_velocity, -0.065, round_off(13, 1, 1.3)));
  EXPECT_EQ(slider->velocity()[0], 0.0);

  // The plane lets go at asin(1/15)/(2 pi) = 0.010618 s: after the eleventh step of 1 ms.
  StickSlipIntegrator mass(contact_system(shaken_plane(15.0)),
                           {.time_step = 1e-3, .spectral_radius = 0.9, .scheme = ContactScheme::end_of_step});
  mass.start_stuck(scalar(0.0), scalar(0.0));
  while (mass.steps() < 20) mass.step();
  ASSERT_FALSE(mass.events().empty());
  EXPECT_EQ(mass.events()[0].change, data::ContactChange::onset);
  EXPECT_DOUBLE_EQ(mass.events()[0].time, 0.011);
}

// --- The energy balance against exact works, and what changes of the contact do to it

using solver::EnergyRecorder;

void keep(EnergyRecorder& recorder, StickSlipIntegrator& integrator) {
  integrator.observe([&recorder](const StickSlipIntegrator& now) { recorder.record(now); });
}

STICKSLIP_VERIFIES(EnergyRecorder, "F8");
TEST(EnergyRecorder, FrictionLossIsForceTimesPath) {
  // k/2 (1.04^2 - 0.04^2) = 2.16 J over the turning points 1.04, -0.84, 0.64, -0.44, 0.24, -0.04. At spectral radius 1
  // the turning points are exact, and the trapezoidal rule sums the constant force times the path of each of the 7854
  // steps up to 5 pi/2 s.
  const double h = 1e-3;
  StickSlipIntegrator oscillator(contact_system(oscillating_mass), {.time_step = h, .spectral_radius = 1.0});
  oscillator.start_slipping(scalar(1.04), scalar(0.0));
  EnergyRecorder recorder(oscillator);
  keep(recorder, oscillator);
  while (oscillator.time() < 12.0) oscillator.step();
  EXPECT_TRUE(within(recorder.balance().friction_loss, 2.16, round_off(7854, 1, 2.16)));
  EXPECT_EQ(recorder.balance().base_work, 0.0);
  EXPECT_EQ(recorder.balance().follower_work, 0.0);
  EXPECT_EQ(recorder.balance().damping_loss, 0.0);
  // A stuck contact loses nothing more.
  const double loss = recorder.balance().friction_loss;
  while (oscillator.time() < 13.0) oscillator.step();
  EXPECT_EQ(recorder.balance().friction_loss, loss);
}

double energy(const StickSlipIntegrator& now) {
  return 0.5 * now.velocity().dot(now.system().mass * now.velocity()) +
         0.5 * now.displacement().dot(now.system().stick_stiffness * now.displacement());
}

// 12 s of the pair from rest, each state before and after a change given to `change`.
template <typename Change>
solver::EnergyBalance balance_of_the_pair(const IntegratorSettings& settings, Change&& change) {
  StickSlipIntegrator integrator(contact_system(ForcedPair{}), settings);
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  EnergyRecorder recorder(integrator);
  struct State {
    double time{}, energy{};
    Eigen::Vector2d displacement, velocity;
  };
  const auto state_of = [](const StickSlipIntegrator& now) {
    return State{now.time(), energy(now), now.displacement(), now.velocity()};
  };
  State before = state_of(integrator);
  integrator.observe([&](const StickSlipIntegrator& now) {
    recorder.record(now);
    const State after = state_of(now);
    if (after.time == before.time) change(now, before, after);
    before = after;
  });
  while (integrator.time() < 12.0) integrator.step();
  return recorder.balance();
}

STICKSLIP_VERIFIES(ContactChanges, "F8");
TEST(ContactChanges, TakeTheEnergyOfTheImpulseAlone) {
  // In coordinates that the wall moves through, the impulse -m_c v_s of a capture also does the work -m_c v_s w_t of the wall. It is
  // M-orthogonal: what it takes away has no inertia force but at the contact.
  for (const ContactScheme scheme : {ContactScheme::located, ContactScheme::end_of_step})
    for (const double threshold : {0.0, 0.05}) {
      int changes = 0;
      double losses = 0.0;
      const auto balance = balance_of_the_pair(
          {.time_step = 0.012, .spectral_radius = 0.9, .velocity_threshold = threshold, .scheme = scheme},
          [&](const StickSlipIntegrator& now, const auto& before, const auto& after) {
            ++changes;
            const double gain = after.energy - before.energy, wall = now.system().wall.velocity(now.time());
            EXPECT_EQ(after.displacement, before.displacement);
            if (now.events().back().change != data::ContactChange::capture) {
              EXPECT_EQ(after.velocity, before.velocity);
              return;
            }
            const double sliding = before.velocity[1] - wall;
            const double loss = 0.5 * now.contact_mass() * sliding * sliding;
            EXPECT_TRUE(within(gain, -now.contact_mass() * sliding * wall - loss,
                               round_off(20, 1, before.energy + after.energy)));
            const Eigen::Vector2d momentum = now.system().mass * (after.velocity - before.velocity);
            EXPECT_TRUE(within(momentum[0], 0.0, round_off(20, 1, 1.0)));
            losses += loss;
          });
      EXPECT_GE(changes, 20);
      EXPECT_TRUE(within(balance.capture_loss, losses, round_off(30, 1, losses)));
      EXPECT_EQ(losses > 1e-6, scheme == ContactScheme::end_of_step || threshold > 0.0);
    }
}

TEST(EnergyRecorder, SeesOverwrittenVelocity) {
  // As the paper states it: (1/2) v.M v falls by more or less than the impulse takes.
  const auto residual = [](ContactScheme scheme) {
    return std::abs(
        balance_of_the_pair(
            {.time_step = 0.003, .spectral_radius = 1.0, .velocity_threshold = 0.05, .scheme = scheme},
            [](const auto&...) {})
            .residual());
  };
  EXPECT_GT(residual(ContactScheme::paper), residual(ContactScheme::located));
}

TEST(EnergyRecorder, BooksNoImpulseOfASpring) {
  // The slider comes to rest while the mass still moves.
  solver::ContactSystem system = contact_system(oscillating_mass);
  system.tangential = data::TangentialContact({.tangential_stiffness = 400.0});
  StickSlipIntegrator oscillator(system, {.time_step = 1e-2, .spectral_radius = 1.0});
  oscillator.start_slipping(scalar(1.04), scalar(0.0));
  EnergyRecorder recorder(oscillator);
  keep(recorder, oscillator);
  while (oscillator.time() < 4.0) oscillator.step();
  ASSERT_TRUE(std::ranges::any_of(oscillator.events(), [](const ContactEvent& event) {
    return event.change == data::ContactChange::capture && event.residual_velocity != 0.0;
  }));
  EXPECT_EQ(recorder.balance().capture_loss, 0.0);
}

TEST(EnergyRecorder, RefusesNoEnergy) {
  const auto record = [](const solver::ContactSystem& system) {
    StickSlipIntegrator integrator(system, {.time_step = 0.01, .spectral_radius = 1.0});
    integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
    const EnergyRecorder recorder(integrator);
  };
  EXPECT_NO_THROW(record(contact_system(ForcedPair{})));
  for (const auto& [matrix, name] : {std::pair{&solver::ContactSystem::slip_stiffness, "slip_stiffness"},
                                     std::pair{&solver::ContactSystem::stick_stiffness, "stick_stiffness"}}) {
    solver::ContactSystem system = contact_system(ForcedPair{});
    (system.*matrix).coeffRef(0, 1) += 1.0;
    const std::string message = error_message_of<std::invalid_argument>([&] { record(system); });
    EXPECT_TRUE(message.starts_with(name)) << message;
  }
}

// --- The generalised-alpha weights, and the amplification that they imply

using solver::GeneralizedAlpha;
using solver::Kinematics;

STICKSLIP_VERIFIES(GeneralizedAlpha, "F5");
TEST(GeneralizedAlpha, RefusesOtherRadii) {
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

TEST(GeneralizedAlpha, AmplifiesAsPublished) {
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    for (const double omega : {0.1, 1.0, 7.0}) {
      const std::vector<double> computed = moduli(radius, omega);
      const std::vector<double> published = studies::amplification_moduli(radius, omega);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(within(computed[i], published[i], round_off(30, 100, 1.0))) << radius << " " << omega;
    }
}

}  // namespace
}  // namespace stickslip::testing
