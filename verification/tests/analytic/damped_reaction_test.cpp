// SPDX-License-Identifier: MIT
/// The stick-state reaction with damping: it tends to the steady vibration in closed form. Bounds of its largest value are in
/// studies/enclosures_test.cpp.

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::DampedForce;
using analytic::SteadyPart;
using std::numbers::pi;

data::HarmonicExcitation at(double hz) { return shaking(hz, 1.0); }

DampedForce force(const data::Damping& damping, double hz, double duration, int modes = 10,
                  SteadyPart part = SteadyPart::modal_sum) {
  return {analytic::damped_reaction(analytic::HeldBeam(paper_beam(), damping, modes).structure(), part),
          2.0 * pi * hz, duration};
}

// The natural frequency, where the closed form is 0/0, among them.
std::vector<double> frequencies() {
  return {5.0, 15.0, 25.0, 35.0, 70.0, analytic::stick_modes(paper_beam(), 1).front().frequency_hz()};
}

// The eigenvalues are known to eps times the largest. That counts over the distance of i Omega from the nearest.
double rounding_of_eigenvalues(const data::Damping& damping, double hz, int modes) {
  double largest = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (const auto& share :
       analytic::damped_reaction(analytic::HeldBeam(paper_beam(), damping, modes).structure()).shares) {
    largest = std::max(largest, std::abs(share.eigenvalue));
    nearest = std::min(nearest, std::abs(share.eigenvalue - std::complex<double>(0.0, 2.0 * pi * hz)));
  }
  return round_off(4, largest / nearest, 1.0).value;
}

STICKSLIP_VERIFIES(DampedReaction, "A10");
// At times at which nothing of the start is left. The terms at Omega fall as P n^-4 + n^-6, so that twice the
// modes leave at most an eighth of the error.
TEST(DampedReaction, BecomesTheSteadyVibration) {
  for (const double hz : frequencies())
    for (const double eta : {6.4e-5, 2e-3}) {
      const analytic::DampedSteadyState steady(paper_beam(), at(hz), kelvin_voigt(eta),
                                               analytic::TipSupport::held);
      const DampedForce fine = force(kelvin_voigt(eta), hz, 100.0, 40, SteadyPart::exact);
      const DampedForce coarse = force(kelvin_voigt(eta), hz, 100.0, 20, SteadyPart::exact);
      const double scale = std::abs(steady.friction_force());
      const double rounding = rounding_of_eigenvalues(kelvin_voigt(eta), hz, 40) * scale;
      for (const double t : {60.0, 60.003, 99.123}) {
        const double expected =
            (steady.friction_force() * std::exp(std::complex<double>(0.0, 2.0 * pi * hz * t))).imag();
        const double predicted = std::abs(fine.value(t) - coarse.value(t)) / 7.0;
        const double phase = round_off(1, 2.0 * pi * hz * t, scale).value;
        EXPECT_TRUE(
            within(fine.value(t), expected,
                   discretisation(predicted + phase + rounding, 1.5, "N^-3, the phase and the eigenvalues")))
            << hz << ' ' << eta << ' ' << t;
      }
      const double next = std::abs(fine.steady_amplitude() - coarse.steady_amplitude()) / 7.0;
      EXPECT_TRUE(within(fine.steady_amplitude(), scale,
                         discretisation(next + rounding, 1.5, "N^-3 and the eigenvalues")));
    }
}

// Nearly without P the modes do not couple, and eta = 2/omega_1 damps the first one critically. A millionth more
// changes the force by about as much.
TEST(DampedReaction, IsContinuousAtCriticalDamping) {
  const data::Beam beam = paper_beam_with_axial_force(1e-6);
  const double critical = 2.0 / analytic::stick_modes(beam, 1).front().angular_frequency();
  const auto largest = [&](double eta) {
    return DampedForce(analytic::damped_reaction(analytic::HeldBeam(beam, kelvin_voigt(eta), 10).structure()),
                       2.0 * pi * 30.0, 10.0)
        .refined_to();
  };
  const Bounds at = largest(critical), beside = largest(1.000001 * critical);
  EXPECT_NEAR(at.midpoint(), beside.midpoint(), 2e-6 * beside.midpoint());
  EXPECT_LT(at.upper - at.lower, 1e-5 * at.lower);
}

TEST(DampedReaction, RefusesWhatItCannotDo) {
  for (const double narrowest : {0.99e-13, 1.0})
    EXPECT_THROW((void)force({}, 25.0, 1.0).refined_to(narrowest), std::invalid_argument);
  EXPECT_NO_THROW((void)force({}, 25.0, 1.0).refined_to(1e-13));
  EXPECT_THROW((void)force({}, 0.0, 1.0), data::FieldError);
  EXPECT_THROW((void)force({}, 25.0, 0.0), data::FieldError);
  EXPECT_THROW((void)force({}, 25.0, 1e9).refined_to(), data::FieldError);
}

}  // namespace
}  // namespace stickslip::testing
