// SPDX-License-Identifier: MIT
/// Relations between the finite elements and the closed forms that hold for every beam.

#include <Eigen/Dense>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/verification/contact_histories.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using std::numbers::pi;

std::vector<double> angular_frequencies(const std::vector<analytic::StickMode>& modes) {
  std::vector<double> frequencies;
  for (const auto& mode : modes) frequencies.push_back(mode.angular_frequency());
  return frequencies;
}

/// (beta l)^2 of the larger wave number.
double resolution(const analytic::StickMode& mode, double element_length) {
  const double wave_number = std::max(mode.hyperbolic_wave_number(), mode.trigonometric_wave_number());
  return std::pow(wave_number * element_length, 2);
}

/// Relative size of what comes behind the leading term of an eigenvalue's error: the interpolation error of a
/// fourth derivative that varies along an element, l^2 u^(5)^2 (1/12 - 1/140), and what the axial force does
/// on that error, p l^2/42. At P = 0 the inertia leaves less, (beta l)^2/40.
double next_term(const analytic::StickMode& mode, double element_length) {
  return resolution(mode, element_length) * (1.0 / 12.0 - 1.0 / 140.0 + 1.0 / 42.0);
}

STICKSLIP_VERIFIES(RayleighBound, "M2");
// The mesh's functions are admissible: no frequency can lie below that of the beam, whatever the mode. Of the
// modes that the mesh resolves, beta l < 1, the excess of omega^2 is (beta l)^4/720 at P = 0.
TEST(RayleighBound, HoldsWithinTheInterpolationError) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(1, 10);
    const double element_length = beam.length() / elements;
    const int count = 2 * elements - 1;
    const auto exact = analytic::stick_modes(beam, count);
    const auto computed = solver::stick_modes(solver::BeamModel(beam, elements), count);
    for (int n = 0; n < count; ++n) {
      const auto& mode = exact[static_cast<std::size_t>(n)];
      const double ratio = computed[static_cast<std::size_t>(n)].angular_frequency / mode.angular_frequency();
      EXPECT_GT(ratio, 1.0) << "mode " << n + 1;
      if (resolution(mode, element_length) > 1.0) continue;
      const double predicted = studies::hermite_eigenvalue_error(beam, mode, element_length);
      const double rounding = round_off(1, std::pow(elements, 4) * mode.condition_number(), 1.0).value;
      EXPECT_TRUE(within(
          (ratio - 1.0) * (ratio + 1.0), predicted,
          discretisation(predicted * next_term(mode, element_length) + rounding, 1.5, "e (beta l)^2/10")))
          << "mode " << n + 1;
    }
  });
}

TEST(RayleighBound, HoldsForTheBucklingLoad) {
  on_random_beams(40, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    EXPECT_GT(solver::stick_buckling_load(solver::BeamModel(beam, numbers.whole(1, 12))),
              analytic::stick_buckling_load(beam));
  });
}

/// Of the static shape of a unit tip deflection: sigma'''' = -p sigma'', so that the interpolation error is
/// that of a wave of the number sqrt(|p|), which buckling amplifies.
double static_shape_error(const data::Beam& beam, int elements) {
  const double p = beam.axial_force() / rigidity(beam), l = beam.length() / elements;
  return p * p * std::pow(l, 4) / 720.0 * nearness_of_buckling(beam);
}

STICKSLIP_VERIFIES(Similarity, "M1");
// The largest reaction that theory expects of the finite elements, steps and resonance included. What its
// uncertainty leaves out: the error of the mesh's static shape, which counts near buckling, and that a tenth
// off resonance the response has five times the error of a frequency.
TEST(Similarity, LeavesTheErrorOfTheForceMaximum) {
  on_random_beams(15, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const auto natural = angular_frequencies(analytic::stick_modes(beam, 6));
    const double hz = random_frequency_hz(numbers, natural, 0.1),
                 shorter = std::min(1.0 / hz, 2.0 * pi / natural[0]);
    const data::HarmonicExcitation excitation({.frequency_hz = hz, .amplitude = beam.length() * 1e-4});
    const data::NumericalSettings numerics({.elements = 16,
                                            .time_step = shorter / 200.0,
                                            .spectral_radius = 0.9,
                                            .velocity_threshold = 0.0,
                                            .modes = 10,
                                            .duration = 2.0 / hz});
    const studies::PredictedForce predicted(beam, excitation, numerics, 16);
    const double shape_error = static_shape_error(beam, numerics.elements());
    for (const auto& [other, units] : similar_beams(numbers, beam)) {
      const double computed =
          solver::max_abs_friction_force(other, in_units(units, excitation), in_units(units, numerics)) /
          units.force();
      EXPECT_TRUE(within(computed, predicted.max_abs(),
                         discretisation(predicted.uncertainty() + shape_error * computed, 2.0,
                                        "PredictedForce::uncertainty and (sqrt(p) l)^4/720")));
      EXPECT_LT(predicted.uncertainty(), 0.05 * computed);
    }
  });
}

TEST(Similarity, LeavesTheFirstSlipOfTheClosedForm) {
  on_random_beams(5, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const auto natural = angular_frequencies(analytic::stick_modes(beam, 6));
    const double hz = random_frequency_hz(numbers, natural, 0.05);
    const data::FrictionLaw law({.static_coefficient = numbers.uniform(0.1, 1.0)});
    const data::HarmonicExcitation unit({.frequency_hz = hz, .amplitude = 1.0});
    const auto criterion = analytic::evaluate_criterion(beam, law, unit, 1.0 / hz);
    const data::HarmonicExcitation excitation(
        {.frequency_hz = hz, .amplitude = 1.5 * criterion.critical_amplitude.upper});
    const auto expected = studies::closed_form_first_slip(beam, law, excitation, 1.0 / hz);
    ASSERT_TRUE(expected);
    const double located = std::min(1.0 / hz, 2.0 * pi / natural.front()) / 2000.0 * 5e-5;
    // The force of the event-driven engine is that of the closed form but for its modes.
    const auto model = analytic::BeamContactModel(beam, law, excitation, {}, 20).model();
    analytic::EventDriven engine(model);
    engine.advance_to(1.0 / hz);
    ASSERT_FALSE(engine.events().empty());
    const analytic::StickResponse response(beam, excitation, 60, analytic::SteadyPart::exact);
    const double step = 1e-4 * std::min(1.0 / hz, 2.0 * pi / natural.front());
    const double slope =
        (response.friction_force(*expected + step) - response.friction_force(*expected - step)) /
        (2.0 * step);
    const double omitted =
        analytic::StickResponse(beam, excitation, 20, analytic::SteadyPart::exact).omitted_transient_bound();
    EXPECT_TRUE(within(engine.events().front().time, *expected,
                       discretisation(omitted / std::abs(slope) + located, 1.5, "omitted modes")));
  });
}

}  // namespace
}  // namespace stickslip::testing
