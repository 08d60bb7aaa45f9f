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
#include "studies/stick_slip/finite_element_contact_model.hpp"
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

/// Rounding of the modes grows with the square of the highest frequency over the lowest.
double spread(const ContactModel& model) {
  return std::pow(model.angular_frequency.back() / model.angular_frequency.front(), 2);
}

// The adapter.

STICKSLIP_VERIFIES(FiniteElementContactModel, "X9");
TEST(FiniteElementContactModel, HasTheFrequenciesOfTheMeshInStickAndInSlip) {
  const MeshedBeam beam(10, 25.0);
  const ContactModel model = beam.reduced().model();
  ASSERT_EQ(model.modes(), 19u);
  const auto stick = solver::stick_modes(beam.mesh, 5);
  const auto slip = solver::slip_modes(beam.mesh, 5);
  const auto free = free_contact_frequencies(model, 5);
  for (std::size_t n = 0; n < 5; ++n) {
    EXPECT_TRUE(within(model.angular_frequency[n], stick[n].angular_frequency,
                       round_off(20, 100, stick[n].angular_frequency)));
    EXPECT_TRUE(
        within(free[n], slip[n].angular_frequency, round_off(20, spread(model), slip[n].angular_frequency)));
  }
}

TEST(FiniteElementContactModel, HoldsTheContactWithTheForceOfTheTimeStepper) {
  const MeshedBeam beam(10, 25.0);
  const FiniteElementContactModel reduced = beam.reduced();
  const ContactModel& model = reduced.model();
  const Eigen::Index c = beam.system.contact;
  solver::StickSlipIntegrator integrator(beam.system, {.time_step = 1e-4, .spectral_radius = 0.9});
  EventDriven run(model);
  std::srand(20);
  for (int sample = 0; sample < 20; ++sample) {
    const Eigen::VectorXd q = 1e-3 * Eigen::VectorXd::Random(20), v = Eigen::VectorXd::Random(20);
    integrator.start_slipping(q, v);
    run.start_slipping(reduced.amplitudes(q), reduced.amplitudes(v), q[c],
                       v[c] - beam.system.wall.velocity(0.0));
    double scale = 0.0;
    for (std::size_t n = 0; n < model.modes(); ++n)
      scale += std::abs(model.mass_coupling[n] * std::pow(model.angular_frequency[n], 2) *
                        reduced.amplitudes(q)[n]);
    EXPECT_TRUE(
        within(run.holding_force(), integrator.holding_force(), round_off(20, spread(model), 2.0 * scale)));
    const Eigen::VectorXd back = reduced.full(run.amplitudes(), run.contact_displacement());
    EXPECT_LT((back - q).cwiseAbs().maxCoeff(), round_off(20, spread(model), 1e-3).value);
  }
}

TEST(FiniteElementContactModel, BalancesTheRowOfTheContactInEveryStickPhase) {
  // The mesh's own equations at states of the event-driven run: held accelerations from the other rows, and
  // then the friction force from that of the contact. Forces of up to 300 N out of terms K q of 1e5 N.
  const MeshedBeam beam(10, 25.0);
  const FiniteElementContactModel reduced = beam.reduced();
  const Eigen::MatrixXd mass(beam.system.mass), damping(beam.system.damping);
  const Eigen::MatrixXd stiffness(beam.system.slip_stiffness);
  const Eigen::Index c = beam.system.contact;
  EventDriven run(reduced.model());
  int stuck = 0;
  for (int k = 1; k <= 90; ++k) {
    run.advance_to(1e-3 * k);
    const double t = run.time();
    const Eigen::VectorXd q = reduced.full(run.amplitudes(), run.contact_displacement());
    const Eigen::VectorXd v = reduced.full(run.rates(), run.contact_velocity());
    const double held = beam.system.wall.acceleration(t);
    Eigen::VectorXd rest = beam.system.load_history(t) * beam.system.load_shape - damping * v -
                           stiffness * q - held * mass.col(c);
    Eigen::MatrixXd constrained = mass;
    constrained.row(c).setZero();
    constrained.col(c).setZero();
    constrained(c, c) = 1.0;
    Eigen::VectorXd acceleration = rest;
    acceleration[c] = 0.0;
    acceleration = constrained.llt().solve(acceleration).eval();
    const double force = mass.row(c).dot(acceleration) - rest[c];
    ASSERT_TRUE(within(run.holding_force(), force, round_off(20, 100, 1e5))) << t;
    stuck += run.state() == data::ContactState::stick ? 1 : 0;
  }
  EXPECT_GT(stuck, 50);
  EXPECT_LT(stuck, 85);
}

TEST(FiniteElementContactModel, IsTheHandReductionOfTwoMassesAndOfOne) {
  const ForcedPair pair;
  const studies::HarmonicDrive drive{
      .load_amplitude = 1.0, .angular_frequency = pair.omega, .wall_amplitude = pair.wall_amplitude};
  ContactModel reduced = FiniteElementContactModel(contact_system(pair), drive).model();
  const ContactModel by_hand = contact_model(pair);
  // The sign of a mode is anyone's choice.
  const double sign = reduced.mass_coupling[0] * by_hand.mass_coupling[0] < 0.0 ? -1.0 : 1.0;
  const auto same = [](double computed, double expected) {
    return within(computed, expected, round_off(10, 10, 20.0));
  };
  EXPECT_TRUE(same(reduced.angular_frequency[0], by_hand.angular_frequency[0]));
  EXPECT_TRUE(same(sign * reduced.mass_coupling[0], by_hand.mass_coupling[0]));
  EXPECT_TRUE(same(reduced.contact_mass, by_hand.contact_mass));
  EXPECT_TRUE(same(reduced.contact_stiffness, by_hand.contact_stiffness));
  EXPECT_TRUE(same(sign * reduced.follower[0], by_hand.follower[0]));
  EXPECT_TRUE(same(reduced.contact_follower, by_hand.contact_follower));
  EXPECT_TRUE(same(sign * reduced.load[0], by_hand.load[0]));
  EXPECT_TRUE(same(reduced.load[1], by_hand.load[1]));
  EXPECT_TRUE(same(reduced.damping(0, 0), by_hand.damping(0, 0)));
  EXPECT_TRUE(same(sign * reduced.damping(0, 1), by_hand.damping(0, 1)));
  EXPECT_TRUE(same(sign * reduced.damping(1, 0), by_hand.damping(1, 0)));
  EXPECT_TRUE(same(reduced.damping(1, 1), by_hand.damping(1, 1)));
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

struct Event {
  int change{};  // both enumerations list onset, capture, reversal, graze
  double time{}, position{};
};
using Events = std::vector<Event>;

constexpr double tenth_of_a_second = 0.1;

Events event_driven(const ContactModel& model) {
  EventDriven run(model);
  run.advance_to(tenth_of_a_second);
  Events events;
  for (const auto& event : run.events())
    events.push_back({static_cast<int>(event.change), event.time, event.position});
  return events;
}

Events stepped(solver::StickSlipIntegrator& run, const Eigen::VectorXd& velocity, double time_step) {
  run.start_stuck(Eigen::VectorXd::Zero(velocity.size()), velocity);
  while (run.steps() < std::lround(tenth_of_a_second / time_step)) run.step();
  Events events;
  for (const auto& event : run.events())
    events.push_back({static_cast<int>(event.change), event.time, event.position});
  return events;
}

Events stepped(const MeshedBeam& beam, double time_step, double spectral_radius) {
  solver::StickSlipIntegrator run(beam.system, {.time_step = time_step, .spectral_radius = spectral_radius});
  return stepped(run, beam.initial_velocity(), time_step);
}

Events stepped_in_modes(const MeshedBeam& beam, double time_step, double spectral_radius) {
  const solver::HeldTipBasis basis = held_tip_basis(beam.mesh);
  solver::StickSlipIntegrator run(
      modal_contact_system(beam.mesh, basis, paper_friction(), beam.base),
      {.time_step = time_step, .spectral_radius = spectral_radius, .algebra = solver::StepAlgebra::modal});
  return stepped(run, modal_coordinates(beam.mesh, basis, beam.initial_velocity()), time_step);
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

/// Histories in steps from 4e-5 s to 5e-6 s, each half of the one before.
struct Refinement {
  std::vector<Events> histories;
  std::vector<double> times;  ///< largest difference from the exact history, s
};

// history(h) converges to the exact one with order two. An exact history from event to event keeps its tolerance,
// 1e-12 of the state a step.
template <class History, class NextTerm>
Refinement expect_order_two(const History& history, const Events& exact, const NextTerm& next_term) {
  const std::vector<double> steps{4e-5, 2e-5, 1e-5, 5e-6};
  Refinement refinement;
  std::vector<double> positions;
  for (const double h : steps) {
    refinement.histories.push_back(history(h));
    const Difference error = difference(refinement.histories.back(), exact);
    EXPECT_TRUE(std::isfinite(error.time)) << h;
    refinement.times.push_back(error.time);
    positions.push_back(error.position);
  }
  EXPECT_TRUE(order_is(order_levels(steps, refinement.times, next_term, 1e-12), 2.0));
  EXPECT_TRUE(order_is(order_levels(steps, positions, next_term, 1e-12), 2.0));
  return refinement;
}

class TimeStepper : public ::testing::TestWithParam<std::tuple<double, double>> {};

STICKSLIP_VERIFIES(TimeStepper, "X9");
TEST_P(TimeStepper, ConvergesToItsEventDrivenHistory) {
  const double hz = std::get<0>(GetParam()), spectral_radius = std::get<1>(GetParam());
  const MeshedBeam beam(10, hz);
  const Events exact = event_driven(beam.reduced().model());
  ASSERT_EQ(exact.size(), hz < 50.0 ? 5u : 23u);
  const Refinement refinement = expect_order_two([&](double h) { return stepped(beam, h, spectral_radius); },
                                                 exact, next_term_of_the_damped_beam);
  ASSERT_FALSE(HasFailure());
  const Events &coarse = refinement.histories[2], &fine = refinement.histories[3];
  // Richardson: the error of the finer of two levels is a third of their difference.
  const Difference between = difference(fine, coarse);
  EXPECT_TRUE(within(refinement.times[3], between.time / 3.0,
                     discretisation(between.time / 3.0, 0.05, "a third of the difference of two levels")));
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_TRUE(within(fine[i].time, exact[i].time,
                       discretisation(between.time / 3.0, 1.05, "a third of the difference")));
    EXPECT_TRUE(within(fine[i].position, exact[i].position,
                       discretisation(between.position / 3.0, 1.05, "a third of the difference")));
    // And what extrapolation leaves is of another order.
    const double extrapolated = fine[i].time + (fine[i].time - coarse[i].time) / 3.0;
    EXPECT_TRUE(within(extrapolated, exact[i].time,
                       discretisation(between.time / 3.0, 0.05, "the next term, 5 % of the first")));
  }
}

INSTANTIATE_TEST_SUITE_P(Beam, TimeStepper,
                         ::testing::Combine(::testing::Values(25.0, 70.0), ::testing::Values(0.9, 1.0)),
                         [](const auto& instance) {
                           return parameter_name(std::get<0>(instance.param)) + "Hz_radius" +
                                  parameter_name(std::get<1>(instance.param));
                         });

STICKSLIP_VERIFIES(ModalSteps, "F11");
TEST(ModalSteps, ConvergeToTheEventDrivenHistory) {
  // Undamped, and on three elements, so that the steps resolve every mode. The next terms: omega h of mode 2,
  // as each change splits a step anywhere, and (omega h)^2 of the highest.
  const MeshedBeam beam(3, 25.0, data::Damping());
  const ContactModel model = beam.reduced().model();
  const auto next_term = [&model](double h) {
    return model.angular_frequency[1] * h + std::pow(model.angular_frequency.back() * h, 2);
  };
  const Events exact = event_driven(model);
  ASSERT_EQ(exact.size(), 9u);
  for (const double spectral_radius : {0.9, 1.0}) {
    SCOPED_TRACE(spectral_radius);
    expect_order_two([&](double h) { return stepped_in_modes(beam, h, spectral_radius); }, exact, next_term);
  }
}

class MeshedHistory : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(MeshedHistory, "X9");
TEST_P(MeshedHistory, ErrorFallsWithTheFourthPowerOfTheElement) {
  // Cubic elements: frequencies, the deflection of the tip and the friction force from the residual of its
  // row all err as l^4, and event times are smooth functions of them; the next term is (beta l)^2/10 or so
  // for mode 4, beta L = 13.35. Three meshes that cost little are no order (EventDrivenBeamFiner has the
  // finer ones). 20 modes stand for the beam, off by 1e-7 s.
  const Events exact = without_mesh(GetParam(), 20);
  const auto next_term = [](int elements) { return std::pow(13.35 / elements, 2) / 10.0; };
  double coarser = 0.0;
  for (const int elements : {7, 10, 14}) {
    const Difference error =
        difference(event_driven(MeshedBeam(elements, GetParam()).reduced().model()), exact);
    ASSERT_TRUE(std::isfinite(error.time)) << elements;
    // In units of the leading term on 10 elements.
    const double scaled = error.time * std::pow(elements / 10.0, 4);
    if (coarser > 0.0) {
      EXPECT_TRUE(within(scaled / coarser, 1.0,
                         discretisation(next_term(elements) + next_term(elements == 10 ? 7 : 10), 1.0,
                                        "(beta l)^2/10 of mode 4 on both meshes")));
    }
    coarser = scaled;
  }
}

INSTANTIATE_TEST_SUITE_P(Beam, MeshedHistory, ::testing::Values(25.0, 70.0),
                         [](const auto& instance) { return parameter_name(instance.param) + "Hz"; });

STICKSLIP_VERIFIES(EventDrivenAndStepped, "X9");
TEST(EventDrivenAndStepped, KeepTheSameEnergyBalanceThroughOnsetsAndCaptures) {
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
