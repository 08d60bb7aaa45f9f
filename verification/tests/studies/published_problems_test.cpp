// SPDX-License-Identifier: MIT
/// Friction problems of others, one or two masses with one contact, by both implementations against the closed forms of the data
/// sets `published-problems`, `stops-per-period` and `non-stop-limits`, which the README of data/reference states; and a friction
/// law that jumps.

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/history/contact_growth.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using Times = std::vector<double>;

// By the keys of the problem, such as "force.amplitude"; data/reference/README.md has the equations.
using Numbers = std::map<std::string, double>;

double number(const Numbers& numbers, const std::string& key, double otherwise = 0.0) {
  const auto found = numbers.find(key);
  return found == numbers.end() ? otherwise : found->second;
}

// One mass on a wall, a block on an incline, or a mass from which another one hangs on a spring, x2 = x1 + F/k +
// T/sqrt(m2), while F = `pull` (N) acts on the contact.
analytic::ContactModel mass_model(const Numbers& numbers, double pull = 0.0) {
  const auto of = [&](const char* key, double otherwise) { return number(numbers, key, otherwise); };
  const double mass = of("mass", 1.0), gravity = of("gravity", 0.0), slope = of("slope", 0.0);
  const double weight = mass * gravity / std::hypot(1.0, slope), kinetic = of("kinetic_coefficient", 1.0);
  analytic::ContactModel model;
  model.contact_mass = mass;
  model.contact_stiffness = of("stiffness", 0.0);
  model.load = {of("force.amplitude", 0.0)};
  model.load_angular_frequency = of("force.angular_frequency", 1.0);
  model.contact_force = slope * weight + pull;
  data::FrictionCoefficients friction{.static_coefficient = of("static_coefficient", kinetic),
                                      .kinetic_coefficient = kinetic};
  if (friction.static_coefficient != kinetic) friction.decay = std::numeric_limits<double>::infinity();
  model.friction = data::FrictionLaw(friction);
  model.normal_force = gravity > 0.0 ? weight : of("friction_force", of("normal_force", 0.0));
  if (numbers.contains("other_mass")) {
    const double other = numbers.at("other_mass");
    model.angular_frequency = {std::sqrt(numbers.at("coupling") / other)};
    model.mass_coupling = {std::sqrt(other)};
    model.contact_mass = mass + other;
    model.follower = {0.0};
    model.load = {0.0, model.load[0]};
  }
  return model;
}

// Whether a contact with this position (m) and velocity (m/s) rests, and friction can hold it.
bool is_held(const analytic::ContactModel& model, double position, double velocity) {
  return velocity == 0.0 && std::abs(model.contact_stiffness * position - model.contact_force) <=
                                model.friction.static_coefficient() * model.normal_force;
}

// Changes of contact, or states at given times.
struct MassRows {
  std::vector<std::string> changes;
  std::vector<double> times, positions;
};

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
  const analytic::ContactModel model = mass_model(numbers, number(numbers, "pull.force"));
  const solver::ContactSystem system = mass_system(model);
  solver::StickSlipIntegrator run(system, settings);
  const auto size = system.mass.rows();
  const Eigen::VectorXd contact = Eigen::VectorXd::Unit(size, system.contact);
  Eigen::VectorXd stretch = Eigen::VectorXd::Zero(size);
  if (size > 1)
    stretch[0] = number(numbers, "pull.force") / number(numbers, "coupling") *
                 std::sqrt(number(numbers, "other_mass"));
  if (is_held(model, number(numbers, "position"), number(numbers, "velocity")))
    run.start_stuck(number(numbers, "position") * contact - stretch, 0.0 * contact);
  else
    run.start_slipping(number(numbers, "position") * contact - stretch,
                       number(numbers, "velocity") * contact);
  for (const double t : size > 1 ? Times{number(numbers, "pull.until")} : times) {
    step_to(run, 0.0, t);
    if (has_states) rows.positions.push_back(run.displacement()[system.contact]);
  }
  if (!has_states) add_changes(rows, run.events(), 0.0);
  if (size == 1) return rows;
  solver::StickSlipIntegrator on(mass_system(mass_model(numbers)), settings);
  on.start_slipping(run.displacement() + stretch, run.velocity());
  step_to(on, run.time(), times.back());
  add_changes(rows, on.events(), run.time());
  return rows;
}

// The changes of contact up to the last of the times, or the states at the times.
MassRows event_driven(const Numbers& numbers, bool has_states, const Times& times) {
  const double pull = number(numbers, "pull.force"), until = number(numbers, "pull.until");
  const analytic::ContactModel model = mass_model(numbers, pull);
  MassRows rows;
  analytic::EventDriven run(model);
  const double position = number(numbers, "position"), velocity = number(numbers, "velocity");
  const bool has_other = numbers.contains("other_mass");
  const double stretch =
      has_other ? pull / numbers.at("coupling") * std::sqrt(numbers.at("other_mass")) : 0.0;
  const Times amplitudes(has_other ? 1 : 0, -stretch), rates(amplitudes.size());
  if (is_held(model, position, velocity))
    run.start_stuck(amplitudes, rates, position);
  else
    run.start_slipping(amplitudes, rates, position, velocity);
  for (const double time : has_other ? Times{until} : times) {
    run.advance_to(time);
    if (has_states) rows.positions.push_back(run.contact_position());
  }
  if (!has_states) add_changes(rows, run.events(), 0.0);
  if (!has_other) return rows;
  const analytic::ContactModel free = mass_model(numbers);
  analytic::EventDriven on(free);
  on.start_slipping({run.amplitudes()[0] + stretch}, run.rates(), run.contact_position(),
                    run.contact_velocity());
  on.advance_to(times.back() - until);
  add_changes(rows, on.events(), until);
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
  const analytic::ContactModel model = mass_model(numbers);
  const double natural = model.modes() > 0 ? model.angular_frequency[0]
                                           : std::sqrt(model.contact_stiffness / model.contact_mass);
  const double share = 1e-12 * (1.0 + std::max(natural, model.load_angular_frequency) * rows.times.back());
  const auto exact = errors_of(event_driven(numbers, has_states, times), rows);
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
    Numbers numbers;
    for (const auto& [key, value] : table.resource.stated.numbers)
      if (key.starts_with(name + ".")) numbers[key.substr(name.size() + 1)] = value;
    expect_rows(numbers, name, rows);
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
      const Numbers numbers{{"stiffness", 1.0},
                            {"friction_force", 1.0},
                            {"force.amplitude", force},
                            {"force.angular_frequency", frequency}};
      const double period = 2.0 * std::numbers::pi / frequency, end = number * period;
      for (const MassRows& rows :
           {event_driven(numbers, false, {end}),
            step_by_step(numbers, false, {end}, std::min(period, 2.0 * std::numbers::pi) / 500.0)}) {
        int captures = 0;
        for (std::size_t i = 0; i < rows.changes.size(); ++i)
          if (rows.changes[i] == "capture" && rows.times[i] > end - period) ++captures;
        EXPECT_EQ(captures, stops(row)) << frequency << ", " << force;
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

}  // namespace
}  // namespace stickslip::testing
