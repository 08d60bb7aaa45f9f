#pragma once

/// Stick-slip histories of either method in one form, so that they can be compared event by event.

#include <functional>
#include <string>
#include <vector>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::studies {

/// A change between stick and slip.
struct HistoryEvent {
  bool onset{};       ///< stick to slip; else slip to stick
  double time{};      ///< s
  double position{};  ///< y(L), m
};

/// The tip y(L) on a grid of times, and every event.
struct TipHistory {
  std::vector<double> time;              ///< s
  std::vector<double> tip_displacement;  ///< m
  std::vector<HistoryEvent> events;      ///< onsets and captures, alternating
  int changes{};                         ///< all changes of contact, reversals and grazes included
};

/// The events without micro-sticks: a stick phase shorter than `shortest_stick`, s, counts as part of the
/// slip around it, so that its capture and its onset are left out. Slips are never left out, nor is a stick
/// phase that begins the history or has not ended with it.
[[nodiscard]] std::vector<HistoryEvent> without_micro_sticks(const std::vector<HistoryEvent>& events,
                                                             double shortest_stick);

/// An event-driven run from the quasi-static start, sampled every `sample` seconds.
[[nodiscard]] TipHistory event_driven_history(const analytic::ContactModel& model, double duration,
                                              double sample, double tolerance = 1e-12);

/// A time-stepper run with numerics.time_step(), sampled every `every` steps.
[[nodiscard]] TipHistory time_stepper_history(const data::Beam& beam, const data::FrictionLaw& friction,
                                              const data::HarmonicExcitation& excitation,
                                              const data::NumericalSettings& numerics,
                                              const solver::BeamRun& run, double duration, int every = 1);

/// The largest differences of the first `count` events of two histories; infinite if they are not of the same
/// kinds or one has fewer.
struct EventDifference {
  double time{};      ///< s
  double position{};  ///< m
};
[[nodiscard]] EventDifference largest_difference(const std::vector<HistoryEvent>& a,
                                                 const std::vector<HistoryEvent>& b, std::size_t count);

/// `numerics` with another mesh and step, and without a velocity threshold: with events located it is not
/// needed, and a capture at |v_s| = epsilon is early by epsilon/|v_s_t|, 1e-5 s for the paper's 1e-4 m/s.
[[nodiscard]] data::NumericalSettings refined(const data::NumericalSettings& numerics, int elements,
                                              double time_step);

}  // namespace stickslip::studies
