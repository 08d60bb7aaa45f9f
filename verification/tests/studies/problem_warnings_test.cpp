// SPDX-License-Identifier: MIT
/// Warnings about cases outside the range of validity: each begins at the limit that theory gives.

#include "studies/analyses/problem_warnings.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/steady_sliding.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/contact_response.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/analyses/squeal.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/history/natural_frequencies.hpp"
#include "support/random_cases.hpp"
#include "support/structures.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using studies::Concern;
using studies::criterion_warnings;
using studies::design_warnings;
using studies::event_driven;
using studies::finite_elements;
using studies::frequency_warnings;
using studies::history_warnings;

data::Case paper_with(const std::vector<data::Override>& overrides = {}) {
  return data::load_case("paper", overrides);
}

const studies::Warning* find(const std::vector<studies::Warning>& warnings, Concern concern) {
  for (const auto& warning : warnings)
    if (warning.concern == concern) return &warning;
  return nullptr;
}

bool warns(const std::vector<studies::Warning>& warnings, Concern concern) {
  return find(warnings, concern) != nullptr;
}

std::string digits(double value) { return data::shortest_text(value); }

std::vector<Concern> concerns_of(const std::vector<studies::Warning>& warnings) {
  std::vector<Concern> concerns;
  for (const auto& warning : warnings) concerns.push_back(warning.concern);
  return concerns;
}

// --- Thick beams

STICKSLIP_VERIFIES(ThickBeam, "X21");
// Against Timoshenko's beam without axial force. For half waves on pinned supports the next term is (3/8) error^2, from
// (k r)^4 E/(kappa G); the ends change its factor, not its order.
TEST(ThickBeam, WarnsWhereTimoshenkosDiffers) {
  int warned = 0, silent = 0;
  on_random_beams(30, no_force, [&](const data::Beam& beam, RandomNumbers&) {
    const data::Case problem = with(paper_with(), beam);
    for (const bool slips : {false, true}) {
      const auto exact = analytic::timoshenko_frequencies(
          studies::with_shear(beam), slips ? analytic::TipSupport::free : analytic::TipSupport::held, 4);
      for (int mode = 1; mode <= 4; ++mode) {
        const auto n = static_cast<std::size_t>(mode - 1);
        const double slender = slips ? analytic::slip_modes(beam, mode)[n].angular_frequency()
                                     : analytic::stick_modes(beam, mode)[n].angular_frequency();
        const double error = slender / exact[n] - 1.0, next = 3.0 * 0.375 * error * error;
        if (error > 0.3) continue;
        EXPECT_TRUE(
            within(slips ? studies::slip_model_error(beam, mode) : studies::stick_model_error(beam, mode),
                   error, discretisation(next, 1.0, "the next order")))
            << mode;
        if (std::abs(error - studies::allowed_model_error) < next) continue;
        const auto warnings =
            frequency_warnings(with(data::load_case("paper"), beam),
                               slips ? analytic::TipSupport::free : analytic::TipSupport::held, mode);
        EXPECT_EQ(find(warnings, Concern::thick_beam) != nullptr, error > studies::allowed_model_error)
            << error;
        (find(warnings, Concern::thick_beam) == nullptr ? silent : warned) += 1;
      }
    }
  });
  EXPECT_GT(std::min(warned, silent), 5);
}

// The estimate holds for every direction of P: slopes and third derivatives of the mode itself.
TEST(ThickBeam, InSlipIsThatOfTheModeItself) {
  const data::Beam beam = paper_with({{"beam.axial_direction", "1"}, {"beam.axial_force", "8000"}}).beam();
  const auto mode = analytic::slip_modes(beam, 2).back();
  const double h = 1e-3;
  double slopes = 0.0, thirds = 0.0, values = 0.0, curvatures = 0.0;
  for (double x = h; x < 2.0 - 0.5 * h; x += h) {
    slopes += std::pow((mode.shape(x + h) - mode.shape(x - h)) / (2.0 * h), 2);
    thirds += std::pow((mode.curvature(x + h) - mode.curvature(x - h)) / (2.0 * h), 2);
    values += std::pow(mode.shape(x), 2);
    curvatures += std::pow(mode.curvature(x), 2);
  }
  const double error = 0.5 * beam.second_moment_of_area() / beam.area() *
                       (slopes / values + studies::shear_flexibility * thirds / curvatures);
  // Ends left out by half a step each, a share of h/L of each integral, and the square of the error itself.
  EXPECT_TRUE(within(studies::slip_model_error(beam, 2), error,
                     discretisation(error * (4.0 * h + error), 1.0, "ends of the sums, the square root")));
}

// --- Meshes and rows: no warning, so the largest |f| of a tip that sticks is good

// Undamped cases, whose largest |f| is cheap.
const CaseDomain of_forces{
    .shortest = 0.3, .longest = 30.0, .kelvin_voigt = 0.0, .ratio = 0.0, .resonant = 0.1};

STICKSLIP_VERIFIES(CoarseMesh, "X21");
TEST(CoarseMesh, WarnsWhereHalfTheElementsDiffer) {
  int differ = 0, silent = 0;
  on_random_cases(40, of_forces, [&](const CaseText& text, RandomNumbers& numbers) {
    const data::Case fine = text.problem();
    const int elements = static_cast<int>(numbers.log_uniform(1.0, 16.0));
    const auto force = [&](int number) {
      return solver::max_abs_friction_force(data::with_value(fine, "numerics.elements", number));
    };
    const data::Case coarse = data::with_value(fine, "numerics.elements", elements);
    const bool is_silent = !warns(history_warnings(coarse, finite_elements()), Concern::coarse_mesh) &&
                           !warns(history_warnings(coarse, finite_elements()), Concern::long_step);
    const double change = std::abs(force(elements) / force(2 * elements) - 1.0);
    differ += change > 0.05 ? 1 : 0;
    silent += is_silent ? 1 : 0;
    EXPECT_FALSE(is_silent && change > 0.05) << elements << " elements: " << change;
  });
  EXPECT_GT(differ, 8);
  EXPECT_GT(silent, 8);
}

STICKSLIP_VERIFIES(DistantRows, "X21");
TEST(DistantRows, AreWarnedOfWhereFinerRowsDiffer) {
  int differ = 0, silent = 0;
  const auto& method = studies::method("closed-form");
  on_random_cases(40, of_forces, [&](const CaseText& text, RandomNumbers& numbers) {
    const data::Case problem = text.problem();
    const double spacing = std::min(numbers.log_uniform(0.02, 1.0) / problem.excitation().frequency_hz(),
                                    0.3 * problem.numerics.duration());
    const long every = std::max(std::lround(spacing / problem.numerics.time_step()), 1L);
    // Up to the last of the rows: what comes after it no estimate between rows can know.
    const long last = solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
    const double end = static_cast<double>(last - last % every) * problem.numerics.time_step();
    const auto force = [&](long step) {
      double largest = 0.0;
      (void)method.run(problem, {.every = std::max(step, 1L)}, {}, [&](const studies::HistoryRow& row) {
        if (row.time <= end * (1.0 + 1e-12)) largest = std::max(largest, std::abs(row.friction_force));
      });
      return largest;
    };
    const bool is_silent = !studies::row_warning(problem, method, every, every);
    const double change = 1.0 - force(every) / force(every / 20);
    differ += change > 0.05 ? 1 : 0;
    silent += is_silent ? 1 : 0;
    EXPECT_FALSE(is_silent && change > 0.05) << every << " steps: " << change;
    // What the command looks at is good.
    EXPECT_LE(studies::row_effect(problem, static_cast<double>(studies::look_step(problem, every)) *
                                               problem.numerics.time_step()),
              studies::allowed_model_error);
  });
  EXPECT_GT(differ, 4);
  EXPECT_GT(silent, 4);
}

// --- Steps

STICKSLIP_VERIFIES(LongStep, "X21");
// (omega h)^2 (k_1 + k_2)/2 with k_1 = 1/12 + d^2/4, k_2 = 1/12 + d^2/2, d = alpha_f - alpha_m.
TEST(LongStep, HasTheErrorOfTheLeadingTerm) {
  for (const double radius : {0.5, 0.9, 1.0}) {
    const double d = (1.0 - radius) / (1.0 + radius);
    for (const double angle : {0.02, 0.05, 0.1}) {
      const double predicted = angle * angle * (1.0 / 12.0 + 0.375 * d * d);
      const double rate = studies::generalized_alpha_exponent(radius, 1.0, angle).real();
      const double lost = -std::expm1(2.0 * std::numbers::pi * rate);
      const double error = studies::step_error(radius, 1.0, angle);
      EXPECT_GE(error, lost);
      if (error > lost) {
        EXPECT_TRUE(
            within(error, predicted, discretisation(angle * angle * predicted, 1.0, "the next order")));
      }
    }
  }
}

// The step that a warning names passes, and one that is a tenth longer does not: its two digits are rounded down.
TEST(LongStep, IsWarnedOfWithAStepThatPasses) {
  int warned = 0;
  on_random_cases(12, of_forces, [&](const CaseText& text, RandomNumbers& numbers) {
    const data::Case drawn = text.problem();
    const auto with_step = [&](double step) { return with_value(drawn, "numerics.time_step", step); };
    const double step = numbers.log_uniform(1e-3, 0.2) *
                        std::min(1.0 / drawn.excitation().frequency_hz(), drawn.numerics.duration());
    const auto found = history_warnings(with_step(step), finite_elements());
    if (const auto* warning = find(found, Concern::long_step)) {
      ++warned;
      EXPECT_EQ(warning->value, step);
      EXPECT_LT(warning->limit, step);
      EXPECT_FALSE(warns(history_warnings(with_step(warning->limit), finite_elements()), Concern::long_step));
      EXPECT_TRUE(
          warns(history_warnings(with_step(1.11 * warning->limit), finite_elements()), Concern::long_step));
      EXPECT_FALSE(warns(history_warnings(with_step(step), event_driven()), Concern::long_step));
    }
    const auto sentence = studies::fixed_step_warning(drawn, step);
    if (!sentence) return;
    const auto named = sentence->find("numerics.time_step = ");
    ASSERT_NE(named, std::string::npos) << *sentence;
    const double passes = std::stod(sentence->substr(named + 21));
    EXPECT_LT(passes, step);
    EXPECT_FALSE(studies::fixed_step_warning(drawn, passes));
    EXPECT_TRUE(studies::fixed_step_warning(drawn, 1.11 * passes));
  });
  EXPECT_GT(warned, 2);
  EXPECT_LT(warned, 10);
}

STICKSLIP_VERIFIES(ModesThatMatter, "X21");
// max |f| in closed form over the duration, or over a period of the excitation or of the first mode if that is longer.
TEST(ModesThatMatter, HaveAnAmplitudeAboveAShare) {
  const double natural = analytic::stick_modes(paper_with().beam(), 1).front().frequency_hz();
  for (const double duration : {0.002, 1.0})
    for (int hz = 5; hz <= 300; hz += 5) {
      const data::Case problem =
          paper_with({{"excitation.frequency_hz", digits(hz)}, {"excitation.duration", digits(duration)}});
      const analytic::StickResponse response(problem.beam(), problem.excitation(), problem.numerics.modes());
      const double span = std::max({duration, 1.0 / hz, 1.0 / natural});
      const double largest = response.max_abs_friction_force(span, 1e-3).upper;
      const auto vibrations = response.transient_force();
      const auto mode = static_cast<std::size_t>(studies::highest_mode_that_matters(problem));
      for (std::size_t n = mode; n < vibrations.size(); ++n)
        EXPECT_LE(std::abs(vibrations[n].amplitude), studies::share_that_matters * largest)
            << hz << ' ' << duration;
      if (mode > 1) {  // the sampled maximum is low by a few per cent
        EXPECT_GT(std::abs(vibrations[mode - 1].amplitude), 0.8 * studies::share_that_matters * largest)
            << hz << ' ' << duration;
      }
    }
}

// --- Resonance

STICKSLIP_VERIFIES(Resonance, "X21");
// Half a beat lasts pi/|Omega - omega_1|. Does |f| of the last tenth exceed all that was before?
TEST(Resonance, WarnsWhileTheReactionGrows) {
  CaseDomain long_ones = of_forces;
  long_ones.shortest = 40.0, long_ones.longest = 300.0, long_ones.lowest_frequency = 0.99,
  long_ones.highest_frequency = 1.01;
  on_random_cases(6, long_ones, [](const CaseText& text, RandomNumbers&) {
    const data::Case drawn = text.problem();
    const double natural = analytic::modal_forces(drawn.beam(), 1).front().angular_frequency /
                           (2.0 * std::numbers::pi),
                 duration = drawn.numerics.duration();
    for (const double half_beats : {0.0, 0.5, 0.99, 1.01, 2.2}) {
      SCOPED_TRACE(half_beats);
      const data::Case problem =
          with_value(drawn, "excitation.frequency_hz", natural + half_beats / (2.0 * duration));
      const auto warnings = criterion_warnings(problem);
      const auto* warning = find(warnings, Concern::resonance);
      EXPECT_EQ(warning != nullptr, half_beats < 1.0);
      const analytic::StickResponse response(problem.beam(), problem.excitation(), 10);
      const bool grows = response.max_abs_friction_force(duration, 1e-3).lower >
                         1.001 * response.max_abs_friction_force(0.9 * duration, 1e-3).upper;
      EXPECT_TRUE(grows == (half_beats < 1.0) || (half_beats > 0.6 && half_beats < 2.0));
      if (warning == nullptr) continue;
      EXPECT_EQ(warning->value, problem.excitation().frequency_hz());
      EXPECT_DOUBLE_EQ(warning->limit, natural);
      EXPECT_EQ(holds(warning->sentence, "grows with t, without end,"), half_beats == 0.0);
      EXPECT_TRUE(warns(history_warnings(problem, studies::closed_form()), Concern::resonance));
      EXPECT_FALSE(warns(history_warnings(problem, finite_elements()), Concern::resonance));
      // The amplitude grows to Omega T/2 = 10 times that of one period; damping and rest end it.
      const double ten = 20.0 / studies::angular_frequency(problem.excitation());
      for (const auto& [key, value, is_left] : {std::tuple{"excitation.duration", 1.01 * ten, true},
                                                {"excitation.duration", 0.99 * ten, false},
                                                {"damping.ratio", 0.01, false},
                                                {"excitation.amplitude", 0.0, false}})
        EXPECT_EQ(warns(criterion_warnings(with_value(problem, key, value)), Concern::resonance), is_left)
            << key << value;
    }
  });
}

// The steady force follows 1/(1 - (omega_n/Omega)^2): 1 % of omega_n changes it by about 1 % over the distance.
TEST(Resonance, IsWarnedOfWithinTenPercent) {
  on_random_cases(6, of_forces, [](const CaseText& text, RandomNumbers&) {
    const data::Case drawn = with_value(text.problem(), "numerics.modes", 40);
    const double natural =
        analytic::modal_forces(drawn.beam(), 1).front().angular_frequency / (2.0 * std::numbers::pi);
    for (const double share : {-0.3, -0.11, -0.09, 0.09, 0.11, 0.3}) {
      const data::Case problem = with_values(drawn, {{"excitation.frequency_hz", natural / (1.0 + share)},
                                                     {"excitation.duration", 20.0 / natural}});
      EXPECT_EQ(warns(criterion_warnings(problem), Concern::near_resonance), std::abs(share) < 0.1) << share;
      EXPECT_FALSE(
          warns(criterion_warnings(with_value(problem, "damping.ratio", 0.1)), Concern::near_resonance));
      EXPECT_FALSE(warns(history_warnings(problem, finite_elements()), Concern::near_resonance));
      if (std::abs(share) > 0.2) continue;  // the other modes count there
      const auto force = [&](double factor) {
        const data::Case other =
            with_value(problem, "beam.density", drawn.beam().density() / (factor * factor));
        return std::abs(
            analytic::StickResponse(other.beam(), other.excitation(), 40).steady_force_amplitude());
      };
      const double change = 0.01 / std::abs(share);
      EXPECT_TRUE(
          within(std::max(force(1.01), force(0.99)) / force(1.0) - 1.0, change,
                 discretisation(change * (1.5 * std::abs(share) + change), 1.5, "the next two terms")));
    }
  });
}

// --- Draw-back

STICKSLIP_VERIFIES(DrawBack, "X21");
// By elements: the slopes between 101 positions, at each step of a run whose tip friction holds.
TEST(DrawBack, IsThatOfFiniteElements) {
  on_random_cases(4, {.longest = 3.0, .highest_frequency = 2.0}, [](const CaseText& text, RandomNumbers&) {
    const data::Case problem =
        data::with_value(with(text.problem(), data::FrictionLaw({.static_coefficient = 1e9})),
                         "numerics.spectral_radius", 1.0);
    const double length = problem.beam().length();
    studies::Sampling sampling{.every = 4};
    for (int i = 0; i <= 100; ++i) sampling.positions.push_back(std::min(length * i / 100, length));
    double draw_back = 0.0, deflection = 0.0;
    std::ignore = studies::finite_element_history(problem, sampling, {}, [&](const studies::HistoryRow& row) {
      double sum = 0.0;
      for (std::size_t i = 1; i < row.displacement.size(); ++i) {
        sum += std::pow(row.displacement[i] - row.displacement[i - 1], 2) / (2.0 * length / 100);
        deflection = std::max(deflection, std::abs(row.displacement[i] - row.base_displacement));
      }
      draw_back = std::max(draw_back, sum);
    });
    const auto bending = studies::held_bending(problem);
    const auto sampled = [](double value) { return discretisation(0.01 * value, 1.0, "instants"); };
    EXPECT_TRUE(within(bending->draw_back, draw_back, sampled(draw_back)));
    EXPECT_TRUE(within(bending->deflection, deflection, sampled(deflection)));
  });
}

// Values of a program of its own, with the modes of the continuous beam.
TEST(DrawBack, HasKnownValuesAndIsWarnedOf) {
  const auto expect = [](const data::Case& problem, double start_up, double steady, bool is_warned_of) {
    const auto found = studies::criterion_answer(problem);
    EXPECT_TRUE(
        within(found.bending->draw_back, start_up, reference(0.01 * start_up, "two or three digits")));
    EXPECT_TRUE(within(*found.steady_draw_back, steady, reference(0.01 * steady, "two or three digits")));
    EXPECT_EQ(studies::draw_back_warning(problem, found.bending->draw_back).has_value(), is_warned_of);
    EXPECT_DOUBLE_EQ(studies::spring_that_keeps(problem.beam(), 1e-3), 100.0 * problem.beam().axial_force());
  };
  CaseText strip;
  for (const auto& [key, value] : {std::pair{"beam.length", "0.4"},
                                   {"beam.material", "\"steel\""},
                                   {"beam.axial_force", "40"},
                                   {"section.shape", "\"rectangle\""},
                                   {"section.width", "0.03"},
                                   {"section.height", "0.0015"},
                                   {"friction.static_coefficient", "0.5"},
                                   {"friction.kinetic_coefficient", "0.3"},
                                   {"excitation.frequency_hz", "30"},
                                   {"excitation.amplitude", "0.5e-3"}})
    strip.set(key, std::string(value));
  expect(strip.problem(), 0.605e-3, 0.160e-3, true);
  strip.set("damping.kelvin_voigt", 1e-9);  // the steady vibration by the other way
  expect(strip.problem(), 0.605e-3, 0.160e-3, true);
  expect(paper_with({{"excitation.frequency_hz", "35"}, {"excitation.amplitude", "0.5e-3"}}), 4.37e-6,
         0.763e-6, false);
  expect(data::load_case("rig", {{"excitation.frequency_hz", "10"}, {"excitation.amplitude", "7.84e-3"}}),
         0.135e-3, 0.133e-3, true);
}

// --- Flutter

STICKSLIP_VERIFIES(Flutter, "X21");
// The mesh of the warning against modes of the continuous beam, 0.3 % away from where they begin to grow.
TEST(Flutter, IsWarnedOfWhereAModeGrows) {
  int growing = 0, resting = 0;
  const CaseDomain domain{.lowest_force = 0.05, .highest_force = 0.95, .fixed_direction = 0.6};
  on_random_cases(150, domain, [&](CaseText text, RandomNumbers&) {
    text.set("numerics.modes", "12");
    const data::Case problem = text.problem();
    const auto grows_at = [&](double load) {
      const auto model = studies::response_model(with_value(problem, "beam.axial_force", load));
      return std::ranges::any_of(
          analytic::sliding_eigenvalues(model, -problem.contact.friction.viscous() * load), studies::grows);
    };
    const double load = problem.beam().axial_force();
    const auto warning = studies::instability_warning(problem);
    const bool grows = grows_at(1.003 * load);
    if (grows != grows_at(0.997 * load)) return;
    EXPECT_EQ(warning.has_value(), grows);
    for (const auto* method : {&finite_elements(), &event_driven()}) {
      const auto found = history_warnings(problem, *method);
      EXPECT_EQ(warns(found, Concern::flutter) || warns(found, Concern::buckling), grows);
    }
    (grows ? growing : resting) += 1;
    EXPECT_TRUE(!warning || (grows_at(1.003 * warning->limit) && !grows_at(0.997 * warning->limit)));
  });
  EXPECT_GT(std::min(growing, resting), 30);
}

// Euler's load of the cantilever under a dead load.
TEST(Flutter, GivesWayToBucklingUnderADeadLoad) {
  for (const double share : {0.99, 1.01}) {
    const double euler = std::pow(0.5 * std::numbers::pi / 2.0, 2) * 2e9 * 1e-4 / 12.0;
    const data::Case problem =
        paper_with({{"beam.axial_direction", "1"}, {"beam.axial_force", digits(share * euler)}});
    EXPECT_EQ(warns(history_warnings(problem, event_driven()), Concern::buckling), share > 1.0);
    EXPECT_FALSE(warns(history_warnings(problem, event_driven()), Concern::flutter));
    EXPECT_FALSE(warns(criterion_warnings(problem), Concern::buckling));
  }
}

// Directions between 1/2 and 0.58: a buckling that ends before the beam flutters. With E I/(k G A L^2) = 0.01 and 0.05: up to 0.5 %
// below and from 1 % above the loads of a Galerkin model with 420 Legendre functions, 15.287, 13.350, 2.4080, 8.145, 7.577, 2.1964.
TEST(Flutter, HasTheLoadsOfEachDirectionAndOfShear) {
  const std::vector<std::array<double, 4>> rows{
      {0.0, 0.5, 14.0, 17.0},    {0.0, 0.52, 7.5, 7.6},     {0.0, 0.52, 12.6, 12.4},
      {0.01, 0.0, 15.21, 15.44}, {0.01, 0.3, 13.28, 13.49}, {0.01, 1.0, 2.396, 2.433},
      {0.05, 0.0, 8.104, 8.227}, {0.05, 0.3, 7.539, 7.653}, {0.05, 1.0, 2.185, 2.219}};
  const double rigidity = 2e9 * 1e-4 / 12.0;
  for (const auto& [flexibility, direction, stable, unstable] : rows)
    for (const double factor : {stable, unstable}) {
      SCOPED_TRACE(fmt::format("{} {} {}", flexibility, direction, factor));
      const data::Case problem =
          paper_with({{"beam.length", "1"},
                      {"beam.axial_direction", digits(direction)},
                      {"beam.shear_stiffness", digits(flexibility > 0.0 ? rigidity / flexibility : 0.0)},
                      {"beam.axial_force", digits(factor * rigidity)}});
      const bool is_stable = factor == stable;
      EXPECT_EQ(studies::instability_warning(problem).has_value(), !is_stable);
      if (flexibility > 0.0) continue;
      EXPECT_EQ(
          !error_message_if_any<data::FieldError>([&] { (void)analytic::slip_modes(problem.beam(), 2); }),
          is_stable);
    }
}

// --- The published cases

// 69 kN is the flutter load; at 80 kN a disturbance grows by e in 0.021 s.
TEST(Flutter, IsHeldByTheBoundaryIntegralForAWhile) {
  const auto at = [](const char* load, double duration) {
    return paper_with({{"beam.axial_direction", "0.35"},
                       {"beam.axial_force", load},
                       {"friction.static_coefficient", "0"},
                       {"friction.kinetic_coefficient", "0"},
                       {"numerics.modes", "20"},
                       {"excitation.duration", digits(duration)},
                       {"numerics.time_step", "1e-3"}});
  };
  const auto refusal = [](const data::Case& problem, const studies::Method& by) {
    return error_message_if_any<data::FieldError>([&] { studies::require_held_growth(problem, by); });
  };
  const studies::Method& method = studies::boundary_integral();
  EXPECT_TRUE(holds(refusal(at("8e4", 0.2), method).value_or(""),
                    "excitation.duration is 0.2, but must be at most 0.15"));
  EXPECT_EQ(refusal(at("8e4", 0.2), finite_elements()), std::nullopt);
  EXPECT_EQ(refusal(at("6.8e4", 1.0), method), std::nullopt);
  // Up to there it is right: to 1e-4 for the weights and as much for its steps and the other's modes.
  const data::Case problem = at("8e4", 0.15);
  EXPECT_EQ(refusal(problem, method), std::nullopt);
  const studies::Sampling end{.times = {0.15}, .with_midspan = false};
  const double tip = method.run(problem, end, {}, {}).rows.back().tip_displacement,
               other = studies::event_driven_history(problem, end).rows.back().tip_displacement;
  EXPECT_TRUE(within(tip, other, reference(1e-3 * std::abs(other), "weights, steps and modes")));
}

STICKSLIP_VERIFIES(LongSteps, "X21");
// 47 changes; 45 with a step of 2.5e-4 s, 51 with 5e-4 s.
TEST(LongSteps, WarnIfTwiceTheStepDiffers) {
  const auto is_warned = [](const std::vector<data::Override>& step) {
    const data::Case problem = data::load_case("damped", step);
    const auto history = studies::finite_element_history(problem);
    EXPECT_EQ(history.events.size() == 47, step.empty()) << history.events.size();
    const auto warnings = studies::warnings_after(problem, finite_elements(), history);
    return std::ranges::any_of(warnings, [](const std::string& text) {
      return holds(text, "with twice the step the changes of contact are others from t = 0.466");
    });
  };
  EXPECT_FALSE(is_warned({}));
  EXPECT_TRUE(is_warned({{"numerics.time_step", "2.5e-4"}}));
  EXPECT_TRUE(is_warned({{"numerics.time_step", "5e-4"}}));
}

// Next to a turn: two changes that the beam does not have.
TEST(LongSteps, OfTheBoundaryIntegralAreWarnedOf) {
  const data::Case problem = data::parse_case("turn.toml", R"(
[beam]
axial_force = 0.2540941693858187
density = 2176.073338515916
length = 0.05445770527897731
youngs_modulus = 4342968042.8262415
[section]
shape = "rectangle"
width = 0.0012757465340509642
height = 0.0008653363869285468
[friction]
static_coefficient = 0.667190118668982
kinetic_coefficient = 0.5616207213525387
decay = 0.010504004852050126
[excitation]
frequency_hz = 776.2330610369941
amplitude = 0.04666732832102749
duration = 0.001289531815009417
[damping]
kelvin_voigt = 1.5280465638377978e-06
)");
  const auto history = studies::boundary_integral().run(problem, {.with_midspan = false}, {}, {});
  const auto warnings = studies::warnings_after(problem, studies::boundary_integral(), history);
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& text) {
    return holds(text, "changes of contact follow each other within a step of");
  }));
}

STICKSLIP_VERIFIES(ProblemWarnings, "X21");
// 25 Hz is 0.028 Hz above the first natural frequency: |f| grows for 17.8 s, longer than the run.
TEST(ProblemWarnings, OfThePapersCaseAreOne) {
  const data::Case paper = paper_with();
  const auto concerns = [&](analytic::TipSupport tip, int count) {
    return concerns_of(frequency_warnings(paper, tip, count));
  };
  EXPECT_EQ(concerns_of(criterion_warnings(paper)), std::vector{Concern::resonance});
  EXPECT_EQ(concerns_of(history_warnings(paper, finite_elements())), std::vector<Concern>{});
  EXPECT_EQ(concerns_of(history_warnings(paper, event_driven())), std::vector<Concern>{});
  EXPECT_EQ(concerns(analytic::TipSupport::held, 2), std::vector<Concern>{});
  EXPECT_EQ(concerns(analytic::TipSupport::free, 3), std::vector<Concern>{});
  EXPECT_EQ(concerns(analytic::TipSupport::held, 3), std::vector{Concern::thick_beam});  // by 5.2 %
}

TEST(ProblemWarnings, OfAMapAreThoseOfNoAxis) {
  const auto concerns = [](const std::vector<data::Override>& overrides,
                           const std::vector<std::string_view>& axes) {
    return concerns_of(studies::warnings_common_to(paper_with(overrides), axes));
  };
  const std::vector<data::Override> resonant, fast{{"excitation.frequency_hz", "230"}};
  for (const std::string_view axis : {"friction.static_coefficient", "beam.axial_direction"})
    EXPECT_EQ(concerns(resonant, {"excitation.amplitude", axis}), std::vector{Concern::resonance});
  EXPECT_EQ(concerns(fast, {"excitation.amplitude", "friction.static_coefficient"}),
            std::vector{Concern::thick_beam});
  for (const std::string_view axis :
       {"excitation.frequency_hz", "beam.length", "beam.axial_force", "beam.youngs_modulus"}) {
    EXPECT_EQ(concerns(resonant, {axis, "excitation.amplitude"}), std::vector<Concern>{});
    EXPECT_EQ(concerns(fast, {"excitation.amplitude", axis}),
              axis == "beam.length" ? std::vector<Concern>{} : std::vector{Concern::thick_beam});
  }
  EXPECT_EQ(concerns({{"beam.axial_force", "1e5"}}, {"excitation.amplitude", "beam.axial_force"}),
            std::vector<Concern>{});
}

// At the largest values, where they have the worst cell.
TEST(ProblemWarnings, OfAMapByElementsNameTheMesh) {
  studies::MapTask task{.problem = paper_with({{"numerics.elements", "2"}}),
                        .x = studies::map_axis("excitation.frequency_hz", 30.0, 35.0, 2, false),
                        .y = studies::map_axis("excitation.amplitude", 3e-4, 5e-4, 2, false),
                        .method = &finite_elements()};
  EXPECT_EQ(concerns_of(studies::map_warnings(task)).back(), Concern::coarse_mesh);
  task.problem = paper_with();
  EXPECT_EQ(concerns_of(studies::map_warnings(task)), std::vector<Concern>{});
}

// The beam as matrices, which ask for nothing; in tonnes taken for kilograms; and with the rotation of the clamped end in the base, so
// that it turns by 1 rad for each metre: it pulls by 3 E I/L^2 at the contact, L times its stiffness.
TEST(ProblemWarnings, TellOfUnitsAndOfABaseThatIsNotRigid) {
  data::StructureMatrices matrices = beam_matrices(paper_beam(), 8);
  const auto found = [&](Concern concern) {
    const auto warnings = criterion_warnings(with_matrices(paper_with(), matrices));
    const auto* warning = find(warnings, concern);
    return warning == nullptr ? 0.0 : warning->value;
  };
  EXPECT_EQ(found(Concern::structure_mass), 0.0);
  EXPECT_EQ(found(Concern::base_alone), 0.0);
  const double mass = paper_beam().density() * paper_beam().area() * paper_beam().length();
  for (auto& entry : matrices.mass) entry.value *= 1e-6;
  EXPECT_TRUE(within(found(Concern::structure_mass), 1e-6 * mass, round_off(1e4, 1, 1e-6 * mass)));
  for (auto& entry : matrices.mass) entry.value *= 1e6;
  matrices.fixed.clear();
  matrices.base = {0, 1};
  EXPECT_GT(std::abs(found(Concern::base_alone)), 0.5 * paper_beam().length());
}

TEST(ProblemWarnings, AreOneSentenceEach) {
  int warnings = 0;
  const auto expect_sentences = [&](const std::vector<studies::Warning>& found) {
    for (const auto& warning : found) {
      EXPECT_EQ(warning.sentence.find_first_of("\r\n"), std::string::npos);
      EXPECT_LT(warning.sentence.size(), 300u) << warning.sentence;
      ++warnings;
    }
  };
  for (const auto& [name, title] : data::list_cases()) {
    const data::Case problem = data::load_case(name);
    for (const auto tip : {analytic::TipSupport::held, analytic::TipSupport::free})
      expect_sentences(frequency_warnings(problem, tip, 10));
    expect_sentences(criterion_warnings(problem));
    if (problem.general_motion() == nullptr) expect_sentences(design_warnings(problem));
    for (const studies::Method& method : studies::methods()) {
      const auto found = history_warnings(problem, method);
      expect_sentences(found);
      const auto after = studies::warnings_after(problem, method, {});
      for (const auto& warning : found) EXPECT_NE(std::ranges::find(after, warning.sentence), after.end());
    }
  }
  EXPECT_GT(warnings, 10);
}

TEST(ProblemWarnings, RefuseFromTheNamedPeriodsOn) {
  const double tenth = analytic::stick_modes(paper_with().beam(), 10).back().frequency_hz();
  using Refusal = void (*)(const data::Case&);
  const auto error_message = [](double hz, double duration, Refusal require) {
    return error_message_if_any<data::FieldError>([&] {
      require(paper_with({{"excitation.frequency_hz", digits(hz)},
                          {"numerics.time_step", "1e-3"},
                          {"excitation.duration", digits(duration)}}));
    });
  };
  for (const auto& [require, periods, number] :
       {std::tuple{Refusal(studies::require_feasible), 1e8, "a hundred million"},
        {studies::closed_form().require_feasible, 1e8, "a hundred million"},
        {event_driven().require_feasible, 1e6, "a million"}})
    for (const double hz : {25.0, 2000.0}) {
      const double highest = std::max(hz, tenth), longest = periods / highest;
      EXPECT_EQ(error_message(hz, 0.999 * longest, require), std::nullopt);
      EXPECT_EQ(
          error_message(hz, 1.001 * longest, require),
          fmt::format("excitation.duration is {}, but must be at most {:.3g} s, {} periods of {}, {:.3g} Hz",
                      digits(1.001 * longest), longest, number,
                      hz > tenth ? "the excitation" : "natural frequency 10", highest));
    }
  EXPECT_EQ(error_message(25.0, 1e5, finite_elements().require_feasible), std::nullopt);
  // 1/20000 of the period of the first mode, 24.97 Hz, and of an excitation above it.
  for (const auto& [hz, halvings] : {std::pair{"5", 64}, {"25", 64}, {"100", 256}})
    EXPECT_EQ(studies::boundary_integral_step(paper_with({{"excitation.frequency_hz", hz}})),
              1e-4 / halvings);
}

}  // namespace
}  // namespace stickslip::testing
