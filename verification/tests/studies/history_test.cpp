// SPDX-License-Identifier: MIT
/// Histories by all methods: their rows, events and estimated error, and what each method refuses.

#include "studies/history/history.hpp"
#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/energy_audit.hpp"
#include "support/random_cases.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::ContactChange;
using data::ContactState;
using studies::Feature;

data::Case case_of(const std::string& name, std::vector<data::Override> overrides = {}) {
  overrides.insert(
      overrides.begin(),
      {{"excitation.frequency_hz", "25"}, {"excitation.amplitude", "1e-3"}, {"excitation.duration", "0.08"}});
  return data::load_case(name, overrides);
}

// Stick, slip forwards, slip backwards, stick: velocity, force, slides.
const std::vector<analytic::ContactStep> steps_of_contact{
    {0.0, 1.0, false}, {0.0, 3.0, false}, {0.2, -6.0, true}, {-0.1, 5.0, true}, {0.0, 4.0, false}};

STICKSLIP_VERIFIES(BoundaryIntegralContact, "D4");
TEST(BoundaryIntegralContact, IsTheMeanOfTheStepsBesideARow) {
  const auto expect = [](std::size_t step, double velocity, double force, ContactState state) {
    const studies::HistoryRow row = studies::contact_between(steps_of_contact, step);
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

TEST(BoundaryIntegralContact, ChangesWhereTheDirectionOfSlidingChanges) {
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

TEST(BoundaryIntegralContact, StepEffectIsTheDifferenceToTwiceTheStep) {
  const data::Case problem = case_of("damped", {{"numerics.time_step", "2e-4"}});
  const studies::Method& method = studies::method("boundary-integral");
  const auto history = method.run(problem, {}, {}, {});
  const int steps =
      static_cast<int>(std::lround(problem.numerics.time_step() / studies::boundary_integral_step(problem)));
  ASSERT_GT(steps, 1);
  const auto tip = [&](int count) {
    return studies::tip_displacements(
        studies::boundary_integral_history(problem, {.with_midspan = false}, count));
  };
  EXPECT_EQ(history.step_effect, studies::largest_difference(tip(steps), tip(steps / 2)));
  EXPECT_EQ(studies::tip_displacements(history), tip(steps));
  EXPECT_GT(*history.step_effect, 0.0);
  // Whatever rows are asked for.
  EXPECT_EQ(method.run(problem, {.every = 7}, {}, {}).step_effect, history.step_effect);
  // A time step as long as the method's own leaves nothing to halve.
  EXPECT_FALSE(method
                   .run(case_of("damped", {{"numerics.time_step", "1e-6"}, {"excitation.duration", "1e-3"}}),
                        {}, {}, {})
                   .step_effect.has_value());
}

class HistoryBy : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static const studies::Method& method() { return studies::method(GetParam()); }
  [[nodiscard]] static data::Case problem() {
    return case_of(method().refused.contains(Feature::kelvin_voigt) ? "paper" : "damped",
                   {{"excitation.amplitude", "1e-2"}, {"excitation.duration", "0.02"}});
  }
};

STICKSLIP_VERIFIES(HistoryBy, "X9");
TEST_P(HistoryBy, HasTheRowsOfItsSampling) {
  const double h = problem().numerics.time_step();
  const auto all = method().run(problem(), {}, {}, {});
  ASSERT_EQ(all.rows.size(), static_cast<std::size_t>(std::lround(0.02 / h)) + 1);
  EXPECT_TRUE(all.first_slip.has_value());
  EXPECT_EQ(all.events.empty(), method().refused.contains(Feature::slip));
  std::vector<studies::HistoryRow> some;  // given to a sink, and not kept
  const auto none = method().run(problem(), {.every = 7}, {}, [&](const auto& row) { some.push_back(row); });
  EXPECT_TRUE(none.rows.empty());
  ASSERT_EQ(some.size(), (all.rows.size() - 1) / 7 + 1);
  const double length = problem().beam.length();
  const auto chosen = method().run(
      problem(), {.times = {7 * h, 21 * h, 175 * h}, .positions = {0.0, 0.5 * length, length}}, {}, {});
  ASSERT_EQ(chosen.rows.size(), 3u);
  const Tolerance rounding = round_off(100, 100, 1e-3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t n = std::vector<std::size_t>{7, 21, 175}[i];
    const studies::HistoryRow &row = chosen.rows[i], &same = all.rows[n], &seventh = some[n / 7];
    EXPECT_DOUBLE_EQ(row.time, same.time);
    EXPECT_EQ(seventh.time, same.time);
    EXPECT_EQ(row.state, same.state);
    EXPECT_TRUE(within(seventh.tip_displacement, same.tip_displacement, rounding));
    EXPECT_TRUE(within(row.tip_displacement, same.tip_displacement, rounding));
    EXPECT_TRUE(within(row.displacement[0], row.base_displacement, rounding));
    EXPECT_TRUE(within(row.displacement[1], same.midspan_displacement, rounding));
    EXPECT_TRUE(within(row.displacement[2], same.tip_displacement, rounding));
  }
}

INSTANTIATE_TEST_SUITE_P(Method, HistoryBy, ::testing::ValuesIn(studies::method_names()),
                         [](const auto& name) {
                           std::string text = name.param;
                           std::erase(text, '-');
                           return text;
                         });

STICKSLIP_VERIFIES(MethodRefusals, "X18");
TEST(MethodRefusals, NameTheKeyAndTheReason) {
  const data::Case spring = case_of("damped", {{"contact.tangential_stiffness", "1e6"}}),
                   ratio = case_of("paper", {{"damping.ratio", "0.01"}}),
                   shear = case_of("paper", {{"beam.shear_stiffness", "6e6"}});
  const std::tuple<const char*, data::Case, studies::RunChoices, const char*> rows[] = {
      {"event-driven",
       spring,
       {},
       "contact.tangential_stiffness is 1e+06, but must be inf (a rigid contact) for --method event-driven; "
       "fe and boundary-integral take it"},
      {"boundary-integral",
       ratio,
       {},
       "damping.ratio is 0.01, but must be 0 with the boundary integral, which allows Kelvin-Voigt damping "
       "only"},
      {"event-driven",
       shear,
       {},
       "beam.shear_stiffness is 6e+06, but must be 0 for --method event-driven, whose beam is rigid in "
       "shear; "
       "--method fe has shear"},
      {"boundary-integral",
       case_of("paper"),
       {.initial_velocity = solver::InitialVelocity::zero},
       "--initial-velocity is zero, but must be quasi-static for --method boundary-integral, whose equation "
       "assumes it"},
      {"fe",
       spring,
       {.scheme = solver::ContactScheme::paper},
       "contact.tangential_stiffness is 1e+06, but must be inf (a rigid contact) for --scheme paper"}};
  for (const auto& [name, problem, choices, sentence] : rows)
    EXPECT_EQ(error_message_of<data::FieldError>(
                  [&, &n = name, &p = problem, &c = choices] { studies::method(n).require(p, c); }),
              sentence);
}

// What the table says, by each method on a case or a choice with each feature.
TEST(MethodRefusals, AreThoseOfTheTable) {
  const auto with = [](const std::string& key, const std::string& value) {
    return case_of("paper", {{key, value}});
  };
  const std::vector<std::pair<Feature, data::Case>> cases{
      {Feature::kelvin_voigt, with("damping.kelvin_voigt", "1e-5")},
      {Feature::damping_ratio, with("damping.ratio", "0.01")},
      {Feature::yielding_contact, with("contact.tangential_stiffness", "1e6")},
      {Feature::yielding_contact, with("contact.regularisation_velocity", "1e-3")},
      {Feature::moving_wall, with("wall.speed", "0.1")},
      {Feature::shear, with("beam.shear_stiffness", "6e6")},
      {Feature::fixed_axial_force, with("beam.axial_direction", "1")}};
  for (const studies::Method& method : studies::methods()) {
    SCOPED_TRACE(method.name);
    const auto refuses = [&](const data::Case& problem, const studies::RunChoices& choices) {
      return error_message_if_any<data::FieldError>([&] { method.require(problem, choices); }).has_value();
    };
    EXPECT_FALSE(refuses(case_of("paper"), {}));
    const auto last_force = [&](const data::Case& problem) {
      return method.run(problem, {.every = 100}, {}, {}).rows.back().friction_force;
    };
    for (const auto& [feature, problem] : cases) {
      EXPECT_EQ(refuses(problem, {}), method.refused.contains(feature)) << static_cast<int>(feature);
      if (method.refused.contains(feature)) continue;
      EXPECT_NE(last_force(problem), last_force(case_of("paper"))) << static_cast<int>(feature);
    }
    EXPECT_EQ(refuses(case_of("paper"), {.initial_velocity = solver::InitialVelocity::zero}),
              method.refused.contains(Feature::start_at_rest));
    EXPECT_EQ(refuses(case_of("paper"), {.scheme = solver::ContactScheme::located}),
              method.refused.contains(Feature::contact_scheme));
  }
}

TEST(MethodRefusals, AreInTheUserGuide) {
  std::ifstream file(std::filesystem::path(STICKSLIP_SOURCE_DIRECTORY) / "reports/manual/user-guide.md");
  const std::string guide{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(holds(guide, "\n" + studies::table_of_methods() + "\n"));
}

STICKSLIP_VERIFIES(HistorySpectrum, "X9");
TEST(HistorySpectrum, HasTheLinesOfWholePeriods) {
  // 0.18 s of 25 Hz: its second half has two whole periods.
  const data::Case problem =
      case_of("paper", {{"excitation.duration", "0.18"}, {"numerics.time_step", "1e-3"}});
  EXPECT_EQ(studies::spectrum_window(problem, 1).rows, 80u);
  EXPECT_EQ(studies::spectrum_window(problem, 5).rows, 16u);
  EXPECT_EQ(studies::spectrum_window(problem, 20).rows, 4u);  // two in a period
  EXPECT_THROW((void)studies::spectrum_window(problem, 25), data::FieldError);
  EXPECT_THROW((void)studies::spectrum_window(case_of("paper", {{"excitation.duration", "0.07"}}), 1),
               data::FieldError);
  std::vector<double> tip, force;
  for (int n = 0; n <= 180; ++n) {
    const double phase = 2.0 * std::numbers::pi * 25.0 * 1e-3 * n;
    tip.push_back(n > 100 ? 1e-3 + 2e-3 * std::sin(phase) : n);  // a start that the window leaves out
    force.push_back(3.0 * std::cos(2.0 * phase));
  }
  const auto [is_flat_top, leak, lines] = studies::spectrum_of(tip, force, {80, 2}, 1e-3);
  EXPECT_FALSE(is_flat_top);
  EXPECT_DOUBLE_EQ(lines[2].frequency_hz, 25.0);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    EXPECT_NEAR(lines[k].tip_displacement, k == 0 ? 1e-3 : k == 2 ? 2e-3 : 0.0, 1e-15);
    EXPECT_NEAR(lines[k].friction_force, k == 4 ? 3.0 : 0.0, 1e-12);
  }
}

// Of any period, beside that of the base or with a base that rests. The window falls short of an amplitude by 0.08 % at most.
TEST(HistorySpectrum, HasTheAmplitudesOfOtherPeriods) {
  RandomNumbers numbers(1);
  for (int i = 0; i < 20; ++i) {
    const long periods = i % 2 == 0 ? 0 : 20;
    const double other = numbers.uniform(30.0, 35.0), amplitude = numbers.log_uniform(0.1, 10.0);
    std::vector<double> tip;
    for (int n = 0; n < 2000; ++n) {
      const double phase = 2.0 * std::numbers::pi * n / 2000.0;
      tip.push_back(3.0 + (periods > 0 ? std::sin(20.0 * phase) : 0.0) + amplitude * std::sin(other * phase));
    }
    const auto spectrum = studies::spectrum_of(tip, tip, {2000, periods}, 1e-3);
    EXPECT_TRUE(spectrum.is_flat_top);
    const auto line = [&](double at) {
      return spectrum.lines[static_cast<std::size_t>(std::lround(at))].tip_displacement;
    };
    EXPECT_NEAR(line(other), amplitude, 1e-3 * amplitude) << other;
    EXPECT_NEAR(line(0.0), 3.0, 1e-3 * (1.0 + amplitude)) << other;
    if (periods > 0) {
      EXPECT_NEAR(line(20.0), 1.0, 1e-3 * (1.0 + amplitude)) << other;
    }
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
    EXPECT_LT(largest, studies::most_deflection * problem.beam.length() + 1.0) << each.name;
  }
}

// What no step solves, twice the step of the method does not take either.
TEST(BoundaryIntegralContact, TakesAStepWithOneSolution) {
  const auto problem = case_of("paper", {{"friction.decay", "30"},
                                         {"friction.kinetic_coefficient", "0.01"},
                                         {"beam.axial_force", "5e4"},
                                         {"excitation.duration", "0.0002"},
                                         {"excitation.amplitude", "1e-5"}});
  const double step = studies::boundary_integral_step(problem);
  EXPECT_LT(step, studies::boundary_integral_step(case_of("paper")));
  EXPECT_NO_THROW((void)studies::method("boundary-integral").run(problem, {}, {}, {}));
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
  const auto warnings = studies::warnings_after(problem, studies::Inquiry::stepped_history, history);
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& text) {
    return text.starts_with("at t = 0.3 s the contact is in slip") && holds(text, "at 4 times in all");
  }));
}

// --- Random cases by all methods

using data::ContactEvent;

// What a method finds, with the share of the works and losses that no term of the energy balance explains. A reversal of a few
// modes is a stick, shorter than they resolve, and an onset the other way.
struct Found {
  std::vector<ContactEvent> events{};
  long rows_off_law{};
  double unexplained{};
};

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

data::Case with_step(const data::Case& problem, double step) {
  return with_value(problem, "numerics.time_step", step);
}

Found found_by_elements(const data::Case& problem) {
  solver::BeamSimulation run(problem);
  solver::EnergyRecorder recorder(run.integrator());
  run.observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
  studies::History history;
  for (long n = solver::step_count(problem.numerics.duration(), problem.numerics.time_step()); n > 0; --n) {
    run.step();
    studies::hold_to_law(problem, history,
                         {.time = run.time(),
                          .sliding_velocity = run.sliding_velocity(),
                          .friction_force = run.friction_force(),
                          .state = run.state()});
  }
  const solver::EnergyBalance& energy = recorder.balance();
  const double all = std::abs(energy.base_work) + energy.damping_loss + energy.friction_loss;
  return {without_reversals(run.integrator().events()), history.rows_off_law,
          std::abs(energy.residual()) / all};
}

Found found_by_events(const data::Case& problem, double more_modes) {
  const auto history = studies::event_driven_history(
      with_value(problem, "numerics.modes", more_modes * problem.numerics.modes()), {});
  return {without_reversals(history.events), history.rows_off_law};
}

Found found_by_boundary_integral(const data::Case& problem, double step) {
  const auto history = studies::boundary_integral_history(
      with_step(problem, step), {.times = {problem.numerics.duration()}, .with_midspan = false}, 1);
  Found found{.events = {}, .rows_off_law = history.rows_off_law};
  for (const ContactEvent& event : without_reversals(history.events)) {
    // A step sticks or slips: around a turn one step of slip may stand between two of stick.
    if (event.change == ContactChange::capture && found.events.size() > 1 &&
        event.time - found.events.back().time < 1.5 * step)
      found.events.pop_back();
    else
      found.events.push_back(event);
  }
  return found;
}

// By the modes of the continuous beam. Half of them say how far an event is known.
struct Judge {
  explicit Judge(const data::Case& problem)
      : few(found_by_events(problem, 1.0)), many(found_by_events(problem, 2.0)) {
    EXPECT_EQ(few.rows_off_law + many.rows_off_law, 0);
    const auto energy =
        studies::energy_audit(problem, problem.numerics.duration(), {}, problem.numerics.modes(), {});
    EXPECT_LT(energy.event_driven_unexplained(), 1e-12);  // the tolerance of its steps
  }
  [[nodiscard]] bool is_converged() const { return are_alike(few.events, many.events); }
  Found few, many;
};

// The same changes as the judge, each at its time. From order 1 on the error of the step h is at most the difference to the step 2 h and
// twice that to h/2. The error of the modes, of order 3 in their number, is at most the difference to half of them. Times on steps are
// off by `grid` besides. The end of a stick that is shorter than h, or that the modes have as a reversal, is as uncertain as the
// stick is long. Returns the orders that the differences show.
std::vector<double> expect_changes(const Judge& judge, const Found& twice, const Found& own,
                                   const Found& half, double h, double grid) {
  std::vector<double> orders;
  if (!judge.is_converged()) return orders;
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
                                  grid + (is_short ? stick(own) : 0.0),
                              1.0, "step and modes")))
        << i;
    if (!is_short && std::min(coarse, fine) > 1e-6 * h) orders.push_back(std::log2(coarse / fine));
  }
  return orders;
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

const CaseDomain slipping{.lowest_force = 0.01,
                          .lowest_load = 1.2,
                          .longest = 3.0,
                          .lowest_frequency = 0.1,
                          .kelvin_voigt = 1.0,
                          .moving_wall = 0.3};

double mean(const std::vector<double>& values) {
  return std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
}

STICKSLIP_VERIFIES(RandomHistories, "D4");
TEST(RandomHistories, OfElementsAgreeWithEvents) {
  std::vector<double> orders, energy_orders;
  on_motions(8, slipping, [&](const data::Case& problem) {
    const double h = problem.numerics.time_step();
    const Found twice = found_by_elements(with_step(problem, 2.0 * h)), own = found_by_elements(problem),
                half = found_by_elements(with_step(problem, 0.5 * h));
    EXPECT_EQ(twice.rows_off_law + own.rows_off_law + half.rows_off_law, 0);
    // (omega h)^2/12 of a work by the trapezoidal rule; mode 10 has 50 steps in a period.
    EXPECT_TRUE(within(own.unexplained, 0.0,
                       discretisation(std::pow(2.0 * std::numbers::pi / 50.0, 2) / 12.0, 1.0, "the rule")));
    energy_orders.push_back(0.5 * std::log2(twice.unexplained / half.unexplained));
    const auto these = expect_changes(Judge(problem), twice, own, half, h, 0.0);
    orders.insert(orders.end(), these.begin(), these.end());
  });
  ASSERT_GT(orders.size(), 20u);
  EXPECT_GT(mean(orders), 1.5);  // 2, and 1 where changes are not located
  // 2; where a force jumps, modes with eta omega_n^2 h > 1 leave a sum of n^-4 from n ~ h^-1/4 on, which is of order 3/4.
  EXPECT_GT(mean(energy_orders), 0.75);
}

TEST(RandomHistories, OfTheBoundaryIntegralAgreeWithEvents) {
  CaseDomain quick = slipping;
  quick.longest = 1.5, quick.lowest_frequency = 0.3, quick.ratio = quick.moving_wall = quick.jump = 0.0;
  quick.yielding = 0.2;
  int compared = 0;
  on_motions(8, quick, [&](const data::Case& problem) {
    const double h = studies::boundary_integral_step(problem);
    if (problem.numerics.duration() > 1e5 * h) return;
    const Found own = found_by_boundary_integral(problem, h);
    EXPECT_EQ(own.rows_off_law, 0);
    if (!problem.contact.is_rigid()) return;
    const Judge judge(problem);
    compared += judge.is_converged() ? 1 : 0;
    // A change stands on a step, and means over that step and its neighbours decide which one.
    std::ignore = expect_changes(judge, own, own, own, h, 3.0 * h);
  });
  EXPECT_GT(compared, 2);
}

// With a spring, a smooth law, shear and without damping as well, with the default step and with 80 steps a period.
TEST(RandomHistories, OfElementsObeyTheLaw) {
  CaseDomain all = slipping;
  all.kelvin_voigt = 0.5, all.shear = all.yielding = 0.3;
  on_motions(8, all, [&](const data::Case& problem) {
    const data::Case coarse = with_step(problem, 1.0 / (80.0 * problem.excitation.frequency_hz()));
    for (const data::Case& each : {problem, coarse, with_value(coarse, "numerics.spectral_radius", 0.9)}) {
      EXPECT_EQ(studies::finite_element_history(each).rows_off_law, 0) << each.numerics.time_step();
    }
  });
}

// A spectral radius that lets stiff modes turn over in each step may invent changes, but then the run says so.
TEST(RandomHistories, OfAnyRadiusAgreeWithEventsOrSaySo) {
  int right = 0, wrong = 0;
  on_motions(8, slipping, [&](const data::Case& drawn) {
    const data::Case problem = with_value(drawn, "numerics.spectral_radius", 0.9);
    const Judge judge(problem);
    if (!judge.is_converged()) return;
    const studies::History history = studies::finite_element_history(problem);
    const bool is_right = are_alike(without_reversals(history.events), judge.many.events);
    (is_right ? right : wrong) += 1;
    const auto warnings = studies::warnings_after(problem, studies::Inquiry::stepped_history, history);
    EXPECT_TRUE(is_right || std::ranges::any_of(warnings, [](const std::string& text) {
                  return holds(text, "the radius 0 ends it");
                }));
  });
  EXPECT_GT(std::min(right, wrong), 0);
}

}  // namespace
}  // namespace stickslip::testing
