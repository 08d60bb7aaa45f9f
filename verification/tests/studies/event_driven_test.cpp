// SPDX-License-Identifier: MIT
/// The time stepper against the event-driven engine: on the very same semi-discrete system, where only the
/// time step is left between them, and against the beam without a mesh.

#include "stickslip/analytic/event_driven.hpp"

#include <Eigen/Dense>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "stickslip/solver/held_tip_basis.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/verification/finite_element_contact_model.hpp"
#include "support/beams.hpp"
#include "support/contact_models.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::ContactModel;
using analytic::EventDriven;
using std::numbers::pi;
using studies::FiniteElementContactModel;

data::HarmonicExcitation shaking(double hz) {
  return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1e-3});
}

/// The beam on a mesh, damped or not.
struct MeshedBeam {
  solver::BeamModel mesh;
  data::HarmonicExcitation excitation;
  solver::PrescribedMotion base = solver::harmonic_motion(excitation);
  solver::ContactSystem system;

  MeshedBeam(int elements, double hz, const data::Damping& damping = light_damping())
      : mesh(paper_beam(), elements),
        excitation(shaking(hz)),
        system(solver::beam_contact_system(mesh, paper_friction(), base, damping)) {}

  /// The base's velocity at the start, with the static shape of the tip.
  [[nodiscard]] Eigen::VectorXd initial_velocity() const {
    return -base.velocity(0.0) * mesh.unit_tip_deflection();
  }

  [[nodiscard]] FiniteElementContactModel reduced() const {
    return {system, studies::harmonic_drive(excitation)};
  }
};

// The adapter.

STICKSLIP_VERIFIES(FiniteElementContactModel, "X9");
TEST(FiniteElementContactModel, IsTheHandReductionOfTwoMassesAndOfOne) {
  const ForcedPair pair;
  const studies::HarmonicDrive drive{
      .load_amplitude = 1.0, .angular_frequency = pair.omega, .wall_amplitude = pair.wall_amplitude};
  ContactModel reduced = FiniteElementContactModel(contact_system(pair), drive).model();
  const ContactModel by_hand = contact_model(pair);
  // The sign of a mode is anyone's choice.
  const double sign = reduced.mass_coupling[0] * by_hand.mass_coupling[0] < 0.0 ? -1.0 : 1.0;
  for (const auto& [computed, expected] :
       {std::pair{reduced.angular_frequency[0], by_hand.angular_frequency[0]},
        {sign * reduced.mass_coupling[0], by_hand.mass_coupling[0]},
        {reduced.contact_mass, by_hand.contact_mass},
        {reduced.contact_stiffness, by_hand.contact_stiffness},
        {sign * reduced.follower[0], by_hand.follower[0]},
        {reduced.contact_follower, by_hand.contact_follower},
        {sign * reduced.load[0], by_hand.load[0]},
        {reduced.load[1], by_hand.load[1]},
        {reduced.damping(0, 0), by_hand.damping(0, 0)},
        {sign * reduced.damping(0, 1), by_hand.damping(0, 1)},
        {sign * reduced.damping(1, 0), by_hand.damping(1, 0)},
        {reduced.damping(1, 1), by_hand.damping(1, 1)}})
    EXPECT_TRUE(within(computed, expected, round_off(10, 10, 20.0)));
  EXPECT_EQ(reduced.wall_amplitude, by_hand.wall_amplitude);
  EXPECT_EQ(reduced.normal_force, by_hand.normal_force);

  const FiniteElementContactModel one(contact_system({.mass = 2.0, .stiffness = 3.0, .normal_force = 1.0}),
                                      {.angular_frequency = 1.0});
  EXPECT_EQ(one.model().modes(), 0u);
  EXPECT_EQ(one.model().contact_mass, 2.0);
  EXPECT_EQ(one.model().contact_stiffness, 3.0);
  EXPECT_EQ(one.full(one.amplitudes(scalar(0.7)), 0.7), scalar(0.7));
}

TEST(FiniteElementContactModel, RefusesWhatHasNoHeldModes) {
  const studies::HarmonicDrive drive{.angular_frequency = 1.0};
  const auto reduce = [&](const ForcedPair& pair) { FiniteElementContactModel(contact_system(pair), drive); };
  ForcedPair pair;
  EXPECT_NO_THROW(reduce(pair));
  pair.slip_stiffness(0, 0) += 1.0;
  EXPECT_THROW(reduce(pair), std::invalid_argument);
  pair = {};
  pair.stick_stiffness(0, 0) = pair.slip_stiffness(0, 0) = -1.0;
  EXPECT_THROW(reduce(pair), std::invalid_argument);
  pair = {};
  pair.mass(0, 0) = -1.0;
  EXPECT_THROW(reduce(pair), std::invalid_argument);
  EXPECT_THROW(FiniteElementContactModel(contact_system(ForcedPair{}), {}), std::invalid_argument);
}

// Histories.

using Events = std::vector<data::ContactEvent>;

constexpr double tenth_of_a_second = 0.1;

Events event_driven(const ContactModel& model) {
  EventDriven run(model);
  run.advance_to(tenth_of_a_second);
  return run.events();
}

Events stepped_in_modes(const MeshedBeam& beam, double time_step, double spectral_radius) {
  const solver::HeldTipBasis basis = held_tip_basis(beam.mesh);
  solver::StickSlipIntegrator run(
      modal_contact_system(beam.mesh, basis, paper_friction(), beam.base),
      {.time_step = time_step, .spectral_radius = spectral_radius, .algebra = solver::StepAlgebra::modal});
  const Eigen::VectorXd velocity = modal_coordinates(beam.mesh, basis, beam.initial_velocity());
  run.start_stuck(Eigen::VectorXd::Zero(velocity.size()), velocity);
  while (run.steps() < std::lround(tenth_of_a_second / time_step)) run.step();
  return run.events();
}

Events without_mesh(double hz, int modes) {
  return event_driven(
      analytic::BeamContactModel(paper_beam(), paper_friction(), shaking(hz), light_damping(), modes)
          .model());
}

/// Largest differences; infinite unless the same changes happen in the same order.
struct Difference {
  double time{}, position{};
};
Difference difference(const Events& a, const Events& b) {
  if (a.size() != b.size()) return {HUGE_VAL, HUGE_VAL};
  Difference largest;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].change != b[i].change) return {HUGE_VAL, HUGE_VAL};
    largest.time = largest_or_nan({largest.time, std::abs(a[i].time - b[i].time)});
    largest.position = largest_or_nan({largest.position, std::abs(a[i].position - b[i].position)});
  }
  return largest;
}

STICKSLIP_VERIFIES(ModalSteps, "F11");
// Undamped, and on three elements, so that the steps resolve every mode. The next terms: omega h of mode 2, as each change splits
// a step anywhere, and (omega h)^2 of the highest. The exact history keeps its tolerance, 1e-12 of the state a step.
TEST(ModalSteps, ConvergeToTheEventDrivenHistory) {
  const MeshedBeam beam(3, 25.0, data::Damping());
  const ContactModel model = beam.reduced().model();
  const auto next_term = [&model](double h) {
    return model.angular_frequency[1] * h + std::pow(model.angular_frequency.back() * h, 2);
  };
  const Events exact = event_driven(model);
  ASSERT_EQ(exact.size(), 9u);
  const std::vector<double> steps{4e-5, 2e-5, 1e-5, 5e-6};
  for (const double spectral_radius : {0.9, 1.0}) {
    std::vector<double> times, positions;
    for (const double h : steps) {
      const Difference error = difference(stepped_in_modes(beam, h, spectral_radius), exact);
      EXPECT_TRUE(std::isfinite(error.time)) << h;
      times.push_back(error.time);
      positions.push_back(error.position);
    }
    EXPECT_TRUE(order_is(order_levels(steps, times, next_term, 1e-12), 2.0)) << spectral_radius;
    EXPECT_TRUE(order_is(order_levels(steps, positions, next_term, 1e-12), 2.0)) << spectral_radius;
  }
}

STICKSLIP_VERIFIES(EventDrivenAndStepped, "X9");
TEST(EventDrivenAndStepped, HaveTheSameEnergyBalance) {
  // The same mesh, so that the step alone is between them: of second order.
  const MeshedBeam beam(6, 25.0);
  const double end = 0.08;
  const auto stepped = [&](double time_step) {
    solver::StickSlipIntegrator run(beam.system, {.time_step = time_step, .spectral_radius = 0.9});
    run.start_stuck(Eigen::VectorXd::Zero(beam.mesh.degrees_of_freedom()), beam.initial_velocity());
    solver::EnergyRecorder recorder(run);
    run.observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
    while (run.steps() < std::lround(end / time_step)) run.step();
    EXPECT_GE(run.events().size(), 3u);
    return recorder.balance();
  };
  const FiniteElementContactModel reduced = beam.reduced();
  EventDriven run(reduced.model(), {.keep_energy_balance = true});
  run.start_stuck({}, reduced.amplitudes(beam.initial_velocity()));
  run.advance_to(end);
  const analytic::EventDrivenEnergy exact = run.energy_balance();
  const auto coarse = stepped(4e-5), fine = stepped(2e-5);
  // The mean of where in a step the changes fall scatters the leading term by as much again.
  const auto same = [](double fine_entry, double coarse_entry, double entry) {
    return within(fine_entry, entry,
                  discretisation(std::abs(coarse_entry - fine_entry) / 3.0, 3.0, "Richardson"));
  };
  EXPECT_TRUE(same(fine.kinetic, coarse.kinetic, exact.kinetic));
  EXPECT_TRUE(same(fine.elastic, coarse.elastic, exact.potential));
  EXPECT_TRUE(same(fine.base_work, coarse.base_work, exact.base_work));
  EXPECT_TRUE(same(fine.follower_work, coarse.follower_work, exact.follower_work));
  EXPECT_TRUE(same(fine.damping_loss, coarse.damping_loss, exact.damping_loss));
  EXPECT_TRUE(same(fine.friction_loss + fine.capture_loss, coarse.friction_loss + coarse.capture_loss,
                   exact.friction_loss));
}

class TruncatedHistory : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(TruncatedHistory, "D2");
TEST_P(TruncatedHistory, ConvergesAtLeastWithTheThirdOrder) {
  const Events exact = without_mesh(GetParam(), 32);
  std::vector<double> inverse, errors;
  for (const int modes : {6, 8, 11, 15}) {
    const Difference error = difference(without_mesh(GetParam(), modes), exact);
    ASSERT_TRUE(std::isfinite(error.time)) << modes;
    inverse.push_back(1.0 / modes);
    errors.push_back(error.time);
  }
  EXPECT_GT(observed_order(inverse, errors), 2.8);
}

INSTANTIATE_TEST_SUITE_P(Beam, TruncatedHistory, ::testing::Values(25.0, 70.0),
                         [](const auto& instance) { return parameter_name(instance.param) + "Hz"; });

}  // namespace
}  // namespace stickslip::testing
