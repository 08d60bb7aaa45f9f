// SPDX-License-Identifier: MIT
/// Structures that are no beam, by both implementations: random matrices in damped stick-slip, and the published problems of one
/// mass as cases.

#include <map>

#include "stickslip/analytic/held_motion.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/solver/model_system.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "support/structures.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::ContactEvent;
using studies::EventDifference;
using Changes = std::vector<ContactEvent>;

// By time steps, by the step, half and a quarter of it, from the longest to the shortest.
std::array<Changes, 3> stepped_events(const data::Case& problem) {
  std::array<Changes, 3> levels;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const double step = problem.numerics.time_step() / static_cast<double>(1U << level);
    const std::vector<double> end{problem.numerics.duration()};
    levels[level] =
        studies::finite_element_history(with_value(problem, "numerics.time_step", step), {.times = end})
            .events;
  }
  return levels;
}

bool has_mass(const data::StructureMatrices& matrices, int row) {
  return std::ranges::any_of(matrices.mass,
                             [row](const auto& entry) { return entry.row == row && entry.value > 0.0; });
}

// A contact without mass slips by time steps alone; here it has one.
void give_mass_to_contact(data::StructureMatrices& matrices) {
  for (const auto& [row, weight] : matrices.contact)
    if (!has_mass(matrices, row)) matrices.mass.push_back({row, row, 1.0});
}

// In slip for a part of each period.
data::Case slipping_case(data::StructureMatrices matrices, RandomNumbers& numbers) {
  give_mass_to_contact(matrices);
  const bool is_damped_by_case = numbers.whole(0, 2) == 0;
  if (is_damped_by_case) matrices.damping.clear();
  const double period = 1.0 / numbers.uniform(2.0, 10.0);
  data::Case problem = data::load_case("paper");
  problem.motion =
      data::HarmonicExcitation({.frequency_hz = 1.0 / period,
                                .amplitude = 1.0,
                                .amplitude_of = numbers.whole(0, 2) == 0 ? data::AmplitudeOf::force
                                                                         : data::AmplitudeOf::acceleration});
  problem = with_matrices(std::move(problem), std::move(matrices));
  if (is_damped_by_case)
    problem.damping = data::Damping({.kelvin_voigt = numbers.uniform(0.5e-3, 2e-3),
                                     .ratio = numbers.uniform(0.0, 0.02),
                                     .mass_proportional = numbers.uniform(0.0, 2.0),
                                     .ratios = {}});
  problem = with_values(problem, {{"excitation.duration", 4.0 * period},
                                  {"numerics.time_step", period / 2000.0},
                                  {"numerics.velocity_threshold", 0.0},
                                  {"numerics.modes", 200.0},
                                  {"friction.static_coefficient", 0.3},
                                  {"friction.kinetic_coefficient", numbers.uniform(0.2, 0.3)},
                                  {"friction.decay", numbers.log_uniform(1.0, 10.0)}});
  const double amplitude = problem.excitation().amplitude();
  const bool is_pulled = !problem.excitation().is_force() && numbers.whole(0, 2) == 0;
  problem.contact.wall =
      data::Wall({.speed = is_pulled ? amplitude / period : 0.0, .with_base = numbers.whole(0, 2) == 0});
  const double held = solver::steady_reaction_of(problem) * amplitude;
  problem.structure = data::Model(numbers.uniform(0.3, 0.7) * held / 0.3, problem.model()->shared_matrices());
  return problem;
}

// e = c2 h^2 + c3 h^3, where c3 depends on where in its step an event lies: extrapolated from steps of h/2 and h/4, the error is less than
// the difference to that from h and h/2, which is the error of this one, where it is largest.
void expect_extrapolated(const Changes& events, const std::array<Changes, 3>& steps) {
  for (const Changes& stepped : steps) {
    ASSERT_TRUE(std::ranges::equal(stepped, events, {}, &ContactEvent::change, &ContactEvent::change))
        << stepped.size() << " for " << events.size();
  }
  const auto compare = [&](double ContactEvent::*number, const char* name) {
    std::vector<double> expected, changes;
    double coarse = 0.0, fine = 0.0;
    for (std::size_t i = 0; i < events.size(); ++i) {
      const auto at = [&](std::size_t level) { return steps[level][i].*number; };
      const auto extrapolated = [&](std::size_t level) {
        return at(level) + (at(level) - at(level - 1)) / 3.0;
      };
      expected.push_back(extrapolated(2));
      changes.push_back(extrapolated(2) - extrapolated(1));
      coarse = std::max(coarse, std::abs(at(0) - events[i].*number));
      fine = std::max(fine, std::abs(at(1) - events[i].*number));
    }
    const Tolerance tolerance = discretisation(largest(changes), 1.0, "the extrapolation before");
    for (std::size_t i = 0; i < events.size(); ++i)
      EXPECT_TRUE(within(events[i].*number, expected[i], tolerance, name)) << i;
    EXPECT_GT(coarse, 3.5 * fine) << name;
    EXPECT_LT(coarse, 4.5 * fine) << name;
  };
  compare(&ContactEvent::time, "time");
  compare(&ContactEvent::position, "position");
}

STICKSLIP_VERIFIES(RandomStructures, "X9");
TEST(RandomStructures, SlipAlikeByBoth) {
  std::size_t events = 0;
  int singular = 0, weighted = 0, clustered = 0;
  for (const int most_rows : {6, 60})
    on_random_structures(
        10, {.most_rows = most_rows, .damping = 1.0}, [&](const auto& matrices, RandomNumbers& numbers) {
          const data::Case problem = slipping_case(matrices, numbers);
          const Changes exact =
              studies::event_driven_history(problem, {.times = {problem.numerics.duration()}}).events;
          expect_extrapolated(exact, stepped_events(problem));
          events += exact.size();
          for (int row = 2; row < matrices.rows - 1; ++row)
            if (!has_mass(matrices, row)) {
              ++singular;
              break;
            }
          weighted += matrices.contact.size() > 1;
          clustered += matrices.contact.front().row < matrices.rows - 1;  // twins come last
        });
  EXPECT_GT(events, 20U * 8U);
  EXPECT_GE(std::min({singular, weighted, clustered}), 3);
}

// Sums of sines, sweeps and shocks of the base, on a wall at rest or on the base, by events, time steps and, the sines, the boundary
// integral: the first slip, the number of changes and the travel to 0.1 %, which is asked for.
TEST(RandomStructures, FollowAnyMotionAlikeByThree) {
  constexpr double duration = 0.2;
  int slips = 0, kind = 0;
  on_random_structures(6, {.most_rows = 12, .damping = 4.0}, [&](auto matrices, RandomNumbers& numbers) {
    give_mass_to_contact(matrices);
    data::Case problem = with_values(data::load_case("paper"), {{"excitation.duration", duration},
                                                                {"numerics.time_step", 2e-5},
                                                                {"numerics.velocity_threshold", 0.0},
                                                                {"numerics.modes", 200.0},
                                                                {"friction.static_coefficient", 0.3},
                                                                {"friction.kinetic_coefficient", 0.25},
                                                                {"friction.decay", 1.0}});
    problem = with_matrices(problem, std::move(matrices));
    problem.contact.wall = data::Wall({.with_base = numbers.whole(0, 1) == 0});
    data::GeneralMotion::Statement statement;
    const auto acceleration = data::AmplitudeOf::acceleration;
    switch (kind++ % 3) {
      case 0: {
        std::vector<data::Sine> sines;
        for (int i = 0; i < 5; ++i)
          sines.push_back({numbers.uniform(3.0, 30.0), 1.0, acceleration, numbers.uniform(0.0, 6.0)});
        statement = sines;
        break;
      }
      case 1:
        statement = data::Sweep{5.0, 30.0, 60.0, false, 1.0, acceleration};
        break;
      default:
        statement = data::Shock{data::ShockShape::sawtooth, 0.05, 1.0, acceleration};
    }
    problem.motion = data::GeneralMotion(statement, duration);
    const double held = analytic::motion_reaction(problem, problem.numerics.modes()).largest().upper;
    problem.structure = data::Model(0.6 * held / 0.3, problem.model()->shared_matrices());
    std::vector<studies::History> histories;
    std::vector<double> times;
    for (int i = 1; i <= 200; ++i) times.push_back(1e-3 * i);
    for (const auto* method :
         {&studies::event_driven(), &studies::finite_elements(), &studies::boundary_integral()}) {
      if (method == &studies::boundary_integral() && statement.index() > 0) continue;
      method->require(problem);
      histories.push_back(method->run(problem, {.times = times}, {}, {}));
    }
    const auto travel = [](const studies::History& history) {
      double sum = 0.0;
      for (std::size_t i = 1; i < history.rows.size(); ++i)
        sum += std::abs(history.rows[i].tip_displacement - history.rows[i - 1].tip_displacement);
      return sum;
    };
    const studies::History& events = histories.front();
    ASSERT_TRUE(events.first_slip.has_value());
    ++slips;
    for (std::size_t i = 1; i < histories.size(); ++i) {
      EXPECT_EQ(histories[i].events.size(), events.events.size()) << i;
      EXPECT_TRUE(within(*histories[i].first_slip, *events.first_slip,
                         reference(1e-3 * duration, "0.1 % of the duration")))
          << i;
      EXPECT_TRUE(within(travel(histories[i]), travel(events), reference(1e-3 * travel(events), "0.1 %")))
          << i;
    }
  });
  EXPECT_EQ(slips, 6);
}

// The rows of a problem in `published-problems`: its changes of contact, or its states at these times.
struct Published {
  bool has_states{};
  Changes rows;
};

std::map<std::string, Published> published_problems() {
  const data::ReferenceTable table = data::read_table(data::load_reference(), "published-problems");
  const std::map<std::string, data::ContactChange> changes{{"onset", data::ContactChange::onset},
                                                           {"capture", data::ContactChange::capture},
                                                           {"reversal", data::ContactChange::reversal}};
  std::map<std::string, Published> problems;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Published& problem = problems[table.column("problem").text[row]];
    const std::string& change = table.column("change").text[row];
    problem.has_states = change == "state";
    problem.rows.push_back({.change = problem.has_states ? data::ContactChange::onset : changes.at(change),
                            .time = table.column("time").values[row],
                            .position = table.column("position").values[row]});
  }
  return problems;
}

// As many rows as published. A contact that cannot hold from the start on slips at 0, which is no published change.
Changes rows_of(const studies::History& history, const Published& published) {
  if (!published.has_states) {
    Changes events = history.events;
    std::erase_if(events, [](const ContactEvent& event) { return event.time == 0.0; });
    return events;
  }
  Changes states;
  for (const studies::HistoryRow& row : history.rows)
    states.push_back({.time = row.time, .position = row.tip_displacement});
  return states;
}

EventDifference error_of(const studies::Method& method, const data::Case& problem,
                         const Published& published) {
  std::vector<double> times{problem.numerics.duration()};
  if (published.has_states) {
    times.clear();
    for (const ContactEvent& row : published.rows) times.push_back(row.time);
  }
  method.require(problem);
  const Changes found = rows_of(method.run(problem, {.times = times}, {}, {}), published);
  EXPECT_EQ(found.size(), published.rows.size());
  return studies::largest_difference(found, published.rows, published.rows.size());
}

// The event-driven run keeps 1e-12 of each coordinate in a step. Time steps are of order 2, and exact under constant forces.
void expect_published(const std::string& name, const Published& published) {
  const double end = published.rows.back().time;
  const data::Case given = data::load_case(name);
  const data::ModelProperties& mass = given.model()->properties();
  const bool is_mass = given.model()->is_mass();
  const double forced = 2.0 * std::numbers::pi * data::highest_frequency_hz(given),
               natural = is_mass ? std::sqrt(mass.stiffness / mass.mass) : forced,
               omega = std::max(natural, forced);
  double step = 2.0 * std::numbers::pi / natural / 500.0;
  if (!is_mass) step = given.numerics.time_step();  // the pull ends with a step
  if (published.has_states) step = 0.1;
  // A little more than the last event, so that no late one is missed.
  // After a jump of the force the velocity is off by (1/2 - α_f) h times that of the acceleration, which is 0 at a spectral radius of 1.
  const data::Case problem =
      with_values(given, {{"numerics.time_step", step},
                          {"numerics.velocity_threshold", 0.0},
                          {"numerics.spectral_radius", is_mass ? given.numerics.spectral_radius() : 1.0},
                          {"excitation.duration", published.has_states ? end : end + 4.0 * step}});
  const double share = 1e-12 * (1.0 + omega * end),
               largest_position = largest(published.rows, &ContactEvent::position);
  const EventDifference by_events = error_of(studies::event_driven(), problem, published);
  EXPECT_TRUE(within(by_events.time, 0.0, discretisation(share * end, 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(by_events.position, 0.0, discretisation(share * largest_position, 1.0, "1e-12 a step")));
  const auto stepped = [&](double h) {
    return error_of(studies::finite_elements(), with_value(problem, "numerics.time_step", h), published);
  };
  const EventDifference coarse = stepped(step), fine = stepped(0.5 * step);
  if (published.has_states) {
    for (const double position : {coarse.position, fine.position})
      EXPECT_TRUE(within(position, 0.0, round_off(2.0 * end / step, 1.0, largest_position)));
    if (name == "incline-stays") {  // no creep below the friction angle, in 100 s
      EXPECT_EQ(by_events.position + coarse.position + fine.position, 0.0);
    }
    return;
  }
  EXPECT_GT(coarse.time, 3.5 * fine.time);
  EXPECT_LT(coarse.time, 4.5 * fine.time);
  EXPECT_GT(coarse.position, 3.5 * fine.position);
}

STICKSLIP_VERIFIES(PublishedCases, "F6");
TEST(PublishedCases, HaveThePublishedEvents) {
  int tried = 0;
  for (const auto& [name, published] : published_problems()) {
    SCOPED_TRACE(name);
    expect_published(name, published);
    ++tried;
  }
  EXPECT_EQ(tried, 10);
}

// The captures in a period of the force, from rest. By Hong and Liu in the fourth, and beside Den Hartog's limit in the 40th.
TEST(PublishedCases, StopAsOftenAsPublished) {
  const auto package = data::load_reference();
  const data::Case given = data::load_case("hong-liu-1");  // 10 rad/s, mu N = 5 N
  const auto expect_stops = [&](const data::ReferenceTable& table, double share, double number,
                                const auto& stops) {
    EXPECT_GT(table.rows(), 0U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double force = 5.0 * share * table.column("force_ratio").values[row];
      const double hz = 10.0 * table.column("frequency_ratio").values[row] / (2.0 * std::numbers::pi);
      const double period = 1.0 / hz, end = number * period;
      const data::Case problem =
          with_values(given, {{"excitation.frequency_hz", hz},
                              {"excitation.force", force},
                              {"excitation.duration", end},
                              {"numerics.time_step", std::min(period, 0.2 * std::numbers::pi) / 500.0},
                              {"numerics.velocity_threshold", 0.0}});
      const auto is_counted = [&](const ContactEvent& event) {
        return event.change == data::ContactChange::capture && event.time > end - period;
      };
      for (const auto* method : {&studies::event_driven(), &studies::finite_elements()}) {
        const Changes events = method->run(problem, {.times = {end}}, {}, {}).events;
        EXPECT_EQ(std::ranges::count_if(events, is_counted), stops(row))
            << method->name << ", " << hz << " Hz, " << force << " N";
      }
    }
  };
  const auto counts = data::read_table(package, "stops-per-period");
  const std::vector<double>& stops = counts.column("stops").values;
  EXPECT_EQ(std::set<double>(stops.begin(), stops.end()), (std::set<double>{0, 1, 2, 4, 6, 8}));
  expect_stops(counts, 1.0, 4, [&](std::size_t row) { return stops[row]; });
  const auto limits = data::read_table(package, "non-stop-limits");
  expect_stops(limits, 0.99, 40, [](std::size_t) { return 2; });
  expect_stops(limits, 1.01, 40, [](std::size_t) { return 0; });
}

// The mean of N |v_s| from 4 to 12 s: between two changes the mass slides one way.
double friction_power(const data::Case& problem, const studies::Method& method) {
  const studies::History history = method.run(problem, {.times = {4.0, 12.0}}, {}, {});
  double before = 0.0, path = 0.0;
  const auto slide = [&](double time, double position) {
    const double on_wall = position - problem.contact.wall_motion->displacement(time);
    if (time > 4.0) path += std::abs(on_wall - before);
    before = on_wall;
  };
  slide(4.0, history.rows.front().tip_displacement);
  for (const ContactEvent& event : history.events)
    if (event.time > 4.0) slide(event.time, event.position);
  slide(12.0, history.rows.back().tip_displacement);
  return problem.model()->normal_force() * path / 8.0;
}

// The force of a sliding mass is constant, so that time steps are as exact as the events are located.
TEST(PublishedCases, SlideOnAShakenPlaneAsPublished) {
  const data::ReferenceTable powers = data::read_table(data::load_reference(), "friction-powers");
  const data::Case given = data::load_case("sdnd104");
  for (std::size_t row = 0; row < powers.rows(); ++row) {
    const double scale = powers.column("amplitude").values[row],
                 expected = powers.column("power").values[row];
    const data::Case shaken = with_value(given, "wall.scale", scale);
    for (const auto* method : {&studies::event_driven(), &studies::finite_elements()})
      EXPECT_TRUE(within(friction_power(shaken, *method), expected,
                         discretisation(1e-10 * scale, 1.0, "1e-12 a step, some 100 steps")))
          << method->name << ", " << scale;
  }
}

// The spline of the record, its integrals and the changes against ball arithmetic: to rounding by events, to order 2 by time steps.
STICKSLIP_VERIFIES(RecordedMotion, "P8");
TEST(RecordedMotion, IsThatOfBallArithmetic) {
  const auto package = data::load_reference();
  const data::ReferenceTable motion = data::read_table(package, "record-motion"),
                             events = data::read_table(package, "record-events"),
                             history = data::read_table(package, "record-history");
  const data::Case given = with_value(data::load_case("recorded-mass"), "numerics.velocity_threshold", 0.0);
  const auto& record = std::get<data::MotionRecord>(given.general_motion()->statement());
  EXPECT_EQ(record.times, motion.column("time").values);
  EXPECT_EQ(record.samples, motion.column("acceleration").values);
  const auto errors_of = [&](const studies::Method& method, double step) {
    const studies::History run = method.run(with_value(given, "numerics.time_step", step),
                                            {.times = history.column("time").values}, {}, {});
    std::array<double, 4> errors{};
    const auto include = [&](std::size_t i, double value, double expected) {
      errors.at(i) = largest_or_nan({errors.at(i), std::abs(value - expected)});
    };
    EXPECT_EQ(run.events.size(), events.rows());
    for (std::size_t i = 0; i < std::min(run.events.size(), events.rows()); ++i) {
      EXPECT_EQ(data::to_string(run.events[i].change), events.column("change").text[i]);
      include(0, run.events[i].time, events.column("time").values[i]);
      include(1, run.events[i].position, events.column("position").values[i]);
    }
    EXPECT_EQ(run.rows.size(), history.rows());
    for (std::size_t i = 0; i < std::min(run.rows.size(), history.rows()); ++i) {
      include(2, run.rows[i].tip_displacement, history.column("tip_displacement").values[i]);
      include(3, run.rows[i].friction_force, history.column("friction_force").values[i]);
    }
    return errors;
  };
  const std::array scale{1.5, 0.12, 0.12, 15.0};  // s, m, m, N
  const auto exact = errors_of(studies::event_driven(), 1e-3);
  const auto coarse = errors_of(studies::finite_elements(), 1e-3),
             fine = errors_of(studies::finite_elements(), 0.5e-3);
  for (std::size_t i = 0; i < scale.size(); ++i) {
    EXPECT_TRUE(within(exact.at(i), 0.0, discretisation(1e-10 * scale.at(i), 1.0, "1e-12 a step"))) << i;

    EXPECT_GT(coarse.at(i), 3.5 * fine.at(i)) << i;
    EXPECT_LT(coarse.at(i), 4.5 * fine.at(i)) << i;
  }
}

}  // namespace
}  // namespace stickslip::testing
