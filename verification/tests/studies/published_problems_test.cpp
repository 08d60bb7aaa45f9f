// SPDX-License-Identifier: MIT
/// Friction problems of others, one or two masses with one contact, by both implementations against the closed forms of the data
/// sets `published-problems`, `stops-per-period` and `non-stop-limits`, which the README of data/reference states; and a friction
/// law that jumps.

#include "comparison/diagnosis/wrong_numbers.hpp"
#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/history/contact_growth.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::MassRows;
using comparison::Numbers;
using Times = std::vector<double>;

// The model as the time stepper takes it; all loads act on the contact.
solver::ContactSystem mass_system(const analytic::ContactModel& model) {
  solver::ContactSystem system = studies::contact_system(model);
  system.load_shape = Eigen::VectorXd::Unit(system.mass.rows(), system.contact);
  system.load_history = [model](double t) {
    return model.contact_force + model.load.back() * std::sin(model.load_angular_frequency * t);
  };
  return system;
}

void add_changes(MassRows& rows, const std::vector<data::ContactEvent>& events, double start) {
  for (const data::ContactEvent& event : events) {
    rows.changes.emplace_back(data::to_string(event.change));
    rows.times.push_back(start + event.time);
    rows.positions.push_back(event.position);
  }
}

// The changes of contact up to the last of the times, or the states at the times, which must be on the grid then.
MassRows step_by_step(const Numbers& numbers, bool has_states, const Times& times, double h) {
  const solver::IntegratorSettings settings{.time_step = h, .spectral_radius = 0.9};
  MassRows rows;
  const auto step_to = [&](solver::StickSlipIntegrator& run, double start, double end) {
    while (run.time() < end - start - 1e-9 * h) run.step();
  };
  const auto value = [&](const char* key) { return numbers.contains(key) ? numbers.at(key) : 0.0; };
  const analytic::ContactModel model = comparison::mass_model(numbers, value("pull.force"));
  const solver::ContactSystem system = mass_system(model);
  solver::StickSlipIntegrator run(system, settings);
  const auto size = system.mass.rows();
  const Eigen::VectorXd contact = Eigen::VectorXd::Unit(size, system.contact);
  Eigen::VectorXd stretch = Eigen::VectorXd::Zero(size);
  if (size > 1) stretch[0] = value("pull.force") / value("coupling") * std::sqrt(value("other_mass"));
  if (comparison::is_held(model, value("position"), value("velocity")))
    run.start_stuck(value("position") * contact - stretch, 0.0 * contact);
  else
    run.start_slipping(value("position") * contact - stretch, value("velocity") * contact);
  for (const double t : size > 1 ? Times{value("pull.until")} : times) {
    step_to(run, 0.0, t);
    if (has_states) rows.positions.push_back(run.displacement()[system.contact]);
  }
  if (!has_states) add_changes(rows, run.events(), 0.0);
  if (size == 1) return rows;
  solver::StickSlipIntegrator on(mass_system(comparison::mass_model(numbers)), settings);
  on.start_slipping(run.displacement() + stretch, run.velocity());
  step_to(on, run.time(), times.back());
  add_changes(rows, on.events(), run.time());
  return rows;
}

/// The largest errors over the published rows, s and m; as many changes of the same kinds are expected.
std::pair<double, double> errors_of(const MassRows& found, const MassRows& published) {
  std::pair<double, double> error;
  EXPECT_GE(found.positions.size(), published.positions.size());
  for (std::size_t i = 0; i < std::min(found.positions.size(), published.positions.size()); ++i) {
    error.second = largest_or_nan({error.second, std::abs(found.positions[i] - published.positions[i])});
    if (published.changes[i] == "state") continue;
    EXPECT_EQ(found.changes[i], published.changes[i]) << i;
    error.first = largest_or_nan({error.first, std::abs(found.times[i] - published.times[i])});
  }
  return error;
}

// So many of a period of the force, or of the spring if that is shorter; 0.1 s on an incline.
double time_step_of(const Numbers& numbers) {
  if (numbers.contains("gravity")) return 0.1;
  if (!numbers.contains("force.angular_frequency")) return 1e-3;
  return 2.0 * std::numbers::pi / std::max(numbers.at("force.angular_frequency"), 10.0) / 500.0;
}

// The event-driven run keeps 1e-12 of each coordinate in a step. The time stepper is of second order.
void expect_rows(const Numbers& numbers, const std::string& name, const MassRows& rows) {
  const bool has_states = rows.changes.front() == "state";
  const double time_step = time_step_of(numbers);
  double largest = 0.0;
  for (const double position : rows.positions) largest = std::max(largest, std::abs(position));
  // A little more than the last event, so that no late one is missed.
  const Times times = has_states ? rows.times : Times{rows.times.back() + 4.0 * time_step};
  const analytic::ContactModel model = comparison::mass_model(numbers);
  const double natural = model.modes() > 0 ? model.angular_frequency[0]
                                           : std::sqrt(model.contact_stiffness / model.contact_mass);
  const double share = 1e-12 * (1.0 + std::max(natural, model.load_angular_frequency) * rows.times.back());
  const auto events = comparison::mass_rows(numbers, rows);
  ASSERT_TRUE(events);
  const auto exact = errors_of(*events, rows);
  EXPECT_TRUE(within(exact.first, 0.0, discretisation(share * rows.times.back(), 1.0, "1e-12 a step")));
  EXPECT_TRUE(within(exact.second, 0.0, discretisation(share * largest, 1.0, "1e-12 a step")));
  std::vector<std::pair<double, double>> stepped;
  for (int level = 0; level < 3; ++level) {
    const double h = std::ldexp(time_step, -level);
    stepped.push_back(errors_of(step_by_step(numbers, has_states, times, h), rows));
    const auto& [time, position] = stepped.back();
    if (has_states) {  // constant forces: exact but for the rounding of 10 to 200 steps
      EXPECT_TRUE(within(position, 0.0, round_off(100.0 / h, 1, largest)));
    } else if (level > 0) {
      const auto& [longer_time, longer_position] = stepped[stepped.size() - 2];
      EXPECT_GT(longer_time, 3.5 * time);
      EXPECT_LT(longer_time, 4.5 * time);
      EXPECT_GT(longer_position, 3.5 * position);
    }
  }
  if (name == "incline-stays") {  // no creep below the friction angle, in 100 s
    EXPECT_EQ(exact.second, 0.0);
    for (const auto& run : stepped) EXPECT_EQ(run.second, 0.0);
  }
}

STICKSLIP_VERIFIES(PublishedProblems, "F6");
TEST(PublishedProblems, AreSolvedByBoth) {
  const data::ReferenceTable table = data::read_table(data::load_reference(), "published-problems");
  std::size_t tried = 0;
  for (std::size_t row = 0; row < table.rows(); ++tried) {
    const std::string name = table.column("problem").text[row];
    MassRows rows;
    for (; row < table.rows() && table.column("problem").text[row] == name; ++row) {
      rows.changes.push_back(table.column("change").text[row]);
      rows.times.push_back(table.column("time").values[row]);
      rows.positions.push_back(table.column("position").values[row]);
    }
    SCOPED_TRACE(name);
    expect_rows(comparison::numbers_of_mass(table.resource, "problem = " + name), name, rows);
  }
  EXPECT_EQ(tried, 10U);
}

// The captures in a period of the force, from rest. By Hong and Liu in the fourth, and beside Den Hartog's limit in the 40th.
TEST(PublishedProblems, StopAsOftenAsPublished) {
  const auto package = data::load_reference();
  const auto expect_stops = [](const data::ReferenceTable& table, double share, double number,
                               const auto& stops) {
    EXPECT_GT(table.rows(), 0u);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double force = share * table.column("force_ratio").values[row];
      const double frequency = table.column("frequency_ratio").values[row];
      const Numbers ratios{{"force_ratio", force}, {"frequency_ratio", frequency}, {"period", number}};
      EXPECT_EQ(comparison::mass_value(ratios, "stops"), stops(row)) << frequency << ", " << force;
      const Numbers numbers{{"stiffness", 1.0},
                            {"friction_force", 1.0},
                            {"force.amplitude", force},
                            {"force.angular_frequency", frequency}};
      const double period = 2.0 * std::numbers::pi / frequency, end = number * period;
      const MassRows rows =
          step_by_step(numbers, false, {end}, std::min(period, 2.0 * std::numbers::pi) / 500.0);
      int captures = 0;
      for (std::size_t i = 0; i < rows.changes.size(); ++i)
        if (rows.changes[i] == "capture" && rows.times[i] > end - period) ++captures;
      EXPECT_EQ(captures, stops(row)) << frequency << ", " << force;
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

constexpr data::FrictionCoefficients jumping{
    .static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = std::numeric_limits<double>::infinity()};

STICKSLIP_VERIFIES(JumpOfFriction, "P2");
TEST(JumpOfFriction, IsTheLimitOfEverFasterDecay) {
  const data::FrictionLaw law = data::FrictionLaw(jumping).in_slip();
  for (const double v : {0.0, 1e-300, 1.0}) EXPECT_EQ(solver::friction_coefficient(law, v), 0.2);
  data::FrictionCoefficients fast = jumping;
  fast.decay = 1e6;
  EXPECT_DOUBLE_EQ(solver::friction_coefficient(data::FrictionLaw(fast), 1.0), 0.2);
  EXPECT_EQ(data::FrictionLaw(fast).in_slip().decay(), 1e6);
  EXPECT_EQ(studies::weakening(data::FrictionLaw(jumping), 10.0), 0.0);  // nothing grows in slip
}

TEST(JumpOfFriction, IsRefusedByUniqueSteps) {
  EXPECT_THROW(analytic::require_unique_step({10.0, data::FrictionLaw(jumping)}, 1e-9), data::FieldError);
}

// A spring of 4 N/m at 0.3 m and a force of 3 N leave 1.8 N, less than mu_s N = 2 N; at 0.2 and 1.3 m 2.2 N of either sign.
TEST(PublishedProblems, HoldWhatTheSpringLeaves) {
  analytic::ContactModel model =
      contact_model({.stiffness = 4.0,
                     .normal_force = 10.0,
                     .friction = {.static_coefficient = 0.2, .kinetic_coefficient = 0.2}});
  model.contact_force = 3.0;
  for (const auto& [position, holds] : {std::pair{0.3, true}, {1.2, true}, {0.2, false}, {1.3, false}})
    EXPECT_EQ(comparison::is_held(model, position, 0.0), holds) << position;
  EXPECT_FALSE(comparison::is_held(model, 0.3, 1e-9));
}

}  // namespace
}  // namespace stickslip::testing
