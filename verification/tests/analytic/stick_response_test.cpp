// SPDX-License-Identifier: MIT
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::ForceMaximum;
using analytic::SteadyPart;
using analytic::stick_modes;
using analytic::StickMode;
using analytic::StickResponse;
using std::numbers::pi;

double mass(const data::Beam& beam) { return beam.density() * beam.area(); }

STICKSLIP_VERIFIES(StickResponse, "A4");
TEST(StickResponse, SteadyAmplitudesAgreeWithFortyDigitArithmetic) {
  struct Steady {
    double load_factor, frequency_hz, force, displacement;  // f per A0 in N/m, u(0.7 m)/A0
  };
  const std::array<Steady, 12> table{{{-1e4, 24.9, 49.638649902668527, -0.34199821546476244},
                                      {-1e4, 70.0, 402.89647209788633, -0.33190986879179057},
                                      {-10.0, 1e-3, 2570.5274191817687, -0.20083958225026842},
                                      {-10.0, 24.9, 143184.3984755679, 0.86542844007252454},
                                      {-10.0, 70.0, -509359.04909284069, -0.12617986571299714},
                                      {0.0, 1e-9, 6250.0, -0.1623125},
                                      {0.0, 1.0, 6360.194531674385, -0.16140264051190315},
                                      {0.0, 24.9, 7562666.6066694793, 45.22400597300546},
                                      {0.0, 70.0, -865266.78162489029, 0.46266440304473075},
                                      {1e-9, 1e-3, 6250.0001106005924, -0.16231249908607766},
                                      {15.0, 24.9, -188670.2376281065, -0.84625257114217131},
                                      {15.0, 70.0, 137723299.97258069, -197.16899104039809}}};
  for (const auto& [load_factor, frequency_hz, force, displacement] : table) {
    const data::Beam beam = paper_beam_with_load_factor(load_factor);
    const StickResponse response(beam, shaking(frequency_hz, 1.0), 12, SteadyPart::exact);
    double condition = 1.0;
    for (const StickMode& mode : response.modes())
      condition = std::max(condition, mode.frequency_hz() / std::abs(mode.frequency_hz() - frequency_hz));
    // The forces at rest and in motion, between which the sum may cancel, set the scale.
    const double force_scale = std::abs(force) + 4.0 * rigidity(beam) / 8.0;
    EXPECT_TRUE(within(response.steady_force_amplitude(), force, round_off(30, condition, force_scale)));
    EXPECT_TRUE(within(response.steady_displacement_amplitude(0.7), displacement,
                       round_off(30, condition, 1.0 + std::abs(displacement))))
        << load_factor << ", " << frequency_hz;
  }
}

TEST(StickResponse, ExactSteadyPartDoesNotDependOnTheModesKept) {
  // Between 10 and 40 modes only the free vibrations 11 ... 40 differ, at and beside resonance as elsewhere.
  const auto modes = stick_modes(paper_beam(), 2);
  for (const double hz : {1e-3, 15.0, modes[0].frequency_hz(), modes[0].frequency_hz() * (1.0 + 1e-9),
                          modes[0].frequency_hz() * 1.01, 53.0, modes[1].frequency_hz() * (1.0 - 1e-12)}) {
    const StickResponse ten(paper_beam(), shaking(hz), 10, SteadyPart::exact);
    const StickResponse forty(paper_beam(), shaking(hz), 40, SteadyPart::exact);
    const auto transient = forty.transient_force();
    for (const double t : {0.02, 0.7, 3.0}) {
      double beyond_ten = 0.0, phase_error = 0.0;
      for (std::size_t n = 10; n < 40; ++n) {
        const auto [amplitude, frequency] = transient[n];
        beyond_ten += amplitude * std::sin(frequency * t);
        phase_error += round_off(1, 1.0 + frequency * t, amplitude).value;
      }
      // Each of forty terms is as large as the terms at rest or the force, which reaches 4e4 N at resonance.
      const double force = std::max(50.0, std::abs(ten.friction_force(t)));
      EXPECT_TRUE(within(forty.friction_force(t), ten.friction_force(t) + beyond_ten,
                         discretisation(round_off(40, 1, force).value + phase_error, 1.0,
                                        "round-off of the sums and the phases")))
          << hz;
    }
  }
}

TEST(StickResponse, ExactSteadyPartNeedsFewModes) {
  // Half way up to the highest mode kept, as far as is allowed, against forty modes more.
  for (const int count : {1, 2, 3, 8, 20, 60}) {
    const auto modes = stick_modes(paper_beam(), count);
    for (const double share : {0.49999, 0.47, 0.44}) {
      const double hz = share * modes.back().frequency_hz();
      const StickResponse least(paper_beam(), shaking(hz, 1.0), count, SteadyPart::exact);
      const StickResponse many(paper_beam(), shaking(hz, 1.0), count + 40, SteadyPart::exact);
      double condition = 1.0;
      for (const StickMode& mode : modes)
        condition = std::max(condition, hz / std::abs(hz - mode.frequency_hz()));
      // E I |Y'''(L)| is of the order E I k^(3/4) between resonances, k = rho A Omega^2/EI.
      const double k = mass(paper_beam()) * std::pow(2.0 * pi * hz, 2) / rigidity(paper_beam());
      const double scale = rigidity(paper_beam()) * (1.0 + std::pow(k, 0.75));
      EXPECT_TRUE(within(least.steady_force_amplitude(), many.steady_force_amplitude(),
                         round_off(count + 40, condition, scale)))
          << count << " modes, " << hz << " Hz";
    }
  }
}

StickResponse response_at(double hz, int modes = 10) {
  return StickResponse(paper_beam(), shaking(hz, 1e-3), modes);
}

double densely_sampled(const StickResponse& response, double duration) {
  double largest = 0.0;
  for (int i = 0; i <= 20000; ++i)
    largest = std::max(largest, std::abs(response.friction_force(duration * i / 2e4)));
  return largest;
}

TEST(StickResponse, ClosestToResonanceLosesNoDigits) {
  // In the first mode g grows as t cos(omega t)/2, and a relative shift d of Omega turns its phase by d omega
  // t/2.
  const double natural = analytic::stick_modes(paper_beam(), 1).front().frequency_hz(), t = 1.3;
  const double phase = 2.0 * pi * natural * t;
  const double at = response_at(natural).friction_force(t);
  const double peak = densely_sampled(response_at(natural), t);
  for (const double distance : {1e-8, 1e-10, 1e-12, 1e-14}) {
    const double beside = response_at(natural * (1.0 + distance)).friction_force(t);
    EXPECT_TRUE(
        within(beside, at,
               {(0.5 * phase * distance + 4.0 * phase * std::numeric_limits<double>::epsilon()) * peak,
                "round-off", "phase omega t/2 turned by the distance, and its rounding"}))
        << distance;
  }
}

TEST(StickResponse, SteadyAmplitudeIsUnboundedAtResonance) {
  const double natural = stick_modes(paper_beam(), 1).front().frequency_hz();
  EXPECT_GT(std::abs(StickResponse(paper_beam(), shaking(natural)).steady_force_amplitude()), 1e12);
  EXPECT_EQ(StickResponse(paper_beam(), shaking(natural, 0.0)).steady_force_amplitude(), 0.0);
}

TEST(StickResponse, OmittedTransientIsBounded) {
  for (const double factor : {-1e4, -300.0, -5.0, 0.12, 19.0}) {
    const data::Beam beam = paper_beam_with_load_factor(factor);
    const auto all = StickResponse(beam, shaking(12.0), 1000).transient_force();
    for (const int count : {1, 2, 5, 10, 40, 100}) {
      double omitted = 0.0;
      for (auto n = static_cast<std::size_t>(count); n < all.size(); ++n)
        omitted += std::abs(all[n].amplitude);
      const double bound = StickResponse(beam, shaking(12.0), count).omitted_transient_bound();
      EXPECT_GE(bound, omitted) << factor << ", " << count;
    }
  }
  EXPECT_LT(StickResponse(paper_beam(), shaking(35.0), 10).omitted_transient_bound(), 0.2);
  EXPECT_TRUE(std::isinf(StickResponse(paper_beam(), shaking(35.0), 1).omitted_transient_bound()));
  EXPECT_TRUE(std::isinf(
      StickResponse(paper_beam_with_load_factor(-1e4), shaking(35.0), 10).omitted_transient_bound()));
}

TEST(StickResponse, RefusesExactSteadyPartAboveItsModes) {
  expect_error_message<std::invalid_argument>(
      [] { StickResponse(paper_beam(), shaking(50.0), 2, SteadyPart::exact); },
      {"numerics.modes is 2, but must be so large"});
  EXPECT_NO_THROW(StickResponse(paper_beam(), shaking(50.0), 3, SteadyPart::exact));
  EXPECT_NO_THROW(StickResponse(paper_beam(), shaking(50.0), 2, SteadyPart::modal_sum));
}

STICKSLIP_VERIFIES(SampledMaximum, "A5");
TEST(SampledMaximum, HoldsTheSampleAtTheEnd) {
  // The force rises from zero through the whole of 3 ms; the last sample on the grid is at 2 ms.
  const StickResponse response = response_at(5.0);
  const double before = std::abs(response.friction_force(2e-3)),
               end = std::abs(response.friction_force(3e-3));
  ASSERT_GT(end, 1.1 * before);
  EXPECT_TRUE(within(response.sampled_max_abs_friction_force(3e-3, 2e-3).lower, end, round_off(10, 1, end)));
}

TEST(SampledMaximum, HoldsTheLastSampleOfTheGridBeforeAShorterStep) {
  // The largest value of one second is the fifth sample; the sixth would lie behind the end.
  const StickResponse response = response_at(35.0);
  double peak = 0.0;
  for (int i = 1; i <= 20000; ++i)
    if (std::abs(response.friction_force(i / 2e4)) > std::abs(response.friction_force(peak))) peak = i / 2e4;
  const double step = 0.25 * peak, largest = std::abs(response.friction_force(peak));
  ASSERT_LT(std::abs(response.friction_force(peak + 0.9 * step)), 0.9 * largest);
  EXPECT_TRUE(within(response.sampled_max_abs_friction_force(peak + 0.9 * step, step).lower, largest,
                     round_off(10, 1, largest)));
}

TEST(SampledMaximum, UpperBoundHoldsBetweenSamplesFarApart) {
  for (const double hz : {3.0, 40.0, 300.0})
    for (const int modes : {1, 3}) {
      const StickResponse response = response_at(hz, modes);
      const double duration = 7.3 / hz, largest = densely_sampled(response, duration);
      for (const double share : {0.13, 0.29, 0.41}) {
        const Bounds bounds = response.sampled_max_abs_friction_force(duration, share / hz);
        EXPECT_LE(bounds.lower, largest * (1.0 + 1e-12)) << hz << " Hz, " << share;
        EXPECT_GE(bounds.upper, largest) << hz << " Hz, " << share;
      }
    }
}

TEST(SampledMaximum, ExcessIsTheInterpolationErrorOfTheStep) {
  // Far from resonance the bound of |f''| is the sum over the sinusoids, that at Omega taken as one.
  const StickResponse response = response_at(35.0, 4);
  const double omega = 2.0 * pi * 35.0, step = 1e-4;
  double bend = std::abs(response.steady_force_amplitude()) * omega * omega;
  for (const auto& term : response.transient_force())
    bend += std::abs(term.amplitude) * term.angular_frequency * term.angular_frequency;
  const Bounds bounds = response.sampled_max_abs_friction_force(1.0, step);
  const double excess = bend * step * step / 8.0;
  EXPECT_TRUE(within(bounds.upper - bounds.lower, excess, round_off(100, bounds.upper / excess, excess)));
}

STICKSLIP_VERIFIES(MaximumForce, "A5");
TEST(MaximumForce, IsFoundAtExactResonance) {
  // The envelope of the resonant mode is EI A0 |U'''(L) C| (Omega t)/2; the others add at most their
  // amplitudes.
  const data::Beam beam = paper_beam();
  const StickMode mode = stick_modes(beam, 1).front();
  const StickResponse response(beam, shaking(mode.frequency_hz()), 10, SteadyPart::exact);
  const double per_radian =
      rigidity(beam) * 0.5e-3 * std::abs(mode.third_derivative(2.0) * mode.participation()) / 2.0;
  const double envelope = per_radian * mode.angular_frequency() * 10.0;
  const Bounds bounds = response.max_abs_friction_force(10.0, 1e-13);
  const double rounding =
      0.5e-3 * ForceMaximum(response.reaction(), mode.angular_frequency(), 10.0).rounding();
  EXPECT_LE(bounds.upper - bounds.lower, 1e-13 * bounds.lower + 3.0 * rounding);
  EXPECT_LE(rounding, 1e-12 * bounds.lower);
  EXPECT_TRUE(within(bounds.midpoint(), envelope,
                     discretisation(per_radian * (2.0 * pi + 1.0) + 10.0, 1.0,
                                    "the last crest, a period at most before the end, and the other modes")));
}

TEST(MaximumForce, SurvivesExtremeAmplitudesAndDurations) {
  for (const double amplitude : {1e-300, 1e250}) {
    const StickResponse response(paper_beam(), shaking(15.0, amplitude));
    const Bounds bounds = response.max_abs_friction_force(1.0);
    EXPECT_GT(bounds.lower, 0.0);
    EXPECT_TRUE(std::isfinite(bounds.upper));
  }
  const StickResponse at_rest(paper_beam(), shaking(25.0, 0.0));
  EXPECT_EQ(at_rest.max_abs_friction_force(10.0).upper, 0.0);
  EXPECT_EQ(at_rest.sampled_max_abs_friction_force(10.0, 1e-3).upper, 0.0);
  // While f still rises, its largest value is the last: f = EI A0 S'''(L) Omega t to leading order.
  const StickResponse response(paper_beam(), shaking(15.0));
  const Bounds bounds = response.max_abs_friction_force(1e-9);
  const double last = std::abs(response.friction_force(1e-9));
  EXPECT_TRUE(within(bounds.lower, last, reference(1e-10 * last, "relative width of the bounds")));
}

TEST(MaximumForce, RefusesBadArgumentsAndSaysWhich) {
  const StickResponse response(paper_beam(), shaking(15.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double duration : {0.0, -1.0, nan}) {
    EXPECT_THROW((void)response.max_abs_friction_force(duration), std::invalid_argument);
    EXPECT_THROW((void)response.max_abs_friction_force_by_halving(duration, 1e-3), data::FieldError);
    EXPECT_THROW((void)response.sampled_max_abs_friction_force(duration, 1e-3), std::invalid_argument);
  }
  for (const double width : {0.0, 1e-14, 0.99e-13, 1.0, nan}) {
    EXPECT_THROW((void)response.max_abs_friction_force(1.0, width), std::invalid_argument);
    EXPECT_THROW((void)response.max_abs_friction_force_by_halving(1e-9, width), std::invalid_argument);
  }
  EXPECT_NO_THROW((void)response.max_abs_friction_force_by_halving(1e-9, 1e-13));
  EXPECT_THROW((void)response.sampled_max_abs_friction_force(1.0, 0.0), std::invalid_argument);
  EXPECT_THROW((void)response.sampled_max_abs_friction_force(1.0, 1e-300), std::invalid_argument);
  EXPECT_THROW((void)response.max_abs_friction_force(1e300), std::invalid_argument);
  EXPECT_EQ(error_message_of<std::invalid_argument>([&] { (void)response.max_abs_friction_force(-1.0); }),
            "excitation.duration is -1, but must be positive and finite");
}

}  // namespace
}  // namespace stickslip::testing
