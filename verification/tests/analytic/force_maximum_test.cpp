// SPDX-License-Identifier: MIT
/// What the searches for |f_max| refuse, the table of modes against the modes, and what is known of a band without a search. That
/// the searches hold the largest force is in studies/enclosures_test.cpp.

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::BandMaximum;
using analytic::evaluate_criterion;
using analytic::ForceMaximum;
using analytic::ModalReactionTable;
using std::numbers::pi;

STICKSLIP_VERIFIES(ForceMaximum, "A5");
TEST(ForceMaximum, RefusesWhatCannotBeSearched) {
  const analytic::ModalReaction reaction{.quasi_static = 1.0, .modes = {}};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(ForceMaximum(reaction, bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(ForceMaximum(reaction, 1.0, bad), std::invalid_argument) << bad;
  }
  for (const double width : {0.0, 1e-14, 1.0, nan})
    EXPECT_THROW((void)ForceMaximum(reaction, 1.0, 1.0).refined_to(width), std::invalid_argument) << width;
  EXPECT_THROW((void)ForceMaximum(reaction, 1e6, 1e9).refined_to(), std::invalid_argument);
}

double load_factor(const data::Beam& beam) {
  return beam.axial_force() * beam.length() * beam.length() /
         (beam.youngs_modulus() * beam.second_moment_of_area());
}

STICKSLIP_VERIFIES(ModalReactionTable, "A5");
TEST(ModalReactionTable, HoldsTheModesOfItsRange) {
  for (const double highest : {0.5, 3.0, 20.15})
    for (int i = 0; i <= 60; ++i) {
      const ModalReactionTable table(0.0, highest, 12);
      const double length = i % 2 == 0 ? 0.4 : 2.0;
      auto properties = paper_beam_properties();
      properties.length = length;
      properties.axial_force = 0.999 * highest * i / 60.0 * properties.youngs_modulus *
                               properties.second_moment_of_area / (length * length);
      const data::Beam beam(properties);
      ASSERT_LE(load_factor(beam), highest);
      const analytic::ModalReaction read = table.at(beam), exact = analytic::modal_reaction(beam, 12);
      const double condition = analytic::stick_modes(beam, 1)[0].condition_number();
      EXPECT_TRUE(
          within(read.quasi_static, exact.quasi_static, round_off(20, condition, exact.quasi_static)));
      ASSERT_EQ(read.modes.size(), 12u);
      for (std::size_t n = 0; n < 12; ++n) {
        const double kappa = n == 0 ? condition : 1.0;
        const auto& [frequency, coefficient] = exact.modes[n];
        EXPECT_TRUE(within(read.modes[n].angular_frequency, frequency, round_off(10, kappa, frequency)));
        EXPECT_TRUE(within(read.modes[n].coefficient, coefficient, round_off(20, kappa, coefficient)));
      }
    }
}

TEST(ModalReactionTable, RefusesOthersThanItsRange) {
  const double z = load_factor(paper_beam());
  EXPECT_THROW((void)ModalReactionTable(2.0 * z, 3.0 * z, 3).at(paper_beam()), std::invalid_argument);
  EXPECT_THROW((void)ModalReactionTable(0.0, 0.5 * z, 3).at(paper_beam()), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(2.0, 1.0, 3), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(-1.0, 1.0, 3), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(std::nan(""), 1.0, 3), std::invalid_argument);
  EXPECT_THROW(ModalReactionTable(0.0, 21.0, 3), data::InputError);  // over the buckling load
}

STICKSLIP_VERIFIES(Criterion, "A6");
TEST(Criterion, AmplitudeBoundsInvertForceBounds) {
  for (const double width : {0.3, 0.03}) {
    const auto criterion = evaluate_criterion(paper_problem(35.0, 1e-3), width);
    ASSERT_GT(criterion.force_max.upper, criterion.force_max.lower * (1.0 + 1e-6));
    EXPECT_DOUBLE_EQ(criterion.critical_amplitude.lower * criterion.force_max.upper, 300.0 * 1e-3);
    EXPECT_DOUBLE_EQ(criterion.critical_amplitude.upper * criterion.force_max.lower, 300.0 * 1e-3);
  }
}

STICKSLIP_VERIFIES(BandMaximum, "X15");
TEST(BandMaximum, BoundsOfOneModeAreSumsOfSuprema) {
  // f = A sin(Omega t) - B sin(omega_1 t) with A = F + c p and B = c p Omega/omega_1, p = Omega^2/(Omega^2 -
  // omega_1^2): |f| <= |A| + |B| and |f_OmegaOmega| <= T^2 |A| + 2 T |A'| + |A''| + |B''|. Derivatives by
  // central differences, off by (h/(Omega - omega_1))^2 and by round-off eps/h^2.
  const analytic::ModalForce mode = analytic::modal_forces(paper_beam(), 1).front();
  const double base = paper_beam().youngs_modulus() * paper_beam().second_moment_of_area() *
                      analytic::QuasiStaticShape(paper_beam()).third_derivative(paper_beam().length());
  const double natural = mode.angular_frequency, c = mode.coefficient;
  const auto share = [&](double omega) { return omega * omega / ((omega - natural) * (omega + natural)); };
  const auto steady = [&](double omega) { return base + c * share(omega); };
  const auto free = [&](double omega) { return c * share(omega) * omega / natural; };
  for (const double ratio : {0.3, 0.8, 1.5, 3.0})
    for (const double periods : {4.0, 10.0}) {  // so long that no bound of a mode in the interval is nearer
      const double omega = ratio * natural, duration = periods * 2.0 * pi / natural;
      const double h = 1e-3 * std::abs(omega - natural);
      const auto slope = [h, omega](auto f) { return (f(omega + h) - f(omega - h)) / (2.0 * h); };
      const auto bend = [h, omega](auto f) {
        return (f(omega + h) - 2.0 * f(omega) + f(omega - h)) / (h * h);
      };
      const BandMaximum search(analytic::modal_reaction(paper_beam(), 1),
                               {omega / (2.0 * pi), omega / (2.0 * pi)}, duration);
      const auto suprema = search.between(omega, omega);
      const double force = std::abs(steady(omega)) + std::abs(free(omega));
      const double curvature = duration * duration * std::abs(steady(omega)) +
                               2.0 * duration * std::abs(slope(steady)) + std::abs(bend(steady)) +
                               std::abs(bend(free));
      EXPECT_TRUE(within(suprema.force, force, round_off(20, 1.0 / std::abs(1.0 - ratio), force)));
      EXPECT_TRUE(within(suprema.curvature, curvature,
                         discretisation(1e-6 * curvature, 2.0, "(h/(Omega - omega_1))^2")))
          << ratio << ", " << periods;
    }
}

TEST(BandMaximum, RefusesWhatIsNoBand) {
  const auto reaction = analytic::modal_reaction(paper_beam(), 10);
  EXPECT_THROW(BandMaximum(reaction, {0.0, 1.0}, 1.0), std::invalid_argument);
  EXPECT_THROW(BandMaximum(reaction, {2.0, 1.0}, 1.0), std::invalid_argument);
  EXPECT_THROW(BandMaximum(reaction, {1.0, 2.0}, 0.0), std::invalid_argument);
  for (const double width : {0.0, 0.99e-7, 1.0})
    EXPECT_THROW((void)BandMaximum(reaction, {1.0, 1.0}, 1.0).refined_to(width), std::invalid_argument);
  EXPECT_NO_THROW((void)BandMaximum(reaction, {1.0, 1.0}, 1.0).refined_to(1e-7));
  EXPECT_THROW((void)analytic::modal_reaction(paper_beam_with_axial_force(1e6), 10), data::InputError);
}

}  // namespace
}  // namespace stickslip::testing
