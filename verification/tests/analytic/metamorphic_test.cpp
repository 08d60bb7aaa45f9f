// SPDX-License-Identifier: MIT
/// Relations between runs of the closed forms and of the event-driven engine that hold for every beam.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/event_sensitivity.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"
#include "support/units.hpp"

namespace stickslip::testing {
namespace {

using analytic::BeamContactModel;
using analytic::ContactModel;
using analytic::EventDriven;
using analytic::StickMode;
using analytic::StickResponse;
using data::ContactEvent;
using std::numbers::pi;

std::vector<double> stick_frequencies(const data::Beam& beam, int count) {
  std::vector<double> frequencies;
  for (const StickMode& mode : analytic::stick_modes(beam, count))
    frequencies.push_back(mode.angular_frequency());
  return frequencies;
}

data::HarmonicExcitation random_excitation(const data::Beam& beam, RandomNumbers& numbers) {
  return data::HarmonicExcitation(
      {.frequency_hz = random_frequency_hz(numbers, stick_frequencies(beam, 6), 0.02),
       .amplitude = beam.length() * numbers.log_uniform(1e-6, 1e-2)});
}

constexpr int kModes = 4;

/// A beam whose tip slips: 1.2 to 3 times the critical amplitude over one period, damped by half a percent of
/// critical in its first mode.
StickSlipProblem slipping(const data::Beam& beam, RandomNumbers& numbers) {
  const std::vector<double> natural = stick_frequencies(beam, kModes);
  const double hz = random_frequency_hz(numbers, natural, 0.05);
  const double friction = numbers.uniform(0.1, 1.0);
  const auto criterion = analytic::evaluate_criterion(
      beam, data::FrictionLaw({.static_coefficient = friction}),
      data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.0}), 1.0 / hz, kModes);
  const double amplitude = numbers.uniform(1.2, 3.0) * criterion.critical_amplitude.midpoint();
  return random_problem(numbers, beam, friction, {.frequency_hz = hz, .amplitude = amplitude},
                        0.01 / natural.front());
}

BeamContactModel contact_model(const StickSlipProblem& problem) {
  return {problem.beam, problem.friction, problem.excitation, problem.damping, kModes};
}

EventDriven run(const ContactModel& model, double end) {
  EventDriven history(model);
  history.advance_to(end);
  return history;
}

EventDriven run(const StickSlipProblem& problem, double periods) {
  return run(contact_model(problem).model(), periods * period(problem.excitation));
}

/// The events of both, bit for bit. Times and positions of the second are in units `time` and `length` of the first.
void expect_identical_events(const EventDriven& a, const EventDriven& b, double time, double length) {
  ASSERT_EQ(a.events().size(), b.events().size());
  for (std::size_t i = 0; i < a.events().size(); ++i) {
    ASSERT_EQ(a.events()[i].change, b.events()[i].change);
    ASSERT_EQ(a.events()[i].time * time, b.events()[i].time);
    ASSERT_EQ(a.events()[i].position * length, b.events()[i].position);
  }
}

// Symmetry.

ContactModel mirrored(ContactModel model) {
  for (double& load : model.load) load = -load;
  model.wall_amplitude = -model.wall_amplitude;
  return model;
}

STICKSLIP_VERIFIES(Symmetry, "M1");
TEST(Symmetry, MirroredBaseMirrorsTheEventDrivenHistoryBitForBit) {
  int events = 0;
  on_random_beams(40, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const ContactModel model = contact_model(problem).model();
    EventDriven plus(model), minus(mirrored(model));
    for (int quarter = 1; quarter <= 8; ++quarter) {
      const double t = 0.25 * quarter * period(problem.excitation);
      plus.advance_to(t);
      minus.advance_to(t);
      ASSERT_EQ(plus.state(), minus.state());
      ASSERT_EQ(plus.contact_position(), -minus.contact_position());
      ASSERT_EQ(plus.sliding_velocity(), -minus.sliding_velocity());
      ASSERT_EQ(plus.friction_force(), -minus.friction_force());
      for (std::size_t n = 0; n < model.modes(); ++n) {
        ASSERT_EQ(plus.amplitudes()[n], -minus.amplitudes()[n]);
        ASSERT_EQ(plus.rates()[n], -minus.rates()[n]);
      }
    }
    expect_identical_events(plus, minus, 1.0, -1.0);
    events += static_cast<int>(plus.events().size());
  });
  EXPECT_GT(events, 200);
}

// Other units.

STICKSLIP_VERIFIES(UnitChange, "M1");
TEST(UnitChange, ByPowersOfTwoLeavesModesTheSameBitForBit) {
  on_random_beams(100, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const Units units = random_powers_of_two(numbers);
    const double length = units.length, time = units.time;
    const data::Beam other = in_units(units, beam);
    const double x = beam.length() * numbers.uniform(0.0, 1.0);

    EXPECT_EQ(analytic::stick_buckling_load(beam) * units.force(), analytic::stick_buckling_load(other));
    EXPECT_EQ(analytic::slip_critical_load(beam) * units.force(), analytic::slip_critical_load(other));
    const analytic::QuasiStaticShape shape(beam), other_shape(other);
    EXPECT_EQ(shape.value(x), other_shape.value(x * length));
    EXPECT_EQ(shape.slope(x), other_shape.slope(x * length) * length);
    EXPECT_EQ(shape.curvature(x), other_shape.curvature(x * length) * length * length);
    EXPECT_EQ(shape.third_derivative(x), other_shape.third_derivative(x * length) * std::pow(length, 3));

    const auto modes = analytic::stick_modes(beam, 8), other_modes = analytic::stick_modes(other, 8);
    for (std::size_t n = 0; n < modes.size(); ++n) {
      const StickMode &a = modes[n], &b = other_modes[n];
      EXPECT_EQ(a.angular_frequency(), b.angular_frequency() * time);
      EXPECT_EQ(a.frequency_hz(), b.frequency_hz() * time);
      EXPECT_EQ(a.slope_norm_squared(), b.slope_norm_squared() * length);
      EXPECT_EQ(a.curvature_norm_squared(), b.curvature_norm_squared() * std::pow(length, 3));
      EXPECT_EQ(a.condition_number(), b.condition_number());
      EXPECT_EQ(a.participation(), b.participation());
      EXPECT_EQ(a.shape(x), b.shape(x * length));
      EXPECT_EQ(a.third_derivative(x), b.third_derivative(x * length) * std::pow(length, 3));
    }
    const auto slip = analytic::slip_modes(beam, 6), other_slip = analytic::slip_modes(other, 6);
    for (std::size_t n = 0; n < slip.size(); ++n) {
      EXPECT_EQ(slip[n].angular_frequency(), other_slip[n].angular_frequency() * time);
      EXPECT_EQ(slip[n].shape(x), other_slip[n].shape(x * length));
      EXPECT_EQ(slip[n].adjoint_shape(x), other_slip[n].adjoint_shape(x * length));
      EXPECT_EQ(slip[n].curvature(x), other_slip[n].curvature(x * length) * length * length);
    }
  });
}

TEST(UnitChange, ByPowersOfTwoLeavesTheStickResponseTheSameBitForBit) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const Units units = random_powers_of_two(numbers);
    const data::Beam other = in_units(units, beam);
    const data::HarmonicExcitation excitation = random_excitation(beam, numbers);
    const data::HarmonicExcitation other_excitation = in_units(units, excitation);
    const data::FrictionLaw law({.static_coefficient = numbers.uniform(0.1, 1.0)});
    const double x = beam.length() * numbers.uniform(0.0, 1.0);
    const double duration = 2.0 * period(excitation), t = duration * numbers.uniform(0.0, 1.0);
    const double force = units.force();
    for (const auto part : {analytic::SteadyPart::modal_sum, analytic::SteadyPart::exact}) {
      const StickResponse a(beam, excitation, 10, part), b(other, other_excitation, 10, part);
      EXPECT_EQ(a.friction_force(t) * force, b.friction_force(t * units.time));
      EXPECT_EQ(a.steady_force_amplitude() * force, b.steady_force_amplitude());
      EXPECT_EQ(a.omitted_transient_bound() * force, b.omitted_transient_bound());
      EXPECT_EQ(a.absolute_displacement(x, t) * units.length,
                b.absolute_displacement(x * units.length, t * units.time));
      const auto sampled = a.sampled_max_abs_friction_force(duration, 0.01 * duration);
      const auto other_sampled =
          b.sampled_max_abs_friction_force(duration * units.time, 0.01 * duration * units.time);
      EXPECT_EQ(sampled.lower * force, other_sampled.lower);
      EXPECT_EQ(sampled.upper * force, other_sampled.upper);
    }
    const auto a = analytic::evaluate_criterion(beam, law, excitation, duration);
    const auto b = analytic::evaluate_criterion(other, law, other_excitation, duration * units.time);
    EXPECT_EQ(a.verdict, b.verdict);
    EXPECT_EQ(a.force_max.lower * force, b.force_max.lower);
    EXPECT_EQ(a.force_max.upper * force, b.force_max.upper);
    EXPECT_EQ(a.critical_amplitude.lower * units.length, b.critical_amplitude.lower);
    EXPECT_EQ(a.friction_limit * force, b.friction_limit);
  });
}

TEST(UnitChange, ByPowersOfTwoLeavesTheWorstOfABandTheSameBitForBit) {
  on_random_beams(4, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const Units units = random_powers_of_two(numbers);
    const double first = stick_frequencies(beam, 1).front() / (2.0 * pi);
    const analytic::FrequencyBand band{0.5 * first, 1.5 * first};
    analytic::BandMaximum a(beam, band, 4.0 / first, 4);
    analytic::BandMaximum b(in_units(units, beam), {band.from_hz / units.time, band.to_hz / units.time},
                            4.0 / first * units.time, 4);
    const auto found = a.refined_to(1e-2), other = b.refined_to(1e-2);
    EXPECT_EQ(found.lower * (units.force() / units.length), other.lower);
    EXPECT_EQ(found.upper * (units.force() / units.length), other.upper);
    EXPECT_EQ(a.frequency_hz(), b.frequency_hz() * units.time);
    EXPECT_EQ(a.evaluations(), b.evaluations());
  });
}

TEST(UnitChange, ByPowersOfTwoLeavesTheEventDrivenHistoryTheSameBitForBit) {
  int events = 0;
  on_random_beams(30, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const Units units = random_powers_of_two(numbers);
    const EventDriven a = run(problem, 2.0), b = run(in_units(units, problem), 2.0);
    expect_identical_events(a, b, units.time, units.length);
    EXPECT_EQ(a.friction_force() * units.force(), b.friction_force());
    EXPECT_EQ(a.contact_displacement() * units.length, b.contact_displacement());
    EXPECT_EQ(a.contact_velocity() * units.velocity(), b.contact_velocity());
    events += static_cast<int>(a.events().size());
  });
  EXPECT_GT(events, 150);
}

// Not of the unit of mass: GSL normalises modes of the free tip in kg^(1/2) m and m together, which rounds.
TEST(UnitChange, OfLengthAndTimeByPowersOfTwoLeavesAModallyDampedHistoryTheSameBitForBit) {
  on_random_beams(10, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    StickSlipProblem problem = slipping(beam, numbers);
    problem.damping = data::Damping({.ratio = 0.01});
    Units units = random_powers_of_two(numbers);
    units.mass = 1.0;
    const EventDriven a = run(problem, 1.0), b = run(in_units(units, problem), 1.0);
    expect_identical_events(a, b, units.time, units.length);
  });
}

// The beam let go from a bent shape, without any load: nothing but its own motion says what is small.
TEST(UnitChange, ByPowersOfTwoLeavesAFreeMotionTheSameBitForBit) {
  int events = 0;
  on_random_beams(20, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    StickSlipProblem problem = slipping(beam, numbers);
    problem.excitation =
        data::HarmonicExcitation({.frequency_hz = problem.excitation.frequency_hz(), .amplitude = 0.0});
    const Units units = random_powers_of_two(numbers);
    const ContactModel model = contact_model(problem).model();
    const double first = model.angular_frequency.front();
    const double bent = 10.0 * problem.friction.static_coefficient() * beam.axial_force() /
                        (first * first * model.contact_mass);
    const auto released = [](const StickSlipProblem& of, double position, double end) {
      EventDriven history(contact_model(of).model());
      history.start_slipping({}, {}, position, 0.0);
      history.advance_to(end);
      return history;
    };
    const double end = 20.0 / first;
    const EventDriven a = released(problem, bent, end);
    const EventDriven b = released(in_units(units, problem), bent * units.length, end * units.time);
    expect_identical_events(a, b, units.time, units.length);
    EXPECT_EQ(a.contact_displacement() * units.length, b.contact_displacement());
    events += static_cast<int>(a.events().size());
  });
  EXPECT_GT(events, 100);
}

// In other units or with another material, section and length. What is rounded differently: E I, rho A, P
// L^2/EI and the unit of the frequency, some ten operations.

/// Relative change of a quantity of the beam per relative change of its axial force, by a difference.
template <typename Quantity>
double sensitivity_to_force(const data::Beam& beam, Quantity&& quantity) {
  constexpr double share = 1e-6;
  data::BeamProperties properties = beam.properties();
  properties.axial_force *= 1.0 + share;
  return std::abs(quantity(data::Beam(properties)) / quantity(beam) - 1.0) / share;
}

STICKSLIP_VERIFIES(Similarity, "M1");
TEST(Similarity, FixesModesAndShapes) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const double x = beam.length() * numbers.uniform(0.05, 0.95);
    const auto modes = analytic::stick_modes(beam, 8);
    const auto slip = analytic::slip_modes(beam, 4);
    const double s = analytic::QuasiStaticShape(beam).value(x);
    for (const auto& [other, units] : similar_beams(numbers, beam)) {
      const auto other_modes = analytic::stick_modes(other, 8);
      for (std::size_t n = 0; n < modes.size(); ++n) {
        const StickMode &a = modes[n], &b = other_modes[n];
        EXPECT_TRUE(within(b.angular_frequency() * units.time, a.angular_frequency(),
                           round_off(3, a.condition_number(), a.angular_frequency())));
        EXPECT_TRUE(within(b.participation(), a.participation(),
                           round_off(3, a.condition_number(), a.participation())));
      }
      const auto other_slip = analytic::slip_modes(other, 4);
      for (std::size_t n = 0; n < slip.size(); ++n) {
        const double slope = sensitivity_to_force(
            beam, [n](const data::Beam& of) { return analytic::slip_modes(of, 4)[n].angular_frequency(); });
        const double omega = slip[n].angular_frequency();
        EXPECT_TRUE(
            within(other_slip[n].angular_frequency() * units.time, omega, round_off(3, 1.0 + slope, omega)));
      }
      EXPECT_TRUE(within(analytic::QuasiStaticShape(other).value(x * units.length), s,
                         round_off(3, nearness_of_buckling(beam), 1.0)));
    }
  });
}

TEST(Similarity, FixesTheReactionAndTheCriterion) {
  on_random_beams(25, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::HarmonicExcitation excitation = random_excitation(beam, numbers);
    const data::FrictionLaw law({.static_coefficient = numbers.uniform(0.1, 1.0)});
    const double duration = 2.0 * period(excitation), t = duration * numbers.uniform(0.1, 1.0);
    const StickResponse response(beam, excitation);
    const auto criterion = analytic::evaluate_criterion(beam, law, excitation, duration);
    // Off resonance by 2 %, an error of a natural frequency counts fiftyfold, and in the phase with omega_n
    // t.
    double scale = std::abs(response.steady_force_amplitude());
    for (const auto& [amplitude, omega] : response.transient_force())
      scale += std::abs(amplitude) * (1.0 + omega * t);
    const double condition = 50.0 * response.modes().front().condition_number();
    const Tolerance width =
        discretisation(1e-10 * criterion.force_max.upper, 1.0, "relative width of the enclosures");
    const double critical = criterion.critical_amplitude.midpoint();
    for (const auto& [other, units] : similar_beams(numbers, beam)) {
      const data::HarmonicExcitation other_excitation = in_units(units, excitation);
      const StickResponse other_response(other, other_excitation);
      EXPECT_TRUE(within(other_response.friction_force(t * units.time) / units.force(),
                         response.friction_force(t), round_off(3, condition, scale)));
      const auto other_criterion =
          analytic::evaluate_criterion(other, law, other_excitation, duration * units.time);
      EXPECT_TRUE(within(other_criterion.force_max.midpoint() / units.force(), criterion.force_max.midpoint(),
                         width));
      EXPECT_TRUE(within(other_criterion.critical_amplitude.midpoint() / units.length, critical,
                         discretisation(1e-10 * critical, 1.0, "relative width of the enclosures")));
      EXPECT_EQ(other_criterion.verdict, criterion.verdict);
    }
  });
}

TEST(Similarity, FixesTheDampedSteadyState) {
  on_random_beams(50, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::HarmonicExcitation excitation = random_excitation(beam, numbers);
    const data::Damping damping({.kelvin_voigt = numbers.log_uniform(1e-3, 1.0) * period(excitation)});
    const analytic::DampedSteadyState a(beam, excitation, damping, analytic::TipSupport::held);
    // 2 % off resonance, and what the closed form loses to min(|b|, |c|)^-3 at low frequencies.
    const double z = beam.axial_force() * beam.length() * beam.length() / rigidity(beam);
    const double s = 2.0 * pi * excitation.frequency_hz() / frequency_unit(beam);
    const double smaller = s / std::sqrt(0.5 * std::abs(z) + std::hypot(0.5 * z, s));
    const double condition = 50.0 * nearness_of_buckling(beam) * std::max(1.0, std::pow(smaller, -3));
    for (const auto& [other, units] : similar_beams(numbers, beam)) {
      const analytic::DampedSteadyState b(other, in_units(units, excitation), in_units(units, damping),
                                          analytic::TipSupport::held);
      const auto force = a.friction_force(), other_force = b.friction_force() / units.force();
      const Tolerance tolerance = round_off(3, condition, std::abs(force));
      EXPECT_TRUE(within(other_force.real(), force.real(), tolerance));
      EXPECT_TRUE(within(other_force.imag(), force.imag(), tolerance));
      EXPECT_TRUE(within(b.dissipated_energy() / (units.force() * units.length), a.dissipated_energy(),
                         round_off(3, condition, a.dissipated_energy())));
    }
  });
}

std::vector<EventAt> events_of(const EventDriven& history) {
  std::vector<EventAt> events;
  for (const data::ContactEvent& event : history.events()) events.push_back({event.time, event.position});
  return events;
}

/// The integrator's tolerance in each of its steps, whose errors have either sign.
constexpr double kHistoryError = 1e-12;
constexpr double kPerturbation = 1e-8;

TEST(Similarity, FixesTheEventDrivenHistory) {
  int events = 0;
  on_random_beams(20, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const auto expected = events_of(run(problem, 1.5));
    const Sensitivity sensitivity{events_of(run(with_amplitude(problem, 1.0 + kPerturbation), 1.5)),
                                  kPerturbation, kHistoryError, problem.excitation.amplitude()};
    expect_same_events_of_similar_beams(
        numbers, problem, expected, sensitivity,
        [](const StickSlipProblem& scaled, const Units& /*units*/) { return events_of(run(scaled, 1.5)); });
    events += static_cast<int>(expected.size());
  });
  EXPECT_GT(events, 60);
}

// Linearity in stick.

STICKSLIP_VERIFIES(Linearity, "M1");
TEST(Linearity, TwiceTheAmplitudeIsTwiceTheStickResponseBitForBitAndThriceToRoundOff) {
  on_random_beams(40, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::HarmonicExcitation excitation = random_excitation(beam, numbers);
    const auto times = [&](double factor) {
      return StickResponse(beam, data::HarmonicExcitation({.frequency_hz = excitation.frequency_hz(),
                                                           .amplitude = factor * excitation.amplitude()}));
    };
    const StickResponse once = times(1.0), twice = times(2.0), thrice = times(3.0);
    const double x = beam.length() * numbers.uniform(0.0, 1.0);
    const double t = 10.0 * period(excitation) * numbers.uniform(0.0, 1.0);
    EXPECT_EQ(twice.friction_force(t), 2.0 * once.friction_force(t));
    EXPECT_EQ(twice.absolute_displacement(x, t), 2.0 * once.absolute_displacement(x, t));
    EXPECT_EQ(twice.steady_force_amplitude(), 2.0 * once.steady_force_amplitude());
    const double force = once.friction_force(t);
    EXPECT_TRUE(within(thrice.friction_force(t), 3.0 * force, round_off(1, 1, 3.0 * force)));
    const double steady = once.steady_force_amplitude();
    EXPECT_TRUE(within(thrice.steady_force_amplitude(), 3.0 * steady, round_off(1, 1, 3.0 * steady)));
  });
}

// The model's load and wall are free of each other: any two excitations of one frequency can be added. In
// stick the propagator is exact; with a tip that slides without friction the integrator keeps 1e-12 a step.
TEST(Linearity, ResponsesToTwoLoadsAddUpInStickAndWithoutFriction) {
  on_random_beams(15, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const ContactModel model = contact_model(problem).model();
    const double end = 1.3 * period(problem.excitation);
    for (const bool stuck : {true, false}) {
      const double coefficient = stuck ? 1e6 : 0.0;
      const auto history = [&](const std::vector<double>& load, double wall) {
        ContactModel loaded = model;
        loaded.load = load;
        loaded.wall_amplitude = wall;
        loaded.friction =
            data::FrictionLaw({.static_coefficient = coefficient, .kinetic_coefficient = coefficient});
        return run(loaded, end);
      };
      std::vector<double> second = model.load, sum = model.load;
      for (std::size_t n = 0; n < sum.size(); ++n) {
        second[n] *= numbers.uniform(-1.0, 1.0);
        sum[n] += second[n];
      }
      const double wall = model.wall_amplitude, other_wall = wall * numbers.uniform(-1.0, 1.0);
      const EventDriven a = history(model.load, wall), b = history(second, other_wall);
      const EventDriven both = history(sum, wall + other_wall);
      double displacement = std::abs(wall), amplitude = 0.0;
      for (const EventDriven* part : {&a, &b}) {
        displacement = std::max(displacement, std::abs(part->contact_displacement()));
        for (const double modal : part->amplitudes()) amplitude = std::max(amplitude, std::abs(modal));
      }
      const auto tolerance = [stuck](double scale) {
        return stuck ? round_off(4, 20, scale) : discretisation(1e-11 * scale, 1.0, "1e-12 a step");
      };
      EXPECT_TRUE(within(both.contact_displacement(), a.contact_displacement() + b.contact_displacement(),
                         tolerance(displacement)));
      for (std::size_t n = 0; n < model.modes(); ++n)
        EXPECT_TRUE(
            within(both.amplitudes()[n], a.amplitudes()[n] + b.amplitudes()[n], tolerance(amplitude)));
    }
  });
}

TEST(Linearity, CriticalAmplitudeBringsTheReactionToTheFrictionLimit) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::HarmonicExcitation excitation = random_excitation(beam, numbers);
    const data::FrictionLaw law({.static_coefficient = numbers.uniform(0.1, 1.0)});
    const double duration = 3.0 * period(excitation);
    const auto criterion = analytic::evaluate_criterion(beam, law, excitation, duration);
    const double critical = criterion.critical_amplitude.midpoint();
    const auto at = [&](double amplitude) {
      return analytic::evaluate_criterion(
          beam, law,
          data::HarmonicExcitation({.frequency_hz = excitation.frequency_hz(), .amplitude = amplitude}),
          duration);
    };
    EXPECT_TRUE(within(at(critical).force_max.midpoint(), law.static_coefficient() * beam.axial_force(),
                       round_off(1, 1, criterion.friction_limit)));
    EXPECT_EQ(at(critical * (1.0 - 1e-9)).verdict, analytic::Verdict::stick);
    EXPECT_EQ(at(critical * (1.0 + 1e-9)).verdict, analytic::Verdict::stick_slip);
  });
}

// Monotony: with more friction, less amplitude or less time there is no slip where there was none, and a
// first slip does not come earlier.

STICKSLIP_VERIFIES(Monotony, "M1");
TEST(Monotony, OfTheCriterionInFrictionAmplitudeAndDuration) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const double mu = problem.friction.static_coefficient();
    const auto slips = [&](double friction, double share, double periods) {
      return analytic::evaluate_criterion(beam, data::FrictionLaw({.static_coefficient = friction}),
                                          with_amplitude(problem, share).excitation,
                                          periods * period(problem.excitation), kModes)
                 .verdict == analytic::Verdict::stick_slip;
    };
    bool by_friction = true, by_amplitude = false, by_duration = false;
    for (int i = -4; i <= 4; ++i) {
      const double factor = std::pow(2.0, 0.5 * i);
      const bool friction = slips(factor * mu, 1.0, 1.0), share = slips(mu, factor, 1.0);
      const bool duration = slips(mu, 0.7, factor);
      EXPECT_LE(friction, by_friction);
      EXPECT_GE(share, by_amplitude);
      EXPECT_GE(duration, by_duration);
      by_friction = friction, by_amplitude = share, by_duration = duration;
    }
    EXPECT_FALSE(by_friction);
    EXPECT_TRUE(by_amplitude);
  });
}

TEST(Monotony, OfTheFirstSlipOfTheEngineInFrictionAndAmplitude) {
  on_random_beams(15, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const double never = std::numeric_limits<double>::infinity();
    const auto slip_at = [&](double friction, double share) {
      StickSlipProblem varied = with_amplitude(problem, share);
      varied.friction = data::FrictionLaw({.static_coefficient = friction});
      const EventDriven history = run(varied, 0.7);
      return history.events().empty() ? never : history.events().front().time;
    };
    double by_friction = 0.0, by_amplitude = never;
    for (double factor = 0.25; factor <= 4.0; factor *= 2.0) {
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

// Time shift: the load is periodic, and antiperiodic in half a period.

/// The history of a model from the state that another run has reached, seen with a sign.
EventDriven continued(const ContactModel& model, const EventDriven& from, double sign, double end) {
  const auto seen = [sign](std::vector<double> values) {
    for (double& value : values) value *= sign;
    return values;
  };
  EventDriven rest(model);
  if (from.state() == data::ContactState::stick) {
    rest.start_stuck(seen(from.amplitudes()), seen(from.rates()), sign * from.contact_position());
  } else {
    rest.start_slipping(seen(from.amplitudes()), seen(from.rates()), sign * from.contact_position(),
                        sign * from.sliding_velocity());
  }
  rest.advance_to(end);
  return rest;
}

STICKSLIP_VERIFIES(TimeShift, "M1");
TEST(TimeShift, ByAPeriodOrMirroredByHalfOfOneRestartsTheRestOfTheHistory) {
  int events = 0;
  on_random_beams(20, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const double cycle = period(problem.excitation);
    const ContactModel model = contact_model(problem).model();
    const auto whole = events_of(run(model, 2.5 * cycle));
    const auto perturbed = events_of(run(with_amplitude(problem, 1.0 + kPerturbation), 2.5));
    for (const double sign : {1.0, -1.0}) {
      const double shift = sign > 0.0 ? cycle : 1.5 * cycle;
      const EventDriven before = run(model, shift);
      const EventDriven rest = continued(model, before, sign, 2.5 * cycle - shift);
      // The events of the whole run, those before the shift as they were.
      auto computed = events_of(before);
      for (const EventAt& event : events_of(rest))
        computed.push_back({event.time + shift, sign * event.position});
      expect_same_events(computed, whole,
                         {perturbed, kPerturbation, kHistoryError, problem.excitation.amplitude()});
      events += static_cast<int>(rest.events().size());
    }
  });
  EXPECT_GT(events, 100);
}

STICKSLIP_VERIFIES(Reciprocity, "M2");
// Reciprocity (Betti). The tip displaced by 1 and a mode: the inertia forces of the mode on sigma do the work
// of the mode's tip reaction on the displacement 1,
//
//     omega_n^2 rho A int U_n sigma dx = EI U_n'''(L) + P U_n'(L),
//
// and the base's load on the mode is that on the mode and sigma apart, int U_n (1 + S) + int U_n sigma. The
// right sides are closed forms, the left ones come from quadrature.
TEST(Reciprocity, HoldsBetweenTheModesAndTheStaticShape) {
  on_random_beams(60, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::HarmonicExcitation excitation = random_excitation(beam, numbers);
    const double length = beam.length(), mass = beam.density() * beam.area();
    const ContactModel model = BeamContactModel(beam, data::FrictionLaw({}), excitation, {}, 8).model();
    const auto modes = analytic::stick_modes(beam, 8);
    const double base = excitation.amplitude() * std::pow(2.0 * pi * excitation.frequency_hz(), 2);
    for (std::size_t n = 0; n < modes.size(); ++n) {
      const StickMode& mode = modes[n];
      const double scale = 1.0 / std::sqrt(mass * mode.norm_squared());
      const double shear = rigidity(beam) * mode.third_derivative(length);
      const double follower = beam.axial_force() * mode.slope(length);
      // sigma is at most of the size of the nearness; the argument bb of a mode is known to bb eps.
      const double bb = mode.trigonometric_wave_number() * length;
      const Tolerance tolerance = round_off(2, bb, std::sqrt(mass * length) * nearness_of_buckling(beam));
      EXPECT_TRUE(within(model.mass_coupling[n],
                         scale * (shear + follower) / std::pow(mode.angular_frequency(), 2), tolerance));
      EXPECT_TRUE(within(model.load[n] / base, scale * mass * mode.load_integral() + model.mass_coupling[n],
                         tolerance));
    }
  });
}

// Without axial force the slip state is its own adjoint; with one, the adjoint differs by the follower force.
TEST(Reciprocity, OfTheSlipStateIsLostToTheFollowerForceAlone) {
  on_random_beams(50, no_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const double x = beam.length() * numbers.uniform(0.05, 0.95);
    for (const auto& mode : analytic::slip_modes(beam, 8))
      EXPECT_TRUE(within(mode.adjoint_shape(x), mode.shape(x),
                         round_off(1, mode.trigonometric_wave_number() * beam.length(), 1.0)));
  });
  on_random_beams(50, {0.1, 0.95}, [](const data::Beam& beam, RandomNumbers&) {
    const auto mode = analytic::slip_modes(beam, 1).front();
    EXPECT_GT(std::abs(mode.adjoint_shape(0.5 * beam.length()) - mode.shape(0.5 * beam.length())), 1e-2);
  });
}

STICKSLIP_VERIFIES(Interlacing, "M2");
// At P = 0 the stick state is the slip state with one constraint.
TEST(Interlacing, PutsOneStickFrequencyBetweenTwoSlipFrequencies) {
  on_random_beams(50, no_force, [](const data::Beam& beam, RandomNumbers&) {
    const auto stick = analytic::stick_modes(beam, 30);
    const auto slip = analytic::slip_modes(beam, 31);
    for (std::size_t n = 0; n < stick.size(); ++n) {
      EXPECT_LT(slip[n].angular_frequency(), stick[n].angular_frequency()) << n;
      EXPECT_LT(stick[n].angular_frequency(), slip[n + 1].angular_frequency()) << n;
    }
  });
}

}  // namespace
}  // namespace stickslip::testing
