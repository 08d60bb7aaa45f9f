// SPDX-License-Identifier: MIT
/// The energy balance against exact works, and what changes of the contact do to the energy.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "support/beams.hpp"
#include "support/contact_models.hpp"
#include "support/error_message.hpp"
#include "support/mesh.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using data::ContactEvent;
using solver::ContactScheme;
using solver::EnergyRecorder;
using solver::IntegratorSettings;
using solver::StickSlipIntegrator;

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

struct Change {
  double energy_before{}, energy_after{};
  double sliding_velocity{}, wall_velocity{};  // before
  double contact_mass{};
  bool capture{};
};

double energy(const StickSlipIntegrator& now) {
  return 0.5 * now.velocity().dot(now.system().mass * now.velocity()) +
         0.5 * now.displacement().dot(now.system().stick_stiffness * now.displacement());
}

std::vector<Change> changes_of_the_pair(const IntegratorSettings& settings) {
  StickSlipIntegrator integrator(contact_system(ForcedPair{}), settings);
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  std::vector<Change> changes;
  double last_time = 0.0, last_energy = energy(integrator), last_sliding = 0.0;
  integrator.observe([&](const StickSlipIntegrator& now) {
    const double wall = now.system().wall.velocity(now.time());
    if (now.time() == last_time)
      changes.push_back({last_energy, energy(now), last_sliding, wall, now.contact_mass(),
                         now.events().back().change == data::ContactChange::capture});
    last_time = now.time();
    last_energy = energy(now);
    last_sliding = now.velocity()[1] - wall;
  });
  while (integrator.time() < 12.0) integrator.step();
  EXPECT_EQ(changes.size(), integrator.events().size());
  return changes;
}

STICKSLIP_VERIFIES(ContactChanges, "F8");
TEST(ContactChanges, NeverAddEnergyInTheFrameOfTheWall) {
  // In coordinates that the wall moves through, the impulse -m_c v_s of a capture also does the work
  // -m_c v_s w_t of the wall.
  for (const ContactScheme scheme : {ContactScheme::located, ContactScheme::end_of_step})
    for (const double threshold : {0.0, 0.05}) {
      const auto changes = changes_of_the_pair(
          {.time_step = 0.012, .spectral_radius = 0.9, .velocity_threshold = threshold, .scheme = scheme});
      EXPECT_GE(changes.size(), 20u);
      double largest_loss = 0.0;
      for (const Change& change : changes) {
        const double gain = change.energy_after - change.energy_before;
        if (!change.capture) {
          EXPECT_EQ(gain, 0.0);
          continue;
        }
        const double impulse = -change.contact_mass * change.sliding_velocity;
        const double loss = 0.5 * change.contact_mass * std::pow(change.sliding_velocity, 2);
        EXPECT_TRUE(within(gain, impulse * change.wall_velocity - loss,
                           round_off(20, 1, change.energy_before + change.energy_after)));
        largest_loss = std::max(largest_loss, loss);
      }
      const bool slides_at_capture = scheme == ContactScheme::end_of_step || threshold > 0.0;
      EXPECT_EQ(largest_loss > 1e-6, slides_at_capture);
    }
}

// Of 12 s of the pair.
solver::EnergyBalance balance_of_the_pair(const IntegratorSettings& settings) {
  StickSlipIntegrator integrator(contact_system(ForcedPair{}), settings);
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  EnergyRecorder recorder(integrator);
  keep(recorder, integrator);
  while (integrator.time() < 12.0) integrator.step();
  return recorder.balance();
}

TEST(ContactChanges, AreBookedAsCaptureLoss) {
  const IntegratorSettings settings{
      .time_step = 0.012, .spectral_radius = 0.9, .scheme = ContactScheme::end_of_step};
  double expected = 0.0;
  for (const Change& change : changes_of_the_pair(settings))
    if (change.capture) expected += 0.5 * change.contact_mass * std::pow(change.sliding_velocity, 2);
  EXPECT_GT(expected, 1e-6);
  EXPECT_TRUE(within(balance_of_the_pair(settings).capture_loss, expected, round_off(30, 1, expected)));
}

TEST(EnergyRecorder, OverwrittenVelocityLeavesAResidual) {
  // As the paper states it: (1/2) v.M v falls by more or less than the impulse takes.
  const auto residual = [](ContactScheme scheme) {
    return std::abs(
        balance_of_the_pair(
            {.time_step = 0.003, .spectral_radius = 1.0, .velocity_threshold = 0.05, .scheme = scheme})
            .residual());
  };
  EXPECT_GT(residual(ContactScheme::paper), 100.0 * residual(ContactScheme::located));
}

TEST(EnergyRecorder, BooksNoImpulseOfAContactOnASpring) {
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

TEST(EnergyRecorder, BeamEnergyIsElasticPlusGeometric) {
  const data::NumericalSettings numerics(paper_choices(0.06));
  solver::BeamSimulation simulation(paper_beam(), paper_friction(), data::HarmonicExcitation({25.0, 1e-3}),
                                    numerics);
  EnergyRecorder recorder(simulation.integrator());
  simulation.observe([&recorder](const StickSlipIntegrator& now) { recorder.record(now); });
  while (simulation.time() < 0.06) simulation.step();
  const auto& q = simulation.integrator().displacement();
  const double elastic = elastic_energy(simulation.model(), q);
  const double geometric = geometric_energy(simulation.model(), q);
  EXPECT_GT(elastic, 0.1);
  EXPECT_LT(geometric, 0.0);
  // The sums cancel from 12 EI/l^3 u^2 = 2e8 N/m (3 mm)^2 for an element to about 1 J for the beam.
  EXPECT_TRUE(within(elastic + geometric, recorder.balance().elastic, round_off(10, 2e3, 1.0)));
}

TEST(EnergyRecorder, RefusesASystemThatHasNoEnergyToBalance) {
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

}  // namespace
}  // namespace stickslip::testing
