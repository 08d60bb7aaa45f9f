// SPDX-License-Identifier: MIT
/// Doubles against proven enclosures: the closed form to round-off, finite elements from above.

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/certified/complex.hpp"
#include "stickslip/certified/force_maximum.hpp"
#include "stickslip/certified/stick_modes.hpp"
#include "stickslip/certified/stick_response.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/paper_checks.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using certified::Rational;
using certified::Real;

constexpr int mode_count = 10;

/// The very doubles, so that no conversion of decimals enters.
certified::Beam exactly(const data::Beam& beam) {
  return certified::Beam({Rational(beam.length()), Rational(beam.area()),
                          Rational(beam.second_moment_of_area()), Rational(beam.density()),
                          Rational(beam.youngs_modulus()), Rational(beam.axial_force())});
}

/// Random beams, and the paper's with the axial forces at which closed forms lose digits: next to buckling, none, next to none,
/// and a tension that makes a string of it.
template <class Claim>
void on_beams(Claim&& claim) {
  for (const data::Beam& beam :
       {paper_beam(), paper_beam_with_axial_force(0.97 * analytic::stick_buckling_load(paper_beam())),
        paper_beam_with_axial_force(0.0), paper_beam_with_load_factor(1e-7),
        paper_beam_with_load_factor(-1e3)}) {
    SCOPED_TRACE(description(beam));
    claim(beam);
  }
  on_random_beams(5, any_force, [&](const data::Beam& beam, RandomNumbers&) { claim(beam); });
}

/// `computed` is off by a rounding error, relative to the larger of the exact value and `scale`.
::testing::AssertionResult within_round_off(double computed, const Real& exact, double operations,
                                            double condition, double scale = 0.0) {
  return within(
      certified::distance(computed, exact), 0.0,
      round_off(operations, condition, std::max(std::abs(exact.nearest_double()), std::abs(scale))));
}

/// Quantities of a beam by mode, against enclosures of them. Their condition is 1 + |P dq/dP|/|q|, by differences of
/// enclosed values.
template <class Enclosed>
void expect_in_the_last_places(const std::vector<double>& computed, const data::Beam& beam,
                               const Enclosed& enclosed, double operations) {
  constexpr double kStep = 1e-6;
  const std::vector<Real> exact = enclosed(exactly(beam));
  const std::vector<Real> beside = enclosed(
      exactly(studies::with(beam, &data::BeamProperties::axial_force, beam.axial_force() * (1.0 - kStep))));
  for (std::size_t n = 0; n < computed.size(); ++n) {
    const double sensitivity = std::abs((beside[n] - exact[n]).nearest_double()) / kStep;
    EXPECT_TRUE(
        within_round_off(computed[n], exact[n], operations, 1.0 + sensitivity / std::abs(computed[n])))
        << n + 1;
  }
}

STICKSLIP_VERIFIES(EnclosedFrequencies, "X19");
TEST(EnclosedFrequencies, AgreeInStick) {
  // Ten roundings: EI, rho A, their quotient, its root, L^2, z, b, bb, the product, 2 pi.
  on_beams([&](const data::Beam& beam) {
    const auto exact = certified::stick_modes(exactly(beam), mode_count);
    const auto modes = analytic::stick_modes(beam, mode_count);
    for (std::size_t n = 0; n < modes.size(); ++n) {
      const double condition = modes[n].condition_number();
      EXPECT_TRUE(within_round_off(modes[n].angular_frequency(), exact[n].angular_frequency, 10, condition))
          << n + 1;
      EXPECT_TRUE(within_round_off(modes[n].frequency_hz(), exact[n].frequency_hz, 10, condition)) << n + 1;
      EXPECT_TRUE(within_round_off(modes[n].trigonometric_wave_number(), exact[n].trigonometric_wave_number,
                                   10, condition))
          << n + 1;
    }
  });
}

TEST(EnclosedFrequencies, AgreeInSlip) {
  const auto enclosed = [](const certified::Beam& beam) {
    return certified::slip_frequencies(beam, mode_count);
  };
  on_beams([&](const data::Beam& beam) {
    std::vector<double> computed;
    for (const auto& mode : analytic::slip_modes(beam, mode_count))
      computed.push_back(mode.angular_frequency());
    expect_in_the_last_places(computed, beam, enclosed, 10);
  });
}

TEST(EnclosedFrequencies, AgreeOfBucklingAndFlutter) {
  const data::Beam beam = paper_beam();
  const certified::Beam exact = exactly(beam);
  EXPECT_TRUE(within_round_off(analytic::stick_buckling_load(beam), certified::buckling_load(exact), 5, 1));
  const Real flutter = certified::flutter_factor() * exact.bending_stiffness() / pow(exact.length(), 2);
  const double computed = analytic::slip_critical_load(beam);
  EXPECT_TRUE(within(certified::distance(computed, flutter), 0.0,
                     reference(1e-12 * computed, "the flutter load in doubles")));
}

TEST(EnclosedFrequencies, AreBelowFiniteElements) {
  // Hermite elements with the consistent mass are a Ritz method.
  on_beams([](const data::Beam& beam) {
    const auto exact = certified::stick_modes(exactly(beam), 5);
    const auto modes = solver::stick_modes(solver::BeamModel(beam, 12), 5);
    for (std::size_t n = 0; n < modes.size(); ++n)
      EXPECT_TRUE(Real(modes[n].angular_frequency) > exact[n].angular_frequency) << n + 1;
  });
}

STICKSLIP_VERIFIES(EnclosedShapes, "X19");
TEST(EnclosedShapes, AgreeInModes) {
  on_beams([&](const data::Beam& beam) {
    const auto exact = certified::stick_modes(exactly(beam), mode_count);
    const auto modes = analytic::stick_modes(beam, mode_count);
    for (std::size_t n = 0; n < modes.size(); ++n) {
      const double bb = modes[n].trigonometric_wave_number() * beam.length();
      for (const double share : {0.05, 0.31, 0.5, 0.83}) {
        const double x = share * beam.length();
        const auto shape = exact[n].shape(Real(x));
        const std::array computed{modes[n].shape(x), modes[n].slope(x), modes[n].curvature(x)};
        for (std::size_t order = 0; order < 3; ++order)
          EXPECT_TRUE(within_round_off(computed[order], shape[order], 10, bb * modes[n].condition_number(),
                                       std::pow(bb / beam.length(), order)))
              << "derivative " << order << " of mode " << n + 1 << " at " << share;
      }
      EXPECT_TRUE(within_round_off(modes[n].third_derivative(beam.length()),
                                   exact[n].shape(Real(beam.length()))[3], 10,
                                   3 * modes[n].condition_number()))
          << n + 1;
    }
  });
}

TEST(EnclosedShapes, AgreeInParticipations) {
  const auto enclosed = [](const certified::Beam& beam) {
    std::vector<Real> values;
    for (const auto& mode : certified::stick_modes(beam, mode_count)) values.push_back(mode.participation);
    return values;
  };
  on_beams([&](const data::Beam& beam) {
    std::vector<double> computed;
    for (const auto& mode : analytic::stick_modes(beam, mode_count)) computed.push_back(mode.participation());
    expect_in_the_last_places(computed, beam, enclosed, 20);
  });
}

TEST(EnclosedShapes, AgreeInStaticDeflection) {
  on_beams([&](const data::Beam& beam) {
    const certified::QuasiStaticShape exact(exactly(beam));
    const analytic::QuasiStaticShape shape(beam);
    const double condition = nearness_of_buckling(beam), length = beam.length();
    for (const double share : {0.05, 0.31, 0.5, 0.83, 1.0}) {
      const double x = share * length;
      const auto values = exact.at(Real(x));
      const std::array computed{shape.value(x), shape.slope(x), shape.curvature(x),
                                shape.third_derivative(x)};
      // Near the base S ~ (x/L)^2 is a difference of terms of the order of 1.
      const std::array scales{1.0, 1.0, 3.0, 3.0};
      for (std::size_t order = 0; order < 4; ++order)
        EXPECT_TRUE(within_round_off(computed[order], values[order], 10, condition,
                                     scales[order] / std::pow(length, order)))
            << "derivative " << order << " at " << share;
    }
  });
}

/// Between the first two natural frequencies, away from both.
data::HarmonicExcitation shaken(const data::Beam& beam) {
  const auto modes = analytic::stick_modes(beam, 2);
  return data::HarmonicExcitation(
      {.frequency_hz = 0.6 * modes[0].frequency_hz() + 0.4 * modes[1].frequency_hz(),
       .amplitude = 1e-3 * beam.length()});
}

certified::Excitation exactly(const data::HarmonicExcitation& excitation) {
  return {Rational(excitation.frequency_hz()), Rational(excitation.amplitude())};
}

/// Sum of the amplitudes of a history, each times 1 + w t for the rounding of its phase, and times the
/// condition of its frequency.
double history_scale(const analytic::StickResponse& response, double omega, double steady,
                     const std::vector<analytic::Sinusoid>& transient, double t) {
  double scale = std::abs(steady) * (1.0 + omega * t);
  for (std::size_t n = 0; n < transient.size(); ++n)
    scale += std::abs(transient[n].amplitude) * (1.0 + transient[n].angular_frequency * t) *
             response.modes()[n].condition_number();
  return scale;
}

STICKSLIP_VERIFIES(EnclosedResponse, "X19");
TEST(EnclosedResponse, AgreesInMotionAndForce) {
  on_beams([&](const data::Beam& beam) {
    const data::HarmonicExcitation excitation = shaken(beam);
    const analytic::StickResponse response(beam, excitation, mode_count);
    const certified::StickResponse exact(exactly(beam), exactly(excitation), mode_count);
    const double condition = nearness_of_buckling(beam);
    const double omega = studies::angular_frequency(excitation);
    for (const double periods : {0.13, 3.7, 41.3}) {
      SCOPED_TRACE(periods);
      const double t = periods * period(excitation);
      EXPECT_TRUE(within_round_off(
          response.friction_force(t), exact.friction_force(Real(t)), 10, condition,
          history_scale(response, omega, response.steady_force_amplitude(), response.transient_force(), t)));
      for (const double share : {0.4, 0.77}) {
        const double x = share * beam.length();
        const double scale =
            excitation.amplitude() + history_scale(response, omega, response.steady_displacement_amplitude(x),
                                                   response.transient_displacement(x), t);
        EXPECT_TRUE(within_round_off(response.relative_displacement(x, t),
                                     exact.relative_displacement(Real(x), Real(t)), 10, condition, scale));
        EXPECT_TRUE(within_round_off(response.absolute_displacement(x, t),
                                     exact.absolute_displacement(Real(x), Real(t)), 10, condition, scale));
      }
    }
  });
}

STICKSLIP_VERIFIES(EnclosedMaximum, "X19");
TEST(EnclosedMaximum, MatchesAmplitudeAndVerdict) {
  for (const double hz : {15.0, 25.0, 35.0, 70.0}) {
    const data::HarmonicExcitation excitation({.frequency_hz = hz, .amplitude = 0.5e-3});
    const auto criterion = analytic::evaluate_criterion(paper_problem(hz, 0.5e-3, 10.0));
    const Real force =
        certified::max_abs_friction_force(exactly(paper_beam()), exactly(excitation), "10").value;
    const Real limit = Real(0.6) * 500;
    EXPECT_TRUE((limit * Real(0.5e-3) / force)
                    .overlaps(hull(Real(criterion.critical_amplitude.lower),
                                   Real(criterion.critical_amplitude.upper))))
        << hz;
    EXPECT_TRUE(criterion.verdict == analytic::Verdict::stick ? force <= limit : force > limit) << hz;
  }
}

using Complex = std::complex<double>;

/// The doubles next to the enclosed Y(s).
Complex enclosed_mobility(const data::Beam& beam, double eta, Complex s) {
  const auto y = certified::tip_mobility(exactly(beam), Real(s.real()), Real(s.imag()), Rational(eta));
  return {y.real().nearest_double(), y.imaginary().nearest_double()};
}

STICKSLIP_VERIFIES(EnclosedTipMobility, "X19");
TEST(EnclosedTipMobility, AgreesAsFarAsPolesAllow) {
  // a = -z + 2 k and b = -z - 2 k are rounded to eps (|z| + 2 |k|), which is as much in z and half of it in
  // k. The density moves k alone, k dY/dk = 2 rho dY/d rho, the axial force z. Ten roundings: EI, rho A, 1 +
  // eta s, D, their quotient, its root, L^2, k, a, Phi(a). The last sizes are k = |z|/2, where l_1 =
  // l_2, and next to it, where Phi is a series.
  constexpr double kStep = 1e-7;
  on_beams([](const data::Beam& beam) {
    const double meeting =
        0.5 * std::abs(beam.axial_force()) / std::sqrt(rigidity(beam) * beam.density() * beam.area());
    for (const double eta : {0.0, 1e-5})
      for (const double size :
           {1e-3, 0.3, 20.0, 1e3, 4e4, 1e6, 1e9, 1e12, meeting, meeting + 0.1 * frequency_unit(beam)}) {
        if (size == 0.0) continue;
        for (const double angle : {0.0, 0.3, 1.0, 1.5, 0.5 * std::numbers::pi}) {
          const Complex s = std::polar(size, angle), y = enclosed_mobility(beam, eta, s);
          const Complex rigidity_of_s = rigidity(beam) * (1.0 + eta * s);
          const double load_unit = std::abs(rigidity_of_s) / std::pow(beam.length(), 2);
          const double k = std::abs(s * std::pow(beam.length(), 2) *
                                    std::sqrt(beam.density() * beam.area() / rigidity_of_s));
          const double width = std::abs(beam.axial_force()) / load_unit + 2.0 * k;
          const auto change = [&](double data::BeamProperties::*field, double by) {
            const data::Beam beside = studies::with(beam, field, beam.properties().*field + by);
            return std::abs(enclosed_mobility(beside, eta, s) - y) / kStep;
          };
          const double of_density = change(&data::BeamProperties::density, kStep * beam.density()),
                       of_force = change(&data::BeamProperties::axial_force, kStep * load_unit);
          const double condition = 1.0 + width * (of_density / k + of_force) / std::abs(y);
          const Complex error = analytic::TipMobility(beam, data::Damping({.kelvin_voigt = eta}))(s) - y;
          EXPECT_TRUE(within(error / y, 0.0, round_off(10, condition, 1.0)))
              << "eta = " << eta << ", s = " << s;
        }
      }
  });
}

}  // namespace
}  // namespace stickslip::testing
