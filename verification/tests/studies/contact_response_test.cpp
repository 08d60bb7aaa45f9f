// SPDX-License-Identifier: MIT
/// What maps and sweeps say of a motion in fixed steps. The battery of beams (history_test.cpp) has the run itself.

#include "studies/analyses/contact_response.hpp"

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/analyses/slip_readouts.hpp"
#include "studies/history/method.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::ContactModes;
using analytic::ModalContactRun;

data::Case case_with_step(const std::string& name, double frequency_hz, double amplitude, double step,
                          double duration, int modes) {
  data::Case problem = data::load_case(name);
  problem.motion = data::HarmonicExcitation({.frequency_hz = frequency_hz, .amplitude = amplitude});
  problem.numerics = data::NumericalSettings({.elements = problem.numerics.elements(),
                                              .time_step = step,
                                              .spectral_radius = problem.numerics.spectral_radius(),
                                              .modes = modes,
                                              .duration = duration});
  return problem;
}

// Of the damped case at 25 Hz and 1 mm; duration and transient in s.
data::Case damped_at_25_hz(double step, double duration, int modes = 10) {
  return case_with_step("damped", 25.0, 1e-3, step, duration, modes);
}

// Events and forces of the event-driven run, which shares nothing of the scheme, from `start` on.
template <typename Sample>
analytic::EventDriven event_driven(const data::Case& problem, double start, int samples, Sample&& sample) {
  analytic::EventDriven run(studies::response_model(problem), {.keep_energy_balance = true});
  run.advance_to(start);
  for (int n = 1; n <= samples; ++n) {
    run.advance_to(std::lerp(start, problem.numerics.duration(), static_cast<double>(n) / samples));
    sample(run);
  }
  return run;
}

int captures_after(const analytic::EventDriven& run, double start) {
  return static_cast<int>(std::ranges::count_if(run.events(), [start](const auto& event) {
    return event.time >= start && event.change == data::ContactChange::capture;
  }));
}

STICKSLIP_VERIFIES(FixedSteps, "D5");
// A mass of 1 kg on a spring: its velocity per unit force after a step h is W = sin(omega h)/omega. N (mu_s - mu_m) = 1 N.
TEST(FixedSteps, AreRefusedWhereTheyAreTooLong) {
  constexpr double omega = 2.0, step = 2.0 * std::numbers::pi / 64.0;
  const auto model = [&](double fall) {
    return contact_model({.stiffness = omega * omega,
                          .normal_force = 10.0,
                          .friction = {.static_coefficient = 0.2,
                                       .kinetic_coefficient = 0.1,
                                       .decay = fall * omega / std::sin(omega * step)}});
  };
  const ContactModes modes(model(0.0));
  EXPECT_NO_THROW(ModalContactRun(modes, model(1.999), 64));
  EXPECT_THROW(ModalContactRun(modes, model(2.001), 64), data::InputError);
  EXPECT_NO_THROW(ModalContactRun(modes, model(0.0), 4));
  EXPECT_THROW(ModalContactRun(modes, model(0.0), 3), std::invalid_argument);
  auto on_a_belt = model(0.0);
  on_a_belt.wall_speed = 1.0;
  EXPECT_THROW(ModalContactRun(modes, on_a_belt, 4), data::FieldError);
}

STICKSLIP_VERIFIES(MotionQuantities, "D5");
// Event by event, over the same eight periods.
TEST(MotionQuantities, AreThoseOfEvents) {
  const data::Case problem = damped_at_25_hz(2.5e-5, 0.4, 20);
  const studies::ContactResponse response = studies::contact_response(problem, 0.08);
  constexpr int samples = 32000;
  double squares = 0.0, peak = 0.0, travel = 0.0, slip = 0.0, force = 0.0;
  analytic::EventDriven before(studies::response_model(problem), {.keep_energy_balance = true});
  before.advance_to(0.08);
  const auto run = event_driven(problem, 0.08, samples, [&](const analytic::EventDriven& now) {
    const double speed = std::abs(now.sliding_velocity());
    squares += speed * speed / samples;
    peak = std::max(peak, speed);
    travel += speed * 0.04 / samples;
    slip += speed > 0.0 ? 1.0 / samples : 0.0;
    force = std::max(force, std::abs(now.friction_force()));
  });
  const double work = (run.energy_balance().friction_loss - before.energy_balance().friction_loss) / 8.0;
  EXPECT_TRUE(response.slips);
  // Of the 1600 steps of a period each change is off by up to one; what is smooth by (omega h)^2 of mode 4.
  const std::tuple<double, double, double> rows[] = {
      {response.values.slip_share, slip, response.changes.slip_share},
      {response.values.peak_speed, peak, 1e-3},
      {response.values.rms_speed, std::sqrt(squares), 1e-3},
      {response.values.travel, travel, 1e-3},
      {response.values.work, work, 1e-3},
      {response.values.largest_force, force, 1e-3}};
  for (const auto& [value, expected, relative] : rows)
    EXPECT_TRUE(within(value, expected, discretisation(relative * expected, 1.0, "(omega h)^2")));
  EXPECT_DOUBLE_EQ(response.values.sticks, captures_after(run, 0.08) / 8.0);
}

// While the tip sticks, the force is that of the closed form: over two periods the least is the largest in magnitude at 15 Hz,
// and the greatest at 110 Hz.
TEST(MotionQuantities, CountTheForceOfEitherSign) {
  constexpr double amplitude = 1e-5;
  for (const double hz : {15.0, 110.0}) {
    const double step = 1e-3 / hz;
    const data::Case problem = case_with_step("damped", hz, amplitude, step, 2.0 / hz, 10);
    const analytic::DampedForce force(
        analytic::damped_reaction(analytic::held_structure(problem, 10), analytic::SteadyPart::exact),
        studies::angular_frequency(problem.excitation()), 1.0);
    double least = 0.0, greatest = 0.0;
    for (int i = 1; i <= 2000; ++i) {
      least = std::min(least, amplitude * force.value(i * step));
      greatest = std::max(greatest, amplitude * force.value(i * step));
    }
    ASSERT_GT(std::abs(least + greatest), 0.1 * greatest);
    const double largest = std::max(-least, greatest);
    EXPECT_TRUE(within(studies::contact_response(problem, 0.0).values.largest_force, largest,
                       discretisation(1e-3 * largest, 1.0, "the scheme at 1000 steps a period")));
  }
}

TEST(MotionQuantities, TellPeriodsApart) {
  const auto samples = [](const std::vector<double>& cycle) {
    std::vector<std::vector<std::complex<double>>> result;
    for (int n = 0; n < 48; ++n) result.push_back({cycle[static_cast<std::size_t>(n) % cycle.size()], 1.0});
    return result;
  };
  EXPECT_EQ(studies::period_of(samples({1.0})), 1);
  EXPECT_EQ(studies::period_of(samples({1.0, 1.1})), 2);
  EXPECT_EQ(studies::period_of(samples({1.0, 1.1, 1.0, 1.2})), 4);
  EXPECT_EQ(studies::period_of(samples({1.0, 1.0005})), 1);
  EXPECT_EQ(studies::period_of(samples({1.0, 1.0017})), 2);  // 1.2e-3 of the norm
  EXPECT_EQ(studies::period_of(samples({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16})), 16);
  auto few = samples({1.0, 1.1});
  few.resize(4);
  EXPECT_EQ(studies::period_of(few), 2);
  few.resize(3);
  EXPECT_EQ(studies::period_of(few), 0);
  // A free vibration of 5/7 of the frequency that loses 5 % or 2.3 % in 7 periods is none of period 7: 1 % of the
  // difference of two samples is 2 sin(5 pi/7) = 1.56 % of its amplitude.
  for (const double loss : {0.05, 0.023, 0.012}) {
    std::vector<std::vector<std::complex<double>>> decaying;
    for (int n = 0; n < 48; ++n)
      decaying.push_back({1.0 + 5e-3 * std::exp(std::complex(-loss, 10.0 * std::numbers::pi) * (n / 7.0))});
    EXPECT_EQ(studies::period_of(decaying), loss > 0.0157 ? 0 : 7);
  }
  EXPECT_EQ(studies::period_of(samples({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17})), 0);
}

TEST(MotionQuantities, NeedTwoPeriods) {
  const data::Case problem = damped_at_25_hz(1e-4, 0.2);
  const studies::ResponseGrid grid = studies::response_grid(problem, 0.05);
  EXPECT_EQ(grid.steps_per_period, 400);
  EXPECT_EQ(grid.transient, 2);
  EXPECT_EQ(grid.recorded, 2);
  EXPECT_EQ(studies::response_grid(problem, 0.12).recorded, 2);
  EXPECT_THROW((void)studies::response_grid(problem, 0.13), data::FieldError);
  // 2e8 steps in a period of 0.04 s.
  const auto steps = [](double step) { return studies::steps_per_period(damped_at_25_hz(step, 0.19)); };
  EXPECT_EQ(steps(0.04), 32);
  EXPECT_EQ(steps(2e-10), 200000000);
  EXPECT_THROW((void)steps(1.99e-10), data::FieldError);
}

// The halves of a record, and the record on twice the step, are what other runs record.
TEST(MotionQuantities, ErrorIsASpread) {
  const auto response = [](double step, double duration, double transient) {
    return studies::contact_response(damped_at_25_hz(step, duration), transient);
  };
  const auto whole = response(1e-4, 0.4, 0.08), first = response(1e-4, 0.24, 0.08),
             second = response(1e-4, 0.4, 0.24), coarse = response(2e-4, 0.4, 0.08);
  for (const auto& q : studies::motion_quantities) {
    const auto [least, largest] =
        std::minmax({whole[q].value, first[q].value, second[q].value, coarse[q].value});
    // Each slip of a period begins and ends within a step, of which it has 400.
    const double resolution = q.name == "slip-share" ? whole.values.sticks / 400.0 : 0.0;
    const double spread = largest - least + resolution;
    EXPECT_NEAR(whole[q].change,
                q.name == "period" ? (spread > 0.0 || least == 0.0 ? 1.0 : 0.0)
                : spread == 0.0    ? 0.0
                                   : std::min(spread / largest, 1.0),
                1e-12)
        << q.name;
  }
}

// Of a realisation of a spectrum, against the read-outs of the event-driven run. The law is of second order in the step h, so that the run
// with h/2 is off by a third of what it differs from the run with h; slip begins and ends in a step, for how many of which there is one
// more or less. The places are those of a row.
TEST(MotionQuantities, OfAnyMotionAreThoseOfEvents) {
  const auto problem = [](const std::string& step) {
    return data::load_case(
        "rough-road",
        {{"excitation.scale", "3"}, {"excitation.duration", "20"}, {"numerics.time_step", step}});
  };
  const auto values = studies::contact_response(problem("5e-5"), 0.0).values,
             coarse = studies::contact_response(problem("1e-4"), 0.0).values;
  const auto history = studies::event_driven_history(problem("1e-4"), {.with_midspan = false}, {}, {});
  const auto events = studies::slip_readouts(problem("1e-4"), history, {});
  double least = history.rows.front().tip_displacement, largest = least;
  for (const auto& row : history.rows) {
    least = std::min(least, row.tip_displacement);
    largest = std::max(largest, row.tip_displacement);
  }
  EXPECT_NEAR(values.slip_rate, events.slip_rate.value, 1.5 / 20.0);
  EXPECT_TRUE(
      within(values.slip_share, events.slip_share.value,
             discretisation(static_cast<double>(events.slips) * 5e-5 / 20.0, 1.0, "a step for each slip")));
  for (const auto& [quantity, by_events] :
       {std::pair{&studies::MotionValues::travel_rate, events.travel_rate.value},
        {&studies::MotionValues::power, events.friction_power.value},
        {&studies::MotionValues::peak_to_peak, largest - least},
        {&studies::MotionValues::distance_95, events.distance_95},
        {&studies::MotionValues::distance_99, events.distance_99}})
    EXPECT_TRUE(
        within(values.*quantity, by_events,
               discretisation(std::abs(values.*quantity - coarse.*quantity), 1.0, "second order, a third")));
}

// Event by event the tip sticks for less than the step of two runs, which find no stick at 1.5 mm, or never, at 1.6 mm. They say which
// of both they cannot tell, and the share of slip to a step for each slip.
TEST(MotionQuantities, DoubtShortSticks) {
  for (const auto& [hz, amplitude, sticks] :
       {std::tuple{36.0, 1.5e-3, true}, {36.0, 1.6e-3, false}, {32.0, 1.5e-3, true}}) {
    const data::Case problem = case_with_step("damped", hz, amplitude, 1e-4, 3.0, 10);
    const auto response = studies::contact_response(problem, 1.5);
    int slipping = 0;
    const auto run = event_driven(problem, 1.5, 30000, [&](const analytic::EventDriven& now) {
      slipping += now.state() == data::ContactState::slip ? 1 : 0;
    });
    EXPECT_EQ(captures_after(run, 1.5) > 0, sticks);
    EXPECT_TRUE(response.values.sticks > 0.0 || (response.changes.sticks > 0.0) == sticks) << hz;
    EXPECT_TRUE(within(response.values.slip_share, slipping / 30000.0,
                       discretisation(response.changes.slip_share * response.values.slip_share, 1.0,
                                      "a step for each slip")));
  }
}

// Free vibrations have not decayed after 1.5 s; after 20 s the motion has a period, which is that of the event-driven run.
TEST(MotionQuantities, HaveAPeriodOnceSettled) {
  for (const double duration : {3.0, 40.0}) {
    const data::Case problem = case_with_step("damped", 24.0, 9e-4, 1e-4, duration, 10);
    const auto response = studies::contact_response(problem, 0.5 * duration);
    EXPECT_EQ(response.values.period > 0.0, duration == 40.0);
    EXPECT_EQ(response.changes.period, duration == 40.0 ? 0.0 : 1.0);
  }
}

TEST(MotionQuantities, SeeASlipOfTheStartAlone) {
  const auto at = [](double amplitude) { return case_with_step("damped", 60.0, amplitude, 1e-4, 4.0, 10); };
  const double amplitude = 1.1 * analytic::evaluate_criterion(at(1e-4)).critical_amplitude.upper;
  EXPECT_TRUE(studies::contact_response(at(amplitude), 0.0).slips);
  EXPECT_FALSE(studies::contact_response(at(amplitude), 2.0).slips);
}

// Without damping stick and slip alternate ever faster the shorter the step is: the number of sticks has no limit, and
// the map says so.
TEST(MotionQuantities, SayThatTheyHaveNotConverged) {
  EXPECT_FALSE(studies::contact_response(case_with_step("damped", 25.0, 1e-6, 1e-4, 0.2, 10), 0.08).slips);
  const auto response = [](double step) {
    return studies::contact_response(case_with_step("paper", 25.0, 1e-3, step, 2.0, 20), 1.0);
  };
  for (const double step : {1e-4, 5e-5}) {
    EXPECT_EQ(response(step).values.period, 0.0);
    EXPECT_GT(response(step).changes.sticks, 1.0 / 25.0);  // more than a stick in a second
  }
}

// One set of modes serves all cells where no axis changes the modes, and only there. A buckled beam has no motion.
TEST(MotionQuantities, AreMappedWithOwnModes) {
  studies::MapTask task{.problem = case_with_step("damped", 25.0, 1e-3, 1e-4, 0.2, 10),
                        .x = studies::map_axis("excitation.frequency_hz", 25.0, 26.0, 2, false),
                        .y = {},
                        .quantities = {&studies::motion_quantity("work")},
                        .transient = 0.08};
  for (const auto& [parameter, from, to] : {std::tuple{std::string_view("damping.ratio"), 0.0, 0.02},
                                            {"beam.axial_direction", 0.0, 1.0},
                                            {"beam.length", 1.9, 2.0},
                                            {"friction.kinetic_coefficient", 0.3, 0.5},
                                            {"beam.axial_force", 500.0, 1e5}}) {
    task.y = studies::map_axis(parameter, from, to, 2, false);
    const auto cells = studies::criterion_map(task).cells;
    ASSERT_EQ(cells.size(), 4u);
    for (const auto& cell : cells) {
      if (cell.y == 1e5) {
        EXPECT_FALSE(cell.state);
        EXPECT_TRUE(cell.response.empty());
        continue;
      }
      const auto point = data::with_value(data::with_value(task.problem, "excitation.frequency_hz", cell.x),
                                          parameter, cell.y);
      const auto response = studies::contact_response(point, 0.08);
      EXPECT_EQ(cell.response.at(0).value, response.values.work);
      EXPECT_EQ(cell.state, response.slips ? analytic::Verdict::stick_slip : analytic::Verdict::stick);
      EXPECT_TRUE(response.slips || parameter != "damping.ratio");
    }
  }
}

// A sweep of the amplitude of the damped case, from its first value.
studies::SweepTask sweep(double frequency_hz, const std::vector<double>& amplitudes, int settle,
                         int periods) {
  return {.problem = case_with_step("damped", frequency_hz, amplitudes.front(), 1e-4, 10.0, 10),
          .parameter = "excitation.amplitude",
          .values = amplitudes,
          .direction = studies::SweepDirection::up,
          .settle = settle,
          .periods = periods};
}

STICKSLIP_VERIFIES(ParameterSweep, "D5");
// At 25 Hz the base meets the first held mode, and a small amplitude makes the tip slip with three times the period. The
// event-driven run, which shares nothing of the scheme, has the same three points.
TEST(ParameterSweep, FindsAMotionOfPeriodThree) {
  const studies::SweepTask task = sweep(25.0, {3e-4}, 120, 30);
  const auto points = studies::parameter_sweep(task);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].period, 3);
  data::Case problem = task.problem;
  problem.numerics = data::NumericalSettings(paper_choices(0.04 * 126));
  std::vector<double> positions;
  const auto run = event_driven(problem, 0.04 * 120, 6, [&](const analytic::EventDriven& now) {
    positions.push_back(now.contact_position());
    // Up to 10 m/s^2 for a step make 1e-3 m/s; the force is a mean over the step before.
    const auto& point = points[0].section[positions.size() - 1];
    EXPECT_TRUE(within(point.sliding_velocity, now.sliding_velocity(), discretisation(1e-3, 2.0, "a step")));
    EXPECT_TRUE(within(point.friction_force, -now.friction_force(), discretisation(1.0, 2.0, "half a step")));
  });
  const auto [lowest, highest] = std::ranges::minmax(positions);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_LT(std::abs(positions[n + 3] - positions[n]), 1e-3 * (highest - lowest));
    EXPECT_GT(std::abs(positions[n + 1] - positions[n]), 1e-3 * (highest - lowest));
    EXPECT_TRUE(within(points[0].section[n].tip_displacement, positions[n],
                       discretisation(2e-3 * (highest - lowest), 5.0, "the error at 1e-4 s")));
  }
}

TEST(ParameterSweep, GoesOnAsOneRun) {
  const auto next = studies::parameter_sweep(sweep(25.0, {1e-3, 1e-3}, 4, 3)).at(1).section;
  const auto alone = studies::parameter_sweep(sweep(25.0, {1e-3}, 11, 3)).at(0).section;
  for (std::size_t n = 0; n < 3; ++n) {
    // The law is solved to 1.25e-9 of the falling part, in each of 400 steps of a period; motions of 1 mm, 0.1 m/s and 300 N.
    const double solved = 1.25e-9 * 400.0;
    EXPECT_TRUE(within(next[n].tip_displacement, alone[n].tip_displacement,
                       discretisation(solved * 1e-3, 2.0, "law")));
    EXPECT_TRUE(within(next[n].sliding_velocity, alone[n].sliding_velocity,
                       discretisation(solved * 0.1, 2.0, "law")));
    EXPECT_TRUE(
        within(next[n].friction_force, alone[n].friction_force, discretisation(solved * 300.0, 2.0, "law")));
  }
}

// The tip that sticks goes on to stick until its steady force reaches mu_s P, at 1.34 mm, and begins to slide soon after. The
// one that slides goes on at a smaller amplitude, because friction falls with the velocity.
TEST(ParameterSweep, ShowsHysteresis) {
  studies::SweepTask task = sweep(35.0, {1.1e-3, 1.25e-3}, 150, 16);
  const data::Case& problem = task.problem;
  const double largest_stuck =
      studies::friction_limit(problem) /
      analytic::DampedForce(
          analytic::damped_reaction(analytic::held_structure(problem, 10), analytic::SteadyPart::exact),
          2.0 * std::numbers::pi * 35.0, 10.0)
          .steady_amplitude();
  task.values.insert(task.values.end(), {0.97 * largest_stuck, 1.1 * largest_stuck});
  task.direction = studies::SweepDirection::both;
  const auto points = studies::parameter_sweep(task);
  ASSERT_EQ(points.size(), 8u);
  const auto slides = [](const studies::SweepPoint& point) {
    return point.section.back().tip_displacement > 5e-3;
  };
  for (std::size_t up = 0; up <= 3; ++up) {
    EXPECT_TRUE(points[up].up);
    EXPECT_EQ(slides(points[up]), up == 3) << up;
    if (up < 3) {  // in a step of a stick the velocity is zero at the ends only
      EXPECT_NEAR(points[up].section.front().tip_displacement, points[up].section.back().tip_displacement,
                  1e-8)
          << up;
    }
    EXPECT_EQ(points[7 - up].value, points[up].value);
    EXPECT_EQ(slides(points[7 - up]), up > 0) << up;
  }
  for (std::size_t down = 4; down <= 6; ++down) EXPECT_EQ(points[down].period, 1);
}

TEST(ParameterSweep, CountsHysteresis) {
  bool slips = true;
  const auto point = [&](bool up, double value, double least, double largest) {
    return studies::SweepPoint{.up = up,
                               .value = value,
                               .section = {{.friction_force = least}, {.friction_force = largest}},
                               .period = 2,
                               .slips = slips && !up};
  };
  // Of 200 N: 1 N is less than 1 %, 3 N more, in either force.
  const auto count = [&](double least, double largest) {
    return studies::hysteresis_of({point(true, 1.0, -200.0, 100.0), point(true, 2.0, 10.0, 200.0),
                                   point(false, 2.0, 11.995, 199.0), point(false, 1.0, least, largest)});
  };
  for (const auto& [least, largest, moving] :
       {std::tuple{-200.0, 100.0, 0u}, {-199.0, 101.0, 0u}, {-197.0, 100.0, 1u}, {-200.0, 103.0, 1u}})
    EXPECT_EQ(count(least, largest).moving, moving);
  EXPECT_EQ(count(-200.0, 103.0).resting, 0u);
  slips = false;
  EXPECT_EQ(count(-200.0, 103.0).moving, 0u);
  EXPECT_EQ(count(-200.0, 103.0).resting, 1u);
}

}  // namespace
}  // namespace stickslip::testing
