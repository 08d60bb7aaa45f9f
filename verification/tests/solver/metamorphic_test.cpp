// SPDX-License-Identifier: MIT
/// Relations between runs of the finite elements and of the time stepper that hold for every beam.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "support/energy.hpp"
#include "support/event_sensitivity.hpp"
#include "support/free_tip.hpp"
#include "support/order.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"
#include "support/units.hpp"

namespace stickslip::testing {
namespace {

using data::ContactEvent;
using solver::BeamModel;
using solver::BeamSimulation;
using solver::PrescribedMotion;
using solver::StickSlipIntegrator;
using std::numbers::pi;

constexpr int mesh_elements = 6;

std::vector<double> stick_frequencies(const data::Beam& beam, int count) {
  std::vector<double> frequencies;
  for (const auto& mode : solver::stick_modes(BeamModel(beam, mesh_elements), count))
    frequencies.push_back(mode.angular_frequency);
  return frequencies;
}

/// A hundred steps to the shorter of both periods, of the excitation and of the first mode.
data::NumericalSettings settings(const data::Beam& beam, double hz, double periods) {
  const double shorter = std::min(1.0 / hz, 2.0 * pi / stick_frequencies(beam, 1).front());
  return data::NumericalSettings({.elements = mesh_elements,
                                  .time_step = 0.01 * shorter,
                                  .spectral_radius = 0.9,
                                  .velocity_threshold = 0.0,
                                  .modes = 1,
                                  .duration = periods / hz});
}

data::NumericalSettings settings(const StickSlipProblem& problem, double periods) {
  return settings(problem.beam, problem.excitation.frequency_hz(), periods);
}

/// A beam whose tip slips: 1.2 to 3 times the critical amplitude over one period, damped by half a percent of
/// critical in its first mode.
StickSlipProblem slipping(const data::Beam& beam, RandomNumbers& numbers) {
  const std::vector<double> natural = stick_frequencies(beam, 4);
  const double hz = random_frequency_hz(numbers, natural, 0.05);
  const double friction = numbers.uniform(0.1, 1.0);
  const double force_per_metre = solver::max_abs_friction_force(
      beam, data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1.0}), settings(beam, hz, 1.0));
  const double amplitude = numbers.uniform(1.2, 3.0) * friction * beam.axial_force() / force_per_metre;
  return random_problem(numbers, beam, friction, {.frequency_hz = hz, .amplitude = amplitude},
                        0.01 / natural.front());
}

/// A simulation, run to the end of its duration.
std::unique_ptr<BeamSimulation> run(const StickSlipProblem& problem, const data::NumericalSettings& numerics,
                                    solver::TipContact contact = solver::TipContact::friction) {
  auto simulation =
      std::make_unique<BeamSimulation>(problem.beam, problem.friction, problem.excitation, numerics,
                                       solver::BeamRun{.contact = contact, .damping = problem.damping});
  for (long n = solver::step_count(numerics.duration(), numerics.time_step()); n > 0; --n) simulation->step();
  return simulation;
}

std::vector<EventAt> events_of(const StickSlipIntegrator& integrator) {
  std::vector<EventAt> events;
  for (const ContactEvent& event : integrator.events()) events.push_back({event.time, event.position});
  return events;
}

PrescribedMotion transformed(const PrescribedMotion& motion, double factor, double delay = 0.0) {
  const auto changed = [factor, delay](const std::function<double(double)>& f) {
    return [=](double t) { return factor * f(t - delay); };
  };
  return {changed(motion.displacement), changed(motion.velocity), changed(motion.acceleration)};
}

PrescribedMotion sum(const PrescribedMotion& a, const PrescribedMotion& b) {
  return {[=](double t) { return a.displacement(t) + b.displacement(t); },
          [=](double t) { return a.velocity(t) + b.velocity(t); },
          [=](double t) { return a.acceleration(t) + b.acceleration(t); }};
}

/// The time stepper on a base with any motion, started as a BeamSimulation is.
std::unique_ptr<StickSlipIntegrator> started(const StickSlipProblem& problem, const PrescribedMotion& base,
                                             const solver::IntegratorSettings& settings,
                                             solver::TipContact contact = solver::TipContact::friction) {
  const BeamModel model(problem.beam, mesh_elements);
  solver::ContactSystem system = solver::beam_contact_system(model, problem.friction, base, problem.damping);
  if (contact == solver::TipContact::bonded) system.normal_force = solver::bonding_force;
  auto integrator = std::make_unique<StickSlipIntegrator>(system, settings);
  integrator->start_stuck(Eigen::VectorXd::Zero(model.degrees_of_freedom()),
                          -base.velocity(0.0) * model.unit_tip_deflection());
  return integrator;
}

void step(StickSlipIntegrator& integrator, long steps) {
  for (long n = 0; n < steps; ++n) integrator.step();
}

// Symmetry.

STICKSLIP_VERIFIES(Symmetry, "M1");
TEST(Symmetry, MirroredBaseMirrorsTheSteppedHistoryBitForBit) {
  int events = 0;
  on_random_beams(40, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const auto numerics = settings(problem, 2.0);
    const PrescribedMotion base = solver::harmonic_motion(problem.excitation);
    // Half of them with a threshold of a hundredth of the base's speed: captured while the tip still slides.
    const solver::IntegratorSettings choices{.time_step = numerics.time_step(),
                                             .spectral_radius = 0.9,
                                             .velocity_threshold = numbers.whole(0, 1) * 0.02 * pi *
                                                                   problem.excitation.frequency_hz() *
                                                                   problem.excitation.amplitude()};
    const auto plus = started(problem, base, choices);
    const auto minus = started(problem, transformed(base, -1.0), choices);
    for (long n = solver::step_count(numerics.duration(), numerics.time_step()); n > 0; --n) {
      plus->step();
      minus->step();
      ASSERT_EQ(plus->displacement(), Eigen::VectorXd(-minus->displacement()));
      ASSERT_EQ(plus->velocity(), Eigen::VectorXd(-minus->velocity()));
      ASSERT_EQ(plus->state(), minus->state());
      ASSERT_EQ(plus->friction_force(), -minus->friction_force());
    }
    ASSERT_EQ(plus->events().size(), minus->events().size());
    for (std::size_t i = 0; i < plus->events().size(); ++i) {
      const ContactEvent &a = plus->events()[i], &b = minus->events()[i];
      ASSERT_EQ(a.change, b.change);
      ASSERT_EQ(a.time, b.time);
      ASSERT_EQ(a.position, -b.position);
      ASSERT_EQ(a.residual_velocity, -b.residual_velocity);
    }
    events += static_cast<int>(plus->events().size());
  });
  EXPECT_GT(events, 200);
}

// Other units.

STICKSLIP_VERIFIES(UnitChange, "M1");
TEST(UnitChange, ByPowersOfTwoLeavesTheModesOfTheMeshTheSameBitForBit) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const Units units = random_powers_of_two(numbers);
    const int elements = numbers.whole(1, 8);
    const BeamModel a(beam, elements), b(in_units(units, beam), elements);
    EXPECT_EQ(solver::stick_buckling_load(a) * units.force(), solver::stick_buckling_load(b));
    const int count = 2 * elements - 1;
    const auto stick = solver::stick_modes(a, count);
    const auto expect_same = [&units](const auto& modes, const auto& others) {
      for (std::size_t n = 0; n < modes.size(); ++n) {
        EXPECT_EQ(modes[n].angular_frequency, others[n].angular_frequency * units.time) << n;
        for (Eigen::Index i = 0; i < modes[n].shape.size(); i += 2)
          EXPECT_EQ(modes[n].shape[i], others[n].shape[i] * std::sqrt(units.mass)) << n;
      }
    };
    expect_same(stick, solver::stick_modes(b, count));
    expect_same(solver::slip_modes(a, elements), solver::slip_modes(b, elements));
    const Eigen::VectorXd shape = a.unit_tip_deflection(), other_shape = b.unit_tip_deflection();
    for (Eigen::Index i = 0; i < shape.size(); i += 2) {
      EXPECT_EQ(shape[i], other_shape[i]);
      EXPECT_EQ(shape[i + 1], other_shape[i + 1] * units.length);
    }
    const data::Damping damping({.kelvin_voigt = 0.01 / stick.front().angular_frequency, .ratio = 0.02});
    const Eigen::MatrixXd dashpots = solver::damping_matrix(a, damping),
                          other_dashpots = solver::damping_matrix(b, in_units(units, damping));
    for (Eigen::Index i = 0; i < dashpots.rows(); i += 2)
      for (Eigen::Index j = 0; j < dashpots.cols(); j += 2)
        EXPECT_EQ(dashpots(i, j) * (units.mass / units.time), other_dashpots(i, j));
  });
}

TEST(UnitChange, ByPowersOfTwoLeavesTheSteppedHistoryTheSameBitForBit) {
  int events = 0;
  on_random_beams(40, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const Units units = random_powers_of_two(numbers);
    data::NumericalChoices choices = settings(problem, 2.0).choices();
    // A threshold of a hundredth of the base's speed: captured while it still slides.
    choices.velocity_threshold =
        0.02 * pi * problem.excitation.frequency_hz() * problem.excitation.amplitude();
    const data::NumericalSettings numerics(choices);
    const auto a = run(problem, numerics), b = run(in_units(units, problem), in_units(units, numerics));
    const auto &first = a->integrator().events(), &second = b->integrator().events();
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      ASSERT_EQ(first[i].change, second[i].change);
      ASSERT_EQ(first[i].time * units.time, second[i].time);
      ASSERT_EQ(first[i].position * units.length, second[i].position);
      ASSERT_EQ(first[i].residual_velocity * units.velocity(), second[i].residual_velocity);
    }
    EXPECT_EQ(a->friction_force() * units.force(), b->friction_force());
    EXPECT_EQ(a->midspan_displacement() * units.length, b->midspan_displacement());
    events += static_cast<int>(first.size());
  });
  EXPECT_GT(events, 200);
}

// In other units or with another material, section and length. An eigenvalue of the mesh is known to the
// round-off of its largest stiffness, n^4 times that of the lowest mode, and to that of P L^2/EI.

STICKSLIP_VERIFIES(Similarity, "M1");
TEST(Similarity, FixesTheModesOfTheMesh) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(2, 12);
    const BeamModel model(beam, elements);
    const auto stick = solver::stick_modes(model, elements), slip = solver::slip_modes(model, elements);
    const double condition = std::pow(elements, 4) * nearness_of_buckling(beam);
    const Eigen::VectorXd shape = model.unit_tip_deflection();
    for (const auto& [other, units] : similar_beams(numbers, beam)) {
      const BeamModel other_model(other, elements);
      const auto other_stick = solver::stick_modes(other_model, elements);
      const auto other_slip = solver::slip_modes(other_model, elements);
      const double load = solver::stick_buckling_load(model);
      EXPECT_TRUE(within(solver::stick_buckling_load(other_model) / units.force(), load,
                         round_off(1, std::pow(elements, 4), load)));
      for (std::size_t n = 0; n < stick.size(); ++n) {
        EXPECT_TRUE(within(other_stick[n].angular_frequency * units.time, stick[n].angular_frequency,
                           round_off(1, condition, stick[n].angular_frequency)))
            << n;
        // Unsymmetric: absolutely in 1/omega^2. In tension, which a follower force does not turn into
        // stiffness, the first mode is softer than that of the unloaded mesh, 12.4 units of omega^2.
        const double first = slip.front().angular_frequency, omega = slip[n].angular_frequency;
        const double softness = 1.0 + 12.4 * std::pow(frequency_unit(beam) / first, 2);
        EXPECT_TRUE(within(other_slip[n].angular_frequency * units.time, omega,
                           round_off(2, condition * softness * std::pow(omega / first, 2), omega)))
            << n;
      }
      const Eigen::VectorXd other_shape = other_model.unit_tip_deflection();
      for (Eigen::Index i = 0; i < shape.size(); i += 2)
        EXPECT_TRUE(within(other_shape[i], shape[i], round_off(1, condition, 1.0)));
    }
  });
}

/// Round-off in the data of the mesh, n^4 times the last digit, and events located to 1e-11 of a step.
constexpr double history_error = 4.0 * 6 * 6 * 6 * 6 * std::numeric_limits<double>::epsilon() + 1e-11;
constexpr double amplitude_change = 1e-8;

TEST(Similarity, FixesTheSteppedHistory) {
  int events = 0;
  on_random_beams(25, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const auto numerics = settings(problem, 1.5);
    const auto expected = events_of(run(problem, numerics)->integrator());
    const Sensitivity sensitivity{
        events_of(run(with_amplitude(problem, 1.0 + amplitude_change), numerics)->integrator()),
        amplitude_change, history_error, problem.excitation.amplitude()};
    expect_same_events_of_similar_beams(
        numbers, problem, expected, sensitivity, [&](const StickSlipProblem& scaled, const Units& units) {
          return events_of(run(scaled, in_units(units, numerics))->integrator());
        });
    events += static_cast<int>(expected.size());
  });
  EXPECT_GT(events, 60);
}

// Linearity in stick, and in slip without friction.

STICKSLIP_VERIFIES(Linearity, "M1");
TEST(Linearity, TwiceTheAmplitudeIsTwiceTheSteppedResponseBitForBit) {
  on_random_beams(30, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const double hz = random_frequency_hz(numbers, stick_frequencies(beam, 4), 0.02);
    const StickSlipProblem problem{
        beam,
        data::FrictionLaw({}),
        data::HarmonicExcitation({.frequency_hz = hz, .amplitude = numbers.log_uniform(1e-9, 1e-3)}),
        {}};
    const auto numerics = settings(problem, 0.7);
    const auto bonded = solver::TipContact::bonded;
    const auto once = run(problem, numerics, bonded),
               twice = run(with_amplitude(problem, 2.0), numerics, bonded);
    EXPECT_EQ(twice->friction_force(), 2.0 * once->friction_force());
    EXPECT_EQ(twice->integrator().displacement(), Eigen::VectorXd(2.0 * once->integrator().displacement()));
    const double force = solver::max_abs_friction_force(beam, problem.excitation, numerics);
    const data::HarmonicExcitation thrice = with_amplitude(problem, 3.0).excitation;
    // Each step rounds the reaction, a difference of forces of stiff elements, by n^4 eps; a random walk.
    const double walk = std::sqrt(numerics.duration() / numerics.time_step());
    EXPECT_TRUE(
        within(solver::max_abs_friction_force(beam, thrice, numerics), 3.0 * force,
               round_off(walk, std::pow(mesh_elements, 4) * nearness_of_buckling(beam), 3.0 * force)));
  });
}

// Round-off: a step rounds what it adds, and some hundreds of steps add up as they do in a response.
TEST(Linearity, SteppedResponsesToTwoBaseMotionsAddUp) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const std::vector<double> natural = stick_frequencies(beam, 4);
    const double hz = random_frequency_hz(numbers, natural, 0.02);
    const auto motion = [&](double frequency) {
      return solver::harmonic_motion(data::HarmonicExcitation(
          {.frequency_hz = frequency, .amplitude = numbers.log_uniform(1e-6, 1e-3)}));
    };
    const PrescribedMotion first = motion(hz), second = motion(random_frequency_hz(numbers, natural, 0.02));
    const double h = settings(beam, hz, 1.0).time_step();
    const BeamModel model(beam, mesh_elements);
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(model.degrees_of_freedom());
    const StickSlipProblem problem{beam, data::FrictionLaw({}),
                                   data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.0}),
                                   data::Damping({.kelvin_voigt = 0.01 / natural.front()})};
    for (const bool stuck : {true, false}) {
      const auto response = [&](const PrescribedMotion& base) {
        std::unique_ptr<StickSlipIntegrator> integrator;
        if (stuck) {
          integrator =
              started(problem, base, {.time_step = h, .spectral_radius = 0.9}, solver::TipContact::bonded);
        } else {
          integrator = std::make_unique<StickSlipIntegrator>(
              free_tip_system(model, base, problem.damping),
              solver::IntegratorSettings{.time_step = h, .spectral_radius = 0.9});
          integrator->start_slipping(at_rest, at_rest);
        }
        step(*integrator, 150);
        return integrator->displacement();
      };
      const Eigen::VectorXd a = response(first), b = response(second), both = response(sum(first, second));
      const double scale = a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff();
      for (Eigen::Index i = 0; i < both.size(); ++i)
        EXPECT_TRUE(within(both[i], a[i] + b[i], round_off(150, nearness_of_buckling(beam), scale)));
    }
  });
}

TEST(Linearity, CriticalAmplitudeIsTheFrictionLimitOverTheForcePerAmplitude) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const double hz = random_frequency_hz(numbers, stick_frequencies(beam, 4), 0.02);
    const data::FrictionLaw law({.static_coefficient = numbers.uniform(0.1, 1.0)});
    const auto numerics = settings(beam, hz, 2.0);
    const auto at = [hz](double amplitude) {
      return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = amplitude});
    };
    const double critical = law.static_coefficient() * beam.axial_force() /
                            solver::max_abs_friction_force(beam, at(1.0), numerics);
    EXPECT_FALSE(solver::first_slip(beam, law, at(critical * (1.0 - 1e-9)), numerics));
    EXPECT_TRUE(solver::first_slip(beam, law, at(critical * (1.0 + 1e-9)), numerics));
  });
}

STICKSLIP_VERIFIES(Monotony, "M1");
// Monotony: more friction or less amplitude turns no stick into slip, and no slip comes earlier.
TEST(Monotony, OfTheFirstSlipOfTheTimeStepperInFrictionAndAmplitude) {
  on_random_beams(15, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const auto numerics = settings(problem, 1.0);
    constexpr double never = std::numeric_limits<double>::infinity();
    const auto slip_at = [&](double friction, double share) {
      return solver::first_slip(beam, data::FrictionLaw({.static_coefficient = friction}),
                                with_amplitude(problem, share).excitation, numerics)
          .value_or(never);
    };
    double by_friction = 0.0, by_amplitude = never;
    for (int i = -4; i <= 4; ++i) {
      const double factor = std::pow(2.0, 0.5 * i);
      const double friction = slip_at(factor * problem.friction.static_coefficient(), 1.0);
      const double share = slip_at(problem.friction.static_coefficient(), factor);
      EXPECT_GE(friction, by_friction);
      EXPECT_LE(share, by_amplitude);
      by_friction = friction, by_amplitude = share;
    }
    EXPECT_EQ(by_friction, never);
    EXPECT_LT(by_amplitude, period(problem.excitation));
  });
}

// Time shift.

/// A0 sin(omega t)^3 for t > 0 and rest before: with its first two derivatives zero at the start.
PrescribedMotion smooth_start(const data::HarmonicExcitation& excitation) {
  const double amplitude = excitation.amplitude(), omega = 2.0 * pi * excitation.frequency_hz();
  return {[=](double t) { return t <= 0.0 ? 0.0 : amplitude * std::pow(std::sin(omega * t), 3); },
          [=](double t) {
            const double s = std::sin(omega * t), c = std::cos(omega * t);
            return t <= 0.0 ? 0.0 : 3.0 * amplitude * omega * s * s * c;
          },
          [=](double t) {
            const double s = std::sin(omega * t), c = std::cos(omega * t);
            return t <= 0.0 ? 0.0 : 3.0 * amplitude * omega * omega * s * (2.0 * c * c - s * s);
          }};
}

/// A power of two near 1/100 of the shorter period, so that n h - k h = (n - k) h exactly.
double binary_step(const StickSlipProblem& problem) {
  return std::exp2(std::floor(std::log2(settings(problem, 1.0).time_step())));
}

STICKSLIP_VERIFIES(TimeShift, "M1");
// With a spectral radius of 1 the load is taken in the middle of a step, which has a double of its own.
TEST(TimeShift, OfTheBaseByWholeStepsShiftsTheStickResponseBitForBit) {
  on_random_beams(30, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const double h = binary_step(problem);
    const PrescribedMotion base = smooth_start(problem.excitation);
    const solver::IntegratorSettings stepping{.time_step = h, .spectral_radius = 1.0};
    const auto bonded = solver::TipContact::bonded;
    const int delay = numbers.whole(1, 50);
    const auto now = started(problem, base, stepping, bonded),
               later = started(problem, transformed(base, 1.0, delay * h), stepping, bonded);
    step(*later, delay);
    EXPECT_EQ(later->displacement().cwiseAbs().maxCoeff(), 0.0);
    for (int n = 0; n < 150; ++n) {
      now->step();
      later->step();
      ASSERT_EQ(now->displacement(), later->displacement()) << n;
      ASSERT_EQ(now->velocity(), later->velocity()) << n;
      ASSERT_EQ(now->friction_force(), later->friction_force()) << n;
    }
  });
}

TEST(TimeShift, OfTheBaseByWholeStepsShiftsEveryEvent) {
  int events = 0;
  on_random_beams(25, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = with_amplitude(slipping(beam, numbers), 3.0);
    const double h = binary_step(problem);
    const solver::IntegratorSettings choices{.time_step = h, .spectral_radius = 0.9};
    const PrescribedMotion base = smooth_start(problem.excitation);
    const int delay = numbers.whole(1, 50);
    const long steps = solver::step_count(1.5 * period(problem.excitation), h);
    const auto history = [&](double factor, int waiting) {
      const auto integrator = started(problem, transformed(base, factor, waiting * h), choices);
      step(*integrator, steps + waiting);
      return events_of(*integrator);
    };
    const auto expected = history(1.0, 0);
    auto computed = history(1.0, delay);
    for (EventAt& event : computed) event.time -= delay * h;
    expect_same_events(computed, expected,
                       {history(1.0 + amplitude_change, 0), amplitude_change, history_error,
                        problem.excitation.amplitude()});
    events += static_cast<int>(expected.size());
  });
  EXPECT_GT(events, 60);
}

// A run that is continued from q and v alone starts with another algorithmic acceleration, a share of h off,
// which costs (1/2 - alpha_f)(alpha_m - alpha_f) h^2 q_ttt in the velocity: second order, as the method.
TEST(TimeShift, RestartFromAnyStepContinuesTheRunToSecondOrder) {
  on_random_beams(10, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    StickSlipProblem problem = slipping(beam, numbers);
    problem.damping = data::Damping({.kelvin_voigt = 0.1 / stick_frequencies(beam, 1).front()});
    const PrescribedMotion base = smooth_start(problem.excitation);
    const BeamModel model(beam, mesh_elements);
    const double coarse = binary_step(problem);
    const int start = numbers.whole(20, 60);
    std::vector<double> steps, differences;
    double motion = 0.0;
    for (const int halvings : {2, 3, 4, 5}) {
      const double h = std::ldexp(coarse, -halvings);
      const long before = static_cast<long>(start) << halvings, after = 100L << halvings;
      const solver::IntegratorSettings stepping{.time_step = h, .spectral_radius = 0.5};
      const auto whole = started(problem, base, stepping, solver::TipContact::bonded);
      step(*whole, before);
      solver::ContactSystem system = solver::beam_contact_system(
          model, problem.friction, transformed(base, 1.0, -static_cast<double>(before) * h), problem.damping);
      system.normal_force = solver::bonding_force;
      StickSlipIntegrator rest(system, stepping);
      rest.start_stuck(whole->displacement(), whole->velocity());
      double largest = 0.0;
      for (long n = 0; n < after; ++n) {
        whole->step();
        rest.step();
        const Eigen::VectorXd difference = whole->velocity() - rest.velocity();
        largest = largest_or_nan({largest, difference.dot(model.mass() * difference)});
        motion = std::max(motion, std::sqrt(whole->velocity().dot(model.mass() * whole->velocity())));
      }
      steps.push_back(h);
      differences.push_back(std::sqrt(largest));
    }
    // A mode's next term is a share of its w h; the jump of velocity reaches the fifth with some weight.
    const double fifth = stick_frequencies(beam, 5).back();
    const double floor = 3200.0 * std::numeric_limits<double>::epsilon() * motion;
    EXPECT_TRUE(order_is(order_levels(
                             steps, differences, [&](double h) { return 0.5 * fifth * h; }, floor),
                         2.0));
  });
}

/// A stiffness with the deflection of the tip held at zero.
Eigen::MatrixXd with_held_tip(const BeamModel& model, const solver::SparseMatrix& stiffness) {
  Eigen::MatrixXd held = stiffness;
  const Eigen::Index tip = model.tip_deflection();
  held.row(tip).setZero();
  held.col(tip).setZero();
  held(tip, tip) = 1.0;
  return held;
}

// Nested meshes: the cubic of an element is a cubic on each part of it.

/// Value and slope of a coarse mesh's functions at the nodes of one `factor` times as fine.
Eigen::MatrixXd interpolant(const BeamModel& coarse, int factor) {
  const int elements = coarse.elements();
  const double l = coarse.beam().length() / elements;
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(2 * elements * factor, 2 * elements);
  for (int node = 1; node <= elements * factor; ++node) {
    const int element = std::min((node - 1) / factor, elements - 1);
    const double s = static_cast<double>(node) / factor - element;
    const Eigen::RowVector4d value = solver::shape_functions(s, l).transpose();
    const Eigen::RowVector4d slope(6.0 * s * (s - 1.0) / l, 1.0 - 4.0 * s + 3.0 * s * s,
                                   6.0 * s * (1.0 - s) / l, 3.0 * s * s - 2.0 * s);
    for (int i = 0; i < 4; ++i)
      if (const int column = 2 * (element - 1) + i; column >= 0) {
        map(2 * node - 2, column) = value[i];
        map(2 * node - 1, column) = slope[i];
      }
  }
  return map;
}

STICKSLIP_VERIFIES(MeshNesting, "M2");
TEST(MeshNesting, FineMatricesOnCoarseFunctionsAreTheCoarseMatrices) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(1, 6);
    const BeamModel coarse(beam, elements);
    for (const int factor : {2, 3}) {
      const BeamModel fine(beam, factor * elements);
      const Eigen::MatrixXd map = interpolant(coarse, factor);
      for (const auto part :
           {&BeamModel::mass, &BeamModel::elastic_stiffness, &BeamModel::geometric_stiffness,
            &BeamModel::stick_stiffness, &BeamModel::slip_stiffness}) {
        const Eigen::MatrixXd large = (fine.*part)(), small = (coarse.*part)();
        const Eigen::MatrixXd nested = map.transpose() * large * map;
        const Eigen::MatrixXd magnitude = map.cwiseAbs().transpose() * large.cwiseAbs() * map.cwiseAbs();
        for (Eigen::Index i = 0; i < small.rows(); ++i)
          for (Eigen::Index j = 0; j < small.cols(); ++j)
            ASSERT_TRUE(within(nested(i, j), small(i, j), round_off(4, 1, magnitude(i, j))));
      }
      const Eigen::VectorXd load = map.transpose() * fine.base_load();
      const Eigen::VectorXd magnitude = map.cwiseAbs().transpose() * fine.base_load().cwiseAbs();
      for (Eigen::Index i = 0; i < load.size(); ++i)
        ASSERT_TRUE(within(load[i], coarse.base_load()[i], round_off(2, 1, magnitude[i])));
    }
  });
}

TEST(MeshNesting, InterpolantOfACoarseModeHasItsValues) {
  on_random_beams(40, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(2, 6);
    const BeamModel coarse(beam, elements), fine(beam, 2 * elements);
    const Eigen::MatrixXd map = interpolant(coarse, 2);
    const double x = beam.length() * numbers.uniform(0.0, 1.0);
    for (const auto& mode : solver::stick_modes(coarse, 2 * elements - 1)) {
      EXPECT_TRUE(within(fine.interpolation(x).dot(map * mode.shape), coarse.interpolation(x).dot(mode.shape),
                         round_off(4, 1, mode.shape.cwiseAbs().maxCoeff())));
      // An energy is a sum of products that are up to n^4 times as large.
      const double elastic = elastic_energy(coarse, mode.shape);
      const double kinetic = 0.5 * mode.angular_frequency * mode.angular_frequency;
      EXPECT_TRUE(within(elastic + geometric_energy(coarse, mode.shape), kinetic,
                         round_off(1, std::pow(2.0 * elements, 4), elastic + kinetic)));
    }
  });
}

// Rayleigh-Ritz: of two nested spaces the larger one has the lower frequencies, buckling load and energy of
// an imposed deflection, and the larger compliance.
TEST(MeshNesting, RefinementSoftens) {
  on_random_beams(40, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(2, 6);
    const BeamModel coarse(beam, elements);
    const auto modes = solver::stick_modes(coarse, 2 * elements - 1);
    const auto tip_energy = [](const BeamModel& model) {
      const Eigen::VectorXd q = model.unit_tip_deflection();
      return elastic_energy(model, q) + geometric_energy(model, q);
    };
    const auto compliance = [](const BeamModel& model) {
      Eigen::VectorXd load = model.base_load();
      load[model.tip_deflection()] = 0.0;
      return load.dot(with_held_tip(model, model.stick_stiffness()).llt().solve(load));
    };
    for (const int factor : {2, 3}) {
      const BeamModel fine(beam, factor * elements);
      const double slack =
          round_off(1, std::pow(factor * elements, 4) * nearness_of_buckling(beam), 1.0).value;
      const auto finer = solver::stick_modes(fine, 2 * elements - 1);
      for (std::size_t n = 0; n < modes.size(); ++n)
        EXPECT_LT(finer[n].angular_frequency, modes[n].angular_frequency) << n;
      EXPECT_LT(solver::stick_buckling_load(fine), solver::stick_buckling_load(coarse));
      EXPECT_LE(tip_energy(fine),
                tip_energy(coarse) + slack * elastic_energy(coarse, coarse.unit_tip_deflection()));
      EXPECT_GT(compliance(fine), compliance(coarse));
    }
  });
}

// Reciprocity (Betti).

/// (K - omega^2 M)^-1.
Eigen::MatrixXd flexibility(const BeamModel& model, const solver::SparseMatrix& stiffness, double omega) {
  return Eigen::MatrixXd(stiffness - omega * omega * model.mass()).inverse();
}

double random_angular_frequency(RandomNumbers& numbers, const data::Beam& beam) {
  return 2.0 * pi * random_frequency_hz(numbers, stick_frequencies(beam, 4), 0.05);
}

STICKSLIP_VERIFIES(Reciprocity, "M2");
// A force at a, with the tip held, moves b as far as the same force at b moves a.
TEST(Reciprocity, HoldsInTheStickStateAtRestAndInVibration) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(3, 8);
    const BeamModel model(beam, elements);
    const double a = beam.length() * numbers.uniform(0.1, 0.9), b = beam.length() * numbers.uniform(0.1, 0.9);
    for (const double omega : {0.0, random_angular_frequency(numbers, beam)}) {
      const Eigen::PartialPivLU<Eigen::MatrixXd> solve(
          with_held_tip(model, model.stick_stiffness() - omega * omega * model.mass()));
      const auto at = [&](double x) {
        Eigen::VectorXd row = model.interpolation(x);
        row[model.tip_deflection()] = 0.0;
        return row;
      };
      const double there = at(b).dot(solve.solve(at(a))), back = at(a).dot(solve.solve(at(b)));
      const double scale =
          std::sqrt(std::abs(at(a).dot(solve.solve(at(a))) * at(b).dot(solve.solve(at(b))))) +
          std::abs(there);
      EXPECT_TRUE(
          within(there, back, round_off(1, std::pow(elements, 4) * nearness_of_buckling(beam), scale)));
    }
  });
}

// In slip the follower term P e_w e_theta^T is a rank-one change of the symmetric K - P K_G - omega^2 M,
// whose flexibility is F: by Sherman and Morrison
//
//     G_ab - G_ba = -P (F_aw F_theta b - F_bw F_theta a)/(1 + P F_theta w).
TEST(Reciprocity, IsLostInSlipByWhatTheFollowerForceDoes) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(3, 8);
    const BeamModel model(beam, elements);
    const double omega = random_angular_frequency(numbers, beam), force = beam.axial_force();
    const Eigen::MatrixXd g = flexibility(model, model.slip_stiffness(), omega);
    const Eigen::MatrixXd f = flexibility(model, model.stick_stiffness(), omega);
    const Eigen::Index w = model.tip_deflection(), theta = model.tip_rotation();
    double largest = 0.0;
    for (Eigen::Index a = 0; a < g.rows(); a += 2)
      for (Eigen::Index b = 0; b < a; b += 2) {
        const double scale = std::abs(g(a, b)) + std::abs(g(b, a));
        const double predicted =
            -force * (f(a, w) * f(theta, b) - f(b, w) * f(theta, a)) / (1.0 + force * f(theta, w));
        const double parts = std::abs(force) *
                             (std::abs(f(a, w) * f(theta, b)) + std::abs(f(b, w) * f(theta, a))) /
                             std::abs(1.0 + force * f(theta, w));
        EXPECT_TRUE(within(g(a, b) - g(b, a), predicted,
                           round_off(1, std::pow(elements, 4) * nearness_of_buckling(beam), scale + parts)));
        largest = std::max(largest, std::abs(predicted) / scale);
      }
    EXPECT_GT(largest, 1e-4);
  });
}

STICKSLIP_VERIFIES(Interlacing, "M2");
// At P = 0 the stick state is the slip state with one constraint (Cauchy): all modes of any mesh interlace.
TEST(Interlacing, PutsOneStickFrequencyOfTheMeshBetweenTwoSlipFrequencies) {
  on_random_beams(40, no_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(2, 8);
    const BeamModel model(beam, elements);
    const auto stick = solver::stick_modes(model, 2 * elements - 1);
    const auto slip = solver::slip_modes(model, 2 * elements);
    for (std::size_t n = 0; n < stick.size(); ++n) {
      EXPECT_LT(slip[n].angular_frequency, stick[n].angular_frequency) << n;
      EXPECT_LT(stick[n].angular_frequency, slip[n + 1].angular_frequency) << n;
    }
  });
}

}  // namespace
}  // namespace stickslip::testing
