// SPDX-License-Identifier: MIT
/// What the mesh does to the frequencies of any beam.

#include <Eigen/Dense>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/discretisation.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

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

}  // namespace
}  // namespace stickslip::testing
