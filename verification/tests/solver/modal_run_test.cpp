// SPDX-License-Identifier: MIT
/// The fast runs in the modes of the mesh against the plain ones: the same numbers, up to rounding.

#include <Eigen/Core>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/held_tip_basis.hpp"
#include "stickslip/solver/modal_stick_run.hpp"
#include "studies/common/convergence.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using solver::BeamModel;
using solver::BeamSimulation;
using solver::Coordinates;
using solver::HeldTipBasis;
using solver::InitialVelocity;
using solver::ModalStickRun;
using solver::TipContact;

data::NumericalSettings settings(int elements, double spectral_radius) {
  auto choices = paper_choices(1.0);
  choices.elements = elements;
  choices.spectral_radius = spectral_radius;
  return data::NumericalSettings(choices);
}

struct History {
  std::vector<double> force, displacement;
};

double largest(const std::vector<double>& values) {
  double maximum = 0.0;
  for (const double value : values) maximum = std::max(maximum, std::abs(value));
  return maximum;
}

// f and u(x) by the plain loop.
History plain_history(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                      const data::NumericalSettings& numerics, InitialVelocity initial_velocity, double x,
                      long steps) {
  BeamSimulation run(with(paper_problem(25.0, 1e-3), beam, excitation, numerics),
                     {.contact = TipContact::bonded, .initial_velocity = initial_velocity});
  History history;
  const auto note = [&] {
    history.force.push_back(run.friction_force());
    history.displacement.push_back(run.displacement(x) - run.base_displacement());
  };
  for (note(); run.integrator().steps() < steps; note()) run.step();
  return history;
}

// The plain loop rounds every degree of freedom at every step; a rounding of the deflections moves the force
// by 12 EI/l^3 of it, and the roundings of so many steps add up as a random walk, of three vectors.
Tolerance rounding_of_the_plain_loop(const data::Beam& beam, int elements, const History& history,
                                     long steps) {
  const double l = beam.length() / elements;
  const double stiffness = 12.0 * beam.youngs_modulus() * beam.second_moment_of_area() / (l * l * l);
  const double condition = 1.0 + stiffness * largest(history.displacement) / largest(history.force);
  return round_off(3.0 * std::sqrt(static_cast<double>(steps)), condition, largest(history.force));
}

STICKSLIP_VERIFIES(ModalStickRun, "F11");
TEST(ModalStickRun, ReproducesTheNodalForce) {
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    for (const auto velocity : {InitialVelocity::quasi_static, InitialVelocity::zero})
      for (const auto& [elements, axial_force] : {std::pair{20, 500.0}, {7, 75000.0}, {3, -2000.0}}) {
        constexpr long steps = 5000;
        const data::Beam beam = paper_beam_with_axial_force(axial_force);
        const auto excitation = shaking(35.0, 0.5e-3);
        const auto numerics = settings(elements, radius);
        const History plain = plain_history(beam, excitation, numerics, velocity, 1.0, steps);
        const auto force = ModalStickRun(beam, excitation, numerics, velocity).friction_force(steps);
        ASSERT_EQ(force.size(), plain.force.size());
        EXPECT_TRUE(within(studies::largest_difference(force, plain.force), 0.0,
                           rounding_of_the_plain_loop(beam, elements, plain, steps)))
            << "radius " << radius << ", " << elements << " elements, P = " << axial_force;
      }
}

TEST(ModalStickRun, ReproducesTheNodalDisplacement) {
  constexpr long steps = 300;
  const auto excitation = shaking(60.0, 0.5e-3);
  for (const double x : {0.0, 0.13, 1.0, 1.97, 2.0}) {
    const History plain =
        plain_history(paper_beam(), excitation, settings(20, 0.9), InitialVelocity::zero, x, steps);
    const auto displacement =
        ModalStickRun(paper_beam(), excitation, settings(20, 0.9), InitialVelocity::zero)
            .relative_displacement(x, steps);
    EXPECT_TRUE(within(studies::largest_difference(displacement, plain.displacement), 0.0,
                       round_off(steps, 10, 0.5e-3)))
        << x;
  }
}

TEST(ModalStickRun, MaximumIsThatOfItsHistory) {
  // Blocks of 64 steps, 64 blocks at a time: the ends around a whole one of each.
  const ModalStickRun run(paper_beam(), shaking(35.0, 0.5e-3), settings(6, 0.9));
  const auto whole = run.friction_force(9000);
  for (const long steps : {0L, 1L, 62L, 63L, 64L, 65L, 4094L, 4095L, 4096L, 4097L, 9000L}) {
    const std::vector<double> part(whole.begin(), whole.begin() + steps + 1);
    EXPECT_EQ(run.friction_force(steps), part) << steps;
    EXPECT_EQ(run.max_abs_friction_force(steps), largest(part)) << steps;
  }
}

TEST(ModalStickRun, RefusesABuckledBeam) {
  EXPECT_THROW(ModalStickRun(paper_beam_with_axial_force(90000.0), shaking(35.0, 1e-3), settings(4, 0.9)),
               data::InputError);
}

STICKSLIP_VERIFIES(HeldTipBasis, "F11");
TEST(HeldTipBasis, DiagonalisesTheStickState) {
  for (const int elements : {1, 2, 20}) {
    const BeamModel model(paper_beam(), elements);
    const HeldTipBasis basis = held_tip_basis(model);
    const Eigen::Index modes = 2 * elements - 1;
    ASSERT_EQ(basis.modes.cols(), modes);
    const Eigen::MatrixXd mass = basis.modes.transpose() * model.mass() * basis.modes;
    EXPECT_LE((mass - Eigen::MatrixXd::Identity(modes, modes)).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(basis.modes.row(model.tip_deflection()).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_EQ(basis.static_shape[model.tip_deflection()], 1.0);
    const Eigen::MatrixXd stiffness = basis.modes.transpose() * model.stick_stiffness() * basis.modes;
    const double highest = basis.squared_frequencies[modes - 1];
    EXPECT_LE((stiffness - Eigen::MatrixXd(basis.squared_frequencies.asDiagonal())).cwiseAbs().maxCoeff(),
              1e-10 * highest);
    EXPECT_LE(
        (basis.modes.transpose() * (model.stick_stiffness() * basis.static_shape)).cwiseAbs().maxCoeff(),
        1e-11 * std::sqrt(highest) * std::sqrt(modes) * elements);
  }
}

// The beam of the paper where it slips.
BeamSimulation slipping_run(const data::NumericalSettings& numerics, const solver::BeamRun& run = {},
                            const data::Damping& damping = {}) {
  return BeamSimulation(with(paper_problem(25.0, 1e-3), numerics, damping), run);
}

// The same changes of the contact, in time (s) and position (m) within the tolerances.
void expect_same_changes(const solver::StickSlipIntegrator& run, const solver::StickSlipIntegrator& expected,
                         double time_tolerance, double position_tolerance) {
  ASSERT_EQ(run.events().size(), expected.events().size());
  for (std::size_t i = 0; i < run.events().size(); ++i) {
    const data::ContactEvent &event = run.events()[i], &change = expected.events()[i];
    EXPECT_EQ(event.change, change.change) << i;
    EXPECT_NEAR(event.time, change.time, time_tolerance) << i;
    EXPECT_NEAR(event.position, change.position, position_tolerance) << i;
  }
}

STICKSLIP_VERIFIES(ModalSteps, "F11");
TEST(ModalSteps, HaveTheEventsOfTheNodalRun) {
  // Rounding, 1e-16 m at first, grows with every change; a quarter of a second has more than fifty.
  const data::NumericalSettings numerics(paper_choices(0.25));
  BeamSimulation nodal = slipping_run(numerics);
  BeamSimulation modal = slipping_run(numerics, {.coordinates = Coordinates::modal});
  double force_difference = 0.0, tip_difference = 0.0, midspan_difference = 0.0;
  for (int n = 0; n < 2500; ++n) {
    nodal.step();
    modal.step();
    force_difference =
        largest_or_nan({force_difference, std::abs(nodal.friction_force() - modal.friction_force())});
    tip_difference =
        largest_or_nan({tip_difference, std::abs(nodal.tip_displacement() - modal.tip_displacement())});
    midspan_difference = largest_or_nan(
        {midspan_difference, std::abs(nodal.midspan_displacement() - modal.midspan_displacement())});
    EXPECT_NEAR(nodal.displacement(1.3), modal.displacement(1.3), 1e-13);
  }
  ASSERT_GE(nodal.integrator().events().size(), 50u);
  expect_same_changes(modal.integrator(), nodal.integrator(), 1e-11, 1e-13);
  EXPECT_LE(force_difference, 1e-8 * 300.0);
  EXPECT_LE(tip_difference, 1e-13);
  EXPECT_LE(midspan_difference, 1e-13);
}

TEST(ModalSteps, StopWhereTheStateIsNotFinite) {
  for (const Coordinates coordinates : {Coordinates::nodal, Coordinates::modal}) {
    BeamSimulation run(with(paper_problem(1000.0, 1e303), settings(20, 0.9)),
                       {.contact = TipContact::bonded, .coordinates = coordinates});
    const std::string message = error_message_of<std::runtime_error>([&] {
      while (run.integrator().steps() < 100) run.step();
    });
    EXPECT_TRUE(holds(message, "no longer finite at t = 0."));
  }
}

TEST(ModalSteps, RefusesDampingAndSystemsOfAnotherForm) {
  for (const data::Damping& damping :
       {data::Damping({.kelvin_voigt = 1e-5}), data::Damping({.ratio = 0.01})}) {
    const std::string message = error_message_of<data::FieldError>(
        [&] { (void)slipping_run(settings(4, 0.9), {.coordinates = Coordinates::modal}, damping); });
    EXPECT_TRUE(message.starts_with(damping.ratio() > 0.0 ? "damping.ratio is 0.01"
                                                          : "damping.kelvin_voigt is 1e-05"))
        << message;
  }
  const BeamModel model(paper_beam(), 4);
  const auto nodal =
      beam_contact_system(model, paper_friction(), solver::harmonic_motion(shaking(25.0, 1e-3)));
  const solver::IntegratorSettings modal_steps{
      .time_step = 1e-4, .spectral_radius = 0.9, .algebra = solver::StepAlgebra::modal};
  EXPECT_THROW(solver::StickSlipIntegrator(nodal, modal_steps), std::invalid_argument);

  const solver::ContactSystem modal = solver::modal_contact_system(
      model, solver::held_tip_basis(model), paper_friction(), solver::harmonic_motion(shaking(25.0, 1e-3)));
  const auto refuses = [&](solver::SparseMatrix solver::ContactSystem::*matrix, Eigen::Index column) {
    solver::ContactSystem coupled = modal;
    (coupled.*matrix).coeffRef(0, column) = 1e-3;
    EXPECT_THROW(solver::StickSlipIntegrator(coupled, modal_steps), std::invalid_argument)
        << "column " << column;
  };
  refuses(&solver::ContactSystem::mass, 1);
  for (const auto stiffness :
       {&solver::ContactSystem::stick_stiffness, &solver::ContactSystem::slip_stiffness})
    for (const Eigen::Index column : {Eigen::Index{1}, modal.contact}) refuses(stiffness, column);
}

STICKSLIP_VERIFIES(FastestCoordinates, "F11");
TEST(FastestCoordinates, AreModalWhereTheyGiveTheNumbersOfTheNodalOnes) {
  using solver::ContactScheme;
  using solver::fastest_coordinates;
  EXPECT_EQ(fastest_coordinates(1, {}), Coordinates::modal);
  EXPECT_EQ(fastest_coordinates(200, {}, ContactScheme::end_of_step), Coordinates::modal);
  EXPECT_EQ(fastest_coordinates(201, {}), Coordinates::nodal);
  EXPECT_EQ(fastest_coordinates(20, data::Damping({.kelvin_voigt = 1e-5})), Coordinates::nodal);
  EXPECT_EQ(fastest_coordinates(20, data::Damping({.ratio = 0.01})), Coordinates::nodal);
  EXPECT_EQ(fastest_coordinates(20, {}, ContactScheme::paper), Coordinates::nodal);
}

TEST(FastestCoordinates, AreThoseOfARunThatAsksForThem) {
  // Bit for bit: a run by either name takes the same steps.
  const data::NumericalSettings numerics(paper_choices(0.05));
  const auto tip = [&](Coordinates coordinates, solver::ContactScheme scheme) {
    BeamSimulation run = slipping_run(numerics, {.scheme = scheme, .coordinates = coordinates});
    while (run.integrator().steps() < 500) run.step();
    return run.friction_force();
  };
  using solver::ContactScheme;
  EXPECT_EQ(tip(Coordinates::fastest, ContactScheme::located),
            tip(Coordinates::modal, ContactScheme::located));
  EXPECT_NE(tip(Coordinates::nodal, ContactScheme::located), tip(Coordinates::modal, ContactScheme::located));
  EXPECT_EQ(tip(Coordinates::fastest, ContactScheme::paper), tip(Coordinates::nodal, ContactScheme::paper));
  EXPECT_THROW(tip(Coordinates::modal, ContactScheme::paper), std::logic_error);
}

}  // namespace
}  // namespace stickslip::testing
