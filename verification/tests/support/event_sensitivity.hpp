// SPDX-License-Identifier: MIT
#pragma once

/// Histories that must be the same up to small errors. A run with a known small change measures how such errors grow.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/tolerance.hpp"
#include "support/units.hpp"

namespace stickslip::testing {

/// When and where a contact changes, s and m.
struct EventAt {
  double time{}, position{};
};

/// How far two runs of one problem may differ.
struct Sensitivity {
  std::vector<EventAt> perturbed;  ///< of the expected run with an amplitude that is larger by a share
  double perturbation{};           ///< this share
  double error{};                  ///< relative error of the data or the steps
  double amplitude{};              ///< measure of positions, m
};

/// Expects the events of `expected`. The tolerance of a time is `error` times the time plus its slope, that of a position
/// `error` times its slope: the largest change per share so far in the perturbed run, of positions at least the amplitude.
inline void expect_same_events(const std::vector<EventAt>& computed, const std::vector<EventAt>& expected,
                               const Sensitivity& sensitivity) {
  ASSERT_EQ(computed.size(), expected.size());
  ASSERT_EQ(sensitivity.perturbed.size(), expected.size()) << "the perturbation is too large to measure with";
  double time_slope = 0.0, position_slope = sensitivity.amplitude;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const EventAt& moved = sensitivity.perturbed[i];
    const double share = sensitivity.perturbation;
    time_slope = std::max(time_slope, std::abs(moved.time - expected[i].time) / share);
    position_slope = std::max(position_slope, std::abs(moved.position - expected[i].position) / share);
    EXPECT_TRUE(
        within(computed[i].time, expected[i].time,
               discretisation(sensitivity.error * (expected[i].time + time_slope), 1.0, "error times slope")))
        << "event " << i;
    EXPECT_TRUE(within(computed[i].position, expected[i].position,
                       discretisation(sensitivity.error * position_slope, 1.0, "error times slope")))
        << "event " << i;
  }
}

/// The same of the problem with each of two similar beams, in its own units: events_in(problem, units) are
/// the events of the run that belongs to `expected`.
template <class EventsIn>
void expect_same_events_of_similar_beams(RandomNumbers& numbers, const StickSlipProblem& problem,
                                         const std::vector<EventAt>& expected, const Sensitivity& sensitivity,
                                         const EventsIn& events_in) {
  for (const auto& [other, units] : similar_beams(numbers, problem.beam)) {
    StickSlipProblem scaled = in_units(units, problem);
    scaled.beam = other;
    std::vector<EventAt> computed = events_in(scaled, units);
    for (EventAt& event : computed) event = {event.time / units.time, event.position / units.length};
    expect_same_events(computed, expected, sensitivity);
  }
}

}  // namespace stickslip::testing
