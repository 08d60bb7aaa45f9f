/// Finite elements against the closed form in the stick state.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/studies/convergence.hpp"
#include "stickslip/studies/discretisation.hpp"
#include "stickslip/studies/force_maximum.hpp"
#include "stickslip/studies/frequencies.hpp"
#include "stickslip/studies/stick_history.hpp"
#include "support/beams.hpp"
#include "support/parameter_name.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

data::NumericalSettings settings(double duration, double spectral_radius = 0.9) {
  data::NumericalChoices choices = paper_choices(duration);
  choices.spectral_radius = spectral_radius;
  return data::NumericalSettings(choices);
}

const data::HarmonicExcitation figure9({.frequency_hz = 15.0, .amplitude = 0.5e-3});

class Figure9 : public ::testing::TestWithParam<double> {};

TEST_P(Figure9, ErrorsAreThePredictedOnesAtThePaperSettingsAndFallAsPredicted) {
  const auto study = studies::stick_history_study(paper_beam(), figure9, settings(1.0, GetParam()), 3);
  for (const auto& level : study.levels) {
    // drift_bound adds magnitudes and leaves out amplitude errors, 12/(omega T) of a phase error: 8 % in mode
    // 1 at 1 s.
    const std::string law = "phase drift of each mode";
    EXPECT_TRUE(
        within(level.displacement_error, 0.0, discretisation(level.predicted_displacement_error, 1.1, law)));
    EXPECT_TRUE(within(level.force_error, 0.0, discretisation(level.predicted_force_error, 1.1, law)));
    // The bound is a bound, but not an idle one: mode 1 alone makes most of the displacement's, ten modes of
    // like size, which do not peak together, the force's.
    EXPECT_GT(level.displacement_error, level.predicted_displacement_error / 1.5);
    EXPECT_GT(level.force_error, level.predicted_force_error / 2.0);
  }
  // Displacement: h^2. Force: amplitudes n^-4 and drifts n^6 h^2 make a sum whose largest terms sit where the
  // drift reaches a turn, n ~ h^(-1/3): h^1. Both as the predicted errors fall, to 0.2.
  EXPECT_TRUE(within(study.displacement_order.order, study.predicted_displacement_order, next_terms(0.2)));
  EXPECT_TRUE(within(study.force_order.order, study.predicted_force_order, next_terms(0.1)));
  EXPECT_TRUE(within(study.predicted_force_order, 1.0, next_terms(0.05)));
  EXPECT_TRUE(within(study.displacement_order.order, 2.0, next_terms(0.1)));
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, Figure9, ::testing::Values(0.9, 1.0), NameOfDouble());

TEST(Figure9Refined, DisplacementIsWithin1em5AndForceWithin5em4OfThePeak) {
  const auto study = studies::stick_history_study(paper_beam(), figure9, settings(1.0), 4);
  EXPECT_LT(study.levels.back().displacement_error, 1e-5 * study.displacement_peak);
  EXPECT_LT(study.levels.back().force_error, 5e-4 * study.force_peak);
  EXPECT_LT(study.levels.back().force_error, 1.1 * study.levels.back().predicted_force_error);
}

class ForceMaximumAt : public ::testing::TestWithParam<double> {};

TEST_P(ForceMaximumAt, FiniteElementsReturnThePredictedMaximum) {
  for (const double radius : {0.9, 1.0}) {
    const auto study = studies::force_maximum_study(
        paper_beam(), data::HarmonicExcitation({GetParam(), 0.5e-3}), settings(10.0, radius));
    EXPECT_TRUE(within(study.finite_element, study.predicted_finite_element,
                       discretisation(study.prediction_uncertainty, 1.0, "PredictedForce::uncertainty")));
    // The prediction is worth more than the printed digits: within 1 % of the converged value.
    EXPECT_LT(study.prediction_uncertainty, 0.01 * study.finite_element);
    EXPECT_TRUE(within(study.finite_element, study.converged.midpoint(),
                       reference(0.01 * study.converged.midpoint(), "the printed values")));
  }
}

INSTANTIATE_TEST_SUITE_P(Hertz, ForceMaximumAt, ::testing::Values(15.0, 25.0, 35.0, 70.0), NameOfDouble());

// Energy of the beam relative to its base.
double energy(const solver::BeamSimulation& s) {
  const auto& q = s.integrator().displacement();
  const auto& v = s.integrator().velocity();
  return 0.5 * v.dot(s.model().mass() * v) + 0.5 * q.dot(s.model().stick_stiffness() * q);
}

// Power of the base load -b h_tt and of the reaction in the tip row of the symmetric system, f_d - P theta_L.
double power(const solver::BeamSimulation& s, const solver::PrescribedMotion& base) {
  const auto& q = s.integrator().displacement();
  const auto& v = s.integrator().velocity();
  const double reaction = -s.friction_force() - s.model().beam().axial_force() * q[s.model().tip_rotation()];
  return -base.acceleration(s.time()) * s.model().base_load().dot(v) +
         reaction * v[s.model().tip_deflection()];
}

double energy_residual(double time_step, double spectral_radius) {
  data::NumericalChoices choices = settings(0.2, spectral_radius).choices();
  choices.time_step = time_step;
  const data::HarmonicExcitation excitation({.frequency_hz = 35.0, .amplitude = 0.5e-3});
  const solver::PrescribedMotion base = solver::harmonic_motion(excitation);
  solver::BeamSimulation s(paper_beam(), paper_friction(), excitation, data::NumericalSettings(choices),
                           {.contact = solver::TipContact::glued});
  const double initial = energy(s);
  double work = 0.0, before = power(s, base), largest = 0.0, scale = 0.0;
  for (long n = solver::step_count(choices.duration, time_step); n > 0; --n) {
    s.step();
    const double now = power(s, base);
    work += 0.5 * (before + now) * time_step;
    before = now;
    largest = std::max(largest, std::abs(energy(s) - initial - work));
    scale = std::max(scale, energy(s));
  }
  return largest / scale;
}

TEST(StickEnergy, IsBalancedBySecondOrderWithoutDissipation) {
  // Every mode that carries energy must be resolved: omega_5 h < 0.3 on the coarsest level.
  std::vector<double> steps{1e-4, 5e-5, 2.5e-5, 1.25e-5}, residuals;
  for (const double h : steps) residuals.push_back(energy_residual(h, 1.0));
  EXPECT_TRUE(within(studies::observed_order(steps, residuals), 2.0, next_terms(0.15)));
  EXPECT_LT(residuals.back(), 1e-4);
}

TEST(StickState, TipDoesNotCreep) {
  const data::HarmonicExcitation excitation({.frequency_hz = 35.0, .amplitude = 0.5e-3});
  solver::BeamSimulation s(paper_beam(), paper_friction(), excitation, settings(1.0));
  double largest = 0.0;
  for (int n = 0; n < 10000; ++n) {
    s.step();
    largest = std::max(largest, std::abs(s.tip_displacement()));
    ASSERT_EQ(s.sliding_velocity(), 0.0);
  }
  // h + (0 - h): one rounding.
  EXPECT_LE(largest, round_off(1, 1, 0.5e-3).value);
}

TEST(StickState, ForceIsProportionalToTheAmplitude) {
  const auto force = [](double amplitude) {
    return solver::max_abs_friction_force(paper_beam(), data::HarmonicExcitation({35.0, amplitude}),
                                          settings(0.2));
  };
  const double unit = force(1e-3);
  // Round-off grows with steps and with the condition of the reaction, omega_max^2/omega_1^2.
  for (const double factor : {1e-6, 0.3, 7.0})
    EXPECT_TRUE(within(force(factor * 1e-3), factor * unit, round_off(2000, 1e3, factor * unit)));
}

TEST(StickState, ModeShapesOfBothImplementationsAreTheSame) {
  const auto study = studies::mode_shape_study(paper_beam(), 3, 20, 101);
  for (const auto& curve : study.curves) {
    // Shape error of a Hermite mesh: (beta l)^4/384 from interpolation (max of (s - s^2)^2/24), doubled for
    // the Galerkin part.
    const double beta = (curve.mode + (curve.slip ? -0.5 : 0.25)) * std::numbers::pi;
    EXPECT_TRUE(within(curve.largest_difference, 0.0,
                       discretisation(std::pow(beta / 20.0, 4) / 384.0, 4.0, "(beta l)^4/384")))
        << "mode " << curve.mode << (curve.slip ? " slip" : " stick");
  }
}

}  // namespace
}  // namespace stickslip::testing
