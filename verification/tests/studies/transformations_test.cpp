// SPDX-License-Identifier: MIT
/// Transformations of a problem that must change the answers of every engine in a known way, and theorems, whatever the beam is.

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

EventDriven run(const ContactModel& model, double end) {
  EventDriven history(model);
  history.advance_to(end);
  return history;
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
constexpr double amplitude_change = 1e-8;

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

// Betti's reciprocity: kept in stick, and lost in slip by what the follower force does.

/// (K - omega^2 M)^-1.
Eigen::MatrixXd flexibility(const solver::BeamModel& model, const solver::SparseMatrix& stiffness,
                            double omega) {
  return Eigen::MatrixXd(stiffness - omega * omega * model.mass()).inverse();
}

double random_angular_frequency(RandomNumbers& numbers, const data::Beam& beam) {
  return 2.0 * pi * random_frequency_hz(numbers, stick_frequencies(beam, 4), 0.05);
}

STICKSLIP_VERIFIES(Reciprocity, "M2");
// A force at a, with the tip held, moves b as far as the same force at b moves a.
TEST(Reciprocity, HoldsInStickAtRestAndInVibration) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(3, 8);
    const solver::BeamModel model(beam, elements);
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
TEST(Reciprocity, LossInSlipIsThatOfTheFollowerForce) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(3, 8);
    const solver::BeamModel model(beam, elements);
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

}  // namespace
}  // namespace stickslip::testing
