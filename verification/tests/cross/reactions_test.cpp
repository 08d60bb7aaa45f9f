// SPDX-License-Identifier: MIT
/// What the base must apply to a beam, and the acceleration of its tip, by time steps (the equations of the clamp) and from event to
/// event (the balance of momentum).

#include <cmath>

#include "stickslip/data/case_file.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "support/structures.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using studies::History;
using studies::HistoryRow;

History history_of(const studies::Method& method, const data::Case& problem,
                   const std::vector<double>& times) {
  method.require(problem);
  return method.run(problem, {.times = times, .with_reactions = true}, {}, {});
}

// The largest difference of a column over the rows in the same state, as a share of its largest value.
double difference(const History& a, const History& b, double HistoryRow::*column) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    size = std::max(size, std::abs(b.rows[i].*column));
    if (a.rows[i].state == b.rows[i].state)
      error = std::max(error, std::abs(a.rows[i].*column - b.rows[i].*column));
  }
  return error / size;
}

// A beam-column with z = L sqrt(P/EI) and its tip held, on a base that has moved by h:
//
//     R = P k h/(tan z - z),    M = P tan(z) h/(tan z - z),    k = z/L.
//
// Of the size 3 EI h/L^3 without P, the inertia adds 79 (Ω/ω_1)², and P makes both larger near buckling.
STICKSLIP_VERIFIES(BaseReactions, "X9");
TEST(BaseReactions, OfASlowBaseAreStatic) {
  constexpr double slowness = 2e-3;
  on_random_beams(4, {0.05, 0.9}, [](const data::Beam& beam, RandomNumbers& numbers) {
    const double omega = slowness * frequency_unit(beam) * 15.4, h = 1e-9 * beam.length();
    data::Case problem = random_problem(numbers, beam, 0.9, {omega / (2.0 * std::numbers::pi), h, {}}, 0.0);
    const double quarter = 0.25 / problem.excitation().frequency_hz();
    problem = with_values(problem, {{"excitation.duration", quarter},
                                    {"numerics.time_step", quarter / 100.0},
                                    {"numerics.elements", 20.0},
                                    {"numerics.modes", 10.0},
                                    {"beam.axial_direction", numbers.uniform(0.0, 1.0)}});
    const double length = beam.length(), z = length * std::sqrt(beam.axial_force() / rigidity(beam)),
                 scale = beam.axial_force() * h / (std::tan(z) - z), nearness = nearness_of_buckling(beam),
                 size = 3.0 * rigidity(beam) * h / std::pow(length, 3) * nearness;
    for (const auto* method : {&studies::event_driven(), &studies::finite_elements()}) {
      SCOPED_TRACE(method->name);
      const HistoryRow row = history_of(*method, problem, {quarter}).rows.front();
      // Twenty elements are off by (z/20)^4/720 where the beam buckles, and by rounding, 20^4 eps.
      const double share =
          slowness * slowness * 79.0 * nearness + std::pow(z / 20.0, 4) / 720.0 * nearness + 1e-9;
      const Tolerance force = discretisation(share * size, 1.0, "inertia and mesh"),
                      moment = discretisation(share * size * length, 1.0, "inertia and mesh");
      EXPECT_TRUE(within(row.base_reaction, scale * z / length, force));
      EXPECT_TRUE(within(row.clamp_moment, scale * std::tan(z), moment));
      EXPECT_TRUE(within(row.tip_acceleration, 0.0, round_off(1.0, 1.0, omega * omega * h)));
    }
  });
}

// What differs is the state of the two methods, and in slip what mesh, modes and step leave out of the acceleration: shares of the
// largest value of a column, empirical. Returns whether the changes of contact are as many, without which there is no comparison.
bool expect_alike(const data::Case& problem, double acceleration, double others) {
  const double duration = problem.numerics.duration();
  const std::vector<double> times = studies::sample_times(duration, duration / 200.0);
  const History fe = history_of(studies::finite_elements(), problem, times),
                events = history_of(studies::event_driven(), problem, times);
  if (fe.events.size() != events.events.size()) return false;
  for (const studies::FurtherColumn& column : studies::further_columns) {
    if (column.of_beams_alone && problem.model() != nullptr) continue;
    const bool is_acceleration = column.value == &HistoryRow::tip_acceleration;
    EXPECT_TRUE(within(difference(fe, events, column.value), 0.0,
                       reference(is_acceleration ? acceleration : others, "both, empirical"),
                       std::string(column.name)));
  }
  return true;
}

// A sine, or that with another one that starts without a jump of the acceleration as well.
data::Motion sine_or_sum(const data::HarmonicMotion& sine, double duration, RandomNumbers& numbers) {
  if (numbers.whole(0, 1) == 0) return data::HarmonicExcitation(sine);
  return data::GeneralMotion(
      std::vector<data::Sine>{{sine.frequency_hz, sine.amplitude, sine.amplitude_of, 0.0},
                              {1.7 * sine.frequency_hz, 0.3 * sine.amplitude, sine.amplitude_of, 0.0}},
      duration);
}

TEST(BaseReactions, OfABeamAreThoseOfTwoMethods) {
  int compared = 0;
  const CaseDomain domain{.lowest_load = 0.5,
                          .longest = 4.0,
                          .lowest_frequency = 0.3,
                          .highest_frequency = 2.0,
                          .kelvin_voigt = 1.0,
                          .jump = 0.0};
  on_random_cases(6, domain, [&](const CaseText& text, RandomNumbers& numbers) {
    data::Case problem = text.problem();
    problem.motion = sine_or_sum(problem.excitation().motion(), problem.numerics.duration(), numbers);
    compared += expect_alike(problem, 0.2, 0.02);
  });
  EXPECT_GE(compared, 4);
}

TEST(BaseReactions, OfAStructureAreThoseOfTwoMethods) {
  on_random_structures(12, {.most_rows = 12, .damping = 4.0}, [](auto matrices, RandomNumbers& numbers) {
    for (const auto& [row, weight] : matrices.contact) matrices.mass.push_back({row, row, 1.0});
    const bool is_force = numbers.whole(0, 2) == 0;
    const data::HarmonicMotion sine{numbers.uniform(3.0, 10.0), is_force ? 10.0 : 1.0,
                                    is_force ? data::AmplitudeOf::force : data::AmplitudeOf::acceleration};
    data::Case problem = with_values(data::load_case("paper"), {{"excitation.duration", 0.4},
                                                                {"numerics.time_step", 2e-5},
                                                                {"numerics.velocity_threshold", 0.0},
                                                                {"numerics.modes", 200.0},
                                                                {"friction.kinetic_coefficient", 0.5},
                                                                {"friction.decay", 1.0}});
    problem.motion = data::HarmonicExcitation(sine);
    problem = with_matrices(problem, std::move(matrices));
    problem.motion = sine_or_sum(sine, 0.4, numbers);
    problem.damping = data::Damping({.kelvin_voigt = numbers.uniform(0.0, 2e-3),
                                     .ratio = {},
                                     .mass_proportional = numbers.uniform(0.0, 2.0),
                                     .ratios = {}});
    problem.contact.wall = data::Wall({.with_base = numbers.whole(0, 1) == 0});
    problem.structure = data::Model(numbers.log_uniform(1.0, 10.0), problem.model()->shared_matrices());
    EXPECT_TRUE(expect_alike(problem, 1e-3, 1e-3));
  });
}

// R = m a + f - F_c - F of one mass.
TEST(BaseReactions, BalanceTheMomentumOfOneMass) {
  for (const char* name : {"incline-slides", "sdnd100", "den-hartog"}) {
    const data::Case problem = with_value(data::load_case(name), "numerics.velocity_threshold", 0.0);
    const double duration = problem.numerics.duration(), mass = problem.model()->properties().mass,
                 omega = studies::angular_frequency(problem.excitation()),
                 load = problem.is_force() ? omega * omega * problem.excitation().amplitude() : 0.0;
    for (const auto* method : {&studies::event_driven(), &studies::finite_elements()}) {
      const History history = history_of(*method, problem, studies::sample_times(duration, duration / 100.0));
      for (const HistoryRow& row : history.rows) {
        const double inertia = mass * row.tip_acceleration,
                     forces = row.friction_force - problem.constant_force - load * std::sin(omega * row.time);
        EXPECT_TRUE(within(row.base_reaction, inertia + forces,
                           round_off(100.0, 1.0, std::abs(inertia) + std::abs(row.friction_force) + load)))
            << name << method->name << row.time;
      }
    }
  }
}

}  // namespace
}  // namespace stickslip::testing
