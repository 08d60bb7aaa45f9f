// SPDX-License-Identifier: MIT
/// The criterion over any two parameters of a case, and over beam length and axial force, Fig. 14.

#include "studies/analyses/criterion_map.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "support/random_cases.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using studies::map_axis;

data::Case flat_case_of(double duration) { return with_value(flat_case(), "excitation.duration", duration); }

// The case of a cell.
data::Case case_of(const data::Case& problem, const studies::MapAxis& x, const studies::MapAxis& y,
                   const studies::CriterionMap::Cell& cell) {
  return with_value(with_value(problem, x.parameter, cell.x), y.parameter, cell.y);
}

STICKSLIP_VERIFIES(MapAxis, "X7");
TEST(MapAxis, HasEqualStepsOrRatios) {
  const auto steps = map_axis("beam.length", 0.4, 2.0, 5, false).values;
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_EQ(steps.front(), 0.4);
  EXPECT_EQ(steps.back(), 2.0);
  EXPECT_DOUBLE_EQ(steps[2], 1.2);
  EXPECT_FALSE(map_axis("beam.length", 0.4, 2.0, 5, false).logarithmic);
  EXPECT_TRUE(map_axis("beam.axial_force", 7.0, 700.0, 3, true).logarithmic);
  const auto ratios = map_axis("beam.axial_force", 7.0, 700.0, 3, true).values;
  EXPECT_EQ(ratios.front(), 7.0);
  EXPECT_EQ(ratios.back(), 700.0);
  EXPECT_DOUBLE_EQ(ratios[1], 70.0);
  EXPECT_EQ(map_axis("beam.length", 7.0, 29.0, 3, true).values.back(), 29.0);  // 7 (29/7) is not
}

TEST(MapAxis, ChangesItsParameterAlone) {
  data::Case problem = flat_case();
  const auto before = data::numbers_of(problem);
  for (const auto& [path, value] : before) {
    const bool is_integer = data::key_named(path).member.is_integer;
    const double other = is_integer || path == "excitation.duration" ? 35.0 : 0.35;
    auto expected = before;
    expected.at(path) = other;
    const data::Case changed = with_value(problem, path, other);
    EXPECT_EQ(data::numbers_of(changed), expected) << path;
    EXPECT_EQ(value_of(changed, path), other) << path;
  }
  const auto kinetic = [&](double value) {
    return with_value(problem, "friction.static_coefficient", value).contact.friction.kinetic_coefficient();
  };
  EXPECT_EQ(kinetic(0.2), 0.2);
  EXPECT_EQ(kinetic(0.0), 0.0);
  problem.structure = studies::with_shear(problem.beam());
  EXPECT_DOUBLE_EQ(with_value(problem, "beam.youngs_modulus", 3e9).beam().shear_stiffness(),
                   3e9 * problem.beam().area() / 3.12);
  EXPECT_EQ(studies::without_shear(problem.beam()).shear_stiffness(), 0.0);
  const data::Case paper = data::load_case("paper");
  EXPECT_DOUBLE_EQ(studies::friction_limit(paper), 300.0);
  EXPECT_DOUBLE_EQ(studies::angular_frequency(paper.excitation()), 157.07963267948966);
  EXPECT_TRUE(paper.damping.is_none());
  for (const auto parameter : {"damping.ratio", "damping.kelvin_voigt"})
    EXPECT_FALSE(with_value(paper, parameter, 1e-12).damping.is_none());
}

STICKSLIP_VERIFIES(CriterionMap, "X7");
// Values of one number of a case, around its own; a number that may be 0 has that as well.
studies::MapAxis axis_of(const data::Case& problem, std::string_view key) {
  const double value = value_of(problem, key), omega = studies::two_pi * data::highest_frequency_hz(problem);
  if (key == "damping.ratio") return {.parameter = key, .values = {0.0, 0.01}};
  if (key == "damping.kelvin_voigt") return {.parameter = key, .values = {0.0, 0.02 / omega}};
  if (key == "beam.axial_direction") return {.parameter = key, .values = {0.0, 0.6}};
  if (key == "excitation.amplitude" || key == "excitation.scale")
    return {.parameter = key, .values = {0.0, 0.5 * value, 2.0 * value}};
  return {.parameter = key, .values = {0.6 * value, 1.3 * value}};
}

struct Seen {
  int stick{}, slip{}, buckled{};

  void expect_criterion(const data::Case& point, const studies::CriterionMap::Cell& cell) {
    const bool is_buckled = point.beam().axial_force() >= analytic::stick_buckling_load(point.beam());
    EXPECT_EQ(cell.state.has_value(), !is_buckled);
    EXPECT_EQ(cell.force_ratio.has_value(), !is_buckled);
    if (is_buckled) return void(++buckled);
    const auto criterion = analytic::evaluate_criterion(point);
    const double ratio = criterion.force_max.midpoint() / criterion.friction_limit;
    EXPECT_TRUE(
        within(*cell.force_ratio, ratio, reference(3e-10 * ratio, "the relative width of the bounds")));
    EXPECT_EQ(cell.state, criterion.verdict);
    ++(criterion.verdict == analytic::Verdict::stick ? stick : slip);
  }

  void expect_map(const data::Case& problem, const studies::MapAxis& x, const studies::MapAxis& y) {
    SCOPED_TRACE(fmt::format("{} {}", x.parameter, y.parameter));
    const auto map = studies::criterion_map({.problem = problem, .x = x, .y = y});
    const auto states = studies::criterion_map({.problem = problem, .x = x, .y = y, .states_only = true});
    ASSERT_EQ(map.cells.size(), x.values.size() * y.values.size());
    for (std::size_t n = 0; n < map.cells.size(); ++n) {
      const auto& cell = map.cells[n];
      EXPECT_EQ(cell.x, x.values[n % x.values.size()]);
      EXPECT_EQ(cell.y, y.values[n / x.values.size()]);
      expect_criterion(case_of(problem, x, y, cell), cell);
      EXPECT_EQ(states.cells[n].state, cell.state);
      EXPECT_FALSE(states.cells[n].force_ratio);
    }
  }
};

// Over any two numbers of a random case: which cells share modes, forces or a table depends on the two.
TEST(CriterionMap, HoldsTheCriterionOfEachCell) {
  const std::vector<std::string_view> keys{"excitation.frequency_hz",
                                           "excitation.amplitude",
                                           "excitation.duration",
                                           "beam.length",
                                           "beam.axial_force",
                                           "beam.youngs_modulus",
                                           "beam.density",
                                           "beam.axial_direction",
                                           "section.height",
                                           "damping.ratio",
                                           "friction.static_coefficient",
                                           "damping.kelvin_voigt"};
  Seen seen;
  const CaseDomain domain{.shortest = 0.5, .kelvin_voigt = 0.3, .ratio = 0.3};
  on_random_cases(4, domain, [&](const CaseText& text, RandomNumbers& numbers) {
    const auto statement = data::amplitude_keys.at(static_cast<std::size_t>(numbers.whole(0, 2)));
    const data::Case drawn = with_value(text.problem(), "numerics.modes", numbers.whole(2, 12)),
                     problem = with_value(drawn, statement, value_of(drawn, statement));
    for (const auto one : keys)
      for (const auto other : keys)
        if (one < other) {
          const auto [x, y] = numbers.whole(0, 1) == 0 ? std::pair(one, other) : std::pair(other, one);
          seen.expect_map(problem, axis_of(problem, x), axis_of(problem, y));
        }
  });
  EXPECT_GT(std::min({seen.stick, seen.slip, seen.buckled}), 20);
  // Under any motion, which has no frequency and a scale in place of its amplitude; with that of the wall it is no factor.
  Seen of_motions;
  on_random_cases(4, {.shortest = 0.5, .any_motion = 1.0}, [&](const CaseText& text, RandomNumbers&) {
    const data::Case problem = with_value(text.problem(), "numerics.modes", 4);
    for (const auto key : {"beam.length", "damping.ratio", "friction.static_coefficient"})
      of_motions.expect_map(problem, axis_of(problem, "excitation.scale"), axis_of(problem, key));
  });
  EXPECT_GT(std::min(of_motions.stick, of_motions.slip), 5);
  // With shear a map over the frequency shares one reaction, and one over the length does not.
  data::Case sheared = data::load_case("paper");
  sheared.structure = studies::with_shear(sheared.beam());
  for (const auto key : {"excitation.frequency_hz", "beam.length"})
    seen.expect_map(sheared, axis_of(sheared, key), axis_of(sheared, "excitation.amplitude"));
}

TEST(CriterionMap, CostEstimateLeavesTheThreads) {
  const studies::MapTask task{.problem = with_values(flat_case_of(0.1), {{"numerics.elements", 4}}),
                              .x = map_axis("excitation.frequency_hz", 5.0, 50.0, 20, false),
                              .y = map_axis("excitation.amplitude", 0.0, 1e-3, 3, false),
                              .method = &studies::finite_elements()};
  for (const unsigned count : {1u, 2u}) {
    const studies::ScopedThreadCount threads(count);
    const auto estimate = studies::map_estimate(task);
    EXPECT_EQ(studies::thread_count(), count);
    EXPECT_EQ(estimate.threads, count);
    EXPECT_EQ(estimate.evaluations, 20u);
    EXPECT_GT(estimate.sample, 0u);
    EXPECT_GT(estimate.seconds_each, 0.0);
    EXPECT_TRUE(count > 1 || estimate.speedup == 1.0);
  }
  const studies::MapEstimate hours{.evaluations = 7200, .seconds_each = 2.0, .speedup = 4.0};
  EXPECT_EQ(hours.core_hours(), 4.0);
  EXPECT_EQ(hours.hours(), 1.0);
}

// An undamped map steps in modal coordinates, which give the plain run's force to 1e-10; over 5000 steps in more than one batch of
// their blocks.
TEST(CriterionMap, ByElementsIsThatOfPlainRuns) {
  struct Run {
    double kelvin_voigt, duration;
    int elements;
  };
  const auto x = map_axis("excitation.frequency_hz", 20.0, 60.0, 2, false);
  const double load = analytic::stick_buckling_load(flat_beam(2.0, 0.0));
  const studies::MapAxis y{.parameter = "beam.axial_force", .values = {0.5 * load, load, 2.0 * load}};
  for (const auto& [kelvin_voigt, duration, elements] :
       {Run{0.0, 0.05, 20}, {1e-5, 0.05, 20}, {0.0, 0.5, 4}}) {
    const data::Case problem = with_values(
        flat_case_of(duration), {{"numerics.elements", elements}, {"damping.kelvin_voigt", kelvin_voigt}});
    const auto map =
        studies::criterion_map({.problem = problem, .x = x, .y = y, .method = &studies::finite_elements()});
    ASSERT_EQ(map.cells.size(), 6u);
    for (std::size_t n = 0; n < 6; ++n) {
      EXPECT_EQ(map.cells[n].state.has_value(), n < 2);
      if (n >= 2) continue;
      const data::Case point = case_of(problem, x, y, map.cells[n]);
      const double ratio =
          solver::max_abs_friction_force(point, solver::Coordinates::nodal) / studies::friction_limit(point);
      EXPECT_TRUE(
          within(*map.cells[n].force_ratio, ratio, reference(1e-10 * ratio, "runs in modal coordinates")));
    }
  }
}

// Cells along the amplitude or the friction share an evaluation.
TEST(CriterionMap, OfAPartMakesItsCellsAlone) {
  const auto hz = map_axis("excitation.frequency_hz", 5.0, 50.0, 4, false);
  const auto amplitude = map_axis("excitation.amplitude", 0.0, 1e-3, 3, false);
  for (const auto& [x, y] : {std::pair(hz, amplitude), {amplitude, hz}}) {
    studies::MapTask task{.problem = flat_case_of(0.1), .x = x, .y = y};
    EXPECT_EQ(studies::evaluation_count(task), 4u);
    const auto whole = studies::criterion_map(task).cells;
    for (const std::size_t parts : {1u, 2u, 5u, 30u}) {
      std::size_t made = 0;
      for (std::size_t part = 1; part <= parts; ++part) {
        task.part = {part, parts};
        EXPECT_LE(studies::evaluation_count(task), (12 + parts - 1) / parts);
        for (const auto& cell : studies::criterion_map(task).cells) {
          ASSERT_LT(made, whole.size());
          EXPECT_EQ(cell.x, whole[made].x);
          EXPECT_EQ(cell.y, whole[made].y);
          EXPECT_EQ(cell.force_ratio, whole[made++].force_ratio);
        }
      }
      EXPECT_EQ(made, whole.size()) << parts;
    }
  }
  studies::MapTask none{.problem = flat_case_of(0.1), .x = hz, .y = amplitude, .part = {1, 30}};
  EXPECT_EQ(studies::evaluation_count(none), 0u);
  EXPECT_THROW((void)studies::map_estimate(none), std::invalid_argument);
}

TEST(CriterionMap, RefusesWhatHasNoCriterion) {
  const data::Case problem = flat_case_of(0.1);
  const auto hz = map_axis("excitation.frequency_hz", 5.0, 50.0, 2, false);
  const auto map = [&](const data::Case& of, const studies::MapAxis& y) {
    return studies::criterion_map({.problem = of, .x = hz, .y = y});
  };
  EXPECT_THROW((void)map(problem, hz), std::invalid_argument);
  for (const studies::MapAxis& axis : {map_axis("beam.length", -1.0, 2.0, 2, false),
                                       map_axis("friction.static_coefficient", 0.0, 1.0, 2, false),
                                       {.parameter = "excitation.amplitude", .values = {1e-3, -1e-3}}})
    EXPECT_THROW((void)map(problem, axis), data::FieldError) << axis.parameter;
  EXPECT_THROW((void)map(problem, map_axis("beam.axial_force", 0.0, 1.0, 2, false)), data::InputError);
  const auto amplitude = map_axis("excitation.amplitude", 0.0, 1e-3, 2, false);
  for (const double force : {2000.0, -5.0})
    EXPECT_THROW((void)map(with_value(problem, "beam.axial_force", force), amplitude), data::InputError);
}

STICKSLIP_VERIFIES(ResonanceLength, "X7");
TEST(ResonanceLength, IsInResonance) {
  for (const int mode : {1, 2})
    for (const double force : {0.0, 5.0, 500.0, 1500.0}) {
      const auto length = studies::resonance_length(flat_beam(1.0, force), mode, 25.0);
      ASSERT_TRUE(length) << mode << ", " << force;
      // The frequency falls with the square of the length or faster; 1e-9 m is far over what the bisection leaves.
      const auto hz = [&](double of) {
        return analytic::stick_modes(flat_beam(of, force), mode).back().frequency_hz();
      };
      EXPECT_GT(hz(*length - 1e-9), 25.0) << mode << ", " << force;
      EXPECT_LT(hz(*length + 1e-9), 25.0) << mode << ", " << force;
    }
}

TEST(ResonanceLength, IsNoneIfTheBeamBuckles) {
  // Mode 2 meets 25 Hz at about 1.5 m, where the section buckles at 20.19 EI/L^2 = 2.4 kN; mode 1 vibrates at
  // any frequency before it buckles.
  EXPECT_FALSE(studies::resonance_length(flat_beam(1.0, 4000.0), 2, 25.0));
  EXPECT_TRUE(studies::resonance_length(flat_beam(1.0, 4000.0), 1, 25.0));
}

STICKSLIP_VERIFIES(LengthForceMap, "X7");
TEST(LengthForceMap, HoldsTheCriterionOfEachPoint) {
  const data::Case problem = flat_case();
  const auto map = studies::length_force_map(problem, 0.4, 2.0, {50.0, 4000.0});
  ASSERT_EQ(map.lines.size(), 2u);
  for (const auto& line : map.lines) {
    EXPECT_EQ(line.length.size(), map.lines.front().length.size());
    EXPECT_EQ(line.length.front(), 0.4);
    EXPECT_TRUE(std::ranges::is_sorted(line.length));
    // Next to a resonance lengths are a tenth and less as far apart as on the average.
    for (const auto& resonance : {line.resonance_1, line.resonance_2}) {
      if (!resonance) continue;
      const auto at = std::ranges::find(line.length, *resonance);
      ASSERT_NE(at, line.length.end());
      EXPECT_LT(*(at + 1) - *(at - 1), 0.2 * 1.6 / 131.0);
    }
    // 40, 60 and 30 steps, which grow as the square of their number from a resonance on.
    const auto& lengths = line.length;
    ASSERT_EQ(lengths.size(), 131u);
    EXPECT_EQ(lengths[40], line.resonance_1.value_or(lengths[130]));
    EXPECT_EQ(lengths[100], line.resonance_2.value_or(lengths[130]));
    EXPECT_DOUBLE_EQ(lengths[20], std::lerp(lengths[40], lengths[0], 0.25));
    EXPECT_DOUBLE_EQ(lengths[55], std::lerp(lengths[40], lengths[100], 0.125));
    EXPECT_DOUBLE_EQ(lengths[85], std::lerp(lengths[100], lengths[40], 0.125));
    EXPECT_DOUBLE_EQ(lengths[115], std::lerp(lengths[100], lengths[130], 0.25));
    for (std::size_t i = 0; i < line.length.size(); i += 13) {
      const auto criterion =
          analytic::evaluate_criterion(with(problem, flat_beam(line.length[i], line.axial_force)));
      const double ratio = criterion.force_max.midpoint() / criterion.friction_limit;
      EXPECT_TRUE(within(line.force_ratio[i], ratio, reference(1e-3 * ratio, "the stated 0.1 %")))
          << line.length[i] << " m, " << line.axial_force << " N";
    }
  }
  // Far from buckling the force is largest at the first resonance.
  const auto& ratios = map.lines[0].force_ratio;
  EXPECT_EQ(std::ranges::max_element(ratios) - ratios.begin(), 40);
  EXPECT_EQ(map.lines[0].length.back(), 2.0);
  const double buckling = map.lines[1].buckling_length;
  EXPECT_DOUBLE_EQ(map.lines[1].length.back(), 0.999 * buckling);
  EXPECT_TRUE(
      within(analytic::stick_buckling_load(flat_beam(buckling, 0.0)), 4000.0, round_off(10, 2, 4000.0)));
}

TEST(LengthForceMap, StatesTheCaseAndItsLimits) {
  const data::Case problem = flat_case();
  const auto map = studies::length_force_map(problem, 0.4, 0.5, {50.0});
  EXPECT_EQ(map.frequency_hz, 25.0);
  const double z = std::sqrt(map.buckling_coefficient);  // tan z = z, with the condition number z^2 = 20
  EXPECT_TRUE(within(std::tan(z) / z, 1.0, round_off(50, 1, 1.0)));
  const double height = map.section_height, width = map.section_width;
  EXPECT_DOUBLE_EQ(width * height, problem.beam().area());
  EXPECT_DOUBLE_EQ(width * height * height * height / 12.0, problem.beam().second_moment_of_area());
  ASSERT_EQ(map.resonance_lengths.size(), 2U);
  for (const int mode : {1, 2})
    EXPECT_EQ(map.resonance_lengths[static_cast<std::size_t>(mode - 1)],
              studies::resonance_length(problem.beam(), mode, 25.0));
}

}  // namespace
}  // namespace stickslip::testing
