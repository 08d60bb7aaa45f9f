// SPDX-License-Identifier: MIT
/// Histories: the battery of beams, in which every method runs random cases; their rows and spectra, and what a method refuses.

#include "studies/history/history.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/analyses/contact_response.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "support/random_cases.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::ContactChange;
using data::ContactEvent;
using data::ContactState;
using data::Feature;
using studies::HistoryRow;

data::Case with_step(const data::Case& problem, double step) {
  return with_value(problem, "numerics.time_step", step);
}

// --- The battery of beams. A method is a row.

// What a method finds in a case, with the step of the case.
struct Found {
  std::vector<ContactEvent> events{};
  std::vector<HistoryRow> rows{};  // at the times asked for
  long rows_off_law{};
  double unexplained{};  // share of the works and losses that no term of the energy balance explains
};

// A reversal of a few modes is a stick, shorter than they resolve, and an onset the other way.
std::vector<ContactEvent> without_reversals(const std::vector<ContactEvent>& events) {
  std::vector<ContactEvent> changes;
  for (ContactEvent event : events) {
    if (event.change == ContactChange::reversal) {
      event.change = ContactChange::capture;
      changes.push_back(event);
      event.change = ContactChange::onset;
    }
    changes.push_back(event);
  }
  return changes;
}

bool are_alike(const std::vector<ContactEvent>& a, const std::vector<ContactEvent>& b) {
  return std::ranges::equal(a, b, {}, &ContactEvent::change, &ContactEvent::change);
}

// Keeps the rows that are next to the times.
studies::RowSink rows_at(const std::vector<double>& times, double step, std::vector<HistoryRow>& rows) {
  return [&times, step, &rows](const HistoryRow& row) {
    if (rows.size() < times.size() && row.time > times[rows.size()] - 0.25 * step) rows.push_back(row);
  };
}

using Times = std::vector<double>;

Found found_by_elements(const data::Case& problem, const Times& times) {
  solver::BeamSimulation run(problem, {.coordinates = solver::Coordinates::nodal});
  solver::EnergyRecorder recorder(run.integrator());
  run.integrator().observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
  Found found;
  studies::History history;
  const double step = problem.numerics.time_step();
  const auto keep = rows_at(times, step, found.rows);
  for (long n = solver::step_count(problem.numerics.duration(), step); n > 0; --n) {
    run.integrator().step();
    const HistoryRow row{.time = run.integrator().time(),
                         .tip_displacement = run.tip_displacement(),
                         .midspan_displacement = run.midspan_displacement(),
                         .sliding_velocity = run.integrator().sliding_velocity(),
                         .friction_force = run.friction_force(),
                         .state = run.integrator().state()};
    studies::require_bounded(problem, row.tip_displacement, row.time);
    studies::hold_to_law(problem, history, row);
    keep(row);
  }
  const solver::EnergyBalance& energy = recorder.balance();
  found.events = without_reversals(run.integrator().events());
  found.rows_off_law = history.rows_off_law;
  found.unexplained =
      std::abs(energy.residual()) / (std::abs(energy.base_work) + energy.damping_loss + energy.friction_loss);
  return found;
}

Found found_by_modes(const data::Case& problem, int modes, const Times& times) {
  Found found;
  const data::Case with_modes = with_value(problem, "numerics.modes", modes);
  const auto history = studies::event_driven_history(with_modes, {});
  if (!times.empty()) found.rows = studies::event_driven_history(with_modes, {.times = times}).rows;
  found.events = without_reversals(history.events);
  found.rows_off_law = history.rows_off_law;
  analytic::EventDriven run(analytic::contact_model(with_modes, modes), {.keep_energy_balance = true});
  const auto start = run.energy_balance();
  auto now = start;
  for (int k = 1; k <= 20; ++k) {
    const auto before = now;
    run.advance_to(problem.numerics.duration() * k / 20.0);
    now = run.energy_balance();
    EXPECT_GE(now.friction_loss, before.friction_loss);
    EXPECT_GE(now.damping_loss, before.damping_loss);
  }
  found.unexplained = std::abs(now.kinetic + now.potential - start.kinetic - start.potential - now.base_work -
                               now.follower_work + now.damping_loss + now.friction_loss) /
                      (std::abs(now.base_work) + now.damping_loss + now.friction_loss);
  return found;
}

Found found_by_events(const data::Case& problem, const Times& times) {
  return found_by_modes(problem, problem.numerics.modes(), times);
}

// A step sticks or slips: around a turn one step of slip may stand between two of stick.
std::vector<ContactEvent> without_slips_of_one_step(const std::vector<ContactEvent>& events, double step) {
  std::vector<ContactEvent> kept;
  for (const ContactEvent& event : events) {
    if (event.change == ContactChange::capture && kept.size() > 1 &&
        event.time - kept.back().time < 1.5 * step)
      kept.pop_back();
    else
      kept.push_back(event);
  }
  return kept;
}

Found found_by_boundary_integral(const data::Case& problem, const Times& times) {
  const auto history = studies::boundary_integral_history(problem, {.times = times}, 1);
  for (const HistoryRow& row : history.rows) {  // means of two steps
    EXPECT_TRUE(problem.contact.friction.viscous() > 0.0 ||
                std::abs(row.friction_force) <= studies::friction_limit(problem) * (1.0 + 1e-9))
        << row.time;
    EXPECT_TRUE(row.state == ContactState::slip || row.sliding_velocity == 0.0 ||
                !problem.contact.compliance.is_rigid())
        << row.time;
  }
  return {without_slips_of_one_step(without_reversals(history.events), problem.numerics.time_step()),
          history.rows, history.rows_off_law};
}

// The run of maps and sweeps. It takes the law at the mean of the velocities of a step, to 1.25e-9 of the falling part, and does not
// locate its changes.
Found found_in_fixed_steps(const data::Case& problem, const Times& times) {
  const analytic::ContactModel model = studies::response_model(problem);
  const analytic::ContactModes modes(model);
  const double force = problem.beam().axial_force();
  analytic::ModalContactRun run(
      modes, model,
      static_cast<int>(std::lround(2.0 * std::numbers::pi /
                                   (model.load_angular_frequency * problem.numerics.time_step()))));
  run.start_stuck();
  Found found;
  const auto keep = rows_at(times, run.time_step(), found.rows);
  const analytic::ContactDynamics dynamics(model);
  const auto tip = [&] {
    dynamics.enter(run.time());
    return run.contact_position() + dynamics.base_displacement(run.time()) +
           dynamics.wall_displacement(run.time());
  };
  std::vector<ContactEvent> events;
  double before = 0.0;
  for (double direction = 0.0; run.time() < problem.numerics.duration();) {
    const double start = run.time(), position = tip();
    run.step();
    const double after = run.sliding_velocity(), now = run.slips() ? std::copysign(1.0, after) : 0.0;
    keep({.time = run.time(), .tip_displacement = tip(), .midspan_displacement = std::nan("")});
    if (now != direction)
      events.push_back(direction == 0.0
                           ? ContactEvent{ContactChange::onset, start, position}
                           : ContactEvent{now == 0.0 ? ContactChange::capture : ContactChange::reversal,
                                          run.time(), tip()});
    const double mean = 0.5 * std::abs(before + after),
                 law = force * solver::friction_coefficient(problem.contact.friction.in_slip(), mean);
    if (now == 0.0)
      found.rows_off_law += after != 0.0 || std::abs(run.friction_force()) > studies::friction_limit(problem);
    else if (before * after >= 0.0)  // else it turns round, with the force of each direction for a while
      found.rows_off_law += std::abs(run.friction_force() + std::copysign(law, after)) >
                            1.5e-9 * studies::friction_limit(problem);
    before = after;
    direction = now;
  }
  found.events = without_reversals(events);
  return found;
}

struct BeamMethod {
  std::string name, requirement;
  CaseDomain domain;  // of what the method does not refuse
  double (*step)(const data::Case&);
  Found (*run)(const data::Case&, const Times&);
  double unexplained{};  // allowed of the energy balance
  double order{};        // of the times of changes on average, at least; 0: runs on other steps are not made
  double grid{};         // changes stand on steps, and are off by so many
  double mesh{};         // the relative error of the first frequency
};

void PrintTo(const BeamMethod& method, std::ostream* stream) { *stream << method.name; }

const CaseDomain slipping{.lowest_force = 0.01,
                          .lowest_load = 1.2,
                          .longest = 3.0,
                          .lowest_frequency = 0.1,
                          .kelvin_voigt = 1.0,
                          .moving_wall = 0.3,
                          .any_motion = 0.4};

std::vector<BeamMethod> beam_methods() {
  CaseDomain light = slipping, resting = slipping, quick = slipping;
  light.kelvin_voigt = 0.5;
  resting.moving_wall = 0.0, resting.resonant = 0.3;
  quick.longest = 1.5, quick.lowest_frequency = 0.3, quick.ratio = quick.moving_wall = quick.jump = 0.0;
  quick.yielding = 0.2;
  const auto of_case = [](const data::Case& problem) { return problem.numerics.time_step(); };
  const auto of_map = [](const data::Case& problem) {
    return 1.0 / (data::highest_frequency_hz(problem) * studies::steps_per_period(problem));
  };
  // (omega h)^2/12 of a work by the trapezoidal rule; mode 10 has 50 steps in a period. A change stands on a step, and means over that
  // step and its neighbours decide which one.
  const double rule = std::pow(2.0 * std::numbers::pi / 50.0, 2) / 12.0;
  const double mesh = std::pow(3.93 / 20.0, 4) / 720.0;
  return {{"Elements", "X9", slipping, of_case, found_by_elements, rule, 1.5, 0.0, mesh},
          {"Events", "D3", light, of_case, found_by_events, 1e-12, 0.0, 0.0},
          {"BoundaryIntegral", "D4", quick, studies::boundary_integral_step, found_by_boundary_integral, 0.0,
           0.0, 3.0},
          {"FixedSteps", "D5", resting, of_map, found_in_fixed_steps, 0.0, 0.0, 2.0}};
}

// By the modes of the continuous beam. Half of them say how far an event is known.
struct Judge {
  Judge(const data::Case& problem, const Times& times)
      : few(found_by_events(problem, times)),
        many(found_by_modes(problem, 2 * problem.numerics.modes(), times)) {}
  [[nodiscard]] bool is_converged() const { return are_alike(few.events, many.events); }
  Found few, many;
};

// Runs with twice the step, the step and half of it.
struct Runs {
  Found twice, own, half;
  double step{}, grid{}, mesh{};
};

// The same changes as the judge, each at its time. From order 1 on the error of the step h is at most the difference to the step 2 h and
// twice that to h/2. The mesh keeps time by its first frequency. The error of the modes, of order 3 in their number, is at most the difference to half of them. The end of a stick
// that is shorter than h, or that the modes have as a reversal, is as uncertain as the stick is long. Returns the orders that the
// differences show.
std::vector<double> expect_changes(const Judge& judge, const Runs& runs) {
  const auto& [twice, own, half, h, grid, mesh] = runs;
  std::vector<double> orders;
  EXPECT_TRUE(are_alike(own.events, judge.many.events))
      << own.events.size() << " for " << judge.many.events.size();
  for (const Found* each : {&own, &twice, &half})
    if (!are_alike(each->events, judge.many.events)) return orders;
  for (std::size_t i = 0; i < own.events.size(); ++i) {
    const auto time = [i](const Found& found) { return found.events[i].time; };
    const auto stick = [i](const Found& found) { return found.events[i].time - found.events[i - 1].time; };
    const double coarse = std::abs(time(twice) - time(own)), fine = std::abs(time(own) - time(half));
    const bool is_short = i > 0 && own.events[i].change == ContactChange::onset &&
                          (stick(own) < h || std::min(stick(judge.few), stick(judge.many)) == 0.0);
    EXPECT_TRUE(
        within(time(own), time(judge.many),
               discretisation(std::max(coarse, 2.0 * fine) + std::abs(time(judge.few) - time(judge.many)) +
                                  grid * h + mesh * time(own) + (is_short ? stick(own) : 0.0),
                              1.0, "step, modes and mesh")))
        << i;
    if (!is_short && std::min(coarse, fine) > 1e-6 * h) orders.push_back(std::log2(coarse / fine));
  }
  return orders;
}

// y(L) and y(L/2), of the size of the motion of the base at least, with the errors as of the changes: 20 elements leave (beta l)^4/720 of mode 3, and a change that is off
// by a step moves the tip by what it slides then.
void expect_motion(const Judge& judge, const Runs& runs) {
  const double mesh = std::pow(10.2 / 20.0, 4) / 720.0;
  for (const auto value : {&HistoryRow::tip_displacement, &HistoryRow::midspan_displacement}) {
    double coarse = 0.0, fine = 0.0, modes = 0.0, error = 0.0, size = 0.0, speed = 0.0;
    ASSERT_EQ(runs.own.rows.size(), judge.many.rows.size());
    for (std::size_t i = 0; i < runs.own.rows.size(); ++i) {
      const auto of = [&](const Found& found) { return found.rows.at(i).*value; };
      if (std::isnan(of(runs.own))) return;
      coarse = std::max(coarse, std::abs(of(runs.twice) - of(runs.own)));
      fine = std::max(fine, std::abs(of(runs.own) - of(runs.half)));
      modes = std::max(modes, std::abs(of(judge.few) - of(judge.many)));
      error = largest_or_nan({error, std::abs(of(runs.own) - of(judge.many))});
      size = std::max({size, std::abs(of(judge.many)), std::abs(judge.many.rows[i].base_displacement)});
      speed = std::max(speed, std::abs(judge.many.rows[i].sliding_velocity));
    }
    const double late = runs.grid * runs.step * speed * static_cast<double>(runs.own.events.size());
    EXPECT_TRUE(within(error, 0.0,
                       discretisation(std::max(coarse, 2.0 * fine) + modes + mesh * size + late, 1.0,
                                      "step, modes and mesh")));
  }
}

// Beyond flutter a motion may be stopped, with a sentence.
template <typename Claim>
void on_motions(int count, const CaseDomain& domain, Claim&& claim) {
  on_random_cases(count, domain, [&](const CaseText& text, RandomNumbers&) {
    try {
      claim(text.problem());
    } catch (const data::InputError& error) {
      EXPECT_TRUE(holds(error.what(), "the motion is stopped at")) << error.what();
    }
  });
}

double mean(const std::vector<double>& values) {
  return std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
}

class RandomHistories : public ::testing::TestWithParam<BeamMethod> {};

TEST_P(RandomHistories, AgreeWithEventsAndObeyTheLaw) {
  const BeamMethod& method = GetParam();
  record_requirement(method.requirement);
  std::vector<double> orders, energy_orders;
  int compared = 0;
  on_motions(8, method.domain, [&](const data::Case& problem) {
    const double h = method.step(problem);
    const long steps = solver::step_count(problem.numerics.duration(), h);
    if (steps > 50000) return;
    Times times;
    for (long n = 1; n <= 8; ++n) times.push_back(static_cast<double>((steps - 1) / 16 * 2 * n) * h);
    const auto run = [&](double step) { return method.run(with_step(problem, step), times); };
    Runs runs{{}, run(h), {}, h, method.grid, method.mesh};
    runs.twice = method.order > 0.0 ? run(2.0 * h) : runs.own;
    runs.half = method.order > 0.0 ? run(0.5 * h) : runs.own;
    EXPECT_EQ(runs.twice.rows_off_law + runs.own.rows_off_law + runs.half.rows_off_law, 0);
    EXPECT_TRUE(within(runs.own.unexplained, 0.0,
                       discretisation(method.unexplained, 1.0, "trapezoidal rule, or tolerance of a step")));
    if (method.order > 0.0)
      energy_orders.push_back(0.5 * std::log2(runs.twice.unexplained / runs.half.unexplained));
    if (!problem.contact.compliance.is_rigid()) return;
    const Judge judge(problem, times);
    EXPECT_EQ(judge.few.rows_off_law + judge.many.rows_off_law, 0);
    if (!judge.is_converged()) return;
    ++compared;
    const auto these = expect_changes(judge, runs);
    orders.insert(orders.end(), these.begin(), these.end());
    expect_motion(judge, runs);
  });
  EXPECT_GT(compared, 2);
  if (method.order == 0.0) return;
  ASSERT_GT(orders.size(), 20u);
  EXPECT_GT(mean(orders), method.order);  // 2, and 1 where changes are not located
  // 2; where a force jumps, modes with eta omega_n^2 h > 1 leave a sum of n^-4 from n ~ h^-1/4 on, which is of order 3/4.
  EXPECT_GT(mean(energy_orders), 0.75);
}

INSTANTIATE_TEST_SUITE_P(, RandomHistories, ::testing::ValuesIn(beam_methods()),
                         [](const auto& instance) { return instance.param.name; });

const CaseDomain any_feature = [] {
  CaseDomain domain = slipping;
  domain.kelvin_voigt = 0.5, domain.shear = domain.yielding = 0.3;
  return domain;
}();

STICKSLIP_VERIFIES(RandomRows, "X10");
// With a spring, a smooth law, shear and without damping as well, with the default step and with 80 steps a period.
TEST(RandomRows, ObeyTheLawOnEveryStep) {
  for (const char* name : {"fe", "event-driven"})
    on_motions(8, any_feature, [&](const data::Case& problem) {
      const studies::Method& method = studies::method(name);
      if (error_message_if_any<data::FieldError>([&] { method.require(problem); })) return;
      const data::Case coarse = with_step(problem, 1.0 / (80.0 * data::highest_frequency_hz(problem)));
      for (const data::Case& each : {problem, coarse, with_value(coarse, "numerics.spectral_radius", 0.9)})
        EXPECT_EQ(method.run(each, {}, {}, {}).rows_off_law, 0) << name << each.numerics.time_step();
    });
}

// A spectral radius that lets stiff modes turn over in each step may invent changes, but then the run says so.
TEST(RandomRows, OfAnyRadiusAgreeOrSaySo) {
  int right = 0, wrong = 0;
  on_motions(6, slipping, [&](const data::Case& drawn) {
    const data::Case problem = with_value(drawn, "numerics.spectral_radius", 0.9);
    const Judge judge(problem, {});
    if (!judge.is_converged()) return;
    const studies::History history = studies::finite_element_history(problem);
    const bool is_right = are_alike(without_reversals(history.events), judge.many.events);
    (is_right ? right : wrong) += 1;
    const auto warnings = studies::warnings_after(problem, studies::finite_elements(), history);
    EXPECT_TRUE(is_right || std::ranges::any_of(warnings, [](const std::string& text) {
                  return holds(text, "the radius 0 ends it");
                }));
  });
  EXPECT_GT(std::min(right, wrong), 0);
}

// --- What a method refuses

std::map<std::string, Feature> features_of(const data::Case& problem) {
  std::map<std::string, Feature> features;
  const auto add = [&](bool has, const char* key, Feature feature) {
    if (has) features.emplace(key, feature);
  };
  add(problem.damping.kelvin_voigt() > 0.0, "damping.kelvin_voigt", Feature::kelvin_voigt);
  add(problem.damping.ratio() > 0.0, "damping.ratio", Feature::other_damping);
  add(problem.damping.mass_proportional() > 0.0, "damping.mass_proportional", Feature::other_damping);
  add(problem.contact.compliance.is_smooth(), "contact.regularisation_velocity", Feature::yielding_contact);
  add(!problem.contact.compliance.is_smooth() && !problem.contact.compliance.is_rigid(),
      "contact.tangential_stiffness", Feature::yielding_contact);
  add(problem.contact.wall.speed() != 0.0, "wall.speed", Feature::moving_wall);
  add(problem.beam().shear_stiffness() > 0.0, "beam.shear_stiffness", Feature::shear);
  return features;
}

STICKSLIP_VERIFIES(MethodRefusals, "X18");
TEST(MethodRefusals, AreThoseOfTheTable) {
  CaseDomain domain = any_feature;
  domain.jump = 0.0;  // which the boundary integral refuses for its steps
  on_random_cases(40, domain, [&](const CaseText& text, RandomNumbers&) {
    const data::Case problem = text.problem();
    const auto features = features_of(problem);
    for (const studies::Method& method : studies::methods()) {
      SCOPED_TRACE(method.name);
      const auto message = [&](const solver::RunOptions& options) {
        return error_message_if_any<data::FieldError>([&] { method.require(problem, options); }).value_or("");
      };
      const std::string refusal = message({});
      EXPECT_EQ(!refusal.empty(), std::ranges::any_of(features, [&](const auto& each) {
        return method.refused.contains(each.second);
      }));
      EXPECT_TRUE(refusal.empty() || std::ranges::any_of(features,
                                                         [&](const auto& each) {
                                                           return refusal.starts_with(each.first) &&
                                                                  method.refused.contains(each.second);
                                                         }))
          << refusal;
      if (!refusal.empty()) continue;
      EXPECT_EQ(message({.starts_with_the_base = true}) != "",
                method.refused.contains(Feature::start_at_rest));
      EXPECT_EQ(message({.scheme = solver::ContactScheme::located}) != "",
                method.refused.contains(Feature::contact_scheme));
      EXPECT_EQ(message({.scheme = solver::ContactScheme::paper}) != "",
                method.refused.contains(Feature::contact_scheme) || !problem.contact.compliance.is_rigid());
    }
  });
}

TEST(MethodRefusals, AreInTheUserGuide) {
  std::ifstream file(std::filesystem::path(STICKSLIP_SOURCE_DIRECTORY) / "reports/manual/user-guide.md");
  const std::string guide{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(holds(guide, "\n" + studies::table_of_methods() + "\n"));
}

// --- Rows and events of each method

data::Case case_of(const std::string& name, std::vector<data::Override> overrides = {}) {
  overrides.insert(
      overrides.begin(),
      {{"excitation.frequency_hz", "25"}, {"excitation.amplitude", "1e-3"}, {"excitation.duration", "0.08"}});
  return data::load_case(name, overrides);
}

STICKSLIP_VERIFIES(RowsOfMethods, "X9");
TEST(RowsOfMethods, AreThoseOfTheSampling) {
  const data::Case problem =
      case_of("paper", {{"excitation.amplitude", "1"}, {"excitation.duration", "0.004"}});
  const double h = problem.numerics.time_step(), length = problem.beam().length();
  for (const studies::Method& method : studies::methods()) {
    SCOPED_TRACE(method.name);
    const auto all = method.run(problem, {}, {}, {});
    ASSERT_EQ(all.rows.size(), 41u);
    EXPECT_TRUE(all.first_slip.has_value());
    EXPECT_EQ(all.events.empty(), method.refused.contains(Feature::slip));
    std::vector<HistoryRow> some;  // given to a sink, and not kept
    EXPECT_TRUE(
        method.run(problem, {.every = 7}, {}, [&](const auto& row) { some.push_back(row); }).rows.empty());
    ASSERT_EQ(some.size(), 6u);
    const auto chosen =
        method.run(problem, {.times = {7 * h, 28 * h}, .positions = {0.0, 0.5 * length, length}}, {}, {});
    ASSERT_EQ(chosen.rows.size(), 2u);
    for (const std::size_t n : {7u, 28u}) {
      const HistoryRow &row = chosen.rows[n / 28], &same = all.rows[n], &seventh = some[n / 7];
      EXPECT_DOUBLE_EQ(row.time, same.time);
      EXPECT_EQ(seventh.time, same.time);
      EXPECT_EQ(row.state, same.state);
      const std::pair<double, double> values[] = {{seventh.tip_displacement, same.tip_displacement},
                                                  {row.tip_displacement, same.tip_displacement},
                                                  {row.displacement[0], row.base_displacement},
                                                  {row.displacement[1], same.midspan_displacement},
                                                  {row.displacement[2], same.tip_displacement}};
      for (const auto& [value, expected] : values)
        EXPECT_TRUE(within(value, expected, round_off(100, 100, 1.0)));
    }
  }
}

// Stick, slip forwards, slip backwards, stick: velocity, force, slides.
const std::vector<analytic::ContactStep> steps_of_contact{
    {0.0, 1.0, false}, {0.0, 3.0, false}, {0.2, -6.0, true}, {-0.1, 5.0, true}, {0.0, 4.0, false}};

STICKSLIP_VERIFIES(BoundaryIntegralContact, "D4");
TEST(BoundaryIntegralContact, IsTheMeanBesideARow) {
  const auto expect = [](std::size_t step, double velocity, double force, ContactState state) {
    const HistoryRow row = studies::contact_between(steps_of_contact, step);
    EXPECT_DOUBLE_EQ(row.sliding_velocity, velocity) << step;
    EXPECT_DOUBLE_EQ(row.friction_force, force) << step;  // f = -f_d
    EXPECT_EQ(row.state, state) << step;
  };
  expect(0, 0.0, -0.0, ContactState::stick);  // on the line through 1 and 3
  expect(1, 0.0, -2.0, ContactState::stick);
  expect(2, 0.0, 1.5, ContactState::stick);  // at rest until then
  expect(3, 0.05, 0.5, ContactState::slip);
  expect(4, -0.05, -4.5, ContactState::slip);
  expect(5, 0.0, -4.0, ContactState::stick);
  const std::vector<analytic::ContactStep> one{{0.0, 2.0, false}};
  EXPECT_EQ(studies::contact_between(one, 0).friction_force, -2.0);
}

TEST(BoundaryIntegralContact, ChangesWithDirection) {
  const auto events = studies::events_between(steps_of_contact, 0.5);
  ASSERT_EQ(events.size(), 3u);
  const auto expect = [&](std::size_t i, ContactChange change, double time, double position) {
    EXPECT_EQ(events[i].change, change);
    EXPECT_DOUBLE_EQ(events[i].time, time);
    EXPECT_DOUBLE_EQ(events[i].position, position);
  };
  expect(0, ContactChange::onset, 1.0, 0.0);
  expect(1, ContactChange::reversal, 1.5, 0.1);
  expect(2, ContactChange::capture, 2.0, 0.05);
  EXPECT_TRUE(studies::events_between({{0.0, 1.0, false}}, 0.5).empty());
}

TEST(BoundaryIntegralContact, HasTheEffectOfAStep) {
  const data::Case problem =
      case_of("damped", {{"excitation.amplitude", "1"}, {"excitation.duration", "0.002"}});
  const studies::Method& method = studies::method("boundary-integral");
  const auto history = method.run(problem, {}, {}, {});
  const int steps =
      static_cast<int>(std::lround(problem.numerics.time_step() / studies::boundary_integral_step(problem)));
  EXPECT_EQ(history.step_effect,
            studies::largest_difference(
                studies::tip_displacements(history),
                studies::tip_displacements(studies::boundary_integral_history(problem, {}, steps / 2))));
  EXPECT_GT(*history.step_effect, 0.0);
  // A time step as long as the method's own leaves nothing to halve.
  const data::Case own = with_step(problem, studies::boundary_integral_step(problem));
  EXPECT_FALSE(method.run(own, {.times = {1e-4}}, {}, {}).step_effect.has_value());
}

// What no step solves, twice the step of the method does not take either.
TEST(BoundaryIntegralContact, HasOneSolutionAStep) {
  const auto weakening = [](const char* decay) {
    return case_of("paper", {{"friction.decay", decay},
                             {"friction.kinetic_coefficient", "0.01"},
                             {"beam.axial_force", "5e4"},
                             {"numerics.time_step", "1e-6"},
                             {"excitation.duration", "1e-5"},
                             {"excitation.amplitude", "1e-5"}});
  };
  EXPECT_LT(studies::boundary_integral_step(weakening("30")),
            studies::boundary_integral_step(weakening("1")));
  EXPECT_NO_THROW((void)studies::method("boundary-integral").run(weakening("30"), {}, {}, {}));
}

STICKSLIP_VERIFIES(HistorySpectrum, "X9");
TEST(HistorySpectrum, HasWholePeriods) {
  // 0.18 s of 25 Hz: its second half has two whole periods.
  const data::Case problem =
      case_of("paper", {{"excitation.duration", "0.18"}, {"numerics.time_step", "1e-3"}});
  for (const auto& [every, rows] : {std::pair{1, 80u}, {5, 16u}, {20, 4u}}) {  // two in a period
    EXPECT_EQ(studies::spectrum_window(problem, every).rows, rows);
    EXPECT_EQ(studies::spectrum_window(problem, every).periods, 2);
  }
  EXPECT_THROW((void)studies::spectrum_window(problem, 25), data::FieldError);
  EXPECT_THROW((void)studies::spectrum_window(case_of("paper", {{"excitation.duration", "0.07"}}), 1),
               data::FieldError);
}

// Lines of whole periods are exact. Of any other period, beside that of the base or with a base that rests, the window falls short of
// an amplitude by 0.08 % at most. What is before the window does not count.
TEST(HistorySpectrum, HasTheAmplitudes) {
  RandomNumbers numbers(1);
  for (int i = 0; i < 30; ++i) {
    const long periods = i % 3 == 0 ? 0 : 20;
    const bool is_whole = i % 3 == 2;
    const double other = is_whole ? 40.0 : numbers.uniform(30.0, 35.0),
                 amplitude = numbers.log_uniform(0.1, 10.0);
    std::vector<double> tip(100, 1e3);
    for (int n = 0; n < 2000; ++n) {
      const double phase = 2.0 * std::numbers::pi * n / 2000.0;
      tip.push_back(3.0 + (periods > 0 ? std::sin(20.0 * phase) : 0.0) + amplitude * std::sin(other * phase));
    }
    std::vector<double> force = tip;
    for (double& value : force) value *= -2.0;
    const auto spectrum = studies::spectrum_of(tip, force, {2000, periods}, 1e-3);
    EXPECT_EQ(spectrum.is_flat_top, !is_whole);
    const auto expect_line = [&](double at, double expected) {
      const auto& line = spectrum.lines[static_cast<std::size_t>(std::lround(at))];
      const double off = is_whole ? 1e-12 : 1e-3;
      EXPECT_DOUBLE_EQ(line.frequency_hz, std::round(at) / 2.0);
      const Tolerance tolerance = discretisation(off * (expected + amplitude), 1.0, "flat-top window");
      EXPECT_TRUE(within(line.tip_displacement, expected, tolerance)) << other;
      EXPECT_TRUE(within(0.5 * line.friction_force, expected, tolerance)) << other;
    };
    expect_line(other, amplitude);
    expect_line(0.0, 3.0);
    if (periods > 0) expect_line(20.0, 1.0);
  }
}

STICKSLIP_VERIFIES(EndlessMotion, "X21");
TEST(EndlessMotion, IsStopped) {
  const auto problem = case_of("paper", {{"beam.axial_force", "8e4"},
                                         {"beam.axial_direction", "0.35"},  // flutter at 6.87e4 N
                                         {"friction.static_coefficient", "0.01"},
                                         {"friction.kinetic_coefficient", "0.005"},
                                         {"excitation.duration", "1"},
                                         {"numerics.time_step", "2e-4"},
                                         {"numerics.modes", "5"}});
  for (const std::string name : {"fe", "event-driven"}) {
    const auto& each = studies::method(name);
    double largest = 0.0;
    try {
      (void)each.run(problem, {.every = 5}, {}, [&](const studies::HistoryRow& row) {
        largest = std::max(largest, std::abs(row.tip_displacement));
      });
      ADD_FAILURE() << each.name;
    } catch (const data::InputError& error) {
      EXPECT_TRUE(holds(error.what(), "the motion is stopped at 0.")) << each.name << error.what();
    }
    EXPECT_LT(largest, studies::most_deflection * problem.beam().length() + 1.0) << each.name;
  }
}

STICKSLIP_VERIFIES(RowsOffTheLaw, "X21");
TEST(RowsOffTheLaw, AreCountedAndTheFirstIsNamed) {
  const data::Case problem = case_of("paper");  // mu_s P = 300 N
  const double force = (0.3 + 0.3 * std::exp(-0.1)) * 500.0;
  studies::History history;
  const auto hold = [&](double time, double velocity, double friction, ContactState state) {
    studies::hold_to_law(
        problem, history,
        {.time = time, .sliding_velocity = velocity, .friction_force = friction, .state = state});
    return history.rows_off_law;
  };
  EXPECT_EQ(hold(0.1, 0.0, -300.0, ContactState::stick), 0);
  EXPECT_EQ(hold(0.2, -0.1, -force, ContactState::slip), 0);
  EXPECT_EQ(hold(0.3, 0.1, -force, ContactState::slip), 1);
  EXPECT_EQ(hold(0.4, 0.1, 1.001 * force, ContactState::slip), 2);
  EXPECT_EQ(hold(0.5, 0.0, 300.001, ContactState::stick), 3);
  EXPECT_EQ(hold(0.6, 1e-9, 100.0, ContactState::stick), 4);
  const auto warnings = studies::warnings_after(problem, studies::finite_elements(), history);
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& text) {
    return text.starts_with("at t = 0.3 s the contact is in slip") && holds(text, "at 4 times in all");
  }));
}

}  // namespace
}  // namespace stickslip::testing
