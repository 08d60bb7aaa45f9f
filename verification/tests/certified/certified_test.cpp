// SPDX-License-Identifier: MIT
/// Ball arithmetic: what is certain is stated, what is not is not, and the closed forms have their
/// properties.

#include "stickslip/certified/complex.hpp"
#include "stickslip/certified/force_maximum.hpp"
#include "stickslip/certified/roots.hpp"
#include "stickslip/certified/stick_modes.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using namespace certified;
using std::domain_error, std::invalid_argument, std::runtime_error;

Real decimal(const std::string& text) { return Rational(std::string_view(text)); }

/// x is known to one unit in the last of the digits given, and agrees with them.
::testing::AssertionResult has_digits(const Real& x, const std::string& digits) {
  const std::size_t point = digits.find('.');
  const auto decimals = static_cast<unsigned>(digits.size() - point - 1);
  const Real unit = 1 / pow(Real(10), decimals);
  if (abs(x - decimal(digits)) <= unit && x.radius() < unit) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << enclosure(x, 40).value << " is not " << digits;
}

/// x may be 0 and is at most 10^-digits in size.
::testing::AssertionResult vanishes(const Real& x, unsigned digits = 40) {
  if (x.contains_zero() && abs(x) < 1 / pow(Real(10), digits)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << enclosure(x, 10).value << " +/- " << enclosure(x, 10).radius
                                       << " is not 0 to " << digits << " digits";
}

template <class Error>
void refuses(const std::string& part, const std::function<void()>& action) {
  expect_error_message<Error>(action, {part.c_str()});
}

Beam paper_beam(const Rational& axial_force = "500") {
  return Beam({"2", "0.01", "1/120000", "1000", "2e9", axial_force});
}

/// Length, EI and rho A are 1: omega = kappa, P = z.
Beam unit_beam(const Rational& axial_force) { return Beam({"1", "1", "1", "1", "1", axial_force}); }

/// Compression, P = 0, tension, close to buckling.
std::vector<Beam> beams() {
  return {paper_beam(), paper_beam("0"), paper_beam("-9000"), paper_beam("80000"), unit_beam("1e-9")};
}

/// Of more bits each ball lies in the one of fewer, is as much more accurate, and excludes a wrong digit.
void expect_nested(const std::function<std::vector<Real>()>& quantities) {
  const auto at = [&](long bits) {
    const PrecisionScope scope(bits);
    return quantities();
  };
  const auto coarse = at(128), fine = at(256);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_TRUE(coarse[i].contains(fine[i])) << i;
    EXPECT_GT(fine[i].accurate_bits(), coarse[i].accurate_bits() + 110) << i;
    EXPECT_FALSE(coarse[i].overlaps(fine[i] * (1 + Real(Rational("1e-30"))))) << i;
  }
}

// Real.

STICKSLIP_VERIFIES(CertifiedReal, "A8");
TEST(CertifiedReal, ReadsDecimalsAndRatiosExactly) {
  EXPECT_TRUE((Real(Rational("1/120000")) * 120000 - 1).contains_zero());
  EXPECT_TRUE((Real(Rational("-0.5e-3")) * 2000 + 1).contains_zero());
  EXPECT_TRUE((Real(Rational("1.5E+3/3e0")) - 500).contains_zero());
  EXPECT_TRUE((Real(Rational("+.25")) - Real(0.25)).contains_zero());
  EXPECT_TRUE((Real(Rational("2e9")) - Real(2e9)).contains_zero());
  // The double 0.1 is 0.1000000000000000055511151231257827...
  EXPECT_TRUE(has_digits(Real(Rational(0.1)), "0.1000000000000000055511151231257827"));
  EXPECT_TRUE(has_digits(Rational("0.1"), "0.1000000000000000000000000000000000"));
  EXPECT_EQ(Rational("-1/3").sign(), -1);
  EXPECT_EQ(Rational("0e5").sign(), 0);
}

TEST(CertifiedReal, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"", "abc", "1/0", "1e", "1e10001", "1e-10001", "1/2/3", "--1", "1e+-3", " 1", "1 ", ".", "1/"})
    refuses<invalid_argument>(std::string(text) + "' is no exact number", [=] { (void)Rational(text); });
  for (const char* text : {"1e10000", "1e-10000"}) EXPECT_EQ(Rational(text).sign(), 1);
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    refuses<invalid_argument>("not finite", [=] { (void)Rational(value); });
    refuses<invalid_argument>("not finite", [=] { (void)Real(value); });
  }
  for (const long bits : {8L, 31L, 1'000'001L})
    refuses<invalid_argument>(std::to_string(bits) + " bits", [=] { const PrecisionScope scope(bits); });
  for (const long bits : {32L, 1'000'000L}) EXPECT_NO_THROW(const PrecisionScope scope(bits)) << bits;
}

TEST(CertifiedReal, OrdersOnlyWhatIsCertain) {
  const Real low = hull(1, 2), high = hull(3, 4), between = hull(Real(1.5), Real(3.5));
  EXPECT_TRUE(low < high && low <= high && high > low && high >= low);
  EXPECT_FALSE(low > high || low >= high || high < low || high <= low);
  for (const Real& other : {low, high})
    EXPECT_FALSE(between < other || between > other || between <= other || between >= other);
  EXPECT_TRUE(low.overlaps(between) && high.overlaps(between) && !low.overlaps(high));
  EXPECT_TRUE(hull(low, high).contains(between) && !between.contains(low));
  EXPECT_TRUE(intersection(low, between).contains(Real(1.75)));
  EXPECT_FALSE(intersection(low, between).contains(Real(1.25)));
  EXPECT_THROW((void)intersection(low, high), std::logic_error);
  EXPECT_EQ(low.certain_sign(), 1);
  EXPECT_EQ((-low).certain_sign(), -1);
  EXPECT_EQ((low - between).certain_sign(), 0);
}

TEST(CertifiedReal, FunctionsKeepTheirIdentities) {
  for (const char* text : {"1/7", "2.5", "-11/3", "40"}) {
    const Real x = Rational(text);
    EXPECT_TRUE(vanishes(pow(sin(x), 2) + pow(cos(x), 2) - 1));
    EXPECT_TRUE(vanishes((pow(cosh(x), 2) - pow(sinh(x), 2) - 1)));
    EXPECT_TRUE(vanishes(tan(x) - sin(x) / cos(x)));
    EXPECT_TRUE(vanishes(exp(x) * exp(-x) - 1));
    EXPECT_TRUE(vanishes(pow(sqrt(abs(x)), 2) - abs(x)));
    EXPECT_TRUE(vanishes(sinc(x) * x - sin(x)));
    EXPECT_TRUE(vanishes(max(x, -x) - abs(x)));
  }
  EXPECT_TRUE(has_digits(pi(), "3.14159265358979323846264338327950288419716939937510"));
  EXPECT_TRUE(sinc(Real(0)).contains(Real(1)));
}

TEST(CertifiedReal, PrintsADecimalBallAroundTheBall) {
  for (const Real& x :
       {pi(), -exp(Real(100)) / 3, Real(Rational("1e-40/7")), hull(Real(1), Real(Rational("1.001"))),
        Real(0.5), Real(0), hull(-1, 2), hull(-1, 1)}) {
    const Enclosure printed = enclosure(x);
    const Real value = decimal(printed.value), radius = decimal(printed.radius);
    EXPECT_TRUE(value - radius <= x.lower() && x.upper() <= value + radius)
        << printed.value << " " << printed.radius;
    EXPECT_TRUE(radius <= x.radius() * Real(1.1) + abs(value) / pow(Real(10), 28)) << printed.radius;
    EXPECT_DOUBLE_EQ(printed.midpoint, x.nearest_double());
  }
  EXPECT_EQ(enclosure(pi()).value, "3.14159265358979323846264338328");
  EXPECT_EQ(enclosure(Real(0.5)).radius, "0");
  EXPECT_THROW((void)enclosure(1 / Real(0)), std::invalid_argument);
}

TEST(CertifiedReal, BoundsTheErrorOfADouble) {
  EXPECT_EQ(distance(1.0, Real(1)), 0.0);
  EXPECT_EQ(distance(1.0, Real(1) + Real(0x1p-53)), 0x1p-53);
  EXPECT_EQ(distance(-3.0, Real(-3) + Real(0x1p-50)), 0x1p-50);
  EXPECT_EQ(distance(0.0, Real(0x1p-1073)), 0x1p-1073);
  EXPECT_TRUE(within(distance(std::numbers::pi, pi()), 1.2246467991473532e-16,
                     round_off(4, 1, 1.2246467991473532e-16)));
  EXPECT_GE(distance(1.0, hull(1, 2)), 1.0);
  EXPECT_TRUE(std::isinf(distance(std::nan(""), Real(1))));
  EXPECT_TRUE(std::isinf(distance(1.0, 1 / Real(0))));
}

// Roots.

STICKSLIP_VERIFIES(CertifiedRoots, "A8");
TEST(CertifiedRoots, FindsEveryZeroOfTheSine) {
  const auto sine = [](const Real& x) { return sin(Dual<Real>(x, 1)); };
  const std::vector<Real> roots = isolate_roots(sine, 1, 100);
  ASSERT_EQ(roots.size(), 31u);
  for (std::size_t n = 1; n <= roots.size(); ++n)
    EXPECT_TRUE(vanishes(roots[n - 1] - static_cast<int>(n) * pi(), 65)) << n;
}

/// (x - 1)(x - 1 - gap).
DifferentiableFunction parabola(const Rational& gap) {
  return [second = 1 + Real(gap)](const Real& at) {
    const Dual<Real> x(at, 1);
    return (x - 1) * (x - Dual<Real>(second));
  };
}

TEST(CertifiedRoots, TellsCloseRootsApart) {
  const std::vector<Real> roots = isolate_roots(parabola("1e-10"), 0, 3);
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_TRUE(roots[0].contains(1) && !roots[1].contains(1));
  EXPECT_TRUE(vanishes(roots[1] - roots[0] - Real(Rational("1e-10")), 60));
}

TEST(CertifiedRoots, RefusesWhatItCannotDecide) {
  refuses<runtime_error>("between", [] { (void)isolate_roots(parabola("0"), 0, 3); });
  refuses<runtime_error>("between", [] { (void)isolate_roots(parabola("1e-30"), 0, 3); });
  refuses<runtime_error>("certain sign at the ends", [] { (void)isolate_roots(parabola("1/2"), 1, 3); });
  refuses<invalid_argument>("exact and ascending", [] { (void)isolate_roots(parabola("1/2"), 3, 0); });
  refuses<invalid_argument>("exact and ascending", [] { (void)isolate_roots(parabola("1/2"), 0, pi()); });
  refuses<runtime_error>("2 roots", [] { (void)isolate_root(parabola("1/2"), 0, 3); });
}

// Stick modes.

STICKSLIP_VERIFIES(CertifiedStickModes, "A8");
TEST(CertifiedStickModes, BuckleAtTheRootOfTan) {
  const Real y = sqrt(buckling_factor());
  EXPECT_TRUE(has_digits(y, "4.49340945790906417530788092728"));
  EXPECT_TRUE(vanishes(tan(y) - y));
  EXPECT_TRUE(vanishes(buckling_load(paper_beam()) * 6 / 25000 - buckling_factor()));
}

TEST(CertifiedStickModes, SolveTheirEquation) {
  for (const Beam& beam : beams()) {
    const Real length = beam.length(), p = beam.axial_force() / beam.bending_stiffness();
    for (const StickMode& mode : certified::stick_modes(beam, 10)) {
      SCOPED_TRACE(mode.number);
      const Real beta2 = pow(mode.hyperbolic_wave_number, 2),
                 betabar2 = pow(mode.trigonometric_wave_number, 2);
      const Derivatives base = mode.shape(0), tip = mode.shape(length);
      EXPECT_TRUE(vanishes(base[0], 35) && vanishes(base[1], 35) && vanishes(tip[0], 35) &&
                  vanishes(tip[2], 35));
      EXPECT_TRUE(vanishes(base[2] / (beta2 + betabar2) - 1));
      // Solutions of phi'' = beta^2 phi and psi'' = -betabar^2 psi solve U'''' + p U'' = k U if and only if
      EXPECT_TRUE(vanishes((betabar2 - beta2 - p) / betabar2));
      EXPECT_TRUE(vanishes(beta2 * betabar2 * beam.bending_stiffness() /
                               (beam.mass_per_length() * pow(mode.angular_frequency, 2)) -
                           1));
    }
  }
}

TEST(CertifiedStickModes, LieOneInEachInterval) {
  for (const char* load : {"-300", "0", "15"}) {
    const auto modes = certified::stick_modes(unit_beam(load), 60);
    ASSERT_EQ(modes.size(), 60u);
    for (const StickMode& mode : modes) {
      const Real bb = mode.trigonometric_wave_number / pi();
      EXPECT_TRUE(mode.number < bb && bb < mode.number + Real(0.5)) << load << mode.number;
    }
  }
}

TEST(CertifiedStickModes, NestUnderRefinement) {
  expect_nested([] {
    const auto mode = certified::stick_modes(paper_beam(), 4).back();
    return std::vector{mode.angular_frequency, mode.participation, mode.shape(Real(0.75))[0],
                       mode.shape(2)[3]};
  });
  EXPECT_EQ(precision(), 256);
}

TEST(CertifiedStickModes, RefuseImpossibleBeams) {
  EXPECT_NO_THROW((void)certified::stick_modes(unit_beam("20.1907"), 1));
  refuses<domain_error>("beam.axial_force is 20.190728557;",
                        [] { (void)certified::stick_modes(unit_beam("20.190728557"), 1); });
  refuses<domain_error>("20.19072855642663", [] { (void)QuasiStaticShape(unit_beam("21")); });
  for (const char* value : {"-2", "0"})
    for (const auto& [member, field] : {std::pair{&BeamData::length, "beam.length"},
                                        {&BeamData::area, "beam.area"},
                                        {&BeamData::second_moment_of_area, "beam.second_moment_of_area"},
                                        {&BeamData::density, "beam.density"},
                                        {&BeamData::youngs_modulus, "beam.youngs_modulus"}}) {
      BeamData data{"1", "1", "1", "1", "1", "0"};
      data.*member = value;
      expect_error_message<std::invalid_argument>([&] { (void)Beam(data); }, {field, value});
    }
  for (const int count : {0, 1001})
    refuses<invalid_argument>("numerics.modes", [=] { (void)certified::stick_modes(paper_beam(), count); });
}

// Slip modes.

STICKSLIP_VERIFIES(CertifiedSlipModes, "A8");
TEST(CertifiedSlipModes, FlutterWhereBeckHasIt) {
  EXPECT_TRUE(has_digits(flutter_factor(), "20.050953"));
  EXPECT_GT(flutter_factor().accurate_bits(), 200);
  const auto below = slip_frequencies(unit_beam("20.0509536"), 2);
  EXPECT_TRUE(below[0] < below[1]);
  EXPECT_TRUE(below[1] - below[0] < Real(0.01));
  refuses<domain_error>("below the flutter load of the slip state, 20.0509536189737",
                        [] { (void)slip_frequencies(unit_beam("20.0509537"), 2); });
  refuses<domain_error>("beam.axial_force is 1000", [] { (void)slip_frequencies(unit_beam("1000"), 2); });
  for (const int count : {0, 1001})
    refuses<invalid_argument>("numerics.modes is " + std::to_string(count),
                              [&] { (void)slip_frequencies(unit_beam("1"), count); });
}

// Response.

STICKSLIP_VERIFIES(CertifiedResponse, "A8");
TEST(CertifiedResponse, ObeysStartAndBoundaries) {
  for (const Beam& beam : beams()) {
    const StickResponse response(beam, {"31/3", "1/1000"}, 6);
    const Real length = beam.length(), t = Rational("1/7");
    const Real base = sin(2 * pi() * Real(Rational("31/3")) * t) / 1000;
    EXPECT_TRUE(vanishes(response.absolute_displacement(0, t) - base, 35));
    EXPECT_TRUE(vanishes(response.absolute_displacement(length, t), 35));
    EXPECT_TRUE(vanishes(response.relative_displacement(length, t) + base, 35));
    EXPECT_TRUE(vanishes(response.relative_displacement(length / 2, 0)));
    EXPECT_TRUE(vanishes(response.friction_force(0)));
  }
}

TEST(CertifiedResponse, EnclosesForceAtResonance) {
  // At 100 bits the excitation cannot be told from the mode, at 256 it can: two formulas for one number.
  const std::string natural =
      enclosure(certified::stick_modes(paper_beam(), 1).front().frequency_hz, 40).value;
  const Excitation excitation{std::string_view(natural), "1e-3"};
  const auto force = [&](long bits) {
    const PrecisionScope scope(bits);
    return StickResponse(paper_beam(), excitation, 3).friction_force(Rational("1.3"));
  };
  const Real coarse = force(100), fine = force(256);
  EXPECT_TRUE(coarse.contains(fine));
  EXPECT_GT(coarse.accurate_bits(), 50);
  EXPECT_GT(fine.accurate_bits(), 80);  // of which the quotient costs 133
  const PrecisionScope scope(100);
  refuses<domain_error>("natural frequency 1",
                        [&] { (void)StickResponse(paper_beam(), excitation, 3).force_sinusoids(); });
}

TEST(CertifiedResponse, RefusesAWrongExcitation) {
  const Excitation at_rest{"0", "1"}, backwards{"1", "-1"};
  refuses<invalid_argument>("excitation.frequency_hz is 0",
                            [&] { (void)StickResponse(paper_beam(), at_rest); });
  refuses<invalid_argument>("excitation.amplitude is -1",
                            [&] { (void)StickResponse(paper_beam(), backwards); });
  const StickResponse still(paper_beam(), {"1", "0"}, 1);
  EXPECT_TRUE(still.friction_force(Rational("0.3")).contains(0));
  EXPECT_TRUE(still.friction_force(Rational("0.3")).radius() <= 0);
}

// Mobility of the tip.

STICKSLIP_VERIFIES(CertifiedTipMobility, "A8");
TEST(CertifiedTipMobility, IsThePublishedReceptance) {
  // Y(i omega) = i omega (sin b cosh b - cos b sinh b)/[b^3 (1 + cos b cosh b)], b^2 = omega (Bishop and
  // Johnson 1960), of a beam of unit length, stiffness and mass.
  for (const char* omega : {"1e-3", "1", "10", "1e6"}) {
    const Complex y = tip_mobility(unit_beam("0"), 0, Rational(omega));
    const Real b = sqrt(Real(Rational(omega)));
    const Real expected =
        b * b * (sin(b) * cosh(b) - cos(b) * sinh(b)) / (pow(b, 3) * (1 + cos(b) * cosh(b)));
    EXPECT_TRUE(vanishes(y.real())) << omega;
    EXPECT_TRUE(vanishes(y.imaginary() / expected - 1)) << omega;
  }
}

TEST(CertifiedTipMobility, ChangesSignInEveryBall) {
  for (const char* force : {"-9000", "0", "500", "60000"}) {
    const Beam beam = paper_beam(force);
    const auto changes = [&](const Real& omega) {
      const Real step = Rational("1e-40");
      return tip_mobility(beam, 0, omega - step).imaginary().certain_sign() *
                 tip_mobility(beam, 0, omega + step).imaginary().certain_sign() ==
             -1;
    };
    for (const Real& omega : slip_frequencies(beam, 4)) EXPECT_TRUE(changes(omega)) << force;
    for (const auto& mode : certified::stick_modes(beam, 4))
      EXPECT_TRUE(changes(mode.angular_frequency)) << force;
    EXPECT_FALSE(changes(Real(40)));
  }
}

TEST(CertifiedTipMobility, NestsUnderRefinement) {
  for (const char* force : {"-9000", "0", "500", "80000"})
    for (const char* eta : {"0", "6.4e-5"}) {
      SCOPED_TRACE(force);
      expect_nested([=] {
        const Complex y = tip_mobility(paper_beam(force), Rational("3.7"), Rational("811"), eta);
        return std::vector{y.real(), y.imaginary()};
      });
    }
}

TEST(CertifiedTipMobility, IsNotFiniteAtZeroByZero) {
  for (const int s : {0, 2}) EXPECT_FALSE(tip_mobility(unit_beam("4"), s, 0).real().is_finite()) << s;
  refuses<invalid_argument>("damping.kelvin_voigt is -1; it must be 0 or more",
                            [] { (void)tip_mobility(paper_beam(), 1, 0, "-1"); });
}

// Maximum.

STICKSLIP_VERIFIES(CertifiedMaximum, "A8");
TEST(CertifiedMaximum, LiesBeforeARisingEnd) {
  // |f(1)| is 1e-7 below the maximum and rises by 4 in a second. The last cells, of 2^-20 s, begin at 1 s: the
  // one before is removed, the one behind is not.
  const Real w(12.7151659);
  const auto maximum = max_abs_of_sinusoids({{Real(1), Real(1)}, {Real(0.3), w}}, "1");
  ASSERT_EQ(maximum.times.size(), 1u);
  const Real t = maximum.times.front();
  EXPECT_TRUE(abs(t - Real(0.63441769241)) < Real(1e-9));
  EXPECT_TRUE(vanishes(maximum.value - (sin(t) + Real(0.3) * sin(w * t)), 60));
  const Real excess = maximum.value - (sin(Real(1)) + Real(0.3) * sin(w));
  EXPECT_TRUE(Real(1.07e-7) < excess && excess < Real(1.09e-7));
}

TEST(CertifiedMaximum, RefusesAStationaryEnd) {
  refuses<runtime_error>("certain sign at the ends", [] {
    (void)max_abs_of_sinusoids({{Real(1), 2 * pi()}}, "1.25");
  });
}

TEST(CertifiedMaximum, IsOddInNegativeFrequencies) {
  // w t of 1e6 rad: the error of the doubles, 4e-10, is larger than what the last cells are divided to, 1e-10.
  const auto forwards = max_abs_of_sinusoids({{Real(1), Real(2)}, {Real(1), Real(1e6)}}, "1");
  const auto backwards = max_abs_of_sinusoids({{Real(-1), Real(-2)}, {Real(-1), Real(-1e6)}}, "1");
  EXPECT_TRUE(vanishes(backwards.value - forwards.value, 60));
  EXPECT_TRUE(forwards.value > Real(1.999999));
}

TEST(CertifiedMaximum, NamesAllTimesThatMayBeIt) {
  const auto maximum = max_abs_of_sinusoids({{Real(1), 2 * pi()}}, "1.6");  // at 1/4, 3/4, 5/4
  EXPECT_TRUE(vanishes(maximum.value - 1, 60));
  ASSERT_EQ(maximum.times.size(), 3u);
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(vanishes(maximum.times[static_cast<std::size_t>(i)] - Real(2 * i + 1) / 4, 60));
}

TEST(CertifiedMaximum, TellsNearlyEqualPeaksApart) {
  // Two peaks of |sin|, one raised and one lowered by a slow second term, by less than doubles can see.
  const Real tiny = Rational("1e-25");
  for (const auto& [amplitude, peak] : {std::pair{tiny, Real(0.25)}, {-tiny, Real(0.75)}}) {
    const auto maximum = max_abs_of_sinusoids({{Real(1), 2 * pi()}, {amplitude, Real(1)}}, "1.1");
    ASSERT_EQ(maximum.times.size(), 1u);
    EXPECT_TRUE(abs(maximum.times.front() - peak) < Real(1e-20));
    EXPECT_TRUE(abs(maximum.value - 1 - tiny * sin(peak)) < Real(1e-45));
  }
}

TEST(CertifiedMaximum, FindsARippleOnASlowWave) {
  // The first cells are longer than a ripple, so that one whose middle lies in a trough may hold the peak.
  for (int w = 1000; w < 1020; ++w) {
    const auto maximum = max_abs_of_sinusoids({{Real(1), Real(1)}, {Real(0.01), Real(w)}}, "3");
    double largest = 0.0;
    for (int i = 0; i <= 10000; ++i) {
      const double t = 1.52 + 1e-5 * i;
      largest = std::max(largest, std::sin(t) + 0.01 * std::sin(w * t));
    }
    const double curvature = 1.0 + 0.01 * w * w;
    EXPECT_TRUE(within(maximum.value.nearest_double(), largest,
                       discretisation(curvature * 1e-10 / 8.0, 2.5, "M dt^2/8")))
        << w;
  }
}

TEST(CertifiedMaximum, RefusesSpansThatAreNone) {
  const auto refused = [](const std::vector<Sinusoid>& sinusoids, const char* duration) {
    return [=] { (void)max_abs_of_sinusoids(sinusoids, duration); };
  };
  refuses<invalid_argument>("excitation.duration is 0", refused({{Real(1), Real(1)}}, "0"));
  refuses<domain_error>("excitation.duration is 10;", refused({{Real(1), Real(1e12)}}, "10"));
  refuses<domain_error>("excitation.duration is 3;",
                        refused({{Real(1e12), Real(1)}, {Real(-1e12), Real(1) + Real(1e-13)}}, "3"));
  const PrecisionScope scope(50);
  refuses<invalid_argument>("60 bits", refused({{pi(), Real(1)}}, "1"));
  refuses<invalid_argument>("60 bits", refused({{Real(1), pi()}}, "1"));
  EXPECT_TRUE(max_abs_of_sinusoids({{Real(0), Real(1)}}, "1").value.contains(0));
}

}  // namespace
}  // namespace stickslip::testing
