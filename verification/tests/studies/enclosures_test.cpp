// SPDX-License-Identifier: MIT
/// The bounds of the largest friction force with all modes, and the verdict on them, against finite elements.

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"
#include "support/random_cases.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Verdict;

// Short durations, in which the start decides, as likely as long ones.
constexpr CaseDomain domain{.highest_force = 0.9,
                            .shortest = 0.002,
                            .longest = 1.0,
                            .lowest_frequency = 0.5,
                            .highest_frequency = 3.0,
                            .resonant = 0.1};

// By elements in steps, the tip bonded; `finer` is 1/2, 1 or 2.
double force_by_elements(const data::Case& problem, double finer) {
  // Steps that divide the duration, at the end of which |f| may be largest.
  const double duration = problem.numerics.duration();
  const double step = duration / std::ceil(std::max(duration / problem.numerics.time_step(), 400.0));
  return solver::max_abs_friction_force(data::with_values(
      problem,
      {{"numerics.elements", 40.0 * finer}, {"numerics.time_step", step / std::max(1.0, finer * finer)}}));
}

struct Truth {
  double force{}, error{};  // N
};
// The error falls at least in proportion to the step, where damping makes the force jump at the start: that of the finest run is at most
// the difference to the one before. In a short undamped start, in which waves run, two may be alike by chance: so the spread of three.
Truth by_elements(const data::Case& problem) {
  const double rough = force_by_elements(problem, 0.5), middle = force_by_elements(problem, 1.0),
               fine = force_by_elements(problem, 2.0);
  const auto [least, most] = std::minmax({rough, middle, fine});
  return {fine, most - least + 1e-9 * fine};
}

data::Case paper_at(double hz, double amplitude, double duration,
                    const std::vector<std::pair<std::string_view, double>>& more) {
  auto values = more;
  values.insert(values.end(), {{"excitation.frequency_hz", hz},
                               {"excitation.amplitude", amplitude},
                               {"excitation.duration", duration}});
  return data::with_values(data::load_case("paper"), values);
}

STICKSLIP_VERIFIES(Enclosures, "A10");
TEST(Enclosures, HoldTheForceOfFiniteElements) {
  on_random_cases(16, domain, [](const CaseText& text, RandomNumbers&) {
    const data::Case problem = text.problem();
    const auto found = studies::criterion_with_all_modes(problem, 1e-8);
    const auto [lower, upper] = found.force_max;
    ASSERT_TRUE(std::isfinite(upper) && 0.0 <= lower && lower <= upper) << lower << ' ' << upper;
    EXPECT_TRUE(std::isfinite(found.critical_amplitude.upper));
    const auto [force, error] = by_elements(problem);
    EXPECT_LE(lower, force + error) << force << " +- " << error;
    EXPECT_GE(upper, force - error) << force << " +- " << error;
    const auto twice = studies::criterion_with_all_modes(
        data::with_value(problem, "excitation.amplitude", 2.0 * problem.excitation.amplitude()), 1e-8);
    if (twice.verdict == found.verdict) {
      EXPECT_TRUE(within(twice.force_max.upper, 2.0 * upper, round_off(8, 1, 2.0 * upper)));
    }
  });
}

// f(0+) = eta E I S'''(L) A0 Omega: the base sets the bent beam in motion at once.
double jump_of(const data::Case& problem) {
  return problem.damping.kelvin_voigt() * rigidity(problem.beam) *
         std::abs(analytic::QuasiStaticShape(problem.beam).third_derivative(problem.beam.length())) *
         problem.excitation.amplitude() * studies::angular_frequency(problem.excitation);
}

TEST(Enclosures, HoldTheJumpAtTheStart) {
  CaseDomain short_ones = domain;
  short_ones.kelvin_voigt = 1.0, short_ones.ratio = 0.0, short_ones.longest = 0.1,
  short_ones.fixed_direction = 0.0;
  on_random_cases(16, short_ones, [](const CaseText& text, RandomNumbers&) {
    const data::Case problem = text.problem();
    const double jump = jump_of(problem);
    const auto [lower, upper] = studies::criterion_with_all_modes(problem, 1e-8).force_max;
    EXPECT_GE(upper, jump * (1.0 - 1e-12)) << jump;
  });
}

// Where damping is strong, the force falls from there, and a sum of modes overshoots.
TEST(Enclosures, DoNotOvershootTheJump) {
  const data::Case problem =
      data::parse_case("strongly-damped.toml",
                       "[beam]\nlength = 1\ndensity = 1000\nyoungs_modulus = 1e9\naxial_force = "
                       "19.2\naxial_direction = 1\narea = "
                       "1e-3\nsecond_moment_of_area = 1e-9\n[friction]\nstatic_coefficient = "
                       "0.5\n[excitation]\nfrequency_hz = 2\n"
                       "amplitude = 0.001\nduration = 0.01\n[damping]\nkelvin_voigt = 0.02\n");
  const auto [lower, upper] = studies::criterion_with_all_modes(problem, 1e-8).force_max;
  EXPECT_TRUE(lower <= jump_of(problem) && jump_of(problem) <= upper) << lower << ' ' << upper;
}

// At a resonance with little damping; the truth has 70 modes and a steady part of 180 functions.
TEST(Enclosures, HoldTheReductionOfASmallRatio) {
  const auto bounds =
      studies::criterion_with_all_modes(paper_at(81.0776, 1e-3, 100.0, {{"damping.ratio", 1e-4}}), 1e-10)
          .force_max;
  EXPECT_LE(bounds.lower, 1690238.30561 + 1e-5);
  EXPECT_GE(bounds.upper, 1690238.30561 - 1e-5);
}

// 336.98 N by 320 elements, where 40 modes leave 270 ... 400 N.
TEST(Enclosures, AreRefinedUntilTheVerdictIsDecided) {
  const auto at = [](double amplitude) {
    return studies::criterion_with_all_modes(
        paper_at(500.0, amplitude, 0.0015, {{"damping.kelvin_voigt", 6.4e-5}}), 1e-10);
  };
  const auto found = at(3.5e-3);
  EXPECT_EQ(found.verdict, Verdict::stick_slip);
  EXPECT_TRUE(found.force_max.lower <= 336.99 && found.force_max.upper >= 336.97);
  EXPECT_EQ(at(2.5e-3).verdict, Verdict::stick);
  EXPECT_EQ(analytic::verdict_of({299.0, 301.0}, 300.0), Verdict::undecided);
}

// Where N modes are off by 5 %, and by more than the elements are, the warning says so.
TEST(Enclosures, AreWarnedOfWhereNModesAreTooFew) {
  int warned = 0, silent = 0;
  on_random_cases(24, domain, [&](const CaseText& text, RandomNumbers& numbers) {
    const data::Case problem = data::with_value(text.problem(), "numerics.modes", numbers.whole(1, 10));
    const double computed = studies::criterion_of(problem).force_max.midpoint();
    const auto [force, error] = by_elements(text.problem());
    const bool is_off = std::abs(computed - force) > 0.06 * force + error;
    const auto warnings = studies::problem_warnings(problem, studies::Inquiry::criterion);
    const bool is_warned = std::ranges::find(warnings, studies::Concern::few_modes,
                                             &studies::Warning::concern) != warnings.end();
    EXPECT_TRUE(is_warned || !is_off) << computed << " N, by elements " << force << " +- " << error;
    (is_warned ? warned : silent) += 1;
  });
  EXPECT_GT(std::min(warned, silent), 0);
}

}  // namespace
}  // namespace stickslip::testing
