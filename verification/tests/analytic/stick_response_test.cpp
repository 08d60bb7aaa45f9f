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
TEST(StickResponse, AgreesWithFortyDigits) {
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

TEST(StickResponse, IsUnboundedAtResonance) {
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

TEST(StickResponse, RefusesASteadyPartAboveModes) {
  expect_error_message<std::invalid_argument>(
      [] { StickResponse(paper_beam(), shaking(50.0), 2, SteadyPart::exact); },
      {"numerics.modes is 2, but must be so large"});
  EXPECT_NO_THROW(StickResponse(paper_beam(), shaking(50.0), 3, SteadyPart::exact));
  EXPECT_NO_THROW(StickResponse(paper_beam(), shaking(50.0), 2, SteadyPart::modal_sum));
}

STICKSLIP_VERIFIES(SampledMaximum, "A5");
TEST(SampledMaximum, IsThatOfItsGridAndOfTheEnd) {
  const StickResponse response = response_at(35.0);
  for (int i = 1; i <= 60; ++i) {
    const double duration = i * 1.1e-3, step = 6.3e-3;
    double largest = std::abs(response.friction_force(duration));
    for (int k = 0; k * step < duration; ++k)
      largest = std::max(largest, std::abs(response.friction_force(k * step)));
    EXPECT_TRUE(within(response.sampled_max_abs_friction_force(duration, step).lower, largest,
                       round_off(10, 1, largest)));
  }
}

STICKSLIP_VERIFIES(MaximumForce, "A5");
TEST(MaximumForce, SurvivesExtremeInput) {
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
    EXPECT_THROW((void)response.sampled_max_abs_friction_force(duration, 1e-3), std::invalid_argument);
  }
  for (const double width : {0.0, 1e-14, 0.99e-13, 1.0, nan})
    EXPECT_THROW((void)response.max_abs_friction_force(1.0, width), std::invalid_argument);
  EXPECT_NO_THROW((void)response.max_abs_friction_force(1e-9, 1e-13));
  EXPECT_THROW((void)response.sampled_max_abs_friction_force(1.0, 0.0), std::invalid_argument);
  EXPECT_THROW((void)response.sampled_max_abs_friction_force(1.0, 1e-300), std::invalid_argument);
  EXPECT_THROW((void)response.max_abs_friction_force(1e300), std::invalid_argument);
  EXPECT_EQ(error_message_of<std::invalid_argument>([&] { (void)response.max_abs_friction_force(-1.0); }),
            "excitation.duration is -1, but must be positive and finite");
}

}  // namespace
}  // namespace stickslip::testing
