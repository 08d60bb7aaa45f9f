// SPDX-License-Identifier: MIT
/// The fast runs in the modes of the mesh against the plain ones: the same numbers, up to rounding.

#include <Eigen/Core>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/held_tip_basis.hpp"
#include "stickslip/solver/modal_stick_run.hpp"
#include "studies/common/convergence.hpp"
#include "studies/history/history.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using solver::BeamModel;
using solver::BeamSimulation;
using solver::Coordinates;
using solver::ModalStickRun;

data::NumericalSettings settings(int elements, double spectral_radius) {
  auto choices = paper_choices(1.0);
  choices.elements = elements;
  choices.spectral_radius = spectral_radius;
  return data::NumericalSettings(choices);
}

struct History {
  std::vector<double> force, displacement;
};

// f and u(L/2) by the plain loop.
History plain_history(const data::Case& problem, bool starts_with_the_base, long steps) {
  BeamSimulation run(
      problem,
      {.is_bonded = true, .starts_with_the_base = starts_with_the_base, .coordinates = Coordinates::nodal});
  History history;
  const auto note = [&] {
    history.force.push_back(run.friction_force());
    history.displacement.push_back(run.displacement(0.49 * problem.beam().length()) -
                                   run.base_displacement());
  };
  for (note(); run.integrator().steps() < steps; note()) run.integrator().step();
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
TEST(ModalStickRun, ReproducesTheNodalHistory) {
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    for (const bool with_the_base : {false, true})
      for (const auto& [elements, axial_force] : {std::pair{20, 500.0}, {7, 75000.0}, {3, -2000.0}}) {
        SCOPED_TRACE(fmt::format("radius {}, {} elements, P = {}", radius, elements, axial_force));
        constexpr long steps = 2000;
        const data::Beam beam = paper_beam_with_axial_force(axial_force);
        const data::Case problem = with(paper_problem(35.0, 0.5e-3), beam, settings(elements, radius));
        const History plain = plain_history(problem, with_the_base, steps);
        const ModalStickRun run(problem, {.starts_with_the_base = with_the_base});
        const auto force = run.friction_force(steps);
        ASSERT_EQ(force.size(), plain.force.size());
        EXPECT_TRUE(within(studies::largest_difference(force, plain.force), 0.0,
                           rounding_of_the_plain_loop(beam, elements, plain, steps)));
        EXPECT_TRUE(within(studies::largest_difference(run.relative_displacement(0.49 * beam.length(), steps),
                                                       plain.displacement),
                           0.0, round_off(steps, 10, largest(plain.displacement))));
      }
}

TEST(ModalStickRun, MaximumIsThatOfItsHistory) {
  // Blocks of 64 steps, 64 blocks at a time: the ends around a whole one of each.
  const ModalStickRun run(with(paper_problem(35.0, 0.5e-3), settings(6, 0.9)));
  const auto whole = run.friction_force(9000);
  for (const long steps : {0L, 1L, 62L, 63L, 64L, 65L, 4094L, 4095L, 4096L, 4097L, 9000L}) {
    const std::vector<double> part(whole.begin(), whole.begin() + steps + 1);
    EXPECT_EQ(run.friction_force(steps), part) << steps;
    EXPECT_EQ(run.max_abs_friction_force(steps), largest(part)) << steps;
  }
}

TEST(ModalStickRun, RefusesABuckledBeam) {
  EXPECT_THROW(
      ModalStickRun(with(paper_problem(35.0, 1e-3), paper_beam_with_axial_force(90000.0), settings(4, 0.9))),
      data::InputError);
}

// The beam of the paper where it slips.
BeamSimulation slipping_run(const data::NumericalSettings& numerics, const solver::RunOptions& options = {},
                            const data::Damping& damping = {}) {
  return BeamSimulation(with(paper_problem(25.0, 1e-3), numerics, damping), options);
}

struct SlipRun {
  std::vector<data::ContactEvent> events;
  std::vector<double> force, tip, midspan, elsewhere;
};

SlipRun run_of(const data::NumericalSettings& numerics, const data::Damping& damping, Coordinates coordinates,
               double amplitude = 1e-3) {
  BeamSimulation run(with(paper_problem(25.0, amplitude), numerics, damping), {.coordinates = coordinates});
  SlipRun result;
  for (long n = solver::step_count(numerics.duration(), numerics.time_step()); n > 0; --n) {
    run.integrator().step();
    result.force.push_back(run.friction_force());
    result.tip.push_back(run.tip_displacement());
    result.midspan.push_back(run.midspan_displacement());
    result.elsewhere.push_back(run.displacement(1.3));
  }
  result.events = run.integrator().events();
  return result;
}

STICKSLIP_VERIFIES(ModalSteps, "F11");
// Rounding, 1e-16 of the motion in each of 2500 steps, grows with every change of contact as any disturbance does: it moves less than
// 1e-12 of the amplitude does. Damping holds disturbances of the motion back but not rounding: there it is 1e-11, an empirical number.
TEST(ModalSteps, HaveTheHistoryOfTheNodalRun) {
  const data::NumericalSettings numerics(paper_choices(0.25));
  for (const data::Damping& damping :
       {data::Damping(), data::Damping({.kelvin_voigt = 1e-4}), data::Damping({.ratio = 0.02}),
        data::Damping({.mass_proportional = 1.0}),
        data::Damping({.kelvin_voigt = 2e-5, .ratio = 0.01, .mass_proportional = 0.5})}) {
    SCOPED_TRACE(fmt::format("eta {}, zeta {}, c {}", damping.kelvin_voigt(), damping.ratio(),
                             damping.mass_proportional()));
    const SlipRun nodal = run_of(numerics, damping, Coordinates::nodal),
                  modal = run_of(numerics, damping, Coordinates::modal),
                  disturbed = run_of(numerics, damping, Coordinates::nodal,
                                     1e-3 * (1.0 + (damping.is_none() ? 1e-12 : 1e-11)));
    ASSERT_GE(nodal.events.size(), 20u);
    const auto apart = studies::largest_difference(modal.events, nodal.events, nodal.events.size()),
               allowed = studies::largest_difference(disturbed.events, nodal.events, nodal.events.size());
    EXPECT_EQ(modal.events.size(), nodal.events.size());
    EXPECT_LE(apart.time, allowed.time);
    EXPECT_LE(apart.position, allowed.position);
    for (const auto values : {&SlipRun::force, &SlipRun::tip, &SlipRun::midspan, &SlipRun::elsewhere})
      EXPECT_LE(studies::largest_difference(modal.*values, nodal.*values),
                studies::largest_difference(disturbed.*values, nodal.*values));
  }
}

TEST(ModalSteps, StopWhereTheStateIsNotFinite) {
  for (const Coordinates coordinates : {Coordinates::nodal, Coordinates::modal}) {
    BeamSimulation run(with(paper_problem(1000.0, 1e303), settings(20, 0.9)),
                       {.is_bonded = true, .coordinates = coordinates});
    const std::string message = error_message_of<std::runtime_error>([&] {
      while (run.integrator().steps() < 100) run.integrator().step();
    });
    EXPECT_TRUE(holds(message, "no longer finite at t = 0."));
  }
}

TEST(ModalSteps, RefuseCoupling) {
  const BeamModel model(paper_beam(), 4);
  const auto nodal = beam_contact_system(model, paper_problem(25.0, 1e-3));
  const solver::IntegratorSettings modal_steps{
      .time_step = 1e-4, .spectral_radius = 0.9, .coordinates = Coordinates::modal};
  EXPECT_THROW(solver::StickSlipIntegrator(nodal, modal_steps), std::invalid_argument);

  const solver::ContactSystem modal =
      solver::modal_contact_system(model, solver::held_tip_basis(model), nodal);
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
TEST(FastestCoordinates, AreModalOnSmallMeshes) {
  using solver::ContactScheme;
  const auto are_modal = [](int elements, const data::Damping& damping, ContactScheme scheme) {
    return solver::fastest_coordinates(elements, damping, scheme) == Coordinates::modal;
  };
  EXPECT_TRUE(are_modal(1, {}, ContactScheme::located));
  EXPECT_TRUE(are_modal(200, {}, ContactScheme::end_of_step));
  EXPECT_FALSE(are_modal(201, {}, ContactScheme::located));
  EXPECT_TRUE(are_modal(100, data::Damping({.kelvin_voigt = 1e-5}), ContactScheme::located));
  EXPECT_FALSE(are_modal(101, data::Damping({.ratio = 0.01}), ContactScheme::located));
  EXPECT_FALSE(are_modal(20, {}, ContactScheme::paper));
}

TEST(FastestCoordinates, AreThoseOfARun) {
  // Bit for bit: a run by either name takes the same steps.
  const data::NumericalSettings numerics(paper_choices(0.05));
  const auto tip = [&](std::optional<Coordinates> coordinates, solver::ContactScheme scheme) {
    BeamSimulation run = slipping_run(numerics, {.scheme = scheme, .coordinates = coordinates});
    while (run.integrator().steps() < 500) run.integrator().step();
    return run.friction_force();
  };
  using solver::ContactScheme;
  EXPECT_EQ(tip(std::nullopt, ContactScheme::located), tip(Coordinates::modal, ContactScheme::located));
  EXPECT_NE(tip(Coordinates::nodal, ContactScheme::located), tip(Coordinates::modal, ContactScheme::located));
  EXPECT_EQ(tip(std::nullopt, ContactScheme::paper), tip(Coordinates::nodal, ContactScheme::paper));
  EXPECT_THROW(tip(Coordinates::modal, ContactScheme::paper), std::logic_error);
}

}  // namespace
}  // namespace stickslip::testing
