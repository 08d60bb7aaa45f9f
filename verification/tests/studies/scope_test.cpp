// SPDX-License-Identifier: MIT
/// What |f_max| over a time is: the start-up of an undamped beam, by both implementations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/criterion/problem_warnings.hpp"
#include "studies/criterion/scope.hpp"
#include "support/beams.hpp"
#include "support/paper_case.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

constexpr double half_millimetre = 0.5e-3;

data::Case paper_at(double hz, double amplitude = half_millimetre) {
  data::Case problem = paper();
  problem.excitation = excitation(hz, amplitude);
  return problem;
}

class SteadyForce : public ::testing::TestWithParam<double> {
 protected:
  static studies::SteadyForce study(const std::vector<double>& durations = {}) {
    return studies::steady_force(paper_at(GetParam()), durations);
  }
};

STICKSLIP_VERIFIES(SteadyForce, "X22");
TEST_P(SteadyForce, OfAMeshDiffersFromTheClosedFormByTheFourthPowerOfTheElementLength) {
  const auto force = study();
  // The next term is (beta l)^2/40 of it, and near resonance the shift of the frequency counts once more.
  EXPECT_TRUE(within(force.finite_element, force.steady,
                     discretisation(force.predicted_error, 1.02, "extrapolation from two meshes")));
  EXPECT_GT(std::abs(force.finite_element - force.steady), 0.98 * force.predicted_error);
  const auto with_modes = [](int modes, analytic::SteadyPart part = analytic::SteadyPart::exact) {
    return analytic::StickResponse(paper().beam, excitation(GetParam(), half_millimetre), modes, part);
  };
  EXPECT_EQ(force.truncated,
            std::abs(with_modes(10, analytic::SteadyPart::modal_sum).steady_force_amplitude()));
  // The ceiling bounds the modes from the 21st on: 60 modes are below it, by less than that bound.
  double amplitudes = force.steady;
  for (const auto& free : with_modes(60).transient_force()) amplitudes += std::abs(free.amplitude);
  EXPECT_GE(force.ceiling, amplitudes);
  EXPECT_LE(force.ceiling, amplitudes + with_modes(20).omitted_transient_bound());
}

TEST_P(SteadyForce, IsExceededByTheStartUpMoreTheLongerItLasts) {
  const auto force = study({0.1, 1.0, 10.0, 100.0});
  double shorter = 0.0;
  for (const auto& horizon : force.horizons) {
    EXPECT_GE(horizon.force_max.upper, shorter) << horizon.duration;
    shorter = horizon.force_max.lower;
    EXPECT_LE(horizon.force_max.lower, force.ceiling) << horizon.duration;
    EXPECT_TRUE(within(horizon.critical_amplitude * horizon.force_max.midpoint(),
                       friction_limit() * half_millimetre, round_off(10, 1, 0.15)));
    ASSERT_EQ(horizon.finite_element.has_value(), horizon.duration <= 10.0);
    if (horizon.finite_element) {
      EXPECT_TRUE(within(*horizon.finite_element, horizon.force_max.midpoint(),
                         discretisation(horizon.predicted_error, 1.0, "PredictedForce")));
    }
  }
  EXPECT_EQ(force.grows, GetParam() == 25.0);
}

INSTANTIATE_TEST_SUITE_P(, SteadyForce, ::testing::Values(15.0, 25.0, 35.0, 70.0));

STICKSLIP_VERIFIES(DampedForce, "X22");
TEST(DampedForce, OfALongRunIsTheClosedFormAtTheFrequencyOfTheRun) {
  data::Case problem = paper_at(25.0);
  problem.damping = data::load_case("damped").damping;
  const auto force = studies::damped_force(problem);
  // Of the free vibration exp(-zeta omega_1 T) is left after 20 s, 2e-7 of the force.
  EXPECT_TRUE(within(force.finite_element, force.steady,
                     discretisation(force.predicted_error + 2e-7 * force.steady, 1.5,
                                    "frequency of mode 1 in the run, and modes above it")));
  const analytic::StickResponse undamped(problem.beam, problem.excitation, 60, analytic::SteadyPart::exact);
  EXPECT_TRUE(
      within(force.undamped_force_max, undamped.max_abs_friction_force(10.0, 1e-8).midpoint(),
             discretisation(
                 1e-7 * force.undamped_force_max +
                     analytic::StickResponse(problem.beam, problem.excitation, 20).omitted_transient_bound(),
                 1.0, "width of the bounds, modes from the 21st on")));
  EXPECT_TRUE(within(force.ratio, 0.005, reference(5e-5, "the comment of damped.toml, one digit")));
  const auto error = [&](int elements) {
    return studies::finite_element_steady_force(problem, elements) - force.steady;
  };
  EXPECT_TRUE(within(error(10) / error(20), 16.0, discretisation(16.0 * 0.02, 1.0, "the next order")));
}

TEST(DampedForce, NeedsKelvinVoigtDampingOnAMesh) {
  data::Case problem = paper_at(25.0);
  problem.damping = data::Damping({.ratio = 0.01});
  EXPECT_THROW((void)studies::finite_element_steady_force(problem, 4), data::FieldError);
}

STICKSLIP_VERIFIES(SlenderForce, "X22");
// The error of a mesh is that of the frequency of mode 1, (beta l)^4/1440 + rho A omega^2 l^2/(24 k G A), over its distance to
// the excitation, 24.72 Hz to 25 Hz; half a beat of 3.6 s is inside the duration, so that the largest |f| follows the distance.
TEST(SlenderForce, NearResonanceIsThatOfAMeshWithShear) {
  const auto force = studies::slender_force(paper_at(25.0));
  data::Case sheared = paper_at(25.0);
  sheared.beam = studies::with_shear(sheared.beam);
  data::NumericalChoices choices = sheared.numerics.choices();
  choices.elements = 80;
  const double finite_element = solver::max_abs_friction_force(
      sheared.beam, sheared.excitation, data::NumericalSettings(choices), {}, solver::Coordinates::modal);
  const double omega = analytic::modal_forces(sheared.beam, 1).front().angular_frequency;
  const double excitation = studies::angular_frequency(sheared.excitation);
  const double mass = sheared.beam.density() * sheared.beam.area();
  const double stiffness = sheared.beam.youngs_modulus() * sheared.beam.second_moment_of_area();
  const double l = sheared.beam.length() / choices.elements;
  const double mesh = mass * omega * omega *
                      (std::pow(l, 4) / stiffness / 1440.0 + l * l / sheared.beam.shear_stiffness() / 24.0);
  const double step = studies::step_error(choices.spectral_radius, omega, choices.time_step);
  EXPECT_TRUE(within(force.shifted_force_max, finite_element,
                     discretisation((mesh + step) * omega / (excitation - omega) * finite_element, 3.0,
                                    "frequency of mode 1 over its distance to the excitation")));
  EXPECT_GT(force.force_max, 7.0 * force.shifted_force_max);
  EXPECT_NEAR(force.model_errors.front(), studies::stick_model_error(paper().beam, 1),
              0.05 * force.model_errors.front());
}

STICKSLIP_VERIFIES(LateSlips, "X22");
TEST(LateSlips, GoOnButMoveTheTipLittleByTwoFormulations) {
  const auto converged = studies::converged_history(
      paper_at(35.0, 1e-3),
      {.duration = 0.5, .samples = 1000, .steps_per_sample = 128, .levels = 2, .with_midspan = false});
  const auto histories = studies::late_slips(paper(), converged);
  std::string methods;
  for (const auto& history : histories) methods += history.method + "; ";
  EXPECT_EQ(methods,
            "converged; finite elements, 40, 2.5e-06 s; finite elements, 20, 0.0001 s; "
            "finite elements, 40, 0.0001 s; ");
  EXPECT_EQ(histories[0].range, converged.tip_range);
  EXPECT_EQ(histories[0].last_onset, converged.sticks.back().end);
  EXPECT_NEAR(histories[1].duration, 0.5, 2.5e-6);  // a step
  EXPECT_DOUBLE_EQ(histories[3].duration, 10.0);
  // The sample before is farther from the last value.
  const auto settled = std::ranges::find(converged.time, histories[0].settled) - converged.time.begin();
  EXPECT_GT(std::abs(*(converged.tip.begin() + settled - 1) - converged.tip.back()),
            0.05 * converged.tip_range);
  EXPECT_LE(std::abs(*(converged.tip.begin() + settled) - converged.tip.back()), 0.05 * converged.tip_range);
  for (const auto& history : histories) {
    EXPECT_LT(history.settled, 0.145) << history.method;
    EXPECT_LT(history.later_range, 2.0 * studies::settled_share * history.range) << history.method;
    EXPECT_GT(history.last_onset, 0.4) << history.method;
  }
}

TEST(LateSlips, AreAPartOfTheStudyBesideThoseAtItsFrequenciesAndAmplitudes) {
  const studies::ScopeRange whole;
  EXPECT_EQ(whole.frequencies_hz, (std::vector{15.0, 25.0, 35.0, 70.0}));
  EXPECT_EQ(whole.durations, (std::vector{0.1, 1.0, 10.0, 100.0, 1000.0}));
  EXPECT_EQ(whole.amplitudes, (std::vector{0.5e-3, 1e-3}));
  EXPECT_EQ(whole.last_hz, 120);
  const auto shortened = [](data::Case problem) {
    problem.numerics = data::NumericalSettings(paper_choices(0.2));
    return problem;
  };
  const data::Case problem = shortened(paper()), damped = shortened(data::load_case("damped"));
  const auto converged = studies::converged_history(
      paper_at(35.0, 1e-3),
      {.duration = 0.05, .samples = 100, .steps_per_sample = 16, .levels = 2, .with_midspan = false});
  const studies::ScopeRange range{{15.0, 70.0}, {0.1, 0.4}, {0.5e-3, 1e-3}, 2};
  const auto study = studies::scope(problem, damped, converged, range);
  EXPECT_EQ(study.friction_limit, friction_limit());
  for (std::size_t i = 0; i < 2; ++i) {
    const data::Case here = shortened(paper_at(range.frequencies_hz[i]));
    const auto steady = studies::steady_force(here, range.durations);
    EXPECT_EQ(study.steady.at(i).frequency_hz, range.frequencies_hz[i]);
    EXPECT_EQ(study.steady.at(i).amplitude, half_millimetre);
    EXPECT_EQ(study.steady.at(i).horizons.at(1).force_max.upper, steady.horizons.at(1).force_max.upper);
    EXPECT_EQ(study.slender.at(i).frequency_hz, range.frequencies_hz[i]);
    EXPECT_EQ(study.slender.at(i).amplitude, half_millimetre);
    EXPECT_EQ(study.slender.at(i).force_max, studies::slender_force(here).force_max);
    EXPECT_EQ(study.slender.at(i).model_errors.size(), 10u);
    EXPECT_EQ(study.damped.at(i).frequency_hz, 25.0);
    EXPECT_EQ(study.damped.at(i).amplitude, range.amplitudes[i]);
    EXPECT_EQ(study.damped.at(i).kelvin_voigt, damped.damping.kelvin_voigt());
  }
  EXPECT_EQ(study.softer.all, 2);
  EXPECT_EQ(study.softer.lowest_ratio, studies::softer_beam(problem, 2).lowest_ratio);
  ASSERT_EQ(study.late_slips.size(), 4u);
  EXPECT_EQ(study.late_slips[0].range, converged.tip_range);
}

}  // namespace
}  // namespace stickslip::testing
