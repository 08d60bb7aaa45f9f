// SPDX-License-Identifier: MIT
#pragma once

/// Stick-slip histories of all methods in one format, so that they can be compared event by event.

#include <optional>
#include <vector>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// A change between stick and slip.
struct HistoryEvent {
  bool onset{};       ///< stick to slip; otherwise slip to stick
  double time{};      ///< s
  double position{};  ///< y(L), m
};
STICKSLIP_MEMBERS(HistoryEvent, (onset, "1"), (time, "s"), (position, "m"))

/// The tip displacement y(L) at given times, and the events.
struct TipHistory {
  std::vector<double> time;              ///< s
  std::vector<double> tip_displacement;  ///< m
  std::vector<HistoryEvent> events;      ///< onsets and captures, alternating
  /// Number of all changes of contact, including reversals and grazing contacts.
  int changes{};
};
STICKSLIP_MEMBERS(TipHistory, (time, "s"), (tip_displacement, "m"), (events), (changes, "1"))

/// The events without micro-sticks: a stick phase shorter than `shortest_stick` (s) counts as part of the
/// slip phase around it, so its capture and its onset are removed. Slip phases are never removed, nor is a
/// stick phase at the beginning or at the end of the history.
[[nodiscard]] std::vector<HistoryEvent> without_micro_sticks(const std::vector<HistoryEvent>& events,
                                                             double shortest_stick);

/// The first change from slip to stick, if there is one.
[[nodiscard]] std::optional<HistoryEvent> first_capture(const std::vector<HistoryEvent>& events);

/// An event-driven run from the quasi-static initial state, sampled every `sample` seconds.
[[nodiscard]] TipHistory event_driven_history(const analytic::ContactModel& model, double duration,
                                              double sample, double tolerance = 1e-12);

/// A run by time integration with numerics.time_step(), sampled every `every` steps.
[[nodiscard]] TipHistory time_stepper_history(const data::Beam& beam, const data::FrictionLaw& friction,
                                              const data::HarmonicExcitation& excitation,
                                              const data::NumericalSettings& numerics,
                                              const solver::BeamRun& run, double duration, int every = 1);

/// The largest differences of the first `count` events of two histories; infinite if their kinds differ or if
/// one history has fewer events.
struct EventDifference {
  double time{};      ///< s
  double position{};  ///< m
};
STICKSLIP_MEMBERS(EventDifference, (time, "s"), (position, "m"))
[[nodiscard]] EventDifference largest_difference(const std::vector<HistoryEvent>& a,
                                                 const std::vector<HistoryEvent>& b, std::size_t count);

/// `numerics` with another mesh and time step and with the velocity threshold 0. Located events do not need a
/// threshold. A capture at |v_s| = epsilon would be early by epsilon/|v_s_t|, which is 1e-5 s for the 1e-4
/// m/s of the paper.
[[nodiscard]] data::NumericalSettings refined(const data::NumericalSettings& numerics, int elements,
                                              double time_step);

}  // namespace stickslip::studies
