// SPDX-License-Identifier: MIT
/// The plain searches for |f_max|, by halving and by samples: they enclose what the fast one finds however
/// wide they may be, and what they leave open falls with the square of the interval. The fast one, down to
/// its rounding.

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;
using analytic::ForceMaximum;
using analytic::StickResponse;

// Of one history of f. Few modes, whose crests come near the sum of their amplitudes, leave the bound of f''
// no slack.
struct Search {
  double frequency_hz, duration;
  int modes;
};

std::vector<Search> searches() {
  std::vector<Search> all;
  for (const double hz : {7.0, 35.0, 70.0, 400.0})
    for (const int modes : {1, 10})
      for (const double duration : {0.004, 0.31, 1.1}) all.push_back({hz, duration, modes});
  return all;
}

StickResponse response_of(const Search& search) {
  return StickResponse(paper_beam(),
                       data::HarmonicExcitation({.frequency_hz = search.frequency_hz, .amplitude = 1.0}),
                       search.modes);
}

ForceMaximum fast_search(const Search& search) {
  return {response_of(search).reaction(), 2.0 * std::numbers::pi * search.frequency_hz, search.duration};
}

std::string name_of(const Search& search) {
  return fmt::format("{} Hz, {} s, N = {}", search.frequency_hz, search.duration, search.modes);
}

STICKSLIP_VERIFIES(MaximumForce, "A5");
TEST(MaximumForce, GapOfHalvingIsOfSecondOrder) {
  for (const Search& search : searches()) {
    SCOPED_TRACE(name_of(search));
    const StickResponse response = response_of(search);
    const ForceMaximum fast = fast_search(search);
    const Bounds maximum = fast.refined_to(1e-12);
    const double slack = fast.rounding();  // which the plain bounds leave out
    double widest_gap = 0.0;
    for (double width = 0.5; width > 1e-6; width /= 3.0) {
      const Bounds bounds = response.max_abs_friction_force_by_halving(search.duration, width);
      const double gap = bounds.upper - bounds.lower;
      EXPECT_LE(bounds.lower, maximum.upper + slack) << width;
      EXPECT_GE(bounds.upper, maximum.lower - slack) << width;
      EXPECT_LE(gap, width * bounds.lower) << width;
      if (gap == 0.0) continue;  // nothing promising was left
      if (widest_gap == 0.0) widest_gap = gap;
      // Intervals are halved k times: the gap is that of the first by 4^k, but for the rounding of the
      // bounds.
      const double halvings = std::log2(widest_gap / gap) / 2.0;
      EXPECT_TRUE(within(halvings, std::round(halvings), round_off(1, bounds.upper / gap, 1.0))) << width;
    }
  }
}

TEST(MaximumForce, FastSearchEnclosesBeats) {
  // In runs as short as these a mode and the excitation do not part: one beat stands for both.
  const double resonance = analytic::stick_modes(paper_beam(), 1).front().frequency_hz();
  for (const double hz : {resonance, resonance + 0.05, 35.0})
    for (const int modes : {1, 10})
      for (double duration = 0.01; duration < 0.2; duration *= 1.05) {
        const Search search{hz, duration, modes};
        SCOPED_TRACE(name_of(search));
        const ForceMaximum fast = fast_search(search);
        const Bounds maximum = fast.refined_to(1e-12);
        for (double width = 0.7; width > 1e-5; width /= 3.0) {
          const Bounds bounds = fast.refined_to(width);
          EXPECT_LE(bounds.lower, maximum.upper) << width;
          EXPECT_GE(bounds.upper, maximum.lower) << width;
        }
      }
}

TEST(MaximumForce, EnclosesOneSinusoidToRounding) {
  // sin(t) rises to sin(T); where T^2/8, which the chord leaves open, is less than rounding, rounding alone
  // keeps the two bounds apart.
  for (double duration = 1.5; duration > 1e-20; duration *= 0.3) {
    const ForceMaximum search({.quasi_static = 1.0, .modes = {}}, 1.0, duration);
    for (const double width : {1e-13, 1e-6, 0.5}) {
      const Bounds bounds = search.refined_to(width);
      EXPECT_LE(bounds.lower, std::sin(duration)) << duration << " s, " << width;
      EXPECT_GE(bounds.upper, std::sin(duration)) << duration << " s, " << width;
    }
  }
}

TEST(MaximumForce, EnclosesTheCubeOfASineToRounding) {
  // A mode three times as fast as the excitation: f = (sin(3t) - 3 sin(t))/24 = -sin(t)^3/6, which bends away
  // from zero at first. The reference is off by the half unit of the sine three times, of the power and of
  // the quotient once: 5 eps/2.
  for (double duration = 1.5; duration > 1e-3; duration *= 0.9) {
    const ForceMaximum search({.quasi_static = 0.0, .modes = {{3.0, 1.0}}}, 1.0, duration);
    const double largest = std::pow(std::sin(duration), 3) / 6.0;
    const double rounding_of_the_reference = 6e-16 * largest;
    for (const double width : {1e-13, 1e-10, 1e-6, 1e-3, 0.5}) {
      const Bounds bounds = search.refined_to(width);
      EXPECT_LE(bounds.lower, largest + rounding_of_the_reference) << duration << " s, " << width;
      EXPECT_GE(bounds.upper, largest - rounding_of_the_reference) << duration << " s, " << width;
    }
  }
}

}  // namespace
}  // namespace stickslip::testing
