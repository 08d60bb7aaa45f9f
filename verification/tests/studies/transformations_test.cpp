// SPDX-License-Identifier: MIT
/// Transformations of a problem that must change the answers of every engine in a known way, whatever the beam is.

#include <Eigen/Dense>
#include <iterator>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "support/measurements.hpp"
#include "support/mesh.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::ContactModel;
using analytic::EventDriven;
using solver::PrescribedMotion;
using solver::StickSlipIntegrator;
using std::numbers::pi;

Scene scene_of(const Measurement& measurement, const data::Beam& beam, RandomNumbers& numbers) {
  Scene scene{.problem = measurement.slips ? slipping(beam, numbers) : off_resonance(beam, numbers)};
  scene.x = numbers.uniform(0.05, 0.95);
  scene.t = numbers.uniform(0.1, 1.0);
  scene.elements = numbers.whole(2, 8);
  scene.periods = 2.0;
  return scene;
}

class Transformation : public ::testing::TestWithParam<Measurement> {};

auto rows_where(bool (*holds)(const Measurement&)) {
  std::vector<Measurement> rows;
  std::ranges::copy_if(measurements(), std::back_inserter(rows), holds);
  return ::testing::ValuesIn(rows);
}

const auto name_of_row = [](const auto& instance) { return instance.param.name; };

// Mirrored base.

class Symmetry : public Transformation {};

STICKSLIP_VERIFIES(Symmetry, "M1");
TEST_P(Symmetry, OfTheBaseIsThatOfTheHistoryBitForBit) {
  on_random_beams(40, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
    Scene scene = scene_of(GetParam(), beam, numbers);
    scene.has_threshold = numbers.whole(0, 1) == 1;
    const auto plus = GetParam().measure(scene);
    scene.is_mirrored = true;
    const auto minus = GetParam().measure(scene);
    ASSERT_EQ(plus.size(), minus.size());
    for (std::size_t i = 0; i < plus.size(); ++i)
      ASSERT_EQ(plus[i].value, (plus[i].is_odd ? -1.0 : 1.0) * minus[i].value) << i;
  });
}

INSTANTIATE_TEST_SUITE_P(Engines, Symmetry, rows_where([](const Measurement& row) { return row.is_history; }),
                         name_of_row);

// Other units.

double factor(const Units& units, const Dimension& dimension) {
  return std::pow(units.length, dimension.length) * std::pow(units.mass, dimension.mass) *
         std::pow(units.time, dimension.time);
}

class UnitChange : public Transformation {};

STICKSLIP_VERIFIES(UnitChange, "M1");
TEST_P(UnitChange, ByPowersOfTwoChangesNoBit) {
  std::size_t quantities = 0;
  on_random_beams(GetParam().beams, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
    Units units = random_powers_of_two(numbers);
    if (!GetParam().is_exact_in_mass) units.mass = 1.0;
    Scene scene = scene_of(GetParam(), beam, numbers);
    scene.has_threshold = true;
    const auto here = GetParam().measure(scene);
    scene.problem = in_units(units, scene.problem);
    const auto there = GetParam().measure(scene);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      ASSERT_EQ(here[i].value * factor(units, here[i].dimension), there[i].value) << i;
    quantities += here.size();
  });
  EXPECT_GE(quantities, GetParam().least_quantities);
}

INSTANTIATE_TEST_SUITE_P(Engines, UnitChange,
                         rows_where([](const Measurement& row) { return row.beams > 0; }), name_of_row);

// In mm, t, s, or with another material, section and length.

class Similarity : public Transformation {};

STICKSLIP_VERIFIES(Similarity, "M1");
TEST_P(Similarity, FixesAllButTheUnits) {
  int compared = 0;
  on_random_beams(
      GetParam().similar_beams, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
        Scene scene = scene_of(GetParam(), beam, numbers);
        scene.periods = 1.5;
        scene.measures_errors = true;
        const auto here = GetParam().measure(scene);
        scene.measures_errors = false;
        for (const auto& [other, units] : similar_beams(numbers, beam)) {
          Scene similar = scene;
          similar.problem = in_units(units, scene.problem);
          similar.problem.beam = other;
          const auto there = GetParam().measure(similar);
          ASSERT_EQ(here.size(), there.size());
          for (std::size_t i = 0; i < here.size(); ++i) {
            if (!here[i].of_similar) continue;
            EXPECT_TRUE(
                within(there[i].value / factor(units, here[i].dimension), here[i].value, *here[i].of_similar))
                << i;
            ++compared;
          }
        }
      });
  EXPECT_GE(compared, 100);
}

INSTANTIATE_TEST_SUITE_P(Engines, Similarity,
                         rows_where([](const Measurement& row) { return row.similar_beams > 0; }),
                         name_of_row);

// Linearity in stick, and in slip without friction.

class Linearity : public Transformation {};

STICKSLIP_VERIFIES(Linearity, "M1");
TEST_P(Linearity, TwiceTheAmplitudeIsTwiceTheResponseBitForBit) {
  on_random_beams(GetParam().beams, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
    Scene scene = scene_of(GetParam(), beam, numbers);
    const auto once = GetParam().measure(scene);
    const StickSlipProblem problem = scene.problem;
    scene.problem = with_amplitude(problem, 2.0);
    const auto twice = GetParam().measure(scene);
    scene.problem = with_amplitude(problem, 3.0);
    const auto thrice = GetParam().measure(scene);
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_EQ(twice.at(i).value, 2.0 * once[i].value) << i;
      if (once[i].condition == 0.0) continue;
      const double expected = 3.0 * once[i].value;
      EXPECT_TRUE(within(thrice.at(i).value, expected, round_off(1, once[i].condition, expected))) << i;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Engines, Linearity, rows_where([](const Measurement& row) { return row.is_linear; }),
                         name_of_row);

PrescribedMotion sum(const PrescribedMotion& a, const PrescribedMotion& b) {
  return {[=](double t) { return a.displacement(t) + b.displacement(t); },
          [=](double t) { return a.velocity(t) + b.velocity(t); },
          [=](double t) { return a.acceleration(t) + b.acceleration(t); }};
}

STICKSLIP_VERIFIES(Superposition, "M1");
// Round-off: a step rounds what it adds, and some hundreds of steps add up as they do in a response.
TEST(Superposition, HoldsForSteppedResponsesToTwoBaseMotions) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const std::vector<double> natural = stick_frequencies(beam, 4);
    const auto motion = [&](double frequency) {
      return solver::harmonic_motion(data::HarmonicExcitation(
          {.frequency_hz = frequency, .amplitude = numbers.log_uniform(1e-6, 1e-3)}));
    };
    const double hz = random_frequency_hz(numbers, natural, 0.02);
    const PrescribedMotion first = motion(hz), second = motion(random_frequency_hz(numbers, natural, 0.02));
    const StickSlipProblem problem{beam, data::FrictionLaw({}),
                                   data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.0}),
                                   data::Damping({.kelvin_voigt = 0.01 / natural.front()})};
    const solver::IntegratorSettings stepping{.time_step = settings(problem, 1.0).time_step(),
                                              .spectral_radius = 0.9};
    const solver::BeamModel model(beam, mesh_elements);
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(model.degrees_of_freedom());
    for (const bool stuck : {true, false}) {
      const auto response = [&](const PrescribedMotion& base) {
        auto integrator = started(problem, base, stepping, solver::TipContact::bonded);
        if (!stuck) {
          integrator =
              std::make_unique<StickSlipIntegrator>(free_tip_system(model, base, problem.damping), stepping);
          integrator->start_slipping(at_rest, at_rest);
        }
        while (integrator->steps() < 150) integrator->step();
        return integrator->displacement();
      };
      const Eigen::VectorXd a = response(first), b = response(second), both = response(sum(first, second));
      const double scale = a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff();
      for (Eigen::Index i = 0; i < both.size(); ++i)
        EXPECT_TRUE(within(both[i], a[i] + b[i], round_off(150, nearness_of_buckling(beam), scale)));
    }
  });
}

EventDriven run(const ContactModel& model, double end) {
  EventDriven history(model);
  history.advance_to(end);
  return history;
}

// The model's load and wall are free of each other: any two excitations of one frequency can be added. In
// stick the propagator is exact; with a tip that slides without friction the integrator keeps 1e-12 a step.
TEST(Superposition, HoldsForEventDrivenResponsesToTwoLoads) {
  on_random_beams(15, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const ContactModel model = modal_model(problem);
    for (const bool stuck : {true, false}) {
      const double coefficient = stuck ? 1e6 : 0.0;
      const auto history = [&](const std::vector<double>& load, double wall) {
        ContactModel loaded = model;
        loaded.load = load;
        loaded.wall_amplitude = wall;
        loaded.friction =
            data::FrictionLaw({.static_coefficient = coefficient, .kinetic_coefficient = coefficient});
        return run(loaded, 1.3 * period(problem.excitation));
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

// More friction, less amplitude or less time turns no stick into slip, and no slip comes earlier.

constexpr double never = std::numeric_limits<double>::infinity();

struct FirstSlip {
  std::string name;
  std::function<double(const StickSlipProblem&)> time;  ///< of the first slip within a period, s, or never
  /// The amplitude that takes the largest force to the friction limit, m.
  std::function<double(const StickSlipProblem&)> critical_amplitude;
};

double slip_by_criterion(const StickSlipProblem& problem) {
  const auto found = analytic::evaluate_criterion(problem.beam, problem.friction, problem.excitation,
                                                  period(problem.excitation), 4);
  return found.verdict == analytic::Verdict::stick_slip ? 0.0 : never;
}

double critical_by_criterion(const StickSlipProblem& problem) {
  return analytic::evaluate_criterion(problem.beam, problem.friction, problem.excitation,
                                      period(problem.excitation), 4)
      .critical_amplitude.midpoint();
}

double stepped_slip(const StickSlipProblem& problem) {
  return solver::first_slip(problem.beam, problem.friction, problem.excitation, settings(problem, 1.0))
      .value_or(never);
}

double stepped_critical(const StickSlipProblem& problem) {
  const data::HarmonicExcitation unit({.frequency_hz = problem.excitation.frequency_hz(), .amplitude = 1.0});
  return problem.friction.static_coefficient() * problem.beam.axial_force() /
         solver::max_abs_friction_force(problem.beam, unit, settings(problem, 1.0));
}

double event_driven_slip(const StickSlipProblem& problem) {
  const EventDriven history = run(modal_model(problem), period(problem.excitation));
  return history.events().empty() ? never : history.events().front().time;
}

const std::vector<FirstSlip> first_slips{{"Criterion", slip_by_criterion, critical_by_criterion},
                                         {"Stepped", stepped_slip, stepped_critical},
                                         {"EventDriven", event_driven_slip, {}}};

void PrintTo(const FirstSlip& row, std::ostream* stream) { *stream << row.name; }

class Monotonicity : public ::testing::TestWithParam<FirstSlip> {};

STICKSLIP_VERIFIES(Monotonicity, "M1");
TEST_P(Monotonicity, OfTheFirstSlipInFrictionAndAmplitude) {
  on_random_beams(15, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const auto slip_at = [&](double friction, double share) {
      StickSlipProblem varied = with_amplitude(problem, share);
      varied.friction =
          data::FrictionLaw({.static_coefficient = friction * problem.friction.static_coefficient()});
      return GetParam().time(varied);
    };
    double by_friction = 0.0, by_amplitude = never;
    for (int i = -4; i <= 4; ++i) {
      const double factor = std::pow(2.0, 0.5 * i), friction = slip_at(factor, 1.0),
                   share = slip_at(1.0, factor);
      EXPECT_GE(friction, by_friction);
      EXPECT_LE(share, by_amplitude);
      by_friction = friction, by_amplitude = share;
    }
    EXPECT_EQ(by_friction, never);
    EXPECT_LT(by_amplitude, period(problem.excitation));
  });
}

TEST_P(Monotonicity, SlipBeginsAtTheCriticalAmplitude) {
  if (!GetParam().critical_amplitude) return;  // the engine knows no forces but those of its own run
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = off_resonance(beam, numbers);
    const double share = GetParam().critical_amplitude(problem) / problem.excitation.amplitude();
    EXPECT_EQ(GetParam().time(with_amplitude(problem, share * (1.0 - 1e-9))), never);
    EXPECT_LT(GetParam().time(with_amplitude(problem, share * (1.0 + 1e-9))), never);
  });
}

INSTANTIATE_TEST_SUITE_P(Engines, Monotonicity, ::testing::ValuesIn(first_slips), name_of_row);

STICKSLIP_VERIFIES(CriterionOfRandomBeams, "M1");
TEST(CriterionOfRandomBeams, SlipsNoLessInALongerTime) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = with_amplitude(slipping(beam, numbers), 0.7);
    bool before = false;
    for (int i = -4; i <= 4; ++i) {
      const double duration = std::pow(2.0, 0.5 * i) * period(problem.excitation);
      const bool slips =
          analytic::evaluate_criterion(beam, problem.friction, problem.excitation, duration, 4).verdict ==
          analytic::Verdict::stick_slip;
      EXPECT_GE(slips, before);
      before = slips;
    }
  });
}

TEST(CriterionOfRandomBeams, HasTheFrictionLimitAtTheCriticalAmplitude) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = off_resonance(beam, numbers);
    const double share = critical_by_criterion(problem) / problem.excitation.amplitude();
    const auto found = analytic::evaluate_criterion(
        beam, problem.friction, with_amplitude(problem, share).excitation, period(problem.excitation), 4);
    EXPECT_TRUE(within(found.force_max.midpoint(), problem.friction.static_coefficient() * beam.axial_force(),
                       round_off(1, 1, found.friction_limit)));
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
constexpr double amplitude_change = 1e-8;

TEST(TimeShift, OfTheBaseIsThatOfTheSteppedStickBitForBit) {
  on_random_beams(30, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const double h = binary_step(problem);
    const PrescribedMotion base = smooth_start(problem.excitation);
    const solver::IntegratorSettings stepping{.time_step = h, .spectral_radius = 1.0};
    const auto bonded = solver::TipContact::bonded;
    const int delay = numbers.whole(1, 50);
    const auto now = started(problem, base, stepping, bonded),
               later = started(problem, transformed(base, 1.0, delay * h), stepping, bonded);
    while (later->steps() < delay) later->step();
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

TEST(TimeShift, OfTheBaseIsThatOfEverySteppedEvent) {
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
      while (integrator->steps() < steps + waiting) integrator->step();
      return integrator->events();
    };
    const auto expected = history(1.0, 0);
    auto computed = history(1.0, delay);
    for (data::ContactEvent& event : computed) event.time -= delay * h;
    expect_same_events(computed, expected,
                       {history(1.0 + amplitude_change, 0), amplitude_change, stepped_error,
                        problem.excitation.amplitude()});
    events += static_cast<int>(expected.size());
  });
  EXPECT_GT(events, 60);
}

// A run that is continued from q and v alone starts with another algorithmic acceleration, a share of h off,
// which costs (1/2 - alpha_f)(alpha_m - alpha_f) h^2 q_ttt in the velocity: second order, as the method.
TEST(TimeShift, SteppedRestartContinuesToSecondOrder) {
  on_random_beams(10, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    StickSlipProblem problem = slipping(beam, numbers);
    problem.damping = data::Damping({.kelvin_voigt = 0.1 / stick_frequencies(beam, 1).front()});
    const PrescribedMotion base = smooth_start(problem.excitation);
    const solver::BeamModel model(beam, mesh_elements);
    const double coarse = binary_step(problem);
    const int start = numbers.whole(20, 60);
    std::vector<double> steps, differences;
    double motion = 0.0;
    for (const int halvings : {2, 3, 4, 5}) {
      const double h = std::ldexp(coarse, -halvings);
      const long before = static_cast<long>(start) << halvings, after = 100L << halvings;
      const solver::IntegratorSettings stepping{.time_step = h, .spectral_radius = 0.5};
      const auto whole = started(problem, base, stepping, solver::TipContact::bonded);
      while (whole->steps() < before) whole->step();
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

TEST(TimeShift, OfAPeriodRestartsTheEventDrivenHistory) {
  int events = 0;
  on_random_beams(20, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const StickSlipProblem problem = slipping(beam, numbers);
    const double cycle = period(problem.excitation);
    const ContactModel model = modal_model(problem);
    const auto whole = run(model, 2.5 * cycle).events();
    const auto perturbed =
        run(modal_model(with_amplitude(problem, 1.0 + amplitude_change)), 2.5 * cycle).events();
    for (const double sign : {1.0, -1.0}) {
      const double shift = sign > 0.0 ? cycle : 1.5 * cycle;
      const EventDriven before = run(model, shift);
      const EventDriven rest = continued(model, before, sign, 2.5 * cycle - shift);
      // The events of the whole run, those before the shift as they were.
      auto computed = before.events();
      for (const data::ContactEvent& event : rest.events())
        computed.push_back({event.change, event.time + shift, sign * event.position});
      expect_same_events(computed, whole,
                         {perturbed, amplitude_change, event_driven_error, problem.excitation.amplitude()});
      events += static_cast<int>(rest.events().size());
    }
  });
  EXPECT_GT(events, 100);
}

// At P = 0 the stick state is the slip state with one constraint (Cauchy): the frequencies of the beam interlace, and all of any
// mesh.

template <class StickModes, class SlipModes, class Frequency>
void expect_interlaced(const StickModes& stick, const SlipModes& slip, Frequency frequency) {
  for (std::size_t n = 0; n < stick.size(); ++n) {
    EXPECT_LT(std::invoke(frequency, slip.at(n)), std::invoke(frequency, stick[n])) << n;
    EXPECT_LT(std::invoke(frequency, stick[n]), std::invoke(frequency, slip.at(n + 1))) << n;
  }
}

STICKSLIP_VERIFIES(Interlacing, "M2");
TEST(Interlacing, OfTheClosedFormFrequencies) {
  on_random_beams(50, no_force, [](const data::Beam& beam, RandomNumbers&) {
    expect_interlaced(analytic::stick_modes(beam, 30), analytic::slip_modes(beam, 31),
                      [](const auto& mode) { return mode.angular_frequency(); });
  });
}

TEST(Interlacing, OfAllFrequenciesOfTheMesh) {
  on_random_beams(40, no_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(2, 8);
    const solver::BeamModel model(beam, elements);
    expect_interlaced(solver::stick_modes(model, 2 * elements - 1), solver::slip_modes(model, 2 * elements),
                      &solver::FiniteElementMode::angular_frequency);
  });
}

}  // namespace
}  // namespace stickslip::testing
