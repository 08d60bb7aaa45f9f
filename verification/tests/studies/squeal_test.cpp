// SPDX-License-Identifier: MIT
/// Steady sliding on a wall that moves, and what follows from rest, by both implementations.

#include "studies/analyses/squeal.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/steady_sliding.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_mobility.hpp"
#include "stickslip/solver/sliding_stability.hpp"
#include "studies/analyses/contact_response.hpp"
#include "studies/history/method.hpp"
#include "support/contact_models.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using Complex = std::complex<double>;

data::Case reed(const std::vector<data::Override>& overrides = {}) {
  return data::load_case("reed", overrides);
}

// The reed with Kelvin-Voigt damping of 1 % of critical in its first mode: the closed form knows all modes.
data::Case viscous_reed() { return reed({{"damping.ratio", "0.0"}, {"damping.kelvin_voigt", "1.27e-5"}}); }

solver::ContactSystem mesh_of(const data::Case& problem, int elements) {
  return solver::beam_contact_system(solver::BeamModel(problem.beam(), elements), problem);
}

std::vector<double> free_frequencies(const data::Case& problem, int count) {
  std::vector<double> frequencies;
  for (const auto& mode : analytic::slip_modes(problem.beam(), count))
    frequencies.push_back(mode.angular_frequency());
  return frequencies;
}

Complex nearest(const std::vector<Complex>& values, Complex to) {
  return *std::ranges::min_element(values, {}, [&](Complex value) { return std::abs(value - to); });
}

STICKSLIP_VERIFIES(SteadySliding, "W2");
TEST(SteadySliding, DeflectionIsThatOfTheMesh) {
  for (const double direction : {0.0, 0.4, 1.0}) {
    data::BeamProperties properties = paper_beam().properties();
    properties.axial_force = 4000.0;  // almost half of Euler's load
    properties.axial_direction = direction;
    const data::Beam beam(properties);
    const data::Wall wall(-0.2);
    const auto steady = analytic::steady_sliding(beam, paper_friction(), wall);
    EXPECT_TRUE(
        within(steady.friction_force, -4000.0 * (0.3 + 0.3 * std::exp(-0.2)), round_off(5, 1, 4000.0)));
    std::vector<double> errors;
    for (const int elements : {4, 8}) {
      const auto system = solver::beam_contact_system(solver::BeamModel(beam, elements),
                                                      with(paper_problem(25.0, 1e-3), beam, wall),
                                                      solver::PrescribedMotion());
      errors.push_back(std::abs(solver::steady_contact_displacement(system, steady.friction_force) /
                                    steady.tip_displacement -
                                1.0));
    }
    // Order 4 of the mesh; the next term is P l^2/EI of 4 elements, 0.06.
    EXPECT_TRUE(within(errors[0] / errors[1], 16.0, discretisation(16.0 * 0.06, 1.0, "P l^2/EI")));
    // The limit of Y(s)/s.
    const analytic::TipMobility mobility(beam);
    EXPECT_TRUE(within((mobility(1e-4) / 1e-4).real() * steady.friction_force / steady.tip_displacement, 1.0,
                       discretisation(1e-8 / 100.0, 10.0, "(s/omega_1)^2")));
  }
}

TEST(SteadySliding, HasTheSlopeOfFrictionInBoth) {
  data::Case problem = reed();
  problem.contact.friction = data::FrictionLaw(
      {.static_coefficient = 0.6, .kinetic_coefficient = 0.4, .decay = 2.0, .viscous = 0.3});
  const double force = problem.beam().axial_force();
  const double slope = analytic::falling_slope(problem.contact.friction, force, problem.contact.wall.speed());
  EXPECT_TRUE(within(solver::falling_slope(mesh_of(problem, 2)), slope, round_off(10, 1, 0.7 * force)));
}

TEST(SteadySliding, OfAMassIsLostAtASlope) {
  analytic::ContactModel model = contact_model({.mass = 2.0, .stiffness = 50.0});
  model.damping = analytic::Matrix(1, 1);
  model.damping(0, 0) = 0.7;
  const auto modes = analytic::sliding_modes(analytic::contact_mobility(model), {5.0}, 1.5);
  ASSERT_EQ(modes.size(), 1u);
  model.damping(0, 0) = 0.0;
  EXPECT_EQ(1.0 / analytic::contact_mobility(model)(Complex(0.0, 5.0)),
            0.0);  // no impedance at an eigenvalue
  EXPECT_TRUE(within(modes[0].one_mode_slope, 0.7, discretisation(1e-10, 1.0, "difference quotient of Z")));
  EXPECT_TRUE(within(modes[0].hopf->slope, 0.7, round_off(100, 1, 0.7)));
  EXPECT_TRUE(within(modes[0].hopf->angular_frequency, 5.0, round_off(100, 1, 5.0)));
  EXPECT_TRUE(within(modes[0].root->real(), 0.5 * (1.5 - 0.7) / 2.0, round_off(100, 1, 5.0)));
  const data::FrictionLaw law(
      {.static_coefficient = 0.6, .kinetic_coefficient = 0.4, .decay = 2.0, .viscous = 0.01});
  const double speed = analytic::speed_of_slope(law, 10.0, 0.7);
  EXPECT_TRUE(within(analytic::falling_slope(law, 10.0, speed), 0.7, round_off(10, 1, 4.0)));
  EXPECT_EQ(analytic::speed_of_slope(law, 10.0, 4.0), 0.0);
  // Constant friction: the slope 0 of every speed is above a slope that drives, and below one that is held.
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(analytic::speed_of_slope(data::FrictionLaw({0.6, 0.4, 2.0, 0.0}), 10.0, 0.0), never);
  EXPECT_EQ(analytic::speed_of_slope(data::FrictionLaw({0.4, 0.4}), 10.0, -0.1), never);
  EXPECT_EQ(analytic::speed_of_slope(data::FrictionLaw({0.4, 0.4}), 10.0, 0.1), 0.0);
}

// A mode that creeps back, s^2 + 3 s + 1, has no root off the real axis; one that vibrates, s^2 + s/50 + 100, has -0.01 + i
// 10 to 1e-4.
TEST(SteadySliding, LeavesOutAModeThatCreepsBack) {
  const auto mobility = [](Complex s) {
    return s / (s * s + 3.0 * s + 1.0) + s / (s * s + 0.02 * s + 100.0);
  };
  EXPECT_TRUE(analytic::sliding_modes(mobility, {1.0, 10.0}, 0.0).empty());
  const auto modes = analytic::sliding_modes(mobility, {10.0, 1.0}, 0.0);
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_TRUE(within(modes[0].free_root, Complex(-0.01, std::sqrt(100.0 - 1e-4)), round_off(100, 1, 10.0)));
}

// kappa g_k/2 = zeta_k omega_k, with the g_k of the modes without damping. The contact couples the modes: the slope that all
// of them hold differs from it by a term of second order in the damping.
TEST(SteadySliding, OfOneModeIsAFormula) {
  std::vector<double> coupling;
  for (const std::string damping : {"4e-6", "2e-6"}) {
    const data::Case problem = reed({{"damping.ratio", "0.0"}, {"damping.kelvin_voigt", damping}});
    const auto mode = analytic::sliding_modes(analytic::TipMobility(problem.beam(), problem.damping),
                                              free_frequencies(problem, 1), 0.0)
                          .front();
    const double input = analytic::free_modes(problem.beam(), 1).front().input;
    EXPECT_TRUE(within(mode.one_mode_slope * input / 2.0, -mode.free_root.real(),
                       discretisation(-1e-12 * mode.free_root.real(), 5.0, "(1e-3)^4 of the derivative")));
    coupling.push_back(mode.hopf->slope / mode.one_mode_slope - 1.0);
  }
  // The next term is of the order of the damping ratio, 0.3 %.
  EXPECT_TRUE(within(coupling[0] / coupling[1], 4.0, discretisation(4.0 * 0.003, 2.0, "damping ratio")));
}

// Eigenvalues of matrices on one side, the characteristic equation of the mobility on the other: the same mesh.
TEST(SteadySliding, CrossesWhereTheMobilitySays) {
  const data::Case problem = viscous_reed();
  const auto mesh = mesh_of(problem, 8);
  const solver::ContactMobility mobility(mesh);
  const auto modes =
      analytic::sliding_modes([&](Complex s) { return mobility(s); }, free_frequencies(problem, 2), 2.0);
  ASSERT_EQ(modes.size(), 2u);
  const auto eigenvalues = solver::sliding_eigenvalues(mesh, 2.0);
  for (const auto& mode : modes) {
    // Round-off of an eigenvalue relative to its modulus, over the damping ratio of 1 % and more.
    EXPECT_TRUE(within(nearest(solver::sliding_eigenvalues(mesh, mode.hopf->slope),
                               Complex(0.0, mode.hopf->angular_frequency))
                           .real(),
                       0.0, round_off(100, 1.0 / 0.01, mode.free_root.real())));
    const Complex eigenvalue = nearest(eigenvalues, *mode.root);
    EXPECT_TRUE(within(eigenvalue, *mode.root, round_off(1e4, 1, std::abs(eigenvalue))));
  }
}

// The eigenvalue of a mesh that begins at the mode without friction, followed to the slope held. Heavy damping of the higher
// modes lets some of them never reach the axis.
TEST(SteadySliding, SlopeHeldIsThatOfTheModeItself) {
  int crossing = 0, held = 0;
  on_random_beams(16, {0.02, 0.1}, [&](const data::Beam& beam, RandomNumbers& numbers) {
    data::Case problem = with(viscous_reed(), beam);
    const auto frequencies = free_frequencies(problem, 3);
    problem.damping = data::Damping({.kelvin_voigt = numbers.log_uniform(0.003, 0.1) / frequencies.front()});
    const auto mesh = mesh_of(problem, 10);
    for (const auto& mode :
         analytic::sliding_modes(analytic::TipMobility(beam, problem.damping), frequencies, 0.0)) {
      (mode.hopf ? crossing : held) += 1;
      if (!mode.hopf) continue;
      Complex root = mode.free_root;
      for (int i = 0; i <= 50; ++i)
        root = nearest(solver::sliding_eigenvalues(mesh, mode.hopf->slope * i / 50.0), root);
      // Ten elements leave (beta l)^4/720 of mode 3.
      EXPECT_TRUE(within(root / mode.hopf->angular_frequency, Complex(0.0, 1.0),
                         discretisation(std::pow(7.86 / 10.0, 4) / 720.0, 10.0, "the mesh")));
    }
  });
  EXPECT_GE(std::min(crossing, held), 3);
}

// The slope (mu_s - mu_m) alpha N exp(-alpha v) is c at the Hopf point of one mass, with 40 and 5.946 N s/m in the oscillator of Veraszto
// and Stepan. Their 0.190624 m/s is this to the digits of c: half of its last one is 0.0005/5.946/alpha.
TEST(SteadySliding, OfOneMassIsAFormula) {
  data::Case problem = reed();
  problem.structure = data::Model({.mass = 1.0, .stiffness = 100.0, .damping = 5.946, .normal_force = 10.0});
  problem.damping = {};
  problem.contact.friction = data::FrictionLaw(
      {.static_coefficient = 0.8, .kinetic_coefficient = 0.4, .decay = 10.0, .viscous = 0.0});
  for (const double speed : {0.19, 0.191}) {
    problem.contact.wall = data::Wall({.speed = speed});
    const studies::Squeal squeal = studies::squeal_of(problem, 1);
    EXPECT_EQ(squeal.is_stable(), speed > 0.1905);
    ASSERT_EQ(squeal.modes.size(), 1U);
    const double critical = squeal.modes.front().critical_speed.value();
    EXPECT_TRUE(within(critical, std::log(40.0 / 5.946) / 10.0, round_off(100, 1, critical)));
    EXPECT_TRUE(within(critical, 0.190624, reference(0.0005 / 5.946 / 10.0, "the digits of c")));
  }
}

TEST(SteadySliding, MapHasTheBoundaryOfTheHopfPoint) {
  const data::Case problem = reed();
  const auto squeal = studies::squeal_of(problem, 3);
  const double speed = *squeal.modes.front().critical_speed;
  for (const double ratio : {0.01, 0.02}) {
    const auto growths =
        studies::sliding_growths(problem, {speed * (1.0 - 1e-6), speed * (1.0 + 1e-6)}, ratio);
    ASSERT_EQ(growths.size(), 2u);
    EXPECT_EQ(growths[0] > 0.0, ratio == 0.01);
    EXPECT_LT(growths[1], 0.0);
  }
  EXPECT_FALSE(squeal.all_modes || squeal.is_stable());
  EXPECT_TRUE(studies::squeal_of(viscous_reed(), 1).all_modes);
  EXPECT_EQ(squeal.fastest, squeal.modes[0].finite_element_root);
  EXPECT_TRUE(within(squeal.friction_force, 3.0 + 2.0 * std::exp(-1.5), round_off(10, 1, 5.0)));
  EXPECT_TRUE(within(squeal.slope, 10.0 * std::exp(-1.5), round_off(10, 1, 10.0)));
  // (beta l)^4/720 of mode 3 on 20 elements. A static deflection is a cubic, but for the small P.
  const double mesh = std::pow(7.86 / 20.0, 4) / 720.0;
  const double tip = analytic::steady_sliding(problem.beam(), problem.contact.friction, problem.contact.wall)
                         .tip_displacement;
  EXPECT_EQ(squeal.tip_displacement, tip);
  EXPECT_TRUE(within(squeal.finite_element_displacement, tip, discretisation(mesh * tip, 1.0, "mesh")));
  const auto roots = analytic::sliding_eigenvalues(studies::response_model(problem), squeal.slope);
  for (const auto& mode : squeal.modes) {
    const double size = std::abs(*mode.root);
    EXPECT_TRUE(within(*mode.finite_element_root, *mode.root, discretisation(mesh * size, 2.0, "mesh")));
    // The same model as a matrix and by its mobility.
    EXPECT_TRUE(within(nearest(roots, *mode.root), *mode.root, round_off(1e4, 1, size)));
    // Coupled by the contact at second order in 1 % of damping, which makes it less than a fifth of that in the ratio.
    EXPECT_TRUE(within(mode.damping_ratio, 0.01, discretisation(1e-4 * 0.01, 10.0, "ratio^2")));
    EXPECT_TRUE(within(*mode.critical_slope, mode.one_mode_slope,
                       discretisation(1e-4 * mode.one_mode_slope, 20.0, "ratio^2")));
  }
  // Without damping nothing is held, at any speed.
  const auto undamped = studies::squeal_of(reed({{"damping.ratio", "0.0"}}), 1).modes.front();
  EXPECT_TRUE(std::isinf(undamped.critical_speed.value()));
  EXPECT_EQ(undamped.damping_ratio, 0.0);
  EXPECT_EQ(undamped.one_mode_slope, 0.0);
  EXPECT_LT(studies::sliding_growths(viscous_reed(), {0.7}, 0.0).front(), 0.0);  // Kelvin-Voigt holds it
  EXPECT_TRUE(studies::squeal_of(reed({{"wall.speed", "0.7"}}), 3).is_stable());
  EXPECT_THROW((void)studies::squeal_of(reed({{"wall.speed", "0.0"}}), 3), data::FieldError);
}

// Where friction falls fast, the highest modes of every mesh grow, and faster the finer it is.
TEST(SteadySliding, IsJudgedByResolvedModes) {
  std::vector<double> growth;
  for (const char* elements : {"10", "20", "40"}) {
    const data::Case problem = reed({{"damping.ratio", "0.001"},
                                     {"friction.decay", "60.0"},
                                     {"wall.speed", "0.01"},
                                     {"numerics.elements", elements}});
    const auto squeal = studies::squeal_of(problem, 3);
    EXPECT_TRUE(squeal.unresolved_mode_grows) << elements;
    // beta l = 1.948 at 1 %, and beta L = (n - 1/2) pi.
    const double beta_l = 1.948 * problem.numerics.elements();
    EXPECT_TRUE(
        within(squeal.resolved_modes, beta_l / std::numbers::pi + 0.5, reference(1.0, "a whole number")));
    const double omega = beta_l * beta_l * frequency_unit(problem.beam());
    EXPECT_TRUE(within(2.0 * std::numbers::pi * squeal.resolved_hz, omega,
                       discretisation(omega * 1e-3, 1.0, "four digits of 1.948")));
    EXPECT_LT(std::abs(squeal.fastest), 2.0 * std::numbers::pi * squeal.resolved_hz);
    growth.push_back(squeal.fastest.real());
  }
  // Of order 4 in the mesh.
  EXPECT_LT(std::abs(growth[1] - growth[2]), 0.5 * std::abs(growth[0] - growth[1]));
}

// The real root of the mesh is one of the continuous beam.
TEST(SteadySliding, DivergesWithARealRootOfTheBeam) {
  const data::Case problem = reed({{"damping.ratio", "0.0"},
                                   {"damping.kelvin_voigt", "1e-4"},
                                   {"wall.speed", "0.01"},
                                   {"friction.decay", "100.0"},
                                   {"numerics.elements", "40"}});
  const auto squeal = studies::squeal_of(problem, 3);
  ASSERT_TRUE(squeal.diverges());
  EXPECT_FALSE(squeal.modes.front().root);
  EXPECT_EQ(squeal.modes.front().finite_element_root, squeal.fastest);
  const analytic::TipMobility mobility(problem.beam(), problem.damping);
  EXPECT_TRUE(within((1.0 / mobility(squeal.fastest)).real() / squeal.slope, 1.0,
                     discretisation(1e-3, 1.0, "sigma of a mesh of 40 elements")));
}

// --- The wall that moves in the time stepper

STICKSLIP_VERIFIES(MovingWallOfTheMesh, "W1");
// Beside a base that moves, too, and with a friction that has its least value at 0.46 m/s.
TEST(MovingWallOfTheMesh, HasTheChangesOfEvents) {
  const data::FrictionLaw friction(
      {.static_coefficient = 0.5, .kinetic_coefficient = 0.3, .decay = 5.0, .viscous = 0.1});
  const data::Case problem = with(viscous_reed(), shaking(250.0, 5e-5), friction);
  const auto exact = studies::event_driven_history(analytic::contact_model(problem, 24), {0.01}).events;
  std::vector<double> errors;
  for (const double step : {1e-6, 5e-7}) {
    const auto events =
        studies::finite_element_history(studies::refined(problem, 24, step, 0.01, 0.9), {}).events;
    ASSERT_EQ(events.size(), exact.size());
    errors.push_back(studies::largest_difference(events, exact, exact.size()).time);
    for (const auto& onset : {events.front(), exact.front()}) {  // a tip that sticks goes with the wall
      EXPECT_EQ(onset.change, data::ContactChange::onset);
      EXPECT_TRUE(within(onset.position, problem.contact.wall.speed() * onset.time, round_off(100, 1, 1e-3)));
    }
  }
  EXPECT_GT(errors[0] / errors[1], 3.5);  // second order, down to what mesh and modes leave
}

// --- From rest

STICKSLIP_VERIFIES(Cycles, "W3");
TEST(Cycles, AreIndependentOfSettling) {
  const auto cycle = studies::cycle_of(reed({{"numerics.modes", "4"}}), 1, 60);
  ASSERT_TRUE(cycle.search.motion);
  EXPECT_TRUE(studies::is_stable(cycle));
  // It sticks from a capture to the next onset, twice in a period, and the wall at 0.3 m/s takes it along.
  const double period = cycle.search.motion->period;
  double sticking = 0.0, before = cycle.search.motion->events.back().time - period;
  for (const auto& event : cycle.search.motion->events) {
    if (event.change == data::ContactChange::onset) sticking += event.time - before;
    before = event.time;
  }
  EXPECT_GT(cycle.stick_share, 0.05);
  EXPECT_NEAR(cycle.stick_share, sticking / period, 1e-12);
  EXPECT_GT(cycle.peak_to_peak, 0.3 * 0.5 * sticking);
  EXPECT_GT(cycle.largest_sliding, 0.3);
  for (const auto& [speed, settle] : {std::pair{"0.3", 100}, {"-0.3", 60}}) {
    const auto other = studies::cycle_of(reed({{"numerics.modes", "4"}, {"wall.speed", speed}}), 1, settle);
    ASSERT_TRUE(other.search.motion);
    EXPECT_TRUE(within(other.search.motion->period, cycle.search.motion->period,
                       discretisation(1e-12, 100.0, "1e-12 a step")));
  }
}

TEST(Cycles, AreNotFoundInSteadySliding) {
  const auto cycle = studies::cycle_of(reed({{"wall.speed", "4.0"}, {"numerics.modes", "2"}}), 1, 200);
  EXPECT_FALSE(cycle.search.motion);
  EXPECT_EQ(cycle.search.reason, analytic::NoMotion::steady);
  EXPECT_THROW((void)studies::cycle_of(reed({{"wall.speed", "0.0"}}), 1, 10), data::FieldError);
}

// Five modes grow, and the motion from rest has no period. Newton's method, free to wander, ended at a chatter of 14.3 kHz far
// away, and took 160 of its periods for one.
TEST(Cycles, AreNotThoseOfAMotionFarAway) {
  const auto cycle = studies::cycle_of(reed({{"damping.ratio", "0.001"}, {"numerics.modes", "5"}}), 1, 200);
  EXPECT_FALSE(cycle.search.motion);
  EXPECT_EQ(cycle.search.reason, analytic::NoMotion::unsettled);
}

// Converged in the modes (1.2414 with 10 and 20), a pair of multipliers is outside of the unit circle: the history of this case
// does not settle to its period.
TEST(Cycles, OfTheShakenBeamReturnButAreUnstable) {
  const data::Case problem = data::load_case("damped", {{"numerics.modes", "3"}});
  const auto cycle = studies::cycle_of(problem, 1, 200);
  ASSERT_TRUE(cycle.search.motion);
  const analytic::PeriodicMotion& motion = *cycle.search.motion;
  EXPECT_TRUE(cycle.forced);
  EXPECT_FALSE(studies::is_stable(cycle));
  EXPECT_LT(motion.residual, 1e-9);
  const double path = std::abs(motion.events.at(2).position - motion.events.at(0).position);
  EXPECT_TRUE(within(cycle.peak_to_peak, path, discretisation(1e-6 * path, 1.0, "samples of half a sine")));
  EXPECT_GT(cycle.largest_sliding, path / (0.5 * motion.period * (1.0 - cycle.stick_share)));  // the mean
  const double modulus = std::abs(motion.multipliers.front());
  EXPECT_GT(modulus, 1.0);
  EXPECT_LT(std::abs(motion.multipliers.back()), 1e-12);
  // Of two periods they are the squares.
  const auto model = analytic::contact_model(problem, 3);
  const auto twice =
      analytic::eigenvalues(analytic::poincare_map(model, motion.start, 2.0 * motion.period).derivative);
  EXPECT_TRUE(
      within(std::abs(twice.front()), modulus * modulus,
             discretisation(motion.residual, 1e4, "of x(T) = x(0), times the curvature of the flow")));
}

TEST(Cycles, AreStableUpToAShiftInTime) {
  studies::Cycle cycle;
  const auto stable = [&](bool forced, double multiplier) {
    cycle.forced = forced;
    cycle.search.motion.emplace().multipliers = {multiplier};
    return studies::is_stable(cycle);
  };
  EXPECT_TRUE(stable(false, 1.0 + 9e-7) && stable(true, 1.0));
  EXPECT_FALSE(stable(false, 1.0 + 1.1e-6) || stable(false, -1.0 - 9e-7) || stable(true, 1.0 + 9e-7));
}

}  // namespace
}  // namespace stickslip::testing
