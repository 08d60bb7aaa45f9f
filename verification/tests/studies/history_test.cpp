// SPDX-License-Identifier: MIT
/// Histories by all methods: their rows, events and estimated error, and what each method refuses.

#include "studies/history/history.hpp"
#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
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
    return case_of(method().refused.contains(Feature::kelvin_voigt) ? "paper" : "damped");
  }
};

STICKSLIP_VERIFIES(HistoryBy, "X9");
// The first slip is at 0.0552 s without damping, 0.0553 s with it.
void expect_first_slip(const studies::History& history, bool has_events) {
  ASSERT_TRUE(history.first_slip.has_value());
  EXPECT_NEAR(*history.first_slip, 0.05525, 1.5e-4);
  EXPECT_EQ(history.events.empty(), !has_events);
  if (history.events.empty()) return;
  EXPECT_EQ(history.events.front().change, ContactChange::onset);
  EXPECT_EQ(history.events.front().time, *history.first_slip);
  for (const auto& event : history.events) {
    // Within a step of the event the tip moves by less than 0.5 m/s times the step.
    const auto after = std::ranges::find_if(
        history.rows, [&](const studies::HistoryRow& row) { return row.time >= event.time; });
    if (after == history.rows.end()) continue;
    EXPECT_NEAR(after->tip_displacement, event.position, 0.5e-4);
  }
}

TEST_P(HistoryBy, HasTheRowsOfItsSamplingAndTheFirstSlip) {
  const double h = problem().numerics.time_step();
  const auto all = method().run(problem(), {}, {}, {});
  expect_first_slip(all, !method().refused.contains(Feature::slip));
  ASSERT_EQ(all.rows.size(), static_cast<std::size_t>(std::lround(0.08 / h)) + 1);
  std::vector<studies::HistoryRow> some;  // given to a sink, and not kept
  const auto none = method().run(problem(), {.every = 7}, {}, [&](const auto& row) { some.push_back(row); });
  EXPECT_TRUE(none.rows.empty());
  ASSERT_EQ(some.size(), (all.rows.size() - 1) / 7 + 1);
  const double length = problem().beam.length();
  const auto chosen = method().run(
      problem(), {.times = {7 * h, 21 * h, 700 * h}, .positions = {0.0, 0.5 * length, length}}, {}, {});
  ASSERT_EQ(chosen.rows.size(), 3u);
  const Tolerance rounding = round_off(100, 100, 1e-3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t n = std::vector<std::size_t>{7, 21, 700}[i];
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
    tip.push_back(1e-3 + 2e-3 * std::sin(phase));
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
    const auto line = [&](double at) { return spectrum.lines[std::lround(at)].tip_displacement; };
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
                                         {"excitation.duration", "0.002"},
                                         {"excitation.amplitude", "1e-5"}});
  const double step = studies::boundary_integral_step(problem);
  EXPECT_LT(step, studies::boundary_integral_step(case_of("paper")));
  EXPECT_NO_THROW((void)studies::method("boundary-integral").run(problem, {}, {}, {}));
}

// A reversal of a few modes is a stick, shorter than they resolve, and an onset the other way.
std::string kinds(const studies::History& history) {
  std::string text;
  for (const auto& event : history.events)
    text += event.change == ContactChange::reversal ? "co" : std::string(1, data::to_string(event.change)[0]);
  return text;
}

STICKSLIP_VERIFIES(DampedHistories, "D4");
TEST(DampedHistories, ObeyTheLawAndHaveTheSameChanges) {
  const CaseDomain domain{
      .lowest_force = 0.01, .lowest_load = 1.2, .longest = 3.0, .lowest_frequency = 0.1, .kelvin_voigt = 1.0};
  on_random_cases(8, domain, [](const CaseText& text, RandomNumbers&) {
    const data::Case problem = text.problem();
    const double period = 1.0 / problem.excitation.frequency_hz();
    const auto with_modes = [&](double factor) {
      return studies::event_driven_history(
          with_value(problem, "numerics.modes", factor * problem.numerics.modes()), {});
    };
    const studies::History events = with_modes(2.0);
    EXPECT_EQ(events.rows_off_law, 0);
    const studies::History own = studies::finite_element_history(problem);
    EXPECT_EQ(own.rows_off_law, 0);
    if (kinds(with_modes(1.0)) == kinds(events)) {
      EXPECT_EQ(kinds(own), kinds(events));
    }
    for (const double radius : {0.0, 0.9}) {
      const data::Case stated =
          with_values(problem, {{"numerics.time_step", period / 80.0}, {"numerics.spectral_radius", radius}});
      EXPECT_EQ(studies::finite_element_history(stated).rows_off_law, 0) << radius;
    }
  });
}

}  // namespace
}  // namespace stickslip::testing
